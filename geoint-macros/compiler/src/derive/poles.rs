//! Tests between the ends of a step: poles, conditions where the energy may jump, and angles.

use crate::analyze::{self, Jump, Pole, Quick, crossings};
use crate::ir::{Function, Graph, Id, Node, UndefinedAt};
use crate::schedule::{Kernel, Layout, Levels, Output, Routine, Scheduler};

/// Poles, and tests that exclude them between the ends of a step.
#[derive(Debug)]
pub(crate) struct Poles {
    pub(crate) all: Vec<Pole>,
    /// The signs of parameters on which tests by structure rely.
    pub(crate) signs: Option<Signs>,
    /// Tests by structure that every step makes.
    pub(crate) always: Option<Margins>,
    /// Tests by structure for steps without divided differences, which detect these poles themselves.
    pub(crate) undivided: Option<Margins>,
    /// The function that vanishes at each pole: one routine a pole.
    pub(crate) vanishing: Kernel,
}

/// Functions of the parameters whose signs are tested: the outputs `positive` and `not_negative`.
#[derive(Debug)]
pub(crate) struct Signs(pub(crate) Routine);

/// Numbers that are positive if no pole lies between the ends of a step. They are computed from values at both ends.
#[derive(Debug)]
pub(crate) struct Margins {
    pub(crate) values: Routine,
    pub(crate) margins: Vec<Margin>,
}

/// A number that has to be positive, by indices of values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Margin {
    /// The scalar product of a vector at one end with the vector at the other end.
    Together(Vec<usize>),
    /// π minus the change of an angle.
    Near(usize),
}

/// Conditions on the state at which the energy may jump.
#[derive(Debug)]
pub(crate) struct Jumps {
    pub(crate) all: Vec<Jump>,
    /// The side of each condition.
    pub(crate) sides: Routine,
    /// Side and height: one routine a condition.
    pub(crate) heights: Kernel,
    /// Two functions that are equal where the energy may jump, if there is no proof that it does not.
    pub(crate) edge: Option<[Id; 2]>,
}

/// The angles `atan2(y, x)` of the state in formulas with discrete gradients.
#[derive(Debug)]
pub(crate) struct Angles {
    pub(crate) all: Vec<Id>,
    /// y and x of each angle.
    pub(crate) sides: Routine,
}

/// A list of different nodes.
#[derive(Default)]
pub(super) struct DistinctNodes(pub(super) Vec<Id>);

impl DistinctNodes {
    /// Returns the index of a node. Adds the node if it is new.
    pub(super) fn place(&mut self, id: Id) -> usize {
        self.0.iter().position(|known| *known == id).unwrap_or_else(|| {
            self.0.push(id);
            self.0.len() - 1
        })
    }

    fn extend(&mut self, ids: &[Id]) {
        for id in ids {
            self.place(*id);
        }
    }
}

/// Margins while they are collected.
#[derive(Default)]
struct Collected {
    values: DistinctNodes,
    margins: Vec<Margin>,
}

impl Collected {
    fn add_scalar_product(&mut self, forms: &[Id]) {
        let places = forms.iter().map(|form| self.values.place(*form)).collect();
        self.add(Margin::Together(places));
    }

    fn add_angle(&mut self, angle: Id) {
        let place = self.values.place(angle);
        self.add(Margin::Near(place));
    }

    fn add(&mut self, margin: Margin) {
        if !self.margins.contains(&margin) {
            self.margins.push(margin);
        }
    }

    fn margins(self) -> Option<Margins> {
        let Collected { values, margins } = self;
        (!margins.is_empty()).then(|| Margins { values: Routine::row("values", values.0), margins })
    }
}

