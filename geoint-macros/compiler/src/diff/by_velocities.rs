//! ∂H/∂q in velocities, which q' = ∂H/∂p needs anyway: with H = pᵀA(q)p/2 + … and M = A⁻¹ it is −vᵀ(∂M/∂q)v/2 + …, where v = Ap.
//!
//! That is ∂H/∂q = −∂L/∂q for the Lagrangian that belongs to H. Where M is shorter than A, as of most machines, so is this: a double pendulum has
//! v₁v₂ sin(q₁ − q₂) in it, one product of series after the other, and no quotient.

use super::gradient::{Gradient, gradient};
use super::jacobian;
use crate::analyze;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Node, Number, Ratio, Symbol};

/// ∇H with ∂H/∂q in velocities, for the parts that are quadratic in one momentum or two, and whose M is known.
pub(crate) fn of_energy(graph: &mut Graph, energy: Id, known: &Gradient) -> Option<Gradient> {
    // Most energies have a constant A.
    let moves = |graph: &Graph, id: Id| graph.reads(id).q || graph.reads(id).t || graph.reads(id).s;
    if !known.p.iter().any(|velocity| graph.reads(*velocity).p && moves(graph, *velocity)) {
        return None;
    }
    let momenta: Vec<Symbol> = (0..).map(Symbol::Momentum).take(known.p.len()).collect();
    let inverse = jacobian(graph, &known.p, &momenta);
    let (mut kinetic, mut taken) = (vec![], vec![]);
    for part in parts(graph, &inverse) {
        let entries = || part.iter().flat_map(|i| &inverse[*i]);
        let changes = entries().any(|entry| moves(graph, *entry)) && !entries().any(|entry| graph.reads(*entry).p);
        let Some(mass) = changes.then(|| mass(graph, &inverse, &part)).flatten() else { continue };
        for (row, i) in mass.iter().zip(&part) {
            for (entry, j) in row.iter().zip(&part) {
                let velocities = [*i, *j].map(|i| graph.symbol(Symbol::Velocity(i as u32)));
                kinetic.push(graph.product(&[*entry, velocities[0], velocities[1]]));
            }
        }
        taken.extend(part);
    }
    if taken.is_empty() {
        return None;
    }
    let kinetic = graph.sum(&kinetic);
    let kinetic = graph.scale(Number::HALF, kinetic);
    // H without those squares, and velocities without what momenta do not give.
    let zero = graph.zero();
    let at_rest = |_: &mut Graph, symbol: Symbol| match symbol {
        Symbol::Momentum(i) if taken.contains(&(i as usize)) => Some(zero),
        _ => None,
    };
    let mut at_rest = Substitution::new(at_rest);
    let mut rest = vec![at_rest.apply(graph, energy)];
    let mut velocities = known.p.clone();
    for i in &taken {
        let shift = at_rest.apply(graph, known.p[*i]);
        let momentum = graph.symbol(Symbol::Momentum(*i as u32));
        rest.push(graph.mul(shift, momentum));
        velocities[*i] = graph.sub(velocities[*i], shift);
    }
    let rest = graph.sum(&rest);
    let degrees = known.q.len() as u32;
    let rest = gradient(graph, rest, degrees).q;
    let forces = gradient(graph, kinetic, degrees).q;
    Some(replaced(graph, known, (&rest, &forces), &velocities))
}

/// ∇H of a Lagrangian's energy, from ∂L/∂q.
pub(crate) fn of_lagrangian(graph: &mut Graph, forces: &[Id], known: &Gradient) -> Gradient {
    let rest = vec![graph.zero(); forces.len()];
    replaced(graph, known, (&rest, forces), &known.p)
}

