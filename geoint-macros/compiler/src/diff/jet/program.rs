//! Programs of recurrences: series, the rule of each, and what a rule reads.

use crate::ir::{Id, Number, Symbol};

/// A number of a step, by its place among the values at the start.
pub(crate) type Value = usize;

/// The coefficients of a series of this program.
pub(crate) type Source = usize;

/// What a coefficient is multiplied by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Factor {
    Number(Number),
    Value(Value),
}

/// How the coefficient of order n ≥ 1 follows. In comments y is the series itself, and a sum runs over j.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Rule {
    /// A coordinate: its rate of order n − 1, over n.
    State(Symbol),
    /// A function a + b·t: b at n = 1, zero beyond.
    Affine(Value),
    /// Σ factor·u.
    Linear(Vec<(Factor, Source)>),
    /// Σ uⱼwₙ₋ⱼ; the second factor is known last.
    Product(Source, Source),
    /// (a + b·t)·u.
    Shift { start: Value, slope: Value, of: Source },
    /// Σ u².
    Squares(Vec<Source>),
    /// y·w = u.
    Quotient(Source, Source),
    /// y·w = 1.
    Reciprocal(Source),
    /// y² = u.
    Root(Source),
    /// y'·u = α·y·u'.
    Power(Source, Factor),
    /// y' = k·d·u', with d up to the order n − 1.
    Integral { factor: Number, by: Source, of: Source },
    /// The same for u = a + b·t.
    Wave { factor: Number, slope: Value, by: Source },
    /// y'·d = k·u', with d up to the order n − 1.
    Quadrature { factor: Number, of: Source, over: Source },
    /// r²·y' = x·y₂' − y₂·x': the angle of (x, y₂).
    Angle { y: Source, x: Source, square: Source },
    /// One of two, where nothing is zero, by a condition at the start.
    Select(Value, Option<Source>, Option<Source>),
}

/// A series.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    pub(crate) rule: Rule,
    /// Its value at the start.
    pub(crate) value: Value,
    /// Whether coefficients of lower orders are read.
    pub(crate) kept: bool,
    /// Whether j·uⱼ are read.
    pub(crate) weighted: bool,
    /// Whether the coefficient of the order before is read by itself.
    pub(crate) before: bool,
}

/// The rate of a coordinate: its value at the start, and its series if it is not constant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rate {
    pub(crate) symbol: Symbol,
    pub(crate) value: Value,
    pub(crate) source: Option<Source>,
}

/// A program.
#[derive(Clone, Debug, Default)]
pub(crate) struct Jet {
    pub(crate) series: Vec<Series>,
    /// In this order coefficients of one order are computed.
    pub(crate) order: Vec<Source>,
    pub(crate) rates: Vec<Rate>,
    /// What is computed at the start: numbers, and conditions.
    pub(crate) values: Vec<Id>,
    /// Which of them are conditions.
    pub(crate) conditions: Vec<Value>,
    /// What decides a condition by its sign.
    pub(crate) switches: Vec<(Value, Option<Source>)>,
}

impl Rule {
    /// The series whose coefficients of the same order are read.
    pub(crate) fn now(&self) -> Vec<Source> {
        match self {
            Rule::State(_) | Rule::Affine(_) | Rule::Wave { .. } => vec![],
            Rule::Linear(terms) => terms.iter().map(|(_, source)| *source).collect(),
            Rule::Product(a, b) | Rule::Quotient(a, b) => vec![*a, *b],
            Rule::Shift { of, .. } | Rule::Integral { of, .. } | Rule::Quadrature { of, .. } => vec![*of],
            Rule::Squares(all) => all.clone(),
            Rule::Reciprocal(a) | Rule::Root(a) | Rule::Power(a, _) => vec![*a],
            Rule::Angle { y, x, square } => vec![*y, *x, *square],
            Rule::Select(_, a, b) => a.iter().chain(b).copied().collect(),
        }
    }

