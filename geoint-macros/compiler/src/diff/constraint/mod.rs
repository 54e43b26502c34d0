//! The equations of steps with constraints g(q) = 0. Their unknowns are increments and one multiplier ν for each constraint.
//!
//! With G = ∂g/∂q, a multiplier adds Gᵀν/h to the momenta, and W Gᵀν to the positions if W = ∂²H/∂p² is constant. The row of g(q₁) is divided by the
//! diagonal entry of G W Gᵀ. The row then has the unit of its multiplier, and the determinant of the iteration is positive near h = 0.

mod steps;

use super::equations::times;
use super::forward::jacobian;
use super::gradient::with_values;
use crate::ir::formula::{call, pow, squared};
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};
use std::collections::BTreeSet;
pub(crate) use steps::{discrete_gradient_step, rattle};

/// A system with constraints, and derivatives of it.
pub(crate) struct Constrained<'a> {
    pub(crate) constraints: &'a [Id],
    /// G, with one row for each constraint.
    pub(crate) gradients: Vec<Vec<Id>>,
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
}

/// The equation of a step, residual = 0.
pub(crate) struct Equation {
    pub(crate) unknowns: Vec<Symbol>,
    pub(crate) residual: Vec<Id>,
    /// The increments of positions and momenta at a solution.
    pub(crate) end: Vec<Id>,
    /// For every unknown a number of the size whose rounding error the unknown has.
    pub(crate) origin: Vec<Id>,
}

impl<'a> Constrained<'a> {
    /// Adds the derivatives of the constraints and of the velocity.
    pub(crate) fn new(
        graph: &mut Graph,
        constraints: &'a [Id],
        velocity: &'a [Id],
        force: &'a [Id],
        mean_force: &'a [Id],
        mean_velocity: Option<&'a [Id]>,
    ) -> Constrained<'a> {
        let degrees = velocity.len() as u32;
        let [positions, momenta]: [Vec<Symbol>; 2] =
            [Symbol::Position, Symbol::Momentum].map(|symbol: fn(u32) -> Symbol| (0..degrees).map(symbol).collect());
        let gradients = jacobian(graph, constraints, &positions);
        let inverse_mass = jacobian(graph, velocity, &momenta);
        Constrained { constraints, gradients, velocity, inverse_mass, force, mean_force, mean_velocity }
    }

    fn degrees(&self) -> usize {
        self.velocity.len()
    }

    /// dg/dt = G ∂H/∂p.
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

    /// For each constraint the coordinates with inertia that it couples: its own, and those of constraints that share a coordinate with it, directly or
    /// through other constraints.
    fn coupled_coordinates(&self, graph: &Graph) -> Vec<Vec<usize>> {
        let n = self.degrees();
        let own = |gradient: &Vec<Id>| (0..n).filter(|i| !graph.is_zero(gradient[*i])).collect();
        let mut all: Vec<BTreeSet<usize>> = self.gradients.iter().map(own).collect();
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

    /// g(q₁) in units of multipliers.
    fn constraints_at(&self, graph: &mut Graph, end: &[Id]) -> Vec<Id> {
        let units = self.units(graph);
        let values = with_values(graph, self.constraints, Symbol::Position, end);
        values.iter().zip(&units).map(|(value, unit)| graph.div(*value, *unit)).collect()
    }

    /// The origin of every unknown, see [`Equation`]. A multiplier has the rounding error of positions. A position adds the error of W Gᵀν, and a
    /// momentum adds the error of `pull`·Gᵀν/h.
    fn origin(&self, graph: &mut Graph, unknowns: &[Symbol], pull: Number) -> Vec<Id> {
        let units = self.units(graph);
        let mut multipliers = vec![];
        for (gradient, unit) in self.gradients.iter().zip(&units) {
            let mut terms = vec![];
            for (i, slope) in (0..).zip(gradient) {
                let q = graph.symbol(Symbol::Position(i));
                terms.push(graph.build(call(Function::Abs, [*slope * q])));
            }
            let size = graph.sum(&terms);
            multipliers.push(graph.build(size / call(Function::Abs, [*unit])));
        }
        let h = graph.symbol(Symbol::StepLength);
        let weight = graph.build(pull * pow(call(Function::Abs, [h]), Ratio::integer(-1)));
        let directions: Vec<Vec<Id>> = self.gradients.iter().map(|gradient| self.along(graph, gradient)).collect();
        let mut size = |symbol: &Symbol| {
            let (own, rows, weight, i) = match symbol {
                Symbol::Multiplier(k) => return multipliers[*k as usize],
                Symbol::PositionIncrement(i) => (Symbol::Position(*i), &directions, graph.integer(1), *i),
                Symbol::MomentumIncrement(i) => (Symbol::Momentum(*i), &self.gradients, weight, *i),
                other => return graph.symbol(*other),
            };
            let own = graph.symbol(own);
            let mut terms = vec![graph.call(Function::Abs, &[own])];
            for (row, multiplier) in rows.iter().zip(&multipliers) {
                terms.push(graph.build(weight * call(Function::Abs, [row[i as usize]]) * *multiplier));
            }
            graph.sum(&terms)
        };
        unknowns.iter().map(&mut size).collect()
    }
}
