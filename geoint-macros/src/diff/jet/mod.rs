//! The Taylor coefficients of a solution x' = f(x, t): a program that is run once for every order.
//!
//! A coefficient is no expression of the graph, so this derivation makes no nodes for coefficients: it makes a series of each node
//! that f is built of, with the recurrence that gives its coefficient of order n from coefficients of operands up to n and its own
//! up to n − 1. Coefficients of order 0 are values of nodes, and are scheduled as all values are.
//!
//! Coefficients are normalised: u⁽ⁿ⁾/n!.

mod factored;
mod lanes;
mod rules;

pub(crate) use lanes::{LANES, Lanes, Operand, Weight, sums};

use crate::analyze::Reads;
use crate::ir::{Graph, HashMap, Id, Node, Number, Symbol};
use std::collections::VecDeque;

/// A number of a step, by its place among the values at the start.
pub(crate) type Value = usize;

/// The coefficients of a series of this program.
pub(crate) type Source = usize;

/// What a coefficient is multiplied by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Factor {
    Number(Number),
    Value(Value),
}

/// How the coefficient of order n ≥ 1 follows. In comments y is the series itself, and a sum runs over j.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Rule {
    /// A coordinate: its rate of order n − 1, over n.
    State(Symbol),
    /// A function a + b·t: b at n = 1, zero beyond.
    Affine(Value),
    /// Σ factor·u.
    Linear(Vec<(Factor, Source)>),
    /// Σ uⱼwₙ₋ⱼ; the second factor is known last.
    Product(Source, Source),
    /// (a + b·t)·u.
    Shift {
        start: Value,
        slope: Value,
        of: Source,
    },
    Square(Source),
    /// y·w = u.
    Quotient(Source, Source),
    /// y·w = 1.
    Reciprocal(Source),
    /// y² = u.
    Root(Source),
    /// y'·u = α·y·u'.
    Power(Source, Factor),
    /// y' = k·d·u', with d up to the order n − 1.
    Integral {
        factor: Number,
        by: Source,
        of: Source,
    },
    /// The same for u = a + b·t.
    Wave {
        factor: Number,
        slope: Value,
        by: Source,
    },
    /// y'·d = k·u', with d up to the order n − 1.
    Quadrature {
        factor: Number,
        of: Source,
        over: Source,
    },
    /// r²·y' = x·y₂' − y₂·x': the angle of (x, y₂).
    Angle {
        y: Source,
        x: Source,
        square: Source,
    },
    /// One of two, where nothing is zero, by a condition at the start.
    Select(Value, Option<Source>, Option<Source>),
}

/// A series.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    pub(crate) rule: Rule,
    /// Its value at the start.
    pub(crate) value: Value,
    /// Whether coefficients of lower orders are read.
    pub(crate) kept: bool,
    /// Whether j·uⱼ are read.
    pub(crate) weighted: bool,
    /// Whether the coefficient of the order before is read by itself.
    pub(crate) before: bool,
}

/// The rate of a coordinate: its value at the start, and its series if it is not constant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rate {
    pub(crate) symbol: Symbol,
    pub(crate) value: Value,
    pub(crate) source: Option<Source>,
}

/// A program.
#[derive(Clone, Debug, Default)]
pub(crate) struct Jet {
    pub(crate) series: Vec<Series>,
    /// In this order coefficients of one order are computed.
    pub(crate) order: Vec<Source>,
    pub(crate) rates: Vec<Rate>,
    /// What is computed at the start: numbers, and conditions.
    pub(crate) values: Vec<Id>,
    /// Which of them are conditions.
    pub(crate) conditions: Vec<Value>,
    /// What decides a condition by its sign.
    pub(crate) switches: Vec<(Value, Option<Source>)>,
}

