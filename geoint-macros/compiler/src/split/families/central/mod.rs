//! Families "inverse square" and "Kepler motion": motion about a centre. The potential is a function of the length of a vector y, whose
//! components are forms in the positions.
//!
//! T = p·Wp/2, |y|² = Σ κₘ yₘ² and yₘ = aₘ·q + cₘ. The acceleration of y is parallel to y if κₘ aₘ·Waₙ is λ for m = n and 0 otherwise. Then y
//! moves in a plane: y(h) = F y + G y' and y'(h) = Ḟ y + Ġ y' with numbers F to Ġ. The forces change q along W aₘ and p along aₘ only, so q and p
//! follow from y. Examples are one body about a fixed centre, two bodies about each other, and oscillators with walls of one coordinate.

mod centre;
mod motion;

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Polynomial, degree, is_free, is_momentum, is_whole, reads};
use super::super::products::known_terms;
use crate::analyze;
use crate::diff::equations::times;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};
use centre::{Centre, Form};
use motion::{Motion, Start, about_inverse_square};

/// p·Wp/2, the centres of the potential, and the sum of its other terms.
struct Central {
    inverse_mass: Vec<Vec<Id>>,
    centres: Vec<Centre>,
    rest: Id,
}

/// Returns the flow of p·Wp/2 + Σ k/2|y|² + b|y|²/2, if the acceleration of each y is parallel to y.
pub(super) fn inverse_square(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let central = Central::of(graph, group, Ratio::integer(-2))?;
    let bound = central.oscillators(graph)?;
    central.flow(graph, group.degrees, |graph, start| about_inverse_square(graph, start, bound[start.number]))
}

/// Returns the flow of p·Wp/2 − Σ k/|y|.
pub(super) fn kepler(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let central = Central::of(graph, group, Ratio::integer(-1))?;
    // The motion along a line ends in the centre or started there.
    let on_line = |centre: &Centre| centre.length.forms.len() < 2;
    if !is_free(graph, central.rest, &Symbol::is_coordinate) || central.centres.iter().any(on_line) {
        return None;
    }
    central.flow(graph, group.degrees, |graph, start| {
        let attraction = graph.neg(start.strength);
        let args = [start.square, start.radial, start.speed, attraction, graph.symbol(Symbol::StepLength)];
        let [f, g, f_rate, g_rate] = Function::KEPLER.map(|function| graph.call(function, &args));
        Motion { f, g, f_rate, g_rate }
    })
}

impl Central {
    /// Separates an energy into T, centres g·|y|ⁿ with n = `power`, and the rest.
    fn of(graph: &mut Graph, group: &Group, power: Ratio) -> Option<Central> {
        if reads(graph, group.energy, Symbol::Action) || !group.clock.is_steady(graph, group.energy) {
            return None;
        }
        let divides =
            |id: Id| matches!(graph.node(id), Node::Power(base, r) if r.numerator < 0 && graph.reads(*base).q);
        if !graph.reachable(&[group.energy]).into_iter().any(divides) {
            return None;
        }
        let powers = Polynomial::of(graph, group.energy, &is_momentum)?;
        let two = Some(Ratio::integer(2));
        for (monomial, coefficient) in powers.terms().filter(|(monomial, _)| !monomial.is_empty()) {
            let quadratic = is_whole(monomial) && degree(monomial) == two;
            if !quadratic || !is_free(graph, coefficient, &Symbol::is_coordinate) {
                return None;
            }
        }
        let momenta: Vec<Symbol> = (0..group.degrees).map(Symbol::Momentum).collect();
        let row = |graph: &mut Graph, p| momenta.iter().map(|r| powers.second_derivative(graph, p, *r)).collect();
        let inverse_mass = momenta.iter().map(|p| row(graph, *p)).collect();
        let potential = powers.coefficient(graph, &[]);
        let (centres, rest) =
            known_terms(graph, potential, |graph, term| Centre::of(graph, term, power, group.degrees));
        let rest = graph.sum(&rest);
        (!centres.is_empty()).then_some(Central { inverse_mass, centres, rest })
    }

