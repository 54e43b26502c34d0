//! What is derived from H(r, m, t) of rigid bodies, and from H(r, q, m, p, t) of those with centres of mass.

use super::domain::{Domain, Friction, Roots};
use super::system::{FlowKernel, Implicit, System};
use crate::analyze::{self, momenta_of_body as momenta};
use crate::diff;
use crate::ir::{Graph, Id, Number, Symbol, UndefinedAt};
use crate::parse::Form;
use crate::schedule::{Levels, Output, Routine, Scheduler, phase};

/// Kicks and drifts of rigid bodies.
#[derive(Debug)]
pub(crate) struct BodyKernels {
    pub(crate) kick: FlowKernel,
    pub(crate) gradient_kick: FlowKernel,
    /// Entries of hJ and hb of every body that are not zero, and of hM⁻¹.
    pub(crate) drift: Routine,
    /// Where the entries of each body are.
    pub(crate) turns: Vec<Turn>,
    /// The places of the entries for the coordinates of each centre of mass.
    pub(crate) centres: Vec<[Shift; 3]>,
    /// Whether all frames are those of principal axes.
    pub(crate) principal: bool,
    /// Whether the impulse of a kick depends on positions only.
    pub(crate) repeats: bool,
}

/// hω = hJm + hb of one body, by places in what is prepared for a drift.
#[derive(Clone, Debug, Default)]
pub(crate) struct Turn {
    pub(crate) linear: [[Option<usize>; 3]; 3],
    pub(crate) constant: [Option<usize>; 3],
    /// An axis about which the body is symmetric.
    pub(crate) symmetry: Option<usize>,
}

/// What a drift adds to a coordinate of a centre of mass: Σ of prepared numbers times momenta, and a number alone.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shift {
    pub(crate) linear: Vec<(usize, Symbol)>,
    pub(crate) constant: Option<usize>,
}

/// Derives everything that some method needs.
pub(crate) fn bodies(
    graph: &mut Graph,
    found: &analyze::Bodies,
    partial: &[UndefinedAt],
    positions: &[usize],
) -> System {
    let [h, g] = [Symbol::StepLength, Symbol::GradientWeight].map(|symbol| graph.symbol(symbol));
    // Of −hV as a whole, so that h meets the constants of every term.
    let generator = graph.mul(h, found.potential);
    let generator = graph.neg(generator);
    let impulse = impulses(graph, generator, found);
    let kick = kick(graph, &impulse);

    let potential = graph.neg(found.potential);
    let torque = impulses(graph, potential, found);
    // [V, [T, V]] = τ·Jτ + F·M⁻¹F is a function of r and q.
    let mut squares = vec![];
    for (torque, inertia) in torque.iter().zip(&found.inertia) {
        for i in 0..3 {
            for j in 0..3 {
                squares.push(graph.product(&[inertia.inverse[i][j], torque[i], torque[j]]));
            }
        }
    }
    let forces = torque[found.inertia.len()..].concat();
    for (row, force) in found.inverse_mass.iter().zip(&forces) {
        for (entry, other) in row.iter().zip(&forces) {
            squares.push(graph.product(&[*entry, *force, *other]));
        }
    }
    let square = graph.sum(&squares);
    let correction = graph.mul(g, square);
    let generator = graph.add(generator, correction);
    let impulse = impulses(graph, generator, found);
    let gradient_kick = self::kick(graph, &impulse);

    let mut entries: Vec<Id> = vec![];
    // Equal ones are one.
    let mut place = |graph: &mut Graph, entry: Id| {
        (!graph.is_zero(entry)).then(|| {
            let entry = graph.mul(h, entry);
            entries.iter().position(|other| *other == entry).unwrap_or_else(|| {
                entries.push(entry);
                entries.len() - 1
            })
        })
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
        drift: Routine::row("prepare_drift", entries),
        turns,
        centres,
        principal: found.inertia.iter().all(|inertia| inertia.is_principal(graph)),
        repeats: found.autonomous,
    };
    let rates = rates(graph, found, &torque);
    System {
        facts: vec![],
        value: Some(Routine::number("hamiltonian", found.energy)),
        gradient: None,
        rate: Some(Routine::new("rate", vec![Output::array("slopes", &phase(positions), rates)])),
        splitting: None,
        perturbed: None,
        modified: None,
        pieces: vec![],
        implicit: Implicit::Bodies(kernels),
        integrals: None,
        lagrangian: None,
        jet: None,
        domain: Domain::of(graph, Roots::of_energy(&found.energy), Form::Bodies, partial, Friction::NONE),
    }
}

