//! Numbers in the coefficients: constants, and what is computed once a step.

use crate::diff::jet::{Factor, Value};
use crate::emit::tokens::Tokens;
use crate::ir::Number;
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

/// A number that is computed once a step.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Prepared {
    Value(Value),
    /// 1/v.
    Reciprocal(Value),
    /// 1/(2v).
    HalfReciprocal(Value),
    /// α + 1.
    Next(Factor),
    /// α·w/u.
    Ratio(Factor, Value, Value),
    /// c·v for a derivative v by time, in the unit of time of the coefficients.
    Slope(Number, Value),
    /// That unit.
    Unit,
}

/// A number of the start, from the values there.
pub(super) fn prepared(number: Prepared, values: &[Tokens]) -> TokenStream {
    let factor = |number: Factor| factor(number, values);
    match number {
        Prepared::Value(value) => values[value].to_token_stream(),
        Prepared::Reciprocal(value) => {
            let value = &values[value];
            quote!(R::from_f64(1.0) / #value)
        }
        Prepared::HalfReciprocal(value) => {
            let value = &values[value];
            quote!(R::from_f64(0.5) / #value)
        }
        Prepared::Next(Factor::Number(exponent)) => constant(exponent.add(Number::ONE)),
        Prepared::Next(Factor::Value(exponent)) => {
            let exponent = &values[exponent];
            quote!(#exponent + R::from_f64(1.0))
        }
        Prepared::Ratio(exponent, w, u) => {
            let (exponent, w, u) = (factor(exponent), &values[w], &values[u]);
            quote!(#exponent * #w / #u)
        }
        Prepared::Slope(c, value) => {
            let slope = scaled(c, values[value].to_token_stream());
            quote!(unit * (#slope))
        }
        Prepared::Unit => quote!(unit),
    }
}

/// What a coefficient is multiplied by, from the values at the start.
pub(super) fn factor(factor: Factor, values: &[Tokens]) -> TokenStream {
    match factor {
        Factor::Number(number) => constant(number),
        Factor::Value(value) => values[value].to_token_stream(),
    }
}

/// A constant of the scalar type.
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

/// 0 of the scalar type. A literal that is quoted as it stands is parsed every time.
pub(super) fn zero() -> TokenStream {
    constant(Number::ZERO)
}

/// c·x.
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
