//! Operators, powers and casts.

use super::Lowering;
use super::language::{EXPRESSIONS, is_arithmetic};
use super::value::Value;
use crate::ir::{Function, Graph, Id, Number, Relation};
use crate::parse::integer_operation;
use proc_macro2::Literal;
use quote::{ToTokens, quote};
use syn::BinOp;

const INTEGER_BESIDE_NUMBER: &str = "an integer stands beside a number of type `f64` or `f32`: write `0.5` or `1.0 / 2.0` for a half, `2.0 * q` \
                                     for `2 * q`, and `i as f64` for a counter";

impl Lowering {
    /// Applies a binary operator.
    pub(super) fn arithmetic(&mut self, syntax: &impl ToTokens, op: &BinOp, left: Value, right: Value) -> Value {
        use Value::{Integer, Iterator, List, Opaque, Poison, Quaternion, Real, Truth, Tuple, Vector};
        match (left, right) {
            (Poison, _) | (_, Poison) => Poison,
            (Integer(a), Integer(b)) => self.integers(syntax, op, a, b),
            (Truth(a), Truth(b)) => match op {
                BinOp::And(_) => Truth(self.graph.and(a, b)),
                BinOp::Or(_) => Truth(self.graph.or(a, b)),
                _ => self.refuse(syntax, "conditions are combined with `&&`, `||` and `!`"),
            },
            (Vector(a), Vector(b)) if a.len() == b.len() => {
                let operation = match op {
                    BinOp::Add(_) => Graph::add,
                    BinOp::Sub(_) => Graph::sub,
                    _ => return self.refuse(syntax, "two vectors have a sum, a difference, `dot` and `cross`"),
                };
                Vector(a.iter().zip(&b).map(|(a, b)| operation(&mut self.graph, *a, *b)).collect())
            }
            (Vector(a), b @ (Real(_) | Opaque(_))) if matches!(op, BinOp::Mul(_) | BinOp::Div(_)) => {
                let b = self.real(syntax, b);
                let factor = if matches!(op, BinOp::Div(_)) { self.graph.recip(b) } else { b };
                Vector(a.iter().map(|a| self.graph.mul(*a, factor)).collect())
            }
            (a @ (Real(_) | Opaque(_)), Vector(b)) if matches!(op, BinOp::Mul(_)) => {
                let a = self.real(syntax, a);
                Vector(b.iter().map(|b| self.graph.mul(a, *b)).collect())
            }
            (Quaternion(r), Vector(v)) if v.len() == 3 && matches!(op, BinOp::Mul(_)) => self.rotated(&r, &v),
            (Quaternion(a), Quaternion(b)) if matches!(op, BinOp::Mul(_)) => Quaternion(self.product(&a, &b)),
            (Quaternion(a), Quaternion(b)) if matches!(op, BinOp::Div(_)) => {
                let b = self.conjugate(&b);
                Quaternion(self.product(&a, &b))
            }
            (Quaternion(_), _) | (_, Quaternion(_)) => self.refuse(syntax, super::quaternion::OPERATORS),
            // Only rustc knows whether the constants are integers, so rustc computes the result.
            (Opaque(a), Opaque(b)) if is_arithmetic(op) => opaque(op, &a, &b),
            (Opaque(a), Integer(b)) if is_arithmetic(op) => opaque(op, &a, &Literal::i128_unsuffixed(b)),
            (Integer(a), Opaque(b)) if is_arithmetic(op) => opaque(op, &Literal::i128_unsuffixed(a), &b),
            (a @ (Real(_) | Opaque(_)), b @ (Real(_) | Opaque(_))) => {
                let (a, b) = (self.real(syntax, a), self.real(syntax, b));
                self.reals(syntax, op, a, b)
            }
            (Integer(_), Real(_)) | (Real(_), Integer(_)) => self.refuse(syntax, INTEGER_BESIDE_NUMBER),
            (a @ (List(_) | Tuple(_) | Iterator(_)), _) | (_, a) => {
                self.refuse(syntax, format!("this operator does not apply to {}", a.kind()))
            }
        }
    }

    fn reals(&mut self, syntax: &impl ToTokens, op: &BinOp, a: Id, b: Id) -> Value {
        let graph = &mut self.graph;
        let real = match op {
            BinOp::Add(_) => graph.add(a, b),
            BinOp::Sub(_) => graph.sub(a, b),
            BinOp::Mul(_) => graph.mul(a, b),
            BinOp::Div(_) => graph.div(a, b),
            _ => return self.comparison(syntax, op, a, b),
        };
        Value::Real(real)
    }

    fn comparison(&mut self, syntax: &impl ToTokens, op: &BinOp, a: Id, b: Id) -> Value {
        let graph = &mut self.graph;
        let truth = match op {
            BinOp::Lt(_) => graph.compare(Relation::Less, a, b),
            BinOp::Le(_) => graph.compare(Relation::LessEqual, a, b),
            BinOp::Gt(_) => graph.compare(Relation::Less, b, a),
            BinOp::Ge(_) => graph.compare(Relation::LessEqual, b, a),
            BinOp::Eq(_) => graph.compare(Relation::Equal, a, b),
            BinOp::Ne(_) => {
                let equal = graph.compare(Relation::Equal, a, b);
                graph.not(equal)
            }
            _ => return self.refuse(syntax, format!("numbers have no such operator; {EXPRESSIONS}")),
        };
        Value::Truth(truth)
    }

