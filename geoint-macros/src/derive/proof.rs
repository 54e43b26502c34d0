//! What is proven of a flow before methods rely on it: what it keeps, and what its structure S is. Witnesses, no messages.

use super::flow::{Flow, Named};
use crate::analyze::{Identity, Remainder, identity};
use crate::diff::flow::{orbital, plain, times};
use crate::diff;
use crate::ir::{Graph, Id, Symbol};
use crate::lower::Skew;

/// What is known of the functions that a flow is said to keep.
#[derive(Debug)]
pub(crate) struct Integrals {
    /// Whether each is kept: (f − b)·∇I + ∂I/∂t = 0. Nothing of what is assumed.
    pub(crate) kept: Vec<Option<Identity>>,
    /// The first of them, if any, that is a function of those before it.
    pub(crate) dependent: Option<usize>,
}

/// Decides what a flow keeps.
pub(crate) fn integrals(graph: &mut Graph, flow: &Flow) -> Integrals {
    let mut decide = |named: &Named| {
        (!named.assumed).then(|| {
            let rate = orbital(graph, &flow.field, &named.conserved);
            identity(graph, rate)
        })
    };
    let kept = flow.kept.iter().map(&mut decide).collect();
    let functions: Vec<Id> = flow.kept.iter().map(|named| named.conserved.value).collect();
    Integrals { kept, dependent: dependent(graph, &functions, flow.field.len() as u32) }
}

/// More minors than this are not tried.
const MOST_MINORS: usize = 100;

/// The first function, if any, that is one of those before it: every minor of their gradients is zero. What could not be decided is
/// none.
fn dependent(graph: &mut Graph, functions: &[Id], degrees: u32) -> Option<usize> {
    let gradients: Vec<Vec<Id>> = functions
        .iter()
        .map(|function| {
            let slopes = diff::gradient(graph, *function, degrees).q;
            slopes.into_iter().map(|slope| plain(graph, slope)).collect()
        })
        .collect();
    (0..functions.len()).find(|last| {
        let rows = &gradients[..=*last];
        rows.len() > degrees as usize || all_minors_vanish(graph, rows)
    })
}

fn all_minors_vanish(graph: &mut Graph, rows: &[Vec<Id>]) -> bool {
    let mut choices: Vec<Vec<usize>> = vec![vec![]];
    for _ in rows {
        let longer = choices.iter().flat_map(|chosen| {
            let next = chosen.last().map_or(0, |last| last + 1);
            (next..rows[0].len()).map(move |column| [&chosen[..], &[column]].concat())
        });
        choices = longer.take(MOST_MINORS + 1).collect();
    }
    choices.len() <= MOST_MINORS
        && choices.into_iter().all(|columns| {
            let minor = determinant(graph, rows, &columns);
            identity(graph, minor) == Identity::Zero
        })
}

/// By the first row.
fn determinant(graph: &mut Graph, rows: &[Vec<Id>], columns: &[usize]) -> Id {
    let Some((first, rest)) = rows.split_first() else { return graph.integer(1) };
    let mut terms = vec![];
    for (i, column) in columns.iter().enumerate() {
        if graph.is_zero(first[*column]) {
            continue;
        }
        let others: Vec<usize> = columns.iter().copied().filter(|other| other != column).collect();
        let minor = determinant(graph, rest, &others);
        let term = graph.mul(first[*column], minor);
        terms.push(if i % 2 == 0 { term } else { graph.neg(term) });
    }
    graph.sum(&terms)
}

/// S of x' = S ∇H.
#[derive(Clone, Debug, Default)]
pub(crate) struct Structure {
    pub(crate) matrix: Vec<Vec<Id>>,
    /// The first pair of entries whose sum is not zero, and what that is; nothing left if it was not decided.
    pub(crate) flaw: Option<(usize, usize, Option<Remainder>)>,
    pub(crate) jacobi: Jacobi,
}

/// Whether {f, g} = ∇f·S∇g is a Poisson bracket.
#[derive(Clone, Debug, Default)]
pub(crate) enum Jacobi {
    Holds,
    /// Three indices, and what is left of the cyclic sum.
    Fails([usize; 3], Id),
    /// It was not decided.
    #[default]
    Open,
}

/// S as it is computed: skew to the last bit if it was proven to be skew.
pub(crate) fn structure(graph: &mut Graph, skew: &Skew) -> Structure {
    let matrix = match skew {
        Skew::Matrix(matrix) => matrix.clone(),
        Skew::Nambu(function) => {
            let slopes = diff::gradient(graph, *function, 3).q;
            cross(graph, &slopes)
        }
    };
    let n = matrix.len();
    let mut exact = matrix.clone();
    for i in 0..n {
        for j in 0..=i {
            let sum = graph.add(matrix[i][j], matrix[j][i]);
            let rest = match identity(graph, sum) {
                Identity::Zero => {
                    exact[i][j] = if i == j { graph.zero() } else { graph.neg(matrix[j][i]) };
                    continue;
                }
                Identity::Left(rest) => Some(rest),
                Identity::TooLong => None,
            };
            return Structure { matrix, flaw: Some((j, i, rest)), jacobi: Jacobi::Open };
        }
    }
    let jacobi = jacobi(graph, &exact);
    Structure { matrix: exact, flaw: None, jacobi }
}

/// The matrix of v ↦ a × v.
fn cross(graph: &mut Graph, a: &[Id]) -> Vec<Vec<Id>> {
    let zero = graph.zero();
    let negative: Vec<Id> = a.iter().map(|entry| graph.neg(*entry)).collect();
    vec![vec![zero, negative[2], a[1]], vec![a[2], zero, negative[0]], vec![negative[1], a[0], zero]]
}

/// More sums than this are not looked at.
const MOST_SUMS: usize = 2_000;

/// Σ S_il ∂_l S_jk + cyclic = 0 for all i < j < k.
fn jacobi(graph: &mut Graph, matrix: &[Vec<Id>]) -> Jacobi {
    let n = matrix.len();
    let coordinates: Vec<Symbol> = (0..n as u32).map(Symbol::Q).collect();
    let slopes: Vec<Vec<Vec<Id>>> = matrix.iter().map(|row| diff::jacobian(graph, row, &coordinates)).collect();
    let (mut open, mut sums) = (false, 0);
    for k in 0..n {
        for j in 0..k {
            for i in 0..j {
                let mut terms = vec![];
                for [a, b, c] in [[i, j, k], [j, k, i], [k, i, j]] {
                    terms.extend(times(graph, &[matrix[a].clone()], &slopes[b][c]));
                }
                let sum = graph.sum(&terms);
                if graph.is_zero(sum) {
                    continue;
                }
                sums += 1;
                if sums > MOST_SUMS {
                    return Jacobi::Open;
                }
                let sum = plain(graph, sum);
                match identity(graph, sum) {
                    Identity::Zero => {}
                    Identity::Left(Remainder { rest, certain: true, .. }) => return Jacobi::Fails([i, j, k], rest),
                    Identity::Left(_) | Identity::TooLong => open = true,
                }
            }
        }
    }
    if open { Jacobi::Open } else { Jacobi::Holds }
}
