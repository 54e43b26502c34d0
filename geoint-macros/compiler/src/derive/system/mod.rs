//! Everything that was derived of a system: the input of emission.

mod implicit;
mod perturbed;

pub(crate) use implicit::{
    ActionStages, Collocation, ConstraintKernels, ContactKernels, ContactStages, FieldKernels, Implicit, KeptMomentum,
    MassKernels, StageKernel, StepKernel, VelocityKernels, VelocityStages,
};
pub(crate) use perturbed::{Inner, Perturbed};

use super::domain::Domain;
use super::jet::JetKernel;
use crate::compilation::Compilation;
use crate::derive::facts::Fact;
use crate::diff;
use crate::ir::{Graph, Id, Symbol};
use crate::legendre::{Canonical, FirstOrder, Legendre, Route};
use crate::schedule::{Extent, Kernel, Layout, Levels, Output, Routine, Scheduler};
use crate::split::{self, Clock, Rejected};

/// Routines and facts of a system.
#[derive(Debug)]
pub(crate) struct System {
    /// Proven properties that need no routine.
    pub(crate) facts: Vec<Fact>,
    /// H. Absent if momenta are not followed.
    pub(crate) value: Option<Routine>,
    /// ∇H. Absent if q and p do not follow ∇H.
    pub(crate) gradient: Option<Routine>,
    /// x'; or q', p' and s' if they do not follow from ∇H alone.
    pub(crate) rate: Option<Routine>,
    /// Kick and drift, for energies in q and p.
    pub(crate) splitting: Option<Result<KickDrift, Missing>>,
    /// A part with an exact flow and a rest, for energies in q and p without an action.
    pub(crate) perturbed: Option<Result<Perturbed, Missing>>,
    /// The energy that symmetric steps of order 2 keep up to h⁴.
    pub(crate) modified: Option<Modified>,
    /// The flows whose composition is a step, for each splitting.
    pub(crate) pieces: Vec<PiecesOf>,
    pub(crate) implicit: Implicit,
    /// Integrals of a flow.
    pub(crate) integrals: Option<Integrals>,
    /// Where the energy is defined.
    pub(crate) domain: Domain,
    /// Velocities and momenta of a Lagrangian.
    pub(crate) lagrangian: Option<Lagrangian>,
    /// Taylor coefficients of the solution.
    pub(crate) jet: Option<JetKernel>,
}

/// L, and the maps between velocities and momenta.
#[derive(Debug)]
pub(crate) struct Lagrangian {
    /// L as a function of velocities.
    pub(crate) value: Routine,
    /// ∂L/∂v.
    pub(crate) momenta: Routine,
    /// v as a function of momenta, if it has a closed form.
    pub(crate) velocities: Option<Routine>,
}

/// Why a system lacks a property.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Missing {
    /// The name of the trait that no scalar implements begins with this word.
    pub(crate) marker: &'static str,
    /// The term to blame.
    pub(crate) term: Id,
    pub(crate) why: &'static str,
    pub(crate) pair: Option<Pair>,
}

impl Missing {
    pub(crate) fn new(marker: &'static str, term: Id, why: &'static str) -> Missing {
        Missing { marker, term, why, pair: None }
    }
}

/// Two coordinates to blame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    pub(crate) coordinates: [Symbol; 2],
    /// The verb of the message: "span the plane".
    pub(crate) verb: &'static str,
}

/// A flow: the routine `end` computes new values of coordinates. A flow that does more than add also has the routine `increments`.
#[derive(Clone, Debug)]
pub(crate) struct FlowKernel {
    /// The coordinates that change, in order.
    pub(crate) changes: Vec<Symbol>,
    pub(crate) kernel: Kernel,
}

/// Kick and drift.
#[derive(Debug)]
pub(crate) struct KickDrift {
    pub(crate) kick: FlowKernel,
    pub(crate) drift: FlowKernel,
    /// Whether a drift is exact in its own time.
    pub(crate) exact_in_time: bool,
    /// Whether the impulse of a kick depends on positions only.
    pub(crate) repeats: bool,
    /// Whether a kick outside of the domain of the energy leaves momenta that are not finite.
    pub(crate) shows: bool,
    pub(crate) gradient_kick: Result<GradientKick, Missing>,
    /// For contact systems.
    pub(crate) undamped: Option<Undamped>,
}

