//! Operators, powers and casts: of numbers, of vectors, of integers.

use super::Lowering;
use super::language::{EXPRESSIONS, is_arithmetic};
use super::value::Value;
use crate::ir::{Id, Number, Ratio, Relation};
use quote::{ToTokens, quote};
use syn::BinOp;

const INTEGER_BESIDE_NUMBER: &str = "an integer stands beside a number of type `f64` or `f32`: write `0.5` or `1.0 / 2.0` for a half, `2.0 * q` \
                                     for `2 * q`, and `i as f64` for a counter";

impl Lowering {
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
            (Vector(a), Vector(b)) if a.len() == b.len() => match op {
                BinOp::Add(_) => Vector(a.iter().zip(&b).map(|(a, b)| self.graph.add(*a, *b)).collect()),
                BinOp::Sub(_) => Vector(a.iter().zip(&b).map(|(a, b)| self.graph.sub(*a, *b)).collect()),
                _ => self.refuse(syntax, "two vectors have a sum, a difference, `dot` and `cross`"),
            },
            (Vector(a), b @ (Real(_) | Opaque(_))) if matches!(op, BinOp::Mul(_) | BinOp::Div(_)) => {
                let b = self.real(syntax, b);
                let factor = if matches!(op, BinOp::Div(_)) { self.graph.recip(b) } else { b };
                Vector(a.iter().map(|a| self.graph.mul(*a, factor)).collect())
            }
            (a @ (Real(_) | Opaque(_)), Vector(b)) if matches!(op, BinOp::Mul(_)) => {
                let a = self.real(syntax, a);
                Vector(b.iter().map(|b| self.graph.mul(a, *b)).collect())
            }
            (Quaternion(r), Vector(v)) if v.len() == 3 && matches!(op, BinOp::Mul(_)) => {
                Vector(self.rotated(&r, &[v[0], v[1], v[2]]).to_vec())
            }
            (Quaternion(a), Quaternion(b)) if matches!(op, BinOp::Mul(_)) => Quaternion(self.product(&a, &b)),
            (Quaternion(a), Quaternion(b)) if matches!(op, BinOp::Div(_)) => {
                let b = self.conjugate(&b);
                Quaternion(self.product(&a, &b))
            }
            (Quaternion(_), _) | (_, Quaternion(_)) => self.refuse(syntax, super::quaternion::OPERATORS),
            // Whether these are integers is known to rustc alone, so that it has to do what they decide.
            (Opaque(a), Opaque(b)) if is_arithmetic(op) => Opaque(quote!((#a #op #b))),
            (Opaque(a), Integer(b)) if is_arithmetic(op) => {
                let b = proc_macro2::Literal::i128_unsuffixed(b);
                Opaque(quote!((#a #op #b)))
            }
            (Integer(a), Opaque(b)) if is_arithmetic(op) => {
                let a = proc_macro2::Literal::i128_unsuffixed(a);
                Opaque(quote!((#a #op #b)))
            }
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
        Value::Real(match op {
            BinOp::Add(_) => graph.add(a, b),
            BinOp::Sub(_) => graph.sub(a, b),
            BinOp::Mul(_) => graph.mul(a, b),
            BinOp::Div(_) => graph.div(a, b),
            _ => {
                let (relation, a, b, negated) = match op {
                    BinOp::Lt(_) => (Relation::Less, a, b, false),
                    BinOp::Le(_) => (Relation::LessEqual, a, b, false),
                    BinOp::Gt(_) => (Relation::Less, b, a, false),
                    BinOp::Ge(_) => (Relation::LessEqual, b, a, false),
                    BinOp::Eq(_) => (Relation::Equal, a, b, false),
                    BinOp::Ne(_) => (Relation::Equal, a, b, true),
                    _ => return self.refuse(syntax, format!("numbers have no such operator; {EXPRESSIONS}")),
                };
                let truth = graph.compare(relation, a, b);
                return Value::Truth(if negated { graph.not(truth) } else { truth });
            }
        })
    }

    fn integers(&mut self, syntax: &impl ToTokens, op: &BinOp, a: i128, b: i128) -> Value {
        let truth = match op {
            BinOp::Lt(_) => Some(a < b),
            BinOp::Le(_) => Some(a <= b),
            BinOp::Gt(_) => Some(a > b),
            BinOp::Ge(_) => Some(a >= b),
            BinOp::Eq(_) => Some(a == b),
            BinOp::Ne(_) => Some(a != b),
            _ => None,
        };
        if let Some(truth) = truth {
            return Value::Truth(self.graph.truth(truth));
        }
        let result = match op {
            BinOp::Add(_) => a.checked_add(b),
            BinOp::Sub(_) => a.checked_sub(b),
            BinOp::Mul(_) => a.checked_mul(b),
            BinOp::Div(_) => a.checked_div(b),
            BinOp::Rem(_) => a.checked_rem(b),
            _ => None,
        };
        match result {
            Some(n) => Value::Integer(n),
            None => self.refuse(syntax, "this integer cannot be computed; integers have `+ - * / %`"),
        }
    }

    /// xʸ: closed forms for exponents that are integers or halves.
    pub(super) fn power(&mut self, base: Id, exponent: Id) -> Id {
        let half_integer = self.graph.as_number(exponent).and_then(|exponent| match exponent {
            Number::Exact(ratio) if ratio.denominator <= 2 && ratio.numerator.abs() <= 64 => Some(ratio),
            _ => None,
        });
        match half_integer {
            Some(ratio) => self.graph.pow(base, ratio),
            None => self.graph.call(crate::ir::Function::Powf, &[base, exponent]),
        }
    }

    pub(super) fn integer_power(&mut self, base: Id, n: i64) -> Id {
        self.graph.pow(base, Ratio::integer(n.into()))
    }

    pub(super) fn cast(&mut self, cast: &syn::ExprCast) -> Value {
        let value = self.expr(&cast.expr);
        if matches!(value, Value::Poison) {
            return Value::Poison;
        }
        let target = match &self.scopes.outside().resolve(&cast.ty) {
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
            // It is a number from here on, so that `/` is no longer that of integers.
            Value::Opaque(path) => Value::Real(self.constant(path)),
            Value::Real(id) if self.graph.as_number(id).is_some() => Value::Real(id),
            Value::Real(_) => {
                let float = &self.float;
                let message = format!("this is a number of type `{float}` already: leave the cast out");
                self.refuse(cast, message)
            }
            other => self.refuse(cast, format!("{} cannot be cast to a number", other.kind())),
        }
    }

    /// A value as an integer.
    pub(super) fn integer(&mut self, syntax: &impl ToTokens, value: Value) -> Option<i128> {
        match value {
            Value::Integer(n) => return Some(n),
            Value::Poison => {}
            Value::Opaque(_) => {
                self.refuse(syntax, "this number is not known to the macro: make it a `const` in the body, or repeat the one outside in the \
                     attribute: `const N = …`");
            }
            Value::Real(_) => {
                self.refuse(
                    syntax,
                    "a bound or index that depends on data is not supported: it must be an integer constant",
                );
            }
            other => {
                self.refuse(syntax, format!("expected an integer, found {}", other.kind()));
            }
        }
        None
    }
}

/// `n as target`: the bits that fit. Of `usize` and `isize` only what fits on every processor.
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
