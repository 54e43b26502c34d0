//! The value that holds what was derived of a system.

mod implicit;
mod perturbed;

pub(crate) use implicit::{
    ConstraintKernels, ContactKernels, ContactStages, FieldKernels, HerglotzKernels, Implicit, MassKernels,
    StageKernel, StepKernel, VelocityKernels, VelocityStages,
};

pub(crate) use perturbed::{Inner, Perturbed};

use super::domain::Domain;
use super::jet::JetKernel;
use crate::derive::facts::Fact;
use crate::diff;
use crate::ir::{Graph, Id, Symbol};
use crate::legendre::{Canonical, FirstOrder, Legendre, Route};
use crate::schedule::{Kernel, Levels, Plan};
use crate::split::{self, Clock, Rejected};

/// What a system offers.
#[derive(Debug)]
pub(crate) struct System<K = Kernel> {
    /// Proven properties that need no kernel.
    pub(crate) facts: Vec<Fact>,
    /// H; nothing if momenta are not followed.
    pub(crate) value: Option<K>,
    /// ∇H; nothing where the state is not moved by H in q and p.
    pub(crate) slopes: Option<K>,
    /// q', p' and s', where they are not those of H alone; x'.
    pub(crate) rate: Option<K>,
    /// Kick and drift; of energies in q and p.
    pub(crate) splitting: Option<Result<KickDrift<K>, Missing>>,
    /// A part with an exact flow, and a rest that is a kick; of energies in q and p without an action.
    pub(crate) perturbed: Option<Result<Perturbed<K>, Missing>>,
    /// The energy that symmetric steps of order 2 keep up to h⁴.
    pub(crate) modified: Option<Modified<K>>,
    /// The flows whose composition is a step, for each splitting.
    pub(crate) pieces: Vec<PiecesOf<K>>,
    pub(crate) implicit: Implicit<K>,
    /// What a flow keeps.
    pub(crate) integrals: Option<Integrals<K>>,
    /// Where the energy is defined.
    pub(crate) domain: Domain<K>,
    /// What velocities have to do with it, of a Lagrangian.
    pub(crate) lagrangian: Option<Lagrangian<K>>,
    /// The Taylor coefficients of the solution.
    pub(crate) jet: Option<JetKernel<K>>,
}

/// From velocities to momenta, and back.
#[derive(Debug)]
pub(crate) struct Lagrangian<K = Kernel> {
    /// L, as a function of velocities.
    pub(crate) value: K,
    /// ∂L/∂v.
    pub(crate) momenta: K,
    /// v, as a function of momenta, where that is known.
    pub(crate) velocities: Option<K>,
}

/// What an energy lacks.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Missing {
    /// The beginning of the name of the trait that nothing implements.
    pub(crate) marker: &'static str,
    /// The term to blame.
    pub(crate) term: Id,
    pub(crate) why: &'static str,
    /// Two coordinates to blame, and what they are.
    pub(crate) pair: Option<([Symbol; 2], &'static str)>,
}

/// The end of a flow: what it changes, in order, and the values; of flows that do not only add, with what they add as a second routine.
#[derive(Clone, Debug)]
pub(crate) struct FlowKernel<K = Kernel> {
    pub(crate) changes: Vec<Symbol>,
    pub(crate) kernel: K,
}

/// Kick and drift.
#[derive(Debug)]
pub(crate) struct KickDrift<K> {
    pub(crate) kick: FlowKernel<K>,
    pub(crate) drift: FlowKernel<K>,
    /// Whether a drift is exact in its own time.
    pub(crate) exact_in_time: bool,
    /// Whether a kick adds to the momenta what positions alone decide.
    pub(crate) repeats: bool,
    /// Whether a kick where the energy is not defined leaves momenta that are not finite.
    pub(crate) shows: bool,
    pub(crate) gradient_kick: Result<GradientKick<K>, Missing>,
    /// Of contact systems.
    pub(crate) undamped: Option<Undamped<K>>,
}

/// A kick with a force gradient.
#[derive(Debug)]
pub(crate) enum GradientKick<K> {
    /// By the kernel of collocation.
    Collocation,
    Flow(FlowKernel<K>),
}

/// Kick and drift without damping, where they are others; and the damping.
#[derive(Debug)]
pub(crate) struct Undamped<K> {
    pub(crate) kick: Option<FlowKernel<K>>,
    pub(crate) drift: Option<FlowKernel<K>>,
    pub(crate) damping: K,
}

