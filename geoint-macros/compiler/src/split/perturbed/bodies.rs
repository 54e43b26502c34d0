//! Kepler motion of bodies about their centres, and the rest of their energy, in the coordinates of a [`Frame`].
//!
//! Velocities take the place of momenta: V_i is a combination of p_j/m_j. Thus the method never multiplies and divides momenta by masses, which would
//! round twice and let the energy drift. Masses may be arbitrarily small.

use super::super::flow::Flow;
use super::super::time::Clock;
use super::attraction::Attraction;
use super::frame::{Frame, Masses, Offsets};
use super::{Inner, Jump, OwnMotion, Perturbed};
use crate::analyze;
use crate::diff;
use crate::ir::formula::{pow, squared};
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

/// The motion of all bodies about their centres.
struct OrbitalMotion {
    /// A, as a function of momenta.
    energy: Id,
    /// The flow of A, as a function of velocities.
    flow: Flow,
    /// For each coordinate, the reciprocal of the mass in this motion.
    weights: Vec<Id>,
}

const KEPLER: &str =
    "Kepler's motion: p²/2m − k/|q| (J. Wisdom & D. M. Hernandez, Mon. Not. R. Astron. Soc. 453 (2015) 3015)";

/// Returns A, the motion of each body about its centre, and B, the rest of the energy.
pub(super) fn perturbed(graph: &mut Graph, frame: &Frame, attraction: &Attraction, shape: &Shape) -> Perturbed {
    let masses = Masses::new(graph, &attraction.masses);
    let bodies = Bodies { frame, attraction, masses, dimensions: shape.extents[1] };
    let kick = bodies.rest(graph);
    let jump = bodies.jump(graph, kick);
    let OrbitalMotion { energy: exact, flow, weights } = bodies.motion(graph);
    let parts = (1..bodies.count()).map(|body| (OwnMotion::Orbit(body), bodies.coordinates(body))).collect();
    let mut velocity = |(i, weight): (u32, &Id)| {
        let p = graph.symbol(Symbol::Momentum(i));
        graph.mul(*weight, p)
    };
    let velocity = match &jump {
        // A rest that moves positions is not a kick, so it has no force gradient.
        Some(jump) => Err(jump.energy),
        None => Ok((0..).zip(&weights).map(&mut velocity).collect()),
    };
    let inner = Inner {
        name: frame.name,
        enter: bodies.enter(graph),
        leave: bodies.leave(graph),
        weights,
        masses: bodies.masses.each.clone(),
        shares: bodies.shares(),
    };
    let known = vec![KEPLER.into()];
    Perturbed { exact, kick, jump, flow, clock: Clock::Own, parts, known, velocity, inner: Some(inner) }
}

