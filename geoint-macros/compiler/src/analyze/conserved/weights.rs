//! Proposes products of parameters as weights of generators, so that their brackets with an energy cancel.

use crate::analyze::quadratic::{Atom, Atoms, Variable, product_of_atoms};
use crate::ir::Ratio;

/// The weight of a generator.
pub(super) type Weight = Atoms;

/// A term of the bracket {J, Q} of a generator J.
pub(super) struct Term<'a> {
    pub(super) variables: [Variable; 2],
    /// The number of the generator.
    pub(super) generator: usize,
    pub(super) atoms: &'a Weight,
    pub(super) number: Ratio,
}

/// The weight of generator `to` over the weight of generator `from` that lets two terms of a bracket cancel.
struct Edge {
    from: usize,
    to: usize,
    ratio: Weight,
    /// The number of terms with these variables.
    terms: usize,
}

/// Returns a/b. `None` if an exponent is too large.
fn over(a: &Weight, b: &Weight) -> Option<Weight> {
    let reciprocal = b.iter().map(|(atom, exponent)| (*atom, -exponent)).collect();
    product_of_atoms(a, &reciprocal)
}

/// Returns a weight for each generator. With these weights, terms of different generators can cancel for all values of the parameters. Pairs of terms
/// without a third term have priority. The weights are proposals: linear equations decide which combinations vanish. Only `steady` atoms are used.
pub(super) fn weights(generators: usize, brackets: &[Vec<Term<'_>>], steady: impl Fn(&Atom) -> bool) -> Vec<Weight> {
    let mut edges: Vec<Edge> = vec![];
    for terms in brackets.iter().flat_map(|bracket| bracket.chunk_by(|a, b| a.variables == b.variables)) {
        let mut parts: Vec<(usize, &Weight)> = terms.iter().map(|term| (term.generator, term.atoms)).collect();
        parts.sort();
        parts.dedup();
        for pair in parts.windows(2) {
            let [(from, a), (to, b)] = *pair else { continue };
            if from != to
                && a.iter().chain(b).all(|(atom, _)| steady(atom))
                && let Some(ratio) = over(a, b)
            {
                edges.push(Edge { from, to, ratio, terms: parts.len() });
            }
        }
    }
    edges.sort_by_key(|edge| edge.terms);
    let mut weights: Vec<Weight> = vec![vec![]; generators];
    let mut component: Vec<usize> = (0..generators).collect();
    for Edge { from, to, ratio, .. } in edges {
        let (kept, moved) = (component[from], component[to]);
        let Some(wanted) = product_of_atoms(&weights[from], &ratio).filter(|_| kept != moved) else { continue };
        let Some(factor) = over(&wanted, &weights[to]) else { continue };
        for k in (0..generators).filter(|k| component[*k] == moved).collect::<Vec<_>>() {
            component[k] = kept;
            weights[k] = product_of_atoms(&weights[k], &factor).unwrap_or_default();
        }
    }
    for first in 0..generators {
        let members: Vec<usize> = (0..generators).filter(|k| component[*k] == first).collect();
        let mut own: Vec<Weight> = members.iter().map(|k| weights[*k].clone()).collect();
        divide_by_common(&mut own);
        members.into_iter().zip(own).for_each(|(k, weight)| weights[k] = weight);
    }
    weights
}

/// Divides weights by the most common power of each atom. Of two equally common powers, the smaller exponent is removed.
pub(super) fn divide_by_common(weights: &mut [Weight]) {
    let mut atoms: Vec<Atom> = weights.iter().flatten().map(|(atom, _)| *atom).collect();
    atoms.sort();
    atoms.dedup();
    for atom in atoms {
        let exponent = |weight: &Weight| weight.iter().find(|(other, _)| *other == atom).map_or(0, |(_, e)| *e);
        let exponents: Vec<i128> = weights.iter().map(exponent).collect();
        let count = |e: &i128| exponents.iter().filter(|other| *other == e).count();
        let common = exponents.iter().copied().max_by_key(|e| (count(e), -e)).unwrap_or(0);
        for weight in weights.iter_mut().filter(|_| common != 0) {
            *weight = product_of_atoms(weight, &vec![(atom, -common)]).unwrap_or_default();
        }
    }
}
