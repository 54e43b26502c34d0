//! Conditions: what is assumed in a case, and what follows from that.

use super::atoms::Atoms;
use super::inequalities::{Inequality, are_contradictory};
use super::normal::{Normal, Powers};
use crate::ir::{Id, Ratio, Relation};
use std::collections::BTreeSet;

/// A comparison that was not decided.
#[derive(Clone, Debug)]
pub(super) struct Comparison {
    /// As it was written.
    pub(super) id: Id,
    relation: Relation,
    /// What is compared with a number: a sum without a constant, whose first coefficient is one.
    form: Normal,
    /// Whether `number < form` is asked; else `form < number`.
    above: bool,
    number: Ratio,
}

impl Comparison {
    /// `left relation right` by the difference right − left.
    pub(super) fn new(id: Id, relation: Relation, difference: &Normal) -> Option<Comparison> {
        let (constant, rest) = difference.parted();
        let scale = rest.leading().recip()?;
        let number = constant.mul(scale)?.neg();
        Some(Comparison { id, relation, form: rest.scale(scale)?, above: scale.numerator > 0, number })
    }
}

/// What a case assumes of one sum.
#[derive(Clone, Debug)]
struct Range {
    form: Normal,
    /// Bounds, and whether each is allowed itself.
    low: Option<(Ratio, bool)>,
    high: Option<(Ratio, bool)>,
    excluded: Vec<Ratio>,
}

/// The conditions of a case.
#[derive(Clone, Debug, Default)]
pub(super) struct Assumptions {
    conditions: Vec<(Id, bool)>,
    ranges: Vec<Range>,
    /// Normal forms of conditions are in terms of these.
    pub(super) atoms: Atoms,
}

impl Assumptions {
    pub(super) fn len(&self) -> usize {
        self.conditions.len()
    }

    pub(super) fn conditions(&self) -> Vec<(Id, bool)> {
        self.conditions.clone()
    }

    /// Whether a comparison holds, if that follows.
    pub(super) fn decide(&self, comparison: &Comparison) -> Option<bool> {
        let range = self.ranges.iter().find(|range| range.form == comparison.form)?;
        let number = comparison.number;
        // Whether all values are below the number, or at most it; and above.
        let below = |or_equal: bool| {
            range.high.is_some_and(|(high, own)| high < number || high == number && (or_equal || !own))
        };
        let above =
            |or_equal: bool| range.low.is_some_and(|(low, own)| low > number || low == number && (or_equal || !own));
        let (holds, fails) = match (comparison.relation, comparison.above) {
            (Relation::Less, true) => (above(false), below(true)),
            (Relation::Less, false) => (below(false), above(true)),
            (Relation::LessEqual, true) => (above(true), below(false)),
            (Relation::LessEqual, false) => (below(true), above(false)),
            (Relation::Equal, _) => {
                (below(true) && above(true), below(false) || above(false) || range.excluded.contains(&number))
            }
        };
        (holds || fails).then_some(holds)
    }

    /// Whether no state is known to be in this case: its inequalities exclude each other.
    pub(super) fn is_void(&self) -> bool {
        let mut inequalities = vec![];
        for Range { form, low, high, .. } in &self.ranges {
            for (bound, sign) in [(low, Ratio::ONE), (high, Ratio::integer(-1))] {
                let Some((number, own)) = bound else { continue };
                let distance =
                    Normal::number(*number).scale(Ratio::integer(-1)).and_then(|least| least.add(Ratio::ONE, form));
                let Some(sum) = distance.and_then(|distance| distance.scale(sign)) else { return false };
                inequalities.push(Inequality { sum, is_strict: !own });
            }
        }
        let monomials: BTreeSet<&Powers> = self.ranges.iter().flat_map(|range| range.form.monomials()).collect();
        for powers in monomials.into_iter().filter(|powers| self.is_not_negative(powers)) {
            inequalities.push(Inequality { sum: Normal::term(powers.clone(), Ratio::ONE), is_strict: false });
        }
        are_contradictory(inequalities)
    }

    /// Whether a monomial is a product of squares, square roots and positive atoms.
    fn is_not_negative(&self, powers: &Powers) -> bool {
        powers.iter().all(|(atom, exponent)| match exponent.denominator {
            1 => exponent.numerator % 2 == 0 || self.atoms.is_positive(*atom),
            2 => true,
            _ => self.atoms.is_positive(*atom),
        })
    }

    /// The case in which a comparison of such atoms holds, or not. An open boundary is part of neither case.
    pub(super) fn with(&self, comparison: &Comparison, holds: bool, is_open: bool, atoms: &Atoms) -> Assumptions {
        let mut case = Assumptions { atoms: atoms.clone(), ..self.clone() };
        case.conditions.push((comparison.id, holds));
        let Comparison { relation, form, above, number, .. } = comparison;
        let known = case.ranges.iter().position(|range| range.form == *form).unwrap_or_else(|| {
            case.ranges.push(Range { form: form.clone(), low: None, high: None, excluded: vec![] });
            case.ranges.len() - 1
        });
        let range = &mut case.ranges[known];
        match relation {
            Relation::Equal if holds => (range.low, range.high) = (Some((*number, true)), Some((*number, true))),
            Relation::Equal => range.excluded.push(*number),
            // What is not above is below; the comparison was undecided, so that this bound is the tighter one.
            _ => {
                let own = !is_open && (*relation == Relation::LessEqual) == holds;
                let bound = if *above == holds { &mut range.low } else { &mut range.high };
                *bound = Some((*number, own));
            }
        }
        case
    }
}