/// ∂H/∂q = rest − forces, with velocities in place of their symbols.
fn replaced(graph: &mut Graph, known: &Gradient, (rest, forces): (&[Id], &[Id]), velocities: &[Id]) -> Gradient {
    // Squares are those of the sum with one of both signs. Products shall be of the same, so that they have a factor in common.
    let signed: Vec<(bool, Id)> = velocities.iter().map(|velocity| with_sign_of_square(graph, *velocity)).collect();
    let of = |symbol: Symbol| match symbol {
        Symbol::Velocity(i) => signed.get(i as usize).copied(),
        _ => None,
    };
    let mut sign = Substitution::new(|graph: &mut Graph, symbol| {
        let negative = of(symbol).is_some_and(|(negative, _)| negative);
        negative.then(|| {
            let symbol = graph.symbol(symbol);
            graph.neg(symbol)
        })
    });
    let mut velocity = Substitution::new(|_: &mut Graph, symbol| of(symbol).map(|(_, velocity)| velocity));
    let by_q = rest.iter().zip(forces).map(|(rest, force)| {
        let force = sign.apply(graph, *force);
        let force = velocity.apply(graph, force);
        graph.sub(*rest, force)
    });
    Gradient { q: by_q.collect(), ..known.clone() }
}

/// u, or −u if that is the base of u².
fn with_sign_of_square(graph: &mut Graph, u: Id) -> (bool, Id) {
    let sum = matches!(graph.node(u), Node::Linear(_, terms) if terms.len() > 1);
    if sum && graph.leads_negative(u) { (true, graph.negated_sum(u)) } else { (false, u) }
}

/// Momenta that A couples, in order.
fn parts(graph: &Graph, inverse: &[Vec<Id>]) -> Vec<Vec<usize>> {
    let mut left: Vec<usize> = (0..inverse.len()).rev().collect();
    let mut parts = vec![];
    while let Some(first) = left.pop() {
        let (mut part, mut open) = (vec![first], vec![first]);
        while let Some(i) = open.pop() {
            let (coupled, rest) = left.iter().partition::<Vec<usize>, _>(|j| !graph.is_zero(inverse[i][**j]));
            left = rest;
            part.extend(&coupled);
            open.extend(coupled);
        }
        part.sort_unstable();
        parts.push(part);
    }
    parts
}

/// M of one momentum or two, if that is short: A = Q/d with a determinant of Q that is proven to be a number, or c·d.
fn mass(graph: &mut Graph, inverse: &[Vec<Id>], part: &[usize]) -> Option<Vec<Vec<Id>>> {
    let entry = |i: usize, j: usize| inverse[part[i]][part[j]];
    match part.len() {
        1 if !graph.is_zero(entry(0, 0)) => {
            let d = denominator(graph, &[entry(0, 0)]);
            let rest = graph.mul(entry(0, 0), d);
            Some(vec![vec![graph.div(d, rest)]])
        }
        2 => {
            let entries = [entry(0, 0), entry(0, 1), entry(1, 1)];
            let d = denominator(graph, &entries);
            let [first, mixed, second] = entries.map(|entry| graph.mul(entry, d));
            let square = graph.pow(mixed, Ratio::integer(2));
            let product = graph.mul(first, second);
            let determinant = graph.sub(product, square);
            let factor = match graph.reads(determinant).moves() {
                true => {
                    let c = analyze::multiple(graph, determinant, d)?;
                    graph.recip(c)
                }
                false => graph.div(d, determinant),
            };
            let mixed = graph.neg(mixed);
            let [first, mixed, second] = [first, mixed, second].map(|entry| graph.mul(factor, entry));
            Some(vec![vec![second, mixed], vec![mixed, first]])
        }
        _ => None,
    }
}

/// What all of the nodes that are not zero are divided by.
fn denominator(graph: &mut Graph, nodes: &[Id]) -> Id {
    let mut common: Option<Vec<(Id, Ratio)>> = None;
    for node in nodes.iter().filter(|node| !graph.is_zero(**node)) {
        let factors = graph.factors(graph.coefficient(*node).1);
        let divided = factors.into_iter().filter(|(_, exponent)| exponent.numerator < 0 && exponent.is_integer());
        common = Some(match common {
            None => divided.collect(),
            Some(common) => {
                let divided: Vec<_> = divided.collect();
                common.into_iter().filter(|factor| divided.contains(factor)).collect()
            }
        });
    }
    let factors: Vec<Id> = common
        .unwrap_or_default()
        .into_iter()
        .map(|(base, exponent)| graph.pow(base, Ratio::integer(-exponent.numerator)))
        .collect();
    graph.product(&factors)
}
