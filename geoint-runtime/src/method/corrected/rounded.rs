//! Checks whether rounding on the way of a step changes an invariant of the step.
//!
//! A coordinate is rounded by ε times its largest size during a step. If a step moves far away and returns, for instance over a pole, its result has the
//! rounding of the far point. This rounding changes a steep invariant by much more than its own rounding. Such steps are refused.
//!
//! A *thorough* attempt is the second one: it iterates longer, and accepts an equation that is solved to its measured rounding. The first attempt is
//! quick. For rounding it only marks its result as needs_recheck, unless the energy reads an angle. Jumps refuse every attempt.

use crate::method::implicit::{Arrival, Departure};
use crate::method::{Effort, Failure};
use crate::scalar::Real;
use crate::solving::size::Sizes;
use crate::space::vector::difference;
use crate::space::{Array, PerCoordinate, Snapshot};
use crate::system::{Invariants, Keeping, KeptBy, PhaseSpace, jump_of_integral};

/// A step is refused if an invariant changes by more than this many of its roundings.
///
/// The constant is also the factor of a *leap*: a coordinate moves by more than this many times the smaller of its magnitudes at both ends. Corrections
/// are checked, and first attempts of steep fields marked, only after a leap: otherwise the rounding on the way is within the bound. With a small factor, many
/// ordinary passages through zero would be leaps. A coordinate that starts or ends at zero always leaps.
const MOST: f64 = 16384.0;

/// A step of a canonical system may change the energy by this many of its roundings (2²², empirical). Forces that cancel have larger terms, which are
/// not known here. In single precision, 2²² ε is half of the energy. The bound is therefore √ε at most.
const MOST_OF_ENERGY: f64 = 4_194_304.0;

/// Refuses the step of a field from `before` to `x` if rounding changes an integral, or the step leads across a jump of an integral.
///
/// For fields, a jump refuses any attempt, and rounding refuses only thorough attempts. The first attempt of a steep field is marked as needs_recheck if a
/// coordinate leaps, and the caller repeats it as a thorough attempt.
///
/// In canonical systems only the energy is checked, by [`check_energy`]. This check runs in thorough attempts, and always if the energy reads an angle.
#[inline(always)]
pub(crate) fn check_step<S: Keeping<R>, R: Real>(
    effort: Effort,
    Departure { system, t, end, z: before, .. }: &Departure<'_, S, R>,
    Arrival { z, s, needs_recheck }: Arrival<'_, S, R>,
) -> Result<(), Failure> {
    if const { S::State::MOMENTA } {
        return if effort.is_thorough() || S::ANGLES { check_energy(*system, before, z) } else { Ok(()) };
    }
    Failure::outside(jump_of_integral(*system, [*t, *end], [before, z], *s))?;
    if effort.is_thorough() {
        let kept = KeptBy::<S, R>::default();
        let changes = kept.changes(*system, before, &difference(z, before));
        return refuse(*system, &kept, &changes, [before, z, z]);
    }
    if const { S::STEEP } {
        *needs_recheck |= leaps(before, z);
    }
    Ok(())
}

/// Refuses a step of a canonical system, from `before` to `after`, that changes the energy by more than rounding.
///
/// A thorough attempt trusts the measured rounding of its equation. Next to a bend of the energy (`abs`), the bend may look like rounding. If an angle
/// moves by half a turn, its divided differences jump, and an equation may look solved on both sides of the jump.
///
/// The bound is relative to the energy and to the products of coordinates and forces. Terms that cancel are not among them: [`MOST_OF_ENERGY`] leaves
/// room for their rounding.
#[cold]
#[inline(never)]
fn check_energy<S: Keeping<R>, R: Real>(system: &S, before: &S::Phase, after: &S::Phase) -> Result<(), Failure> {
    let kept = KeptBy::<S, R>::default();
    // The first change is the change of the energy, or zero if the energy reads time. Other integrals, such as angular momenta, are not checked,
    // because some discrete gradients do not keep them.
    let changes = kept.changes(system, before, &difference(after, before));
    let Some(change) = changes.as_slice().first() else { return Ok(()) };
    let terms =
        system.hamiltonian(R::from_f64(0.0), before, &PerCoordinate::<S::Phase, S::Action>::zero().s).magnitude();
    // The rounding of a coordinate follows its largest size on the way.
    let sizes = Sizes::along([before, after]);
    let at_ends = [before, after].map(|z| {
        let mut gradients = kept.gradients(system, z);
        sizes.terms(&<KeptBy<S, R> as Invariants<S, R>>::Values::entries(&mut gradients)[0])
    });
    let most = (MOST_OF_ENERGY * R::epsilon()).min(Real::sqrt(R::epsilon())) * (at_ends[0].max(at_ends[1]) + terms);
    if change.magnitude() > most { Err(Failure::Rounded) } else { Ok(()) }
}

/// Refuses a step of any method from `before` to `end`, followed by a projection from `end` to `after`. `t` holds the times of the last step.
///
/// The step is refused if it leads across a jump of an integral, or if a coordinate leaps and rounding on the way changes an invariant. The change of
/// the invariants themselves is not checked again. The correction has already reduced this change to rounding.
#[inline(always)]
pub(super) fn check_correction<S: PhaseSpace<R, Action = ()>, R: Real, I: Invariants<S, R>>(
    system: &S,
    t: [R; 2],
    invariants: &I,
    [before, end, after]: [&S::Phase; 3],
) -> Result<(), Failure> {
    Failure::outside(jump_of_integral(system, t, [before, after], ()))?;
    if leaps(before, after) || leaps(end, after) {
        return refuse(system, invariants, &I::Values::zero(), [before, after, end]);
    }
    Ok(())
}

/// Returns whether a coordinate becomes smaller or larger by more than the factor [`MOST`].
#[inline(always)]
fn leaps<A: Array>(before: &A, after: &A) -> bool {
    let mut leaps = false;
    for i in 0..A::LEN {
        let (before, after) = (before.as_slice()[i], after.as_slice()[i]);
        let (moved, before, after) = ((after - before).magnitude(), before.magnitude(), after.magnitude());
        leaps |= moved > MOST * if before < after { before } else { after };
    }
    leaps
}

/// Refuses a step from `start` to `end` if an invariant changes by more than [`MOST`] of its roundings at the ends, or if rounding on the way may change
/// it by as much. `uncorrected` is the end before a correction, and lies on the way, too.
#[cold]
#[inline(never)]
fn refuse<S: PhaseSpace<R>, R: Real, I: Invariants<S, R>>(
    system: &S,
    invariants: &I,
    changes: &I::Values,
    [start, end, uncorrected]: [&S::Phase; 3],
) -> Result<(), Failure> {
    let mut gradients = [start, end].map(|z| invariants.gradients(system, z));
    let [first, last] = gradients.each_mut().map(I::Values::entries);
    let (way, ends) = (Sizes::along([start, end, uncorrected]), [start, end].map(Sizes::at));
    let is_lost = |(change, (first, last)): (&R, (&S::Phase, &S::Phase))| {
        let at_ends = f64::max(ends[0].terms(first), ends[1].terms(last));
        let on_way = f64::max(way.terms(first), way.terms(last));
        f64::max(change.magnitude() / R::epsilon(), on_way) > MOST * at_ends
    };
    let lost = changes.as_slice().iter().zip(first.iter().zip(last.iter())).any(is_lost);
    if lost { Err(Failure::Rounded) } else { Ok(()) }
}
