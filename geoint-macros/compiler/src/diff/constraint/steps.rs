//! RATTLE and the plain discrete gradient with constraints, with multipliers μ, f = −∂H/∂q and v = ∂H/∂p. The time of the system's nodes is the middle of the
//! step.
//!
//! - RATTLE: p½ = p₀ + (h/2) f(q₀, p½) + Gᵀ(q₀) μ/h, q₁ = q₀ + (h/2) (v(q₀, p½) + v(q₁, p½)), g(q₁) = 0, p₁ = p½ + (h/2) f(q₁, p½).
//!   The runtime then projects p₁ to the tangent space. (H. C. Andersen 1983; L. O. Jay 1996 for general H.)
//! - Discrete gradient: q₁ = q₀ + h v̄, p₁ = p₀ + h f̄ + 2 Āᵀ μ/h, and the condition of each row, with discrete gradients v̄, f̄ and Ā (O. Gonzalez 1999).
//!   [`Normal`] makes the momenta at its ends tangent.
//!
//! If H = T(p) + V(q) with a constant mass matrix, momenta determine positions: the unknowns are fewer then, and `mean_velocity` is absent.

use super::action::GradientStep;
use super::tangent::Normal;
use super::vectors::{differences, ends, increments, moved, multipliers, pulls, scaled, shifts, sums};
use super::{Constrained, Equation};
use crate::ir::formula::{call, pow};
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

/// RATTLE up to the momentum at the end, before its projection to the tangent space. All rows bind positions.
pub(crate) fn rattle(graph: &mut Graph, system: &Constrained<'_>) -> Equation {
    let n = system.degrees();
    let h = graph.symbol(Symbol::StepLength);
    let [first_time, last_time] = [Symbol::StepStart, Symbol::StepEnd].map(|symbol| graph.symbol(symbol));
    let half = graph.scale(Number::HALF, h);
    let start: Vec<Id> = (0..n as u32).map(|i| graph.symbol(Symbol::Position(i))).collect();
    let mut gradients = vec![];
    for row in system.rows {
        gradients.push(moved(graph, &row.gradient, &start, None, first_time));
    }
    let pull = pulls(graph, &gradients, Number::ONE);
    if system.mean_velocity.is_none() {
        let force = moved(graph, system.force, &start, None, first_time);
        let kick = scaled(graph, half, &force);
        let increments = sums(graph, &kick, &pull);
        let shift = shifts(graph, system.velocity, &increments, Number::ONE);
        let end = ends(graph, Symbol::Position, &shift);
        let force = moved(graph, system.force, &end, None, last_time);
        let last = scaled(graph, half, &force);
        let middle = ends(graph, Symbol::Momentum, &increments);
        let action = system.action.map(|action| action.of_rattle(graph, &middle, &shift));
        let unknowns = multipliers(system.rows.len());
        return Equation {
            residual: conditions(graph, system, &shift),
            end: [shift, sums(graph, &increments, &last)].concat(),
            action,
            origin: system.rounding_of_multipliers(graph),
            unknowns,
        };
    }
    // Here Δp leads to the momenta in the middle of the step.
    let [dq, dp] = increments(graph, n);
    let [end, middle] = [ends(graph, Symbol::Position, &dq), ends(graph, Symbol::Momentum, &dp)];
    let mut at = |nodes: &[Id], positions: &[Id], time| moved(graph, nodes, positions, Some(&middle), time);
    let (first, last) = (at(system.velocity, &start, first_time), at(system.velocity, &end, last_time));
    let (first_force, last_force) = (at(system.force, &start, first_time), at(system.force, &end, last_time));
    let velocity = sums(graph, &first, &last);
    let shift = scaled(graph, half, &velocity);
    let mut residual = differences(graph, &dq, &shift);
    let kick = scaled(graph, half, &first_force);
    let impulse = sums(graph, &kick, &pull);
    residual.extend(differences(graph, &dp, &impulse));
    residual.extend(conditions(graph, system, &dq));
    let last = scaled(graph, half, &last_force);
    let action = system.action.map(|action| action.of_rattle(graph, &middle, &dq));
    let increments = increments_of_both(n);
    Equation {
        residual,
        end: [dq, sums(graph, &dp, &last)].concat(),
        action,
        origin: origin(graph, system, &increments, Number::ONE),
        unknowns: [increments, multipliers(system.rows.len())].concat(),
    }
}

