//! The equations of implicit methods, by form.

use super::Missing;
use crate::analyze::{MeanValue, Momentum};
use crate::ir::{Id, Symbol};

/// The equations of implicit methods.
#[derive(Debug)]
pub(crate) enum Implicit<K> {
    /// Of a field.
    Field(FieldKernels<K>),
    /// Of contact systems.
    Contact(ContactKernels<K>),
    /// Of a Lagrangian, for velocities.
    Velocities(VelocityKernels<K>),
    /// Of a Lagrangian with an action, for velocities.
    Herglotz(HerglotzKernels<K>),
    /// With constraints.
    Constrained(ConstraintKernels<K>),
}

/// ∂L/∂v of a Lagrangian, and how it depends on v.
#[derive(Debug)]
pub(crate) struct MassKernels<K> {
    /// ∂L/∂v and M.
    pub(crate) mass: K,
    /// Functions of parameters, of which so many are not negative and the others positive where M is positive definite at every state.
    pub(crate) definite: Option<(usize, K)>,
    /// Whether L is quadratic in v.
    pub(crate) quadratic: bool,
}

/// Stages of collocation of a Lagrangian with an action, for velocities.
#[derive(Debug)]
pub(crate) struct VelocityStages<K> {
    /// Whether ∂L/∂s reads the state, so that s is solved for.
    pub(crate) varying: bool,
    /// Whether L has second derivatives by q and v, by v and s, and by q and s.
    pub(crate) mixed: [bool; 3],
    pub(crate) mass: MassKernels<K>,
    /// ∂L/∂v and ∂L/∂q, with their derivatives by q and v; L, σ = −∂L/∂s, and the derivatives of all by s; ∂L/∂q and σ.
    pub(crate) stage: K,
}

/// A Lagrangian with an action by its derivatives.
#[derive(Debug)]
pub(crate) struct HerglotzKernels<K> {
    pub(crate) stages: VelocityStages<K>,
    /// What is solved for by the polarised discrete gradient, and its equation, as the runtime has it. Of an L that is quadratic in v.
    pub(crate) polarised: Result<StepKernel<K>, Missing>,
}

