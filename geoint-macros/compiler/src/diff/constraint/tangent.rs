//! The discrete gradient with tangent ends, for energies whose ∂H/∂p is affine in p. With N = C⁻¹A and C Cᵀ = A W Aᵀ, unknown q₁, p₁, μ, ν:
//!
//! - P₀ = p₀ + N₀ᵀν and P₁ = p₁ + N₁ᵀν with the same ν,
//! - q₁ − q₀ = h v̄ and P₁ − P₀ = h f̄ + 2 Āᵀμ/h, with discrete gradients between (q₀, P₀) and (q₁, P₁),
//! - the condition of each row over the step, and A₁v(q₁, p₁) + b₁ = 0.
//!
//! The rows of N are orthonormal in W. Tangent momenta have no part along them, so H(qᵢ, Pᵢ) = H(qᵢ, pᵢ) + |ν|²/2 at both ends. The energy is therefore kept,
//! although each pᵢ is tangent. The step is symmetric and of order 2, and ν = O(h²).

use super::cholesky::Cholesky;
use super::vectors::{combination, differences, ends, increments, moved, multipliers, pulls, scaled, shifts, sums};
use super::{Constrained, Equation, sum_of_magnitudes};
use crate::ir::formula::{call, pow};
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

/// The step. Its unknowns are increments of positions, P₁ − P₀ if `mean_velocity` is present, μ, and ν.
pub(crate) fn tangent_step(graph: &mut Graph, system: &Constrained<'_>) -> Equation {
    let (n, m) = (system.degrees(), system.rows.len());
    let [h, start, end_time] =
        [Symbol::StepLength, Symbol::StepStart, Symbol::StepEnd].map(|symbol| graph.symbol(symbol));
    let unknown = multipliers(0..2 * m);
    let nu: Vec<Id> = unknown[m..].iter().map(|symbol| graph.symbol(*symbol)).collect();
    let positions: Vec<Id> = (0..n as u32).map(|i| graph.symbol(Symbol::Position(i))).collect();
    let [dq, dp] = increments(graph, n);

    let first = Normals::at(graph, system, &positions, start);
    let push = first.push(graph, &nu);
    let from = ends(graph, Symbol::Momentum, &push); // P₀
    let [force, mean_velocity] =
        [Some(system.mean_force), system.mean_velocity].map(|nodes| at_momenta(graph, nodes.unwrap_or(&[]), &from));
    let slopes: Vec<Vec<Id>> = system.rows.iter().map(|row| row.mean_gradient(graph)).collect();
    let pull = pulls(graph, &slopes, Number::integer(2));
    let kick = scaled(graph, h, &force);
    let impulse = sums(graph, &kick, &pull);

    let (mut residual, shift, lead) = match system.mean_velocity {
        None => {
            let half = scaled_by(graph, Number::HALF, &impulse);
            let mean = sums(graph, &push, &half);
            let shift = shifts(graph, system.velocity, &mean, Number::ONE);
            (differences(graph, &dq, &shift), shift, impulse)
        }
        Some(_) => {
            let shift = scaled(graph, h, &mean_velocity);
            ([differences(graph, &dq, &shift), differences(graph, &dp, &impulse)].concat(), dq.clone(), dp)
        }
    };
    let end = ends(graph, Symbol::Position, &dq);
    let to = sums(graph, &from, &lead); // P₁
    let last = Normals::at(graph, system, &end, end_time);
    let rates = last.rates_without(graph, system, &end, &to, &nu);
    residual.extend(rows(graph, system, &first, &rates, &dq));
    let back = last.push(graph, &nu);
    let gained = sums(graph, &push, &lead);
    let increments: Vec<Symbol> = match system.mean_velocity {
        None => (0..n as u32).map(Symbol::PositionIncrement).collect(),
        Some(_) => {
            (0..n as u32).map(Symbol::PositionIncrement).chain((0..n as u32).map(Symbol::MomentumIncrement)).collect()
        }
    };
    let origin = origin(graph, system, &first, &increments);
    Equation {
        residual,
        end: [shift, differences(graph, &gained, &back)].concat(),
        origin,
        unknowns: [increments, unknown].concat(),
    }
}

