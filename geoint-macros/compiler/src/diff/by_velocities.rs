//! Expresses ∂H/∂q by velocities, for Taylor series: ∂H/∂q = −∂L/∂q for the Lagrangian L of H.
//!
//! For H = pᵀA(q)p/2 + … and M = A⁻¹, it is −vᵀ(∂M/∂q)v/2 + … with v = Ap. The equation q' = ∂H/∂p needs v anyway. M is often shorter than A, for
//! most machines for example. A double pendulum then has v₁v₂ sin(q₁ − q₂) in its force: products of series, and no quotient.

use super::forward::{blocks, jacobian};
use super::gradient::{Gradient, gradient};
use crate::analyze;
use crate::ir::formula::squared;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Node, Number, Ratio, Symbol};

/// Computes ∇H with ∂H/∂q by velocities, for parts of H that are quadratic in one or two momenta and have a short M. Returns `None` if no part has.
pub(crate) fn of_energy(graph: &mut Graph, energy: Id, known: &Gradient) -> Option<Gradient> {
    // Most energies have a constant A and leave here.
    let moves = |graph: &Graph, id: Id| graph.reads(id).q || graph.reads(id).t || graph.reads(id).s;
    if !known.p.iter().any(|velocity| graph.reads(*velocity).p && moves(graph, *velocity)) {
        return None;
    }
    let momenta: Vec<Symbol> = (0..).map(Symbol::Momentum).take(known.p.len()).collect();
    let inverse = jacobian(graph, &known.p, &momenta);
    let (mut kinetic, mut quadratic) = (vec![], vec![]);
    for block in blocks(graph, &inverse) {
        let entries = || block.iter().flat_map(|i| &inverse[*i as usize]);
        let changes = entries().any(|entry| moves(graph, *entry)) && !entries().any(|entry| graph.reads(*entry).p);
        let Some(mass) = changes.then(|| mass(graph, &inverse, &block)).flatten() else { continue };
        for (row, i) in mass.iter().zip(&block) {
            for (entry, j) in row.iter().zip(&block) {
                let velocities = [*i, *j].map(|i| graph.symbol(Symbol::Velocity(i)));
                kinetic.push(graph.product(&[*entry, velocities[0], velocities[1]]));
            }
        }
        quadratic.extend(block);
    }
    if quadratic.is_empty() {
        return None;
    }
    let twice = graph.sum(&kinetic);
    let kinetic = graph.build(Number::HALF * twice);
    // Subtract the squares from H, and the velocities at p = 0 from the velocities.
    let zero = graph.zero();
    let at_rest = |_: &mut Graph, symbol: Symbol| match symbol {
        Symbol::Momentum(i) if quadratic.contains(&i) => Some(zero),
        _ => None,
    };
    let mut at_rest = Substitution::new(at_rest);
    let mut rest = vec![at_rest.apply(graph, energy)];
    let mut velocities = known.p.clone();
    for i in &quadratic {
        let velocity = &mut velocities[*i as usize];
        let shift = at_rest.apply(graph, *velocity);
        let momentum = graph.symbol(Symbol::Momentum(*i));
        rest.push(graph.mul(shift, momentum));
        *velocity = graph.sub(*velocity, shift);
    }
    let rest = graph.sum(&rest);
    let degrees = known.q.len() as u32;
    let rest = gradient(graph, rest, degrees).q;
    let forces = gradient(graph, kinetic, degrees).q;
    Some(by_velocities(graph, known, &rest, &forces, &velocities))
}

/// Computes ∇H for the energy of a Lagrangian, from ∂L/∂q.
pub(crate) fn of_lagrangian(graph: &mut Graph, forces: &[Id], known: &Gradient) -> Gradient {
    let rest = vec![graph.zero(); forces.len()];
    by_velocities(graph, known, &rest, forces, &known.p)
}

/// ∂H/∂q = rest − forces, with the symbols of velocities in the forces replaced by velocities.
fn by_velocities(graph: &mut Graph, known: &Gradient, rest: &[Id], forces: &[Id], velocities: &[Id]) -> Gradient {
    // The graph writes (−u)² as u². Products take this sign of u, too, and so share factors with squares. Pairs are (signed symbol, signed velocity).
    let mut signed = vec![];
    for (i, velocity) in (0..).zip(velocities) {
        let symbol = graph.symbol(Symbol::Velocity(i));
        let is_sum = matches!(graph.node(*velocity), Node::Linear(_, terms) if terms.len() > 1);
        signed.push(match is_sum && graph.leads_negative(*velocity) {
            true => (graph.neg(symbol), graph.negated_sum(*velocity)),
            false => (symbol, *velocity),
        });
    }
    let find = |symbol: Symbol| match symbol {
        Symbol::Velocity(i) => signed.get(i as usize).copied(),
        _ => None,
    };
    let mut sign = Substitution::new(|_: &mut Graph, symbol| find(symbol).map(|(symbol, _)| symbol));
    let mut velocity = Substitution::new(|_: &mut Graph, symbol| find(symbol).map(|(_, velocity)| velocity));
    let by_q = rest.iter().zip(forces).map(|(rest, force)| {
        let force = sign.apply(graph, *force);
        let force = velocity.apply(graph, force);
        graph.sub(*rest, force)
    });
    Gradient { q: by_q.collect(), ..known.clone() }
}

/// M of one or two momenta if it is short: A = Q/d, where the determinant of Q is constant or a constant multiple of d.
fn mass(graph: &mut Graph, inverse: &[Vec<Id>], block: &[u32]) -> Option<Vec<Vec<Id>>> {
    let entry = |i: usize, j: usize| inverse[block[i] as usize][block[j] as usize];
    match block.len() {
        1 if !graph.is_zero(entry(0, 0)) => {
            let d = denominator(graph, &[entry(0, 0)]);
            Some(vec![vec![graph.build(d / (entry(0, 0) * d))]])
        }
        2 => {
            let entries = [entry(0, 0), entry(0, 1), entry(1, 1)];
            let d = denominator(graph, &entries);
            let [first, mixed, second] = entries.map(|entry| graph.mul(entry, d));
            let square = graph.build(squared(mixed));
            let determinant = graph.build(first * second - square);
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

/// The common denominator of all nodes that are not zero.
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
    let power = |(base, exponent): (Id, Ratio)| graph.pow(base, Ratio::integer(-exponent.numerator));
    let factors: Vec<Id> = common.unwrap_or_default().into_iter().map(power).collect();
    graph.product(&factors)
}
