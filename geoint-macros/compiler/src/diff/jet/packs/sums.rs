//! The sums Σ uⱼwₙ₋ⱼ over coefficients of lower orders that a recurrence reads.

use crate::diff::jet::{Factor, Rule, Source};

/// The coefficients uⱼ of a series, or j·uⱼ if `weighted`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Operand {
    pub(crate) source: Source,
    pub(crate) weighted: bool,
}

impl Operand {
    pub(super) fn plain(source: Source) -> Operand {
        Operand { source, weighted: false }
    }

    fn weighted(source: Source) -> Operand {
        Operand { source, weighted: true }
    }
}

/// The factor beside uⱼwₙ₋ⱼ in a sum over 0 < j < n.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Weight {
    One,
    /// 1 with u = w, so that the terms j and n − j are equal. The squares of several operands are added.
    Square,
    /// j(α + 1) − n.
    Power(Factor),
}

/// A sum over 0 < j < n.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Sum {
    /// The two factors, or all squared series.
    pub(crate) operands: Vec<Operand>,
    pub(crate) weight: Weight,
}

impl Sum {
    fn new(u: Operand, w: Operand) -> Sum {
        if u == w { Sum::of_squares(vec![u]) } else { Sum { operands: vec![u, w], weight: Weight::One } }
    }

    fn of_squares(operands: Vec<Operand>) -> Sum {
        Sum { operands, weight: Weight::Square }
    }

    /// The factor beside an operand.
    pub(super) fn other(&self, operand: Operand) -> Operand {
        self.operands[usize::from(self.operands[0] == operand)]
    }

    /// Factor number `k`. A square has its operand as both factors.
    pub(super) fn factor(&self, k: usize) -> Operand {
        self.operands[k.min(self.operands.len() - 1)]
    }

    /// Sums of weight 1 from which this sum follows: the single squares, or Σ j·uⱼyₙ₋ⱼ and Σ uⱼyₙ₋ⱼ for the weight j(α + 1) − n.
    pub(crate) fn parts(&self) -> Vec<Sum> {
        match (self.weight, &self.operands[..]) {
            (Weight::Square, all) => all.iter().map(|operand| Sum::of_squares(vec![*operand])).collect(),
            (Weight::Power(_), [u, y]) => vec![Sum::new(Operand::weighted(u.source), *y), Sum::new(*u, *y)],
            _ => vec![self.clone()],
        }
    }

    /// The cost in halves of a sum of n terms.
    pub(in super::super) fn half_convolutions(&self) -> usize {
        match self.weight {
            Weight::Square => self.operands.len(),
            Weight::One => 2,
            Weight::Power(_) => 4,
        }
    }

    /// Returns whether both sums are computed by the same operations.
    pub(super) fn is_like(&self, other: &Sum) -> bool {
        self.weight == other.weight && self.operands.len() == other.operands.len()
    }
}

/// The sums in the recurrence of the series `own`.
pub(crate) fn sums(rule: &Rule, own: Source) -> Vec<Sum> {
    let [plain, weighted] = [Operand::plain, Operand::weighted];
    match *rule {
        Rule::State(_) | Rule::Affine(_) | Rule::Linear(_) | Rule::Select(..) => vec![],
        Rule::Shift { .. } | Rule::Wave { .. } => vec![],
        Rule::Product(a, b) => vec![Sum::new(plain(a), plain(b))],
        Rule::Squares(ref all) => vec![Sum::of_squares(all.iter().copied().map(plain).collect())],
        Rule::Quotient(_, w) | Rule::Reciprocal(w) => vec![Sum::new(plain(w), plain(own))],
        Rule::Root(_) => vec![Sum::new(plain(own), plain(own))],
        Rule::Power(u, exponent) => {
            vec![Sum { operands: vec![plain(u), plain(own)], weight: Weight::Power(exponent) }]
        }
        Rule::Integral { by, of, .. } => vec![Sum::new(weighted(of), plain(by))],
        Rule::Quadrature { over, .. } => vec![Sum::new(weighted(own), plain(over))],
        Rule::Angle { y, x, square } => vec![
            Sum::new(weighted(y), plain(x)),
            Sum::new(weighted(x), plain(y)),
            Sum::new(weighted(own), plain(square)),
        ],
    }
}
