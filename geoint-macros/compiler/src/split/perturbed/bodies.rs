//! Kepler's motion of bodies, each about a centre, and the rest of their energy, in coordinates of the kind that a [`Frame`] is.
//!
//! What has the place of momenta is velocities: V_i is made of p_j/m_j, so that no mass that momenta are divided by and multiplied with again,
//! both rounded, lets the energy drift, and bodies may be as light as they like.

use super::super::flow::Flow;
use super::super::time::Clock;
use super::attraction::Attraction;
use super::frame::{Frame, Masses, Offsets};
use super::{Inner, Jump, OwnMotion, Perturbed, halved};
use crate::analyze;
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};
use crate::parse::Shape;
use std::ops::Range;

struct Bodies<'a> {
    frame: &'a Frame,
    attraction: &'a Attraction,
    masses: Masses,
    dimensions: usize,
}

const KEPLER: &str =
    "Kepler's motion: p²/2m − k/|q| (J. Wisdom & D. M. Hernandez, Mon. Not. R. Astron. Soc. 453 (2015) 3015)";

/// A: each body about its centre; B: the energy less that.
pub(super) fn perturbed(graph: &mut Graph, frame: &Frame, attraction: &Attraction, shape: &Shape) -> Perturbed {
    let masses = Masses::new(graph, &attraction.masses);
    let bodies = Bodies { frame, attraction, masses, dimensions: shape.extents[1] };
    let kick = bodies.rest(graph);
    let jump = bodies.jump(graph, kick);
    let (exact, flow, weights) = bodies.motion(graph);
    let parts = (1..bodies.count()).map(|body| (OwnMotion::Orbit(body), bodies.coordinates(body))).collect();
    let velocity = match &jump {
        // A rest that moves positions is no kick, with or without a force gradient.
        Some(jump) => Err(jump.energy),
        None => Ok((0..)
            .zip(&weights)
            .map(|(i, weight)| {
                let p = graph.symbol(Symbol::Momentum(i));
                graph.mul(*weight, p)
            })
            .collect()),
    };
    Perturbed {
        exact,
        kick,
        jump,
        flow,
        clock: Clock::Own,
        parts,
        known: vec![KEPLER.into()],
        velocity,
        inner: Some(Inner {
            name: frame.name,
            enter: bodies.enter(graph),
            leave: bodies.leave(graph),
            weights,
            masses: bodies.masses.each.clone(),
            shares: bodies.shares(),
        }),
    }
}

