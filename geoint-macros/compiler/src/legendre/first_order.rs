//! Lagrangians ϑ(q)·v − H(q) that are linear in all velocities. Their equations are of first order: Ω q' = ∇H with Ωᵢⱼ = ∂ᵢϑⱼ − ∂ⱼϑᵢ.
//!
//! S = Ω⁻¹ is the structure matrix of a Poisson bracket, because dΩ = 0. It is computed from Pfaffians, because a pivot might vanish where Ω is
//! regular.
//!
//! Ω may vanish on half of the coordinates, called y. Then ϑ + ∇f has no entries in y for some function f. The other half, x, and P = ϑₓ + ∂f/∂x are
//! canonical coordinates.

use super::{add_unconditional, at_rest, divisors, idle_coordinates::without_idle_coordinates, without_velocities};
use crate::analyze;
use crate::analyze::liouville::{self, Logarithm};
use crate::diff;
use crate::ir::{Graph, Id, Symbol, UndefinedAt};
use std::collections::{HashMap, HashSet};

/// The parts of a Lagrangian ϑ(q)·v − H(q).
#[derive(Debug)]
pub(crate) struct FirstOrder {
    pub(crate) lagrangian: Id,
    /// The coefficients ϑ of the velocities.
    pub(crate) momenta: Vec<Id>,
    /// The energy H.
    pub(crate) energy: Id,
    /// The matrix Ω.
    pub(crate) form: Vec<Vec<Id>>,
    /// The structure matrix S = Ω⁻¹.
    pub(crate) structure: Vec<Vec<Id>>,
    pub(crate) canonical: Option<Canonical>,
    /// The partial nodes of L and S.
    pub(crate) partial: Vec<UndefinedAt>,
    /// The divisors of S. One of them vanishes where Ω is singular.
    pub(crate) divisors: Vec<Id>,
}

/// A change to canonical coordinates (x, P).
#[derive(Debug)]
pub(crate) struct Canonical {
    /// The function f with ∂f/∂y = −ϑ for all y.
    pub(crate) gauge: Id,
    /// New coordinates in the order of the old ones: x stays, and each y is replaced by a momentum P.
    pub(crate) values: Vec<Id>,
    /// Time derivatives of the new coordinates.
    pub(crate) rates: Vec<Id>,
    /// For each new coordinate that is a momentum, the position to which it belongs.
    pub(crate) replaced: Vec<(u32, u32)>,
}

/// The reason why the equations do not determine q'.
#[derive(Debug)]
pub(crate) enum FirstOrderFlaw {
    /// An odd number of coordinates that Ω couples with each other, but with no others.
    OddBlock(Vec<u32>),
    /// Ω is singular at every state on these coordinates.
    Singular(Vec<u32>),
    /// ϑ depends on time: then ∂ϑ/∂t is a force, and Ω q' = ∇H is not the whole equation.
    ReadsTime(u32),
    /// Ω couples more than [`LARGEST_BLOCK`] coordinates.
    TooLarge(Vec<u32>),
}

/// Largest number of coupled coordinates. A Pfaffian of 10 coordinates has 945 terms.
pub(crate) const LARGEST_BLOCK: usize = 8;

/// Splits L with the momenta ϑ = ∂L/∂v. Precondition: ϑ reads no velocity. `written` lists the partial nodes of L.
pub(crate) fn first_order(
    graph: &mut Graph,
    lagrangian: Id,
    momenta: &[Id],
    written: &[UndefinedAt],
) -> Result<FirstOrder, FirstOrderFlaw> {
    let momenta: Vec<Id> = momenta.iter().map(|momentum| at_rest(graph, *momentum)).collect();
    if let Some(i) = momenta.iter().position(|momentum| graph.reads(*momentum).t) {
        return Err(FirstOrderFlaw::ReadsTime(i as u32));
    }
    let rest = at_rest(graph, lagrangian);
    let energy = graph.neg(rest);
    let form = form(graph, &momenta);
    // Record the divisors of Ω⁻¹. They are poles, too.
    graph.take_partial();
    let structure = inverse(graph, &form)?;
    let mut divided = graph.take_partial();
    graph.stop_recording();
    let canonical = canonical(graph, &momenta, energy, &form, &structure);
    let mut partial = without_velocities(graph, written);
    let read: HashSet<Id> = graph.reachable(&structure.concat()).into_iter().collect();
    divided.retain(|node| read.contains(node));
    add_unconditional(&mut partial, divided.iter().copied());
    let divisors = divisors(graph, &divided);
    Ok(FirstOrder { lagrangian, momenta, energy, form, structure, canonical, partial, divisors })
}

