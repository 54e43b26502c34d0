//! Lagrangians that are linear in all velocities, ϑ(q)·v − H(q): equations of first order, Ω q' = ∇H with Ωᵢⱼ = ∂ᵢϑⱼ − ∂ⱼϑᵢ.
//!
//! S = Ω⁻¹ is that of a Poisson bracket, since dΩ = 0. It is written by Pfaffians, without a pivot that might vanish where Ω is regular.
//! Where Ω vanishes on half of the coordinates, y, there is a function f of which ϑ + ∇f has no entry in y: then the other half, x, with
//! P = ϑₓ + ∂f/∂x are canonical coordinates.

use super::mass::blocks;
use super::{at_points, at_rest, divisors, invariant};
use crate::analyze;
use crate::analyze::liouville::{self, Logarithm};
use crate::diff;
use crate::ir::{Graph, Id, Partial, Symbol};
use std::collections::{HashMap, HashSet};

/// What belongs to such a Lagrangian.
#[derive(Debug)]
pub(crate) struct FirstOrder {
    pub(crate) lagrangian: Id,
    /// ϑ.
    pub(crate) momenta: Vec<Id>,
    /// H.
    pub(crate) energy: Id,
    /// Ω.
    pub(crate) form: Vec<Vec<Id>>,
    /// S = Ω⁻¹.
    pub(crate) structure: Vec<Vec<Id>>,
    pub(crate) canonical: Option<Canonical>,
    /// What of L is not defined everywhere.
    pub(crate) partial: Vec<Partial>,
    /// What S is divided by. It vanishes where Ω is singular.
    pub(crate) divisors: Vec<Id>,
}

/// Canonical coordinates.
#[derive(Debug)]
pub(crate) struct Canonical {
    /// f.
    pub(crate) gauge: Id,
    /// In the place of each coordinate: itself, or the momentum P of a coordinate that is kept.
    pub(crate) values: Vec<Id>,
    /// Their derivatives along the motion.
    pub(crate) rates: Vec<Id>,
    /// The coordinates in whose place there is a momentum: which position it belongs to.
    pub(crate) replaced: Vec<(u32, u32)>,
}

/// Why q' does not follow.
#[derive(Debug)]
pub(crate) enum NotRegular {
    /// An odd number of coordinates, which Ω couples with no others.
    Odd(Vec<u32>),
    /// Ω of these is singular at every state.
    Singular(Vec<u32>),
    /// ϑ reads time.
    Timed(u32),
    /// Too many coordinates that Ω couples.
    Large(Vec<u32>),
}

/// So many coupled coordinates: with 10 a Pfaffian has 945 terms.
const MOST: usize = 8;

/// From L and ϑ = ∂L/∂v, which is free of velocities.
pub(crate) fn first_order(
    graph: &mut Graph,
    lagrangian: Id,
    momenta: &[Id],
    written: &[Partial],
) -> Result<FirstOrder, NotRegular> {
    let momenta: Vec<Id> = momenta.iter().map(|momentum| at_rest(graph, *momentum, |_| true)).collect();
    if let Some(i) = momenta.iter().position(|momentum| graph.reads(*momentum).t) {
        return Err(NotRegular::Timed(i as u32));
    }
    let rest = at_rest(graph, lagrangian, |_| true);
    let energy = graph.neg(rest);
    let form = form(graph, &momenta);
    // What Ω⁻¹ is divided by must not vanish either.
    graph.take_partial();
    let structure = inverse(graph, &form)?;
    let mut divided = graph.take_partial();
    graph.stop_recording();
    let canonical = canonical(graph, &momenta, (energy, &form, &structure));
    let mut partial = at_points(graph, written);
    let read: HashSet<Id> = graph.reachable(&structure.concat()).into_iter().collect();
    let known: HashSet<Id> = partial.iter().map(|partial| partial.node).collect();
    divided.retain(|node| read.contains(node));
    let new = divided.iter().filter(|node| !known.contains(node));
    partial.extend(new.map(|node| Partial { node: *node, condition: None }));
    let divisors = divisors(graph, &divided);
    Ok(FirstOrder { lagrangian, momenta, energy, form, structure, canonical, partial, divisors })
}

/// Ω, whose entries read no coordinate on which they do not depend.
fn form(graph: &mut Graph, momenta: &[Id]) -> Vec<Vec<Id>> {
    let n = momenta.len();
    let coordinates: Vec<Symbol> = (0..n as u32).map(Symbol::Q).collect();
    let slopes = diff::jacobian(graph, momenta, &coordinates);
    let mut form = vec![vec![graph.zero(); n]; n];
    for i in 0..n {
        for j in 0..i {
            let entry = graph.sub(slopes[i][j], slopes[j][i]);
            form[j][i] = invariant::simplified(graph, entry);
            form[i][j] = graph.neg(form[j][i]);
        }
    }
    form
}