impl Bodies<'_> {
    fn count(&self) -> usize {
        self.masses.each.len()
    }

    /// Returns the index of a coordinate of a body.
    fn index(&self, body: usize, d: usize) -> usize {
        body * self.dimensions + d
    }

    /// Returns the indices of the coordinates of a body.
    fn coordinates(&self, body: usize) -> Range<usize> {
        self.index(body, 0)..self.index(body + 1, 0)
    }

    /// Returns each mass with the mass up to its body, and with the mass of the bodies inside its orbit.
    fn shares(&self) -> Vec<[Id; 2]> {
        let Masses { each, sums } = &self.masses;
        (1..self.count()).flat_map(|i| [i, (self.frame.inside)(i).end - 1].map(|j| [each[i], sums[j]])).collect()
    }

    /// Returns a position of a body.
    fn position(&self, graph: &mut Graph, body: usize, d: usize) -> Id {
        graph.symbol(Symbol::Position(self.index(body, d) as u32))
    }

    /// Returns the positions of all bodies along a direction.
    fn positions(&self, graph: &mut Graph, d: usize) -> Vec<Id> {
        (0..self.count()).map(|body| self.position(graph, body, d)).collect()
    }

    /// Returns the momenta, or inner velocities, of all bodies along a direction.
    fn momenta(&self, graph: &mut Graph, d: usize) -> Vec<Id> {
        (0..self.count()).map(|body| graph.symbol(Symbol::Momentum(self.index(body, d) as u32))).collect()
    }

    /// Returns k_i/m_i with k_i = Σ c_ji over all bodies j inside the orbit. If c contains m_i as a factor, the division cancels.
    fn strength_over_mass(&self, graph: &mut Graph, body: usize) -> Id {
        let inside = (self.frame.inside)(body);
        let mut sum = graph.zero();
        for pair in
            self.attraction.pairs.iter().filter(|pair| pair.bodies[1] == body && inside.contains(&pair.bodies[0]))
        {
            sum = graph.build(sum + pair.strength / self.masses.each[body]);
        }
        sum
    }

    /// Returns V + Σ k/|Q|. Attractions between body 0 and bodies with offset Q cancel and are omitted.
    fn rest(&self, graph: &mut Graph) -> Id {
        let along: Vec<Offsets> = (0..self.dimensions)
            .map(|d| {
                let inner = self.positions(graph, d);
                (self.frame.leave)(graph, &self.masses, &inner)
            })
            .collect();
        let mut about_first =
            |body: usize| (0..self.dimensions).all(|d| along[d].each[body] == self.position(graph, body, d));
        let solved: Vec<bool> = (0..self.count()).map(|body| body > 0 && about_first(body)).collect();
        let pairs = self.attraction.pairs.iter().filter(|pair| pair.bodies[0] != 0 || !solved[pair.bodies[1]]);
        let terms: Vec<Id> = pairs.map(|pair| pair.term).chain(self.attraction.others.iter().copied()).collect();
        let mut terms = self.in_inner_positions(graph, &terms, &along);
        for body in (1..self.count()).filter(|body| !solved[*body]) {
            let strength = self.strength_over_mass(graph, body);
            let strength = graph.mul(strength, self.masses.each[body]);
            let q: Vec<Id> = (0..self.dimensions).map(|d| self.position(graph, body, d)).collect();
            let square = graph.dot(&q, &q);
            terms.push(graph.build(strength * pow(square, Ratio { numerator: -1, denominator: 2 })));
        }
        graph.sum(&terms)
    }

    /// Replaces positions in terms by inner positions. In sums of positions with total weight zero, the position of body 0 cancels.
    fn in_inner_positions(&self, graph: &mut Graph, terms: &[Id], along: &[Offsets]) -> Vec<Id> {
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
            // The weight of body 0 along each direction.
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

    /// Returns the part of the kinetic energy that belongs to no single body. It moves all bodies but body 0 alike. Thus it commutes with kicks that
    /// read only differences of the positions of these bodies: such kicks keep the sum of their momenta.
    fn jump(&self, graph: &mut Graph, kick: Id) -> Option<Jump> {
        let jump = self.frame.jump?;
        let (mut velocity, mut squares) = (vec![graph.zero(); self.count() * self.dimensions], vec![]);
        for d in 0..self.dimensions {
            let inner = self.momenta(graph, d);
            let along = jump(graph, &self.masses, &inner);
            (1..self.count()).for_each(|body| velocity[self.index(body, d)] = along);
            // The energy is a function of momenta.
            let weighted: Vec<Id> = inner
                .iter()
                .zip(&self.masses.each)
                .map(|(p, mass)| graph.build(self.masses.each[0] / *mass * *p))
                .collect();
            let momentum = jump(graph, &self.masses, &weighted);
            squares.push(graph.build(squared(momentum)));
        }
        let square = graph.sum(&squares);
        let twice = graph.div(square, self.masses.each[0]);
        let slopes = diff::gradient(graph, kick, velocity.len() as u32).q;
        let commutes = (0..self.dimensions).all(|d| {
            let along: Vec<Id> = (1..self.count()).map(|body| slopes[self.index(body, d)]).collect();
            let sum = graph.sum(&along);
            analyze::identity(graph, sum).is_zero()
        });
        Some(Jump { energy: graph.scale(Number::HALF, twice), velocity, commutes })
    }

    /// Returns the motion of each body about its centre: Kepler motion, or uniform motion without an attraction.
    fn motion(&self, graph: &mut Graph) -> OrbitalMotion {
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
            terms.push(graph.build(Number::HALF * (inverse * speed)));
            let over_mass = self.strength_over_mass(graph, body);
            if body == 0 || graph.is_zero(over_mass) {
                for (i, v) in of_body.zip(v) {
                    flow.q[i] = graph.build(flow.q[i] + h * v);
                }
                continue;
            }
            let (square, radial) = (graph.dot(&q, &q), graph.dot(&q, &v));
            let strength = graph.mul(over_mass, ratio);
            let args = [square, radial, speed, strength, h];
            let [f, g, f_rate, g_rate] = Function::KEPLER.map(|function| graph.call(function, &args));
            let recip = graph.pow(square, Ratio { numerator: -1, denominator: 2 });
            terms.push(graph.build(-(over_mass * mass * recip)));
            for (i, (q, v)) in of_body.zip(q.into_iter().zip(v)) {
                for (x, weights) in [(&mut flow.q[i], [f, g]), (&mut flow.p[i], [f_rate, g_rate])] {
                    let added = graph.dot(&weights, &[q, v]);
                    *x = graph.add(*x, added);
                }
            }
        }
        OrbitalMotion { energy: graph.sum(&terms), flow, weights }
    }

    /// Returns the inner positions and velocities as functions of positions and momenta.
    fn enter(&self, graph: &mut Graph) -> Vec<(Symbol, Id)> {
        let mut inner = vec![];
        for d in 0..self.dimensions {
            let (q, p) = (self.positions(graph, d), self.momenta(graph, d));
            let v: Vec<Id> = p.into_iter().zip(&self.masses.each).map(|(p, mass)| graph.div(p, *mass)).collect();
            let q = (self.frame.enter)(graph, &self.masses, &q);
            let v = (self.frame.enter_velocities)(graph, &self.masses, &v);
            inner.extend(self.with_symbols(d, q, v));
        }
        inner
    }

    /// Returns the positions and momenta as functions of inner positions and velocities.
    fn leave(&self, graph: &mut Graph) -> Vec<(Symbol, Id)> {
        let mut outer = vec![];
        for d in 0..self.dimensions {
            let (q, v) = (self.positions(graph, d), self.momenta(graph, d));
            let q = (self.frame.leave)(graph, &self.masses, &q).places(graph);
            let v = (self.frame.leave_velocities)(graph, &self.masses, &v);
            let p = v.into_iter().zip(&self.masses.each).map(|(v, mass)| graph.mul(*mass, v)).collect();
            outer.extend(self.with_symbols(d, q, p));
        }
        outer
    }

    /// Returns positions and momenta of all bodies along a direction with their symbols.
    fn with_symbols(&self, d: usize, q: Vec<Id>, p: Vec<Id>) -> impl Iterator<Item = (Symbol, Id)> {
        let index = move |body: usize| self.index(body, d) as u32;
        let positions = q.into_iter().enumerate().map(move |(body, q)| (Symbol::Position(index(body)), q));
        positions.chain(p.into_iter().enumerate().map(move |(body, p)| (Symbol::Momentum(index(body)), p)))
    }
}
