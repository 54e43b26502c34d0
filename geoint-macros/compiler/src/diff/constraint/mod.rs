//! The equations of steps with constraints g(q) = 0, whose multipliers are unknowns beside increments.
//!
//! A multiplier ν is that of positions: Gᵀν/h is added to momenta on the way, W Gᵀν to positions with W = ∂²H/∂p² for a constant mass
//! matrix. A row g(q₁) is divided by the entry of G W Gᵀ on the diagonal: then it has the unit of its multiplier, and the determinant of
//! the iteration is positive near h = 0.

mod steps;

use super::forward::jacobian;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};
pub(crate) use steps::{gradient, rattle};

/// What is known of a system with constraints.
pub(crate) struct Given<'a> {
    pub(crate) constraints: &'a [Id],
    /// G, a row a constraint.
    pub(crate) gradients: Vec<Vec<Id>>,
    /// ∂H/∂p.
    pub(crate) velocity: &'a [Id],
    /// W.
    pub(crate) inverse_mass: Vec<Vec<Id>>,
    /// p' without multipliers, at a point and between two.
    pub(crate) force: &'a [Id],
    pub(crate) mean_force: &'a [Id],
    /// q' between two points; nothing if the mass matrix is constant and nothing is damped: positions then follow from momenta.
    pub(crate) mean_velocity: Option<&'a [Id]>,
}

/// The equation of a step.
pub(crate) struct Equation {
    pub(crate) unknowns: Vec<Symbol>,
    pub(crate) residual: Vec<Id>,
    /// What a solution adds to positions and momenta.
    pub(crate) end: Vec<Id>,
    /// How large a number is whose rounding an unknown has.
    pub(crate) origin: Vec<Id>,
}

impl<'a> Given<'a> {
    pub(crate) fn new(
        graph: &mut Graph,
        constraints: &'a [Id],
        velocity: &'a [Id],
        [force, mean_force]: [&'a [Id]; 2],
        mean_velocity: Option<&'a [Id]>,
    ) -> Given<'a> {
        let degrees = velocity.len() as u32;
        let [positions, momenta]: [Vec<Symbol>; 2] =
            [Symbol::Position, Symbol::Momentum].map(|symbol: fn(u32) -> Symbol| (0..degrees).map(symbol).collect());
        let gradients = jacobian(graph, constraints, &positions);
        let inverse_mass = jacobian(graph, velocity, &momenta);
        Given { constraints, gradients, velocity, inverse_mass, force, mean_force, mean_velocity }
    }

    fn degrees(&self) -> usize {
        self.velocity.len()
    }

    /// G ∂H/∂p.
    pub(crate) fn rates(&self, graph: &mut Graph) -> Vec<Id> {
        self.gradients.iter().map(|gradient| graph.dot(gradient, self.velocity)).collect()
    }

    /// The diagonal of G W Gᵀ.
    fn units(&self, graph: &mut Graph) -> Vec<Id> {
        let mut units = vec![];
        for gradient in &self.gradients {
            let direction = self.along(graph, gradient);
            units.push(graph.dot(gradient, &direction));
        }
        units
    }

    /// What the rounding of coordinates that constraints bind to each other moves each constraint by, in units of ε: a coordinate that stays
    /// zero has the rounding of those that it is solved for with. Lengths are those of the kinetic energy, which are of one unit.
    pub(crate) fn sizes(&self, graph: &mut Graph) -> Vec<Id> {
        let units = self.units(graph);
        let bound = self.bound_together(graph);
        let mut sizes = vec![];
        for (unit, bound) in units.into_iter().zip(bound) {
            let mut lengths = vec![];
            for i in bound {
                let q = graph.symbol(Symbol::Position(i as u32));
                let square = graph.pow(q, Ratio::integer(2));
                let length = graph.div(square, self.inverse_mass[i][i]);
                lengths.push(graph.call(Function::Abs, &[length]));
            }
            let (length, unit) = (graph.sum(&lengths), graph.call(Function::Abs, &[unit]));
            let square = graph.mul(length, unit);
            sizes.push(graph.sqrt(square));
        }
        sizes
    }