/// A kick with a force gradient.
#[derive(Debug)]
pub(crate) enum GradientKick {
    /// By the kernel of collocation.
    Collocation,
    Flow(FlowKernel),
}

/// Kick and drift without damping, if they differ from those with damping; and the damping.
#[derive(Debug)]
pub(crate) struct Undamped {
    pub(crate) kick: Option<FlowKernel>,
    pub(crate) drift: Option<FlowKernel>,
    pub(crate) damping: Routine,
}

/// H + h²H₂.
#[derive(Debug)]
pub(crate) enum Modified {
    /// By the kernels of implicit methods.
    Implicit,
    Value(Routine),
}

/// The pieces of a splitting.
#[derive(Debug)]
pub(crate) struct PiecesOf {
    /// Name of the splitting.
    pub(crate) splitting: &'static str,
    pub(crate) pieces: Result<Vec<PieceKernel>, Missing>,
    /// Cost of all flows of a step, in units of one sum.
    pub(crate) cost: usize,
    /// Whether the pieces were chosen because the first one has all linear motion, and not for their cost.
    pub(crate) linear: bool,
    /// Other partitions that were found.
    pub(crate) rejected: Vec<Rejected>,
    /// Whether every flow preserves the structure of phase space.
    pub(crate) symplectic: bool,
    /// Whether every flow keeps H, or the first integral.
    pub(crate) conserves_energy: bool,
}

/// A piece of a contact Hamiltonian, or of a field.
#[derive(Debug)]
pub(crate) struct PieceKernel {
    pub(crate) energy: Id,
    /// Whether a step solves an equation. The kernel then has the routine `equation`.
    pub(crate) solved: bool,
    /// Whether its flow may end before its time.
    pub(crate) may_end: bool,
    /// The rules by which its flow is known: their names, applicability and sources.
    pub(crate) known: Vec<String>,
    pub(crate) clock: Clock,
    pub(crate) flow: FlowKernel,
}

/// Functions of x that a flow keeps or changes at a known rate.
#[derive(Debug)]
pub(crate) struct Integrals {
    pub(crate) all: Vec<NamedFunction>,
    /// Values of all functions.
    pub(crate) values: Routine,
    /// Indices of constant functions.
    pub(crate) constant: Vec<usize>,
    /// Indices of constant functions that do not read time.
    pub(crate) steady: Vec<usize>,
    /// Index in `steady` of the function that stands for the energy.
    pub(crate) energy: Option<usize>,
    /// Whether a steady function may be steep in a coordinate near zero.
    pub(crate) steep: bool,
    /// Gradients of the steady functions.
    pub(crate) slopes: Routine,
    /// Changes of the steady functions over an increment.
    pub(crate) changes: Routine,
}

/// A function of x with its name.
#[derive(Debug)]
pub(crate) struct NamedFunction {
    pub(crate) name: String,
    /// Whether the generated struct has a method of this name.
    pub(crate) callable: bool,
}

impl FlowKernel {
    /// Creates a flow from the new values of coordinates.
    pub(super) fn new(levels: Levels, ends: Vec<(Symbol, Id)>) -> FlowKernel {
        let (changes, nodes): (Vec<Symbol>, Vec<Id>) = ends.into_iter().unzip();
        let end = Output { name: "end", extent: Extent::Coordinates(changes.clone()), nodes };
        FlowKernel { changes, kernel: Kernel::new(levels, vec![Routine::new("end", vec![end])]) }
    }

    /// Creates a flow with the routine `increments`, for sums that compensate rounding.
    pub(super) fn with_increments(graph: &mut Graph, levels: Levels, ends: Vec<(Symbol, Id)>) -> FlowKernel {
        let increments = split::increments(graph, &ends);
        let mut flow = FlowKernel::new(levels, ends);
        let extent = Extent::Increments(flow.changes.clone());
        let increments = Output { name: "increments", extent, nodes: increments };
        flow.kernel.routines.push(Routine::new("increments", vec![increments]));
        flow
    }
}

impl System {
    /// Returns whether a property was proven.
    pub(crate) fn has(&self, fact: Fact) -> bool {
        self.facts.contains(&fact)
    }