impl Rule {
    /// The series whose coefficients of the same order are read.
    fn now(&self) -> Vec<Source> {
        match self {
            Rule::State(_) | Rule::Affine(_) | Rule::Wave { .. } => vec![],
            Rule::Linear(terms) => terms.iter().map(|(_, source)| *source).collect(),
            Rule::Product(a, b) | Rule::Quotient(a, b) => vec![*a, *b],
            Rule::Shift { of, .. } | Rule::Integral { of, .. } | Rule::Quadrature { of, .. } => vec![*of],
            Rule::Square(a) | Rule::Reciprocal(a) | Rule::Root(a) | Rule::Power(a, _) => vec![*a],
            Rule::Angle { y, x, square } => vec![*y, *x, *square],
            Rule::Select(_, a, b) => a.iter().chain(b).copied().collect(),
        }
    }

    /// The series whose coefficients of lower orders are read in sums, itself excepted.
    fn in_sums(&self) -> Vec<Source> {
        match self {
            Rule::State(_) | Rule::Affine(_) | Rule::Linear(_) | Rule::Select(..) | Rule::Root(_) => vec![],
            Rule::Product(a, b) => vec![*a, *b],
            Rule::Quotient(_, b) => vec![*b],
            Rule::Square(a) | Rule::Reciprocal(a) | Rule::Power(a, _) => vec![*a],
            Rule::Shift { .. } | Rule::Wave { .. } => vec![],
            Rule::Integral { by, .. } => vec![*by],
            Rule::Quadrature { over, .. } => vec![*over],
            Rule::Angle { y, x, square } => vec![*y, *x, *square],
        }
    }

    /// The series whose coefficients are read with their orders as factors.
    fn weighted(&self) -> Vec<Source> {
        match self {
            Rule::Integral { of, .. } => vec![*of],
            Rule::Angle { y, x, .. } => vec![*y, *x],
            _ => vec![],
        }
    }

    /// Whether it reads its own coefficients, and whether with orders as factors.
    fn own(&self) -> (bool, bool) {
        match self {
            Rule::Quotient(..) | Rule::Reciprocal(_) | Rule::Root(_) | Rule::Power(..) => (true, false),
            Rule::Quadrature { .. } | Rule::Angle { .. } => (false, true),
            _ => (false, false),
        }
    }

    /// Sums of n terms in the coefficient of order n, in halves.
    pub(crate) fn half_convolutions(&self) -> usize {
        match self {
            Rule::State(_)
            | Rule::Affine(_)
            | Rule::Linear(_)
            | Rule::Shift { .. }
            | Rule::Wave { .. }
            | Rule::Select(..) => 0,
            Rule::Square(_) | Rule::Root(_) => 1,
            Rule::Product(..)
            | Rule::Quotient(..)
            | Rule::Reciprocal(_)
            | Rule::Integral { .. }
            | Rule::Quadrature { .. } => 2,
            Rule::Power(..) => 4,
            Rule::Angle { .. } => 6,
        }
    }
}

impl Jet {
    /// Sums of n terms in all coefficients of order n.
    pub(crate) fn convolutions(&self) -> usize {
        self.series.iter().map(|series| series.rule.half_convolutions()).sum::<usize>().div_ceil(2)
    }
}

/// The program for coordinates by their rates.
pub(crate) fn jet(graph: &mut Graph, rates: &[(Symbol, Id)]) -> Jet {
    let roots: Vec<Id> = rates.iter().map(|(_, rate)| *rate).collect();
    let mut uses = HashMap::default();
    for id in graph.reachable(&roots) {
        graph.node(id).for_each_child(|child| *uses.entry(child).or_insert(0) += 1);
    }
    let mut builder = Builder {
        graph,
        uses,
        known: Known::default(),
        jet: Jet::default(),
        sources: HashMap::default(),
        values: HashMap::default(),
        open: VecDeque::new(),
    };
    for (symbol, rate) in rates {
        let (value, source) = (builder.value(*rate), builder.source(*rate));
        builder.jet.rates.push(Rate { symbol: *symbol, value, source });
    }
    builder.close();
    builder.jet
}

