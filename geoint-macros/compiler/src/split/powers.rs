//! Polynomials as sums of powers of linear forms, whose flows are shears.
//!
//! x₁⋯xₙ = Σ ε₂⋯εₙ (x₁ + ε₂x₂ + … + εₙxₙ)ⁿ/(2ⁿ⁻¹ n!) over all signs. S. Blanes, Phys. Rev. E 65 (2002) 056703.

use super::families::piece;
use super::flow::Space;
use super::linear_motion::{is_quadratic, is_whole};
use super::polynomial::Polynomial;
use crate::analyze;
use crate::ir::{Graph, Id, Number, Ratio, Symbol};
use std::collections::{BTreeMap, BTreeSet};

/// Of polynomials up to this degree.
const MAX_DEGREE: i128 = 4;

/// More shears than these are no gain.
const MAX_FORMS: usize = 7;

/// Coefficients of each coordinate in a form, the first one positive.
type Form = BTreeMap<Symbol, i128>;

/// The same terms, products of positions and momenta as powers of forms, with what reads one form as one atom. A sum whose flow is known
/// stays.
///
/// A form adds positions to momenta, so that both have to be of one scale: none is made unless all of them have squares, with the same number
/// for their coefficient.
pub(super) fn powers_of_forms(graph: &mut Graph, atoms: &[Id], space: Space) -> Option<Vec<Id>> {
    // The coefficient of each power of a form.
    let mut forms: BTreeMap<Form, BTreeMap<i128, Id>> = BTreeMap::new();
    // Of positions, and of momenta.
    let mut alone = [graph.zero(), graph.zero()];
    let mut known = vec![];
    for atom in atoms {
        let reads = graph.reads(*atom);
        if reads.kinds() == 1 {
            let side = &mut alone[usize::from(reads.p)];
            *side = graph.add(*side, *atom);
            continue;
        }
        let powers = Polynomial::of(graph, *atom, &Symbol::is_coordinate);
        let product = powers.as_ref().is_some_and(|powers| powers.single().is_some());
        if !product && piece(graph, *atom, space).is_some() {
            known.push(*atom);
            continue;
        }
        let powers = powers?;
        for (monomial, coefficient) in powers.into_terms() {
            if !is_whole(&monomial) {
                return None;
            }
            let factors: Vec<Symbol> = monomial
                .iter()
                .flat_map(|(symbol, power)| std::iter::repeat_n(*symbol, power.numerator.max(0) as usize))
                .collect();
            let degree = factors.len() as i128;
            if degree > MAX_DEGREE {
                return None;
            }
            let share = Ratio { numerator: 1, denominator: (1..=degree).product::<i128>() << (degree - 1) };
            for signs in 0..1_u32 << (degree - 1) {
                let (mut form, mut sign) = (Form::new(), 1);
                for (i, symbol) in factors.iter().enumerate() {
                    let epsilon = if i > 0 && signs >> (i - 1) & 1 == 1 { -1 } else { 1 };
                    sign *= epsilon;
                    *form.entry(*symbol).or_default() += epsilon;
                }
                form.retain(|_, c| *c != 0);
                let Some(scale) = normalised(&mut form) else { continue };
                let size = scale.pow(u32::try_from(degree).ok()?) * sign;
                let part = graph.scale(Number::Exact(share.mul(Ratio::integer(size))?), coefficient);
                let sum = forms.entry(form).or_default().entry(degree).or_insert_with(|| graph.zero());
                *sum = graph.add(*sum, part);
            }
        }
    }
    if forms.is_empty() || forms.len() > MAX_FORMS || !is_of_one_scale(graph, alone, &forms) {
        return None;
    }
    let mut mixed = known;
    for (form, powers) in forms {
        let mut sum = graph.zero();
        for (symbol, c) in &form {
            let symbol = graph.symbol(*symbol);
            let term = graph.scale(Number::integer(*c), symbol);
            sum = graph.add(sum, term);
        }
        let mut energy = graph.zero();
        for (degree, coefficient) in powers {
            let power = graph.pow(sum, Ratio::integer(degree));
            let term = graph.mul(coefficient, power);
            energy = graph.add(energy, term);
        }
        let reads = graph.reads(energy);
        match reads.kinds() {
            0 => {}
            1 => {
                let side = &mut alone[usize::from(reads.p)];
                *side = graph.add(*side, energy);
            }
            _ => mixed.push(energy),
        }
    }
    let alone = alone.into_iter().filter(|side| !graph.is_zero(*side));
    Some(alone.collect::<Vec<_>>().into_iter().chain(mixed).collect())
}

/// Divides a form by its first coefficient's sign and by what all coefficients have in common; that number, if there is a form.
fn normalised(form: &mut Form) -> Option<i128> {
    let gcd = form.values().copied().reduce(|a, b| {
        let (mut a, mut b) = (a.abs(), b.abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a
    })?;
    let scale = gcd.abs() * form.values().next()?.signum();
    form.values_mut().for_each(|c| *c /= scale);
    Some(scale)
}

/// Whether each coordinate of a form has a square, and all squares one number for their coefficient: then orbits are as wide in positions as
/// in momenta.
fn is_of_one_scale(graph: &mut Graph, alone: [Id; 2], forms: &BTreeMap<Form, BTreeMap<i128, Id>>) -> bool {
    let mut of_one_scale = BTreeSet::new();
    let mut common = None;
    for side in alone {
        for term in analyze::terms(graph, side) {
            if !is_quadratic(graph, term) {
                continue;
            }
            let Some(powers) = Polynomial::of(graph, term, &Symbol::is_coordinate) else { return false };
            for (monomial, coefficient) in powers.into_terms() {
                let number = graph.as_number(coefficient);
                if number.is_none() || monomial.len() > 1 || *common.get_or_insert(number) != number {
                    return false;
                }
                of_one_scale.extend(monomial.into_keys());
            }
        }
    }
    forms.keys().flat_map(Form::keys).all(|symbol| of_one_scale.contains(symbol))
}