    /// Adds L with its momenta and velocities.
    pub(crate) fn of_lagrangian(
        mut self,
        positions: &[usize],
        Legendre { lagrangian, momenta, route, divisors, .. }: &Legendre,
    ) -> System {
        let velocities = match route {
            Route::Energy { velocities, .. } => Some(vector("velocity", positions, velocities)),
            Route::Velocities { .. } => None,
        };
        let (value, momenta) = (Routine::number("lagrangian", *lagrangian), vector("momentum", positions, momenta));
        if let Some(poles) = &mut self.domain.poles {
            poles.mark_mass(divisors);
        }
        System { lagrangian: Some(Lagrangian { value, momenta, velocities }), ..self }
    }

    /// Adds L that is linear in velocities, and collocation in canonical coordinates if these are known.
    pub(crate) fn of_first_order(mut self, graph: &mut Graph, positions: &[usize], found: &FirstOrder) -> System {
        if let (Implicit::Field(field), Some(Canonical { values, rates, .. })) = (&mut self.implicit, &found.canonical)
        {
            let x = &field.coordinates.symbols;
            let [values_by, rates_by] = [values, rates].map(|of| diff::jacobian(graph, of, x));
            let canonical = Routine::new(
                "canonical",
                vec![
                    Output::array("value", positions, values.clone()),
                    Output::array("rate", positions, rates.clone()),
                    Output::square("value_by", positions, &values_by),
                    Output::square("rate_by", positions, &rates_by),
                ],
            );
            field.canonical = Some(Kernel::new(Levels::Prepared, vec![canonical]));
        }
        let value = Routine::number("lagrangian", found.lagrangian);
        let momenta = vector("momentum", positions, &found.momenta);
        if let Some(poles) = &mut self.domain.poles {
            poles.mark_mass(&found.divisors);
        }
        System { lagrangian: Some(Lagrangian { value, momenta, velocities: None }), ..self }
    }

    /// Computes the statements of all routines. No node is added to the graph later.
    pub(crate) fn schedule(&mut self, compilation: &mut Compilation<'_>) {
        let (layout, has_momenta) = (Layout::of(compilation.energy), !compilation.form.is_flow());
        let scheduler = &mut Scheduler { graph: &mut compilation.graph, layout, has_momenta };
        if let Some(Ok(flows)) = &mut self.splitting {
            flows.schedule(scheduler);
        }
        if let Some(Ok(parts)) = &mut self.perturbed {
            parts.schedule(scheduler);
        }
        if let Some(Modified::Value(value)) = &mut self.modified {
            value.schedule(scheduler);
        }
        for piece in self.pieces.iter_mut().filter_map(|found| found.pieces.as_mut().ok()).flatten() {
            piece.flow.kernel.schedule(scheduler);
        }
        self.implicit.schedule(scheduler);
        self.domain.schedule(scheduler);
        for routine in [&mut self.value, &mut self.rate, &mut self.gradient].into_iter().flatten() {
            routine.schedule(scheduler);
        }
        if let Some(Integrals { values, slopes, changes, .. }) = &mut self.integrals {
            [values, slopes, changes].into_iter().for_each(|routine| routine.schedule(scheduler));
        }
        if let Some(Lagrangian { value, momenta, velocities }) = &mut self.lagrangian {
            [value, momenta].into_iter().chain(velocities).for_each(|routine| routine.schedule(scheduler));
        }
        if let Some(jet) = &mut self.jet {
            jet.start.schedule(scheduler);
        }
    }
}

/// A routine with one array of numbers, one for each coordinate.
fn vector(name: &'static str, positions: &[usize], nodes: &[Id]) -> Routine {
    Routine::new(name, vec![Output::array(name, positions, nodes.to_vec())])
}

impl KickDrift {
    fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        self.kick.kernel.schedule(scheduler);
        self.drift.kernel.schedule(scheduler);
        if let Ok(GradientKick::Flow(flow)) = &mut self.gradient_kick {
            flow.kernel.schedule(scheduler);
        }
        if let Some(Undamped { kick, drift, damping }) = &mut self.undamped {
            kick.iter_mut().chain(drift).for_each(|flow| flow.kernel.schedule(scheduler));
            damping.schedule(scheduler);
        }
    }
}
