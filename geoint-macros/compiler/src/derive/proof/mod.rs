//! What is proven of a flow before methods rely on it: what it keeps, and what its structure S is. Witnesses, no messages.

pub(super) mod flow;
pub(super) mod liouville;

use crate::analyze::crossings::{self, Discontinuity};
use crate::analyze::{Identity, claims};
use crate::diff;
use crate::ir::{Graph, Id};
use crate::lower::Skew;
use flow::{Flow, Named, coordinates};

/// What is known of the functions that a flow is said to keep.
#[derive(Debug)]
pub(crate) struct Integrals {
    /// Whether each is kept: (f − b)·∇I + ∂I/∂t = 0.
    pub(crate) kept: Vec<Identity>,
    /// Where each may jump on the way along the field: its derivative does not show that.
    pub(crate) jumps: Vec<Option<Discontinuity>>,
    /// The first of them, if any, that is a function of those before it.
    pub(crate) dependent: Option<usize>,
}

/// Decides what a flow keeps.
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

/// S of x' = S ∇H.
#[derive(Debug)]
pub(crate) struct Structure {
    /// As it is computed: skew to the last bit if it was proven to be skew.
    pub(crate) matrix: Vec<Vec<Id>>,
    /// Whether it is skew; else the first pair of entries whose sum is not zero, and what is known of that.
    pub(crate) skew: Result<(), ([usize; 2], Identity)>,
    /// Whether {f, g} = ∇f·S∇g is a Poisson bracket; else the first three indices for which Jacobi's identity fails.
    pub(crate) poisson: Result<(), ([usize; 3], Identity)>,
    /// The function that the user has made S of.
    pub(crate) casimir: Option<Id>,
}

/// Decides what S of x' = S ∇H is.
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

/// S ∇H.
fn field_of(graph: &mut Graph, energy: Id, matrix: &[Vec<Id>]) -> Vec<Id> {
    let gradient = diff::gradient(graph, energy, matrix.len() as u32).q;
    diff::equations::structured(graph, matrix, &gradient)
}

/// The matrix of v ↦ a × v.
fn cross(graph: &mut Graph, a: &[Id]) -> Vec<Vec<Id>> {
    let zero = graph.zero();
    let negative: Vec<Id> = a.iter().map(|entry| graph.neg(*entry)).collect();
    vec![vec![zero, negative[2], a[1]], vec![a[2], zero, negative[0]], vec![negative[1], a[0], zero]]
}
