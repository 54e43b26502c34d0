//! Which products of parameters may be before generators, so that their brackets cancel.

use super::quadratic::{Atom, Variable};
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

/// For each generator the weight that lets what two generators alone contribute to a bracket cancel, whatever the parameters are; but for
/// what all that are connected in this way have in common. (Whether they do cancel is decided by the equations.)
pub(super) fn weights(generators: usize, brackets: &[Vec<Term<'_>>], steady: impl Fn(&Atom) -> bool) -> Vec<Weight> {
    let mut edges: Vec<Vec<(usize, Weight)>> = vec![vec![]; generators];
    for terms in brackets.iter().flat_map(|bracket| bracket.chunk_by(|a, b| a.variables == b.variables)) {
        let mut parts: Vec<(usize, &Weight)> = terms.iter().map(|term| (term.generator, term.atoms)).collect();
        parts.sort();
        parts.dedup();
        let [(g, a), (h, b)] = parts[..] else { continue };
        if g != h
            && a.iter().chain(b).all(|(atom, _)| steady(atom))
            && let (Some(forth), Some(back)) = (over(a, b), over(b, a))
        {
            edges[g].push((h, forth));
            edges[h].push((g, back));
        }
    }
    let mut weights: Vec<Option<Weight>> = vec![None; generators];
    for first in 0..generators {
        if weights[first].is_some() {
            continue;
        }
        weights[first] = Some(vec![]);
        let mut component = vec![first];
        let mut next = 0;
        while let Some(g) = component.get(next).copied() {
            next += 1;
            for (h, ratio) in &edges[g] {
                if weights[*h].is_none() {
                    weights[*h] = weights[g].as_ref().and_then(|weight| times(weight, ratio));
                    component.push(*h);
                }
            }
        }
        clear(&mut weights, &component);
    }
    weights.into_iter().map(Option::unwrap_or_default).collect()
}

/// Divides the weights of some generators by what most of them have in common; by what all have if as many have another power.
fn clear(weights: &mut [Option<Weight>], component: &[usize]) {
    let of = |weights: &[Option<Weight>], g: usize| weights[g].clone().unwrap_or_default();
    let mut atoms: Vec<Atom> = component.iter().flat_map(|g| of(weights, *g)).map(|(atom, _)| atom).collect();
    atoms.sort();
    atoms.dedup();
    for atom in atoms {
        let exponent = |g: &usize| of(weights, *g).iter().find(|(other, _)| *other == atom).map_or(0, |(_, e)| *e);
        let exponents: Vec<i128> = component.iter().map(exponent).collect();
        let count = |e: &i128| exponents.iter().filter(|other| *other == e).count();
        let common = exponents.iter().copied().max_by_key(|e| (count(e), -e)).unwrap_or(0);
        for g in component.iter().filter(|_| common != 0) {
            weights[*g] = times(&of(weights, *g), &vec![(atom, -common)]);
        }
    }
}
