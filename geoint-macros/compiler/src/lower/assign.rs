//! Assignments. Loops are unrolled, so that at every point a variable has the value that was given to it last.
//!
//! Inside a branch on data, a closure or a nested function, variables from outside of it can be read only: which value they have
//! afterwards would depend on data, or on who calls.

use super::Lowering;
use super::language::compound;
use super::scope::Refused;
use super::value::{Around, Value, axis};
use quote::ToTokens;
use std::rc::Rc;
use syn::visit::Visit;
use syn::{BinOp, Expr, ExprAssign, ExprBinary, Member};

/// A variable, and the indices that lead to the part of it that is assigned to.
struct Target {
    name: String,
    indices: Vec<usize>,
    /// As it is written.
    text: String,
}

impl Lowering {
    /// `target = value`.
    pub(super) fn assign(&mut self, assignment: &ExprAssign) -> Value {
        let value = self.expr(&assignment.right);
        // The value may be on its way out of a loop: `x += if … { continue } else { … }`.
        if self.is_leaving() {
            return Value::Poison;
        }
        self.assign_to(assignment, &assignment.left, value)
    }

    /// `target op= value`.
    pub(super) fn assign_with(&mut self, assignment: &ExprBinary, op: &BinOp) -> Value {
        // rustc, too, looks at the value before it looks at what a number is added to.
        let value = self.expr(&assignment.right);
        if self.is_leaving() {
            return Value::Poison;
        }
        let Some(target) = self.target(&assignment.left) else { return Value::Poison };
        let Some(variable) = self.variable(assignment, &target, additive(op)) else { return Value::Poison };
        let Some(before) = part(variable, &target.indices) else { return self.no_part(&assignment.left) };
        let after = self.arithmetic(assignment, op, before, value);
        let after = match after {
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
            // What is assigned has been refused.
            (Expr::Tuple(_) | Expr::Array(_), Value::Poison) => Value::Poison,
            (Expr::Tuple(targets), Value::Tuple(values)) if targets.elems.len() == values.len() => {
                for (target, value) in targets.elems.iter().zip(values) {
                    self.assign_to(target, target, value);
                }
                Value::unit()
            }
            (Expr::Array(targets), Value::List(values)) if targets.elems.len() == values.len() => {
                for (target, value) in targets.elems.iter().zip(values.iter()) {
                    self.assign_to(target, target, value.clone());
                }
                Value::unit()
            }
            (_, value) => {
                let Some(place) = self.target(target) else { return Value::Poison };
                if self.variable(syntax, &place, false).is_none() {
                    return Value::Poison;
                }
                self.replace(target, &place, value)
            }
        }
    }

    /// The variable that a place is a part of. Its indices are evaluated.
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
                match usize::try_from(i) {
                    Ok(i) => {
                        target.indices.push(i);
                        target.text += &format!("[{}]", index.index.to_token_stream());
                    }
                    Err(_) => {
                        self.refuse(&index.index, format!("the index {i} is out of bounds"));
                        return None;
                    }
                }
                Some(target)
            }
            Expr::Field(field) => {
                let mut target = self.target(&field.base)?;
                target.indices.push(match &field.member {
                    Member::Unnamed(index) => index.index as usize,
                    Member::Named(name) => match axis(name) {
                        Some(axis) => axis,
                        None => {
                            self.refuse(&field.member, "only components of vectors and tuples can be assigned to");
                            return None;
                        }
                    },
                });
                target.text += &format!(".{}", field.member.to_token_stream());
                Some(target)
            }
            other => {
                self.refuse(other, "a variable is assigned to, or a part of one: `x = …`, `x[i] = …`");
                None
            }
        }
    }

    /// The variable to assign to; says why if there is none. What has been said makes it nothing as well.
    fn variable(&mut self, syntax: &impl ToTokens, target: &Target, additive: bool) -> Option<&mut Value> {
        let name = &target.name;
        // Asked for twice, because messages need what the variable would borrow.
        match self.scopes.assignable(name) {
            Ok(Value::Poison) => return None,
            Ok(_) => {}
            Err(Refused::Unknown) => {
                self.refuse(syntax, format!("`{name}` is no variable of this function"));
                return None;
            }
            Err(Refused::Outside(around)) => {
                self.refuse(syntax, outside(target, around, additive));
                return None;
            }
        }
        self.scopes.assignable(name).ok()
    }

    fn replace(&mut self, syntax: &Expr, target: &Target, value: Value) -> Value {
        match self.scopes.assignable(&target.name) {
            Ok(variable) => match replace_part(variable, &target.indices, value) {
                Some(()) => Value::unit(),
                None => self.no_part(syntax),
            },
            Err(_) => Value::Poison,
        }
    }

    /// Evaluating says which index is out of bounds, or what has no parts.
    fn no_part(&mut self, target: &Expr) -> Value {
        let said = self.errors.len();
        self.expr(target);
        if self.errors.len() == said {
            self.refuse(target, "the macro does not know the parts of this: build the array from its elements first");
        }
        Value::Poison
    }
}

/// The part of a value that indices lead to.
fn part(value: &Value, indices: &[usize]) -> Option<Value> {
    match (indices, value) {
        ([], value) => Some(value.clone()),
        ([i], Value::Vector(ids)) => ids.get(*i).map(|id| Value::Real(*id)),
        ([i, rest @ ..], Value::List(items)) => part(items.get(*i)?, rest),
        ([i, rest @ ..], Value::Tuple(items)) => part(items.get(*i)?, rest),
        _ => None,
    }
}

/// Replaces the part of a value that indices lead to.
fn replace_part(value: &mut Value, indices: &[usize], new: Value) -> Option<()> {
    match (indices, value) {
        ([], value) => *value = new,
        (_, value) if matches!(new, Value::Poison) => *value = Value::Poison,
        ([i], Value::Vector(ids)) => match new {
            Value::Real(id) => *ids.get_mut(*i)? = id,
            _ => return None,
        },
        ([i, rest @ ..], Value::List(items)) => replace_part(Rc::make_mut(items).get_mut(*i)?, rest, new)?,
        ([i, rest @ ..], Value::Tuple(items)) => replace_part(items.get_mut(*i)?, rest, new)?,
        _ => return None,
    }
    Some(())
}

/// Whether an expression contains an assignment.
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

fn additive(op: &BinOp) -> bool {
    matches!(op, BinOp::Add(_) | BinOp::Sub(_))
}

/// Why a place cannot be assigned to, and what to write.
fn outside(Target { name, text, .. }: &Target, around: Around, additive: bool) -> String {
    match (around, additive) {
        (Around::Branch, true) => format!(
            "`{name}` is a variable outside of this branch: make the branch a value, as in \
             `{text} += if … {{ … }} else {{ 0.0 }}`"
        ),
        (Around::Branch, false) => format!(
            "`{name}` is a variable outside of this branch: make the branch a value, as in \
             `{text} = if … {{ … }} else {{ {text} }}`"
        ),
        (Around::Function, true) => format!(
            "`{name}` is a variable outside of this function: return the value, and add that with `{text} += …`"
        ),
        (Around::Function, false) => {
            format!("`{name}` is a variable outside of this function: return the value, and assign that: `{text} = …`")
        }
    }
}
