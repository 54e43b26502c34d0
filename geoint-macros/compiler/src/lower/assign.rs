//! Assignments. Loops are unrolled, so each variable has one known value at each point.
//!
//! Branches on data, closures and nested functions can only read outer variables. Otherwise the value of a variable would depend on data or on the caller.

use super::Lowering;
use super::language::compound;
use super::scope::Refused;
use super::value::{Around, Value, axis};
use quote::ToTokens;
use syn::visit::Visit;
use syn::{BinOp, Expr, ExprAssign, ExprBinary, Member};

/// Left side of an assignment: a variable, or a part of one.
struct Target {
    name: String,
    /// Indices of the part, from outside in.
    indices: Vec<usize>,
    /// Text of the user.
    text: String,
}

/// Kind of an assignment. Messages suggest the same operator.
#[derive(Clone, Copy)]
enum Update {
    /// `=`, `*=` and similar.
    Replace,
    /// `+=` and `-=`.
    Add,
}

impl Lowering {
    /// Evaluates `target = value`.
    pub(super) fn assign(&mut self, assignment: &ExprAssign) -> Value {
        let value = self.expr(&assignment.right);
        // The value can be a pending `continue` or `break`: `x += if … { continue } else { … }`.
        if self.is_leaving() {
            return Value::Poison;
        }
        self.assign_to(assignment, &assignment.left, value)
    }

    /// Evaluates `target op= value`.
    pub(super) fn assign_with(&mut self, assignment: &ExprBinary, op: &BinOp) -> Value {
        // rustc evaluates the value before the target.
        let value = self.expr(&assignment.right);
        if self.is_leaving() {
            return Value::Poison;
        }
        let Some(target) = self.target(&assignment.left) else { return Value::Poison };
        let update = if matches!(op, BinOp::Add(_) | BinOp::Sub(_)) { Update::Add } else { Update::Replace };
        let Some(variable) = self.variable(assignment, &target, update) else { return Value::Poison };
        let Some(before) = variable.part(&target.indices) else { return self.no_part(&assignment.left) };
        let after = match self.arithmetic(assignment, op, before, value) {
            Value::Real(id) => self.written(id, assignment, || super::place(assignment)),
            other => other,
        };
        self.replace(&assignment.left, &target, after)
    }

    fn assign_to(&mut self, syntax: &impl ToTokens, target: &Expr, value: Value) -> Value {
        match (target, value) {
            (Expr::Paren(inner), value) => self.assign_to(syntax, &inner.expr, value),
            (Expr::Group(inner), value) => self.assign_to(syntax, &inner.expr, value),
            (Expr::Infer(_), _) => Value::unit(),
            (Expr::Tuple(_) | Expr::Array(_), Value::Poison) => Value::Poison,
            (Expr::Tuple(targets), Value::Tuple(values)) if targets.elems.len() == values.len() => {
                self.assign_each(&targets.elems, &values)
            }
            (Expr::Array(targets), Value::List(values)) if targets.elems.len() == values.len() => {
                self.assign_each(&targets.elems, &values)
            }
            (_, value) => {
                let Some(place) = self.target(target) else { return Value::Poison };
                match self.variable(syntax, &place, Update::Replace) {
                    Some(_) => self.replace(target, &place, value),
                    None => Value::Poison,
                }
            }
        }
    }

