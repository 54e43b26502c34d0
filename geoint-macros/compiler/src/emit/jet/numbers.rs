//! Scalar expressions in the emitted coefficients: constants, and numbers computed once per step.

use crate::diff::jet::{Factor, Value};
use crate::emit::tokens::Tokens;
use crate::emit::tokens::element;
use crate::ir::Number;
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

/// A number computed once per step, from values at the start.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum StepNumber {
    Value(Value),
    /// 1/v.
    Reciprocal(Value),
    /// 1/(2v).
    HalfReciprocal(Value),
    /// α + 1 for an exponent α.
    Next(Factor),
    /// α·y/u, from α, y and u.
    Ratio(Factor, Value, Value),
    /// c·v for a time derivative v, in the unit of time of the coefficients.
    Slope(Number, Value),
    /// The unit of time of the coefficients.
    Unit,
}

impl StepNumber {
    /// Returns the expression of the number.
    pub(super) fn tokens(self, values: &[Tokens]) -> TokenStream {
        let over = |c: Number, value: Value| {
            let (c, value) = (constant(c), &values[value]);
            quote!(#c / #value)
        };
        match self {
            StepNumber::Value(value) => values[value].to_token_stream(),
            StepNumber::Reciprocal(value) => over(Number::ONE, value),
            StepNumber::HalfReciprocal(value) => over(Number::HALF, value),
            StepNumber::Next(Factor::Number(exponent)) => constant(exponent.add(Number::ONE)),
            StepNumber::Next(Factor::Value(exponent)) => {
                let exponent = &values[exponent];
                quote!(#exponent + R::from_f64(1.0))
            }
            StepNumber::Ratio(exponent, y, u) => {
                let (exponent, y, u) = (factor(exponent, values), &values[y], &values[u]);
                quote!(#exponent * #y / #u)
            }
            StepNumber::Slope(c, value) => {
                let slope = scaled(c, values[value].to_token_stream());
                quote!(unit * (#slope))
            }
            StepNumber::Unit => quote!(unit),
        }
    }
}

/// Returns the expression of a factor at the start of a step.
pub(super) fn factor(factor: Factor, values: &[Tokens]) -> TokenStream {
    match factor {
        Factor::Number(number) => constant(number),
        Factor::Value(value) => values[value].to_token_stream(),
    }
}

/// Returns a constant of the scalar type.
pub(super) fn constant(number: Number) -> TokenStream {
    let literal = Literal::f64_unsuffixed(number.to_f64().abs());
    match number.to_f64() {
        x if x.is_nan() => quote!(R::from_f64(f64::NAN)),
        x if x.is_infinite() && x > 0.0 => quote!(R::from_f64(f64::INFINITY)),
        x if x.is_infinite() => quote!(R::from_f64(-f64::INFINITY)),
        x if x < 0.0 => quote!(R::from_f64(-#literal)),
        _ => quote!(R::from_f64(#literal)),
    }
}

/// Returns 0 of the scalar type. A literal inside `quote!` would be parsed at each use.
pub(super) fn zero() -> TokenStream {
    constant(Number::ZERO)
}

/// Returns `list[index]`.
pub(super) fn entry(list: impl ToTokens, index: usize) -> TokenStream {
    element(list.to_token_stream(), &[index]).to_token_stream()
}

/// Returns c·x.
pub(super) fn scaled(c: Number, x: TokenStream) -> TokenStream {
    match c {
        Number::ONE => x,
        Number::MINUS_ONE => quote!(-#x),
        _ => {
            let c = constant(c);
            quote!(#c * #x)
        }
    }
}
