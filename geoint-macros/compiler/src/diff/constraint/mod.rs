//! The equations of steps with constraints A v + b = 0. Their unknowns are increments and multipliers for each [`Row`] of A.
//!
//! A multiplier μ adds Aᵀμ/h to the momenta, and W Aᵀμ to the positions if W = ∂²H/∂p² is constant. Its row is divided by the diagonal entry of A W Aᵀ. The
//! row then has the unit of its multiplier, and the determinant of the iteration is positive near h = 0.

mod action;
mod elimination;
mod eliminated;
mod rows;
mod steps;
mod tangent;
mod vectors;

use super::equations::times;
use super::forward::jacobian;
use crate::ir::formula::{call, pow, squared};
use crate::ir::{Function, Graph, Id, Ratio, Symbol};
pub(crate) use action::{Action, Damping};
pub(crate) use rows::Row;
use std::collections::BTreeSet;
pub(crate) use steps::{Momenta, discrete_gradient_step, rattle};

/// A system with constraints, and derivatives of it.
pub(crate) struct Constrained<'a> {
    pub(crate) rows: &'a [Row],
    /// ∂H/∂p.
    pub(crate) velocity: &'a [Id],
    /// W = ∂²H/∂p².
    pub(crate) inverse_mass: Vec<Vec<Id>>,
    /// p' without multipliers at a point.
    pub(crate) force: &'a [Id],
    /// p' without multipliers between two points.
    pub(crate) mean_force: &'a [Id],
    /// q' between two points. Absent if H = T(p) + V(q), the mass matrix is constant, and nothing is damped: momenta then
    /// determine positions.
    pub(crate) mean_velocity: Option<&'a [Id]>,
    /// The friction of an energy with an action. The rates above are those of the energy without it.
    pub(crate) action: Option<Action>,
}

/// The equation of a step, residual = 0.
#[derive(Clone, Debug)]
pub(crate) struct Equation {
    pub(crate) unknowns: Vec<Symbol>,
    pub(crate) residual: Vec<Id>,
    /// The increments of positions and momenta at a solution.
    pub(crate) end: Vec<Id>,
    /// The increment of the action, if there is one.
    pub(crate) action: Option<Id>,
    /// For every unknown a number of the size whose rounding error the unknown has.
    pub(crate) origin: Vec<Id>,
}

