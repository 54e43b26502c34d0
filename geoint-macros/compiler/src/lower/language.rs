//! The language of bodies: kinds of operators, and messages about unsupported code.

use syn::BinOp;

pub(super) const EXPRESSIONS: &str = "an energy is made of numbers, arrays, vectors, `+ - * /`, methods of `f64`, `if … else`, \
                           closures, `for` over ranges, and sums over iterators";

pub(super) const STATEMENTS: &str =
    "a body is made of `let`, `const`, `type`, nested `fn`, `for`, assignments, and a last expression";

pub(super) const POWER: &str =
    "this is no power: write `x.powi(2)` or `x * x`, and `x.powf(y)` where the exponent is no integer";

pub(super) const THROUGH_REFERENCE: &str =
    "what is changed through a reference is not followed: bind a new variable with `let`";

/// Returns the message for a macro in the body.
pub(super) fn other_macro(call: &syn::Macro) -> String {
    let name = call.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default();
    format!("this attribute cannot see into `{name}!`: check arguments where the function is called; {EXPRESSIONS}")
}

pub(super) fn is_arithmetic(op: &BinOp) -> bool {
    matches!(op, BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Div(_) | BinOp::Rem(_))
}

pub(super) fn is_comparison(op: &BinOp) -> bool {
    matches!(op, BinOp::Lt(_) | BinOp::Le(_) | BinOp::Gt(_) | BinOp::Ge(_) | BinOp::Eq(_) | BinOp::Ne(_))
}

/// Returns the operator of a compound assignment, such as `+` of `+=`.
pub(super) fn compound(op: &BinOp) -> Option<BinOp> {
    Some(match op {
        BinOp::AddAssign(_) => BinOp::Add(Default::default()),
        BinOp::SubAssign(_) => BinOp::Sub(Default::default()),
        BinOp::MulAssign(_) => BinOp::Mul(Default::default()),
        BinOp::DivAssign(_) => BinOp::Div(Default::default()),
        BinOp::RemAssign(_) => BinOp::Rem(Default::default()),
        BinOp::BitAndAssign(_) => BinOp::BitAnd(Default::default()),
        BinOp::BitOrAssign(_) => BinOp::BitOr(Default::default()),
        BinOp::ShlAssign(_) => BinOp::Shl(Default::default()),
        BinOp::ShrAssign(_) => BinOp::Shr(Default::default()),
        _ => return None,
    })
}
