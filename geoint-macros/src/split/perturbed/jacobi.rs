//! Jacobi's coordinates: each body as seen from the centre of mass of those before it.
//!
//! Momenta are velocities here: V_i is made of p_j/m_j as Q_i is of q_j. With η_i the mass of bodies 0…i and R_i = R_{i−1} + (m_i/η_i) Q_i:
//! q_i = q₀ + Q_i + R_{i−1}, Q₀ and P₀ those of all together. Sums stay nested as written here, so that they, and the reverse sweep through
//! them, cost as much for each body, not for each pair. J. Wisdom & M. Holman, Astron. J. 102 (1991) 1528; H. Rein & D. Tamayo, Mon. Not.
//! R. Astron. Soc. 452 (2015) 376.

use super::super::flow::Flow;
use super::super::time::Clock;
use super::attraction::Attraction;
use super::{Inner, Perturbed, halved};
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};
use crate::parse::Shape;

/// Bodies in a row.
struct Bodies<'a> {
    attraction: &'a Attraction,
    dimensions: usize,
    /// η.
    sums: Vec<Id>,
    /// mᵢ/η_i.
    shares: Vec<Id>,
}

/// A: each body about a fixed centre, with the attraction of all bodies before it; B: V less that.
pub(super) fn perturbed(graph: &mut Graph, attraction: &Attraction, shape: &Shape) -> Perturbed {
    let dimensions = shape.extents[1];
    let (mut sums, mut shares): (Vec<Id>, Vec<Id>) = (vec![], vec![]);
    for (i, mass) in attraction.masses.iter().enumerate() {
        let sum = if i == 0 { *mass } else { graph.add(*mass, sums[i - 1]) };
        sums.push(sum);
        shares.push(graph.div(*mass, sum));
    }
    let bodies = Bodies { attraction, dimensions, sums, shares };
    let rest = bodies.rest(graph);
    let (exact, flow, weights) = bodies.motion(graph);
    let velocity = (0..).zip(&weights).map(|(i, weight)| {
        let p = graph.symbol(Symbol::P(i));
        graph.mul(*weight, p)
    });
    let velocity = velocity.collect();
    Perturbed {
        exact,
        rest,
        flow,
        clock: Clock::Own,
        known: vec![KEPLER.into()],
        velocity: Ok(velocity),
        inner: Some(Inner { name: "Jacobi", enter: bodies.enter(graph), leave: bodies.leave(graph), weights }),
    }
}

const KEPLER: &str =
    "Kepler's motion: p²/2m − k/|q| (J. Wisdom & D. M. Hernandez, Mon. Not. R. Astron. Soc. 453 (2015) 3015)";