/// Computes Ω. Its entries are simplified until they read only coordinates on which they depend.
fn form(graph: &mut Graph, momenta: &[Id]) -> Vec<Vec<Id>> {
    let n = momenta.len();
    let coordinates: Vec<Symbol> = (0..n as u32).map(Symbol::Position).collect();
    let jacobian = diff::jacobian(graph, momenta, &coordinates);
    let mut form = vec![vec![graph.zero(); n]; n];
    for i in 0..n {
        for j in 0..i {
            let entry = graph.sub(jacobian[i][j], jacobian[j][i]);
            form[j][i] = without_idle_coordinates(graph, entry);
            form[i][j] = graph.neg(form[j][i]);
        }
    }
    form
}

/// Computes Ω⁻¹ by blocks of coupled coordinates: (Ω⁻¹)ᵢⱼ is a Pfaffian without rows i and j, divided by the Pfaffian of the block, up to the sign.
fn inverse(graph: &mut Graph, form: &[Vec<Id>]) -> Result<Vec<Vec<Id>>, FirstOrderFlaw> {
    let mut inverse = vec![vec![graph.zero(); form.len()]; form.len()];
    for block in diff::blocks(graph, form) {
        if !block.len().is_multiple_of(2) {
            return Err(FirstOrderFlaw::OddBlock(block));
        }
        if block.len() > LARGEST_BLOCK {
            return Err(FirstOrderFlaw::TooLarge(block));
        }
        let mut pfaffians = Pfaffians { form, block: &block, known: HashMap::new() };
        let all = (1 << block.len()) - 1;
        let whole = pfaffians.of(graph, all);
        if analyze::identity(graph, whole).is_zero() {
            return Err(FirstOrderFlaw::Singular(block));
        }
        let reciprocal = graph.recip(whole);
        for i in 0..block.len() {
            for j in i + 1..block.len() {
                let minor = pfaffians.of(graph, all & !(1 << i) & !(1 << j));
                let entry = graph.mul(minor, reciprocal);
                let opposite = graph.neg(entry);
                let (above, below) = if (i + j) % 2 == 0 { (entry, opposite) } else { (opposite, entry) };
                let [i, j] = [i, j].map(|k| block[k] as usize);
                (inverse[i][j], inverse[j][i]) = (above, below);
            }
        }
    }
    Ok(inverse)
}

/// Cache of the Pfaffians of the minors of a block. The key is the set of the rows that are kept, one bit each.
struct Pfaffians<'a> {
    form: &'a [Vec<Id>],
    block: &'a [u32],
    known: HashMap<u32, Id>,
}

impl Pfaffians<'_> {
    /// Computes the Pfaffian of a minor by expansion along its first row.
    fn of(&mut self, graph: &mut Graph, rows: u32) -> Id {
        if let Some(known) = self.known.get(&rows) {
            return *known;
        }
        let left: Vec<usize> = (0..self.block.len()).filter(|i| rows & (1 << i) != 0).collect();
        let Some((first, others)) = left.split_first() else { return graph.integer(1) };
        let mut terms = vec![];
        for (place, other) in others.iter().enumerate() {
            let entry = self.form[self.block[*first] as usize][self.block[*other] as usize];
            if !graph.is_zero(entry) {
                let minor = self.of(graph, rows & !(1 << first) & !(1 << other));
                let term = graph.mul(entry, minor);
                terms.push(if place % 2 == 0 { term } else { graph.neg(term) });
            }
        }
        let value = graph.sum(&terms);
        self.known.insert(rows, value);
        value
    }
}

