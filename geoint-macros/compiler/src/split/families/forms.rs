//! Pieces that read linear forms in involution: all of these stay, and everything else moves along a straight line.
//!
//! ℓ = a·q + b·p with numbers or parameters for a and b; two forms are in involution if a·b' = b·a'. Kicks, drifts, F(q₀, p₁),
//! (p₁ − A(q₀))² and (q + p)⁴ are such pieces.

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Polynomial, is_free};
use super::super::time::Clock;
use crate::diff;
use crate::ir::{Graph, Id, Node, Number, Ratio, Symbol};
use std::collections::{BTreeMap, BTreeSet};

/// V(q, t).
pub(in super::super) fn kick(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let moves = |symbol| matches!(symbol, Symbol::Momentum(_) | Symbol::Action);
    if is_free(graph, group.energy, &moves) { straight(graph, group) } else { None }
}

/// Coefficients of coordinates.
type Form = BTreeMap<Symbol, Id>;

/// q moves by h ∂H/∂p, p by −h ∂H/∂q, both at the start.
pub(in super::super) fn straight(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let forms = forms(graph, group.energy)?;
    let moves = |symbol| symbol == Symbol::Time;
    let autonomous = is_free(graph, group.energy, &moves);
    if group.clock == Clock::Own && forms.iter().any(|form| form.values().any(|c| !is_free(graph, *c, &moves))) {
        return None;
    }
    for (i, first) in forms.iter().enumerate() {
        for second in &forms[..i] {
            if !in_involution(graph, first, second) {
                return None;
            }
        }
    }
    let mut flow = Flow::rest(graph, group.degrees);
    let h = graph.symbol(Symbol::StepLength);
    if autonomous || group.clock == Clock::Stage {
        // Derivatives of hH, so that h meets the constants of every term and is prepared with them.
        let generator = graph.mul(h, group.energy);
        let slopes = diff::gradient(graph, generator, group.degrees);
        for i in 0..group.degrees as usize {
            flow.q[i] = graph.add(flow.q[i], slopes.p[i]);
            flow.p[i] = graph.sub(flow.p[i], slopes.q[i]);
        }
        return Some(flow);
    }
    let slopes = diff::gradient(graph, group.energy, group.degrees);
    for i in 0..group.degrees as usize {
        let [moved, impulse] = [slopes.p[i], slopes.q[i]].map(|rate| group.clock.over_step(graph, rate));
        flow.q[i] = graph.add(flow.q[i], moved?);
        flow.p[i] = graph.sub(flow.p[i], impulse?);
    }
    Some(flow)
}

/// Σ (aᵢ b'ᵢ − bᵢ a'ᵢ) = 0?
fn in_involution(graph: &mut Graph, first: &Form, second: &Form) -> bool {
    let mut sum = graph.zero();
    for (symbol, c) in first {
        let (other, sign) = match *symbol {
            Symbol::Position(i) => (Symbol::Momentum(i), Number::ONE),
            Symbol::Momentum(i) => (Symbol::Position(i), Number::MINUS_ONE),
            _ => return false,
        };
        if let Some(other) = second.get(&other) {
            let product = graph.mul(*c, *other);
            let product = graph.scale(sign, product);
            sum = graph.add(sum, product);
        }
    }
    graph.is_zero(sum)
}

/// The forms by which `root` reads positions and momenta; nothing if it reads s.
fn forms(graph: &mut Graph, root: Id) -> Option<Vec<Form>> {
    let (mut found, mut seen, mut open) = (vec![], BTreeSet::new(), vec![root]);
    while let Some(id) = open.pop() {
        if !seen.insert(id) || is_free(graph, id, &Symbol::is_coordinate) {
            continue;
        }
        if let Some(form) = form(graph, id) {
            if form.contains_key(&Symbol::Action) {
                return None;
            }
            if !found.contains(&form) {
                found.push(form);
            }
            continue;
        }
        match graph.node(id).clone() {
            // The linear terms of a sum are one form.
            Node::Linear(_, terms) => {
                let mut linear = graph.zero();
                for (c, term) in terms {
                    if form_of(graph, term).is_some() {
                        let term = graph.scale(c, term);
                        linear = graph.add(linear, term);
                    } else {
                        open.push(term);
                    }
                }
                open.push(linear);
            }
            node => open.extend(node.children()),
        }
    }
    Some(found)
}

fn form(graph: &mut Graph, id: Id) -> Option<Form> {
    match graph.node(id) {
        Node::Symbol(_) | Node::Linear(..) | Node::Product(_) => form_of(graph, id),
        _ => None,
    }
}

/// The coefficients of a node of degree 1; a constant in it does not matter.
fn form_of(graph: &mut Graph, id: Id) -> Option<Form> {
    let powers = Polynomial::of(graph, id, &Symbol::is_coordinate)?;
    let linear = powers.has_only(|monomial| monomial.is_empty() || monomial.values().eq([&Ratio::ONE]));
    linear.then(|| powers.into_terms().filter_map(|(monomial, c)| Some((*monomial.keys().next()?, c))).collect())
}