/// The rows for μ and ν. To first order in h, the rate at the end is 2 A W Aᵀμ/h, and a condition is h C ν with half of the rate's impulse. The rows are solved
/// for μ and ν by these leading terms, so the derivative tends to the identity.
fn rows(graph: &mut Graph, system: &Constrained<'_>, first: &Normals, rates: &[Id], dq: &[Id]) -> Vec<Id> {
    let h = graph.symbol(Symbol::StepLength);
    let half = graph.scale(Number::HALF, h);
    let impulses = scaled(graph, half, rates);
    let of_multipliers = system.in_units(graph, &impulses);
    let mut of_normals = vec![];
    for (k, (row, impulse)) in system.rows.iter().zip(&impulses).enumerate() {
        let condition = row.condition(graph, dq);
        of_normals.push(graph.build((condition - *impulse) / (h * first.factor.diagonal(k))));
    }
    [of_multipliers, of_normals].concat()
}

/// The origin of each unknown, see [`Equation`]. μ follows from rates, and has their rounding. ν follows from positions, and has theirs over h.
fn origin(graph: &mut Graph, system: &Constrained<'_>, first: &Normals, increments: &[Symbol]) -> Vec<Id> {
    let h = graph.symbol(Symbol::StepLength);
    let h = graph.call(Function::Abs, &[h]);
    let units = system.units(graph);
    let q: Vec<Id> = (0..system.degrees() as u32).map(|i| graph.symbol(Symbol::Position(i))).collect();
    let (mut multipliers, mut normals) = (vec![], vec![]);
    for (k, row) in system.rows.iter().enumerate() {
        let rate = sum_of_magnitudes(graph, &row.gradient, system.velocity);
        multipliers.push(graph.build(Number::HALF * h * rate / call(Function::Abs, [units[k]])));
        let position = sum_of_magnitudes(graph, &row.gradient, &q);
        normals.push(graph.build((position / h + rate) / first.factor.diagonal(k)));
    }
    let weight = graph.build(Number::integer(2) * pow(h, Ratio::integer(-1)));
    let increments = system.origins_of_increments(graph, increments, &multipliers, weight);
    [increments, multipliers, normals].concat()
}

/// A at one end of a step, and C.
struct Normals {
    gradients: Vec<Vec<Id>>,
    factor: Cholesky,
}

impl Normals {
    fn at(graph: &mut Graph, system: &Constrained<'_>, positions: &[Id], time: Id) -> Normals {
        let inertia: Vec<Vec<Id>> =
            system.inertia(graph).iter().map(|row| moved(graph, row, positions, None, time)).collect();
        let gradients = system.rows.iter().map(|row| moved(graph, &row.gradient, positions, None, time)).collect();
        Normals { gradients, factor: Cholesky::of(graph, &inertia) }
    }

    /// Nᵀν.
    fn push(&self, graph: &mut Graph, nu: &[Id]) -> Vec<Id> {
        let weights = self.factor.solve_transposed(graph, nu);
        combination(graph, &self.gradients, &weights)
    }

    /// A v + b at the momenta P − Nᵀν. Since ∂H/∂p is affine in p, it is A v(P) + b − C ν.
    fn rates_without(
        &self,
        graph: &mut Graph,
        system: &Constrained<'_>,
        positions: &[Id],
        momenta: &[Id],
        nu: &[Id],
    ) -> Vec<Id> {
        let time = graph.symbol(Symbol::StepEnd);
        let rates = system.rates(graph);
        let rates = moved(graph, &rates, positions, Some(momenta), time);
        let normal = self.factor.times(graph, nu);
        differences(graph, &rates, &normal)
    }
}

/// Nodes at other momenta at the start of a step.
fn at_momenta(graph: &mut Graph, nodes: &[Id], momenta: &[Id]) -> Vec<Id> {
    let mut moved = Substitution::new(|_: &mut Graph, symbol| match symbol {
        Symbol::Momentum(i) => Some(momenta[i as usize]),
        _ => None,
    });
    nodes.iter().map(|node| moved.apply(graph, *node)).collect()
}

fn scaled_by(graph: &mut Graph, factor: Number, vector: &[Id]) -> Vec<Id> {
    vector.iter().map(|entry| graph.scale(factor, *entry)).collect()
}
