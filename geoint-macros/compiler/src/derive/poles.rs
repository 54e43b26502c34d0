//! Poles and conditions between the ends of a step: what the runtime asks of them.

use crate::analyze::{self, Jump, Pole, Quick, crossings};
use crate::ir::{Graph, Id, UndefinedAt};
use crate::schedule::{Kernel, Levels};

/// Poles, and how zeros of what vanishes there are excluded.
#[derive(Debug)]
pub(crate) struct Poles<K = Kernel> {
    pub(crate) all: Vec<Pole>,
    /// The signs of parameters on which tests by structure rely.
    pub(crate) signs: Option<Signs<K>>,
    /// Tests by structure that are always made.
    pub(crate) always: Option<Margins<K>>,
    /// Those that divided differences make as well.
    pub(crate) undivided: Option<Margins<K>>,
    /// What must not vanish: a routine a pole.
    pub(crate) vanishing: K,
}

/// Numbers made of parameters whose signs have to be as they are assumed.
#[derive(Debug)]
pub(crate) struct Signs<K = Kernel> {
    pub(crate) values: K,
    /// So many of them, the first ones, have to be positive; the others not negative.
    pub(crate) positive: usize,
}

/// Numbers that have to be positive, made of values at both ends of a step.
#[derive(Debug)]
pub(crate) struct Margins<K = Kernel> {
    pub(crate) values: K,
    /// How many values there are.
    pub(crate) count: usize,
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
pub(crate) struct Jumps<K = Kernel> {
    pub(crate) all: Vec<Jump>,
    /// The side of each.
    pub(crate) sides: K,
    /// The side and the height: a routine a condition.
    pub(crate) heights: K,
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
        let count = roots.len();
        (!margins.is_empty()).then(|| Margins { values: Kernel::new(Levels::One, roots), count, margins })
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
        let Roots(positive) = positive;
        let parameters = [&positive[..], &not_negative.0].concat();
        Some(Poles {
            signs: (!parameters.is_empty())
                .then(|| Signs { values: Kernel::new(Levels::One, parameters), positive: positive.len() }),
            always: always.margins(),
            undivided: undivided.margins(),
            vanishing: Kernel { levels: Levels::One, routines: all.iter().map(|pole| vec![pole.enclosable]).collect() },
            all,
        })
    }
}

impl<K> Poles<K> {
    /// Marks the poles at which a mass matrix is singular, by what vanishes there.
    pub(super) fn mark_mass(&mut self, divisors: &[Id]) {
        for pole in &mut self.all {
            pole.of_mass = divisors.contains(&pole.term) || divisors.contains(&pole.vanishes);
        }
    }

    pub(super) fn map<L>(self, of: &mut impl FnMut(K) -> L) -> Poles<L> {
        Poles {
            all: self.all,
            signs: self.signs.map(|signs| Signs { values: of(signs.values), positive: signs.positive }),
            always: self.always.map(|margins| margins.map(of)),
            undivided: self.undivided.map(|margins| margins.map(of)),
            vanishing: of(self.vanishing),
        }
    }
}

impl<K> Margins<K> {
    fn map<L>(self, of: &mut impl FnMut(K) -> L) -> Margins<L> {
        Margins { values: of(self.values), count: self.count, margins: self.margins }
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
        let routines = all.iter().map(|jump| vec![jump.side, height(jump)]).collect();
        (!all.is_empty()).then(|| Jumps {
            sides: Kernel::new(Levels::One, all.iter().map(|jump| jump.side).collect()),
            heights: Kernel { levels: Levels::One, routines },
            edge: energies
                .iter()
                .find_map(|energy| crossings::edges_of_jumps(graph, *energy).first().map(|edge| edge.equal)),
            all,
        })
    }
}

impl<K> Jumps<K> {
    pub(super) fn map<L>(self, of: &mut impl FnMut(K) -> L) -> Jumps<L> {
        Jumps { all: self.all, sides: of(self.sides), heights: of(self.heights), edge: self.edge }
    }
}