impl<'a> Constrained<'a> {
    /// Adds the derivatives of the velocity.
    pub(crate) fn new(
        graph: &mut Graph,
        rows: &'a [Row],
        velocity: &'a [Id],
        force: &'a [Id],
        mean_force: &'a [Id],
        mean_velocity: Option<&'a [Id]>,
    ) -> Constrained<'a> {
        let momenta: Vec<Symbol> = (0..velocity.len() as u32).map(Symbol::Momentum).collect();
        let inverse_mass = jacobian(graph, velocity, &momenta);
        Constrained { rows, velocity, inverse_mass, force, mean_force, mean_velocity, action: None }
    }

    fn degrees(&self) -> usize {
        self.velocity.len()
    }

    /// A, with one row for each constraint.
    pub(crate) fn gradients(&self) -> Vec<Vec<Id>> {
        self.rows.iter().map(|row| row.gradient.clone()).collect()
    }

    /// A ∂H/∂p + b.
    pub(crate) fn rates(&self, graph: &mut Graph) -> Vec<Id> {
        self.rows.iter().map(|row| row.rate(graph, self.velocity)).collect()
    }

    /// A W Aᵀ.
    fn inertia(&self, graph: &mut Graph) -> Vec<Vec<Id>> {
        let mut inertia = vec![];
        for row in self.rows {
            let direction = self.along(graph, &row.gradient);
            inertia.push(self.rows.iter().map(|other| graph.dot(&other.gradient, &direction)).collect());
        }
        inertia
    }

    /// The diagonal of A W Aᵀ.
    fn units(&self, graph: &mut Graph) -> Vec<Id> {
        let mut units = vec![];
        for row in self.rows {
            let direction = self.along(graph, &row.gradient);
            units.push(graph.dot(&row.gradient, &direction));
        }
        units
    }

    /// The change of each constraint by rounding errors of the coordinates that it couples, in units of ε.
    ///
    /// A coordinate near zero has the rounding error of the coordinates that are solved for with it. The kinetic energy measures lengths, which gives
    /// all coordinates one unit.
    pub(crate) fn sizes(&self, graph: &mut Graph) -> Vec<Id> {
        let units = self.units(graph);
        let mut sizes = vec![];
        for (unit, coupled) in units.into_iter().zip(self.coupled_coordinates(graph)) {
            let mut lengths = vec![];
            for i in coupled {
                let q = graph.symbol(Symbol::Position(i as u32));
                lengths.push(graph.build(call(Function::Abs, [squared(q) / self.inverse_mass[i][i]])));
            }
            let length = graph.sum(&lengths);
            sizes.push(graph.build(pow(length * call(Function::Abs, [unit]), Ratio::HALF)));
        }
        sizes
    }

    /// Returns for each constraint the coordinates with inertia that it couples. These are its own, and those of every constraint that shares a coordinate with
    /// it or with another coupled one.
    fn coupled_coordinates(&self, graph: &Graph) -> Vec<Vec<usize>> {
        let n = self.degrees();
        let own = |row: &Row| (0..n).filter(|i| !graph.is_zero(row.gradient[*i])).collect();
        let mut all: Vec<BTreeSet<usize>> = self.rows.iter().map(own).collect();
        for _ in 0..all.len() {
            for k in 0..all.len() {
                all[k] = all.iter().filter(|other| !other.is_disjoint(&all[k])).flatten().copied().collect();
            }
        }
        let has_inertia = |i: &usize| !graph.is_zero(self.inverse_mass[*i][*i]);
        all.into_iter().map(|coupled| coupled.into_iter().filter(has_inertia).collect()).collect()
    }

    /// W x.
    fn along(&self, graph: &mut Graph, x: &[Id]) -> Vec<Id> {
        times(graph, &self.inverse_mass, x)
    }

    /// Divides the conditions of all rows by their units.
    fn in_units(&self, graph: &mut Graph, conditions: &[Id]) -> Vec<Id> {
        let units = self.units(graph);
        conditions.iter().zip(&units).map(|(condition, unit)| graph.div(*condition, *unit)).collect()
    }

    /// The rounding of positions in each multiplier: Σ |Aᵢqᵢ| in its unit.
    fn rounding_of_multipliers(&self, graph: &mut Graph) -> Vec<Id> {
        let units = self.units(graph);
        let mut sizes = vec![];
        for (row, unit) in self.rows.iter().zip(&units) {
            let q: Vec<Id> = (0..self.degrees() as u32).map(|i| graph.symbol(Symbol::Position(i))).collect();
            let size = sum_of_magnitudes(graph, &row.gradient, &q);
            sizes.push(graph.build(size / call(Function::Abs, [*unit])));
        }
        sizes
    }

    /// The origins of increments, see [`Equation`]. A position adds the error of W Aᵀμ to its own, and a momentum adds the error of Aᵀμ·`weight`. `multipliers`
    /// are the origins of μ.
    fn origins_of_increments(
        &self,
        graph: &mut Graph,
        increments: &[Symbol],
        multipliers: &[Id],
        weight: Id,
    ) -> Vec<Id> {
        let directions: Vec<Vec<Id>> = self.rows.iter().map(|row| self.along(graph, &row.gradient)).collect();
        let gradients = self.gradients();
        let one = graph.integer(1);
        let mut size = |symbol: &Symbol| {
            let (own, rows, weight, i) = match symbol {
                Symbol::PositionIncrement(i) => (Symbol::Position(*i), &directions, one, *i),
                Symbol::MomentumIncrement(i) => (Symbol::Momentum(*i), &gradients, weight, *i),
                other => return graph.symbol(*other),
            };
            let own = graph.symbol(own);
            let mut terms = vec![graph.call(Function::Abs, &[own])];
            for (row, multiplier) in rows.iter().zip(multipliers) {
                terms.push(graph.build(weight * call(Function::Abs, [row[i as usize]]) * *multiplier));
            }
            graph.sum(&terms)
        };
        increments.iter().map(&mut size).collect()
    }
}

/// Σ |aᵢ xᵢ|.
fn sum_of_magnitudes(graph: &mut Graph, a: &[Id], x: &[Id]) -> Id {
    let terms: Vec<Id> = a.iter().zip(x).map(|(a, x)| graph.build(call(Function::Abs, [*a * *x]))).collect();
    graph.sum(&terms)
}