    fn assign_each<'a>(&mut self, targets: impl IntoIterator<Item = &'a Expr>, values: &[Value]) -> Value {
        targets.into_iter().zip(values).for_each(|(target, value)| _ = self.assign_to(target, target, value.clone()));
        Value::unit()
    }

    /// Returns the variable and the indices of a target. `None` after an error.
    fn target(&mut self, place: &Expr) -> Option<Target> {
        match place {
            Expr::Path(path) if path.path.get_ident().is_some() => {
                let name = path.path.get_ident()?.to_string();
                Some(Target { text: name.clone(), name, indices: vec![] })
            }
            Expr::Paren(inner) => self.target(&inner.expr),
            Expr::Group(inner) => self.target(&inner.expr),
            Expr::Unary(syn::ExprUnary { op: syn::UnOp::Deref(_), expr, .. }) => self.target(expr),
            Expr::Index(index) => {
                let mut target = self.target(&index.expr)?;
                if assigns(&index.index) {
                    self.refuse(&index.index, "this index changes something itself: bind it with `let` first");
                    return None;
                }
                let i = self.expr(&index.index);
                let i = self.integer(&index.index, i)?;
                let Ok(i) = usize::try_from(i) else {
                    self.refuse(&index.index, format!("the index {i} is out of bounds"));
                    return None;
                };
                target.indices.push(i);
                target.text += &format!("[{}]", index.index.to_token_stream());
                Some(target)
            }
            Expr::Field(field) => {
                let mut target = self.target(&field.base)?;
                let index = match &field.member {
                    Member::Unnamed(index) => Some(index.index as usize),
                    Member::Named(name) => axis(name),
                };
                let Some(index) = index else {
                    self.refuse(&field.member, "only components of vectors and tuples can be assigned to");
                    return None;
                };
                target.indices.push(index);
                target.text += &format!(".{}", field.member.to_token_stream());
                Some(target)
            }
            other => {
                self.refuse(other, "a variable is assigned to, or a part of one: `x = …`, `x[i] = …`");
                None
            }
        }
    }

    /// Returns the variable to assign to. `None` after an error, or if the value of the variable is poison.
    fn variable(&mut self, syntax: &impl ToTokens, target: &Target, update: Update) -> Option<&mut Value> {
        let name = &target.name;
        let message = match self.scopes.assignable(name) {
            Ok(Value::Poison) => return None,
            // The borrow checker needs a second search.
            Ok(_) => return self.scopes.assignable(name).ok(),
            Err(Refused::Unknown) => format!("`{name}` is no variable of this function"),
            Err(Refused::Outside(around)) => outside(target, around, update),
        };
        self.refuse(syntax, message);
        None
    }

    fn replace(&mut self, syntax: &Expr, target: &Target, value: Value) -> Value {
        match self.scopes.assignable(&target.name).map(|variable| variable.replace_part(&target.indices, value)) {
            Ok(Some(())) => Value::unit(),
            Ok(None) => self.no_part(syntax),
            Err(_) => Value::Poison,
        }
    }

    /// Reports a part that does not exist. The evaluation of the target usually gives a more precise message.
    fn no_part(&mut self, target: &Expr) -> Value {
        let errors = self.errors.len();
        self.expr(target);
        if self.errors.len() == errors {
            self.refuse(target, "the macro does not know the parts of this: build the array from its elements first");
        }
        Value::Poison
    }
}

/// Returns whether an expression contains an assignment.
fn assigns(expr: &Expr) -> bool {
    struct Assignments(bool);
    impl Visit<'_> for Assignments {
        fn visit_expr_assign(&mut self, _: &ExprAssign) {
            self.0 = true;
        }
        fn visit_expr_binary(&mut self, binary: &ExprBinary) {
            self.0 |= compound(&binary.op).is_some();
            syn::visit::visit_expr_binary(self, binary);
        }
    }
    let mut assignments = Assignments(false);
    assignments.visit_expr(expr);
    assignments.0
}

/// Returns the message for an assignment to an outer variable, with an alternative.
fn outside(Target { name, text, .. }: &Target, around: Around, update: Update) -> String {
    let (place, advice) = match (around, update) {
        (Around::Branch, Update::Add) => {
            ("branch", format!("make the branch a value, as in `{text} += if … {{ … }} else {{ 0.0 }}`"))
        }
        (Around::Branch, Update::Replace) => {
            ("branch", format!("make the branch a value, as in `{text} = if … {{ … }} else {{ {text} }}`"))
        }
        (Around::Function, Update::Add) => ("function", format!("return the value, and add that with `{text} += …`")),
        (Around::Function, Update::Replace) => ("function", format!("return the value, and assign that: `{text} = …`")),
    };
    format!("`{name}` is a variable outside of this {place}: {advice}")
}
