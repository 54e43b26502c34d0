//! Which products of parameters may be before generators, so that their brackets cancel.

use crate::analyze::quadratic::{Atom, Variable};
use crate::ir::Ratio;

/// Π atomᵉ, in order of the atoms; no exponent is zero.
pub(super) type Weight = Vec<(Atom, i128)>;

/// A term of {J, Q} of one generator: its variables, the generator, and its coefficient.
pub(super) struct Term<'a> {
    pub(super) variables: [Variable; 2],
    pub(super) generator: usize,
    pub(super) atoms: &'a Weight,
    pub(super) number: Ratio,
}

/// The product; `None` if an exponent is too large.
pub(super) fn times(a: &Weight, b: &Weight) -> Option<Weight> {
    let mut product = a.clone();
    for (atom, exponent) in b {
        match product.binary_search_by_key(atom, |(atom, _)| *atom) {
            Ok(i) => product[i].1 = product[i].1.checked_add(*exponent)?,
            Err(i) => product.insert(i, (*atom, *exponent)),
        }
    }
    product.retain(|(_, exponent)| *exponent != 0);
    Some(product)
}

/// a/b.
fn over(a: &Weight, b: &Weight) -> Option<Weight> {
    let reciprocal = b.iter().map(|(atom, exponent)| (*atom, -exponent)).collect();
    times(a, &reciprocal)
}

/// For each generator a weight that lets what it contributes to brackets cancel with what others do, whatever the parameters are. These
/// are proposals, from terms of two generators first: whether combinations vanish is decided by the equations.
pub(super) fn weights(generators: usize, brackets: &[Vec<Term<'_>>], steady: impl Fn(&Atom) -> bool) -> Vec<Weight> {
    let mut edges: Vec<(usize, [usize; 2], Weight)> = vec![];
    for terms in brackets.iter().flat_map(|bracket| bracket.chunk_by(|a, b| a.variables == b.variables)) {
        let mut parts: Vec<(usize, &Weight)> = terms.iter().map(|term| (term.generator, term.atoms)).collect();
        parts.sort();
        parts.dedup();
        for pair in parts.windows(2) {
            let [(g, a), (h, b)] = pair else { continue };
            if g != h
                && a.iter().chain(*b).all(|(atom, _)| steady(atom))
                && let Some(ratio) = over(a, b)
            {
                edges.push((parts.len(), [*g, *h], ratio));
            }
        }
    }
    edges.sort_by_key(|(parts, ..)| *parts);
    let mut weights: Vec<Weight> = vec![vec![]; generators];
    let mut component: Vec<usize> = (0..generators).collect();
    for (_, [g, h], ratio) in edges {
        let (kept, moved) = (component[g], component[h]);
        let Some(wanted) = times(&weights[g], &ratio).filter(|_| kept != moved) else { continue };
        let Some(factor) = over(&wanted, &weights[h]) else { continue };
        let members: Vec<usize> = (0..generators).filter(|k| component[*k] == moved).collect();
        for k in members {
            component[k] = kept;
            weights[k] = times(&weights[k], &factor).unwrap_or_default();
        }
    }
    for first in 0..generators {
        let members: Vec<usize> = (0..generators).filter(|k| component[*k] == first).collect();
        let mut own: Vec<Weight> = members.iter().map(|k| weights[*k].clone()).collect();
        clear(&mut own);
        members.into_iter().zip(own).for_each(|(k, weight)| weights[k] = weight);
    }
    weights
}

/// Divides weights by what most of them have in common; by what all have if as many have another power.
pub(super) fn clear(weights: &mut [Weight]) {
    let mut atoms: Vec<Atom> = weights.iter().flatten().map(|(atom, _)| *atom).collect();
    atoms.sort();
    atoms.dedup();
    for atom in atoms {
        let exponent = |weight: &Weight| weight.iter().find(|(other, _)| *other == atom).map_or(0, |(_, e)| *e);
        let exponents: Vec<i128> = weights.iter().map(exponent).collect();
        let count = |e: &i128| exponents.iter().filter(|other| *other == e).count();
        let common = exponents.iter().copied().max_by_key(|e| (count(e), -e)).unwrap_or(0);
        for weight in weights.iter_mut().filter(|_| common != 0) {
            *weight = times(weight, &vec![(atom, -common)]).unwrap_or_default();
        }
    }
}