    fn integers(&mut self, syntax: &impl ToTokens, op: &BinOp, a: i128, b: i128) -> Value {
        let truth = match op {
            BinOp::Lt(_) => a < b,
            BinOp::Le(_) => a <= b,
            BinOp::Gt(_) => a > b,
            BinOp::Ge(_) => a >= b,
            BinOp::Eq(_) => a == b,
            BinOp::Ne(_) => a != b,
            _ => {
                return match integer_operation(op, a, b) {
                    Some(n) => Value::Integer(n),
                    None => self.refuse(syntax, "this integer cannot be computed; integers have `+ - * / %`"),
                };
            }
        };
        Value::Truth(self.graph.truth(truth))
    }

    /// Returns xʸ. Integers up to 64 and half-integers up to 32 become exact exponents of the graph. Other exponents call `powf`.
    pub(super) fn power(&mut self, base: Id, exponent: Id) -> Id {
        let half_integer = self.graph.as_number(exponent).and_then(|exponent| match exponent {
            Number::Exact(ratio) if ratio.denominator <= 2 && ratio.numerator.abs() <= 64 => Some(ratio),
            _ => None,
        });
        match half_integer {
            Some(ratio) => self.graph.pow(base, ratio),
            None => self.graph.call(Function::Powf, &[base, exponent]),
        }
    }

    /// Evaluates `expr as type`.
    pub(super) fn cast(&mut self, cast: &syn::ExprCast) -> Value {
        let value = self.expr(&cast.expr);
        if value.is_poison() {
            return Value::Poison;
        }
        let target = match &self.scopes.outside.resolve(&cast.ty) {
            syn::Type::Path(path) => path.path.get_ident().map(ToString::to_string).unwrap_or_default(),
            _ => String::new(),
        };
        match (value, target.as_str()) {
            (value, "f64" | "f32") => self.cast_to_float(cast, &target, value),
            (Value::Integer(n), target) => match wrapped(n, target) {
                Some(n) => Value::Integer(n),
                None => self.refuse(&cast.ty, "integers can be cast to `f64` and to integers in whose bounds they lie"),
            },
            (Value::Opaque(path), _) => {
                let ty = &cast.ty;
                Value::Opaque(quote!((#path as #ty)))
            }
            _ => self.refuse(cast, "only integers can be cast: a number cast to an integer has no derivative"),
        }
    }

    fn cast_to_float(&mut self, cast: &syn::ExprCast, target: &str, value: Value) -> Value {
        if target != self.float {
            return self.refuse(&cast.ty, format!("all numbers of an energy have one type, here `{}`", self.float));
        }
        match value {
            Value::Integer(n) => Value::Real(self.graph.number(Number::float(n as f64))),
            // The cast makes `/` a division of floats.
            Value::Opaque(path) => Value::Real(self.constant(path)),
            Value::Real(id) if self.graph.as_number(id).is_some() => Value::Real(id),
            Value::Real(_) => {
                self.refuse(cast, format!("this is a number of type `{}` already: leave the cast out", self.float))
            }
            other => self.refuse(cast, format!("{} cannot be cast to a number", other.kind())),
        }
    }

    /// Returns a value as an integer.
    pub(super) fn integer(&mut self, syntax: &impl ToTokens, value: Value) -> Option<i128> {
        let message = match value {
            Value::Integer(n) => return Some(n),
            Value::Poison => return None,
            Value::Opaque(_) => UNKNOWN_INTEGER.into(),
            Value::Real(_) => {
                "a bound or index that depends on data is not supported: it must be an integer constant".into()
            }
            other => format!("expected an integer, found {}", other.kind()),
        };
        self.refuse(syntax, message);
        None
    }
}

const UNKNOWN_INTEGER: &str = "this number is not known to the macro: make it a `const` in the body, or repeat the one outside in the \
                               attribute: `const N = …`";

/// Returns the expression `(a op b)` for rustc.
fn opaque(op: &BinOp, a: &impl ToTokens, b: &impl ToTokens) -> Value {
    Value::Opaque(quote!((#a #op #b)))
}

/// Returns `n as target` with wrapping. `usize` and `isize` are limited to 32 bits, which all processors have.
fn wrapped(n: i128, target: &str) -> Option<i128> {
    match target {
        "i8" => Some((n as i8).into()),
        "i16" => Some((n as i16).into()),
        "i32" => Some((n as i32).into()),
        "i64" => Some((n as i64).into()),
        "i128" => Some(n),
        "u8" => Some((n as u8).into()),
        "u16" => Some((n as u16).into()),
        "u32" => Some((n as u32).into()),
        "u64" => Some((n as u64).into()),
        "usize" => u32::try_from(n).ok().map(Into::into),
        "isize" => i32::try_from(n).ok().map(Into::into),
        _ => None,
    }
}
