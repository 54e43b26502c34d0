//! Family "prolongation": H = p·a(q, s) + b(q, s). The coordinates q and s move without p: q' = a, s' = −b.
//!
//! The flow keeps ds − p dq up to a factor. Thus the momenta follow from Q(q, s) and S(q, s): with d_j = ∂/∂q_j + p_j ∂/∂s,
//! Σᵢ d_jQᵢ Pᵢ = d_jS.

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Polynomial, is_linear, is_momentum, is_whole, power, reads};
use super::super::scalar::{self, Angle, Equation, rotation};
use crate::diff;
use crate::ir::formula::{call, pow, squared};
use crate::ir::{Function, Graph, Id, Number, Symbol};

/// Returns the flow, if the equations of q and s are single equations or pairs of equations with a closed solution.
pub(in super::super) fn solve(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let mut moving = equations(graph, group)?;
    moving.retain(|equation| !graph.is_zero(equation.rate));
    let (mut flow, mut by_start) = (Flow::rest(graph, group.degrees), vec![]);
    while let Some(first) = moving.pop() {
        let coupled: Vec<usize> = (0..moving.len()).filter(|i| couple(graph, &first, &moving[*i])).collect();
        match coupled[..] {
            [] => {
                let solution = scalar::solve(graph, &first)?;
                flow.set(first.x, solution.end);
                by_start.push((first.x, solution.by_start));
            }
            [i] => {
                let second = moving.remove(i);
                if moving.iter().any(|third| couple(graph, &second, third)) {
                    return None;
                }
                let [x_end, y_end] = driven(graph, &first, &second)
                    .or_else(|| driven(graph, &second, &first).map(|[y, x]| [x, y]))
                    .or_else(|| linear_pair(graph, [&first, &second]))?;
                flow.set(first.x, x_end);
                flow.set(second.x, y_end);
            }
            _ => return None,
        }
    }
    set_momenta(graph, &mut flow, &by_start)?;
    Some(flow)
}

/// Returns the equations of q and s, if H is affine in the momenta.
fn equations(graph: &mut Graph, group: &Group) -> Option<Vec<Equation>> {
    let powers = Polynomial::of(graph, group.energy, &is_momentum).filter(Polynomial::is_affine)?;
    let equation = |x, rate| Equation { x, rate, clock: group.clock };
    let mut all: Vec<Equation> = (0..group.degrees)
        .map(|i| equation(Symbol::Position(i), powers.coefficient(graph, &[(Symbol::Momentum(i), 1)])))
        .collect();
    let b = powers.coefficient(graph, &[]);
    all.push(equation(Symbol::Action, graph.neg(b)));
    Some(all)
}

/// Returns whether one of two equations reads the variable of the other equation.
fn couple(graph: &Graph, first: &Equation, second: &Equation) -> bool {
    reads(graph, first.rate, second.x) || reads(graph, second.rate, first.x)
}

/// Returns the ends of x' = a·x and y' = Σ cₖxᵏ: Y = y + Σ cₖxᵏ·h·φ₁(kah). Friction and the heat that it produces are an example.
fn driven(graph: &mut Graph, driver: &Equation, driven: &Equation) -> Option<[Id; 2]> {
    let (x, rates) = (driver.x, [driver.rate, driven.rate]);
    if rates.into_iter().any(|rate| reads(graph, rate, driven.x)) {
        return None;
    }
    let steady = rates.into_iter().all(|rate| driver.clock.is_steady(graph, rate));
    let [own, other] = rates.map(|rate| Polynomial::of(graph, rate, &|symbol| symbol == x));
    let (own, other) = (own?, other?);
    if !own.has_only(is_linear) || !other.has_only(is_whole) || !steady {
        return None;
    }
    let a = own.coefficient(graph, &[(x, 1)]);
    let end = scalar::solve(graph, driver)?.end;
    let [h, start, mut y] = [Symbol::StepLength, x, driven.x].map(|symbol| graph.symbol(symbol));
    for (monomial, coefficient) in other.into_terms() {
        let k = power(&monomial, x);
        let mean = graph.build(call(Function::Phi1, [Number::Exact(k) * (a * h)]));
        y = graph.build(y + coefficient * pow(start, k) * h * mean);
    }
    Some([end, y])
}

