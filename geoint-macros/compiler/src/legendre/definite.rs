//! Is a Lagrangian a sum of squares of velocities, and do all of them vanish only at rest? Then its mass matrix is positive definite, wherever
//! it is.

use super::invariant;
use super::mass::is_velocity;
use crate::analyze::Degrees;
use crate::diff;
use crate::ir::{Graph, Id, Node, Ratio, Symbol};

/// What parameters must be for a mass matrix to be positive definite at every state.
#[derive(Debug, Default)]
pub(crate) struct Definite {
    /// Functions of them that are not negative,
    pub(crate) not_negative: Vec<Id>,
    /// and those that are positive.
    pub(crate) positive: Vec<Id>,
}

/// The square of something affine in velocities, and what it is multiplied by but for a positive number.
struct Square {
    factors: Vec<Id>,
    base: Id,
}

/// When ∂²L/∂v² is positive definite at every state; `None` if that is not seen.
pub(crate) fn definite(graph: &mut Graph, lagrangian: Id, degrees: u32) -> Option<Definite> {
    let mut definite = Definite::default();
    let mut squares = vec![];
    let known = Degrees::of(graph, &[lagrangian], is_velocity);
    if !is_sum(graph, &known, (lagrangian, &[]), (&mut definite.not_negative, &mut squares)) {
        return None;
    }
    definite.positive = only_at_rest(graph, &squares, degrees)?;
    Some(definite)
}

/// Whether a node is a sum of squares, and of what is affine in velocities itself.
fn is_sum(
    graph: &Graph,
    degrees: &Degrees,
    (id, factors): (Id, &[Id]),
    (weights, squares): (&mut Vec<Id>, &mut Vec<Square>),
) -> bool {
    let affine = |id: Id| degrees.get(id).is_some_and(|degree| degree <= 1);
    if affine(id) {
        return true;
    }
    match graph.node(id).clone() {
        Node::Linear(_, terms) => terms.into_iter().all(|(c, term)| {
            affine(term) || (!c.is_negative() && is_sum(graph, degrees, (term, factors), (weights, squares)))
        }),
        Node::Product(all) => {
            let (still, moving): (Vec<Id>, Vec<Id>) =
                all.into_iter().partition(|factor| degrees.get(*factor) == Some(0));
            still.iter().all(|factor| is_weight(graph, *factor, weights))
                && moving.len() == 1
                && is_sum(graph, degrees, (moving[0], &[factors, &still].concat()), (weights, squares))
        }
        Node::Power(base, exponent) if exponent == Ratio::integer(2) && affine(base) => {
            squares.push(Square { factors: factors.to_vec(), base });
            true
        }
        _ => false,
    }
}

/// Whether a factor without velocities is never negative, or is a function of parameters whose sign can be looked at.
fn is_weight(graph: &Graph, factor: Id, weights: &mut Vec<Id>) -> bool {
    if let Node::Power(_, exponent) = graph.node(factor)
        && exponent.is_integer()
        && exponent.numerator % 2 == 0
    {
        return true;
    }
    let still = !graph.reads(factor).moves();
    if still && !weights.contains(&factor) {
        weights.push(factor);
    }
    still
}

/// What must be positive for all squares to vanish at rest alone, one velocity after the other: where those before it are zero, some squares
/// have no velocity but the next one, and its coefficients in these do not vanish together.
fn only_at_rest(graph: &mut Graph, squares: &[Square], degrees: u32) -> Option<Vec<Id>> {
    let velocities: Vec<Symbol> = (0..degrees).map(Symbol::Velocity).collect();
    let bases: Vec<Id> = squares.iter().map(|square| square.base).collect();
    let slopes = diff::jacobian(graph, &bases, &velocities);
    let (mut left, mut positive): (Vec<usize>, Vec<Id>) = ((0..velocities.len()).collect(), vec![]);
    while !left.is_empty() {
        let place = left.iter().position(|j| {
            let alone = |graph: &Graph, slopes: &[Id]| left.iter().all(|i| (i == j) != graph.is_zero(slopes[*i]));
            let mut terms = vec![];
            for (square, slopes) in squares.iter().zip(&slopes) {
                if !alone(graph, slopes) {
                    continue;
                }
                let slope = graph.pow(slopes[*j], Ratio::integer(2));
                let (still, mut moving): (Vec<Id>, Vec<Id>) =
                    square.factors.iter().partition(|factor| !graph.reads(**factor).moves());
                moving.push(slope);
                terms.push((graph.product(&still), graph.product(&moving)));
            }
            let products: Vec<Id> = terms.iter().map(|(still, moving)| graph.mul(*still, *moving)).collect();
            let sum = graph.sum(&products);
            let sum = invariant::simplified(graph, sum);
            let condition = if !graph.reads(sum).moves() {
                Some(sum)
            } else {
                let one = terms.iter().find(|(_, moving)| graph.is_positive(*moving));
                one.map(|(still, _)| *still)
            };
            let condition = condition.filter(|condition| !graph.is_zero(*condition));
            positive.extend(condition);
            condition.is_some()
        })?;
        left.remove(place);
    }
    Some(positive)
}
