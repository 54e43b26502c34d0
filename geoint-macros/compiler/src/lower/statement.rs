//! Blocks, statements, patterns and items.

use super::Lowering;
use super::constants::imported;
use super::language::{STATEMENTS, THROUGH_REFERENCE, other_macro};
use super::value::{self, Callable, Constant, Progress, Scopes, Value};
use crate::parse::Outside;
use quote::ToTokens;
use std::cell::RefCell;
use std::rc::Rc;
use syn::visit::Visit;
use syn::{Block, Expr, Item, Pat, PatIdent, Stmt};

impl Lowering {
    /// Evaluates a block. The value is the last expression.
    pub(super) fn block(&mut self, block: &Block) -> Value {
        let aliases_around = self.scopes.outside.clone();
        self.scopes.enter();
        self.items(block);
        let mut last = Value::unit();
        for statement in &block.stmts {
            last = self.statement(statement);
            if self.is_leaving() {
                break;
            }
        }
        self.scopes.leave();
        self.scopes.outside = aliases_around;
        last
    }

    /// Declares the items of a block before its statements, because items can be used before their declaration.
    fn items(&mut self, block: &Block) {
        let imports = block.stmts.iter().filter_map(|statement| match statement {
            Stmt::Item(Item::Use(item)) => imported(&item.tree),
            _ => None,
        });
        let (globs, named): (Vec<_>, Vec<_>) = imports.flatten().partition(|import| import.is_glob);
        // Later declarations hide earlier ones. Precedence rises from imports by `*` to imports by name to items.
        for import in globs.into_iter().chain(named) {
            let value = Value::Real(self.graph.number(import.value));
            self.scopes.declare(&import.name, value::Item::Import(value));
        }
        for statement in &block.stmts {
            match statement {
                Stmt::Item(Item::Fn(item)) => {
                    let callable = Callable::of(item);
                    self.scopes.declare(&item.sig.ident, value::Item::Function(Rc::new(callable)));
                }
                Stmt::Item(Item::Const(item)) => {
                    let constant = Constant { expr: (*item.expr).clone(), value: RefCell::new(Progress::Untouched) };
                    self.scopes.declare(&item.ident, value::Item::Constant(Rc::new(constant)));
                }
                Stmt::Item(Item::Type(item)) => {
                    let outside = Outside::clone(&self.scopes.outside).with_alias(&item.ident, &item.ty);
                    self.scopes.outside = Rc::new(outside);
                }
                _ => {}
            }
        }
    }

    /// Returns the value of a `const` item. `scopes` are the items around it.
    pub(super) fn constant_item(&mut self, syntax: &impl ToTokens, constant: &Constant, scopes: Scopes) -> Value {
        let value = match constant.value.replace(Progress::Underway) {
            Progress::Known(value) => value,
            Progress::Underway => self.refuse(syntax, "this constant is defined in terms of itself"),
            Progress::Untouched => {
                let before = std::mem::replace(&mut self.scopes, scopes);
                let value = self.expr(&constant.expr);
                self.scopes = before;
                value
            }
        };
        constant.value.replace(Progress::Known(value.clone()));
        value
    }

    fn statement(&mut self, statement: &Stmt) -> Value {
        match statement {
            Stmt::Local(local) => match &local.init {
                Some(init) if init.diverge.is_none() => {
                    let value = self.expr(&init.expr);
                    self.bind(&local.pat, value);
                    Value::unit()
                }
                Some(_) => self.refuse_names(local, "`let … else` is not supported; use `if … else` as an expression"),
                None => self.refuse_names(local, "give the variable its value here: `let name = …;`"),
            },
            Stmt::Item(Item::Fn(_) | Item::Const(_) | Item::Type(_)) => Value::unit(),
            Stmt::Item(Item::Use(item)) if imported(&item.tree).is_some() => Value::unit(),
            Stmt::Item(Item::Use(item)) => self.refuse(
                item,
                "the generated code cannot see imports inside the body: move this above the function; only \
                     constants of `std::f64::consts` can be imported here",
            ),
            Stmt::Item(item) => self.refuse(item, format!("this item is not part of an energy; {STATEMENTS}")),
            Stmt::Expr(expr, semicolon) => {
                let value = self.expr(expr);
                // A refused statement such as `return x;` may stand for the value of the block.
                if semicolon.is_some() && !value.is_poison() { Value::unit() } else { value }
            }
            Stmt::Macro(call) => self.refuse(call, other_macro(&call.mac)),
        }
    }

    /// Binds the names of a pattern to the parts of a value.
    pub(super) fn bind(&mut self, pattern: &Pat, value: Value) {
        match (pattern, value) {
            (Pat::Ident(PatIdent { by_ref: Some(_), mutability: Some(_), .. }), _) => {
                self.refuse(pattern, THROUGH_REFERENCE);
                self.poison_names(pattern);
            }
            (Pat::Ident(ident), value) if ident.subpat.is_none() => self.scopes.bind(&ident.ident, value),
            (Pat::Type(typed), value) => self.bind(&typed.pat, value),
            (Pat::Paren(inner), value) => self.bind(&inner.pat, value),
            (Pat::Reference(inner), value) => self.bind(&inner.pat, value),
            (Pat::Wild(_), _) => {}
            (Pat::Tuple(pattern), Value::Tuple(values)) if pattern.elems.len() == values.len() => {
                pattern.elems.iter().zip(values).for_each(|(pattern, value)| self.bind(pattern, value));
            }
            (Pat::Slice(pattern), Value::List(values)) if pattern.elems.len() == values.len() => {
                pattern.elems.iter().zip(values.iter()).for_each(|(pattern, value)| self.bind(pattern, value.clone()));
            }
            (pattern, value) => {
                if !value.is_poison() {
                    let kind = value.kind();
                    let message = format!(
                        "this pattern does not fit {kind}; patterns are names, tuples `(a, b)` and arrays `[a, b]`"
                    );
                    self.refuse(pattern, message);
                }
                self.poison_names(pattern);
            }
        }
    }

    /// Refuses a `let`. Uses of its names report no further errors.
    fn refuse_names(&mut self, local: &syn::Local, message: &str) -> Value {
        self.poison_names(&local.pat);
        self.refuse(local, message)
    }

    /// Binds all names of a pattern to poison, so that their uses report no further errors.
    fn poison_names(&mut self, pattern: &Pat) {
        struct Names<'a>(&'a mut Lowering);
        impl Visit<'_> for Names<'_> {
            fn visit_pat_ident(&mut self, pattern: &syn::PatIdent) {
                self.0.scopes.bind(&pattern.ident, Value::Poison);
            }
        }
        Names(self).visit_pat(pattern);
    }
}

/// Returns the identifier of an expression without parentheses and `*`.
pub(super) fn simple_name(expr: &Expr) -> Option<String> {
    match expr {
        Expr::Path(path) => path.path.get_ident().map(ToString::to_string),
        Expr::Paren(inner) => simple_name(&inner.expr),
        Expr::Group(inner) => simple_name(&inner.expr),
        Expr::Unary(syn::ExprUnary { op: syn::UnOp::Deref(_), expr, .. }) => simple_name(expr),
        _ => None,
    }
}