impl Bodies<'_> {
    fn count(&self) -> usize {
        self.attraction.masses.len()
    }

    /// A coordinate of a body.
    fn symbol(&self, graph: &mut Graph, of: fn(u32) -> Symbol, body: usize, d: usize) -> Id {
        graph.symbol(of((body * self.dimensions + d) as u32))
    }

    /// k_i = Σ c_ji, of a body and all before it, over the mass of the body: where c has that mass as a factor it is not divided by, so
    /// that bodies may be as light as they like.
    fn strength_over_mass(&self, graph: &mut Graph, body: usize) -> Id {
        let mut sum = graph.zero();
        for pair in self.attraction.pairs.iter().filter(|pair| pair.bodies[1] == body) {
            let part = graph.div(pair.strength, self.attraction.masses[body]);
            sum = graph.add(sum, part);
        }
        sum
    }

    /// Distances from body 0 along one direction: Q_i + R_{i−1} from positions, and in the same way from velocities.
    fn offsets(&self, graph: &mut Graph, inner: &[Id]) -> (Vec<Id>, Id) {
        let (mut offsets, mut sum) = (vec![graph.zero()], graph.zero());
        for i in 1..self.count() {
            let offset = graph.add(inner[i], sum);
            offsets.push(offset);
            let part = graph.mul(self.shares[i], inner[i]);
            sum = graph.add(part, sum);
        }
        (offsets, sum)
    }

    /// V + Σ k/|Q|, in which the pair of the first two bodies is no more.
    fn rest(&self, graph: &mut Graph) -> Id {
        let (mut offsets, mut first) = (vec![vec![]; self.count()], vec![]);
        for d in 0..self.dimensions {
            let inner: Vec<Id> = (0..self.count()).map(|i| self.symbol(graph, Symbol::Q, i, d)).collect();
            let (along, sum) = self.offsets(graph, &inner);
            offsets.iter_mut().zip(along).for_each(|(offsets, along)| offsets.push(along));
            first.push(graph.sub(inner[0], sum));
        }
        let pairs = self.attraction.pairs.iter().filter(|pair| pair.bodies != [0, 1]).map(|pair| pair.term);
        let terms: Vec<Id> = pairs.chain(self.attraction.others.iter().copied()).collect();
        let mut terms = self.moved(graph, &terms, (&offsets, &first));
        for body in 2..self.count() {
            let strength = self.strength_over_mass(graph, body);
            let strength = graph.mul(strength, self.attraction.masses[body]);
            let squares: Vec<Id> = (0..self.dimensions)
                .map(|d| {
                    let q = self.symbol(graph, Symbol::Q, body, d);
                    graph.pow(q, Ratio::integer(2))
                })
                .collect();
            let square = graph.sum(&squares);
            let recip = graph.pow(square, Ratio { numerator: -1, denominator: 2 });
            terms.push(graph.mul(strength, recip));
        }
        graph.sum(&terms)
    }

    /// Terms with positions replaced by inner ones. Differences of positions are those of offsets: where body 0 is drops out of them.
    fn moved(&self, graph: &mut Graph, terms: &[Id], (offsets, first): (&[Vec<Id>], &[Id])) -> Vec<Id> {
        let place = |i: u32| (i as usize / self.dimensions, i as usize % self.dimensions);
        let mut substitution = Substitution::new(|graph: &mut Graph, symbol| match symbol {
            Symbol::Q(i) => {
                let (body, d) = place(i);
                Some(graph.add(first[d], offsets[body][d]))
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
                    Node::Symbol(Symbol::Q(i)) => {
                        let (body, d) = place(*i);
                        whole[d] = whole[d].add(c);
                        moved.push((c, offsets[body][d]));
                    }
                    _ => moved.push((c, substitution.apply(graph, term))),
                }
            }
            moved.extend(whole.into_iter().zip(first).map(|(c, first)| (c, *first)));
            moved.retain(|(c, id)| !c.is_zero() && !graph.is_zero(*id));
            let replacement = graph.linear(constant, moved);
            substitution.insert(id, replacement);
        }
        terms.iter().map(|term| substitution.apply(graph, *term)).collect()
    }

    /// A, its flow for velocities in place of momenta, and the masses with which bodies move, each 1 over it.
    ///
    /// A mass that momenta are divided by and multiplied with again, both rounded, would let the energy drift.
    fn motion(&self, graph: &mut Graph) -> (Id, Flow, Vec<Id>) {
        let degrees = (self.count() * self.dimensions) as u32;
        let mut flow = Flow::rest(graph, degrees);
        let h = graph.symbol(Symbol::H);
        let (mut terms, mut weights) = (vec![], vec![]);
        for body in 0..self.count() {
            let of_body = body * self.dimensions..(body + 1) * self.dimensions;
            let (q, v) = (flow.q[of_body.clone()].to_vec(), flow.p[of_body.clone()].to_vec());
            let mass = self.attraction.masses[body];
            // η_i/η_{i−1}; of the first one, which stands for all, only the mass is another.
            let ratio = if body == 0 {
                graph.div(mass, self.sums[self.count() - 1])
            } else {
                graph.div(self.sums[body], self.sums[body - 1])
            };
            let inverse = graph.div(ratio, mass);
            weights.extend(of_body.clone().map(|_| inverse));
            let dot = |graph: &mut Graph, a: &[Id], b: &[Id]| {
                let products: Vec<Id> = a.iter().zip(b).map(|(a, b)| graph.mul(*a, *b)).collect();
                graph.sum(&products)
            };
            let speed = dot(graph, &v, &v);
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
            let (distance, falling) = (dot(graph, &q, &q), dot(graph, &q, &v));
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

    /// Q_i = q_i − X_{i−1} with the centre of mass X of those before, and velocities in the same way.
    fn enter(&self, graph: &mut Graph) -> Vec<(Symbol, Id)> {
        let mut inner = vec![];
        for symbol in [Symbol::Q as fn(u32) -> Symbol, Symbol::P] {
            for d in 0..self.dimensions {
                let of = |body: usize| symbol((body * self.dimensions + d) as u32);
                let mut centre = self.motion_of(graph, symbol, 0, d);
                for body in 1..self.count() {
                    let x = self.motion_of(graph, symbol, body, d);
                    let from_centre = graph.sub(x, centre);
                    inner.push((of(body), from_centre));
                    let shift = graph.mul(self.shares[body], from_centre);
                    centre = graph.add(shift, centre);
                }
                inner.push((of(0), centre));
            }
        }
        inner
    }

    /// A position, or p/m.
    fn motion_of(&self, graph: &mut Graph, symbol: fn(u32) -> Symbol, body: usize, d: usize) -> Id {
        let x = self.symbol(graph, symbol, body, d);
        if symbol(0) == Symbol::P(0) { graph.div(x, self.attraction.masses[body]) } else { x }
    }

    /// q₀ = Q₀ − R, q_i = q₀ + Q_i + R_{i−1}, and velocities in the same way.
    fn leave(&self, graph: &mut Graph) -> Vec<(Symbol, Id)> {
        let mut outer = vec![];
        for symbol in [Symbol::Q as fn(u32) -> Symbol, Symbol::P] {
            let is_momentum = symbol(0) == Symbol::P(0);
            for d in 0..self.dimensions {
                let inner: Vec<Id> = (0..self.count()).map(|i| self.symbol(graph, symbol, i, d)).collect();
                let (offsets, sum) = self.offsets(graph, &inner);
                let first = graph.sub(inner[0], sum);
                for (body, offset) in offsets.into_iter().enumerate() {
                    let x = graph.add(first, offset);
                    let x = if is_momentum { graph.mul(self.attraction.masses[body], x) } else { x };
                    outer.push((symbol((body * self.dimensions + d) as u32), x));
                }
            }
        }
        outer
    }
}
