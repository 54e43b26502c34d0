//! Facts about a system for its report.

use super::proof::{Integrals, Structure};
use super::{Flow, Liouville, Parted, System};
use crate::analyze::{self, Binding, Damping, Dissipated, Forces, Proof};
use crate::compilation::Compilation;
use crate::diff::Gradient;
use crate::diff::constraint::{Action, Row};
use crate::ir::Id;
use crate::legendre::{FirstOrder, Legendre};

/// A system with its routines, and facts for its report.
pub(crate) struct Derived {
    /// The Lagrangian, if the system was written as one with momenta.
    pub(crate) legendre: Option<Legendre>,
    pub(crate) findings: Findings,
    pub(crate) system: System,
}

impl Derived {
    /// Adds the routines of the Lagrangian, if there is one.
    pub(crate) fn with_velocities(self, compilation: &Compilation<'_>) -> Derived {
        let Derived { legendre, findings, system } = self;
        let system = legendre.iter().fold(system, |system, legendre| system.of_lagrangian(compilation, legendre));
        Derived { legendre, findings, system }
    }
}

/// Facts by form.
pub(crate) enum Findings {
    /// H(q, p, t).
    Canonical { structure: analyze::Structure, gradient: Gradient },
    /// H(q, p, t) with constraints.
    Constrained(Box<ConstrainedFindings>),
    /// H(q, p, s, t). `measure` is that of a lifted field.
    Contact { energy: Id, gradient: Gradient, dissipated: Option<Dissipated>, measure: Option<Measure> },
    /// H(q, p, s, t) with forces beside it. `drag` is ∂R/∂v of a quadratic Rayleigh function R.
    Forced { energy: Id, forces: Option<Forces>, drag: Option<Vec<Id>> },
    /// L(q, v, s, t) with velocities as unknowns. `obstacle` is the reason why there is no H.
    Velocities { obstacle: Id, beside: BesideVelocities },
    /// x' = f(x, t).
    Flow { flow: Flow, source: Source },
    /// H(r, m, t) of rigid bodies.
    Bodies(analyze::Bodies),
}

/// Facts about a system with constraints.
pub(crate) struct ConstrainedFindings {
    /// The user's energy.
    pub(crate) energy: Id,
    pub(crate) structure: analyze::Structure,
    /// The integrals of the system with constraints.
    pub(crate) kept: analyze::Structure,
    pub(crate) rows: Vec<Row>,
    /// Whether the rows of velocities bind positions.
    pub(crate) bindings: Vec<Binding>,
    pub(crate) gradient: Gradient,
    /// The friction of an energy with an action, and what decays by it. Structure and gradient are those of the energy without it.
    pub(crate) action: Option<(Action, Dissipated)>,
}

/// Loss of energy of a Lagrangian with velocities as unknowns.
pub(crate) enum BesideVelocities {
    /// Friction and forces beside L(q, v, t).
    Forces { damping: Option<Damping>, forces: Option<Forces> },
    /// The action of L(q, v, s, t). `decay` is −∂L/∂s.
    Action { decay: Id, dissipated: Option<Dissipated> },
}

/// The origin of the integrals of a flow, by form.
pub(crate) enum Source {
    /// A skew matrix S that the user has written.
    Structure(Structure),
    /// A field. Each integral was proven or found.
    Field(FieldFindings),
    /// A Lagrangian that is linear in velocities. S is the inverse of a skew matrix.
    Lagrangian(FirstOrder),
}

/// An invariant measure ρ dx of a field, as stated by the user.
pub(crate) struct Measure {
    pub(crate) density: Id,
    /// Proof of div(ρf) = 0.
    pub(crate) proof: Proof,
}

/// Facts about a field.
pub(crate) struct FieldFindings {
    pub(crate) proofs: Integrals,
    pub(crate) measure: Option<Measure>,
    pub(crate) liouville: Liouville,
    /// S of the planes, if it is known.
    pub(crate) parted: Option<Parted>,
}
