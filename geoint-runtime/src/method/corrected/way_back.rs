//! Computes the correction of the end of a step that restores invariants. Its length is measured in the units of [`Scales`].

use super::basis::Excluded;
use super::frame::Frame;
use super::invariants::Invariants;
use super::roughness;
use super::scales::{Scales, part_of_rounding, rounding};
use crate::method::Failure;
use crate::scalar::{Real, zero};
use crate::solving::noise;
use crate::solving::rounding::{Convergence, Correction, Corrections, Stuck, correct};
use crate::solving::size::Sizes;
use crate::space::Array;
use crate::space::vector::{self, difference, scaled, sum};
use crate::system::VectorField;
use core::cell::Cell;

/// A correction is *near* if each coordinate changes by at most this part of its size. The gradients hardly change along it. The value is empirical.
const NEAR: f64 = 1.0 / 16.0;

/// The longest correction that is not near, as a part of the step. After a longer one, the result may be any other point with these invariants.
const LONGEST_PART: f64 = 0.5;

/// The correction of a step.
pub(super) struct WayBack<Z> {
    pub(super) back: Z,
    /// The increment at whose end the branches of the energy (`if`, `abs`) were chosen last.
    pub(super) decided: Z,
}

/// Returns a short correction of `end`. After it, each invariant differs by `wanted` from its value at `before`.
///
/// `before` is the start of the step. For Taylor series it may be an earlier state, the reference. "Step" means the increment from `before` to `end`.
/// The correction is found by up to two iterations:
///
/// 1. The simplified Newton iteration. The correction is a combination of the gradients at `end`, and only its multipliers are unknown. Each iteration
///    evaluates the invariants once.
/// 2. Newton's iteration with the gradients at each new point, if the first iteration fails or its correction is not near. This happens if gradients
///    are nearly parallel, for instance those of energy and angular momentum on an almost circular orbit. They then turn much along a correction.
///
/// # Errors
/// - [`Failure::LedAstray`] if the correction is longer than half of the step and not near.
/// - [`Failure::NotConverged`] if no iteration converges. If both iterations fail, the error is that of the first one.
#[inline(always)]
pub(super) fn way_back<S: VectorField<R>, R: Real, I: Invariants<S, R>>(
    system: &S,
    invariants: &I,
    wanted: &I::Values,
    scales: &Scales<S::Phase>,
    [before, end]: [&S::Phase; 2],
) -> Result<WayBack<S::Phase>, Failure> {
    let moved = &difference(end, before);
    // A coordinate is rounded by ε times its largest magnitude between both points. Its magnitude in earlier steps does not matter.
    let sizes = Sizes::along([before, moved]);
    let equation = Equation { system, invariants, wanted, before, sizes, decided: Cell::new(*moved) };
    let gradients = invariants.gradients(system, end);
    let units = scales.units(|| equation.explained_by_rounding(&gradients, moved));
    let at_end = Frame::<I::Values, S::Phase>::new(gradients, units, &sizes, Excluded::Dependent);

    let increment = |multipliers: &I::Values| sum(moved, &at_end.back(multipliers));
    let simplified = |multipliers: &I::Values| {
        let mut delta = equation.residual(&increment(multipliers));
        let relative = at_end.multipliers(&mut delta);
        Ok(Correction { delta, relative })
    };
    let accept = |Stuck { before, delta, .. }: Stuck<'_, I::Values>| {
        equation.is_noise(&increment(before), &at_end.back(delta)).then_some(*before)
    };
    let longest = LONGEST_PART * LONGEST_PART * sizes.square(moved);
    let turning = |increment: &S::Phase| {
        let gradients = invariants.gradients(system, &sum(before, increment));
        let frame = Frame::<I::Values, S::Phase>::new(gradients, units, &sizes, Excluded::Dependent);
        let mut delta = equation.residual(increment);
        let relative = frame.multipliers(&mut delta);
        let correction = frame.back(&delta);
        // If gradients nearly depend on each other, Newton's corrections are very long. They are shortened to the longest permitted correction.
        let length = Real::sqrt(sizes.square(&correction) / longest);
        let delta = if length > 1.0 { scaled(R::from_f64(1.0 / length), &correction) } else { correction };
        Ok(Correction { delta, relative })
    };
    // Linear convergence is assumed for both iterations: corrections shrink by a factor.
    let convergence = Corrections::of(Convergence::Linear);
    let turning_from = |start: S::Phase| {
        let accept =
            |Stuck { before, delta, .. }: Stuck<'_, S::Phase>| equation.is_noise(before, delta).then_some(*before);
        let end = correct(start, convergence, accept, turning)?;
        Ok(difference(&end, moved))
    };
    let back = match correct(I::Values::zero(), convergence, accept, simplified) {
        Ok(multipliers) => {
            let back = at_end.back(&multipliers);
            // The residual was accepted relative to the terms at `end`. After a long correction, these may be much larger than at the solution.
            if sizes.all_within(&back, NEAR) { back } else { turning_from(sum(moved, &back))? }
        }
        Err(refusal) => turning_from(*moved).map_err(|_: Failure| refusal)?,
    };
    if !sizes.all_within(&back, NEAR) && sizes.square(&back) > longest {
        return Err(Failure::LedAstray);
    }
    Ok(WayBack { back, decided: equation.decided.get() })
}