impl Bodies<'_> {
    fn count(&self) -> usize {
        self.masses.each.len()
    }

    fn coordinates(&self, body: usize) -> Range<usize> {
        body * self.dimensions..(body + 1) * self.dimensions
    }

    /// Each mass beside those up to it, and beside those that its body moves about.
    fn shares(&self) -> Vec<[Id; 2]> {
        let Masses { each, sums } = &self.masses;
        (1..self.count()).flat_map(|i| [i, (self.frame.inside)(i).end - 1].map(|j| [each[i], sums[j]])).collect()
    }

    /// A coordinate of a body.
    fn symbol(&self, graph: &mut Graph, of: fn(u32) -> Symbol, body: usize, d: usize) -> Id {
        graph.symbol(of((body * self.dimensions + d) as u32))
    }

    /// That coordinate of all bodies.
    fn row(&self, graph: &mut Graph, of: fn(u32) -> Symbol, d: usize) -> Vec<Id> {
        (0..self.count()).map(|body| self.symbol(graph, of, body, d)).collect()
    }

    /// k_i = Σ c_ji, of a body and all inside, over the mass of the body: where c has that mass as a factor it is not divided by.
    fn strength_over_mass(&self, graph: &mut Graph, body: usize) -> Id {
        let inside = (self.frame.inside)(body);
        let mut sum = graph.zero();
        for pair in
            self.attraction.pairs.iter().filter(|pair| pair.bodies[1] == body && inside.contains(&pair.bodies[0]))
        {
            let part = graph.div(pair.strength, self.masses.each[body]);
            sum = graph.add(sum, part);
        }
        sum
    }

    /// V + Σ k/|Q|, in which pairs that are a body and its centre are no more.
    fn rest(&self, graph: &mut Graph) -> Id {
        let along: Vec<Offsets> = (0..self.dimensions)
            .map(|d| {
                let inner = self.row(graph, Symbol::Position, d);
                (self.frame.leave)(graph, &self.masses, &inner)
            })
            .collect();
        let mut of_centre = |body: usize| {
            (0..self.dimensions).all(|d| along[d].each[body] == self.symbol(graph, Symbol::Position, body, d))
        };
        let solved: Vec<bool> = (0..self.count()).map(|body| body > 0 && of_centre(body)).collect();
        let pairs = self.attraction.pairs.iter().filter(|pair| pair.bodies[0] != 0 || !solved[pair.bodies[1]]);
        let terms: Vec<Id> = pairs.map(|pair| pair.term).chain(self.attraction.others.iter().copied()).collect();
        let mut terms = self.moved(graph, &terms, &along);
        for body in (1..self.count()).filter(|body| !solved[*body]) {
            let strength = self.strength_over_mass(graph, body);
            let strength = graph.mul(strength, self.masses.each[body]);
            let q: Vec<Id> = (0..self.dimensions).map(|d| self.symbol(graph, Symbol::Position, body, d)).collect();
            let square = graph.dot(&q, &q);
            let recip = graph.pow(square, Ratio { numerator: -1, denominator: 2 });
            terms.push(graph.mul(strength, recip));
        }
        graph.sum(&terms)
    }

    /// Terms with positions replaced by inner ones. Differences of positions are those of offsets: where body 0 is drops out of them.
    fn moved(&self, graph: &mut Graph, terms: &[Id], along: &[Offsets]) -> Vec<Id> {
        let place = |i: u32| (i as usize / self.dimensions, i as usize % self.dimensions);
        let mut substitution = Substitution::new(|graph: &mut Graph, symbol| match symbol {
            Symbol::Position(i) => {
                let (body, d) = place(i);
                Some(graph.add(along[d].first, along[d].each[body]))
            }
            _ => None,
        });
        for id in graph.reachable(terms) {
            let Node::Linear(constant, sum) = graph.node(id).clone() else { continue };
            // What body 0 is multiplied by, along each direction.
            let mut whole = vec![Number::ZERO; self.dimensions];
            let mut moved = vec![];
            for (c, term) in sum {
                match graph.node(term) {
                    Node::Symbol(Symbol::Position(i)) => {
                        let (body, d) = place(*i);
                        whole[d] = whole[d].add(c);
                        moved.push((c, along[d].each[body]));
                    }
                    _ => moved.push((c, substitution.apply(graph, term))),
                }
            }
            moved.extend(whole.into_iter().zip(along).map(|(c, along)| (c, along.first)));
            moved.retain(|(c, id)| !c.is_zero() && !graph.is_zero(*id));
            let replacement = graph.linear(constant, moved);
            substitution.insert(id, replacement);
        }
        terms.iter().map(|term| substitution.apply(graph, *term)).collect()
    }

    /// The part of the kinetic energy that is no body's own. It moves all bodies but body 0 alike, and so leaves a kick as it is that reads
    /// nothing but differences of their positions: such a kick keeps the sum of their momenta.
    fn jump(&self, graph: &mut Graph, kick: Id) -> Option<Jump> {
        let jump = self.frame.jump?;
        let (mut velocity, mut squares) = (vec![graph.zero(); self.count() * self.dimensions], vec![]);
        for d in 0..self.dimensions {
            let inner = self.row(graph, Symbol::Momentum, d);
            let along = jump(graph, &self.masses, &inner);
            (1..self.count()).for_each(|body| velocity[body * self.dimensions + d] = along);
            // In words of momenta.
            let weighted: Vec<Id> = inner
                .iter()
                .zip(&self.masses.each)
                .map(|(p, mass)| {
                    let ratio = graph.div(self.masses.each[0], *mass);
                    graph.mul(ratio, *p)
                })
                .collect();
            let momentum = jump(graph, &self.masses, &weighted);
            squares.push(graph.pow(momentum, Ratio::integer(2)));
        }
        let square = graph.sum(&squares);
        let energy = graph.div(square, self.masses.each[0]);
        let slopes = diff::gradient(graph, kick, velocity.len() as u32).q;
        let commutes = (0..self.dimensions).all(|d| {
            let along: Vec<Id> = (1..self.count()).map(|body| slopes[body * self.dimensions + d]).collect();
            let sum = graph.sum(&along);
            analyze::identity(graph, sum).is_zero()
        });
        Some(Jump { energy: halved(graph, energy), velocity, commutes })
    }

    /// A, its flow for velocities in place of momenta, and the masses with which bodies move, each 1 over it.
    fn motion(&self, graph: &mut Graph) -> (Id, Flow, Vec<Id>) {
        let degrees = (self.count() * self.dimensions) as u32;
        let mut flow = Flow::rest(graph, degrees);
        let h = graph.symbol(Symbol::StepLength);
        let (mut terms, mut weights) = (vec![], vec![]);
        for body in 0..self.count() {
            let of_body = self.coordinates(body);
            let (q, v) = (flow.q[of_body.clone()].to_vec(), flow.p[of_body.clone()].to_vec());
            let mass = self.masses.each[body];
            let ratio = (self.frame.ratio)(graph, &self.masses, body);
            let inverse = graph.div(ratio, mass);
            weights.extend(of_body.clone().map(|_| inverse));
            let speed = graph.dot(&v, &v);
            // In words of momenta.
            let kinetic = graph.mul(inverse, speed);
            terms.push(halved(graph, kinetic));
            let over_mass = self.strength_over_mass(graph, body);
            if body == 0 || graph.is_zero(over_mass) {
                for (i, v) in of_body.zip(v) {
                    let shift = graph.mul(h, v);
                    flow.q[i] = graph.add(flow.q[i], shift);
                }
                continue;
            }
            let (distance, falling) = (graph.dot(&q, &q), graph.dot(&q, &v));
            let strength = graph.mul(over_mass, ratio);
            let args = [distance, falling, speed, strength, h];
            let [f, g, f_rate, g_rate] = Function::KEPLER.map(|function| graph.call(function, &args));
            let recip = graph.pow(distance, Ratio { numerator: -1, denominator: 2 });
            let attraction = graph.product(&[over_mass, mass, recip]);
            terms.push(graph.neg(attraction));
            for (i, (q, v)) in of_body.zip(q.into_iter().zip(v)) {
                for (x, [by_q, by_v]) in [(&mut flow.q[i], [f, g]), (&mut flow.p[i], [f_rate, g_rate])] {
                    let added = [graph.mul(by_q, q), graph.mul(by_v, v)];
                    let added = graph.sum(&added);
                    *x = graph.add(*x, added);
                }
            }
        }
        (graph.sum(&terms), flow, weights)
    }

    /// The way in, of positions and of p/m.
    fn enter(&self, graph: &mut Graph) -> Vec<(Symbol, Id)> {
        let mut inner = vec![];
        for d in 0..self.dimensions {
            let q = self.row(graph, Symbol::Position, d);
            let p = self.row(graph, Symbol::Momentum, d);
            let v: Vec<Id> = p.into_iter().zip(&self.masses.each).map(|(p, mass)| graph.div(p, *mass)).collect();
            let ends =
                [(self.frame.enter)(graph, &self.masses, &q), (self.frame.enter_velocities)(graph, &self.masses, &v)];
            inner.extend(self.named(d, ends));
        }
        inner
    }

    /// The way out.
    fn leave(&self, graph: &mut Graph) -> Vec<(Symbol, Id)> {
        let mut outer = vec![];
        for d in 0..self.dimensions {
            let [q, v] = [Symbol::Position as fn(u32) -> Symbol, Symbol::Momentum].map(|of| self.row(graph, of, d));
            let places = (self.frame.leave)(graph, &self.masses, &q).places(graph);
            let velocities = (self.frame.leave_velocities)(graph, &self.masses, &v);
            let momenta =
                velocities.into_iter().zip(&self.masses.each).map(|(v, mass)| graph.mul(*mass, v)).collect::<Vec<_>>();
            outer.extend(self.named(d, [places, momenta]));
        }
        outer
    }

    /// Ends of positions and momenta along a direction, with their symbols.
    fn named(&self, d: usize, ends: [Vec<Id>; 2]) -> Vec<(Symbol, Id)> {
        let of = [Symbol::Position as fn(u32) -> Symbol, Symbol::Momentum];
        let index = |body: usize| (body * self.dimensions + d) as u32;
        of.into_iter()
            .zip(ends)
            .flat_map(|(of, ends)| ends.into_iter().enumerate().map(move |(body, end)| (of(index(body)), end)))
            .collect()
    }
}
