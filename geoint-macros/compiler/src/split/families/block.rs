//! Quadratic energies: linear flows, block by block of degrees of freedom that are coupled.
//!
//! x' = Mx + g with M = JS. For more than two degrees of freedom exp(hM) is a matrix of numbers. For one or two the powers of M are 1, M, N = M², M³, because N² = −bN − c with b = −tr N/2 and
//! c = det M. With z₁ and z₂ the roots of z² + bh²z + ch⁴, S(z) = sinh √z/√z and D(z) = (cosh √z − 1)/z, the lines through both values of
//! S and of D are s₀ + s₂z and d₀ + d₂z, and φ₁(hM) = s₀ + s₂h²N + hM (d₀ + d₂h²N). Then x moves by hM φ₁(hM) x + h φ₁(hM) g, where no
//! numbers of nearly equal size are subtracted.

use super::super::flow::{Flow, Group};
use super::super::polynomial::Polynomial;
use super::quadratic::coefficients;
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

type Matrix = Vec<Vec<Id>>;

/// x·Sx/2 + g·x + c.
pub(in super::super) fn block(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let powers = coefficients(graph, group, |monomial| {
        let degree: i128 = monomial.iter().map(|(_, power)| power).sum();
        monomial.iter().all(|(symbol, power)| *symbol != Symbol::Action && *power > 0) && degree <= 2
    })?;
    let mut flow = Flow::rest(graph, group.degrees);
    for block in blocks(graph, &powers, group.degrees)? {
        let coordinates: Vec<Symbol> =
            block.iter().map(|i| Symbol::Position(*i)).chain(block.iter().map(|i| Symbol::Momentum(*i))).collect();
        let n = block.len();
        // S, and J: q' = ∂H/∂p, p' = −∂H/∂q.
        let row = |graph: &mut Graph, of: Symbol| -> Vec<Id> {
            coordinates.iter().map(|other| second(graph, &powers, of, *other)).collect()
        };
        let turned: Vec<(Symbol, Number)> = coordinates[n..]
            .iter()
            .map(|p| (*p, Number::ONE))
            .chain(coordinates[..n].iter().map(|q| (*q, Number::MINUS_ONE)))
            .collect();
        let (mut m, mut g) = (vec![], vec![]);
        for (of, sign) in turned {
            let entries = row(graph, of);
            m.push(entries.into_iter().map(|entry| graph.scale(sign, entry)).collect::<Vec<_>>());
            let slope = powers.coefficient(graph, &[(of, 1)]);
            g.push(graph.scale(sign, slope));
        }
        if n > CLOSED {
            let changes = changes(graph, &m, &g, &coordinates);
            for (symbol, change) in coordinates.iter().zip(changes) {
                let start = graph.symbol(*symbol);
                flow.moves(*symbol, graph.add(start, change));
            }
            continue;
        }
        let (change, mean) = exponential(graph, &m);
        let h = graph.symbol(Symbol::StepLength);
        for (i, symbol) in coordinates.iter().enumerate() {
            let mut terms = vec![graph.symbol(*symbol)];
            for (j, other) in coordinates.iter().enumerate() {
                let x = graph.symbol(*other);
                terms.push(graph.mul(change[i][j], x));
                let shifted = graph.product(&[h, mean[i][j], g[j]]);
                terms.push(shifted);
            }
            let end = graph.sum(&terms);
            flow.moves(*symbol, end);
        }
    }
    Some(flow)
}

/// So many degrees of freedom have a flow in closed form.
const CLOSED: usize = 2;

/// So many may be coupled: a flow then costs as much as 4·32² products, and its matrix is prepared.
const MOST: usize = 32;

/// (exp(hM) − 1) x + hφ₁(hM) g for more degrees of freedom: a matrix is computed where a step is prepared, with g as what a coordinate
/// that stays 1 adds.
fn changes(graph: &mut Graph, m: &Matrix, g: &[Id], coordinates: &[Symbol]) -> Vec<Id> {
    let h = graph.symbol(Symbol::StepLength);
    let shifted = g.iter().any(|slope| !graph.is_zero(*slope));
    let size = coordinates.len() + usize::from(shifted);
    let mut entries = vec![graph.integer(size as i128)];
    for column in 0..size {
        for row in 0..coordinates.len() {
            let entry = if column < coordinates.len() { m[row][column] } else { g[row] };
            if !graph.is_zero(entry) {
                entries.push(graph.integer((column * size + row) as i128));
                entries.push(graph.mul(h, entry));
            }
        }
    }
    let mut args = vec![graph.zero(), graph.call(Function::FlowMatrix, &entries)];
    args.extend(coordinates.iter().map(|symbol| graph.symbol(*symbol)));
    if shifted {
        args.push(graph.integer(1));
    }
    (0..coordinates.len())
        .map(|row| {
            args[0] = graph.integer(row as i128);
            graph.call(Function::FlowChange, &args)
        })
        .collect()
}

/// Degrees of freedom that are coupled; nothing if these are too many.
fn blocks(graph: &mut Graph, powers: &Polynomial, degrees: u32) -> Option<Vec<Vec<u32>>> {
    let mut blocks: Vec<Vec<u32>> = vec![];
    for i in 0..degrees {
        let coupled = |graph: &mut Graph, j: u32| {
            let [own, other] = [i, j].map(|k| [Symbol::Position(k), Symbol::Momentum(k)]);
            own.into_iter().any(|a| {
                other.into_iter().any(|b| {
                    let entry = second(graph, powers, a, b);
                    !graph.is_zero(entry)
                })
            })
        };
        let (mut with, others): (Vec<_>, Vec<_>) =
            blocks.into_iter().partition(|block| block.iter().any(|j| coupled(graph, *j)));
        with.push(vec![i]);
        blocks = others;
        blocks.push(with.concat());
    }
    // What does not move has no block.
    blocks.retain(|block| {
        powers.terms().any(|(monomial, _)| {
            monomial
                .keys()
                .any(|symbol| matches!(symbol, Symbol::Position(i) | Symbol::Momentum(i) if block.contains(i)))
        })
    });
    blocks.iter().all(|block| block.len() <= MOST).then_some(blocks)
}

