//! Proofs about a flow: its integrals, and its structure matrix S. Methods rely on them. `check` turns counterexamples into messages.

mod entropy;
pub(super) mod flow;
pub(super) mod liouville;

use crate::analyze::crossings::{self, Discontinuity};
use crate::analyze::{Identity, claims};
use crate::diff;
use crate::ir::{Graph, Id};
use crate::lower::Skew;
pub(crate) use entropy::{Entropy, entropy};
use flow::{Flow, Named, coordinates};

/// Proofs about the integrals that the user lists.
#[derive(Debug)]
pub(crate) struct Integrals {
    /// For each integral I, whether it is kept: (f − b)·∇I + ∂I/∂t = 0.
    pub(crate) kept: Vec<Identity>,
    /// For each integral, a place where it may jump along the field. Its derivative does not show jumps.
    pub(crate) jumps: Vec<Option<Discontinuity>>,
    /// The first integral that is a function of earlier ones.
    pub(crate) dependent: Option<usize>,
}

/// Decides whether a flow keeps its integrals.
pub(crate) fn integrals(graph: &mut Graph, flow: &Flow) -> Integrals {
    let x = coordinates(flow.field.len());
    let mut decide = |Named { conserved, .. }: &Named| {
        claims::is_kept(graph, &x, &flow.field, conserved.value, conserved.but.as_deref())
    };
    let kept = flow.kept.iter().map(&mut decide).collect();
    let mut jump = |named: &Named| crossings::may_jump(graph, &x, &flow.field, named.conserved.value);
    let jumps = flow.kept.iter().map(&mut jump).collect();
    let functions: Vec<Id> = flow.kept.iter().map(|named| named.conserved.value).collect();
    let dependent = claims::dependent(graph, &x, &functions);
    Integrals { kept, jumps, dependent: dependent.and_then(|found| found.integrals.first().copied()) }
}

/// The matrix S of x' = S ∇H, with proofs.
#[derive(Debug)]
pub(crate) struct Structure {
    /// S in the emitted code. If S is proven to be skew, one of each pair of entries is computed, so that it is skew to the last bit.
    pub(crate) matrix: Vec<Vec<Id>>,
    /// Ok if S is skew. Errors: the indices of the first entries whose sum is not zero, and the result of the test for zero.
    pub(crate) skew: Result<(), ([usize; 2], Identity)>,
    /// Ok if {f, g} = ∇f·S∇g is a Poisson bracket. Errors: the first three indices for which Jacobi's identity fails, and the result of the test.
    pub(crate) poisson: Result<(), ([usize; 3], Identity)>,
    /// The function from which the user has built S.
    pub(crate) casimir: Option<Id>,
}

/// Decides whether S of x' = S ∇H is skew, and makes a Poisson bracket.
pub(crate) fn structure(graph: &mut Graph, energy: Id, skew: &Skew) -> Structure {
    let (mut matrix, casimir) = match skew {
        Skew::Matrix(matrix) => (matrix.clone(), None),
        Skew::Nambu(function) => {
            let slopes = diff::gradient(graph, *function, 3).q;
            (cross(graph, &slopes), Some(*function))
        }
    };
    let x = coordinates(matrix.len());
    // Proofs about a matrix without conditions do not read the field.
    let has_conditions = graph.reachable(&matrix.concat()).into_iter().any(|id| graph.node(id).is_condition());
    let field = if has_conditions { field_of(graph, energy, &matrix) } else { vec![] };
    let is_skew = claims::is_skew(graph, &x, &matrix, &field);
    if is_skew.is_ok() {
        for i in 0..matrix.len() {
            matrix[i][i] = graph.zero();
            for j in 0..i {
                matrix[i][j] = graph.neg(matrix[j][i]);
            }
        }
    }
    let poisson = claims::is_poisson(graph, &x, &matrix, &field);
    Structure { matrix, skew: is_skew, poisson, casimir }
}

/// Returns S ∇H.
fn field_of(graph: &mut Graph, energy: Id, matrix: &[Vec<Id>]) -> Vec<Id> {
    let gradient = diff::gradient(graph, energy, matrix.len() as u32).q;
    diff::equations::structured(graph, matrix, &gradient)
}

/// Returns the matrix of v ↦ a × v.
fn cross(graph: &mut Graph, a: &[Id]) -> Vec<Vec<Id>> {
    let zero = graph.zero();
    let negative: Vec<Id> = a.iter().map(|entry| graph.neg(*entry)).collect();
    vec![vec![zero, negative[2], a[1]], vec![a[2], zero, negative[0]], vec![negative[1], a[0], zero]]
}
