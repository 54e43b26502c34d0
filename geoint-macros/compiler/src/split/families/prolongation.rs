//! H = p·a(q, s) + b(q, s): the base moves by itself, q' = a, s' = −b, and takes the momenta along.
//!
//! They follow from (Q, S) because ds − p dq is kept up to a factor: with d_j = ∂/∂q_j + p_j ∂/∂s,
//! Σᵢ d_jQᵢ Pᵢ = d_jS.

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Polynomial, is_free};
use super::super::scalar::{self, Equation, rotation};
use super::super::time::Clock;
use crate::diff;
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

pub(in super::super) fn solve(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let rates = base(graph, group)?;
    let mut moving: Vec<(Symbol, Id)> = rates.into_iter().filter(|(_, rate)| !graph.is_zero(*rate)).collect();
    let (mut flow, mut by_start) = (Flow::rest(graph, group.degrees), vec![]);
    while let Some((x, rate)) = moving.pop() {
        let others: Vec<usize> =
            (0..moving.len()).filter(|i| reads(graph, rate, moving[*i].0) || reads(graph, moving[*i].1, x)).collect();
        match others[..] {
            [] => {
                let solution = scalar::solve(graph, &Equation { x, rate, clock: group.clock })?;
                set(&mut flow, x, solution.end);
                by_start.push((x, solution.by_start));
            }
            [other] => {
                let (y, other_rate) = moving.remove(other);
                if moving
                    .iter()
                    .any(|(z, rate)| reads(graph, other_rate, *z) || reads(graph, *rate, y) || reads(graph, *rate, x))
                {
                    return None;
                }
                let (first, second) = ((x, rate), (y, other_rate));
                let ends = driven(graph, group, first, second)
                    .or_else(|| driven(graph, group, second, first).map(|[y, x]| [x, y]))
                    .or_else(|| pair(graph, group, [x, y], [rate, other_rate]));
                let [x_end, y_end] = ends?;
                set(&mut flow, x, x_end);
                set(&mut flow, y, y_end);
            }
            _ => return None,
        }
    }
    momenta(graph, &mut flow, &by_start)?;
    Some(flow)
}

/// The rates of q and s, if H is of degree 1 in the momenta.
fn base(graph: &mut Graph, group: &Group) -> Option<Vec<(Symbol, Id)>> {
    let in_p = Polynomial::of(graph, group.energy, &|symbol| matches!(symbol, Symbol::Momentum(_)))?;
    let affine = in_p.has_only(|monomial| monomial.is_empty() || monomial.values().eq([&Ratio::ONE]));
    if !affine {
        return None;
    }
    let mut rates: Vec<(Symbol, Id)> = (0..group.degrees)
        .map(|i| (Symbol::Position(i), in_p.coefficient(graph, &[(Symbol::Momentum(i), 1)])))
        .collect();
    let b = in_p.coefficient(graph, &[]);
    rates.push((Symbol::Action, graph.neg(b)));
    Some(rates)
}

fn reads(graph: &Graph, id: Id, symbol: Symbol) -> bool {
    !is_free(graph, id, &|other| other == symbol)
}

fn set(flow: &mut Flow, symbol: Symbol, end: Id) {
    match symbol {
        Symbol::Position(i) => flow.q[i as usize] = end,
        _ => flow.s = end,
    }
}

