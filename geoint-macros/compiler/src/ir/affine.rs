//! Rewrites expressions that are affine in one symbol as rest + slope·symbol. The rest is computed before the symbol is known.

use super::{Graph, Id, Node, Symbol, Table};

/// The length of the chain of operations from the symbol to rest + slope·symbol.
const LENGTH_OF_AFFINE_FORM: u32 = 2;

/// A cache of affine forms. `moves` selects the symbols that are known last.
pub(crate) struct AffineForms<F> {
    moves: F,
    known: Table<Kind>,
}

/// The dependence of a node on the moving symbols.
#[derive(Clone, Copy)]
enum Kind {
    /// The node reads no moving symbol.
    Fixed,
    Affine(Affine),
    Other,
}

/// The node rest + slope·symbol.
#[derive(Clone, Copy)]
struct Affine {
    symbol: Id,
    slope: Id,
    rest: Id,
    /// The length of the chain of operations from the symbol to the node, as it was written.
    length: u32,
}

impl<F: Fn(Symbol) -> bool> AffineForms<F> {
    /// Creates an empty cache.
    pub(crate) fn new(moves: F) -> Self {
        AffineForms { moves, known: Table::default() }
    }

    /// Rewrites an expression that is affine in a moving symbol, if this shortens the chain of operations that depend on the symbol. The result
    /// rounds differently. Use it for Newton's matrix only.
    pub(crate) fn shortened(&mut self, graph: &mut Graph, root: Id) -> Id {
        for id in graph.unknown(root, &self.known) {
            let kind = self.kind(graph, id);
            self.known.insert(id, kind);
        }
        match self.known[root] {
            Kind::Affine(Affine { symbol, slope, rest, length }) if length > LENGTH_OF_AFFINE_FORM => {
                let product = graph.mul(slope, symbol);
                graph.sum(&[rest, product])
            }
            _ => root,
        }
    }

    /// Derives the dependence of a node from its operands.
    fn kind(&self, graph: &mut Graph, id: Id) -> Kind {
        let mut fixed = true;
        graph.node(id).for_each_child(|child| fixed &= matches!(self.known[child], Kind::Fixed));
        match graph.node(id).clone() {
            Node::Symbol(symbol) if (self.moves)(symbol) => {
                let (slope, rest) = (graph.integer(1), graph.zero());
                Kind::Affine(Affine { symbol: id, slope, rest, length: 0 })
            }
            _ if fixed => Kind::Fixed,
            Node::Linear(constant, terms) => {
                let (mut slopes, mut rests, mut longest) = (vec![], vec![graph.number(constant)], 0);
                let mut common = None;
                for (c, term) in &terms {
                    let (slope, rest) = match self.known[*term] {
                        Kind::Fixed => (None, *term),
                        Kind::Affine(of) if common.is_none_or(|symbol| symbol == of.symbol) => {
                            common = Some(of.symbol);
                            longest = longest.max(of.length);
                            (Some(of.slope), of.rest)
                        }
                        _ => return Kind::Other,
                    };
                    slopes.extend(slope.map(|slope| graph.scale(*c, slope)));
                    rests.push(graph.scale(*c, rest));
                }
                let length = longest + u32::from(terms.len() > 1 || !constant.is_zero());
                let Some(symbol) = common else { return Kind::Fixed };
                Kind::Affine(Affine { symbol, slope: graph.sum(&slopes), rest: graph.sum(&rests), length })
            }
            Node::Product(factors) => {
                let is_fixed = |factor: &Id| matches!(self.known[*factor], Kind::Fixed);
                let (others, moving): (Vec<Id>, Vec<Id>) = factors.into_iter().partition(is_fixed);
                let [moving] = moving[..] else { return Kind::Other };
                let Kind::Affine(of) = self.known[moving] else { return Kind::Other };
                let others = graph.product(&others);
                let (slope, rest) = (graph.mul(others, of.slope), graph.mul(others, of.rest));
                Kind::Affine(Affine { slope, rest, length: of.length + 1, ..of })
            }
            _ => Kind::Other,
        }
    }
}
