//! Poles and conditions between the ends of a step: what the runtime asks of them.

use crate::analyze::{self, Jump, Pole, Quick, crossings};
use crate::ir::{Graph, Id, UndefinedAt};
use crate::schedule::{Kernel, Layout, Levels, Output, Routine, Scheduler};

/// Poles, and how zeros of what vanishes there are excluded.
#[derive(Debug)]
pub(crate) struct Poles {
    pub(crate) all: Vec<Pole>,
    /// The signs of parameters on which tests by structure rely.
    pub(crate) signs: Option<Signs>,
    /// Tests by structure that are always made.
    pub(crate) always: Option<Margins>,
    /// Those that divided differences make as well.
    pub(crate) undivided: Option<Margins>,
    /// The function that vanishes at each pole: one routine for each.
    pub(crate) vanishing: Kernel,
}

/// Functions of the parameters whose signs are tested: the outputs `positive` and `not_negative`.
#[derive(Debug)]
pub(crate) struct Signs(pub(crate) Routine);

/// Numbers that have to be positive, made of values at both ends of a step.
#[derive(Debug)]
pub(crate) struct Margins {
    pub(crate) values: Routine,
    pub(crate) margins: Vec<Margin>,
}

/// One of them, by the places of values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Margin {
    /// Vectors at both ends must not be opposite: their product is positive.
    Together(Vec<usize>),
    /// An angle moves by less than π.
    Near(usize),
}

/// Conditions that read the state.
#[derive(Debug)]
pub(crate) struct Jumps {
    pub(crate) all: Vec<Jump>,
    /// The side of each condition.
    pub(crate) sides: Routine,
    /// Side and height: one routine for each condition.
    pub(crate) heights: Kernel,
    /// What is equal where the energy was not proven not to jump.
    pub(crate) edge: Option<[Id; 2]>,
}

/// Nodes, each once, and where they are.
#[derive(Default)]
struct Roots(Vec<Id>);

impl Roots {
    fn place(&mut self, id: Id) -> usize {
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
    roots: Roots,
    margins: Vec<Margin>,
}

impl Collected {
    fn together(&mut self, forms: &[Id]) {
        let places = forms.iter().map(|form| self.roots.place(*form)).collect();
        self.add(Margin::Together(places));
    }

    fn near(&mut self, angle: Id) {
        let place = self.roots.place(angle);
        self.add(Margin::Near(place));
    }

    fn add(&mut self, margin: Margin) {
        if !self.margins.contains(&margin) {
            self.margins.push(margin);
        }
    }

    fn margins(self) -> Option<Margins> {
        let Collected { roots: Roots(roots), margins } = self;
        (!margins.is_empty()).then(|| Margins { values: Routine::row("values", roots), margins })
    }
}

impl Poles {
    /// The poles of an energy, if there are any.
    pub(super) fn of(graph: &mut Graph, divided: &[Id], partial: &[UndefinedAt]) -> Option<Poles> {
        let all = analyze::poles(graph, divided, partial);
        if all.is_empty() {
            return None;
        }
        let (mut always, mut undivided) = (Collected::default(), Collected::default());
        let (mut positive, mut not_negative) = (Roots::default(), Roots::default());
        for pole in &all {
            let values = if pole.noticed { &mut undivided } else { &mut always };
            match &pole.quick {
                Some(Quick::Forms(forms, signs)) => {
                    values.together(forms);
                    positive.extend(&signs.positive);
                    not_negative.extend(&signs.not_negative);
                }
                Some(Quick::Angle { value, argument }) => {
                    values.together(&[*value]);
                    always.near(*argument);
                }
                Some(Quick::SineOf { .. }) | None => {}
            }
        }
        let signs =
            [("positive", positive), ("not_negative", not_negative)].map(|(name, roots)| Output::row(name, roots.0));
        let assumed = signs.iter().any(|output| !output.nodes.is_empty());
        Some(Poles {
            signs: assumed.then(|| Signs(Routine::new("signs_hold", signs.to_vec()))),
            always: always.margins(),
            undivided: undivided.margins(),
            vanishing: Kernel::new(
                Levels::One,
                all.iter().map(|pole| Routine::number("vanishing", pole.enclosable)).collect(),
            ),
            all,
        })
    }
}

impl Poles {
    /// Marks the poles at which a mass matrix is singular, by what vanishes there.
    pub(super) fn mark_mass(&mut self, divisors: &[Id]) {
        for pole in &mut self.all {
            pole.of_mass = divisors.contains(&pole.term) || divisors.contains(&pole.vanishes);
        }
    }

    pub(super) fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        let margins = [&mut self.always, &mut self.undivided].into_iter().flatten().map(|margins| &mut margins.values);
        let signs = self.signs.iter_mut().map(|signs| &mut signs.0);
        signs.chain(margins).for_each(|routine| routine.schedule(scheduler));
        schedule_over_any_scalar(&mut self.vanishing, scheduler);
    }
}

impl Jumps {
    /// The conditions of energies that read the state, if there are any.
    pub(super) fn of(graph: &mut Graph, energies: &[Id]) -> Option<Jumps> {
        let mut all: Vec<Jump> = energies.iter().flat_map(|energy| analyze::jumps(graph, *energy)).collect();
        // Points have no velocities: conditions on these are no matter of theirs, and any jump that reads them is one.
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

/// Schedules functions that the runtime calls with any scalar.
pub(super) fn schedule_over_any_scalar(kernel: &mut Kernel, scheduler: &mut Scheduler<'_>) {
    let parameters = scheduler.layout.row_of_parameters();
    let layout = Layout::flat(scheduler.layout.coordinates, &parameters);
    kernel.schedule(&mut Scheduler { graph: &mut *scheduler.graph, layout, has_momenta: scheduler.has_momenta });
}
