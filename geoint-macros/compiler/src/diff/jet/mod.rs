//! The Taylor coefficients of a solution x' = f(x, t): a program that is run once for every order.
//!
//! A coefficient is no expression of the graph, so this derivation makes no nodes for coefficients: it makes a series of each node
//! that f is built of, with the recurrence that gives its coefficient of order n from coefficients of operands up to n and its own
//! up to n − 1. Coefficients of order 0 are values of nodes, and are scheduled as all values are.
//!
//! Coefficients are normalised: u⁽ⁿ⁾/n!.

mod factored;
mod functions;
mod lanes;
mod program;
mod rules;
mod scaled;

pub(crate) use lanes::{Central, LANES, Lanes, Operand, Sum, Weight, sums};
pub(crate) use program::{Factor, Jet, Rate, Rule, Series, Source, Value};

use crate::ir::{Graph, HashMap, Id, Node, Number, Symbol};
use std::collections::{HashSet, VecDeque};

/// The program for coordinates by their rates; the signs of what is `watched` decide as conditions do.
pub(crate) fn jet(graph: &mut Graph, rates: &[(Symbol, Id)], watched: &[Id]) -> Jet {
    let roots: Vec<Id> = rates.iter().map(|(_, rate)| *rate).chain(watched.iter().copied()).collect();
    let resting = rates.iter().filter(|(_, rate)| graph.is_zero(*rate)).map(|(symbol, _)| *symbol).collect();
    let resting = Resting(resting);
    let mut builder = Builder {
        graph,
        resting,
        uses: HashMap::default(),
        alone: HashSet::default(),
        depths: Depths::default(),
        jet: Jet::default(),
        sources: HashMap::default(),
        values: HashMap::default(),
        open: VecDeque::new(),
    };
    builder.look(&roots);
    for (symbol, rate) in rates {
        let (value, source) = (builder.value(*rate), builder.source(*rate));
        builder.jet.rates.push(Rate { symbol: *symbol, value, source });
    }
    for id in watched {
        builder.decides(*id);
    }
    builder.close();
    builder.jet
}

/// How many multiplications of series the coefficient of each node waits for.
#[derive(Default)]
struct Depths(Vec<u32>);

impl Depths {
    fn of(&mut self, graph: &Graph, id: Id) -> u32 {
        for id in graph.ids_from(self.0.len()) {
            let node = graph.node(id);
            let mut depth = 0;
            node.for_each_child(|child| depth = depth.max(self.0[child.index()]));
            let multiplies = matches!(node, Node::Product(_) | Node::Power(..) | Node::Call(..));
            self.0.push(depth + u32::from(multiplies));
        }
        self.0[id.index()]
    }
}

/// The coordinates that stand still, as the momenta of cyclic ones.
struct Resting(Vec<Symbol>);

impl Resting {
    fn is_constant(&self, graph: &Graph, id: Id) -> bool {
        let reads = graph.reads(id);
        let rests = |symbol: &Symbol| matches!(symbol, Symbol::Parameter(_)) || self.0.contains(symbol);
        !reads.moves() || !self.0.is_empty() && !reads.t && graph.symbols(id).iter().all(rests)
    }
}

/// Terms, with the first one positive.
fn of_either_sign(terms: &[(Number, Id)]) -> Vec<(Number, Id)> {
    let negative = terms.first().is_some_and(|(c, _)| c.is_negative());
    terms.iter().map(|(c, term)| (if negative { c.neg() } else { *c }, *term)).collect()
}

struct Builder<'a> {
    graph: &'a mut Graph,
    resting: Resting,
    uses: HashMap<Id, usize>,
    /// What something reads other than in products with something else that moves, it or a multiple of it.
    alone: HashSet<Id>,
    depths: Depths,
    jet: Jet,
    sources: HashMap<Id, Source>,
    values: HashMap<Id, Value>,
    /// Series that have a number but no place in the order yet.
    open: VecDeque<Source>,
}

impl Builder<'_> {
    /// What is read, how often, and how.
    fn look(&mut self, roots: &[Id]) {
        let mut sums = HashSet::new();
        self.alone.extend(roots);
        for id in self.graph.reachable(roots).into_iter().rev() {
            let node = self.graph.node(id).clone();
            let moving = node.children().into_iter().filter(|child| !self.is_constant(*child)).count();
            let alone = match &node {
                // A sum with the other sign is the same sum.
                Node::Linear(_, terms) if moving > 1 && !sums.insert(of_either_sign(terms)) => continue,
                Node::Product(_) => moving == 1 && self.alone.contains(&id),
                Node::Linear(constant, terms) if constant.is_zero() && terms.len() == 1 => self.alone.contains(&id),
                _ => true,
            };
            node.for_each_child(|child| {
                *self.uses.entry(child).or_insert(0) += 1;
                if alone {
                    let (_, child) = self.parted(child);
                    self.alone.insert(child);
                }
            });
        }
    }

    fn depth(&mut self, id: Id) -> u32 {
        self.depths.of(self.graph, id)
    }

    /// Whether a node is a number in a step.
    fn is_constant(&self, id: Id) -> bool {
        self.resting.is_constant(self.graph, id)
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
        self.scale_powers();
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
