//! What conserved functions of the state are made of, and what people call these.

use super::weights::Weight;
use crate::analyze::quadratic::{UNIT, Variable};
use crate::ir::{Graph, Id, Number, Ratio, Symbol};
use crate::parse::{Leaf, Shape};

/// A linear or quadratic function of the state.
pub(super) struct Generator {
    kind: Kind,
    /// Σ coefficient·(product of two variables).
    pub(super) terms: Vec<(i128, [Variable; 2])>,
}

/// What comes first gives a sum of several its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// x p_y − y p_x of a point in the plane or in space, about an axis.
    Angular(usize),
    /// q² or p² of a coordinate.
    Square,
    /// p of a coordinate, along an axis.
    Momentum(usize),
    Position,
}

/// An axis, and the two coordinates that a rotation about it mixes.
const AXES: [(&str, [u32; 2]); 3] = [("x", [1, 2]), ("y", [2, 0]), ("z", [0, 1])];

/// All of them, in order of their kinds.
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
    // With one degree of freedom all that is conserved is a function of H.
    let several = if n > 1 { 0..n } else { 0..0 };
    let squares = several.flat_map(|i| [q(i), p(i)]).map(|x| (Kind::Square, vec![(1, [x, x])]));
    let momenta = (0..n).map(|i| (Kind::Momentum(i as usize % dimension), vec![(1, [p(i), UNIT])]));
    let positions = (0..n).map(|i| (Kind::Position, vec![(1, [q(i), UNIT])]));
    let all = angular.chain(squares).chain(momenta).chain(positions);
    all.map(|(kind, terms)| Generator { kind, terms }).collect()
}

/// The dimension of the points that an array holds, or that it is.
fn dimension(coordinates: &Shape) -> usize {
    coordinates.extents.last().map_or(1, |extent| (*extent).max(1))
}

/// A generator with a number and a product of parameters before it.
pub(super) struct Summand<'a> {
    pub(super) generator: &'a Generator,
    pub(super) number: Ratio,
    pub(super) weight: &'a Weight,
}

/// The name of a sum.
pub(super) fn name(coordinates: &Shape, summands: &[Summand<'_>]) -> String {
    let (n, dimension) = (coordinates.len(), dimension(coordinates));
    let total = summands.iter().all(|summand| summand.number == Ratio::ONE && summand.weight.is_empty());
    let order = |kind: &Kind| match kind {
        Kind::Angular(_) => 0,
        Kind::Square => 1,
        Kind::Momentum(_) => 2,
        Kind::Position => 3,
    };
    let kinds = summands.iter().map(|summand| summand.generator.kind);
    let kind = kinds.min_by_key(order).unwrap_or(Kind::Position);
    let alike = summands.iter().all(|summand| summand.generator.kind == kind);
    let axis = |axis: usize| AXES.get(axis).map(|(axis, _)| *axis);
    match kind {
        Kind::Angular(i) if alike && dimension == 3 => format!("angular momentum about {}", AXES[i].0),
        Kind::Angular(_) => "angular momentum".into(),
        Kind::Square if total && alike && summands.len().is_multiple_of(2) => "norm".into(),
        Kind::Square => "sum of squares".into(),
        Kind::Momentum(i) if total && alike && summands.len() == n / dimension => match axis(i) {
            Some(axis) => format!("total momentum along {axis}"),
            None => "total momentum".into(),
        },
        // The entries of a plain array may be points of a line.
        Kind::Momentum(_) if total && summands.len() == n && coordinates.leaf != Leaf::Vector => {
            "total momentum".into()
        }
        Kind::Momentum(_) => "momentum".into(),
        Kind::Position => "position".into(),
    }
}

impl Generator {
    /// The coordinate that it is.
    pub(super) fn coordinate(&self) -> Option<Variable> {
        matches!(self.kind, Kind::Momentum(_) | Kind::Position).then(|| self.terms[0].1[0])
    }

    /// Whether it moves positions by a rotation or a translation, and velocities as a rotation does.
    pub(super) fn is_rigid(&self) -> bool {
        matches!(self.kind, Kind::Angular(_) | Kind::Momentum(_))
    }

    /// Whether it moves positions alone.
    pub(super) fn is_translation(&self) -> bool {
        matches!(self.kind, Kind::Momentum(_))
    }

    /// Whether it reads no others than these variables.
    pub(super) fn is_function_of(&self, variables: &[Variable]) -> bool {
        self.terms.iter().all(|(_, pair)| pair.iter().all(|x| *x == UNIT || variables.contains(x)))
    }

    /// sum + number·weight·generator.
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