/// ∂²H/∂a∂b.
fn second(graph: &mut Graph, powers: &Polynomial, a: Symbol, b: Symbol) -> Id {
    if a == b {
        let half = powers.coefficient(graph, &[(a, 2)]);
        return graph.scale(Number::integer(2), half);
    }
    powers.coefficient(graph, &[(a, 1), (b, 1)])
}

/// hM φ₁(hM) and φ₁(hM).
fn exponential(graph: &mut Graph, m: &Matrix) -> (Matrix, Matrix) {
    let h = graph.symbol(Symbol::StepLength);
    let n = product(graph, m, m);
    let trace: Vec<Id> = (0..m.len()).map(|i| n[i][i]).collect();
    let trace = graph.sum(&trace);
    let h2 = graph.pow(h, Ratio::integer(2));
    let of_plane = m.len() == 2;
    let b = graph.scale(Number::Exact(Ratio { numerator: -1, denominator: 2 }), trace);
    let scaled_b = graph.mul(h2, b);
    if of_plane {
        // Both roots are −b, N = −b: S = c₁(bh²), and D = c₁(bh²/4)²/2.
        let sine = graph.call(Function::StumpffC1, &[scaled_b]);
        let quarter = graph.scale(Number::Exact(Ratio { numerator: 1, denominator: 4 }), scaled_b);
        let half_sine = graph.call(Function::StumpffC1, &[quarter]);
        let square = graph.pow(half_sine, Ratio::integer(2));
        let d = graph.scale(Number::HALF, square);
        let by_m = graph.mul(h, d);
        let mean = combined(graph, 2, &[(Some(m), by_m), (None, sine)]);
        let along = graph.mul(h, sine);
        let bent = graph.product(&[h2, b, d]);
        let bent = graph.neg(bent);
        let change = combined(graph, 2, &[(Some(m), along), (None, bent)]);
        return (change, mean);
    }
    let c = determinant(graph, m);
    let h4 = graph.pow(h, Ratio::integer(4));
    let scaled_c = graph.mul(h4, c);
    // D by its value at z = −b.
    let [s0, s2, across, d2] = Function::LINEAR_FLOW.map(|function| graph.call(function, &[scaled_b, scaled_c]));
    let cube = product(graph, m, &n);
    let h3 = graph.pow(h, Ratio::integer(3));
    let mean = {
        let rise = graph.mul(scaled_b, d2);
        let d0 = graph.add(across, rise);
        let (by_n, by_m, by_cube) = (graph.mul(h2, s2), graph.mul(h, d0), graph.mul(h3, d2));
        combined(graph, 4, &[(None, s0), (Some(&n), by_n), (Some(m), by_m), (Some(&cube), by_cube)])
    };
    let change = {
        let (by_m, by_cube) = (graph.mul(h, s0), graph.mul(h3, s2));
        let by_n = graph.mul(h2, across);
        let by_one = graph.mul(scaled_c, d2);
        let by_one = graph.neg(by_one);
        combined(graph, 4, &[(Some(m), by_m), (Some(&cube), by_cube), (Some(&n), by_n), (None, by_one)])
    };
    (change, mean)
}

/// A sum of matrices with weights; nothing stands for 1.
fn combined(graph: &mut Graph, size: usize, parts: &[(Option<&Matrix>, Id)]) -> Matrix {
    let mut sum = vec![vec![graph.zero(); size]; size];
    for (matrix, weight) in parts {
        for (i, row) in sum.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                let part = match matrix {
                    Some(matrix) => graph.mul(*weight, matrix[i][j]),
                    None if i == j => *weight,
                    None => continue,
                };
                *entry = graph.add(*entry, part);
            }
        }
    }
    sum
}

fn product(graph: &mut Graph, a: &Matrix, b: &Matrix) -> Matrix {
    let size = a.len();
    let entry = |graph: &mut Graph, i: usize, j: usize| {
        let products: Vec<Id> = (0..size).map(|k| graph.mul(a[i][k], b[k][j])).collect();
        graph.sum(&products)
    };
    (0..size).map(|i| (0..size).map(|j| entry(graph, i, j)).collect()).collect()
}

/// That of four rows, by minors of the first two and the last two.
fn determinant(graph: &mut Graph, m: &Matrix) -> Id {
    let minor = |graph: &mut Graph, rows: [usize; 2], [a, b]: [usize; 2]| {
        let [first, second] = rows.map(|row| &m[row]);
        let straight = graph.mul(first[a], second[b]);
        let crossed = graph.mul(first[b], second[a]);
        graph.sub(straight, crossed)
    };
    let pairs = [
        ([0, 1], [2, 3], 1),
        ([0, 2], [1, 3], -1),
        ([0, 3], [1, 2], 1),
        ([1, 2], [0, 3], 1),
        ([1, 3], [0, 2], -1),
        ([2, 3], [0, 1], 1),
    ];
    let mut sum = graph.zero();
    for (upper, lower, sign) in pairs {
        let [upper, lower] = [minor(graph, [0, 1], upper), minor(graph, [2, 3], lower)];
        let term = graph.mul(upper, lower);
        let term = graph.scale(Number::integer(sign), term);
        sum = graph.add(sum, term);
    }
    sum
}