    /// The series whose coefficients of lower orders are read in sums, itself excepted.
    pub(super) fn in_sums(&self) -> Vec<Source> {
        match self {
            Rule::State(_) | Rule::Affine(_) | Rule::Linear(_) | Rule::Select(..) | Rule::Root(_) => vec![],
            Rule::Product(a, b) => vec![*a, *b],
            Rule::Quotient(_, b) => vec![*b],
            Rule::Squares(all) => all.clone(),
            Rule::Reciprocal(a) | Rule::Power(a, _) => vec![*a],
            Rule::Shift { .. } | Rule::Wave { .. } => vec![],
            Rule::Integral { by, .. } => vec![*by],
            Rule::Quadrature { over, .. } => vec![*over],
            Rule::Angle { y, x, square } => vec![*y, *x, *square],
        }
    }

    /// The series whose coefficients are read with their orders as factors.
    pub(super) fn weighted(&self) -> Vec<Source> {
        match self {
            Rule::Integral { of, .. } => vec![*of],
            Rule::Angle { y, x, .. } => vec![*y, *x],
            _ => vec![],
        }
    }

    /// What is multiplied or divided, in the order in which it is written down above.
    pub(crate) fn operands(&self) -> Vec<Source> {
        match self {
            Rule::State(_) | Rule::Affine(_) | Rule::Linear(_) | Rule::Select(..) => vec![],
            Rule::Product(a, b) | Rule::Quotient(a, b) => vec![*a, *b],
            Rule::Shift { of: a, .. } | Rule::Wave { by: a, .. } => vec![*a],
            Rule::Reciprocal(a) | Rule::Root(a) | Rule::Power(a, _) => vec![*a],
            Rule::Squares(all) => all.clone(),
            Rule::Integral { by, of, .. } => vec![*by, *of],
            Rule::Quadrature { of, over, .. } => vec![*of, *over],
            Rule::Angle { y, x, square } => vec![*y, *x, *square],
        }
    }

    /// Whether coefficients follow by the same operations, from one sum each.
    pub(super) fn is_like(&self, other: &Rule) -> bool {
        match (self, other) {
            (Rule::Squares(all), Rule::Squares(others)) => all.len() == others.len(),
            (Rule::Power(_, exponent), Rule::Power(_, other)) => exponent == other,
            (Rule::Integral { factor, .. }, Rule::Integral { factor: other, .. })
            | (Rule::Quadrature { factor, .. }, Rule::Quadrature { factor: other, .. }) => factor == other,
            (Rule::Product(..), Rule::Product(..))
            | (Rule::Quotient(..), Rule::Quotient(..))
            | (Rule::Reciprocal(_), Rule::Reciprocal(_))
            | (Rule::Root(_), Rule::Root(_)) => true,
            _ => false,
        }
    }

    /// Whether it reads its own coefficients, and whether with orders as factors.
    pub(super) fn own(&self) -> (bool, bool) {
        match self {
            Rule::Quotient(..) | Rule::Reciprocal(_) | Rule::Root(_) | Rule::Power(..) => (true, false),
            Rule::Quadrature { .. } | Rule::Angle { .. } => (false, true),
            _ => (false, false),
        }
    }

    /// Sums of n terms in the coefficient of order n, in halves.
    pub(crate) fn half_convolutions(&self) -> usize {
        match self {
            Rule::State(_)
            | Rule::Affine(_)
            | Rule::Linear(_)
            | Rule::Shift { .. }
            | Rule::Wave { .. }
            | Rule::Select(..) => 0,
            Rule::Squares(all) => all.len(),
            Rule::Root(_) => 1,
            Rule::Product(..)
            | Rule::Quotient(..)
            | Rule::Reciprocal(_)
            | Rule::Integral { .. }
            | Rule::Quadrature { .. } => 2,
            Rule::Power(..) => 4,
            Rule::Angle { .. } => 6,
        }
    }
}

impl Jet {
    /// Sums of n terms in all coefficients of order n, in halves.
    pub(crate) fn half_convolutions(&self) -> usize {
        self.series.iter().map(|series| series.rule.half_convolutions()).sum()
    }

    /// Sums of n terms in all coefficients of order n.
    pub(crate) fn convolutions(&self) -> usize {
        self.half_convolutions().div_ceil(2)
    }
}
