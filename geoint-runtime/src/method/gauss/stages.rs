//! The equations of all stages of a Gauss step, assembled once for every kind of system whose unknowns are not values of a vector field.
//!
//! A form is a kind of system: a row of the table. A stage has the unknown xᵢ and the shift Qᵢ = h Σ aᵢⱼ xⱼ. A form gives a value P and a rate F there, with their
//! derivatives, and the equation of stage i is
//!
//! wᵢ Pᵢ − P₀ − h Σ aᵢⱼ wⱼ Fⱼ = 0.
//!
//! | form | xᵢ | Pᵢ − P₀ | Fᵢ |
//! |---|---|---|---|
//! | canonical coordinates y(x) | xᵢ − x₀ | y(xᵢ) − y₀ | dy/dt at xᵢ |
//! | contact Hamiltonian | increments of q, p, s | the same | ∂H/∂p, −∂H/∂q, s' |
//! | Lagrangian | vᵢ, and with an action the increment of s | ∂L/∂v − p₀, increment of s | ∂L/∂q, L |
//!
//! Weights w are 1, but for momenta of contact systems: there w is the factor r of the step, dr/dt = r σ with the decay rate σ = ∂H/∂s. It may depend on the
//! unknowns of all stages.

use super::factors::Factors;
use crate::scalar::{Real, zero};
use crate::space::vector::{dot, extrapolated, scaled};
use crate::space::{Array, Square};
use core::ops::Range;

/// Derivatives by the unknown of a stage, and by its shift.
#[derive(Clone, Copy, Debug)]
pub(in crate::method) struct Slopes<M> {
    pub(in crate::method) by_unknown: M,
    pub(in crate::method) by_shift: M,
}

impl<M: Copy> Slopes<M> {
    const fn of(slope: M) -> Self {
        Slopes { by_unknown: slope, by_shift: slope }
    }
}

/// P − P₀ and F at a stage, with their derivatives.
#[derive(Clone, Copy, Debug)]
pub(in crate::method) struct Values<A: Array> {
    pub(in crate::method) value: A,
    pub(in crate::method) rate: A,
    pub(in crate::method) value_slopes: Slopes<Square<A>>,
    pub(in crate::method) rate_slopes: Slopes<Square<A>>,
    /// Factors of the rows, for forms with [`Rows::Scaled`]: with them a row has the unit of the unknown.
    pub(in crate::method) scales: A,
    /// P itself. It is read in rows with a weight, as are the next two.
    pub(in crate::method) whole: A,
    /// σ.
    pub(in crate::method) decay: A::Real,
    pub(in crate::method) decay_slopes: Slopes<A>,
}

impl<A: Array> Values<A> {
    pub(in crate::method) fn none() -> Self {
        let (none, square) = (A::zero(), A::fill(A::zero()));
        Values {
            value: none,
            rate: none,
            value_slopes: Slopes::of(square),
            rate_slopes: Slopes::of(square),
            scales: none,
            whole: none,
            decay: zero(),
            decay_slopes: Slopes::of(none),
        }
    }
}

/// A derivative of a form: zero in every stage, the identity, or given. Only the derivative of the value by the unknown may be `One`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::method) enum Part {
    Zero,
    One,
    Given,
}

impl Part {
    /// Returns a part that is given if a property holds.
    pub(in crate::method) const fn given_if(holds: bool) -> Self {
        if holds { Part::Given } else { Part::Zero }
    }
}

/// Rows as they are, or multiplied by [`Values::scales`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::method) enum Rows {
    Plain,
    Scaled,
}

/// The derivatives of a form that are not zero, and its rows.
#[derive(Clone, Copy, Debug)]
pub(in crate::method) struct Form {
    pub(in crate::method) value: Slopes<Part>,
    pub(in crate::method) rate: Slopes<Part>,
    pub(in crate::method) rows: Rows,
}

/// The weights of rows that are multiplied by the factors of a contact step.
#[derive(Clone)]
pub(in crate::method) struct Weights<'a, R, const S: usize> {
    pub(in crate::method) factors: &'a Factors<R, S>,
    /// The rows of momenta.
    pub(in crate::method) rows: Range<usize>,
    /// The derivatives of σ, if the factors depend on the unknowns.
    pub(in crate::method) decay: Slopes<Part>,
}

