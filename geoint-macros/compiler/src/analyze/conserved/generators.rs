//! The generators of conserved functions of the state, and the names of their sums.

use super::weights::Weight;
use crate::analyze::quadratic::{UNIT, Variable};
use crate::ir::{Graph, Id, Number, Ratio, Symbol};
use crate::parse::{Leaf, Shape};

/// A linear or quadratic function of the state.
pub(super) struct Generator {
    kind: Kind,
    /// The function Σ coefficient·(product of two variables).
    pub(super) terms: Vec<(i128, [Variable; 2])>,
}

/// The kind of a generator. The first kind in a sum decides the name of the sum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    /// The angular momentum x p_y − y p_x of a point about an axis.
    Angular(usize),
    /// q² or p².
    Square,
    /// p of a coordinate along an axis.
    Momentum(usize),
    /// q.
    Position,
}

/// The axes, each with the two coordinates that a rotation about it mixes.
const AXES: [(&str, [u32; 2]); 3] = [("x", [1, 2]), ("y", [2, 0]), ("z", [0, 1])];

/// Returns all generators in order of their kinds.
pub(super) fn generators(coordinates: &Shape) -> Vec<Generator> {
    let (n, dimension) = (coordinates.len() as u32, dimension(coordinates));
    let (q, p) = (|i: u32| 2 * i, |i: u32| 2 * i + 1);
    let rotations = match dimension {
        2 => 2..3,
        3 => 0..3,
        _ => 0..0,
    };
    let angular = rotations.flat_map(|axis| {
        (0..n).step_by(dimension).map(move |point| {
            let [x, y] = AXES[axis].1.map(|offset| point + offset);
            (Kind::Angular(axis), vec![(1, [q(x), p(y)]), (-1, [q(y), p(x)])])
        })
    });
    // With one degree of freedom, every conserved function is a function of H.
    let several = if n > 1 { 0..n } else { 0..0 };
    let squares = several.flat_map(|i| [q(i), p(i)]).map(|x| (Kind::Square, vec![(1, [x, x])]));
    let momenta = (0..n).map(|i| (Kind::Momentum(i as usize % dimension), vec![(1, [p(i), UNIT])]));
    let positions = (0..n).map(|i| (Kind::Position, vec![(1, [q(i), UNIT])]));
    let all = angular.chain(squares).chain(momenta).chain(positions);
    all.map(|(kind, terms)| Generator { kind, terms }).collect()
}

/// Returns the dimension of the points in an array of coordinates.
fn dimension(coordinates: &Shape) -> usize {
    coordinates.extents.last().map_or(1, |extent| (*extent).max(1))
}

/// A generator with its coefficients: a number and a product of parameters.
pub(super) struct Summand<'a> {
    pub(super) generator: &'a Generator,
    pub(super) number: Ratio,
    pub(super) weight: &'a Weight,
}

/// Returns the usual name of a sum.
pub(super) fn name(coordinates: &Shape, summands: &[Summand<'_>]) -> String {
    let (n, dimension) = (coordinates.len(), dimension(coordinates));
    let total = summands.iter().all(|summand| summand.number == Ratio::ONE && summand.weight.is_empty());
    let kind = summands.iter().map(|summand| summand.generator.kind).min().unwrap_or(Kind::Position);
    let alike = summands.iter().all(|summand| summand.generator.kind == kind);
    match kind {
        Kind::Angular(i) if alike && dimension == 3 => format!("angular momentum about {}", AXES[i].0),
        Kind::Angular(_) => "angular momentum".into(),
        Kind::Square if total && alike && summands.len().is_multiple_of(2) => "norm".into(),
        Kind::Square => "sum of squares".into(),
        Kind::Momentum(i) if total && alike && summands.len() == n / dimension => match AXES.get(i) {
            Some((axis, _)) => format!("total momentum along {axis}"),
            None => "total momentum".into(),
        },
        // The entries of a plain array may be points on a line.
        Kind::Momentum(_) if total && summands.len() == n && coordinates.leaf != Leaf::Vector => {
            "total momentum".into()
        }
        Kind::Momentum(_) => "momentum".into(),
        Kind::Position => "position".into(),
    }
}

impl Generator {
    /// Returns the variable, if the generator is a single coordinate.
    pub(super) fn coordinate(&self) -> Option<Variable> {
        matches!(self.kind, Kind::Momentum(_) | Kind::Position).then(|| self.terms[0].1[0])
    }

    /// Returns whether the generator rotates or translates positions, and transforms velocities by the same rotation.
    pub(super) fn is_rigid(&self) -> bool {
        matches!(self.kind, Kind::Angular(_) | Kind::Momentum(_))
    }

    /// Returns whether the generator translates positions.
    pub(super) fn is_translation(&self) -> bool {
        matches!(self.kind, Kind::Momentum(_))
    }

    /// Returns whether the generator reads only these variables.
    pub(super) fn is_function_of(&self, variables: &[Variable]) -> bool {
        self.terms.iter().all(|(_, pair)| pair.iter().all(|x| *x == UNIT || variables.contains(x)))
    }

    /// Builds sum + number·weight·generator.
    pub(super) fn add_to(&self, graph: &mut Graph, mut sum: Id, number: Ratio, weight: Id) -> Id {
        for (c, variables) in &self.terms {
            let factors = variables.iter().filter_map(|variable| match variable % 2 {
                _ if *variable == UNIT => None,
                0 => Some(graph.symbol(Symbol::Position(variable / 2))),
                _ => Some(graph.symbol(Symbol::Momentum(variable / 2))),
            });
            let factors: Vec<Id> = factors.collect();
            let product = graph.product(&factors);
            let product = graph.mul(weight, product);
            let term = graph.scale(Number::Exact(number).mul(Number::integer(*c)), product);
            sum = graph.add(sum, term);
        }
        sum
    }
}
