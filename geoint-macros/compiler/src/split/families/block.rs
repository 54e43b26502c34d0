//! Family "coupled oscillators": quadratic energies. Each block of coupled degrees of freedom has a linear flow.
//!
//! The equations of motion are x' = Mx + g with M = JS. The flow moves x by hM φ₁(hM) x + h φ₁(hM) g, which subtracts no nearly equal numbers.
//!
//! For up to two degrees of freedom the flow is a formula. With N = M², b = −tr N/2 and c = det M, N² = −bN − c, so 1, M, N and M³ suffice.
//! Let z₁ and z₂ be the roots of z² + bh²z + ch⁴. The line s₀ + s₂z passes through the values of S(z) = sinh √z/√z at both roots. The line
//! d₀ + d₂z passes through the values of D(z) = (cosh √z − 1)/z. Then φ₁(hM) = s₀ + s₂h²N + hM (d₀ + d₂h²N). For more degrees of freedom, exp(hM) is
//! computed numerically.

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Polynomial, degree_of_freedom};
use super::super::products::matrix_product;
use super::quadratic::coefficients;
use crate::ir::formula::{call, pow, squared};
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

type Matrix = Vec<Vec<Id>>;

/// Returns the flow of x·Sx/2 + g·x + c.
pub(super) fn block(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let powers = coefficients(graph, group, |monomial| {
        let degree: i128 = monomial.iter().map(|(_, power)| power).sum();
        monomial.iter().all(|(symbol, power)| *symbol != Symbol::Action && *power > 0) && degree <= 2
    })?;
    let mut flow = Flow::rest(graph, group.degrees);
    for block in blocks(graph, &powers, group.degrees)? {
        let positions = block.iter().map(|i| Symbol::Position(*i));
        let momenta = block.iter().map(|i| Symbol::Momentum(*i));
        let coordinates: Vec<Symbol> = positions.clone().chain(momenta.clone()).collect();
        // q' = ∂H/∂p, p' = −∂H/∂q.
        let slopes = momenta.map(|p| (p, Number::ONE)).chain(positions.map(|q| (q, Number::MINUS_ONE)));
        let (mut m, mut g) = (vec![], vec![]);
        for (symbol, sign) in slopes {
            let row: Vec<Id> =
                coordinates.iter().map(|other| powers.second_derivative(graph, symbol, *other)).collect();
            m.push(row.into_iter().map(|entry| graph.scale(sign, entry)).collect::<Vec<_>>());
            let slope = powers.coefficient(graph, &[(symbol, 1)]);
            g.push(graph.scale(sign, slope));
        }
        if block.len() > MOST_WITH_FORMULA {
            let changes = changes(graph, &m, &g, &coordinates);
            for (symbol, change) in coordinates.iter().zip(changes) {
                let start = graph.symbol(*symbol);
                flow.set(*symbol, graph.add(start, change));
            }
            continue;
        }
        let Exponential { change, mean } = exponential(graph, &m);
        let h = graph.symbol(Symbol::StepLength);
        for (i, symbol) in coordinates.iter().enumerate() {
            let mut terms = vec![graph.symbol(*symbol)];
            for (j, other) in coordinates.iter().enumerate() {
                let x = graph.symbol(*other);
                terms.push(graph.mul(change[i][j], x));
                terms.push(graph.product(&[h, mean[i][j], g[j]]));
            }
            let end = graph.sum(&terms);
            flow.set(*symbol, end);
        }
    }
    Some(flow)
}

/// The largest number of coupled degrees of freedom whose flow is a formula.
const MOST_WITH_FORMULA: usize = 2;

/// The largest number of coupled degrees of freedom. A flow then costs up to 4·32² products. Its matrix is computed once for each h.
const MOST: usize = 32;

/// Returns hM φ₁(hM) x + h φ₁(hM) g with a numerical matrix exponential. A coordinate with the constant value 1 carries g.
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

