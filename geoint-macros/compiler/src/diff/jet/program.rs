//! Programs of recurrences: series, their rules, and the operands of rules.

use super::packs::sums;
use crate::ir::{Id, Number, Symbol};

/// A number that is constant during a step, as an index into [`Jet::values`].
pub(crate) type Value = usize;

/// A series, as an index into [`Jet::series`].
pub(crate) type Source = usize;

/// A constant factor of a coefficient.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Factor {
    Number(Number),
    Value(Value),
}

/// The recurrence for the coefficient of order n ≥ 1. In the comments, y is the series itself, and sums run over j.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Rule {
    /// A coordinate: the coefficient of order n − 1 of its rate, divided by n.
    State(Symbol),
    /// A function a + b·t: b for n = 1, zero for n > 1.
    Affine(Value),
    /// Σ factor·u.
    Linear(Vec<(Factor, Source)>),
    /// Σ uⱼwₙ₋ⱼ. The second factor is computed last.
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
    /// y' = k·d·b, the integral for u = a + b·t.
    Wave { factor: Number, slope: Value, by: Source },
    /// y'·d = k·u', with d up to the order n − 1.
    Quadrature { factor: Number, of: Source, over: Source },
    /// r²·y' = x·y₂' − y₂·x': the angle of (x, y₂).
    Angle { y: Source, x: Source, square: Source },
    /// One of two series by a condition at the start. `None` is zero.
    Select(Value, Option<Source>, Option<Source>),
}

/// A series.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    pub(crate) rule: Rule,
    /// The value at the start.
    pub(crate) value: Value,
    /// Rules read coefficients uⱼ of lower orders.
    pub(crate) kept: bool,
    /// Rules read j·uⱼ.
    pub(crate) weighted: bool,
    /// Rules read the coefficient of the previous order outside of sums.
    pub(crate) before: bool,
}

/// The rate of a coordinate: its value at the start, and its series if it is not constant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rate {
    pub(crate) symbol: Symbol,
    pub(crate) value: Value,
    pub(crate) source: Option<Source>,
}

/// A program for the coefficients of all orders.
#[derive(Clone, Debug, Default)]
pub(crate) struct Jet {
    pub(crate) series: Vec<Series>,
    /// The order in which the series are evaluated.
    pub(crate) order: Vec<Source>,
    pub(crate) rates: Vec<Rate>,
    /// Nodes that are computed at the start of a step: numbers and conditions.
    pub(crate) values: Vec<Id>,
    /// The values that are conditions.
    pub(crate) conditions: Vec<Value>,
    /// Numbers whose signs decide conditions, each with its series if it is not constant.
    pub(crate) switches: Vec<(Value, Option<Source>)>,
}

impl Rule {
    /// The series whose coefficients of order n the coefficient of order n reads.
    pub(crate) fn now(&self) -> Vec<Source> {
        match self {
            Rule::Linear(terms) => terms.iter().map(|(_, source)| *source).collect(),
            Rule::Integral { of, .. } | Rule::Quadrature { of, .. } => vec![*of],
            Rule::Wave { .. } => vec![],
            Rule::Select(_, a, b) => a.iter().chain(b).copied().collect(),
            _ => self.operands(),
        }
    }

    /// The series that are multiplied or divided, in the order of the fields above.
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

    /// Returns whether the coefficients follow from one sum each, by the same operations.
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
}

impl Jet {
    /// The cost of all coefficients of order n, in halves of a sum of n terms.
    pub(crate) fn half_convolutions(&self) -> usize {
        let all = self.series.iter().enumerate().flat_map(|(own, series)| sums(&series.rule, own));
        all.map(|sum| sum.half_convolutions()).sum()
    }

    /// The cost of all coefficients of order n, in sums of n terms.
    pub(crate) fn convolutions(&self) -> usize {
        self.half_convolutions().div_ceil(2)
    }
}
