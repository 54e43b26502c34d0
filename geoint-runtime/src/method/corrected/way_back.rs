//! The correction of the end of a step that gives invariants their earlier values. Its length is measured in the units of [`Scales`].

use super::frame::Frame;
use super::invariants::Invariants;
use super::roughness;
use super::scales::{Scales, part_of_rounding, rounding};
use crate::method::Refusal;
use crate::scalar::{Real, zero};
use crate::solving::noise;
use crate::solving::rounding::{Convergence, Correction, Corrections, Stuck, correct};
use crate::solving::size::Sizes;
use crate::space::Array;
use crate::space::vector::{self, difference, scaled, sum};
use crate::system::VectorField;
use core::cell::Cell;

/// A correction is near if each coordinate changes by less than this part of its size. The gradients hardly change on such a way. The value is empirical.
const NEAR: f64 = 1.0 / 16.0;

/// The longest correction that is not near, as a part of the step. After a longer one, the result may be any other point with these invariants.
const LONGEST_PART: f64 = 0.5;

/// The correction of a step.
pub(super) struct WayBack<Z> {
    pub(super) back: Z,
    /// The increment at whose end the branches of the energy (`if`, `abs`) were chosen last.
    pub(super) decided: Z,
}

/// Returns a short way from `end` to a point at which each invariant differs by `wanted` from its value at `before`.
///
/// `before` is the start of the step, or an earlier state if a Taylor series counts changes from there; "step" means the way from `before` to `end`. The way
/// back is found by up to two iterations:
///
/// 1. The simplified Newton iteration: the way is a combination of the gradients at `end`, and only its multipliers are unknown. It needs one evaluation
///    of the invariants each time.
/// 2. Newton's iteration with the gradients at each new point, if the first iteration fails or leads far. This happens where gradients are parallel, for
///    instance those of energy and momentum on a circular orbit: close to such a point, they turn much on the way of a correction.
///
/// # Errors
/// - [`Refusal::LedAstray`] if the way is longer than half of the step and not near.
/// - [`Refusal::NotConverged`] if no iteration converges: of the first one if both fail, else of the second one.
#[inline(always)]
pub(super) fn way_back<S: VectorField<R>, R: Real, I: Invariants<S, R>>(
    system: &S,
    invariants: &I,
    wanted: &I::Values,
    scales: &Scales<S::Phase>,
    [before, end]: [&S::Phase; 2],
) -> Result<WayBack<S::Phase>, Refusal> {
    let moved = &difference(end, before);
    // A coordinate is rounded by ε times its largest magnitude between both points. Its magnitude in earlier steps does not matter.
    let mut sizes = Sizes::new();
    sizes.include(before, moved);
    let equation = Equation { system, invariants, wanted, before, sizes, decided: Cell::new(*moved) };
    let gradients = invariants.gradients(system, end);
    let units = scales.units(|| equation.explained_by_rounding(&gradients, moved));
    let at_end = Frame::<I::Values, S::Phase>::new(gradients, units, &sizes);

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
        let frame = Frame::<I::Values, S::Phase>::new(gradients, units, &sizes);
        let mut delta = equation.residual(increment);
        let relative = frame.multipliers(&mut delta);
        let correction = frame.back(&delta);
        // Where gradients nearly depend on each other, Newton's corrections lead far away. They are shortened to what a way back may be.
        let length = Real::sqrt(sizes.square(&correction) / longest);
        let delta = if length > 1.0 { scaled(R::from_f64(1.0 / length), &correction) } else { correction };
        Ok(Correction { delta, relative })
    };
    // Both iterations use old gradients, so corrections shrink by a factor.
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
            // After a long way, the accepted residual was measured at `end`, where the terms may be much larger than at the solution.
            if sizes.all_within(&back, NEAR) { back } else { turning_from(sum(moved, &back))? }
        }
        Err(refusal) => turning_from(*moved).map_err(|_: Refusal| refusal)?,
    };
    if !sizes.all_within(&back, NEAR) && sizes.square(&back) > longest {
        return Err(Refusal::LedAstray);
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
    /// Whether the energy may jump. Corrections may then go from one side of the jump to the other for ever. This is no rounding, and ends with
    /// [`Refusal::NotConverged`].
    const JUMPS: bool = I::KEEP_ENERGY && !S::JUMPS.is_empty();

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
        // Beside a bend, and where angles are many turns, the residual looks rough although it is not rounding. Where rounding takes more than two
        // thirds of the digits, the value is not kept in any case.
        if !terms.all_within(&self.residual(increment), libm::cbrt(R::epsilon())) {
            return false;
        }
        let near = |part: R| {
            let residual = self.residual(&vector::moved(increment, part, correction));
            residual.is_finite().then_some(residual)
        };
        let rounding = roughness::rounding(near);
        // The last evaluation is that of the solution, which chooses the branches of the energy.
        near(zero()).is_some_and(|residual| noise::explains(&rounding, &residual, &terms))
    }

    /// Returns for each coordinate which part of the correction its own rounding explains, from 0 to 1. [`Scales::units`] turns it into a least unit.
    ///
    /// An invariant explains the part (rounding of its terms)/(residual). A coordinate takes the least part of the invariants that read it. The part is zero
    /// for a slope that nearly vanishes, which would ask for a long correction: such a slope differs by more than half at a point as far away as the
    /// correction may lead.
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
