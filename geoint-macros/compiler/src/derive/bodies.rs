//! Routines of H(r, m, t) of rigid bodies, and of H(r, q, m, p, t) of rigid bodies with centres of mass.

use super::domain::{Domain, Formulas};
use super::poles::DistinctNodes;
use super::system::{BodyKernels, FlowKernel, Kernels, Shift, System, Turn, grown};
use crate::analyze::{self, momenta_of_body as momenta};
use crate::compilation::Compilation;
use crate::diff;
use crate::ir::{Graph, Id, Number, Symbol, UndefinedAt};
use crate::schedule::{Levels, Routine, phase};

/// Derives the routines of every method.
pub(crate) fn bodies(compilation: &mut Compilation<'_>, found: &analyze::Bodies, partial: &[UndefinedAt]) -> System {
    let (positions, graph) = (compilation.positions(), &mut compilation.graph);
    let [h, g] = [Symbol::StepLength, Symbol::GradientWeight].map(|symbol| graph.symbol(symbol));
    // The factor h is inside the derivative. It thus meets the constants of every term.
    let generator = graph.mul(h, found.potential);
    let generator = graph.neg(generator);
    let impulse = impulses(graph, generator, found);
    let kick = kick(graph, &impulse);

    let potential = graph.neg(found.potential);
    let torque = impulses(graph, potential, found);
    // [V, [T, V]] = τ·Jτ + F·M⁻¹F is a function of r and q.
    let mut squares = vec![];
    for (torque, inertia) in torque.iter().zip(&found.inertia) {
        squares.extend(quadratic_form(graph, &inertia.inverse, torque));
    }
    let forces = torque[found.inertia.len()..].concat();
    squares.extend(quadratic_form(graph, &found.inverse_mass, &forces));
    let square = graph.sum(&squares);
    let correction = graph.mul(g, square);
    let generator = graph.add(generator, correction);
    let impulse = impulses(graph, generator, found);
    let gradient_kick = self::kick(graph, &impulse);

    let mut entries = DistinctNodes::default();
    let mut place = |graph: &mut Graph, entry: Id| {
        let scaled = (!graph.is_zero(entry)).then(|| graph.mul(h, entry));
        scaled.map(|entry| entries.place(entry))
    };
    let mut turns = vec![];
    for inertia in &found.inertia {
        let linear = inertia.inverse.map(|row| row.map(|entry| place(graph, entry)));
        let constant = inertia.constant.map(|entry| place(graph, entry));
        turns.push(Turn { linear, constant, symmetry: inertia.symmetry(graph) });
    }
    let rows = found.inertia.len()..found.velocity.len();
    let momenta_of_centres: Vec<Symbol> = rows.clone().flat_map(|row| momenta(row as u32)).collect();
    let mut shift = |coordinate: usize| {
        let entries = found.inverse_mass[coordinate].iter().zip(&momenta_of_centres);
        let linear = entries.filter_map(|(entry, symbol)| Some((place(graph, *entry)?, *symbol))).collect();
        Shift { linear, constant: place(graph, found.streaming[coordinate]) }
    };
    let centres = (0..rows.len()).map(|centre| [0, 1, 2].map(|axis| shift(3 * centre + axis))).collect();
    let kernels = BodyKernels {
        kick,
        gradient_kick,
        drift: Routine::row("prepare_drift", entries.0),
        turns,
        centres,
        principal: found.inertia.iter().all(|inertia| inertia.is_principal(graph)),
        kicks_repeat: found.autonomous,
    };
    let rates = rates(graph, found, &torque);
    let domain = Domain::of(graph, compilation.form, Formulas::new(&[found.energy], partial));
    System {
        value: Some(Routine::number("hamiltonian", found.energy)),
        rate: Some(Routine::array("rate", "slopes", &phase(&positions), rates)),
        ..System::new(Kernels::Bodies(kernels), domain)
    }
}

