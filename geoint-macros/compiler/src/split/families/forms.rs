//! Families "kick" and "forms in involution": energies that read q and p through linear forms in involution only.
//!
//! A form is ℓ = a·q + b·p, where a and b read parameters only. Two forms are in involution if a·b' = b·a', so their Poisson bracket vanishes. Then
//! ℓᵢ' = Σⱼ {ℓᵢ, ℓⱼ} ∂H/∂ℓⱼ = 0: every form keeps its value, and so do all rates, except for their dependence on time. The flow is one step with the rates at its
//! start, or the integrals of the rates. Examples are kicks, drifts, F(q₀, p₁), (p₁ − A(q₀))² and (q + p)⁴.
//!
//! Forms are read from the graph as the user wrote H. The expanded form of (q + p)⁴ is not found. Systems with an action have families of their own, because
//! the action moves, too.
//!
//! With the clock `Clock::Own`, time passes in the flow: rates that read time are integrated from t to t + h. With `Clock::Stage`, time stands still, so nothing
//! reads it as a variable.

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Polynomial, is_free};
use crate::diff;
use crate::ir::{Graph, Id, Node, Number, Symbol};
use std::collections::{BTreeMap, BTreeSet};

/// Returns the flow of V(q, t): q rests, and p grows by −∫ ∂V/∂q dt. A special case of [`in_involution`] with a name of its own, because methods and the
/// report treat kicks apart. `None` if V reads p or the action s, or if [`in_involution`] finds no flow.
pub(super) fn kick(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let excluded = |symbol| matches!(symbol, Symbol::Momentum(_) | Symbol::Action);
    if is_free(graph, group.energy, &excluded) { in_involution(graph, group) } else { None }
}

/// The coefficients of the coordinates in a form.
type Form = BTreeMap<Symbol, Id>;

/// Returns the flow of a function of forms in involution: q grows by h ∂H/∂p and p by −h ∂H/∂q, both at the start. For an H that reads time, h times the
/// rate becomes the integral of the rate over the step. `None` if the forms are not in involution, if their coefficients read time, if H reads the action s, or
/// if an integral is not known in closed form.
pub(super) fn in_involution(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let forms = forms(graph, group.energy)?;
    if !forms.iter().flat_map(Form::values).all(|c| group.clock.is_steady(graph, *c)) {
        return None;
    }
    for (i, first) in forms.iter().enumerate() {
        for second in &forms[..i] {
            if !commute(graph, first, second) {
                return None;
            }
        }
    }
    let mut flow = Flow::rest(graph, group.degrees);
    let h = graph.symbol(Symbol::StepLength);
    if group.clock.is_steady(graph, group.energy) {
        // The derivatives of hH contain h in the constants of each term. These products are computed once for each h, before all steps.
        let generator = graph.mul(h, group.energy);
        let gradient = diff::gradient(graph, generator, group.degrees);
        for i in 0..group.degrees as usize {
            flow.q[i] = graph.add(flow.q[i], gradient.p[i]);
            flow.p[i] = graph.sub(flow.p[i], gradient.q[i]);
        }
        return Some(flow);
    }
    let gradient = diff::gradient(graph, group.energy, group.degrees);
    for i in 0..group.degrees as usize {
        let [moved, impulse] = [gradient.p[i], gradient.q[i]].map(|rate| group.clock.over_step(graph, rate));
        flow.q[i] = graph.add(flow.q[i], moved?);
        flow.p[i] = graph.sub(flow.p[i], impulse?);
    }
    Some(flow)
}

/// Returns whether the bracket Σ (aᵢ b'ᵢ − bᵢ a'ᵢ) of two forms is the number zero after the graph's simplification. No proof is tried.
fn commute(graph: &mut Graph, first: &Form, second: &Form) -> bool {
    let mut sum = graph.zero();
    for (symbol, c) in first {
        // `forms` has refused the action.
        let (other, sign) = match *symbol {
            Symbol::Position(i) => (Symbol::Momentum(i), Number::ONE),
            Symbol::Momentum(i) => (Symbol::Position(i), Number::MINUS_ONE),
            _ => return false,
        };
        if let Some(other) = second.get(&other) {
            sum = graph.build(sum + sign * (*c * *other));
        }
    }
    graph.is_zero(sum)
}

/// Returns the forms through which `root` reads positions and momenta, or `None` if it reads the action s.
fn forms(graph: &mut Graph, root: Id) -> Option<Vec<Form>> {
    let (mut found, mut seen, mut open) = (vec![], BTreeSet::new(), vec![root]);
    while let Some(id) = open.pop() {
        if !seen.insert(id) || is_free(graph, id, &Symbol::is_coordinate) {
            continue;
        }
        // Only these nodes can be affine. The test spares all others the expansion into a polynomial.
        let may_be_form = matches!(graph.node(id), Node::Symbol(_) | Node::Linear(..) | Node::Product(_));
        if let Some(form) = may_be_form.then(|| form(graph, id)).flatten() {
            if form.contains_key(&Symbol::Action) {
                return None;
            }
            if !found.contains(&form) {
                found.push(form);
            }
            continue;
        }
        match graph.node(id).clone() {
            // The linear terms of a sum are one form: q and p alone are not in involution, but q + p is a single form.
            Node::Linear(_, terms) => {
                let mut linear = graph.zero();
                for (c, term) in terms {
                    if form(graph, term).is_some() {
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

/// Returns the coefficients of an affine expression. The constant is ignored.
fn form(graph: &mut Graph, id: Id) -> Option<Form> {
    let powers = Polynomial::of(graph, id, &Symbol::is_coordinate).filter(Polynomial::is_affine)?;
    Some(powers.into_terms().filter_map(|(monomial, c)| Some((*monomial.keys().next()?, c))).collect())
}
