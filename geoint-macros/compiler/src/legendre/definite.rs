//! Proves that a mass matrix is positive definite at every state: L is a sum of squares of velocities, and all squares vanish at rest only.

use super::{idle_coordinates::without_idle_coordinates, is_velocity};
use crate::analyze::Degrees;
use crate::diff;
use crate::ir::{Graph, Id, Node, Ratio, Symbol};

/// Conditions on functions of parameters under which a mass matrix is positive definite at every state.
#[derive(Debug, Default)]
pub(crate) struct Definite {
    /// These functions must not be negative.
    pub(crate) not_negative: Vec<Id>,
    /// These functions must be positive.
    pub(crate) positive: Vec<Id>,
}

/// The square of an affine function of velocities. The product of `factors` is its coefficient, up to a positive number.
struct Square {
    factors: Vec<Id>,
    base: Id,
}

/// A Lagrangian as a sum of squares.
struct Squares<'a> {
    graph: &'a Graph,
    /// Degrees in the velocities.
    degrees: Degrees,
    squares: Vec<Square>,
    /// Coefficients of squares whose sign depends on parameters.
    weights: Vec<Id>,
}

/// Returns the conditions under which ∂²L/∂v² is positive definite at every state. `None` without a proof.
pub(crate) fn definite(graph: &mut Graph, lagrangian: Id, degrees: u32) -> Option<Definite> {
    let known = Degrees::of(graph, &[lagrangian], is_velocity);
    let mut sum = Squares { graph, degrees: known, squares: vec![], weights: vec![] };
    if !sum.add(lagrangian, &[]) {
        return None;
    }
    let Squares { squares, weights: not_negative, .. } = sum;
    let positive = only_at_rest(graph, &squares, degrees)?;
    Some(Definite { not_negative, positive })
}

impl Squares<'_> {
    /// Adds the squares of `id`, multiplied by `factors`. Affine functions of velocities are skipped. Returns whether nothing else remains.
    fn add(&mut self, id: Id, factors: &[Id]) -> bool {
        if self.is_affine(id) {
            return true;
        }
        match self.graph.node(id) {
            Node::Linear(_, terms) => {
                terms.iter().all(|(c, term)| self.is_affine(*term) || (!c.is_negative() && self.add(*term, factors)))
            }
            Node::Product(all) => {
                let (still, moving): (Vec<Id>, Vec<Id>) =
                    all.iter().partition(|factor| self.degrees.get(**factor) == Some(0));
                still.iter().all(|factor| self.add_weight(*factor))
                    && matches!(moving[..], [moving] if self.add(moving, &[factors, &still].concat()))
            }
            Node::Power(base, exponent) if *exponent == Ratio::integer(2) && self.is_affine(*base) => {
                self.squares.push(Square { factors: factors.to_vec(), base: *base });
                true
            }
            _ => false,
        }
    }

    fn is_affine(&self, id: Id) -> bool {
        self.degrees.get(id).is_some_and(|degree| degree <= 1)
    }

    /// Adds a factor without velocities to the weights, unless it is an even power. Returns false if the factor is neither an even power nor a
    /// function of parameters.
    fn add_weight(&mut self, factor: Id) -> bool {
        if let Node::Power(_, exponent) = self.graph.node(factor)
            && exponent.is_integer()
            && exponent.numerator % 2 == 0
        {
            return true;
        }
        let still = !self.graph.reads(factor).moves();
        if still && !self.weights.contains(&factor) {
            self.weights.push(factor);
        }
        still
    }
}

/// Returns functions of parameters that must be positive so that all squares vanish at rest only.
///
/// Velocities are eliminated one after the other. If the earlier velocities are zero, some squares read the next velocity only, and its coefficients
/// in these squares do not vanish together. Hence the next velocity is zero.
fn only_at_rest(graph: &mut Graph, squares: &[Square], degrees: u32) -> Option<Vec<Id>> {
    let velocities: Vec<Symbol> = (0..degrees).map(Symbol::Velocity).collect();
    let bases: Vec<Id> = squares.iter().map(|square| square.base).collect();
    let slopes = diff::jacobian(graph, &bases, &velocities);
    let (mut left, mut positive): (Vec<usize>, Vec<Id>) = ((0..velocities.len()).collect(), vec![]);
    while !left.is_empty() {
        let place = left.iter().position(|j| {
            let condition = vanishes_alone(graph, squares, &slopes, &left, *j);
            positive.extend(condition);
            condition.is_some()
        })?;
        left.remove(place);
    }
    Some(positive)
}

/// Returns a function of parameters. If it is positive, velocity `j` is zero wherever the squares vanish that read `j` but no other velocity of
/// `left`.
fn vanishes_alone(graph: &mut Graph, squares: &[Square], slopes: &[Vec<Id>], left: &[usize], j: usize) -> Option<Id> {
    // Each coefficient of the velocity is a pair of factors: the first reads parameters only.
    let mut terms = vec![];
    for (square, slopes) in squares.iter().zip(slopes) {
        if left.iter().all(|i| (*i == j) != graph.is_zero(slopes[*i])) {
            let slope = graph.pow(slopes[j], Ratio::integer(2));
            let (still, mut moving): (Vec<Id>, Vec<Id>) =
                square.factors.iter().partition(|factor| !graph.reads(**factor).moves());
            moving.push(slope);
            terms.push((graph.product(&still), graph.product(&moving)));
        }
    }
    let products: Vec<Id> = terms.iter().map(|(still, moving)| graph.mul(*still, *moving)).collect();
    let sum = graph.sum(&products);
    let sum = without_idle_coordinates(graph, sum);
    let condition = if !graph.reads(sum).moves() {
        Some(sum)
    } else {
        terms.iter().find(|(_, moving)| graph.is_positive(*moving)).map(|(still, _)| *still)
    };
    condition.filter(|condition| !graph.is_zero(*condition))
}
