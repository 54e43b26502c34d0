//! Decides whether functions vanish on the boundary of a comparison, and whether solutions stay on it. The boundary is the surface on which both
//! sides of the comparison are equal.

use super::{Identity, OpenBoundaries, derivative, identity, rounding, sum_is_zero, sum_is_zero_off, vanishes};
use crate::diff;
use crate::ir::substitute::{Substitution, replaced};
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Relation, Symbol};

/// Decides whether Σ terms is zero along all solutions of x' = f(x, t).
///
/// A solution that leaves a boundary at once meets it at single instants. The sum may have any value there: `0 < x` and `0 ≤ x` differ at
/// such an instant.
pub(super) fn sum_is_zero_along(graph: &mut Graph, terms: &[Id], x: &[Symbol], field: &[Id]) -> Identity {
    let verdict = sum_is_zero(graph, terms);
    if verdict.is_zero() {
        return verdict;
    }
    let open = open_boundaries(graph, terms, x, field);
    if open.is_empty() { verdict } else { sum_is_zero_off(graph, terms, &open) }
}

/// Returns the comparisons and signs in `terms` whose boundary every solution leaves at once.
fn open_boundaries(graph: &mut Graph, terms: &[Id], x: &[Symbol], field: &[Id]) -> OpenBoundaries {
    let mut open = OpenBoundaries::default();
    for node in graph.reachable(terms) {
        let difference = match *graph.node(node) {
            Node::Compare(Relation::Less | Relation::LessEqual, a, b) => graph.sub(b, a),
            Node::Call(Function::Signum, ref args) => args[0],
            _ => continue,
        };
        if is_left(graph, difference, x, field) {
            open.insert(node);
        }
    }
    open
}

/// Returns whether solutions leave the surface `difference` = 0. Floating point has to show it on all parts of the surface.
fn is_left(graph: &mut Graph, difference: Id, x: &[Symbol], field: &[Id]) -> bool {
    let terms = diff::derivative_along(graph, x, field, difference, None);
    let rate = graph.sum(&terms);
    let moves = |symbol: &Symbol| x.contains(symbol) || *symbol == Symbol::Time;
    let moving: Vec<Symbol> = graph.symbols(difference).into_iter().filter(moves).collect();
    moving.into_iter().any(|symbol| {
        let Some(Solved { roots, coefficient }) = solved(graph, difference, symbol) else { return false };
        let has_other_parts = graph.symbols(coefficient).iter().any(moves);
        !has_other_parts
            && roots.into_iter().all(|root| {
                let there = replaced(graph, rate, symbol, root);
                rounding::differs_everywhere(graph, there)
            })
    })
}

/// Returns whether a node was proven to be zero on all parts of the surface `edge` = 0.
pub(super) fn vanishes_on(graph: &mut Graph, edge: Id, node: Id) -> bool {
    vanishes(graph, node)
        || parts(graph, edge).into_iter().all(|part| {
            vanishes_by_term(graph, part, node)
                // The equation may also hold where a coefficient that moves is zero.
                || vanishes_at_roots(graph, part, node, |graph, solved| !graph.reads_any(solved.coefficient, moves))
        })
}

/// Returns whether a node was proven to be zero on a part of the surface `edge` = 0.
pub(super) fn vanishes_on_a_part(graph: &mut Graph, edge: Id, node: Id) -> bool {
    vanishes(graph, node) || vanishes_by_term(graph, edge, node) || vanishes_at_roots(graph, edge, node, |_, _| true)
}

/// Returns whether a node was shown to differ from zero on the surface `edge` = 0: at a point of each of its solutions for one symbol.
pub(super) fn differs_on(graph: &mut Graph, edge: Id, node: Id) -> bool {
    let symbols = graph.symbols(edge);
    symbols.into_iter().filter(|symbol| moves(*symbol)).any(|symbol| {
        let Some(solved) = solved(graph, edge, symbol) else { return false };
        solved.roots.into_iter().all(|root| {
            let there = replaced(graph, node, symbol, root);
            matches!(identity(graph, there), Identity::Wrong(_))
        })
    })
}

/// Returns the factors of an edge. The surface consists of their zeros. Factors of parameters alone are omitted: where one is zero, the edge is zero
/// at every state, and no solution crosses it.
pub(super) fn parts(graph: &Graph, edge: Id) -> Vec<Id> {
    let (_, without_number) = graph.coefficient(edge);
    let may_vanish =
        |(base, exponent): (Id, Ratio)| (exponent > Ratio::ZERO && graph.reads_any(base, moves)).then_some(base);
    graph.factors(without_number).into_iter().filter_map(may_vanish).collect()
}

/// Returns whether a symbol may change during a run.
pub(super) fn moves(symbol: Symbol) -> bool {
    !matches!(symbol, Symbol::Parameter(_))
}

/// Returns whether a node is zero after one term of the edge is replaced by its value on the surface.
fn vanishes_by_term(graph: &mut Graph, edge: Id, node: Id) -> bool {
    let terms = match graph.node(edge) {
        Node::Linear(_, terms) => terms.clone(),
        _ => vec![(Number::ONE, edge)],
    };
    terms.into_iter().any(|(coefficient, term)| {
        let own = graph.scale(coefficient, term);
        let rest = graph.sub(edge, own);
        let coefficient = graph.number(coefficient.neg());
        let value = graph.div(rest, coefficient);
        let mut there = Substitution::new(|_: &mut Graph, _| None);
        there.insert(term, value);
        let there = there.apply(graph, node);
        vanishes(graph, there)
    })
}

/// Returns whether a node is zero after one symbol is replaced by each of its values on the surface. `accepts` selects the solutions that may be used.
fn vanishes_at_roots(graph: &mut Graph, edge: Id, node: Id, accepts: impl Fn(&Graph, &Solved) -> bool) -> bool {
    graph.symbols(edge).into_iter().any(|symbol| {
        let Some(solved) = solved(graph, edge, symbol).filter(|solved| accepts(graph, solved)) else { return false };
        solved.roots.into_iter().all(|root| {
            let there = replaced(graph, node, symbol, root);
            vanishes(graph, there)
        })
    })
}

/// Solutions of an equation for one symbol.
struct Solved {
    roots: Vec<Id>,
    /// The coefficient of the symbol. The equation may also hold where the coefficient is zero.
    coefficient: Id,
}

/// Solves c·symbol + d = 0 or c·symbol² + d = 0 for the symbol.
fn solved(graph: &mut Graph, sum: Id, symbol: Symbol) -> Option<Solved> {
    let zero = graph.zero();
    let rest = replaced(graph, sum, symbol, zero);
    let slope = derivative(graph, sum, symbol);
    let reads = |graph: &Graph, node: Id| graph.symbols(node).contains(&symbol);
    let is_quadratic = reads(graph, slope);
    let coefficient = if is_quadratic {
        let second = derivative(graph, slope, symbol);
        let at_zero = replaced(graph, slope, symbol, zero);
        if reads(graph, second) || !graph.is_zero(at_zero) {
            return None;
        }
        graph.scale(Number::HALF, second)
    } else {
        slope
    };
    let power = graph.div(rest, coefficient);
    let power = graph.neg(power);
    let roots = if is_quadratic {
        let root = graph.pow(power, Ratio::HALF);
        vec![root, graph.neg(root)]
    } else {
        vec![power]
    };
    Some(Solved { roots, coefficient })
}