/// Returns the sets of coupled degrees of freedom that move, or `None` if a set is too large.
fn blocks(graph: &mut Graph, powers: &Polynomial, degrees: u32) -> Option<Vec<Vec<u32>>> {
    let mut blocks: Vec<Vec<u32>> = vec![];
    for i in 0..degrees {
        let coupled = |graph: &mut Graph, j: u32| {
            let [own, other] = [i, j].map(|k| [Symbol::Position(k), Symbol::Momentum(k)]);
            own.into_iter().any(|a| {
                other.into_iter().any(|b| {
                    let entry = powers.second_derivative(graph, a, b);
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
    let read = |symbol: &Symbol| degree_of_freedom(*symbol);
    let moving: Vec<u32> = powers.terms().flat_map(|(monomial, _)| monomial.keys().filter_map(read)).collect();
    blocks.retain(|block| block.iter().any(|i| moving.contains(i)));
    blocks.iter().all(|block| block.len() <= MOST).then_some(blocks)
}

/// Functions of the matrix of a linear flow.
struct Exponential {
    /// hM φ₁(hM) = exp(hM) − 1.
    change: Matrix,
    /// φ₁(hM), the mean of exp(tM) over the step.
    mean: Matrix,
}

fn exponential(graph: &mut Graph, m: &Matrix) -> Exponential {
    let h = graph.symbol(Symbol::StepLength);
    let n = matrix_product(graph, m, m);
    let trace: Vec<Id> = (0..m.len()).map(|i| n[i][i]).collect();
    let trace = graph.sum(&trace);
    let h2 = graph.build(squared(h));
    let b = graph.scale(Number::HALF.neg(), trace);
    let scaled_b = graph.mul(h2, b);
    if m.len() == 2 {
        // N = −b, and both roots are −bh²: S = c₁(bh²), D = c₁(bh²/4)²/2 with Stumpff's function c₁.
        let sine = graph.call(Function::StumpffC1, &[scaled_b]);
        let quarter = Number::Exact(Ratio { numerator: 1, denominator: 4 });
        let d = graph.build(Number::HALF * squared(call(Function::StumpffC1, [quarter * scaled_b])));
        let by_m = graph.mul(h, d);
        let mean = combined(graph, sine, &[(m, by_m)]);
        let along = graph.mul(h, sine);
        let bent = graph.build(-(h2 * b * d));
        return Exponential { change: combined(graph, bent, &[(m, along)]), mean };
    }
    let c = determinant(graph, m);
    let scaled_c = graph.build(pow(h, Ratio::integer(4)) * c);
    // The line of D is given by its value `across` at z = −bh² and its slope d₂.
    let [s0, s2, across, d2] = Function::LINEAR_FLOW.map(|function| graph.call(function, &[scaled_b, scaled_c]));
    let cube = matrix_product(graph, m, &n);
    let h3 = graph.pow(h, Ratio::integer(3));
    let d0 = graph.build(across + scaled_b * d2);
    let (by_n, by_m, by_cube) = (graph.mul(h2, s2), graph.mul(h, d0), graph.mul(h3, d2));
    let mean = combined(graph, s0, &[(&n, by_n), (m, by_m), (&cube, by_cube)]);
    let (by_m, by_cube) = (graph.mul(h, s0), graph.mul(h3, s2));
    let by_n = graph.mul(h2, across);
    let by_one = graph.build(-(scaled_c * d2));
    Exponential { change: combined(graph, by_one, &[(m, by_m), (&cube, by_cube), (&n, by_n)]), mean }
}

/// Returns by_one·1 + Σ weight·matrix.
fn combined(graph: &mut Graph, by_one: Id, parts: &[(&Matrix, Id)]) -> Matrix {
    let zero = graph.zero();
    let size = parts[0].0.len();
    let mut sum: Matrix = (0..size).map(|i| (0..size).map(|j| if i == j { by_one } else { zero }).collect()).collect();
    for (matrix, weight) in parts {
        for (i, row) in sum.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = graph.build(*entry + *weight * matrix[i][j]);
            }
        }
    }
    sum
}

/// Returns the determinant of a matrix with four rows, by minors of the first two and the last two rows.
fn determinant(graph: &mut Graph, m: &Matrix) -> Id {
    let minor = |graph: &mut Graph, rows: [usize; 2], [a, b]: [usize; 2]| {
        let [first, second] = rows.map(|row| &m[row]);
        graph.build(first[a] * second[b] - first[b] * second[a])
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
        sum = graph.build(sum + sign * (upper * lower));
    }
    sum
}