/// x' = a·x drives y' = Σ cₖxᵏ: y + Σ cₖxᵏ·h·φ₁(kah). (Friction and the heat that it makes.)
fn driven(graph: &mut Graph, group: &Group, (x, rate): (Symbol, Id), (y, driven): (Symbol, Id)) -> Option<[Id; 2]> {
    if [rate, driven].into_iter().any(|id| reads(graph, id, y)) {
        return None;
    }
    let steady = [rate, driven].into_iter().all(|id| !reads(graph, id, Symbol::Time));
    let powers = |graph: &mut Graph, id| Polynomial::of(graph, id, &|symbol| symbol == x);
    let (own, other) = (powers(graph, rate)?, powers(graph, driven)?);
    let whole = other.has_only(|monomial| monomial.values().all(|power| power.is_integer() && power.numerator > 0));
    if !own.has_only(|monomial| monomial.values().eq([&Ratio::ONE])) || !whole || !steady && group.clock == Clock::Own {
        return None;
    }
    let a = own.coefficient(graph, &[(x, 1)]);
    let end = scalar::solve(graph, &Equation { x, rate, clock: group.clock })?.end;
    let [h, x, mut y] = [Symbol::StepLength, x, y].map(|symbol| graph.symbol(symbol));
    let z = graph.mul(a, h);
    let terms: Vec<(Ratio, Id)> =
        other.terms().map(|(m, c)| (m.values().next().copied().unwrap_or(Ratio::ZERO), c)).collect();
    for (k, coefficient) in terms {
        let z = graph.scale(Number::Exact(k), z);
        let mean = graph.call(Function::Phi1, &[z]);
        let power = graph.pow(x, k);
        let change = graph.product(&[coefficient, power, h, mean]);
        y = graph.add(y, change);
    }
    Some([end, y])
}

/// (x, y)' = A(x, y) with constant A: e^(μh)·(C + S·(A − μ)), 2μ the trace of A, C = cos ωh, S = sin ωh/ω, ω² = det(A − μ).
fn pair(graph: &mut Graph, group: &Group, of: [Symbol; 2], rates: [Id; 2]) -> Option<[Id; 2]> {
    let mut matrix = vec![];
    for rate in rates {
        let linear = Polynomial::of(graph, rate, &|symbol| of.contains(&symbol))?;
        if !linear.has_only(|monomial| monomial.values().eq([&Ratio::ONE])) {
            return None;
        }
        matrix.push(of.map(|symbol| linear.coefficient(graph, &[(symbol, 1)])));
    }
    let steady = matrix.iter().flatten().all(|id| !reads(graph, *id, Symbol::Time));
    if !steady && group.clock == Clock::Own {
        return None;
    }
    let h = graph.symbol(Symbol::StepLength);
    let trace = graph.add(matrix[0][0], matrix[1][1]);
    let mean = graph.scale(Number::HALF, trace);
    let difference = graph.sub(matrix[0][0], matrix[1][1]);
    let d = graph.scale(Number::HALF, difference);
    let cross = graph.mul(matrix[0][1], matrix[1][0]);
    let square = graph.pow(d, Ratio::integer(2));
    let square = graph.add(square, cross);
    let square = graph.neg(square);
    // The momentum that turns with s has a pole within every half a turn.
    let (cosine, sine) = rotation(graph, square, h, of.contains(&Symbol::Action));
    let z = graph.mul(mean, h);
    let growth = graph.call(Function::Exp, &[z]);
    let d = [d, graph.neg(d)];
    let start = of.map(|symbol| graph.symbol(symbol));
    Some([0, 1].map(|i| {
        let own = graph.mul(d[i], sine);
        let own = graph.add(cosine, own);
        let own = graph.mul(own, start[i]);
        let other = graph.product(&[matrix[i][1 - i], sine, start[1 - i]]);
        let sum = graph.add(own, other);
        graph.mul(growth, sum)
    }))
}

