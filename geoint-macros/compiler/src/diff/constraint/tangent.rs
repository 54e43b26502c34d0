//! Tangent ends of a discrete gradient with constraints, for energies whose ∂H/∂p is affine in p. With N = C⁻¹A and C = L√D from
//! A W Aᵀ = L D Lᵀ:
//!
//! - P₀ = p₀ + N₀ᵀν and P₁ = p₁ + N₁ᵀν with the same ν,
//! - q₁ − q₀ = h v̄ and P₁ − P₀ = h f̄ + Āᵀλ, with discrete gradients between (q₀, P₀) and (q₁, P₁),
//! - the condition of each row over the step, and A₁v(q₁, p₁) + b₁ = 0.
//!
//! The rows of N are orthonormal in W, up to signs where inertia is negative. Tangent momenta have no part along them, so H(qᵢ, Pᵢ) = H(qᵢ, pᵢ) + |ν|²/2 at
//! both ends. The energy is therefore kept, although each pᵢ is tangent. The step is symmetric and of order 2, and ν = O(h²).
//!
//! Beside an action, H decays by e^(−hγ), and so must |ν|²: P₁ = p₁ + κN₁ᵀν with κ = e^(−hγ/2). Otherwise κ = 1.
//!
//! The unknowns are those of the plain step, with the sum s = P₁ + P₀ − 2p₀ in place of p₁ − p₀. They determine ν = C₀ᵀw: the rate at the end is that of the
//! momenta p₀ + s less N₀ᵀν and κN₁ᵀν, so (A₁W₁A₀ᵀ + κC₁C₀ᵀ) w = A₁v(q₁, p₀ + s) + b₁. With Āᵀλ = 2 Āᵀ(μ/h − w), s = h f̄ + 2 Āᵀμ/h + 2 (A₀ − Ā)ᵀw. This is
//! the impulse of the plain step and a small term.

use super::Constrained;
use super::elimination::{Factors, solve};
use super::vectors::{combination, differences, ends, moved, scaled, sums};
use crate::diff::equations::times;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Number, Symbol};

/// The normal parts of the momenta P₀ and P₁.
pub(super) struct Normal {
    /// N₀ᵀν.
    at_start: Vec<Id>,
    /// κN₁ᵀν.
    at_end: Vec<Id>,
    /// 2 (A₀ − Ā)ᵀw.
    pub(super) impulse: Vec<Id>,
}

impl Normal {
    /// Computes ν from the increments `dq` and the sum `s`. `means` are the rows of Ā.
    pub(super) fn of(graph: &mut Graph, system: &Constrained<'_>, means: &[Vec<Id>], [dq, s]: [&[Id]; 2]) -> Normal {
        let [start_time, end_time] = [Symbol::StepStart, Symbol::StepEnd].map(|symbol| graph.symbol(symbol));
        let start: Vec<Id> = (0..dq.len() as u32).map(|i| graph.symbol(Symbol::Position(i))).collect();
        let end = ends(graph, Symbol::Position, dq);
        let first = Rows::at(graph, system, &start, start_time);
        let last = Rows::at(graph, system, &end, end_time);
        let velocity = end_velocity(graph, system, [dq, s]);
        let rates = last.rates(graph, &velocity);
        // κ√(D₀/D₁).
        let mut roots = last.factors.ratios(graph, &first.factors);
        if let Some(action) = system.action {
            let factor = action.factor_of_normal(graph);
            roots = scaled(graph, factor, &roots);
        }
        let coupling = last.coupling(graph, &first, &roots);
        let w = solve(graph, coupling, rates);
        // κN₁ᵀν = A₁ᵀ κC₁⁻ᵀ C₀ᵀw.
        let along = first.factors.transposed_times(graph, &w);
        let along: Vec<Id> = along.iter().zip(&roots).map(|(x, root)| graph.mul(*x, *root)).collect();
        let of_end = last.factors.solve_transposed(graph, &along);
        let two = graph.integer(2);
        let twice = scaled(graph, two, &w);
        let changes = first.gradients.iter().zip(means);
        let changes: Vec<Vec<Id>> = changes.map(|(first, mean)| differences(graph, first, mean)).collect();
        Normal {
            at_start: combination(graph, &first.gradients, &w),
            at_end: combination(graph, &last.gradients, &of_end),
            impulse: combination(graph, &changes, &twice),
        }
    }

