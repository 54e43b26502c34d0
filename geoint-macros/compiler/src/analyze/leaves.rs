//! The largest parts of low degree in an expression. The divided differences of the expression end at these parts.
//!
//! Every rule of a divided difference is a chain rule, Δnode = Σ c·Δoperand with scalars c. The tree discrete gradient is therefore a combination of
//! the discrete gradients of the parts. The discrete gradient of a part of degree at most 2 is its gradient at the middle of the step, independent of
//! its form.

use super::degree::Degrees;
use super::terms::{Sums, Term};
use crate::ir::{Function, Graph, Id, Node};
use std::collections::HashSet;

/// A part of low degree.
#[derive(Debug)]
pub(super) enum Leaf {
    /// Terms of one sum, which share its coefficient.
    Sum(Vec<Term>),
    /// The sides x, y, … of a `hypot`. The slope of the root follows from the slope of x² + y² + ….
    Squares(Vec<Id>),
}

/// Returns all parts of degree at most `degree` of which `root` is a function. No part contains another part. `None` if a condition reads the state,
/// because no chain rule connects two branches.
pub(super) fn leaves(graph: &Graph, degrees: &Degrees, root: Id, degree: u32) -> Option<Vec<Leaf>> {
    let reads_state = |id: Id| graph.reads(id).state();
    let mut sums = Sums::new(graph);
    let (mut leaves, mut seen, mut open) = (vec![], HashSet::new(), vec![root]);
    while let Some(id) = open.pop() {
        if !seen.insert(id) {
            continue;
        }
        let mut leaf = vec![];
        for term in sums.terms(id, |_| true) {
            let Some(factor) = term.moving_factor(graph) else { continue };
            match graph.node(factor) {
                _ if degrees.at_most(factor, degree) => leaf.push(term),
                Node::Select(condition, ..) if reads_state(*condition) => return None,
                Node::Call(Function::Hypot, _)
                    if degree >= 2 && sides(graph, factor).iter().all(|side| degrees.at_most(*side, 1)) =>
                {
                    leaves.push(Leaf::Squares(sides(graph, factor)));
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

/// Returns the sides of a `hypot`. The sides of a nested `hypot` replace it: the slope of a root times the mean of the root is half the slope of its
/// square.
fn sides(graph: &Graph, id: Id) -> Vec<Id> {
    match graph.node(id) {
        Node::Call(Function::Hypot, args) => args.iter().flat_map(|side| sides(graph, *side)).collect(),
        _ => vec![id],
    }
}
