//! The equations of implicit steps of a Lagrangian L(q, v, t) or L(q, v, s, t) whose unknowns are velocities.

mod ends;
mod polarised;

use super::equations;
use super::field::symmetrise;
use super::forward::jacobian;
use super::gradient::partial_derivative;
use crate::analyze::Forces;
use crate::ir::collect::collected_with;
use crate::ir::{Graph, Id, Symbol};
pub(crate) use polarised::{Polarised, polarisation, polarised};

/// The terms of d/dt ∂L/∂v = ∂L/∂q − Cv + F, or with an action s of d/dt ∂L/∂v = ∂L/∂q + ∂L/∂s ∂L/∂v, s' = L.
#[derive(Clone, Copy)]
pub(crate) struct EulerLagrange<'a> {
    pub(crate) lagrangian: Id,
    /// The momenta ∂L/∂v.
    pub(crate) momenta: &'a [Id],
    /// The forces ∂L/∂q.
    pub(crate) forces: &'a [Id],
    /// The mass matrix M = ∂²L/∂v².
    pub(crate) mass: &'a [Vec<Id>],
    /// ∂L/∂v at v = 0.
    pub(crate) shift: &'a [Id],
    /// −L at v = 0.
    pub(crate) potential: Id,
    /// The damping matrix C. Absent with an action.
    pub(crate) damping: Option<&'a [Vec<Id>]>,
    /// The applied forces and nonlinear friction F. Absent with an action.
    pub(crate) applied: Option<&'a Forces>,
    /// L has an action s with s' = L.
    pub(crate) has_action: bool,
}

impl EulerLagrange<'_> {
    fn degrees(&self) -> u32 {
        self.momenta.len() as u32
    }

    /// ∂L/∂q − Cv + F.
    fn force(&self, graph: &mut Graph) -> Vec<Id> {
        let velocities: Vec<Id> = (0..self.degrees()).map(|i| graph.symbol(Symbol::Velocity(i))).collect();
        equations::euler_lagrange(graph, self.forces, &velocities, self.damping, self.applied, |_, id| id)
    }
}

/// Values and derivatives at a stage of collocation.
pub(crate) struct Stage {
    /// p = ∂L/∂v.
    pub(crate) momentum: Vec<Id>,
    /// f = ∂L/∂q − Cv + F.
    pub(crate) force: Vec<Id>,
    pub(crate) momentum_by_q: Vec<Vec<Id>>,
    pub(crate) mass: Vec<Vec<Id>>,
    pub(crate) force_by_q: Vec<Vec<Id>>,
    pub(crate) force_by_v: Vec<Vec<Id>>,
    pub(crate) action: Option<ActionStage>,
}

/// The part of a stage that only a Lagrangian with an action has.
pub(crate) struct ActionStage {
    /// s' = L.
    pub(crate) lagrangian: Id,
    /// σ = −∂L/∂s.
    pub(crate) decay: Id,
    pub(crate) momentum_by_action: Vec<Id>,
    pub(crate) force_by_action: Vec<Id>,
    pub(crate) decay_by_action: Id,
}

/// Builds the stage of collocation.
pub(crate) fn stage(graph: &mut Graph, equation: EulerLagrange<'_>) -> Stage {
    let EulerLagrange { lagrangian, momenta, has_action, .. } = equation;
    let decay = has_action.then(|| {
        let by_action = partial_derivative(graph, lagrangian, Symbol::Action);
        graph.neg(by_action)
    });
    let force = equation.force(graph);
    let positions: Vec<Symbol> = (0..equation.degrees()).map(Symbol::Position).collect();
    let velocities: Vec<Symbol> = (0..equation.degrees()).map(Symbol::Velocity).collect();
    let momentum_by_q = jacobian(graph, momenta, &positions);
    let mut force_by_q = jacobian(graph, &force, &positions);
    let mut force_by_v = jacobian(graph, &force, &velocities);
    if equation.damping.is_none() && equation.applied.is_none() {
        // ∂²L/∂q∂v = (∂²L/∂v∂q)ᵀ, and ∂²L/∂q² is symmetric.
        force_by_v = (0..force.len()).map(|i| momentum_by_q.iter().map(|row| row[i]).collect()).collect();
        symmetrise(&mut force_by_q);
    }
    let action = decay.map(|decay| {
        let mut by_action = |nodes: &[Id]| jacobian(graph, nodes, &[Symbol::Action]).concat();
        ActionStage {
            lagrangian,
            decay,
            momentum_by_action: by_action(momenta),
            force_by_action: by_action(&force),
            decay_by_action: by_action(&[decay])[0],
        }
    });
    let mass = equation.mass.to_vec();
    Stage { momentum: momenta.to_vec(), force, momentum_by_q, mass, force_by_q, force_by_v, action }
}

impl Stage {
    /// Collects terms that differ in parameters alone.
    pub(crate) fn collect_terms(&mut self, graph: &mut Graph) {
        let Stage { momentum, force, momentum_by_q, mass, force_by_q, force_by_v, action } = self;
        let mut nodes: Vec<&mut Id> = momentum.iter_mut().chain(force).collect();
        nodes.extend([momentum_by_q, mass, force_by_q, force_by_v].into_iter().flatten().flatten());
        if let Some(ActionStage { lagrangian, decay, momentum_by_action, force_by_action, decay_by_action }) = action {
            nodes.extend([lagrangian, decay, decay_by_action]);
            nodes.extend(momentum_by_action.iter_mut().chain(force_by_action));
        }
        collect_terms(graph, nodes, &[]);
    }
}

/// Replaces nodes in `nodes`, and collects terms that differ in parameters alone.
fn collect_terms(graph: &mut Graph, nodes: Vec<&mut Id>, replaced: &[(Id, Id)]) {
    let roots: Vec<Id> = nodes.iter().map(|node| **node).collect();
    for (node, collected) in nodes.into_iter().zip(collected_with(graph, &roots, replaced)) {
        *node = collected;
    }
}
