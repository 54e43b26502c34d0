//! Conditions on arguments of functions under which a formula has no value, or no derivative.

use crate::analyze;
use crate::ir::op::Domain as Defined;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, UndefinedAt};

/// A condition under which the energy is undefined.
#[derive(Clone, Debug)]
pub(crate) struct Check {
    pub(super) argument: Id,
    /// The sign of the argument for which the energy is undefined.
    pub(crate) forbidden: Sign,
    /// The message without the formula of `term`.
    pub(crate) message: String,
    /// The term to blame.
    pub(crate) term: Id,
    /// First square of an argument that is a sum of squares. If it is positive, so is the sum. Two bodies with different x, for example, do not collide.
    pub(crate) enough: Option<Id>,
}

/// A set of numbers that an argument must avoid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    Negative,
    NotPositive,
    Zero,
}

impl Check {
    pub(super) fn new(argument: Id, forbidden: Sign, message: impl Into<String>, term: Id) -> Check {
        Check { argument, forbidden, message: message.into(), term, enough: None }
    }
}

/// Returns the conditions under which an expression of the user is undefined. The branch of an `if` is tested only where its condition holds.
pub(super) fn checks_where(graph: &mut Graph, UndefinedAt { node, condition }: &UndefinedAt) -> Vec<Check> {
    let checks = checks_of(graph, *node).into_iter();
    checks.map(|check| Check { argument: guarded(graph, *condition, check.argument), ..check }).collect()
}

/// Returns a node where its condition holds, and 1 elsewhere. Every function of the language is defined at 1.
fn guarded(graph: &mut Graph, condition: Option<Id>, node: Id) -> Id {
    let one = graph.integer(1);
    condition.map_or(node, |condition| graph.select(condition, node, one))
}

/// Returns the first term of a sum of squares. The rounded sum is not below this term.
pub(super) fn square_of(graph: &Graph, sum: Id) -> Option<Id> {
    let Node::Linear(constant, terms) = graph.node(sum) else { return None };
    let is_square = |(c, term): &(Number, Id)| {
        let is_even = |exponent: &Ratio| exponent.is_integer() && exponent.numerator % 2 == 0;
        *c == Number::ONE && matches!(graph.node(*term), Node::Power(_, exponent) if is_even(exponent))
    };
    (!constant.is_negative() && terms.iter().all(is_square)).then(|| terms[0].1)
}

/// Returns the conditions under which a node or its gradient is undefined.
pub(super) fn checks_of(graph: &mut Graph, id: Id) -> Vec<Check> {
    match graph.node(id).clone() {
        Node::Power(base, exponent) => {
            let (sign, message) = match (exponent.is_integer(), exponent.numerator < 0) {
                (true, false) => return vec![],
                (true, true) => (Sign::Zero, "division by zero"),
                (false, true) => (Sign::NotPositive, "division by the root of a number that is not positive"),
                (false, false) if !analyze::has_edge(graph, id) => return vec![],
                (false, false) => (Sign::Negative, "`sqrt` of a negative number"),
            };
            vec![Check::new(base, sign, message, base)]
        }
        Node::Call(function, args) => {
            let Defined::Interval(low, high, of) = function.entry().domain else { return vec![] };
            let message = format!("`{}` of {of}", function.entry().name);
            // The distance of the argument from an end of the interval.
            let mut distance = |end: f64, sign: Number| {
                let (end, x) = (graph.number(Number::float(end).mul(sign.neg())), graph.scale(sign, args[0]));
                graph.add(end, x)
            };
            let mut ends = vec![distance(low, Number::ONE)];
            if high.is_finite() {
                ends.push(distance(high, Number::MINUS_ONE));
            }
            let negative_power =
                args.get(1).and_then(|exponent| graph.as_number(*exponent)).is_some_and(Number::is_negative);
            let open =
                matches!(function, Function::Ln | Function::Log2 | Function::Log10 | Function::Ln1p | Function::Atanh);
            let sign = if open || negative_power { Sign::NotPositive } else { Sign::Negative };
            ends.into_iter().map(|argument| Check::new(argument, sign, message.clone(), args[0])).collect()
        }
        _ => vec![],
    }
}

/// Returns the conditions under which a node has a value, but no second derivative.
pub(super) fn edges_of(graph: &mut Graph, id: Id) -> Vec<Check> {
    let rough = |check: Check| Check {
        forbidden: Sign::NotPositive,
        message: "a derivative that is not a number".into(),
        term: id,
        ..check
    };
    match graph.node(id) {
        Node::Power(base, exponent)
            if !exponent.is_integer() && exponent.numerator > 0 && exponent.numerator < 2 * exponent.denominator =>
        {
            vec![rough(Check::new(*base, Sign::NotPositive, "", id))]
        }
        Node::Call(..) => {
            checks_of(graph, id).into_iter().filter(|check| check.forbidden == Sign::Negative).map(rough).collect()
        }
        _ => vec![],
    }
}