/// Finds canonical coordinates. They exist if Ω vanishes on half of the coordinates and f is elementary.
fn canonical(
    graph: &mut Graph,
    momenta: &[Id],
    energy: Id,
    form: &[Vec<Id>],
    structure: &[Vec<Id>],
) -> Option<Canonical> {
    let replaced = replaced(graph, momenta, form)?;
    let kept: Vec<u32> = (0..momenta.len() as u32).filter(|i| !replaced.contains(i)).collect();
    let gauge = gauge(graph, momenta, &replaced)?;
    let coordinates: Vec<Symbol> = (0..momenta.len() as u32).map(Symbol::Position).collect();
    let slopes = diff::jacobian(graph, &[gauge], &coordinates).remove(0);
    let gradient = diff::jacobian(graph, &[energy], &coordinates).remove(0);
    let field = diff::equations::structured(graph, structure, &gradient);
    let mut values: Vec<Id> = coordinates.iter().map(|symbol| graph.symbol(*symbol)).collect();
    let mut rates = field.clone();
    let pairs = pairs(graph, form, &kept, replaced);
    let moved: Vec<Id> = kept.iter().map(|j| graph.add(momenta[*j as usize], slopes[*j as usize])).collect();
    for (place, position) in &pairs {
        // Lagrange's equations: P' = Σ ∂Pⱼ/∂xᵢ xⱼ' − ∂H/∂xᵢ.
        let by_position = diff::jacobian(graph, &moved, &[Symbol::Position(*position)]);
        let mut terms = vec![graph.neg(gradient[*position as usize])];
        for (j, slope) in kept.iter().zip(by_position) {
            terms.push(graph.mul(slope[0], field[*j as usize]));
        }
        rates[*place as usize] = graph.sum(&terms);
        values[*place as usize] = graph.add(momenta[*position as usize], slopes[*position as usize]);
    }
    Some(Canonical { gauge, values, rates, replaced: pairs })
}

/// Returns the coordinates y that are replaced by momenta.
fn replaced(graph: &Graph, momenta: &[Id], form: &[Vec<Id>]) -> Option<Vec<u32>> {
    let mut replaced = vec![];
    for block in diff::blocks(graph, form) {
        replaced.extend(half(graph, momenta, form, &block)?);
    }
    Some(replaced)
}

/// Pairs each y with an x to which Ω couples it, as pairs (y, x). The block Ω(x, y) then has few zeros on its diagonal. The search is greedy.
fn pairs(graph: &Graph, form: &[Vec<Id>], kept: &[u32], replaced: Vec<u32>) -> Vec<(u32, u32)> {
    let mut free = kept.to_vec();
    let mut pair = |y: u32| {
        let coupled = free.iter().position(|x| !graph.is_zero(form[y as usize][*x as usize]));
        (y, free.remove(coupled.unwrap_or(0)))
    };
    replaced.into_iter().map(&mut pair).collect()
}

/// Finds half of a block's coordinates on which Ω vanishes. It prefers the half with the most zero entries of ϑ.
fn half(graph: &Graph, momenta: &[Id], form: &[Vec<Id>], block: &[u32]) -> Option<Vec<u32>> {
    let halves = (0u32..1 << block.len()).filter(|chosen| chosen.count_ones() as usize == block.len() / 2);
    let picked = halves
        .map(|chosen| -> Vec<u32> { (0..block.len()).filter(|i| chosen & (1 << i) != 0).map(|i| block[i]).collect() });
    let apart =
        |half: &Vec<u32>| half.iter().all(|i| half.iter().all(|j| graph.is_zero(form[*i as usize][*j as usize])));
    let zeros = |half: &Vec<u32>| half.iter().filter(|i| graph.is_zero(momenta[**i as usize])).count();
    picked.filter(apart).max_by_key(zeros)
}

/// Integrates ∂f/∂y = −ϑ for all y.
fn gauge(graph: &mut Graph, momenta: &[Id], replaced: &[u32]) -> Option<Id> {
    let variables: Vec<Symbol> = replaced.iter().map(|i| Symbol::Position(*i)).collect();
    let slopes: Vec<Id> = replaced.iter().map(|i| graph.neg(momenta[*i as usize])).collect();
    if slopes.iter().all(|slope| graph.is_zero(*slope)) {
        return Some(graph.zero());
    }
    // A logarithm in f that ϑ does not contain would restrict the domain of P. Every partial node of f must be a node of ϑ.
    let known = graph.reachable(momenta);
    [Logarithm::OfNumber, Logarithm::OfMagnitude].into_iter().find_map(|logarithm| {
        let (gauge, _) = liouville::antiderivative(graph, &variables, &slopes, logarithm).ok()?;
        let everywhere = graph.reachable(&[gauge]).iter().all(|id| !graph.is_partial(*id) || known.contains(id));
        everywhere.then_some(gauge)
    })
}