/// Returns the ends of (x, y)' = A(x, y) with constant A: e^(μh)·(C + S·(A − μ)) with μ half the trace of A, ω² = det(A − μ), C = cos ωh,
/// S = sin ωh/ω.
fn linear_pair(graph: &mut Graph, equations: [&Equation; 2]) -> Option<[Id; 2]> {
    let of = equations.map(|equation| equation.x);
    let mut matrix = vec![];
    for equation in equations {
        let linear = Polynomial::of(graph, equation.rate, &|symbol| of.contains(&symbol))?;
        if !linear.has_only(is_linear) {
            return None;
        }
        matrix.push(of.map(|symbol| linear.coefficient(graph, &[(symbol, 1)])));
    }
    if !matrix.iter().flatten().all(|entry| equations[0].clock.is_steady(graph, *entry)) {
        return None;
    }
    let h = graph.symbol(Symbol::StepLength);
    let mean = graph.build(Number::HALF * (matrix[0][0] + matrix[1][1]));
    let d = graph.build(Number::HALF * (matrix[0][0] - matrix[1][1]));
    let cross = graph.mul(matrix[0][1], matrix[1][0]);
    let square = graph.build(-(squared(d) + cross));
    // The momentum of a coordinate that rotates with s has a pole within each half turn.
    let valid = if of.contains(&Symbol::Action) { Angle::BelowHalfTurn } else { Angle::Any };
    let (cosine, sine) = rotation(graph, square, h, valid);
    let growth = graph.build(call(Function::Exp, [mean * h]));
    let d = [d, graph.neg(d)];
    let start = of.map(|symbol| graph.symbol(symbol));
    Some([0, 1].map(|i| {
        let other = 1 - i;
        graph.build(growth * ((cosine + d[i] * sine) * start[i] + matrix[i][other] * sine * start[other]))
    }))
}

/// Sets P from Q and S. `known` contains derivatives of ends by their own starts.
fn set_momenta(graph: &mut Graph, flow: &mut Flow, known: &[(Symbol, Id)]) -> Option<()> {
    let n = flow.q.len();
    let symbols: Vec<Symbol> = (0..n as u32).map(Symbol::Position).chain([Symbol::Action]).collect();
    let ends = [&flow.q[..], &[flow.s]].concat();
    // Column n contains the derivatives by s.
    let mut jacobian = diff::jacobian(graph, &ends, &symbols);
    for (i, symbol) in symbols.iter().enumerate() {
        if let Some((_, slope)) = known.iter().find(|(known, _)| known == symbol) {
            jacobian[i][i] = *slope;
        }
    }
    let p = flow.p.clone();
    // d_jS minus the terms of known momenta.
    let mut rest: Vec<Id> = (0..n).map(|j| graph.build(jacobian[n][j] + p[j] * jacobian[n][n])).collect();
    let zero = graph.zero();
    let start = Flow::rest(graph, n as u32);
    let moving: Vec<usize> = (0..n).filter(|i| flow.q[*i] != start.q[*i]).collect();
    let (with_s, mut open): (Vec<usize>, Vec<usize>) =
        moving.into_iter().partition(|i| !graph.is_zero(jacobian[*i][n]));

    if with_s.len() > 1 {
        // For Qᵢ = qᵢ + wᵢ(s): P = y − p (w'·y)/(1 + w'·p) with y = rest.
        if with_s.iter().any(|i| (0..n).any(|j| jacobian[*i][j] != if *i == j { graph.integer(1) } else { zero })) {
            return None;
        }
        let (mut along, mut taken) = (graph.integer(1), zero);
        for i in &with_s {
            along = graph.build(along + jacobian[*i][n] * p[*i]);
            taken = graph.build(taken + jacobian[*i][n] * rest[*i]);
        }
        let share = graph.build(taken * call(Function::RecipPositive, [along]));
        for j in 0..n {
            rest[j] = graph.build(rest[j] - p[j] * share);
        }
    } else {
        // A coordinate that reads s comes first, because its momentum occurs in the equations of all other momenta.
        open.splice(0..0, with_s);
    }
    while !open.is_empty() {
        let i = open.remove(0);
        let coupled: Vec<usize> = open.iter().copied().filter(|j| !graph.is_zero(jacobian[*j][i])).collect();
        match coupled[..] {
            [] => {
                let own = graph.mul(p[i], jacobian[i][n]);
                let d = graph.add(jacobian[i][i], own);
                let reciprocal =
                    if graph.is_zero(own) { graph.recip(d) } else { graph.call(Function::RecipPositive, &[d]) };
                rest[i] = graph.mul(rest[i], reciprocal);
                subtract_known(graph, &mut rest, &jacobian[i], &p, i, &[i]);
            }
            // Two coupled coordinates, by Cramer's rule.
            [j] if graph.is_zero(jacobian[i][n]) && graph.is_zero(jacobian[j][n]) => {
                open.retain(|other| *other != j);
                let determinant = graph.build(jacobian[i][i] * jacobian[j][j] - jacobian[i][j] * jacobian[j][i]);
                [rest[i], rest[j]] = [(i, j), (j, i)]
                    .map(|(a, b)| graph.build((jacobian[b][b] * rest[a] - jacobian[b][a] * rest[b]) / determinant));
                subtract_known(graph, &mut rest, &jacobian[i], &p, i, &[i, j]);
                subtract_known(graph, &mut rest, &jacobian[j], &p, j, &[i, j]);
            }
            _ => return None,
        }
    }
    flow.p = rest;
    Some(())
}

/// Subtracts d_jQᵢ Pᵢ from the equations of all momenta except the `solved` ones. `slopes` are the derivatives of Qᵢ.
fn subtract_known(graph: &mut Graph, rest: &mut [Id], slopes: &[Id], p: &[Id], i: usize, solved: &[usize]) {
    for j in (0..p.len()).filter(|j| !solved.contains(j)) {
        rest[j] = graph.build(rest[j] - (slopes[j] + p[j] * slopes[p.len()]) * rest[i]);
    }
}
