//! The sign of a node, derived from its form and valid for all values of its symbols.

use super::id::Id;
use super::node::Node;
use super::number::Number;
use super::op::Function;
use super::table::Table;

/// The known lower bound of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Sign {
    Unknown,
    NotNegative,
    Positive,
}

/// Derives the sign of a node from its operands and their signs.
pub(super) fn sign(node: &Node, operands: &[Node], signs: &Table<Sign>) -> Sign {
    use Function::{Abs, Cbrt, Cos, Cosh, Exp, Exp2, Hypot, Max, Min, Sin, Tanh};
    use Sign::{NotNegative, Positive, Unknown};
    let of = |id: Id| signs[id];
    let largest = |args: &[Id]| args.iter().map(|arg| of(*arg)).max().unwrap_or(Unknown);
    let smallest = |args: &[Id]| args.iter().map(|arg| of(*arg)).min().unwrap_or(Unknown);
    match node {
        Node::Number(value) if value.is_negative() => Unknown,
        Node::Number(value) if value.is_zero() => NotNegative,
        Node::Number(_) => Positive,
        Node::Linear(constant, terms) => {
            // The magnitude of the lower bound of a term, if it is finite.
            let depth = |(c, term): &(Number, Id)| match operands[term.index()] {
                Node::Call(Sin | Cos | Tanh, _) => Some(c.to_f64().abs()),
                _ if c.is_negative() || of(*term) == Unknown => None,
                _ => Some(0.0),
            };
            let Some(depth) = terms.iter().map(depth).sum::<Option<f64>>() else { return Unknown };
            let positive = |(c, term): &(Number, Id)| !c.is_negative() && of(*term) == Positive;
            match constant.to_f64() - depth {
                margin if margin > 0.0 || (margin == 0.0 && terms.iter().any(positive)) => Positive,
                0.0 => NotNegative,
                _ => Unknown,
            }
        }
        Node::Product(factors) => smallest(factors),
        Node::Power(base, exponent) => match of(*base) {
            Unknown if !exponent.is_integer() || exponent.numerator % 2 == 0 => NotNegative,
            sign => sign,
        },
        Node::Call(Exp | Exp2 | Cosh, _) => Positive,
        Node::Call(Cbrt | Min, args) => smallest(args),
        Node::Call(Max, args) => largest(args),
        Node::Call(Abs | Hypot, args) => largest(args).max(NotNegative),
        Node::Select(_, first, second) => of(*first).min(of(*second)),
        _ => Unknown,
    }
}
