//! Expressions of all kinds, names, literals, indices, fields and ranges.

use super::language::{EXPRESSIONS, POWER, THROUGH_REFERENCE, compound, is_arithmetic, is_comparison, other_macro};
use super::loops::Exit;
use super::scope::Found;
use super::value::{Callable, Closure, Item, Value, axis};
use super::{Lowering, constants, quaternion};
use crate::ir::Number;
use proc_macro2::Literal;
use quote::{ToTokens, quote};
use std::rc::Rc;
use syn::{BinOp, Expr, ExprBinary, ExprUnary, Lit, Member, Path, RangeLimits, UnOp};

impl Lowering {
    /// Evaluates an expression and notes its place.
    pub(super) fn expr(&mut self, expr: &Expr) -> Value {
        self.evaluations += 1;
        if self.is_leaving() || self.is_exhausted {
            return Value::Poison;
        }
        if self.depth >= super::MAX_DEPTH {
            return self.refuse(expr, "this is nested too deeply: bind parts of it with `let`");
        }
        self.depth += 1;
        let value = self.evaluate(expr);
        self.depth -= 1;
        if let Value::Real(id) | Value::Truth(id) = value {
            self.places.entry(id).or_insert_with(|| super::place(expr));
        }
        self.noted(expr, value)
    }

    fn evaluate(&mut self, expr: &Expr) -> Value {
        match expr {
            Expr::Lit(lit) => self.literal(&lit.lit),
            Expr::Path(path) if path.qself.is_none() => self.path(&path.path),
            Expr::Paren(inner) => self.expr(&inner.expr),
            Expr::Group(inner) => self.expr(&inner.expr),
            Expr::Reference(inner) if inner.mutability.is_none() => self.expr(&inner.expr),
            Expr::Reference(inner) => self.refuse(inner, THROUGH_REFERENCE),
            // rustc reads `x ** 2` as `x * (*2)`.
            Expr::Unary(unary) if matches!((&unary.op, &*unary.expr), (UnOp::Deref(_), Expr::Lit(_))) => {
                self.refuse(&unary.op, POWER)
            }
            Expr::Unary(unary) => self.unary(unary),
            Expr::Binary(binary) => match (&binary.op, compound(&binary.op)) {
                (op @ (BinOp::BitXor(_) | BinOp::BitXorAssign(_)), _) => self.refuse(op, POWER),
                (_, Some(op)) => self.assign_with(binary, &op),
                (BinOp::And(_) | BinOp::Or(_), _) => self.connective(binary),
                _ => self.chain(binary),
            },
            Expr::Assign(assignment) => self.assign(assignment),
            Expr::Block(block) => self.block(&block.block),
            Expr::If(branch) => self.branch(branch),
            Expr::ForLoop(for_loop) => self.for_loop(for_loop),
            Expr::Tuple(tuple) => Value::Tuple(tuple.elems.iter().map(|item| self.expr(item)).collect()),
            Expr::Array(array) => Value::list(array.elems.iter().map(|item| self.expr(item))),
            Expr::Repeat(repeat) => {
                let (value, length) = (self.expr(&repeat.expr), self.expr(&repeat.len));
                match self.integer(&repeat.len, length) {
                    Some(n @ 0..=10_000) => Value::list(vec![value; n as usize]),
                    Some(_) => self.refuse(&repeat.len, "this length is out of bounds"),
                    None => Value::Poison,
                }
            }
            Expr::Index(index) => {
                let (base, i) = (self.expr(&index.expr), self.expr(&index.index));
                self.index(&index.expr, &index.index, base, i)
            }
            Expr::Field(field) => self.field(field),
            Expr::Range(range) => self.range(range),
            Expr::Cast(cast) => self.cast(cast),
            Expr::Closure(closure) => {
                let callable = Callable {
                    name: None,
                    parameters: closure.inputs.iter().cloned().collect(),
                    body: (*closure.body).clone(),
                };
                Value::Function(Closure { callable: Rc::new(callable), scopes: Rc::new(self.scopes.clone()) })
            }
            Expr::Call(call) => self.call(call),
            Expr::MethodCall(call) => self.method_call(call),
            Expr::Macro(call) => self.refuse(call, other_macro(&call.mac)),
            Expr::Return(e) => self.refuse(e, "an energy has one exit: make the value the last expression"),
            Expr::Continue(e) => self.leave(e, e.label.as_ref(), Exit::Continue),
            Expr::Break(e) if e.expr.is_none() => self.leave(e, e.label.as_ref(), Exit::Break),
            Expr::While(e) => self.refuse(&e.while_token, "`while` has no derivative; use `for` over a range"),
            Expr::Loop(e) => self.refuse(&e.loop_token, "`loop` has no derivative; use `for` over a range"),
            Expr::Match(e) => self.refuse(&e.match_token, "`match` is not supported; use `if … else if … else`"),
            other => self.refuse(other, format!("this expression is not supported: {EXPRESSIONS}")),
        }
    }

