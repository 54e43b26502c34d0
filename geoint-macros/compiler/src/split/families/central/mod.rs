//! Motion about a centre: a potential of the length of y, whose components are forms in the positions.
//!
//! With T = p·Wp/2 and |y|² = Σ κₘ yₘ², yₘ = aₘ·q + cₘ, components are accelerated along y alone if κₘ aₘ·Waₙ is λ for m = n, else 0. Then
//! y moves in a plane, y(h) = F y + G y' and y'(h) = Ḟ y + Ġ y' with numbers F to Ġ, and q and p follow, because W aₘ and aₘ are all that
//! they are accelerated along. One body about a fixed centre and two bodies about each other are such motions, and oscillators and walls of
//! one coordinate.

mod centre;
mod motion;

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Polynomial, is_free, is_momentum};
use super::super::products::known_terms;
use super::super::time::Clock;
use crate::analyze;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};
use centre::{Centre, centre};
use motion::{Motion, Start, about_inverse_square};

/// p·Wp/2 with the terms of a potential that are powers of lengths, and the sum of all others.
struct Central {
    inverse_mass: Vec<Vec<Id>>,
    centres: Vec<Centre>,
    rest: Id,
}

/// p·Wp/2 + Σ k/2|y|² + b|y|²/2, of which each y is accelerated by itself.
pub(in super::super) fn inverse_square(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let central = Central::of(graph, group, Ratio::integer(-2))?;
    let bound = central.oscillators(graph)?;
    central.flow(graph, group, |graph, at| about_inverse_square(graph, at, bound[at.number]))
}

/// p·Wp/2 − Σ k/|y|.
pub(in super::super) fn kepler(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let central = Central::of(graph, group, Ratio::integer(-1))?;
    // On a line every motion ends in the centre, or leaves it alone.
    if !is_free(graph, central.rest, &Symbol::is_coordinate) || central.centres.iter().any(|c| c.forms.len() < 2) {
        return None;
    }
    central.flow(graph, group, |graph, at| {
        let attraction = graph.neg(at.strength);
        let args = [at.square, at.falling, at.speed, attraction, graph.symbol(Symbol::StepLength)];
        Function::KEPLER.map(|function| graph.call(function, &args))
    })
}

impl Central {
    /// The parts of an energy whose lengths stand to the power `power`.
    fn of(graph: &mut Graph, group: &Group, power: Ratio) -> Option<Central> {
        let reads_time = |symbol: Symbol| symbol == Symbol::Time && group.clock == Clock::Own;
        if !is_free(graph, group.energy, &|symbol| symbol == Symbol::Action || reads_time(symbol)) {
            return None;
        }
        let divides =
            |id: Id| matches!(graph.node(id), Node::Power(base, r) if r.numerator < 0 && graph.reads(*base).q);
        if !graph.reachable(&[group.energy]).into_iter().any(divides) {
            return None;
        }
        let powers = Polynomial::of(graph, group.energy, &is_momentum)?;
        let mut inverse_mass = vec![vec![graph.zero(); group.degrees as usize]; group.degrees as usize];
        let mut potential = graph.zero();
        for (monomial, coefficient) in powers.into_terms() {
            let constant = is_free(graph, coefficient, &Symbol::is_coordinate);
            let momenta: Vec<(usize, Ratio)> = monomial
                .iter()
                .filter_map(
                    |(symbol, power)| if let Symbol::Momentum(i) = symbol { Some((*i as usize, *power)) } else { None },
                )
                .collect();
            match momenta[..] {
                [] => potential = coefficient,
                [(i, power)] if constant && power == Ratio::integer(2) => {
                    inverse_mass[i][i] = graph.scale(Number::integer(2), coefficient);
                }
                [(i, Ratio::ONE), (j, Ratio::ONE)] if constant => {
                    (inverse_mass[i][j], inverse_mass[j][i]) = (coefficient, coefficient);
                }
                _ => return None,
            }
        }
        let (centres, rest) = known_terms(graph, potential, |graph, term| centre(graph, term, power, group.degrees));
        let rest = graph.sum(&rest);
        (!centres.is_empty()).then_some(Central { inverse_mass, centres, rest })
    }

