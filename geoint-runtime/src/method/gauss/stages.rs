//! The equations of all stages of a Gauss step, for systems whose unknowns are not the values of a vector field at the stages.
//!
//! One function, [`assemble`], serves all three forms of equations in the table. Stage i has the unknown uᵢ and the shift h Σ aᵢⱼ uⱼ, with the coefficients
//! aᵢⱼ of the method. A form computes at each stage a value P and its rate F, with derivatives by the unknown and by the shift. P₀ is P at the start of the
//! step. The equation of stage i is
//!
//! wᵢ Pᵢ − P₀ − h Σ aᵢⱼ wⱼ Fⱼ = 0.
//!
//! | form | uᵢ | Pᵢ − P₀ | Fᵢ |
//! |---|---|---|---|
//! | canonical coordinates y(x) | xᵢ − x₀ | y(xᵢ) − y(x₀) | dy/dt at xᵢ |
//! | contact Hamiltonian | increments of q, p, s | increments of q, p, s | ∂H/∂p, −∂H/∂q, s' |
//! | Lagrangian | vᵢ, and with an action the increment of s | ∂L/∂v − p₀, increment of s | ∂L/∂q, L |
//!
//! Only Lagrangians read the shift, in qᵢ = q₀ + h Σ aᵢⱼ vⱼ. The weights wᵢ are 1, except for momenta of systems with an action. For these, wᵢ is the factor
//! rᵢ of [`factors`](super::factors): r' = r σ with the decay rate σ = ∂H/∂s = −∂L/∂s. Each factor may depend on the unknowns of all stages.

use super::factors::Factors;
use crate::scalar::{Real, zero};
use crate::space::vector::{dot, extrapolated, scaled};
use crate::space::{Array, Square};
use core::ops::Range;

/// Two entries for a quantity: one for its derivative by the unknown of its stage, and one for its derivative by the shift of its stage.
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

/// The quantities of a form at one stage. A form fills only the fields that its [`Form`] and [`Weights`] name.
#[derive(Clone, Copy, Debug)]
pub(in crate::method) struct Values<A: Array> {
    /// P − P₀.
    pub(in crate::method) value: A,
    /// F.
    pub(in crate::method) rate: A,
    /// The derivatives of P.
    pub(in crate::method) value_slopes: Slopes<Square<A>>,
    /// The derivatives of F.
    pub(in crate::method) rate_slopes: Slopes<Square<A>>,
    /// Factors that give each row the unit of its unknown, for forms with [`Rows::Scaled`].
    pub(in crate::method) scales: A,
    /// P, for rows with a weight.
    pub(in crate::method) whole: A,
    /// σ, for rows with a weight.
    pub(in crate::method) decay: A::Real,
    /// The derivatives of σ, for rows with a weight.
    pub(in crate::method) decay_slopes: Slopes<A>,
}

impl<A: Array> Values<A> {
    /// Returns zeros. A form overwrites those that it has.
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

/// The kind of a derivative: zero at every stage, the identity, or given by [`Values`]. Inlining removes products with `Zero`. Precondition: only the
/// derivative of P by the unknown is `One`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::method) enum Part {
    Zero,
    One,
    Given,
}

impl Part {
    /// Returns `Given` if a property holds, else `Zero`.
    pub(in crate::method) const fn given_if(holds: bool) -> Self {
        if holds { Part::Given } else { Part::Zero }
    }
}

/// The rows of the equations: as they are, or multiplied by [`Values::scales`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::method) enum Rows {
    Plain,
    Scaled,
}

/// The structure of a form, known at compile time.
#[derive(Clone, Copy, Debug)]
pub(in crate::method) struct Form {
    /// The derivatives of P.
    pub(in crate::method) value: Slopes<Part>,
    /// The derivatives of F.
    pub(in crate::method) rate: Slopes<Part>,
    pub(in crate::method) rows: Rows,
}

/// The weights of the rows of momenta in a step with an action.
#[derive(Clone)]
pub(in crate::method) struct Weights<'a, R, const S: usize> {
    pub(in crate::method) factors: &'a Factors<R, S>,
    /// The rows of momenta in each stage.
    pub(in crate::method) rows: Range<usize>,
    /// The derivatives of σ. Both are `Zero` if the factors do not depend on the unknowns.
    pub(in crate::method) decay: Slopes<Part>,
}

/// Returns the left-hand sides of the equations of all stages, and writes their derivatives by all unknowns to `matrix`. `coupling` is h·aᵢⱼ. Without
/// `weights`, all wᵢ are 1. Precondition: with `weights` whose σ has derivatives, the factors have derivatives by σ.
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

/// Returns the derivatives of a weighted row of stage i by σₘ of each stage m: Pᵢ ∂rᵢ/∂σₘ − h Σ aᵢⱼ Fⱼ ∂rⱼ/∂σₘ.
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
    /// Returns F after corrections of the unknown and of the shift, to first order. Precondition: the squares of the corrections are below rounding errors,
    /// as those of the last correction are.
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

    /// Returns σ after corrections of the unknown and of the shift, to first order, as [`rate_after`](Self::rate_after).
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

/// Returns the shifts h Σ aᵢⱼ xⱼ of all stages. `coupling` is h·aᵢⱼ.
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