    fn unary(&mut self, unary: &ExprUnary) -> Value {
        match (&unary.op, self.expr(&unary.expr)) {
            (UnOp::Deref(_), value) => value,
            (_, Value::Poison) => Value::Poison,
            (UnOp::Neg(_), Value::Integer(n)) => match n.checked_neg() {
                Some(n) => Value::Integer(n),
                None => self.refuse(unary, "this integer is out of bounds"),
            },
            (UnOp::Neg(_), Value::Opaque(path)) => Value::Opaque(quote!((-#path))),
            (UnOp::Neg(_), Value::Vector(ids)) => Value::Vector(ids.iter().map(|id| self.graph.neg(*id)).collect()),
            (UnOp::Neg(_), value) => {
                let id = self.real(&unary.expr, value);
                Value::Real(self.graph.neg(id))
            }
            (UnOp::Not(_), Value::Truth(id)) => Value::Truth(self.graph.not(id)),
            (_, other) => self.refuse(unary, format!("this operator does not apply to {}", other.kind())),
        }
    }

    /// Evaluates `a + b + c + …` in a loop over its operators. A recursion would be as deep as the sum is long.
    fn chain(&mut self, outermost: &ExprBinary) -> Value {
        let mut operations = vec![outermost];
        let mut first = &*outermost.left;
        while let Expr::Binary(inner) = first
            && (is_arithmetic(&inner.op) || is_comparison(&inner.op))
        {
            operations.push(inner);
            first = &inner.left;
        }
        let factors = operations.iter().filter(|operation| matches!(operation.op, BinOp::Mul(_) | BinOp::Div(_)));
        if factors.count() > super::MAX_DEPTH {
            return self.refuse(outermost, format!("a product has {} factors at most", super::MAX_DEPTH));
        }
        // UndefinedAt sums start at the same token. The search for the start is not repeated for each term.
        let (start, _) = super::place(first);
        let mut value = self.expr(first);
        for operation in operations.into_iter().rev() {
            let right = self.expr(&operation.right);
            value = self.arithmetic(operation, &operation.op, value, right);
            if let Value::Real(id) = value {
                value = self.written(id, operation, || (start, super::place(&operation.right).1));
            }
        }
        value
    }

    fn literal(&mut self, lit: &Lit) -> Value {
        let number = match lit {
            Lit::Float(x) => Number::decimal(x.base10_digits()),
            Lit::Int(n) if n.suffix().starts_with('f') => Number::decimal(n.base10_digits()),
            Lit::Int(n) => {
                return match n.base10_parse() {
                    Ok(n) => Value::Integer(n),
                    Err(_) => self.refuse(lit, "this integer is out of bounds"),
                };
            }
            Lit::Bool(b) => return Value::Truth(self.graph.truth(b.value)),
            _ => None,
        };
        match number {
            Some(number) if number.to_f64().is_finite() => Value::Real(self.graph.number(number)),
            _ => self.refuse(lit, "an energy is made of finite numbers"),
        }
    }

    fn path(&mut self, path: &Path) -> Value {
        let Some(last) = path.segments.last() else { return Value::Poison };
        let name = last.ident.to_string();
        if path.get_ident().is_some()
            && let Some(value) = self.named(path, &name)
        {
            return value;
        }
        if let Some(value) = constants::of_path(path) {
            return Value::Real(self.graph.number(value));
        }
        // Upper case is a constant from outside of the function. Generated code contains its path.
        if name.chars().all(|c| c.is_uppercase() || c.is_numeric() || c == '_') {
            let first = path.segments[0].ident.to_string();
            let everywhere = path.leading_colon.is_some()
                || path.segments.len() > 1 && ["crate", "core", "std", "f64", "f32"].contains(&first.as_str());
            if self.scopes.is_foreign && !everywhere {
                return self.refuse(
                    path,
                    format!(
                        "where this function is inlined `{name}` may be another constant: make it an argument or a `const` \
                         inside, or name it from the root, `crate::…` or `std::f64::consts::…`"
                    ),
                );
            }
            return Value::Opaque(path.to_token_stream());
        }
        let message = match self.scopes.similar(&name) {
            Some(similar) => format!("`{name}` is not known here; is `{similar}` meant?"),
            None => format!(
                "`{name}` is not known here: an energy sees its arguments, its own variables, and constants. A quantity from \
                 outside becomes an argument, `{name}: f64`"
            ),
        };
        self.refuse(path, message)
    }

    /// Returns the value of a variable or an item.
    pub(super) fn named(&mut self, syntax: &impl ToTokens, name: &str) -> Option<Value> {
        Some(match self.scopes.get(name)? {
            Found::Variable(value) | Found::Item(Item::Import(value), _) => value,
            Found::Item(Item::Function(callable), scopes) => {
                Value::Function(Closure { callable, scopes: Rc::new(scopes) })
            }
            Found::Item(Item::Outside(function), _) => Value::Function(function),
            Found::Item(Item::Constant(constant), scopes) => self.constant_item(syntax, &constant, scopes),
        })
    }

    fn index(&mut self, base_syntax: &Expr, syntax: &Expr, base: Value, index: Value) -> Value {
        if base.is_poison() {
            return Value::Poison;
        }
        let Some(i) = self.integer(syntax, index) else { return Value::Poison };
        match &base {
            Value::List(_) | Value::Vector(_) => match usize::try_from(i).ok().and_then(|i| base.part(&[i])) {
                Some(value) => value,
                None => self.refuse(syntax, format!("the index {i} is out of bounds")),
            },
            Value::Opaque(path) => {
                let i = Literal::i128_unsuffixed(i);
                Value::Opaque(quote!(#path[#i]))
            }
            other => self.refuse(base_syntax, format!("{} cannot be indexed", other.kind())),
        }
    }

    fn field(&mut self, field: &syn::ExprField) -> Value {
        let base = self.expr(&field.base);
        match (&field.member, base) {
            (_, Value::Poison) => Value::Poison,
            (Member::Named(name), Value::Vector(ids)) => match axis(name).and_then(|i| ids.get(i)) {
                Some(id) => Value::Real(*id),
                None => self.refuse(&field.member, format!("a vector of length {} has no such component", ids.len())),
            },
            (Member::Named(name), Value::Quaternion(ids)) => match quaternion::field_of_quaternion(name, &ids) {
                Some(value) => value,
                None => self.refuse(&field.member, quaternion::FIELDS),
            },
            (Member::Unnamed(index), Value::Tuple(items)) => match items.into_iter().nth(index.index as usize) {
                Some(value) => value,
                None => self.refuse(&field.member, "the tuple has no such component"),
            },
            (_, other) => self.refuse(field, format!("{} has no such field", other.kind())),
        }
    }

    fn range(&mut self, range: &syn::ExprRange) -> Value {
        let (Some(start), Some(end)) = (&range.start, &range.end) else {
            return self.refuse(range, "a range needs both ends, as in `0..3`");
        };
        let (low, high) = (self.expr(start), self.expr(end));
        let (Some(low), Some(high)) = (self.integer(start, low), self.integer(end, high)) else { return Value::Poison };
        let high = if matches!(range.limits, RangeLimits::Closed(_)) { high.saturating_add(1) } else { high };
        if high.saturating_sub(low) > 100_000 {
            return self.refuse(
                range,
                "this range is too long: loops are unrolled, and rustc could not compile that in good time",
            );
        }
        self.evaluations += (high - low).max(0) as usize;
        Value::iterator((low..high).map(Value::Integer))
    }
}
