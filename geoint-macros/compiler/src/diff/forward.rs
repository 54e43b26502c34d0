//! Forward derivatives with respect to several symbols at once, for Hessians and Newton's matrices, or along one direction. Blocks of such matrices.

use super::rules::{Derivative, derivative};
use crate::ir::{Graph, Id, Node, Symbol, Table};
use std::rc::Rc;

/// The nonzero derivatives of a node, as pairs (column, derivative) in the order of columns.
type Row = Rc<[(usize, Id)]>;

/// Computes the derivatives ∂root/∂symbol, with one row for each root.
pub(crate) fn jacobian(graph: &mut Graph, roots: &[Id], symbols: &[Symbol]) -> Vec<Vec<Id>> {
    let one = graph.integer(1);
    let column = |symbol| symbols.iter().position(|other| *other == symbol).map(|column| (column, one));
    forward(graph, roots, &column, symbols.len())
}

/// Computes the derivatives of `roots` along `direction`, which returns the change of each symbol.
pub(crate) fn along(graph: &mut Graph, roots: &[Id], direction: impl Fn(Symbol) -> Option<Id>) -> Vec<Id> {
    forward(graph, roots, &|symbol| direction(symbol).map(|change| (0, change)), 1).concat()
}

/// Computes the terms of f·∇I + ∂I/∂t − b·∇I, where `but` is b, or 0 if absent. Their sum vanishes if dI/dt = b·∇I.
pub(crate) fn derivative_along(
    graph: &mut Graph,
    x: &[Symbol],
    field: &[Id],
    integral: Id,
    but: Option<&[Id]>,
) -> Vec<Id> {
    let all: Vec<Symbol> = x.iter().copied().chain([Symbol::Time]).collect();
    let gradient = jacobian(graph, &[integral], &all).remove(0);
    let mut terms: Vec<Id> = field.iter().zip(&gradient).map(|(f, slope)| graph.mul(*f, *slope)).collect();
    terms.extend(gradient.last());
    for (b, slope) in but.into_iter().flatten().zip(&gradient) {
        let product = graph.mul(*b, *slope);
        terms.push(graph.neg(product));
    }
    terms
}

/// The blocks of a symmetric matrix: sets of indices that nonzero entries couple, directly or through others.
pub(crate) fn blocks(graph: &Graph, matrix: &[Vec<Id>]) -> Vec<Vec<u32>> {
    let mut blocks: Vec<Vec<u32>> = vec![];
    for i in 0..matrix.len() {
        let coupled = |block: &Vec<u32>| block.iter().any(|j| !graph.is_zero(matrix[i][*j as usize]));
        let (mine, others): (Vec<_>, Vec<_>) = blocks.into_iter().partition(coupled);
        blocks = others;
        let mut block = mine.concat();
        block.push(i as u32);
        block.sort_unstable();
        blocks.push(block);
    }
    blocks.sort();
    blocks
}

/// The derivatives of `roots` by columns. `seed` returns the column and the change of a symbol.
fn forward(
    graph: &mut Graph,
    roots: &[Id],
    seed: &impl Fn(Symbol) -> Option<(usize, Id)>,
    columns: usize,
) -> Vec<Vec<Id>> {
    let mut rows: Table<usize> = Table::default();
    let mut all: Vec<Row> = vec![];
    for root in roots {
        for id in graph.unknown(*root, &rows) {
            let of = |id: Id| &all[rows[id]];
            let row = derivatives(graph, id, seed, of);
            rows.insert(id, all.len());
            all.push(row);
        }
    }
    let zero = graph.zero();
    let dense = |root: &Id| {
        let mut row = vec![zero; columns];
        all[rows[*root]].iter().for_each(|(column, derivative)| row[*column] = *derivative);
        row
    };
    roots.iter().map(dense).collect()
}

/// Computes the row of a node from the rows of its operands.
fn derivatives<'a>(
    graph: &mut Graph,
    id: Id,
    seed: &impl Fn(Symbol) -> Option<(usize, Id)>,
    of: impl Fn(Id) -> &'a Row,
) -> Row {
    if let Node::Symbol(symbol) = graph.node(id) {
        return seed(*symbol).filter(|(_, change)| !graph.is_zero(*change)).into_iter().collect();
    }
    let mut constant = true;
    graph.node(id).for_each_child(|operand| constant &= of(operand).is_empty());
    if constant {
        return Rc::new([]);
    }
    match derivative(graph, id) {
        Derivative::Chain(partials) => {
            let mut parts: Vec<(usize, Id)> = vec![];
            for (operand, partial) in partials {
                for (column, inner) in of(operand).iter() {
                    parts.push((*column, graph.mul(partial, *inner)));
                }
            }
            parts.sort_by_key(|(column, _)| *column);
            let mut row: Vec<(usize, Id)> = vec![];
            for chunk in parts.chunk_by(|a, b| a.0 == b.0) {
                let sum = match chunk {
                    [(_, part)] => *part,
                    _ => graph.sum(&chunk.iter().map(|(_, part)| *part).collect::<Vec<_>>()),
                };
                if !graph.is_zero(sum) {
                    row.push((chunk[0].0, sum));
                }
            }
            row.into()
        }
        Derivative::Branch(condition, first, second) => {
            let (first, second) = (of(first), of(second));
            let zero = graph.zero();
            let side = |row: &Row, column| row.iter().find(|(c, _)| *c == column).map_or(zero, |(_, id)| *id);
            let mut columns: Vec<usize> = first.iter().chain(second.iter()).map(|(column, _)| *column).collect();
            columns.sort_unstable();
            columns.dedup();
            let select = |column| (column, graph.select(condition, side(first, column), side(second, column)));
            columns.into_iter().map(select).collect()
        }
    }
}
