//! The step of x' = L(x) ∇E + M(x) ∇S that keeps the energy E and never lowers the entropy S, with skew L, positive semidefinite M, L ∇S = 0 and M ∇E = 0:
//!
//! x₁ − x₀ = h (Q L̄ Q ∇̄E + P M̄ P ∇̄S).
//!
//! L̄ and M̄ are taken at the middle of the step, ∇̄ is the discrete gradient. On each block of L, the projection Q removes the component along ∇̄S. On each
//! block of M, P removes the component along ∇̄E. So E changes by 0 and S by h ∇̄S·P M̄ P ∇̄S. Where L̄ ∇̄S = 0 or M̄ ∇̄E = 0 at all states, the projection
//! would change nothing, and is omitted.

use super::equations::times;
use super::field::Field;
use super::flow::{in_means, increments, scaled};
use super::gradient::discrete_gradient;
use super::slope::coordinate_in_middle;
use crate::analyze::vanishes;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Ratio};

/// The mean velocity of a step, with the blocks of both matrices.
#[derive(Debug)]
pub(crate) struct EntropyStep {
    /// S.
    pub(crate) entropy: Id,
    pub(crate) field: Field,
    pub(crate) structure: Vec<Block>,
    pub(crate) friction: Vec<Block>,
}

/// Coordinates that the entries of a matrix couple, and no entry couples to others.
#[derive(Debug)]
pub(crate) struct Block {
    pub(crate) coordinates: Vec<usize>,
    /// True if the step projects on this block.
    pub(crate) projected: bool,
}

/// Builds the step of an energy with its structure L, and of an entropy with its friction M.
pub(crate) fn step(
    graph: &mut Graph,
    energy: Id,
    structure: &[Vec<Id>],
    entropy: Id,
    friction: &[Vec<Id>],
) -> EntropyStep {
    let n = structure.len();
    let [by_energy, by_entropy] = [energy, entropy].map(|function| {
        let slopes = discrete_gradient(graph, function, n as u32).q;
        in_means(graph, &slopes)
    });
    let mut velocity = vec![graph.zero(); n];
    let structure = add_part(graph, structure, &by_energy, &by_entropy, &mut velocity);
    let friction = add_part(graph, friction, &by_entropy, &by_energy, &mut velocity);
    EntropyStep { entropy, field: Field::new(graph, increments(n), velocity), structure, friction }
}

/// Adds Π Ā Π u to the velocity, where the projections Π on the blocks of A remove components along v. Returns the blocks.
fn add_part(graph: &mut Graph, matrix: &[Vec<Id>], u: &[Id], v: &[Id], velocity: &mut [Id]) -> Vec<Block> {
    let mut middle = Substitution::new(coordinate_in_middle);
    let mut blocks = vec![];
    for coordinates in coupled(graph, matrix) {
        let of_block = |all: &[Id]| coordinates.iter().map(|i| all[*i]).collect::<Vec<Id>>();
        let mut row = |i: &usize| of_block(&matrix[*i]).iter().map(|entry| middle.apply(graph, *entry)).collect();
        let rows: Vec<Vec<Id>> = coordinates.iter().map(&mut row).collect();
        let (u, v) = (of_block(u), of_block(v));
        let change = times(graph, &rows, &v);
        let projected = !change.into_iter().all(|entry| vanishes(graph, entry));
        let rates = if projected {
            let across = Across::new(graph, &v);
            let u = across.project(graph, &u);
            let rates = times(graph, &rows, &u);
            across.project(graph, &rates)
        } else {
            times(graph, &rows, &u)
        };
        for (i, rate) in coordinates.iter().zip(rates) {
            velocity[*i] = graph.add(velocity[*i], rate);
        }
        blocks.push(Block { coordinates, projected });
    }
    blocks
}

/// Returns the blocks of a matrix with a symmetric pattern of zeros. Coordinates without entries belong to none.
fn coupled(graph: &Graph, matrix: &[Vec<Id>]) -> Vec<Vec<usize>> {
    let n = matrix.len();
    let (mut seen, mut blocks) = (vec![false; n], vec![]);
    for first in 0..n {
        let (mut block, mut open) = (vec![], vec![first]);
        while let Some(i) = open.pop() {
            let neighbours: Vec<usize> = (0..n).filter(|j| !graph.is_zero(matrix[i][*j])).collect();
            if !std::mem::replace(&mut seen[i], true) && !neighbours.is_empty() {
                block.push(i);
                open.extend(neighbours);
            }
        }
        block.sort_unstable();
        blocks.extend((!block.is_empty()).then_some(block));
    }
    blocks
}

/// The projection across a vector v, 1 − vvᵀ/v·v. It is not a number if v = 0.
struct Across {
    /// v, scaled so that its square neither overflows nor vanishes.
    vector: Vec<Id>,
    /// 1/v·v.
    reciprocal: Id,
}

impl Across {
    fn new(graph: &mut Graph, vector: &[Id]) -> Across {
        let size = sum_of_sizes(graph, vector);
        let vector: Vec<Id> = vector.iter().map(|entry| scaled(graph, *entry, size)).collect();
        let square = graph.dot(&vector, &vector);
        Across { reciprocal: graph.pow(square, Ratio::integer(-1)), vector }
    }

    fn project(&self, graph: &mut Graph, other: &[Id]) -> Vec<Id> {
        let product = graph.dot(other, &self.vector);
        let weight = graph.mul(product, self.reciprocal);
        other.iter().zip(&self.vector).map(|(entry, v)| graph.build(*entry - weight * *v)).collect()
    }
}

/// Returns Σ |vᵢ|. It is zero only if all entries are.
pub(crate) fn sum_of_sizes(graph: &mut Graph, vector: &[Id]) -> Id {
    let sizes: Vec<Id> = vector.iter().map(|entry| graph.call(Function::Abs, &[*entry])).collect();
    graph.sum(&sizes)
}
