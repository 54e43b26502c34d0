//! Polynomials as sums of powers of linear forms. The flow of each power is a shear.
//!
//! x₁⋯xₙ = Σ ε₂⋯εₙ (x₁ + ε₂x₂ + … + εₙxₙ)ⁿ/(2ⁿ⁻¹ n!) over all signs. S. Blanes, Phys. Rev. E 65 (2002) 056703.

use super::families::piece;
use super::flow::Space;
use super::linear_motion::is_of_degree;
use super::polynomial::{Monomial, Polynomial, is_whole};
use crate::analyze;
use crate::ir::formula::pow;
use crate::ir::{Graph, Id, Number, Ratio, Symbol};
use std::collections::{BTreeMap, BTreeSet};

/// The largest degree of a polynomial that is split.
const MAX_DEGREE: i128 = 4;

/// The largest number of forms. More shears cost more than they gain.
const MAX_FORMS: usize = 7;

/// Integer coefficients of the coordinates in a linear form. The first coefficient is positive, and their greatest common divisor is 1.
type Form = BTreeMap<Symbol, i128>;

/// For each form, the coefficients of its powers.
type Powers = BTreeMap<Form, BTreeMap<i128, Id>>;

/// Rewrites products of positions and momenta as powers of forms. All powers of one form become one atom. A sum with a known flow stays one
/// atom.
///
/// A form adds positions to momenta, so both need one scale. Thus every coordinate in a form must have a square in the energy, and all squares
/// must have the same number as their coefficient.
pub(super) fn powers_of_forms(graph: &mut Graph, atoms: &[Id], space: Space) -> Option<Vec<Id>> {
    let mut forms = Powers::new();
    // Terms that read only positions, and terms that read only momenta.
    let mut alone = [graph.zero(), graph.zero()];
    let mut mixed = vec![];
    for atom in atoms {
        if graph.reads(*atom).kinds() == 1 {
            add_alone(graph, &mut alone, *atom);
            continue;
        }
        let powers = Polynomial::of(graph, *atom, &Symbol::is_coordinate);
        let is_product = powers.as_ref().is_some_and(|powers| powers.single().is_some());
        if !is_product && piece(graph, *atom, space).is_some() {
            mixed.push(*atom);
            continue;
        }
        for (monomial, coefficient) in powers?.into_terms() {
            add_forms(graph, &mut forms, &monomial, coefficient)?;
        }
    }
    if forms.is_empty() || forms.len() > MAX_FORMS || !is_of_one_scale(graph, alone, &forms) {
        return None;
    }
    for (form, powers) in forms {
        let mut sum = graph.zero();
        for (symbol, c) in &form {
            let symbol = graph.symbol(*symbol);
            sum = graph.build(sum + *c * symbol);
        }
        let mut energy = graph.zero();
        for (degree, coefficient) in powers {
            energy = graph.build(energy + coefficient * pow(sum, Ratio::integer(degree)));
        }
        match graph.reads(energy).kinds() {
            0 => {}
            1 => add_alone(graph, &mut alone, energy),
            _ => mixed.push(energy),
        }
    }
    Some(alone.into_iter().filter(|side| !graph.is_zero(*side)).chain(mixed).collect())
}

/// Adds an energy to the sum for positions or to the sum for momenta.
fn add_alone(graph: &mut Graph, [positions, momenta]: &mut [Id; 2], energy: Id) {
    let side = if graph.reads(energy).p { momenta } else { positions };
    *side = graph.add(*side, energy);
}

/// Adds coefficient·monomial to the powers of forms. Returns `None` if the monomial is not a product of one to `MAX_DEGREE` coordinates.
fn add_forms(graph: &mut Graph, forms: &mut Powers, monomial: &Monomial, coefficient: Id) -> Option<()> {
    if !is_whole(monomial) {
        return None;
    }
    let repeated = |(symbol, power): (&Symbol, &Ratio)| std::iter::repeat_n(*symbol, power.numerator.max(0) as usize);
    let factors: Vec<Symbol> = monomial.iter().flat_map(repeated).collect();
    let degree = factors.len() as i128;
    if !(1..=MAX_DEGREE).contains(&degree) {
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
        let Some(scale) = normalise(&mut form) else { continue };
        let size = scale.pow(u32::try_from(degree).ok()?) * sign;
        let part = graph.scale(Number::Exact(share.mul(Ratio::integer(size))?), coefficient);
        let sum = forms.entry(form).or_default().entry(degree).or_insert_with(|| graph.zero());
        *sum = graph.add(*sum, part);
    }
    Some(())
}

/// Divides a form by the greatest common divisor of its coefficients and by the sign of its first coefficient. Returns the divisor, or `None`
/// for an empty form.
fn normalise(form: &mut Form) -> Option<i128> {
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

/// Returns whether each coordinate of a form has a square and all squares have the same number as their coefficient. Orbits then have
/// the same width in positions and momenta.
fn is_of_one_scale(graph: &mut Graph, alone: [Id; 2], forms: &Powers) -> bool {
    let mut of_one_scale = BTreeSet::new();
    let mut common = None;
    for side in alone {
        for term in analyze::terms(graph, side) {
            if !is_of_degree(graph, term, 2) {
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