/// Constraints, and the steps that keep them.
#[derive(Debug)]
pub(crate) struct ConstraintKernels<K> {
    /// g.
    pub(crate) constraints: Vec<Id>,
    /// Whether ∂H/∂p is affine in p.
    pub(crate) quadratic: bool,
    /// g and G.
    pub(crate) values: K,
    /// ∂H/∂p and ∂²H/∂p².
    pub(crate) velocity: K,
    /// g, its size, G ∂H/∂p, its size.
    pub(crate) departure: K,
    /// Of each method by name: the residual with its derivative; what a solution adds; the origin of unknowns.
    pub(crate) steps: Vec<(&'static str, StepKernel<K>)>,
}

/// A Lagrangian by its derivatives.
#[derive(Debug)]
pub(crate) struct VelocityKernels<K> {
    /// The increments of velocities, which are solved for.
    pub(crate) increments: Vec<Symbol>,
    pub(crate) mass: MassKernels<K>,
    /// ∂L/∂v and the force, with their derivatives by q and v; the force.
    pub(crate) stage: K,
    /// Whether the flow keeps p·v − L: nothing reads time, and there is neither friction nor another force.
    pub(crate) keeps: bool,
    /// The equation of the polarised discrete gradient, what it adds to the momenta, and the derivatives of both. Of an L that is quadratic
    /// in v.
    pub(crate) polarised: Result<K, Missing>,
    /// Sums of momenta, and angular momenta, that the flow keeps; whether the discrete gradient does, too.
    pub(crate) momenta: Vec<(Momentum, bool)>,
}

/// The field of implicit methods for (q, p), for q alone, or for x.
#[derive(Debug)]
pub(crate) struct FieldKernels<K> {
    /// The coordinates that are solved for, and their increments.
    pub(crate) coordinates: Vec<Symbol>,
    pub(crate) increments: Vec<Symbol>,
    /// Whether the equation is one of second order.
    pub(crate) second_order: bool,
    /// f with its derivative; ∂T/∂p; M⁻¹p.
    pub(crate) collocation: K,
    /// f̄ with its derivative; the equation of Newton's iteration; h ∂T/∂p of a mean momentum.
    pub(crate) discrete: Option<K>,
    /// Why there is no such thing, if there is more to say of it than that nothing is kept.
    pub(crate) nothing_kept: Option<Missing>,
    /// Canonical coordinates and their rates, with the derivatives of both: what collocation moves if there are such.
    pub(crate) canonical: Option<K>,
    /// The equation of a step of order 4 of a flow: h·f̄, and 1 − ∂(h·f̄)/∂d.
    pub(crate) fourth: Option<K>,
    /// The gradients of momenta that steps of order 4 of a canonical system keep, one after the other.
    pub(crate) momenta: K,
    /// Whether Newton's iteration has a kernel of its own.
    pub(crate) folded: bool,
    /// Whether the equation of a step is linear.
    pub(crate) linear: bool,
    pub(crate) mean_value: MeanValue,
}

/// The implicit steps of a contact system.
#[derive(Debug)]
pub(crate) struct ContactKernels<K> {
    /// Of each method by name.
    pub(crate) steps: Vec<(&'static str, StepKernel<K>)>,
    /// Of collocation; nothing if momenta are not followed.
    pub(crate) stages: Option<ContactStages<K>>,
}

/// What collocation of a contact system solves for.
#[derive(Debug)]
pub(crate) enum ContactStages<K> {
    Points(StageKernel<K>),
    Velocities(VelocityStages<K>),
}

/// The field of a contact system at a stage.
#[derive(Debug)]
pub(crate) struct StageKernel<K> {
    /// What is solved for: q and p, and s if they read it.
    pub(crate) moved: Vec<Symbol>,
    /// Their rates, where that of p is −∂H/∂q, and ∂H/∂s; then the derivatives of all that. ∂H/∂s alone. s' alone.
    pub(crate) kernel: K,
}

/// The equation of an implicit step in (q, p, s).
#[derive(Debug)]
pub(crate) struct StepKernel<K> {
    pub(crate) unknowns: Vec<Symbol>,
    /// Φ with 1 − ∂Φ/∂d; what a solution adds.
    pub(crate) kernel: K,
}

impl<K> Implicit<K> {
    pub(super) fn map<L>(self, of: &mut impl FnMut(K) -> L) -> Implicit<L> {
        match self {
            Implicit::Field(field) => Implicit::Field(FieldKernels {
                coordinates: field.coordinates,
                increments: field.increments,
                second_order: field.second_order,
                collocation: of(field.collocation),
                discrete: field.discrete.map(&mut *of),
                nothing_kept: field.nothing_kept,
                canonical: field.canonical.map(&mut *of),
                fourth: field.fourth.map(&mut *of),
                momenta: of(field.momenta),
                folded: field.folded,
                linear: field.linear,
                mean_value: field.mean_value,
            }),
            Implicit::Velocities(VelocityKernels { increments, mass, stage, keeps, polarised, momenta }) => {
                let (mass, stage) = (mass.map(of), of(stage));
                let polarised = polarised.map(&mut *of);
                Implicit::Velocities(VelocityKernels { increments, mass, stage, keeps, polarised, momenta })
            }
            Implicit::Herglotz(HerglotzKernels { stages, polarised }) => {
                let stages = stages.map(of);
                let polarised =
                    polarised.map(|StepKernel { unknowns, kernel }| StepKernel { unknowns, kernel: of(kernel) });
                Implicit::Herglotz(HerglotzKernels { stages, polarised })
            }
            Implicit::Contact(ContactKernels { steps, stages }) => {
                let steps = mapped(steps, of);
                let stages = stages.map(|stages| match stages {
                    ContactStages::Points(StageKernel { moved, kernel }) => {
                        ContactStages::Points(StageKernel { moved, kernel: of(kernel) })
                    }
                    ContactStages::Velocities(stages) => ContactStages::Velocities(stages.map(of)),
                });
                Implicit::Contact(ContactKernels { steps, stages })
            }
            Implicit::Constrained(ConstraintKernels { constraints, quadratic, values, velocity, departure, steps }) => {
                Implicit::Constrained(ConstraintKernels {
                    constraints,
                    quadratic,
                    values: of(values),
                    velocity: of(velocity),
                    departure: of(departure),
                    steps: mapped(steps, of),
                })
            }
        }
    }
}

impl<K> VelocityStages<K> {
    fn map<L>(self, of: &mut impl FnMut(K) -> L) -> VelocityStages<L> {
        let VelocityStages { varying, mixed, mass, stage } = self;
        VelocityStages { varying, mixed, mass: mass.map(of), stage: of(stage) }
    }
}

impl<K> MassKernels<K> {
    fn map<L>(self, of: &mut impl FnMut(K) -> L) -> MassKernels<L> {
        MassKernels {
            mass: of(self.mass),
            definite: self.definite.map(|(weights, values)| (weights, of(values))),
            quadratic: self.quadratic,
        }
    }
}

/// The equations of steps by the names of methods.
fn mapped<K, L>(
    steps: Vec<(&'static str, StepKernel<K>)>,
    of: &mut impl FnMut(K) -> L,
) -> Vec<(&'static str, StepKernel<L>)> {
    let step =
        |(name, step): (_, StepKernel<K>)| (name, StepKernel { unknowns: step.unknowns, kernel: of(step.kernel) });
    steps.into_iter().map(step).collect()
}
