//! The Taylor coefficients of a solution of x' = f(x, t), as a program that runs once for every order.
//!
//! Each node of f becomes a series. A recurrence gives its coefficient of order n from the coefficients of its operands up to order n, and from its
//! own coefficients up to order n − 1. Coefficients are no nodes of the graph, except for order 0: these are values of nodes, scheduled like all values.
//!
//! Coefficients are normalised: u⁽ⁿ⁾/n!.

mod factored;
mod functions;
mod packs;
mod program;
mod rules;
mod scaled;

pub(crate) use packs::{Central, LANES, Operand, Packs, Sum, Weight, sums};
pub(crate) use program::{Factor, Jet, Rate, Rule, Series, Source, Value};

use crate::ir::{Graph, HashMap, Id, Node, Number, Symbol};
use std::collections::{HashSet, VecDeque};

/// Builds the program from the rates of coordinates. The signs of the `checked` nodes decide about branches, as conditions do.
pub(crate) fn jet(graph: &mut Graph, rates: &[(Symbol, Id)], checked: &[Id]) -> Jet {
    let roots: Vec<Id> = rates.iter().map(|(_, rate)| *rate).chain(checked.iter().copied()).collect();
    let resting = rates.iter().filter(|(_, rate)| graph.is_zero(*rate)).map(|(symbol, _)| *symbol).collect();
    let mut builder = Builder {
        graph,
        resting: Resting(resting),
        uses: HashMap::default(),
        alone: HashSet::default(),
        depths: Depths::default(),
        jet: Jet::default(),
        sources: HashMap::default(),
        values: HashMap::default(),
        open: VecDeque::new(),
    };
    builder.count_uses(&roots);
    for (symbol, rate) in rates {
        let (value, source) = (builder.value(*rate), builder.source(*rate));
        builder.jet.rates.push(Rate { symbol: *symbol, value, source });
    }
    for id in checked {
        builder.add_switch(*id);
    }
    builder.complete();
    builder.jet
}

/// The longest chain of multiplications of series before the coefficient of each node.
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

/// The constant coordinates, for example momenta of cyclic coordinates.
struct Resting(Vec<Symbol>);

impl Resting {
    /// Returns whether a node is constant along solutions.
    fn is_constant(&self, graph: &Graph, id: Id) -> bool {
        let reads = graph.reads(id);
        let rests = |symbol: &Symbol| matches!(symbol, Symbol::Parameter(_)) || self.0.contains(symbol);
        !reads.moves() || !self.0.is_empty() && !reads.t && graph.symbols(id).iter().all(rests)
    }
}

/// The terms of a sum up to sign: the first coefficient is made positive.
fn up_to_sign(terms: &[(Number, Id)]) -> Vec<(Number, Id)> {
    let negative = terms.first().is_some_and(|(c, _)| c.is_negative());
    terms.iter().map(|(c, term)| (if negative { c.neg() } else { *c }, *term)).collect()
}

/// The state of the construction of a program.
struct Builder<'a> {
    graph: &'a mut Graph,
    resting: Resting,
    /// How often each node is read.
    uses: HashMap<Id, usize>,
    /// Nodes that are read, themselves or as a multiple, outside of products with another node that moves.
    alone: HashSet<Id>,
    depths: Depths,
    jet: Jet,
    sources: HashMap<Id, Source>,
    values: HashMap<Id, Value>,
    /// Series without a rule yet.
    open: VecDeque<Source>,
}

impl Builder<'_> {
    /// Fills `uses` and `alone`.
    fn count_uses(&mut self, roots: &[Id]) {
        let mut sums = HashSet::new();
        self.alone.extend(roots);
        for id in self.graph.reachable(roots).into_iter().rev() {
            let node = self.graph.node(id).clone();
            let moving = node.children().into_iter().filter(|child| !self.is_constant(*child)).count();
            let alone = match &node {
                // A sum and its negative count as one sum.
                Node::Linear(_, terms) if moving > 1 && !sums.insert(up_to_sign(terms)) => continue,
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

    /// Returns whether a node is constant during a step.
    fn is_constant(&self, id: Id) -> bool {
        self.resting.is_constant(self.graph, id)
    }

    /// The index of the value of a node at the start of a step.
    fn value(&mut self, id: Id) -> Value {
        let next = self.jet.values.len();
        *self.values.entry(id).or_insert_with(|| {
            self.jet.values.push(id);
            next
        })
    }

    /// The series of a node, or `None` if it is constant.
    fn source(&mut self, id: Id) -> Option<Source> {
        (!self.is_constant(id)).then(|| self.series(id))
    }

    /// The series of a node. Its rule follows later.
    fn series(&mut self, id: Id) -> Source {
        if let Some(source) = self.sources.get(&id) {
            return *source;
        }
        let value = self.value(id);
        let source = self.jet.series.len();
        self.sources.insert(id, source);
        // A placeholder, so that readers can refer to the series.
        self.jet.series.push(Series { rule: Rule::Linear(vec![]), value, kept: false, weighted: false, before: false });
        self.open.push_back(source);
        source
    }

    /// Adds the rule of every series, then the order of evaluation.
    fn complete(&mut self) {
        while let Some(source) = self.open.pop_front() {
            let id = self.jet.values[self.jet.series[source].value];
            self.jet.series[source].rule = self.rule(id);
        }
        self.scale_powers();
        self.order();
        let rules: Vec<Rule> = self.jet.series.iter().map(|series| series.rule.clone()).collect();
        for (source, rule) in rules.iter().enumerate() {
            self.jet.series[source].kept |= matches!(rule, Rule::State(_));
            if let Rule::Shift { of: read, .. } | Rule::Wave { by: read, .. } = rule {
                self.jet.series[*read].before = true;
            }
            for Operand { source, weighted } in sums(rule, source).into_iter().flat_map(|sum| sum.operands) {
                let series = &mut self.jet.series[source];
                if weighted {
                    series.weighted = true;
                } else {
                    series.kept = true;
                }
            }
        }
    }

    /// Orders the series, with operands of the same order first.
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