    /// Returns b of each centre, if the rest is Σ b|y|²/2 and a constant.
    fn oscillators(&self, graph: &mut Graph) -> Option<Vec<Id>> {
        let powers = Polynomial::of(graph, self.rest, &Symbol::is_coordinate)?;
        let (mut bound, mut rest) = (vec![], self.rest);
        for Centre { length, .. } in &self.centres {
            let own = Polynomial::of(graph, length.square, &Symbol::is_coordinate)?;
            let of =
                |powers: &Polynomial, graph: &mut Graph, i: u32| powers.coefficient(graph, &[(Symbol::Position(i), 2)]);
            let i = (0..self.inverse_mass.len() as u32).find(|i| {
                let square = of(&own, graph, *i);
                !graph.is_zero(square)
            })?;
            let [square, given] = [&own, &powers].map(|powers| of(powers, graph, i));
            let half = graph.div(given, square);
            rest = graph.build(rest - half * length.square);
            bound.push(graph.scale(Number::integer(2), half));
        }
        let left = Polynomial::of(graph, rest, &Symbol::is_coordinate)?;
        let constant =
            left.into_terms().all(|(monomial, c)| monomial.is_empty() || analyze::identity(graph, c).is_zero());
        constant.then_some(bound)
    }

    /// Returns the flow, if the acceleration of every y is parallel to y.
    fn flow(&self, graph: &mut Graph, degrees: u32, motion: impl Fn(&mut Graph, &Start<'_>) -> Motion) -> Option<Flow> {
        let mut flow = Flow::rest(graph, degrees);
        let (q, p, h) = (flow.q.clone(), flow.p.clone(), graph.symbol(Symbol::StepLength));
        // The forms of the centres so far, with W a.
        let mut before: Vec<(&Form, Vec<Id>)> = vec![];
        // The part of W that no centre has used.
        let mut free = self.inverse_mass.clone();
        for (number, centre) in self.centres.iter().enumerate() {
            let forms = &centre.length.forms;
            let pushes: Vec<Vec<Id>> =
                forms.iter().map(|form| times(graph, &self.inverse_mass, &form.coefficients)).collect();
            for (form, push) in forms.iter().zip(&pushes) {
                if before.iter().any(|(_, push)| !are_orthogonal(graph, push, &form.coefficients)) {
                    return None;
                }
                before.push((form, push.clone()));
            }
            let lambda = common_acceleration(graph, forms, &pushes)?;
            let y: Vec<Id> = forms.iter().map(|form| form.value(graph, &q)).collect();
            let v: Vec<Id> = pushes.iter().map(|push| graph.dot(push, &p)).collect();
            let [square, radial, speed] = [(&y, &y), (&y, &v), (&v, &v)].map(|(a, b)| {
                let products: Vec<Id> =
                    (0..forms.len()).map(|m| graph.product(&[forms[m].weight, a[m], b[m]])).collect();
                graph.sum(&products)
            });
            let strength = graph.mul(lambda, centre.strength);
            let start = Start { number, lambda, strength, forms, y, v, square, radial, speed };
            let Motion { f, g, f_rate, g_rate } = motion(graph, &start);
            for (m, push) in pushes.iter().enumerate() {
                let share = graph.div(forms[m].weight, lambda);
                let [moved, kicked] =
                    [[f, g], [f_rate, g_rate]].map(|weights| graph.dot(&weights, &[start.y[m], start.v[m]]));
                for i in 0..q.len() {
                    let along = graph.mul(share, push[i]);
                    flow.q[i] = graph.build(flow.q[i] + along * moved);
                    flow.p[i] = graph.build(flow.p[i] + share * forms[m].coefficients[i] * kicked);
                    for j in 0..q.len() {
                        free[i][j] = graph.build(free[i][j] - along * push[j]);
                    }
                }
            }
        }
        for (i, row) in free.into_iter().enumerate() {
            for (entry, p) in row.into_iter().zip(&p) {
                if !analyze::identity(graph, entry).is_zero() {
                    flow.q[i] = graph.build(flow.q[i] + h * entry * *p);
                }
            }
        }
        Some(flow)
    }
}

/// Returns λ = κₘ aₘ·Waₘ, if it is nonzero and equal for all forms. `pushes` contains W aₘ.
fn common_acceleration(graph: &mut Graph, forms: &[Form], pushes: &[Vec<Id>]) -> Option<Id> {
    let mut lambda = None;
    for (form, push) in forms.iter().zip(pushes) {
        let own = graph.dot(push, &form.coefficients);
        let own = graph.mul(form.weight, own);
        let difference = graph.sub(own, *lambda.get_or_insert(own));
        if graph.is_zero(own) || !analyze::identity(graph, difference).is_zero() {
            return None;
        }
    }
    lambda
}

/// Returns whether a·b is proven to be zero.
fn are_orthogonal(graph: &mut Graph, a: &[Id], b: &[Id]) -> bool {
    let product = graph.dot(a, b);
    analyze::identity(graph, product).is_zero()
}