/// The momenta at the ends of steps along discrete gradients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Momenta {
    /// They have a part normal to the constraints, of order h².
    Carried,
    /// They are tangent: see [`Normal`].
    Tangent,
}

/// The discrete gradient with constraints. The mean force already reads time in the middle of the step.
pub(crate) fn discrete_gradient_step(graph: &mut Graph, system: &Constrained<'_>, momenta: Momenta) -> Equation {
    let n = system.degrees();
    let h = graph.symbol(Symbol::StepLength);
    // The mean momentum takes half of the impulse to the positions. With the factor 2, they move by W Gᵀμ, as in RATTLE.
    let two = Number::integer(2);
    let slopes: Vec<Vec<Id>> = system.rows.iter().map(|row| row.mean_gradient(graph)).collect();
    let [dq, dp] = increments(graph, n);
    let normal = match momenta {
        Momenta::Carried => None,
        Momenta::Tangent => Some(Normal::of(graph, system, &slopes, [&dq, &dp])),
    };
    let between = |graph: &mut Graph, nodes: &[Id]| match &normal {
        Some(normal) => normal.added_to(graph, nodes),
        None => nodes.to_vec(),
    };
    let force = between(graph, system.mean_force);
    let velocity = system.mean_velocity.map(|velocity| between(graph, velocity));
    let pull = pulls(graph, &slopes, two);
    let impulse = scaled(graph, h, &force);
    let mut impulse = sums(graph, &impulse, &pull);
    if let Some(normal) = &normal {
        impulse = sums(graph, &impulse, &normal.impulse);
    }
    if let Some(action) = system.action {
        impulse = action.damped_sum(graph, &impulse);
    }
    let conditions = conditions(graph, system, &dq);
    let (increments, mut residual, [shift, gained]) = match velocity {
        None => {
            let shift = shifts(graph, system.velocity, &impulse, Number::HALF);
            let increments: Vec<Symbol> = (0..n as u32).map(Symbol::PositionIncrement).collect();
            (increments, differences(graph, &dq, &shift), [shift, impulse])
        }
        Some(velocity) => {
            let shift = scaled(graph, h, &velocity);
            let rows = [differences(graph, &dq, &shift), differences(graph, &dp, &impulse)].concat();
            (increments_of_both(n), rows, [dq, dp])
        }
    };
    residual.extend(conditions);
    let action = system.action.map(|action| {
        let energy = between(graph, &[action.energy])[0];
        // The impulse of the constraints is P₁ − P₀ less those of H and of the friction.
        let mut bound = pull;
        if let Some(normal) = &normal {
            let sum = sums(graph, &bound, &normal.impulse);
            bound = normal.between(graph, &sum);
        }
        let work = match system.rows.iter().all(|row| graph.is_zero(row.drift)) {
            true => graph.zero(),
            false => {
                let work = graph.dot(&bound, &shift);
                graph.div(work, h)
            }
        };
        action.of_gradient(graph, &GradientStep { dq: &shift, sum: &gained, energy, work })
    });
    let gained = match &normal {
        Some(normal) => normal.taken_from(graph, &gained),
        None => gained,
    };
    let origin = origin(graph, system, &increments, two);
    let unknowns = [increments, multipliers(system.rows.len())].concat();
    Equation { residual, end: [shift, gained].concat(), action, origin, unknowns }
}

/// The conditions of all rows in the units of their multipliers.
fn conditions(graph: &mut Graph, system: &Constrained<'_>, dq: &[Id]) -> Vec<Id> {
    let conditions: Vec<Id> = system.rows.iter().map(|row| row.condition(graph, dq)).collect();
    system.in_units(graph, &conditions)
}

/// The origins of increments and multipliers, see [`Equation`]. A momentum adds the error of `pull`·Aᵀμ/h.
fn origin(graph: &mut Graph, system: &Constrained<'_>, increments: &[Symbol], pull: Number) -> Vec<Id> {
    let multipliers = system.rounding_of_multipliers(graph);
    let h = graph.symbol(Symbol::StepLength);
    let weight = graph.build(pull * pow(call(Function::Abs, [h]), Ratio::integer(-1)));
    [system.origins_of_increments(graph, increments, &multipliers, weight), multipliers].concat()
}

/// The increments of positions and momenta.
fn increments_of_both(n: usize) -> Vec<Symbol> {
    let n = n as u32;
    (0..n).map(Symbol::PositionIncrement).chain((0..n).map(Symbol::MomentumIncrement)).collect()
}
