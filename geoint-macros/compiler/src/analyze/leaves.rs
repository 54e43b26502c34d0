//! What the divided differences of an expression end at: its largest parts of low degree.
//!
//! Every rule of a divided difference is a chain rule, Δnode = Σ c·Δoperand with scalars c. The tree discrete gradient is
//! therefore a combination of the discrete gradients of these parts, and that of a part of degree 2 at most is its gradient
//! at the middle of the step, however it is written.

use super::degree::Degrees;
use super::terms::{Sums, Term};
use crate::ir::{Function, Graph, Id, Node};
use std::collections::HashSet;

/// A part of low degree.
#[derive(Debug)]
pub(super) enum Leaf {
    /// Terms of one sum, which have their coefficient in common.
    Sum(Vec<Term>),
    /// x² + y² of a `hypot` of these: its slope is that of the root of the sum.
    Squares(Vec<Id>),
}

/// All parts of degree `degree` at most that `root` is a function of, none inside another. `None` if a condition reads the
/// state: between two branches there is no chain rule.
pub(super) fn leaves(graph: &Graph, degrees: &Degrees, root: Id, degree: u32) -> Option<Vec<Leaf>> {
    let reads_state = |id: Id| graph.reads(id).state();
    let at_most = |id: Id, degree: u32| degrees.get(id).is_some_and(|d| d <= degree);
    let mut sums = Sums::new(graph);
    let (mut leaves, mut seen, mut open) = (vec![], HashSet::new(), vec![root]);
    while let Some(id) = open.pop() {
        if !seen.insert(id) {
            continue;
        }
        let mut leaf = vec![];
        for term in sums.terms(id, |_| true) {
            let Some(last) = term.factors.last().copied().filter(|last| reads_state(*last)) else { continue };
            match graph.node(last) {
                _ if at_most(last, degree) => leaf.push(term),
                Node::Select(condition, ..) if reads_state(*condition) => return None,
                Node::Call(Function::Hypot, _)
                    if degree >= 2 && sides(graph, last).iter().all(|side| at_most(*side, 1)) =>
                {
                    leaves.push(Leaf::Squares(sides(graph, last)));
                }
                node => open.extend(node.children().into_iter().filter(|child| reads_state(*child))),
            }
        }
        if !leaf.is_empty() {
            leaves.push(Leaf::Sum(leaf));
        }
    }
    Some(leaves)
}

/// The sides of a `hypot`, those of one inside of it in its place: the slope of a root times the mean of that root is half of the slope
/// of the square.
fn sides(graph: &Graph, id: Id) -> Vec<Id> {
    match graph.node(id) {
        Node::Call(Function::Hypot, args) => args.iter().flat_map(|side| sides(graph, *side)).collect(),
        _ => vec![id],
    }
}