/// Returns the terms of v·Av.
fn quadratic_form(graph: &mut Graph, matrix: &[impl AsRef<[Id]>], v: &[Id]) -> Vec<Id> {
    let mut terms = vec![];
    for (row, x) in matrix.iter().zip(v) {
        for (entry, y) in row.as_ref().iter().zip(v) {
            terms.push(graph.product(&[*entry, *x, *y]));
        }
    }
    terms
}

/// Returns the attitude of a body: the components i, j, k and w of a quaternion.
fn attitude(graph: &mut Graph, body: u32) -> [Id; 4] {
    [0, 1, 2, 3].map(|i| graph.symbol(Symbol::Position(4 * body + i)))
}

/// Returns the derivatives of a function G(r, q): ½ (r⊗eᵢ)·∂G/∂r for rotations of each body about its axes, then ∂G/∂q for each centre of mass.
fn impulses(graph: &mut Graph, generator: Id, found: &analyze::Bodies) -> Vec<[Id; 3]> {
    let (bodies, rows) = (found.inertia.len(), found.velocity.len());
    let slopes = diff::gradient(graph, generator, 4 * rows as u32).q;
    let (zero, one) = (graph.zero(), graph.integer(1));
    let mut impulses = vec![];
    for row in 0..rows {
        let slope: [Id; 4] = core::array::from_fn(|i| slopes[4 * row + i]);
        if row >= bodies {
            impulses.push([slope[0], slope[1], slope[2]]);
            continue;
        }
        let r = attitude(graph, row as u32);
        impulses.push([[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(|axis| {
            let turned = turned(graph, r, axis);
            let rate = graph.dot(&turned, &slope);
            graph.scale(Number::HALF, rate)
        }));
    }
    impulses
}

/// Returns r⊗(0, v).
fn turned(graph: &mut Graph, [i, j, k, w]: [Id; 4], [a, b, c]: [Id; 3]) -> [Id; 4] {
    let mut sum = |plus: &[[Id; 2]], minus: &[[Id; 2]]| {
        let mut terms: Vec<Id> = plus.iter().map(|[x, v]| graph.mul(*x, *v)).collect();
        for [x, v] in minus {
            let product = graph.mul(*x, *v);
            terms.push(graph.neg(product));
        }
        graph.sum(&terms)
    };
    [
        sum(&[[w, a], [j, c]], &[[k, b]]),
        sum(&[[w, b], [k, a]], &[[i, c]]),
        sum(&[[w, c], [i, b]], &[[j, a]]),
        sum(&[], &[[i, a], [j, b], [k, c]]),
    ]
}

/// Creates the flow m ← m + impulse. The terms of an impulse are summed first, so that m is rounded once.
fn kick(graph: &mut Graph, impulses: &[[Id; 3]]) -> FlowKernel {
    let changes = impulses.iter().zip(0..).flat_map(|(impulse, body)| momenta(body).into_iter().zip(*impulse));
    FlowKernel::new(Levels::Prepared, grown(graph, changes))
}

/// Returns the rates as an array of quaternions: r' = ½ r⊗(0, ω) and q', then m' = m × ω + τ and p'.
fn rates(graph: &mut Graph, found: &analyze::Bodies, impulses: &[[Id; 3]]) -> Vec<Id> {
    let bodies = found.inertia.len() as u32;
    let zero = graph.zero();
    let (mut places, mut changes) = (vec![], vec![]);
    for ((velocity, impulse), row) in found.velocity.iter().zip(impulses).zip(0..) {
        if row >= bodies {
            places.extend([&velocity[..], &[zero]].concat());
            changes.extend([&impulse[..], &[zero]].concat());
            continue;
        }
        let r = attitude(graph, row);
        places.extend(turned(graph, r, *velocity).map(|x| graph.scale(Number::HALF, x)));
        let m = momenta(row).map(|symbol| graph.symbol(symbol));
        for (i, torque) in impulse.iter().enumerate() {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let (first, second) = (graph.mul(m[j], velocity[k]), graph.mul(m[k], velocity[j]));
            let second = graph.neg(second);
            changes.push(graph.sum(&[first, second, *torque]));
        }
        changes.push(zero);
    }
    [places, changes].concat()
}
