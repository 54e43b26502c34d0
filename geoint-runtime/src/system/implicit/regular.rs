//! Check that the mass matrix M = ∂²L/∂v² of a Lagrangian stays regular during a run.
//!
//! If M is singular, the velocity does not follow from the momentum, and a step may jump to another solution of ∂L/∂v = p. The check evaluates det M on
//! the straight line between the ends of each step, and refuses a step on which det M may vanish. It is a search, and no proof: a det M that oscillates
//! within a step may hide a zero. A discontinuity of det M is no zero, for example at an `if` or `abs` in L.

use super::mass::{MassForm, mass_units, velocity_from_rest, velocity_near};
use crate::scalar::Real;
use crate::solving::{Failure, linear};
use crate::space::vector::{difference, moved};
use crate::space::{Action, Array, Record, Tape};

/// Largest number of halvings of the line between the ends of a step. A part is halved if the determinant changes on it by more than a factor of two. A
/// part of 2⁻⁴⁰ of the line with this change holds a discontinuity or a zero.
const HALVINGS: u32 = 40;

/// A shortest part holds a discontinuity if its three determinants have one sign, and this factor times each exceeds the larger determinant at the ends of
/// the line. A smaller determinant may be a value next to a zero, and the step is refused.
const DISCONTINUITY_RATIO: f64 = 256.0;

/// Largest number of parts that are checked before a step is refused. A smallest determinant of 10⁻⁹ of those at the ends takes about sixty.
const MOST_PARTS: u32 = 500;

/// Failure of a state or a step whose mass matrix is singular.
const SINGULAR: Failure = Failure::OutsideDomain { what: SINGULAR_MASS };
const SINGULAR_MASS: &str = "the mass matrix ∂²L/∂v² is singular there, or on the way";

/// A point of a run: t, z and s.
pub(crate) type Moment<'a, S, R> =
    (R, &'a <S as crate::system::PhaseSpace<R>>::Phase, &'a <S as crate::system::PhaseSpace<R>>::Action);

/// The determinant of M at the last point of a run. Empty before the first step, or if M was proven to be positive definite.
#[derive(Clone, Copy, Debug)]
pub struct Regular<A: Array> {
    last: Option<MassAt<A>>,
}

/// The determinant of M at a point.
#[derive(Clone, Copy, Debug)]
struct MassAt<A> {
    /// Factors of the rows: 1/|Mᵢᵢ| at the first point of the run. If Mᵢᵢ = 0, the largest entry of the row replaces it, or 1 in a row of zeros.
    row_scales: A,
    /// The velocity. If L is quadratic, M does not read it, and it stays the velocity of the first point.
    v: A,
    /// The determinant of M with its rows multiplied by `row_scales`. Only its sign and ratios are read, so `f64` serves every scalar.
    determinant: f64,
}

impl<A: Array> Record<A::Real> for Regular<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        tape.option(&mut self.last, || MassAt { row_scales: A::zero(), v: A::zero(), determinant: 0.0 });
    }
}

impl<A: Array> Record<A::Real> for MassAt<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        tape.array(&mut self.row_scales);
        tape.array(&mut self.v);
        tape.number(&mut self.determinant);
    }
}

impl<A: Array> Regular<A> {
    /// Returns an empty value, for the start of a run.
    pub(crate) fn unknown() -> Self {
        Regular { last: None }
    }

    /// Prepares the check of a step, and returns the sign of det M, 1 or −1. det M is computed at the first step of a run only, because a run keeps its sign.
    ///
    /// The solver requires a matrix with a positive determinant. If its determinant has the sign of det M for short steps, callers multiply a row by the sign.
    /// `is_definite` is true if M was proven to be positive definite at every state. Nothing is checked then.
    ///
    /// # Errors
    /// At the first point of a run, if M is singular or no velocity is found.
    #[inline(always)]
    pub(crate) fn begin<S: MassForm<A::Real, Array = A>>(
        &mut self,
        system: &S,
        is_definite: bool,
        start: Moment<'_, S, A::Real>,
    ) -> Result<A::Real, Failure> {
        if is_definite {
            return Ok(A::Real::from_f64(1.0));
        }
        if self.last.is_none() {
            self.last = Some(mass_at_start(system, start).ok_or(SINGULAR)?);
        }
        Ok(A::Real::from_f64(if self.last.is_some_and(|last| last.determinant < 0.0) { -1.0 } else { 1.0 }))
    }

