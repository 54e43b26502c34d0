//! Forward derivatives with respect to several symbols at once: Hessians and Newton's matrices, zeros left out.

use super::rules::{Rule, rule};
use crate::ir::{Graph, Id, Node, Symbol, Table};
use std::rc::Rc;

/// The derivatives of a node that are not zero, by column, in order.
type Row = Rc<[(usize, Id)]>;

/// ∂root/∂symbol, a row a root.
pub(crate) fn jacobian(graph: &mut Graph, roots: &[Id], symbols: &[Symbol]) -> Vec<Vec<Id>> {
    let mut rows: Table<usize> = Table::default();
    let mut all: Vec<Row> = vec![];
    for root in roots {
        for id in graph.unknown(*root, &rows) {
            let of = |id: Id| all[rows[id]].clone();
            let row = derivatives(graph, id, symbols, of);
            rows.insert(id, all.len());
            all.push(row);
        }
    }
    let zero = graph.zero();
    let dense = |root: &Id| {
        let mut row = vec![zero; symbols.len()];
        all[rows[*root]].iter().for_each(|(column, derivative)| row[*column] = *derivative);
        row
    };
    roots.iter().map(dense).collect()
}

/// The row of a node from the rows of its operands.
fn derivatives(graph: &mut Graph, id: Id, symbols: &[Symbol], of: impl Fn(Id) -> Row) -> Row {
    if let Node::Symbol(symbol) = graph.node(id) {
        let column = symbols.iter().position(|other| other == symbol);
        return column.map(|column| (column, graph.integer(1))).into_iter().collect();
    }
    if graph.node(id).children().iter().all(|operand| of(*operand).is_empty()) {
        return Rc::new([]);
    }
    match rule(graph, id) {
        Rule::Chain(partials) => {
            let mut parts: Vec<(usize, Id)> = vec![];
            for (operand, partial) in partials {
                for (column, inner) in of(operand).iter() {
                    parts.push((*column, graph.mul(partial, *inner)));
                }
            }
            parts.sort_by_key(|(column, _)| *column);
            let summed = parts.chunk_by(|a, b| a.0 == b.0).map(|chunk| match chunk {
                [single] => *single,
                _ => (chunk[0].0, graph.sum(&chunk.iter().map(|(_, part)| *part).collect::<Vec<_>>())),
            });
            summed.collect::<Vec<_>>().into_iter().filter(|(_, id)| !graph.is_zero(*id)).collect()
        }
        Rule::Branch(condition, first, second) => {
            let (first, second) = (of(first), of(second));
            let zero = graph.zero();
            let side = |row: &Row, column| row.iter().find(|(c, _)| *c == column).map_or(zero, |(_, id)| *id);
            let mut columns: Vec<usize> = first.iter().chain(second.iter()).map(|(column, _)| *column).collect();
            columns.sort_unstable();
            columns.dedup();
            let select = |column| (column, graph.select(condition, side(&first, column), side(&second, column)));
            columns.into_iter().map(select).collect()
        }
    }
}
