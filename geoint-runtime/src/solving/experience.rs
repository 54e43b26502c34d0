//! Experience of earlier steps for the next equation: sizes of the unknowns, speed of convergence, and the better kind of guess.
//!
//! Newton's corrections shrink as c₂ = C c₁², relative to sizes. A correction below the *reach* √(2⁻²⁰ ε / C) is therefore the last one, with the machine
//! epsilon ε. Most steps then take one evaluation. Steps that compare two corrections measure C, in each 64th step at least. Limit: C may grow in between.

use super::equation::Units;
use super::predictor::Predictor;
use super::rounding::{REMAINDER, is_rounding};
use super::size::Sizes;
use crate::ablation;
use crate::scalar::Real;
use crate::space::{Array, Record, Tape};

/// Each 64th step takes a second evaluation, which measures sizes and the constant C. A larger period would miss more changes of C along an orbit.
const MEASUREMENT_PERIOD: u32 = 64;

/// The largest number of evaluations of Newton's loop. Solutions that take more may belong to another branch, so `rescue` examines them. With C = 1, a first
/// correction of 10⁻¹ is followed by a fifth one of 10⁻¹⁶.
pub(super) const MOST_EVALUATIONS: u32 = 5;

/// An explicit guess is good if its equation takes fewer evaluations than this. An extrapolated guess may take one more, because an explicit guess costs
/// evaluations itself. After a guess that is not good, the next one is explicit. Extrapolation is tried once in any case, when the predictor has all its terms.
/// Limit: it does not return as long as explicit guesses take three evaluations or more.
const POOR_GUESS: u32 = 3;

/// Lower bound of the constant C for the reach, because a measured C may be small by chance. The reach is then at most 5·10⁻¹⁰ in `f64`.
const LEAST_CURVATURE: f64 = 1e-3;

/// Knowledge about the next equation from earlier steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Experience<A> {
    /// The recent magnitudes |origin| + |x|. Solutions that the reach accepts are not included.
    pub(super) sizes: Sizes<A>,
    pub(super) units: Units,
    /// The largest correction, in units of the sizes, after which the next one is expected to be below [`REMAINDER`]·ε: √(ε·`REMAINDER`/C).
    pub(super) reach: f64,
    /// The number of steps that [`Newton`](super::newton::Newton) has solved. It wraps around.
    pub(super) steps: u32,
    /// The number of terms that the predictor has, at most [`Predictor::TERMS`].
    terms: usize,
    /// True if the next guess is extrapolated. Otherwise it is the explicit guess, computed from the start of the step.
    pub(super) extrapolates: bool,
}

impl<A: Array> Record<A::Real> for Experience<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        // The units follow from the method.
        let Experience { sizes, units: _, reach, steps, terms, extrapolates } = self;
        sizes.record(tape);
        tape.number(reach);
        let (mut counted, mut known) = (u64::from(*steps), *terms as u64);
        tape.count(&mut counted);
        tape.count(&mut known);
        (*steps, *terms) = (counted as u32, (known as usize).min(Predictor::<A>::TERMS));
        tape.flag(extrapolates);
    }
}

impl<A: Array> Experience<A> {
    /// Creates the experience before the first step, for unknowns with these units.
    pub(super) fn new(units: Units) -> Self {
        // The reach for C = 1.
        let reach = Real::sqrt(A::Real::epsilon() * REMAINDER);
        Experience { sizes: Sizes::new(), units, reach, steps: 0, terms: 0, extrapolates: false }
    }

    /// Returns whether this step must measure sizes and C, which other steps may take as known.
    #[inline(always)]
    pub(super) fn measures(&self) -> bool {
        ablation::MEASURED_CURVATURE && self.steps.is_multiple_of(MEASUREMENT_PERIOD)
    }

    /// Counts a term of the predictor, and chooses the kind of the next guess. The solution took this number of evaluations. `extrapolates` states whether its
    /// guess was extrapolated.
    #[inline(always)]
    pub(super) fn choose_next_guess(&mut self, evaluations: u32, extrapolates: bool) {
        let fills = self.terms + 1 == Predictor::<A>::TERMS;
        self.terms = (self.terms + 1).min(Predictor::<A>::TERMS);
        let good = fills || evaluations < POOR_GUESS + u32::from(extrapolates);
        self.extrapolates = ablation::EXTRAPOLATION && good && self.terms == Predictor::<A>::TERMS;
    }

    /// Computes C and the reach from the first relative correction, `before`, and the second one, `correction`. If the second correction is rounding, it yields
    /// an upper bound of C only: the reach may then grow, but not shrink.
    #[inline(always)]
    pub(super) fn measure_curvature(&mut self, correction: f64, before: f64) {
        if const { !ablation::MEASURED_CURVATURE } || !correction.is_finite() || !before.is_finite() {
            return;
        }
        // C changes along an orbit, so it gets a margin of 16.
        let curvature = 16.0 * correction / (before * before);
        let reach = Real::sqrt(A::Real::epsilon() * REMAINDER / curvature.max(LEAST_CURVATURE));
        if !is_rounding::<A::Real>(correction) || reach > self.reach {
            self.reach = reach;
        }
    }
}
