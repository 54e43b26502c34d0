//! Expressions that are straight lines in one symbol, written as such: rest + slope·symbol, where the rest is known before the symbol is.

use super::{Graph, Id, Node, Symbol, Table};

/// Operations from the symbol to the end of rest + slope·symbol.
const OF_A_LINE: u32 = 2;

/// What is known of nodes: whether each is a line along one of the symbols that move.
pub(crate) struct Lines<F> {
    moves: F,
    known: Table<Kind>,
}

#[derive(Clone, Copy)]
enum Kind {
    /// It reads no symbol that moves.
    Fixed,
    Line(Line),
    Other,
}

#[derive(Clone, Copy)]
struct Line {
    along: Id,
    slope: Id,
    rest: Id,
    /// So many operations follow each other, from the symbol to here, as it is written.
    operations: u32,
}

impl<F: Fn(Symbol) -> bool> Lines<F> {
    pub(crate) fn new(moves: F) -> Self {
        Lines { moves, known: Table::default() }
    }

    /// The same value as a line, if it is one, and what waits for the symbol takes more operations as it is written. Rounded otherwise: it is meant for
    /// Newton's matrix.
    pub(crate) fn straightened(&mut self, graph: &mut Graph, root: Id) -> Id {
        for id in graph.unknown(root, &self.known) {
            let kind = self.kind(graph, id);
            self.known.insert(id, kind);
        }
        match self.known[root] {
            Kind::Line(Line { along, slope, rest, operations }) if operations > OF_A_LINE => {
                let product = graph.mul(slope, along);
                graph.sum(&[rest, product])
            }
            _ => root,
        }
    }

    fn kind(&self, graph: &mut Graph, id: Id) -> Kind {
        let mut fixed = true;
        graph.node(id).for_each_child(|child| fixed &= matches!(self.known[child], Kind::Fixed));
        match graph.node(id).clone() {
            Node::Symbol(symbol) if (self.moves)(symbol) => {
                let (slope, rest) = (graph.integer(1), graph.zero());
                Kind::Line(Line { along: id, slope, rest, operations: 0 })
            }
            _ if fixed => Kind::Fixed,
            Node::Linear(constant, terms) => {
                let (mut slopes, mut rests, mut longest) = (vec![], vec![graph.number(constant)], 0);
                let mut same = None;
                for (c, term) in &terms {
                    let (slope, rest) = match self.known[*term] {
                        Kind::Fixed => (None, *term),
                        Kind::Line(line) if same.is_none_or(|along| along == line.along) => {
                            same = Some(line.along);
                            longest = longest.max(line.operations);
                            (Some(line.slope), line.rest)
                        }
                        _ => return Kind::Other,
                    };
                    slopes.extend(slope.map(|slope| graph.scale(*c, slope)));
                    rests.push(graph.scale(*c, rest));
                }
                let operations = longest + u32::from(terms.len() > 1 || !constant.is_zero());
                match same {
                    Some(along) => {
                        Kind::Line(Line { along, slope: graph.sum(&slopes), rest: graph.sum(&rests), operations })
                    }
                    None => Kind::Fixed,
                }
            }
            Node::Product(factors) => {
                let is_fixed = |factor: &Id| matches!(self.known[*factor], Kind::Fixed);
                let (others, moving): (Vec<Id>, Vec<Id>) = factors.into_iter().partition(is_fixed);
                let [moving] = moving[..] else { return Kind::Other };
                let Kind::Line(line) = self.known[moving] else { return Kind::Other };
                let others = graph.product(&others);
                Kind::Line(Line {
                    slope: graph.mul(others, line.slope),
                    rest: graph.mul(others, line.rest),
                    operations: line.operations + 1,
                    ..line
                })
            }
            _ => Kind::Other,
        }
    }
}