/// The equation I(before + increment) − I(before) = wanted.
struct Equation<'a, S: VectorField<R>, R: Real, I: Invariants<S, R>> {
    system: &'a S,
    invariants: &'a I,
    wanted: &'a I::Values,
    before: &'a S::Phase,
    sizes: Sizes<S::Phase>,
    /// The increment at whose end the branches of the energy were chosen last.
    decided: Cell<S::Phase>,
}

impl<S: VectorField<R>, R: Real, I: Invariants<S, R>> Equation<'_, S, R, I> {
    /// Whether the energy may jump. Corrections may then alternate between both sides of the jump. This is not rounding, and ends with
    /// [`Failure::NotConverged`].
    const JUMPS: bool = I::ORIGIN.keeps_energy() && !S::JUMPS.is_empty();

    /// Returns the residual I(before + increment) − I(before) − wanted, and stores the increment in `decided`.
    #[inline(always)]
    fn residual(&self, increment: &S::Phase) -> I::Values {
        self.decided.set(*increment);
        difference(&self.invariants.changes(self.system, self.before, increment), self.wanted)
    }

    /// Returns whether the residual at `increment` is rounding. `correction` is the last correction of the iteration.
    #[cold]
    #[inline(never)]
    fn is_noise(&self, increment: &S::Phase, correction: &S::Phase) -> bool {
        let is_long = !self.sizes.all_within(correction, NEAR);
        if Self::JUMPS || is_long {
            return false;
        }
        // Coordinates are rounded at both ends of the step, and the gradient may vanish at one of them.
        let ends = [*self.before, sum(self.before, increment)];
        let mut gradients = ends.map(|z| self.invariants.gradients(self.system, &z));
        let [first, last] = gradients.each_mut().map(I::Values::entries);
        let mut terms = I::Values::zero();
        for (terms, (first, last)) in terms.as_mut_slice().iter_mut().zip(first.iter().zip(last.iter())) {
            *terms = R::from_f64(Sizes::at(self.before).terms(first) + self.sizes.terms(last));
        }
        let terms = Sizes::of_magnitudes(terms);
        // Next to a kink, and for angles of many turns, the residual looks rough although it is not rounding. A residual above ∛ε of the terms
        // is therefore not accepted.
        if !terms.all_within(&self.residual(increment), libm::cbrt(R::epsilon())) {
            return false;
        }
        let near = |part: R| {
            let residual = self.residual(&vector::moved(increment, part, correction));
            residual.is_finite().then_some(residual)
        };
        let rounding = roughness::rounding(near);
        // The last evaluation is at the solution: it chooses the branches of the energy.
        near(zero()).is_some_and(|residual| noise::explains(&rounding, &residual, &terms))
    }

    /// Returns for each coordinate the part of the correction that its own rounding explains, from 0 to 1. [`Scales::units`] converts it to a least unit.
    ///
    /// The part of an invariant is (rounding of its terms)/(residual). The part of a coordinate is the least one of the invariants that read it. The part
    /// is zero if the slope nearly vanishes, because it would require a long correction. The test compares the slope with that at a point at the
    /// distance of such a correction. They must not differ by more than half.
    #[cold]
    #[inline(never)]
    fn explained_by_rounding(&self, gradients: &<I::Values as Array>::Map<S::Phase>, moved: &S::Phase) -> S::Phase {
        let gradients = I::Values::entries_of(gradients);
        let mut parts = self.residual(moved);
        for (part, gradient) in parts.as_mut_slice().iter_mut().zip(gradients) {
            *part = R::from_f64(part_of_rounding(*part, self.sizes.terms(gradient)));
        }
        let least = parts.as_slice().iter().fold(1.0, |least, part| part.magnitude().min(least));
        let beside = self.sizes.beside(&sum(self.before, moved), rounding::<R>() / least);
        let mut beside = self.invariants.gradients(self.system, &beside);
        let slopes = gradients.iter().zip(I::Values::entries(&mut beside));
        let mut explained = S::Phase::zero();
        explained.as_mut_slice().fill(R::from_f64(1.0));
        for (part, (gradient, beside)) in parts.as_slice().iter().zip(slopes) {
            let slopes = gradient.as_slice().iter().zip(beside.as_slice());
            for (least, (slope, beside)) in explained.as_mut_slice().iter_mut().zip(slopes) {
                let is_linear = (*beside - *slope).magnitude() <= 0.5 * slope.magnitude();
                let part = if is_linear { *part } else { R::from_f64(0.0) };
                if slope.magnitude() > 0.0 && part.magnitude() < least.magnitude() {
                    *least = part;
                }
            }
        }
        explained
    }
}