impl Poles {
    /// Finds the poles of formulas with discrete gradients, if there are any.
    pub(super) fn of(graph: &mut Graph, divided: &[Id], partial: &[UndefinedAt]) -> Option<Poles> {
        let all = analyze::poles(graph, divided, partial);
        if all.is_empty() {
            return None;
        }
        let (mut always, mut undivided) = (Collected::default(), Collected::default());
        let (mut positive, mut not_negative) = (DistinctNodes::default(), DistinctNodes::default());
        for pole in &all {
            let values = if pole.noticed { &mut undivided } else { &mut always };
            match &pole.quick {
                Some(Quick::Forms(forms, signs)) => {
                    values.add_scalar_product(forms);
                    positive.extend(&signs.positive);
                    not_negative.extend(&signs.not_negative);
                }
                Some(Quick::Angle { value, argument }) => {
                    values.add_scalar_product(&[*value]);
                    always.add_angle(*argument);
                }
                Some(Quick::SineOf { .. }) | None => {}
            }
        }
        let signs = vec![Output::row("positive", positive.0), Output::row("not_negative", not_negative.0)];
        let assumed = signs.iter().any(|output| !output.nodes.is_empty());
        let vanishing = all.iter().map(|pole| Routine::number("vanishing", pole.enclosable)).collect();
        Some(Poles {
            signs: assumed.then(|| Signs(Routine::new("signs_hold", signs))),
            always: always.margins(),
            undivided: undivided.margins(),
            vanishing: Kernel::new(Levels::One, vanishing),
            all,
        })
    }

    /// Marks the poles at which a mass matrix is singular. `divisors` vanish there.
    pub(super) fn mark_mass(&mut self, divisors: &[Id]) {
        for pole in &mut self.all {
            pole.of_mass = divisors.contains(&pole.term) || divisors.contains(&pole.vanishes);
        }
    }

    /// Computes the statements of all routines.
    pub(super) fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        let margins = [&mut self.always, &mut self.undivided].into_iter().flatten().map(|margins| &mut margins.values);
        let signs = self.signs.iter_mut().map(|signs| &mut signs.0);
        signs.chain(margins).for_each(|routine| routine.schedule(scheduler));
        schedule_over_any_scalar(&mut self.vanishing, scheduler);
    }
}

impl Jumps {
    /// Finds the conditions on the state in energies, if there are any.
    pub(super) fn of(graph: &mut Graph, energies: &[Id]) -> Option<Jumps> {
        let mut all: Vec<Jump> = energies.iter().flat_map(|energy| analyze::jumps(graph, *energy)).collect();
        // The runtime evaluates conditions at points of phase space, which have no velocities. Conditions on velocities are left out. A height that reads
        // velocities is replaced by 1, so that it counts as a jump.
        all.retain(|jump| !graph.reads(jump.side).v);
        let one = graph.integer(1);
        let height = |jump: &Jump| if graph.reads(jump.height).v { one } else { jump.height };
        let routines = all.iter().map(|jump| Routine::row("jump", vec![jump.side, height(jump)])).collect();
        (!all.is_empty()).then(|| Jumps {
            sides: Routine::row("sides", all.iter().map(|jump| jump.side).collect()),
            heights: Kernel::new(Levels::One, routines),
            edge: energies
                .iter()
                .find_map(|energy| crossings::edges_of_jumps(graph, *energy).first().map(|edge| edge.equal)),
            all,
        })
    }
}

impl Angles {
    /// Returns the angles that read coordinates and no velocities: the runtime evaluates them at points of phase space.
    pub(super) fn of(graph: &mut Graph, roots: &[Id]) -> Option<Angles> {
        let mut all = graph.reachable(roots);
        all.retain(|id| {
            let is_angle = matches!(graph.node(*id), Node::Call(Function::Atan2, _));
            is_angle && graph.reads(*id).state() && !graph.reads(*id).v
        });
        let sides: Vec<Id> = all.iter().flat_map(|id| graph.node(*id).children()).collect();
        let extents = [all.len(), 2];
        (!all.is_empty()).then(|| Angles { all, sides: Routine::array("angles", "sides", &extents, sides) })
    }
}

/// Schedules functions that the runtime calls with any scalar. Their coordinates are one row of numbers, and so are their parameters.
pub(super) fn schedule_over_any_scalar(kernel: &mut Kernel, scheduler: &mut Scheduler<'_>) {
    let parameters = scheduler.layout.row_of_parameters();
    let layout = Layout::flat(scheduler.layout.coordinates, &parameters);
    kernel.schedule(&mut Scheduler { graph: &mut *scheduler.graph, layout, has_momenta: scheduler.has_momenta });
}