    /// Checks the way from the start to the end of a step. `v` is near the velocity at the end. Precondition: [`begin`](Self::begin) was called for this step.
    ///
    /// # Errors
    /// If the check does not exclude a zero of det M on the straight line between the ends, or if no velocity is found at the end.
    #[inline(always)]
    pub(crate) fn follow<S: MassForm<A::Real, Array = A>>(
        &mut self,
        system: &S,
        is_definite: bool,
        ends: [Moment<'_, S, A::Real>; 2],
        v: A,
    ) -> Result<(), Failure> {
        if is_definite {
            return Ok(());
        }
        let next = self.last.as_ref().and_then(|last| last.after(system, ends, v));
        self.last = Some(next.ok_or(SINGULAR)?);
        Ok(())
    }
}

/// Returns a message if the check does not exclude a zero of det M on the straight line between two points. For explicit methods.
///
/// Explicit methods keep no velocity, so it is computed from v = 0 at both points, as by [`velocity_of`](super::velocity_of). A jump to another solution of
/// ∂L/∂v = p then shows as a zero of det M between both velocities if there is one degree of freedom, or if M is definite on the line. Limit: with an
/// indefinite M, two velocities may have the same momentum without a zero between them.
pub fn singular_mass<S: MassForm<R>, R: Real>(
    system: &S,
    t: [R; 2],
    z: [&S::Phase; 2],
    s: [&S::Action; 2],
) -> Option<&'static str> {
    if system.is_definite() {
        return None;
    }
    let ends = [(t[0], z[0], s[0]), (t[1], z[1], s[1])];
    let Some(start) = mass_at_start(system, ends[0]) else { return Some(SINGULAR_MASS) };
    // An end that is not finite is reported by another check.
    if !z[1].is_finite() {
        return None;
    }
    let v = if S::QUADRATIC { Some(start.v) } else { velocity_from_rest(system, t[1], z[1], s[1]) };
    let is_regular = v.is_some_and(|v| start.after(system, ends, v).is_some());
    (!is_regular).then_some(SINGULAR_MASS)
}

/// Returns the determinant at the first point of a run. `None` if M is singular there, or if no velocity is found.
#[cold]
#[inline(never)]
fn mass_at_start<S: MassForm<R>, R: Real>(system: &S, start: Moment<'_, S, R>) -> Option<MassAt<S::Array>> {
    let (t, z, s) = start;
    let v = velocity_from_rest(system, t, z, s)?;
    let row_scales = mass_units(system, t, z, s, &v);
    let determinant = determinant(system, (t, &z[0], &v, s), &row_scales);
    (determinant != 0.0 && determinant.is_finite()).then_some(MassAt { row_scales, v, determinant })
}