/// P from Q and S, and from what is known of their derivatives.
fn momenta(graph: &mut Graph, flow: &mut Flow, known: &[(Symbol, Id)]) -> Option<()> {
    let n = flow.q.len();
    let symbols: Vec<Symbol> = (0..n as u32).map(Symbol::Position).chain([Symbol::Action]).collect();
    let ends = [&flow.q[..], &[flow.s]].concat();
    let mut jacobian = diff::jacobian(graph, &ends, &symbols);
    for (i, symbol) in symbols.iter().enumerate() {
        if let Some((_, slope)) = known.iter().find(|(known, _)| known == symbol) {
            jacobian[i][i] = *slope;
        }
    }
    let p = flow.p.clone();
    // d_jS, from which what momenta of moving coordinates take is subtracted.
    let mut rest: Vec<Id> = vec![];
    for j in 0..n {
        let along = graph.mul(p[j], jacobian[n][n]);
        rest.push(graph.add(jacobian[n][j], along));
    }
    let zero = graph.zero();
    let start = Flow::rest(graph, n as u32);
    let moving: Vec<usize> = (0..n).filter(|i| flow.q[*i] != start.q[*i]).collect();
    let with_s: Vec<usize> = moving.iter().copied().filter(|i| !graph.is_zero(jacobian[*i][n])).collect();
    let mut known = vec![false; n];

    if with_s.len() > 1 {
        // ∂Qᵢ/∂qⱼ + pⱼ ∂Qᵢ/∂s with Qᵢ = qᵢ + …(s): P = y − p (w·y)/(1 + w·p) for y = rest.
        if with_s.iter().any(|i| (0..n).any(|j| jacobian[*i][j] != if *i == j { graph.integer(1) } else { zero })) {
            return None;
        }
        let (mut along, mut taken) = (graph.integer(1), zero);
        for i in &with_s {
            let own = graph.mul(jacobian[*i][n], p[*i]);
            along = graph.add(along, own);
            let own = graph.mul(jacobian[*i][n], rest[*i]);
            taken = graph.add(taken, own);
        }
        let reciprocal = graph.call(Function::RecipPositive, &[along]);
        let share = graph.mul(taken, reciprocal);
        for j in 0..n {
            let own = graph.mul(p[j], share);
            rest[j] = graph.sub(rest[j], own);
        }
        with_s.iter().for_each(|i| known[*i] = true);
    }
    // What depends on s first: it takes from all others.
    let mut open: Vec<usize> = moving.iter().copied().filter(|i| !known[*i]).collect();
    open.sort_by_key(|i| !with_s.contains(i));
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
                take(graph, &mut rest, &jacobian, (&p, i));
            }
            // Two coordinates that turn into each other, by Cramer's rule.
            [j] if graph.is_zero(jacobian[i][n]) && graph.is_zero(jacobian[j][n]) => {
                open.retain(|other| *other != j);
                let straight = graph.mul(jacobian[i][i], jacobian[j][j]);
                let crossed = graph.mul(jacobian[i][j], jacobian[j][i]);
                let determinant = graph.sub(straight, crossed);
                let solved = [(i, j), (j, i)].map(|(a, b)| {
                    let first = graph.mul(jacobian[b][b], rest[a]);
                    let second = graph.mul(jacobian[b][a], rest[b]);
                    let above = graph.sub(first, second);
                    graph.div(above, determinant)
                });
                [rest[i], rest[j]] = solved;
                take_but(graph, &mut rest, &jacobian, (&p, i), j);
                take_but(graph, &mut rest, &jacobian, (&p, j), i);
            }
            _ => return None,
        }
    }
    flow.p = rest;
    Some(())
}

/// Subtracts d_jQᵢ Pᵢ from what is left for all other momenta.
fn take(graph: &mut Graph, rest: &mut [Id], jacobian: &[Vec<Id>], (p, i): (&[Id], usize)) {
    take_but(graph, rest, jacobian, (p, i), i);
}

fn take_but(graph: &mut Graph, rest: &mut [Id], jacobian: &[Vec<Id>], (p, i): (&[Id], usize), spared: usize) {
    let n = p.len();
    for j in (0..n).filter(|j| *j != i && *j != spared) {
        let along = graph.mul(p[j], jacobian[i][n]);
        let weight = graph.add(jacobian[i][j], along);
        let part = graph.mul(weight, rest[i]);
        rest[j] = graph.sub(rest[j], part);
    }
}
