//! Blocks, `let` and items.

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
    pub(super) fn block(&mut self, block: &Block) -> Value {
        let types_around = self.scopes.outside().clone();
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
        self.scopes.name_types(types_around);
        last
    }

    /// Items can be used before they are written, and see items only.
    fn items(&mut self, block: &Block) {
        let mut imports = vec![];
        for statement in &block.stmts {
            if let Stmt::Item(Item::Use(item)) = statement {
                imported(&item.tree, &mut vec![], &mut imports);
            }
        }
        // What is imported by name hides what comes by `*`, and items hide both.
        imports.sort_by_key(|(_, _, glob)| !*glob);
        for (name, value, _) in imports {
            let value = self.graph.number(value);
            self.scopes.declare(&name, value::Item::Import(Value::Real(value)));
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
                    let named = Outside::clone(self.scopes.outside()).with_alias(&item.ident, &item.ty);
                    self.scopes.name_types(Rc::new(named));
                }
                _ => {}
            }
        }
    }

    /// The value of a `const` item that sees what is in `sees`.
    pub(super) fn constant_item(&mut self, syntax: &impl ToTokens, constant: &Constant, sees: Scopes) -> Value {
        let progress = constant.value.replace(Progress::Underway);
        let value = match progress {
            Progress::Known(value) => value,
            Progress::Underway => self.refuse(syntax, "this constant is defined in terms of itself"),
            Progress::Untouched => {
                let before = std::mem::replace(&mut self.scopes, sees);
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
            Stmt::Item(Item::Use(item)) if imported(&item.tree, &mut vec![], &mut vec![]) => Value::unit(),
            Stmt::Item(Item::Use(item)) => self.refuse(
                item,
                "the generated code cannot see imports inside the body: move this above the function; only \
                     constants of `std::f64::consts` can be imported here",
            ),
            Stmt::Item(item) => self.refuse(item, format!("this item is not part of an energy; {STATEMENTS}")),
            Stmt::Expr(expr, semicolon) => {
                let value = self.expr(expr);
                // A statement that was refused may have been the value: `return x;`.
                if semicolon.is_some() && !matches!(value, Value::Poison) { Value::unit() } else { value }
            }
            Stmt::Macro(call) => self.refuse(call, other_macro(&call.mac)),
        }
    }

    /// Binds the names of a pattern.
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
                for (pattern, value) in pattern.elems.iter().zip(values) {
                    self.bind(pattern, value);
                }
            }
            (Pat::Slice(pattern), Value::List(values)) if pattern.elems.len() == values.len() => {
                for (pattern, value) in pattern.elems.iter().zip(values.iter()) {
                    self.bind(pattern, value.clone());
                }
            }
            (pattern, Value::Poison) => self.poison_names(pattern),
            (pattern, value) => {
                let kind = value.kind();
                self.refuse(
                    pattern,
                    format!(
                        "this pattern does not fit {kind}; patterns are names, tuples `(a, b)` and arrays `[a, b]`"
                    ),
                );
                self.poison_names(pattern);
            }
        }
    }

    /// Refuses a `let`, but not the uses of what it would bind.
    fn refuse_names(&mut self, local: &syn::Local, message: &str) -> Value {
        self.poison_names(&local.pat);
        self.refuse(local, message)
    }

    /// Binds every name of a pattern to nothing, so that its uses are not reported as well.
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

pub(super) fn simple_name(expr: &Expr) -> Option<String> {
    match expr {
        Expr::Path(path) => path.path.get_ident().map(ToString::to_string),
        Expr::Paren(inner) => simple_name(&inner.expr),
        Expr::Group(inner) => simple_name(&inner.expr),
        Expr::Unary(syn::ExprUnary { op: syn::UnOp::Deref(_), expr, .. }) => simple_name(expr),
        _ => None,
    }
}