impl<A: Array> MassAt<A> {
    /// Returns the determinant after a step. `None` if the determinant may have a zero on the line between the ends, or if no velocity is found from
    /// `near`.
    #[inline(never)]
    fn after<S: MassForm<R, Array = A>, R: Real>(
        &self,
        system: &S,
        [start, end]: [Moment<'_, S, R>; 2],
        near: A,
    ) -> Option<Self>
    where
        A: Array<Real = R>,
    {
        let ([(t, z, s), (t_end, z_end, s_end)], mut v) = ([start, end], self.v);
        if !S::QUADRATIC {
            v = velocity_near(system, t_end, z_end, s_end, near)?;
        }
        let (dq, dv) = (difference(&z_end[0], &z[0]), difference(&v, &self.v));
        let at = |x: f64| {
            let x = R::from_f64(x);
            let (q, v, mut s) = (moved(&z[0], x, &dq), moved(&self.v, x, &dv), *s);
            for (s, end) in s.numbers_mut().iter_mut().zip(s_end.numbers()) {
                *s += x * (*end - *s);
            }
            determinant(system, (t + x * (t_end - t), &q, &v, &s), &self.row_scales)
        };
        let last = determinant(system, (t_end, &z_end[0], &v, s_end), &self.row_scales);
        has_no_zero(at, [self.determinant, last]).then_some(MassAt { v, determinant: last, ..*self })
    }
}

/// Returns whether a search finds no zero of `f` from 0 to 1. `first` and `last` are its values there.
///
/// The line is halved until the values of `f` at the ends and the middle of each part differ by at most a factor of two. Zeros without a change of sign are
/// found too, because `f` changes by more on both sides.
fn has_no_zero(f: impl Fn(f64) -> f64, [first, last]: [f64; 2]) -> bool {
    // The smallest magnitude is at least half of the largest.
    let is_steady = |values: [f64; 3]| {
        let sizes = values.map(f64::abs);
        let largest = sizes.into_iter().fold(0.0, f64::max);
        sizes.into_iter().all(|size| 2.0 * size >= largest)
    };
    let shortest = 1.0 / (1_u64 << HALVINGS) as f64;
    // Ends of the parts that are not checked yet.
    let mut ends = [(1.0, last); HALVINGS as usize + 1];
    let (mut waiting, mut start) = (1, (0.0, first));
    for _ in 0..MOST_PARTS {
        let end = ends[waiting - 1];
        let x = 0.5 * (start.0 + end.0);
        let middle = f(x);
        let values = [start.1, middle, end.1];
        // NaN has neither sign, and counts as a zero.
        let [positive, negative] = [values.iter().all(|f| *f > 0.0), values.iter().all(|f| *f < 0.0)];
        if !positive && !negative {
            return false;
        }
        // A part this short holds a discontinuity, or a zero. A zero has small values beside it.
        let short = end.0 - start.0 <= shortest;
        let is_discontinuity =
            short && values.iter().all(|f| DISCONTINUITY_RATIO * f.abs() > f64::max(first.abs(), last.abs()));
        if is_discontinuity || is_steady(values) {
            start = end;
            waiting -= 1;
            if waiting == 0 {
                return true;
            }
        } else if !short {
            ends[waiting] = (x, middle);
            waiting += 1;
        } else {
            return false;
        }
    }
    false
}

/// Returns det M, with each row multiplied by its entry of `row_scales`.
fn determinant<S: MassForm<R>, R: Real>(
    system: &S,
    (t, q, v, s): (R, &S::Array, &S::Array, &S::Action),
    row_scales: &S::Array,
) -> f64 {
    let none = S::Array::zero();
    let (mut p, mut mass) = (none, S::Array::fill(none));
    system.mass(t, q, v, s, (&mut p, &mut mass));
    let rows = S::Array::entries::<S::Array>(&mut mass).iter_mut();
    for (row, scale) in rows.zip(row_scales.as_slice()) {
        row.as_mut_slice().iter_mut().for_each(|x| *x *= *scale);
    }
    linear::determinant::<S::Array>(&mut mass)
}

#[cfg(test)]
mod tests {
    use super::has_no_zero;

    #[test]
    fn zeros_are_seen_whether_they_are_crossed_or_not() {
        let seen = |f: &dyn Fn(f64) -> f64| !has_no_zero(f, [f(0.0), f(1.0)]);
        for zero in [1e-3, 0.1, 0.25, 1.0 / 3.0, 0.5, 0.7, 0.999] {
            for power in [1, 2, 3, 4, 6] {
                assert!(seen(&|x| (x - zero).powi(power)), "{zero} {power}");
                assert!(seen(&|x| -(x - zero).powi(power) * (2.0 + x)), "{zero} {power}");
            }
        }
        assert!(seen(&|_| f64::NAN) && seen(&|x| (0.5 - x).sqrt()));
    }

    #[test]
    fn functions_far_from_zero_pass() {
        let seen = |f: &dyn Fn(f64) -> f64| !has_no_zero(f, [f(0.0), f(1.0)]);
        assert!(!seen(&|_| -1e-200) && !seen(&|x| 1e-9 + x) && !seen(&|x| (x - 0.3).powi(2) + 1e-9));
        assert!(!seen(&|x| if x < 0.3 { 1.0 } else { 8.0 }) && !seen(&|x| if x < 0.7 { -20.0 } else { -1.0 }));
        assert!(!seen(&|x| (20.0 * x).exp()) && !seen(&|x| -(-30.0 * x).exp()));
    }
}