/// H + h²H₂.
#[derive(Debug)]
pub(crate) enum Modified<K> {
    /// By the kernels of implicit methods.
    Implicit,
    Value(K),
}

/// The pieces of a splitting.
#[derive(Debug)]
pub(crate) struct PiecesOf<K> {
    /// Its name.
    pub(crate) splitting: &'static str,
    pub(crate) pieces: Result<Vec<PieceKernel<K>>, Missing>,
    /// What flows cost a step, in units of one sum.
    pub(crate) cost: usize,
    /// Whether they were taken because all linear motion is in the first one, and not for what they cost.
    pub(crate) linear: bool,
    /// What else was found, and not taken.
    pub(crate) rejected: Vec<Rejected>,
    /// Whether every flow keeps the structure of phase space.
    pub(crate) symplectic: bool,
    /// Whether every flow keeps H, or the first integral.
    pub(crate) conserves_energy: bool,
}

/// A piece of a contact Hamiltonian, or of a field.
#[derive(Debug)]
pub(crate) struct PieceKernel<K> {
    pub(crate) energy: Id,
    /// Whether its step is solved for: the kernel is then that of the equation.
    pub(crate) solved: bool,
    /// Whether its flow may end before its time.
    pub(crate) may_end: bool,
    /// How its flow is known: the names of rules, what they are for, and where from.
    pub(crate) known: Vec<String>,
    pub(crate) clock: Clock,
    pub(crate) flow: FlowKernel<K>,
}

/// Functions of x that a flow keeps, or whose change is known.
#[derive(Debug)]
pub(crate) struct Integrals<K = Kernel> {
    pub(crate) names: Vec<String>,
    /// Whether users call each by its name.
    pub(crate) functions: Vec<bool>,
    pub(crate) values: K,
    /// Those that are kept.
    pub(crate) constant: Vec<usize>,
    /// Those of them that do not read time.
    pub(crate) steady: Vec<usize>,
    /// Which of these stands for the energy.
    pub(crate) energy: Option<usize>,
    /// Whether one of these may be steep in a coordinate that has become small.
    pub(crate) steep: bool,
    /// The gradients of these, one after the other.
    pub(crate) slopes: K,
    /// What these change by over an increment.
    pub(crate) changes: K,
}

impl FlowKernel {
    /// A flow by what it changes.
    pub(super) fn new(levels: Levels, ends: Vec<(Symbol, Id)>) -> FlowKernel {
        let (changes, roots) = ends.into_iter().unzip();
        FlowKernel { changes, kernel: Kernel::new(levels, roots) }
    }

    /// The same with what it adds, as a second routine.
    pub(super) fn with_increments(graph: &mut Graph, levels: Levels, ends: Vec<(Symbol, Id)>) -> FlowKernel {
        let increments = split::increments(graph, &ends);
        let mut flow = FlowKernel::new(levels, ends);
        flow.kernel.routines.push(increments);
        flow
    }
}

impl System {
    /// The same with what a Lagrangian adds.
    pub(crate) fn of_lagrangian(mut self, Legendre { lagrangian, momenta, route, divisors, .. }: &Legendre) -> System {
        let kernel = |roots: &[Id]| Kernel::new(Levels::One, roots.to_vec());
        let lagrangian = Lagrangian {
            value: kernel(&[*lagrangian]),
            momenta: kernel(momenta),
            velocities: match route {
                Route::Energy { velocities, .. } => Some(kernel(velocities)),
                Route::Velocities { .. } => None,
            },
        };
        if let Some(poles) = &mut self.domain.poles {
            poles.mark_mass(divisors);
        }
        System { lagrangian: Some(lagrangian), ..self }
    }

    /// The same with what a Lagrangian that is linear in velocities adds.
    pub(crate) fn of_first_order(mut self, graph: &mut Graph, found: &FirstOrder) -> System {
        if let (Implicit::Field(field), Some(Canonical { values, rates, .. })) = (&mut self.implicit, &found.canonical)
        {
            let [values_by, rates_by] =
                [values, rates].map(|of| diff::jacobian(graph, of, &field.coordinates).concat());
            let stage = [values.clone(), rates.clone(), values_by, rates_by].concat();
            field.canonical = Some(Kernel { levels: Levels::Prepared, routines: vec![stage] });
        }
        let kernel = |roots: &[Id]| Kernel::new(Levels::One, roots.to_vec());
        let (value, momenta) = (kernel(&[found.lagrangian]), kernel(&found.momenta));
        if let Some(poles) = &mut self.domain.poles {
            poles.mark_mass(&found.divisors);
        }
        System { lagrangian: Some(Lagrangian { value, momenta, velocities: None }), ..self }
    }

