//! A system with the routines of all methods: the input of emission.

mod lagrangian;
mod bodies;
mod kernels;
mod kick_drift;
mod perturbed;

pub(crate) use bodies::{BodyKernels, Shift, Turn};
pub(crate) use kernels::{
    Collocation, ConstraintKernels, ContactKernels, ContactStages, Decay, FieldKernels, KeptMomentum, Kernels,
    MassKernels, MixedDerivatives, StageKernel, StepKernel, VelocityKernels, VelocityStages,
};
pub(crate) use kick_drift::{GradientKick, KickDrift, Undamped};
pub(crate) use lagrangian::{Lagrangian, OfEnergy};
pub(crate) use perturbed::{Inner, Perturbed};

use super::domain::Domain;
use super::jet::JetKernel;
use crate::compilation::Compilation;
use crate::derive::facts::Fact;
use crate::ir::{Graph, Id, Symbol};
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
    /// A part with an exact flow, and the rest, for energies in q and p without an action.
    pub(crate) perturbed: Option<Result<Perturbed, Missing>>,
    /// The energy that symmetric steps of order 2 keep up to h⁴.
    pub(crate) modified: Option<Modified>,
    /// The flows whose composition is a step, for each splitting.
    pub(crate) pieces: Vec<PiecesOf>,
    /// Kernels of the methods of its form.
    pub(crate) kernels: Kernels,
    /// Integrals of a flow.
    pub(crate) integrals: Option<Integrals>,
    /// Tests of the domain of the energy.
    pub(crate) domain: Domain,
    /// Velocities and momenta of a Lagrangian.
    pub(crate) lagrangian: Option<Lagrangian>,
    /// Momenta from velocities, for a system that is given by its energy.
    pub(crate) of_energy: Option<OfEnergy>,
    /// Taylor coefficients of the solution.
    pub(crate) jet: Option<JetKernel>,
}

/// The reason why a system lacks a property.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Missing {
    /// The first word in the name of a trait that no scalar implements.
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

/// H + h²H₂.
#[derive(Debug)]
pub(crate) enum Modified {
    /// A value from the kernels of implicit methods.
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
    /// True if the pieces were chosen because the first one has all linear motion, and not for their cost.
    pub(crate) linear: bool,
    /// Other partitions that were found.
    pub(crate) rejected: Vec<Rejected>,
    /// True if every flow preserves the structure of phase space.
    pub(crate) symplectic: bool,
    /// True if every flow keeps H, or the first integral.
    pub(crate) conserves_energy: bool,
}

/// A piece of a contact Hamiltonian, or of a field.
#[derive(Debug)]
pub(crate) struct PieceKernel {
    pub(crate) energy: Id,
    /// True if a step solves an equation. The kernel then has the routine `equation`.
    pub(crate) solved: bool,
    /// True if the flow may end within a step.
    pub(crate) may_end: bool,
    /// Rules of the flow: their names, energies and sources.
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
    /// Index in `steady` of the function that is used as the energy.
    pub(crate) energy: Option<usize>,
    /// True if a steady function may be steep in a coordinate near zero.
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
    /// True if the generated struct has a method of this name.
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

/// Returns the ends of coordinates with nonzero increments. The terms of an increment are summed first, so that a coordinate is rounded once.
pub(super) fn grown(graph: &mut Graph, increments: impl IntoIterator<Item = (Symbol, Id)>) -> Vec<(Symbol, Id)> {
    let mut ends = vec![];
    for (symbol, increment) in increments {
        if !graph.is_zero(increment) {
            let start = graph.symbol(symbol);
            ends.push((symbol, graph.add(start, increment)));
        }
    }
    ends
}

impl System {
    /// Creates a system with the kernels of its form, and nothing else.
    pub(super) fn new(kernels: Kernels, domain: Domain) -> System {
        System {
            facts: vec![],
            value: None,
            gradient: None,
            rate: None,
            splitting: None,
            perturbed: None,
            modified: None,
            pieces: vec![],
            kernels,
            integrals: None,
            domain,
            lagrangian: None,
            of_energy: None,
            jet: None,
        }
    }

    /// Returns whether a property was proven.
    pub(crate) fn has(&self, fact: Fact) -> bool {
        self.facts.contains(&fact)
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
        self.kernels.schedule(scheduler);
        self.domain.schedule(scheduler);
        for routine in [&mut self.value, &mut self.rate, &mut self.gradient].into_iter().flatten() {
            routine.schedule(scheduler);
        }
        if let Some(Integrals { values, slopes, changes, .. }) = &mut self.integrals {
            [values, slopes, changes].into_iter().for_each(|routine| routine.schedule(scheduler));
        }
        if let Some(lagrangian) = &mut self.lagrangian {
            lagrangian.schedule(scheduler);
        }
        if let Some(OfEnergy { momenta, .. }) = &mut self.of_energy {
            momenta.schedule(scheduler);
        }
        if let Some(jet) = &mut self.jet {
            jet.start.schedule(scheduler);
        }
    }
}