/// Ω⁻¹, one block of coupled coordinates after the other.
fn inverse(graph: &mut Graph, form: &[Vec<Id>]) -> Result<Vec<Vec<Id>>, NotRegular> {
    let mut inverse = vec![vec![graph.zero(); form.len()]; form.len()];
    for block in blocks(graph, form) {
        if !block.len().is_multiple_of(2) {
            return Err(NotRegular::Odd(block));
        }
        if block.len() > MOST {
            return Err(NotRegular::Large(block));
        }
        let mut pfaffians = Pfaffians { form, block: &block, known: HashMap::new() };
        let all = (1 << block.len()) - 1;
        let whole = pfaffians.of(graph, all);
        if graph.is_zero(whole) || analyze::identity(graph, whole).is_zero() {
            return Err(NotRegular::Singular(block));
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

/// The Pfaffians of a block without some of its rows, by the set of those that are left.
struct Pfaffians<'a> {
    form: &'a [Vec<Id>],
    block: &'a [u32],
    known: HashMap<u32, Id>,
}

impl Pfaffians<'_> {
    /// Expanded by the first row.
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

/// Canonical coordinates, if half of the coordinates can be found on which Ω vanishes, and f of these is elementary.
fn canonical(
    graph: &mut Graph,
    momenta: &[Id],
    (energy, form, structure): (Id, &[Vec<Id>], &[Vec<Id>]),
) -> Option<Canonical> {
    let (kept, replaced) = halves(graph, momenta, form)?;
    let gauge = gauge(graph, momenta, &replaced)?;
    let coordinates: Vec<Symbol> = (0..momenta.len() as u32).map(Symbol::Q).collect();
    let slopes = diff::jacobian(graph, &[gauge], &coordinates).remove(0);
    let gradient = diff::jacobian(graph, &[energy], &coordinates).remove(0);
    let field = diff::flow::times(graph, structure, &gradient);
    let mut values: Vec<Id> = coordinates.iter().map(|symbol| graph.symbol(*symbol)).collect();
    let mut rates = field.clone();
    let pairs = pairs(graph, form, &kept, replaced);
    let moved: Vec<Id> = kept.iter().map(|j| graph.add(momenta[*j as usize], slopes[*j as usize])).collect();
    for (place, position) in &pairs {
        // P' = Σ ∂Pⱼ/∂xᵢ xⱼ' − ∂H/∂xᵢ, as Lagrange's equations have it.
        let by_position = diff::jacobian(graph, &moved, &[Symbol::Q(*position)]);
        let mut terms = vec![graph.neg(gradient[*position as usize])];
        for (j, slope) in kept.iter().zip(by_position) {
            terms.push(graph.mul(slope[0], field[*j as usize]));
        }
        rates[*place as usize] = graph.sum(&terms);
        values[*place as usize] = graph.add(momenta[*position as usize], slopes[*position as usize]);
    }
    Some(Canonical { gauge, values, rates, replaced: pairs })
}

/// x and y.
fn halves(graph: &Graph, momenta: &[Id], form: &[Vec<Id>]) -> Option<(Vec<u32>, Vec<u32>)> {
    let mut replaced = vec![];
    for block in blocks(graph, form) {
        replaced.extend(half(graph, momenta, form, &block)?);
    }
    Some((0..momenta.len() as u32).partition(|i| !replaced.contains(i)))
}

/// Each of y with one of x that Ω couples it to, as far as that is possible: a diagonal that does not vanish is a pivot.
fn pairs(graph: &Graph, form: &[Vec<Id>], kept: &[u32], replaced: Vec<u32>) -> Vec<(u32, u32)> {
    let mut free = kept.to_vec();
    let mut pair = |y: u32| {
        let coupled = free.iter().position(|x| !graph.is_zero(form[y as usize][*x as usize]));
        (y, free.remove(coupled.unwrap_or(0)))
    };
    replaced.into_iter().map(&mut pair).collect()
}

/// Half of some coordinates on which Ω vanishes; of all such halves one with the most entries of ϑ that are zero already.
fn half(graph: &Graph, momenta: &[Id], form: &[Vec<Id>], block: &[u32]) -> Option<Vec<u32>> {
    let halves = (0u32..1 << block.len()).filter(|chosen| chosen.count_ones() as usize == block.len() / 2);
    let picked = halves
        .map(|chosen| -> Vec<u32> { (0..block.len()).filter(|i| chosen & (1 << i) != 0).map(|i| block[i]).collect() });
    let apart =
        |half: &Vec<u32>| half.iter().all(|i| half.iter().all(|j| graph.is_zero(form[*i as usize][*j as usize])));
    let zeros = |half: &Vec<u32>| half.iter().filter(|i| graph.is_zero(momenta[**i as usize])).count();
    picked.filter(apart).max_by_key(zeros)
}

/// f(q) with ∂f/∂y = −ϑ for all y.
fn gauge(graph: &mut Graph, momenta: &[Id], replaced: &[u32]) -> Option<Id> {
    let variables: Vec<Symbol> = replaced.iter().map(|i| Symbol::Q(*i)).collect();
    let slopes: Vec<Id> = replaced.iter().map(|i| graph.neg(momenta[*i as usize])).collect();
    if slopes.iter().all(|slope| graph.is_zero(*slope)) {
        return Some(graph.zero());
    }
    // A logarithm that ϑ does not have would leave P with fewer states than the flow has.
    let known = graph.reachable(momenta);
    [Logarithm::OfNumber, Logarithm::OfMagnitude].into_iter().find_map(|logarithm| {
        let (gauge, _) = liouville::antiderivative(graph, (&variables, &slopes), logarithm).ok()?;
        let everywhere = graph.reachable(&[gauge]).iter().all(|id| !graph.is_partial(*id) || known.contains(id));
        everywhere.then_some(gauge)
    })
}