    /// The statements of all kernels. After that nothing is added to the graph.
    pub(crate) fn scheduled(self, graph: &mut Graph) -> System<Plan> {
        let mut plan = |kernel: Kernel| kernel.plan(graph);
        System {
            facts: self.facts,
            splitting: self.splitting.map(|splitting| Ok(splitting?.map(&mut plan))),
            perturbed: self.perturbed.map(|perturbed| Ok(perturbed?.map(&mut plan))),
            modified: self.modified.map(|modified| match modified {
                Modified::Implicit => Modified::Implicit,
                Modified::Value(value) => Modified::Value(plan(value)),
            }),
            pieces: self.pieces.into_iter().map(|pieces| pieces.map(&mut plan)).collect(),
            implicit: self.implicit.map(&mut plan),
            domain: self.domain.map(&mut plan),
            value: self.value.map(&mut plan),
            rate: self.rate.map(&mut plan),
            slopes: self.slopes.map(&mut plan),
            integrals: self.integrals.map(|integrals| integrals.map(&mut plan)),
            lagrangian: self.lagrangian.map(|lagrangian| lagrangian.map(&mut plan)),
            jet: self.jet.map(|jet| jet.map(&mut plan)),
        }
    }
}

impl<K> System<K> {
    /// Returns whether a property was proven.
    pub(crate) fn has(&self, fact: Fact) -> bool {
        self.facts.contains(&fact)
    }
}

impl<K> Lagrangian<K> {
    fn map<L>(self, of: &mut impl FnMut(K) -> L) -> Lagrangian<L> {
        Lagrangian { value: of(self.value), momenta: of(self.momenta), velocities: self.velocities.map(&mut *of) }
    }
}

impl<K> FlowKernel<K> {
    pub(super) fn map<L>(self, of: &mut impl FnMut(K) -> L) -> FlowKernel<L> {
        FlowKernel { changes: self.changes, kernel: of(self.kernel) }
    }
}

impl<K> KickDrift<K> {
    fn map<L>(self, of: &mut impl FnMut(K) -> L) -> KickDrift<L> {
        KickDrift {
            kick: self.kick.map(of),
            drift: self.drift.map(of),
            exact_in_time: self.exact_in_time,
            repeats: self.repeats,
            shows: self.shows,
            gradient_kick: self.gradient_kick.map(|kick| match kick {
                GradientKick::Collocation => GradientKick::Collocation,
                GradientKick::Flow(flow) => GradientKick::Flow(flow.map(of)),
            }),
            undamped: self.undamped.map(|undamped| Undamped {
                kick: undamped.kick.map(|flow| flow.map(of)),
                drift: undamped.drift.map(|flow| flow.map(of)),
                damping: of(undamped.damping),
            }),
        }
    }
}

impl<K> PieceKernel<K> {
    fn map<L>(self, of: &mut impl FnMut(K) -> L) -> PieceKernel<L> {
        let PieceKernel { energy, solved, may_end, known, clock, flow } = self;
        PieceKernel { energy, solved, may_end, known, clock, flow: flow.map(of) }
    }
}

impl<K> PiecesOf<K> {
    fn map<L>(self, of: &mut impl FnMut(K) -> L) -> PiecesOf<L> {
        let PiecesOf { splitting, pieces, cost, linear, rejected, symplectic, conserves_energy } = self;
        let pieces = pieces.map(|pieces| pieces.into_iter().map(|piece| piece.map(&mut *of)).collect());
        PiecesOf { splitting, pieces, cost, linear, rejected, symplectic, conserves_energy }
    }
}

impl<K> Integrals<K> {
    fn map<L>(self, of: &mut impl FnMut(K) -> L) -> Integrals<L> {
        Integrals {
            names: self.names,
            functions: self.functions,
            constant: self.constant,
            steady: self.steady,
            energy: self.energy,
            steep: self.steep,
            values: of(self.values),
            slopes: of(self.slopes),
            changes: of(self.changes),
        }
    }
}