/// Returns the residuals of all stages, and writes their derivatives by all unknowns to `matrix`. `coupling` is h·A.
#[inline(always)]
pub(in crate::method) fn assemble<A: Array, const S: usize>(
    form: Form,
    coupling: &[[A::Real; S]; S],
    stages: &[Values<A>; S],
    weights: Option<Weights<'_, A::Real, S>>,
    matrix: &mut Square<[A; S]>,
) -> [A; S] {
    let (one, rows) = (A::Real::from_f64(1.0), <[A; S]>::entries::<[A; S]>(matrix));
    let entry = |slope: &Square<A>, row: usize| A::entries_of::<A>(slope)[row];
    let mut residuals = [A::zero(); S];
    for (i, residual) in residuals.iter_mut().enumerate() {
        *residual = stages[i].value;
        for row in 0..A::LEN {
            let weighted = weights.as_ref().filter(|weights| weights.rows.contains(&row));
            let weight = |j: usize| weighted.map_or(one, |weights| weights.factors.r[j]);
            let value = &mut residual.as_mut_slice()[row];
            if weighted.is_some() {
                *value = (weight(i) - one).multiply_add(stages[i].whole.as_slice()[row], *value);
            }
            for j in 0..S {
                *value = (-(coupling[i][j] * weight(j))).multiply_add(stages[j].rate.as_slice()[row], *value);
            }
            let by_decay = weighted.map(|weights| slopes_by_decay(weights, coupling, stages, (i, row)));
            for k in 0..S {
                let mut slope = A::zero();
                match form.value.by_unknown {
                    Part::Given if i == k => slope = scaled(weight(i), &entry(&stages[i].value_slopes.by_unknown, row)),
                    Part::One if i == k => slope.as_mut_slice()[row] = weight(i),
                    _ => {}
                }
                if form.value.by_shift == Part::Given {
                    slope.add_scaled(coupling[i][k] * weight(i), &entry(&stages[i].value_slopes.by_shift, row));
                }
                if form.rate.by_unknown == Part::Given {
                    slope.add_scaled(-(coupling[i][k] * weight(k)), &entry(&stages[k].rate_slopes.by_unknown, row));
                }
                for j in 0..if form.rate.by_shift == Part::Given { S } else { 0 } {
                    let through = coupling[i][j] * weight(j) * coupling[j][k];
                    slope.add_scaled(-through, &entry(&stages[j].rate_slopes.by_shift, row));
                }
                if let (Some(Weights { decay, .. }), Some(by_decay)) = (weighted, by_decay) {
                    if decay.by_unknown == Part::Given {
                        slope.add_scaled(by_decay[k], &stages[k].decay_slopes.by_unknown);
                    }
                    for m in 0..if decay.by_shift == Part::Given { S } else { 0 } {
                        slope.add_scaled(by_decay[m] * coupling[m][k], &stages[m].decay_slopes.by_shift);
                    }
                }
                rows[i * A::LEN + row][k] = slope;
            }
            if form.rows == Rows::Scaled {
                let scale = stages[i].scales.as_slice()[row];
                *value *= scale;
                for slope in &mut rows[i * A::LEN + row] {
                    *slope = scaled(scale, slope);
                }
            }
        }
    }
    residuals
}

/// Returns the derivatives of a row of stage i by σ of each stage, through the factors: P ∂rᵢ/∂σₘ − h Σ aᵢⱼ Fⱼ ∂rⱼ/∂σₘ.
#[inline(always)]
fn slopes_by_decay<A: Array, const S: usize>(
    Weights { factors, .. }: &Weights<'_, A::Real, S>,
    coupling: &[[A::Real; S]; S],
    stages: &[Values<A>; S],
    (i, row): (usize, usize),
) -> [A::Real; S] {
    core::array::from_fn(|m| {
        let mut by_decay = stages[i].whole.as_slice()[row] * factors.by_decay[i][m];
        for j in 0..S {
            let rate = stages[j].rate.as_slice()[row];
            by_decay = (-(coupling[i][j] * factors.by_decay[j][m])).multiply_add(rate, by_decay);
        }
        by_decay
    })
}

impl<A: Array> Values<A> {
    /// Returns the rate after corrections of the unknown and of the shift, to first order. The squares of the last corrections are rounding.
    #[inline(always)]
    pub(in crate::method) fn rate_after(&self, form: Form, unknown: &A, shift: &A) -> A {
        let mut rate = self.rate;
        if form.rate.by_unknown == Part::Given {
            rate = extrapolated(&rate, &self.rate_slopes.by_unknown, unknown);
        }
        if form.rate.by_shift == Part::Given {
            rate = extrapolated(&rate, &self.rate_slopes.by_shift, shift);
        }
        rate
    }

    /// Returns σ after corrections of the unknown and of the shift, to first order.
    #[inline(always)]
    pub(in crate::method) fn decay_after(&self, slopes: Slopes<Part>, unknown: &A, shift: &A) -> A::Real {
        let mut decay = self.decay;
        if slopes.by_unknown == Part::Given {
            decay += dot(&self.decay_slopes.by_unknown, unknown);
        }
        if slopes.by_shift == Part::Given {
            decay += dot(&self.decay_slopes.by_shift, shift);
        }
        decay
    }
}

/// Returns the shifts h Σ aᵢⱼ xⱼ of all stages.
#[inline(always)]
pub(in crate::method) fn shifts<A: Array, const S: usize>(coupling: &[[A::Real; S]; S], x: &[A; S]) -> [A; S] {
    coupling.map(|weights| {
        let mut shift = A::zero();
        for (weight, x) in weights.iter().zip(x) {
            shift.add_scaled(*weight, x);
        }
        shift
    })
}