/// What is known of nodes.
#[derive(Default)]
struct Known {
    reads: Vec<Reads>,
    /// How many multiplications of series a coefficient waits for.
    depth: Vec<u32>,
}

impl Known {
    /// Includes nodes that are new.
    fn update(&mut self, graph: &Graph) {
        for id in graph.ids().skip(self.reads.len()) {
            let node = graph.node(id);
            let (mut reads, mut depth) = (Reads::default(), 0);
            if let Node::Symbol(symbol) = node {
                reads = Reads::of(*symbol);
            }
            node.for_each_child(|child| {
                reads = reads.or(self.reads[child.index()]);
                depth = depth.max(self.depth[child.index()]);
            });
            let multiplies = matches!(node, Node::Product(_) | Node::Power(..) | Node::Call(..));
            self.reads.push(reads);
            self.depth.push(depth + u32::from(multiplies));
        }
    }
}

struct Builder<'a> {
    graph: &'a mut Graph,
    uses: HashMap<Id, usize>,
    known: Known,
    jet: Jet,
    sources: HashMap<Id, Source>,
    values: HashMap<Id, Value>,
    /// Series that have a number but no place in the order yet.
    open: VecDeque<Source>,
}

impl Builder<'_> {
    fn reads(&mut self, id: Id) -> Reads {
        self.known.update(self.graph);
        self.known.reads[id.index()]
    }

    fn depth(&mut self, id: Id) -> u32 {
        self.known.update(self.graph);
        self.known.depth[id.index()]
    }

    /// Whether a node is a number in a step.
    fn is_constant(&mut self, id: Id) -> bool {
        let reads = self.reads(id);
        !(reads.state() || reads.t)
    }

    /// A value at the start.
    fn value(&mut self, id: Id) -> Value {
        let next = self.jet.values.len();
        *self.values.entry(id).or_insert_with(|| {
            self.jet.values.push(id);
            next
        })
    }

    /// The series of a node that is no number.
    fn source(&mut self, id: Id) -> Option<Source> {
        (!self.is_constant(id)).then(|| self.series(id))
    }

    fn series(&mut self, id: Id) -> Source {
        if let Some(source) = self.sources.get(&id) {
            return *source;
        }
        let value = self.value(id);
        let source = self.jet.series.len();
        self.sources.insert(id, source);
        // A place, so that what reads it knows its number.
        self.jet.series.push(Series { rule: Rule::Linear(vec![]), value, kept: false, weighted: false, before: false });
        self.open.push_back(source);
        source
    }

    /// Gives every series that is asked for its rule, then the order.
    fn close(&mut self) {
        while let Some(source) = self.open.pop_front() {
            let id = self.jet.values[self.jet.series[source].value];
            self.jet.series[source].rule = self.rule(id);
        }
        self.order();
        let rules: Vec<Rule> = self.jet.series.iter().map(|series| series.rule.clone()).collect();
        for (source, rule) in rules.iter().enumerate() {
            let (kept, weighted) = rule.own();
            self.jet.series[source].kept |= kept || matches!(rule, Rule::State(_));
            self.jet.series[source].weighted |= weighted;
            rule.in_sums().into_iter().for_each(|read| self.jet.series[read].kept = true);
            if let Rule::Shift { of: read, .. } | Rule::Wave { by: read, .. } = rule {
                self.jet.series[*read].before = true;
            }
            rule.weighted().into_iter().for_each(|read| self.jet.series[read].weighted = true);
        }
    }

    /// Operands of the same order first.
    fn order(&mut self) {
        let mut state = vec![0; self.jet.series.len()];
        for root in 0..state.len() {
            let mut open = vec![root];
            while let Some(source) = open.pop() {
                match state[source] {
                    0 => {
                        state[source] = 1;
                        open.push(source);
                        open.extend(self.jet.series[source].rule.now().into_iter().filter(|read| state[*read] == 0));
                    }
                    1 => {
                        state[source] = 2;
                        self.jet.order.push(source);
                    }
                    _ => {}
                }
            }
        }
    }
}