    /// b of each centre, if the rest is Σ b|y|²/2 and a constant.
    fn oscillators(&self, graph: &mut Graph) -> Option<Vec<Id>> {
        let powers = Polynomial::of(graph, self.rest, &Symbol::is_coordinate)?;
        let (mut bound, mut rest) = (vec![], self.rest);
        for centre in &self.centres {
            let own = Polynomial::of(graph, centre.square, &Symbol::is_coordinate)?;
            let of =
                |powers: &Polynomial, graph: &mut Graph, i: u32| powers.coefficient(graph, &[(Symbol::Position(i), 2)]);
            let i = (0..self.inverse_mass.len() as u32).find(|i| {
                let square = of(&own, graph, *i);
                !graph.is_zero(square)
            })?;
            let [square, given] = [&own, &powers].map(|powers| of(powers, graph, i));
            let half = graph.div(given, square);
            let energy = graph.mul(half, centre.square);
            rest = graph.sub(rest, energy);
            bound.push(graph.scale(Number::integer(2), half));
        }
        let left = Polynomial::of(graph, rest, &Symbol::is_coordinate)?;
        let constant =
            left.into_terms().all(|(monomial, c)| monomial.is_empty() || analyze::identity(graph, c).is_zero());
        constant.then_some(bound)
    }

    /// The flow, if every y is accelerated along itself.
    fn flow(
        &self,
        graph: &mut Graph,
        group: &Group,
        motion: impl Fn(&mut Graph, &Start<'_>) -> Motion,
    ) -> Option<Flow> {
        let mut flow = Flow::rest(graph, group.degrees);
        let (q, p, h) = (flow.q.clone(), flow.p.clone(), graph.symbol(Symbol::StepLength));
        // W aₘ of all forms so far, with aₘ.
        let mut before: Vec<(Vec<Id>, Vec<Id>)> = vec![];
        let mut free = self.inverse_mass.clone();
        for (number, centre) in self.centres.iter().enumerate() {
            let forms = &centre.forms;
            let pushes: Vec<Vec<Id>> = forms
                .iter()
                .map(|form| self.inverse_mass.iter().map(|row| graph.dot(row, &form.coefficients)).collect())
                .collect();
            for (m, form) in forms.iter().enumerate() {
                if before.iter().any(|(push, _)| !vanishes(graph, push, &form.coefficients))
                    || pushes[..m].iter().any(|push| !vanishes(graph, push, &form.coefficients))
                {
                    return None;
                }
            }
            let of_form = |graph: &mut Graph, m: usize| {
                let own = graph.dot(&pushes[m], &forms[m].coefficients);
                graph.mul(forms[m].weight, own)
            };
            let lambda = of_form(graph, 0);
            for m in 0..forms.len() {
                let other = of_form(graph, m);
                let difference = graph.sub(other, lambda);
                if graph.is_zero(lambda) || !analyze::identity(graph, difference).is_zero() {
                    return None;
                }
            }
            let y: Vec<Id> = forms.iter().map(|form| form.value(graph, &q)).collect();
            let v: Vec<Id> = pushes.iter().map(|push| graph.dot(push, &p)).collect();
            let [square, falling, speed] = [(&y, &y), (&y, &v), (&v, &v)].map(|(a, b)| {
                let products =
                    (0..forms.len()).map(|m| graph.product(&[forms[m].weight, a[m], b[m]])).collect::<Vec<_>>();
                graph.sum(&products)
            });
            let strength = graph.mul(lambda, centre.strength);
            let start = Start { number, lambda, strength, forms, y, v, square, falling, speed };
            let [f, g, f_rate, g_rate] = motion(graph, &start);
            for (m, push) in pushes.iter().enumerate() {
                let share = graph.div(forms[m].weight, lambda);
                let [moved, kicked] = [[f, g], [f_rate, g_rate]].map(|[by_y, by_v]| {
                    let terms = [graph.mul(by_y, start.y[m]), graph.mul(by_v, start.v[m])];
                    graph.sum(&terms)
                });
                for i in 0..q.len() {
                    let along = graph.mul(share, push[i]);
                    let moved = graph.mul(along, moved);
                    flow.q[i] = graph.add(flow.q[i], moved);
                    let kicked = graph.product(&[share, forms[m].coefficients[i], kicked]);
                    flow.p[i] = graph.add(flow.p[i], kicked);
                    for j in 0..q.len() {
                        let bound = graph.mul(along, push[j]);
                        free[i][j] = graph.sub(free[i][j], bound);
                    }
                }
            }
            before.extend(pushes.into_iter().zip(forms.iter().map(|form| form.coefficients.clone())));
        }
        // What no centre accelerates.
        for (i, row) in free.into_iter().enumerate() {
            for (entry, p) in row.into_iter().zip(&p) {
                if !analyze::identity(graph, entry).is_zero() {
                    let moved = graph.product(&[h, entry, *p]);
                    flow.q[i] = graph.add(flow.q[i], moved);
                }
            }
        }
        Some(flow)
    }
}

/// a·b = 0?
fn vanishes(graph: &mut Graph, a: &[Id], b: &[Id]) -> bool {
    let product = graph.dot(a, b);
    analyze::identity(graph, product).is_zero()
}