    /// The coordinates with inertia that each constraint reads, or others that share one with it.
    fn bound_together(&self, graph: &Graph) -> Vec<Vec<usize>> {
        let n = self.degrees();
        let own = |gradient: &Vec<Id>| (0..n).filter(|i| !graph.is_zero(gradient[*i])).collect::<Vec<_>>();
        let mut all: Vec<Vec<usize>> = self.gradients.iter().map(own).collect();
        for _ in 0..all.len() {
            for k in 0..all.len() {
                let shares = |other: &&Vec<usize>| other.iter().any(|i| all[k].contains(i));
                let mut joined = all.iter().filter(shares).cloned().collect::<Vec<_>>().concat();
                joined.sort_unstable();
                joined.dedup();
                all[k] = joined;
            }
        }
        let heavy = |i: &usize| !graph.is_zero(self.inverse_mass[*i][*i]);
        all.into_iter().map(|bound| bound.into_iter().filter(heavy).collect()).collect()
    }

    /// W x.
    fn along(&self, graph: &mut Graph, x: &[Id]) -> Vec<Id> {
        self.inverse_mass.iter().map(|row| graph.dot(row, x)).collect()
    }

    /// g(q₁) in units of multipliers.
    fn bound(&self, graph: &mut Graph, end: &[Id]) -> Vec<Id> {
        let units = self.units(graph);
        let mut there = Substitution::new(|_: &mut Graph, symbol| match symbol {
            Symbol::Position(i) => Some(end[i as usize]),
            _ => None,
        });
        let mut row = |(constraint, unit): (&Id, &Id)| {
            let value = there.apply(graph, *constraint);
            graph.div(value, *unit)
        };
        self.constraints.iter().zip(&units).map(&mut row).collect()
    }

    /// A multiplier has the rounding of positions, a position that of multipliers as well, and a momentum that of `pull` times Gᵀν/h.
    fn origin(&self, graph: &mut Graph, unknowns: &[Symbol], pull: Number) -> Vec<Id> {
        let units = self.units(graph);
        let mut multipliers = vec![];
        for (gradient, unit) in self.gradients.iter().zip(&units) {
            let mut terms = vec![];
            for (i, slope) in (0..).zip(gradient) {
                let q = graph.symbol(Symbol::Position(i));
                let term = graph.mul(*slope, q);
                terms.push(graph.call(Function::Abs, &[term]));
            }
            let (size, unit) = (graph.sum(&terms), graph.call(Function::Abs, &[*unit]));
            multipliers.push(graph.div(size, unit));
        }
        let h = graph.symbol(Symbol::StepLength);
        let h = graph.call(Function::Abs, &[h]);
        let weight = graph.recip(h);
        let weight = graph.scale(pull, weight);
        let directions: Vec<Vec<Id>> = self.gradients.iter().map(|gradient| self.along(graph, gradient)).collect();
        let mut size = |symbol: &Symbol| {
            let (own, weights, weight, i) = match symbol {
                Symbol::Multiplier(k) => return multipliers[*k as usize],
                Symbol::PositionIncrement(i) => (Symbol::Position(*i), &directions, graph.integer(1), *i),
                Symbol::MomentumIncrement(i) => (Symbol::Momentum(*i), &self.gradients, weight, *i),
                other => return graph.symbol(*other),
            };
            let own = graph.symbol(own);
            let mut terms = vec![graph.call(Function::Abs, &[own])];
            for (row, multiplier) in weights.iter().zip(&multipliers) {
                let slope = graph.call(Function::Abs, &[row[i as usize]]);
                terms.push(graph.product(&[weight, slope, *multiplier]));
            }
            graph.sum(&terms)
        };
        unknowns.iter().map(&mut size).collect()
    }
}

/// Coordinates after increments.
fn ends(graph: &mut Graph, coordinate: fn(u32) -> Symbol, increments: &[Id]) -> Vec<Id> {
    let mut end = |(i, increment): (u32, &Id)| {
        let start = graph.symbol(coordinate(i));
        graph.add(start, *increment)
    };
    (0..).zip(increments).map(&mut end).collect()
}

/// Nodes at other positions, perhaps other momenta, and another time.
fn moved(graph: &mut Graph, nodes: &[Id], (positions, momenta): (&[Id], Option<&[Id]>), time: Id) -> Vec<Id> {
    let mut there = Substitution::new(|_: &mut Graph, symbol| match symbol {
        Symbol::Position(i) => Some(positions[i as usize]),
        Symbol::Momentum(i) => momenta.map(|momenta| momenta[i as usize]),
        Symbol::Time => Some(time),
        _ => None,
    });
    nodes.iter().map(|node| there.apply(graph, *node)).collect()
}

fn sums(graph: &mut Graph, a: &[Id], b: &[Id]) -> Vec<Id> {
    a.iter().zip(b).map(|(a, b)| graph.add(*a, *b)).collect()
}