impl BodyKernels {
    pub(super) fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        self.kick.kernel.schedule(scheduler);
        self.gradient_kick.kernel.schedule(scheduler);
        self.drift.schedule(scheduler);
    }
}

/// The attitude of a body as nodes: i, j, k, w.
fn attitude(graph: &mut Graph, body: u32) -> [Id; 4] {
    [0, 1, 2, 3].map(|i| graph.symbol(Symbol::Position(4 * body + i)))
}

/// What turns every body and moves every centre of mass: ½ (r⊗eᵢ)·∂G/∂r, the rate of G as a body turns about each of its axes, and ∂G/∂q.
fn impulses(graph: &mut Graph, generator: Id, found: &analyze::Bodies) -> Vec<[Id; 3]> {
    let (bodies, rows) = (found.inertia.len() as u32, found.velocity.len() as u32);
    let slopes = diff::gradient(graph, generator, 4 * rows).q;
    let half = Number::HALF;
    let mut impulses = vec![];
    for row in 0..rows {
        let slope = &slopes[4 * row as usize..][..4];
        if row >= bodies {
            impulses.push([slope[0], slope[1], slope[2]]);
            continue;
        }
        let r = attitude(graph, row);
        let torque = [0, 1, 2].map(|axis| {
            let mut unit = [None; 3];
            unit[axis] = Some(graph.integer(1));
            let turned = turned(graph, &r, &unit);
            let terms: Vec<Id> = turned.iter().zip(slope).map(|(r, slope)| graph.mul(*r, *slope)).collect();
            let sum = graph.sum(&terms);
            graph.scale(half, sum)
        });
        impulses.push(torque);
    }
    impulses
}

/// r⊗(0, v) with some components that are zero.
fn turned(graph: &mut Graph, [i, j, k, w]: &[Id; 4], v: &[Option<Id>; 3]) -> [Id; 4] {
    let mut sum = |terms: [(Id, Option<Id>, bool); 3]| {
        let mut products = vec![];
        for (x, v, negative) in terms {
            let Some(v) = v else { continue };
            let product = graph.mul(x, v);
            products.push(if negative { graph.neg(product) } else { product });
        }
        graph.sum(&products)
    };
    let [a, b, c] = *v;
    [
        sum([(*w, a, false), (*j, c, false), (*k, b, true)]),
        sum([(*w, b, false), (*k, a, false), (*i, c, true)]),
        sum([(*w, c, false), (*i, b, false), (*j, a, true)]),
        sum([(*i, a, true), (*j, b, true), (*k, c, true)]),
    ]
}

/// m ← m + impulse. An impulse is summed before it is added: m is rounded once.
fn kick(graph: &mut Graph, impulses: &[[Id; 3]]) -> FlowKernel {
    let mut ends = vec![];
    for (impulse, body) in impulses.iter().zip(0..) {
        for (symbol, impulse) in momenta(body).into_iter().zip(impulse) {
            if !graph.is_zero(*impulse) {
                let start = graph.symbol(symbol);
                ends.push((symbol, graph.add(start, *impulse)));
            }
        }
    }
    FlowKernel::new(Levels::Prepared, ends)
}

/// r' = ½ r⊗(0, ω) of all bodies and q' of their centres of mass, then m' = m × ω + τ and p', as quaternions.
fn rates(graph: &mut Graph, found: &analyze::Bodies, impulses: &[[Id; 3]]) -> Vec<Id> {
    let half = Number::HALF;
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
        let turned = turned(graph, &r, &velocity.map(Some));
        places.extend(turned.map(|x| graph.scale(half, x)));
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
