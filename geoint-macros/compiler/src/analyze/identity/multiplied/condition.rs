//! The assumptions of a case, and the comparisons that follow from them.

use super::atoms::Atoms;
use super::inequalities::{Inequality, are_contradictory};
use super::normal::{Monomial, Normal};
use crate::ir::{Id, Ratio, Relation};
use std::collections::BTreeSet;

/// A comparison of a sum with a number.
#[derive(Clone, Debug)]
pub(super) struct Comparison {
    /// The node of the comparison.
    pub(super) id: Id,
    relation: Relation,
    /// A sum without a constant. Its first coefficient is 1.
    form: Normal,
    number: Ratio,
    /// The comparison reads `number relation form`, otherwise `form relation number`.
    number_is_left: bool,
}

impl Comparison {
    /// Normalises `left relation right`, given right − left. `None` if a number becomes too long.
    pub(super) fn new(id: Id, relation: Relation, difference: &Normal) -> Option<Comparison> {
        let constant = difference.coefficient(&vec![]);
        let rest = Normal::number(constant.neg()).add(Ratio::ONE, difference)?;
        let scale = rest.leading().recip()?;
        let (form, number) = (rest.scale(scale)?, constant.mul(scale)?.neg());
        Some(Comparison { id, relation, form, number, number_is_left: scale > Ratio::ZERO })
    }
}

/// A bound of a range.
#[derive(Clone, Copy, Debug)]
struct Limit {
    value: Ratio,
    is_included: bool,
}

/// The values that a case allows for a sum.
#[derive(Clone, Debug)]
struct Range {
    form: Normal,
    low: Option<Limit>,
    high: Option<Limit>,
    excluded: Vec<Ratio>,
}

/// The assumptions of a case.
#[derive(Clone, Debug, Default)]
pub(super) struct Assumptions {
    /// The decided conditions, and whether each holds.
    pub(super) conditions: Vec<(Id, bool)>,
    ranges: Vec<Range>,
    /// The atoms of the sums in `ranges`.
    pub(super) atoms: Atoms,
}

impl Assumptions {
    /// Returns whether a comparison holds; `None` if the assumptions do not decide it.
    pub(super) fn decide(&self, comparison: &Comparison) -> Option<bool> {
        let range = self.ranges.iter().find(|range| range.form == comparison.form)?;
        let number = comparison.number;
        let at_most = range.high.is_some_and(|high| high.value <= number);
        let below = at_most && range.high.is_some_and(|high| high.value != number || !high.is_included);
        let at_least = range.low.is_some_and(|low| low.value >= number);
        let above = at_least && range.low.is_some_and(|low| low.value != number || !low.is_included);
        let (holds, fails) = match (comparison.relation, comparison.number_is_left) {
            (Relation::Less, true) => (above, at_most),
            (Relation::Less, false) => (below, at_least),
            (Relation::LessEqual, true) => (at_least, below),
            (Relation::LessEqual, false) => (at_most, above),
            (Relation::Equal, _) => (at_most && at_least, below || above || range.excluded.contains(&number)),
        };
        (holds || fails).then_some(holds)
    }

    /// Returns whether the case is proven to contain no state.
    pub(super) fn is_void(&self) -> bool {
        let mut inequalities = vec![];
        for Range { form, low, high, .. } in &self.ranges {
            for (limit, sign) in [(low, Ratio::ONE), (high, Ratio::integer(-1))] {
                let Some(Limit { value, is_included }) = limit else { continue };
                let distance = Normal::number(value.neg()).add(Ratio::ONE, form);
                let Some(sum) = distance.and_then(|distance| distance.scale(sign)) else { return false };
                inequalities.push(Inequality { sum, is_strict: !is_included });
            }
        }
        let monomials: BTreeSet<&Monomial> = self.ranges.iter().flat_map(|range| range.form.monomials()).collect();
        for monomial in monomials.into_iter().filter(|monomial| self.is_not_negative(monomial)) {
            inequalities.push(Inequality { sum: Normal::term(monomial.clone(), Ratio::ONE), is_strict: false });
        }
        are_contradictory(inequalities)
    }

    /// Returns whether a monomial is a product of squares, square roots and positive atoms.
    fn is_not_negative(&self, monomial: &Monomial) -> bool {
        monomial.iter().all(|(atom, exponent)| match exponent.denominator {
            1 => exponent.numerator % 2 == 0 || self.atoms.is_positive(*atom),
            2 => true,
            _ => self.atoms.is_positive(*atom),
        })
    }

    /// The case in which an undecided comparison holds, or fails. An open boundary is part of neither case.
    pub(super) fn with(&self, comparison: &Comparison, holds: bool, is_open: bool, atoms: &Atoms) -> Assumptions {
        let mut case = Assumptions { atoms: atoms.clone(), ..self.clone() };
        case.conditions.push((comparison.id, holds));
        let Comparison { relation, form, number, number_is_left, .. } = comparison;
        let known = case.ranges.iter().position(|range| range.form == *form).unwrap_or_else(|| {
            case.ranges.push(Range { form: form.clone(), low: None, high: None, excluded: vec![] });
            case.ranges.len() - 1
        });
        let range = &mut case.ranges[known];
        let limit = |is_included| Some(Limit { value: *number, is_included });
        match relation {
            Relation::Equal if holds => (range.low, range.high) = (limit(true), limit(true)),
            Relation::Equal => range.excluded.push(*number),
            // The comparison was undecided, so the new bound is tighter than a known one.
            _ => {
                let bound = if *number_is_left == holds { &mut range.low } else { &mut range.high };
                *bound = limit(!is_open && (*relation == Relation::LessEqual) == holds);
            }
        }
        case
    }
}