    /// Moves nodes from the momenta p₀ and p₀ + `s` at both ends to P₀ and P₁.
    pub(super) fn added_to(&self, graph: &mut Graph, nodes: &[Id]) -> Vec<Id> {
        let mut moved = Substitution::new(|graph: &mut Graph, symbol| {
            let start = |i: u32| self.at_start[i as usize];
            let own = graph.symbol(symbol);
            match symbol {
                Symbol::Momentum(i) => Some(graph.add(own, start(i))),
                Symbol::MomentumIncrement(i) => Some(graph.build(own - Number::integer(2) * start(i))),
                _ => None,
            }
        });
        nodes.iter().map(|node| moved.apply(graph, *node)).collect()
    }

    /// P₁ − P₀ from s.
    pub(super) fn between(&self, graph: &mut Graph, s: &[Id]) -> Vec<Id> {
        let both = sums(graph, &self.at_start, &self.at_start);
        differences(graph, s, &both)
    }

    /// p₁ − p₀ from s.
    pub(super) fn taken_from(&self, graph: &mut Graph, s: &[Id]) -> Vec<Id> {
        let both = sums(graph, &self.at_start, &self.at_end);
        differences(graph, s, &both)
    }
}

/// v at the end and the momenta p₀ + s. For a constant mass matrix it follows from the mean velocity.
fn end_velocity(graph: &mut Graph, system: &Constrained<'_>, [dq, s]: [&[Id]; 2]) -> Vec<Id> {
    if system.mean_velocity.is_none() {
        let h = graph.symbol(Symbol::StepLength);
        let twice = graph.recip(h);
        let twice = graph.scale(Number::integer(2), twice);
        let sum = scaled(graph, twice, dq);
        return differences(graph, &sum, system.velocity);
    }
    let time = graph.symbol(Symbol::StepEnd);
    let (end, momenta) = (ends(graph, Symbol::Position, dq), ends(graph, Symbol::Momentum, s));
    moved(graph, system.velocity, &end, Some(&momenta), time)
}

/// The rows at one end of a step.
struct Rows {
    gradients: Vec<Vec<Id>>,
    drifts: Vec<Id>,
    inverse_mass: Vec<Vec<Id>>,
    /// Factors of A W Aᵀ.
    factors: Factors,
}

impl Rows {
    fn at(graph: &mut Graph, system: &Constrained<'_>, positions: &[Id], time: Id) -> Rows {
        let mut inertia = system.inertia(graph);
        let mut inverse_mass = system.inverse_mass.clone();
        let mut gradients = system.gradients();
        for row in gradients.iter_mut().chain(&mut inverse_mass).chain(&mut inertia) {
            *row = moved(graph, row, positions, None, time);
        }
        let drifts: Vec<Id> = system.rows.iter().map(|row| row.drift).collect();
        let drifts = moved(graph, &drifts, positions, None, time);
        Rows { gradients, drifts, inverse_mass, factors: Factors::of(graph, &inertia) }
    }

    /// A v + b.
    fn rates(&self, graph: &mut Graph, velocity: &[Id]) -> Vec<Id> {
        let along: Vec<Id> = self.gradients.iter().map(|row| graph.dot(row, velocity)).collect();
        sums(graph, &along, &self.drifts)
    }

    /// A₁W₁A₀ᵀ + κC₁C₀ᵀ of the last rows. `roots` are κ√(D₀/D₁).
    fn coupling(&self, graph: &mut Graph, first: &Rows, roots: &[Id]) -> Vec<Vec<Id>> {
        let mut coupling = self.factors.product(graph, roots, &first.factors);
        for (entries, row) in coupling.iter_mut().zip(&self.gradients) {
            let direction = times(graph, &self.inverse_mass, row);
            for (entry, other) in entries.iter_mut().zip(&first.gradients) {
                let product = graph.dot(&direction, other);
                *entry = graph.add(*entry, product);
            }
        }
        coupling
    }
}
