//! The variational integrator of Herglotz' principle, for H = T(p, t) + g(t)·s + V(q, t).

use crate::method::composition::substeps;
use crate::method::flows::delegate;
use crate::method::{Claims, Clock, Failure, Method, Name, Probe, Step, SteppedAs};
use crate::scalar::Real;
use crate::space::{Array, PerCoordinate, Point, Summation};
use crate::system::Mechanical;

/// p½ = (1 − h g₀/2) p₀ − h/2 V'(q₀, t₀), q₁ = q₀ + h T'(p½, t½), p₁ = [p½ − h/2 V'(q₁, t₁)]/(1 + h g₁/2). Here g₀ = g(t₀), g₁ = g(t₁), V' = ∂V/∂q,
/// T' = ∂T/∂p, and t½ is the middle of the step from t₀ to t₁. The action s has the factors of p, and the increments −h/2 V, h (p½·T' − T) and −h/2 V.
///
/// For H = T(p, t) + g(t)·s + V(q, t). Velocity Verlet with trapezoidal damping, explicit. Order 2, symmetric, a contact map. A step evaluates the force
/// at both ends.
///
/// A step damps by the quotient (1 − h g₀/2)/(1 + h g₁/2). A step is refused if numerator or denominator is not positive, for instance if h g₀ ≥ 2.
/// [`ContactSplitting`] damps by exponentials, such as e^(−hg) for a constant g, and has no such limit.
///
/// Beside constraints the step is [`DampedRattle`](crate::method::constrained::DampedRattle), and multipliers keep q₁ and p₁ on them.
///
/// M. Vermeeren, A. Bravetti & M. Seri, J. Phys. A 52 (2019) 445206. Here g, T and V may depend on time.
///
/// [`ContactSplitting`]: crate::ContactSplitting
#[doc(alias = "contact variational integrator")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContactLeapfrog;

delegate!([] ContactLeapfrog, [SteppedAs<ContactLeapfrog, R>], Steps<S, R>, |this| Steps::<S, R>::from(*this));
substeps!([] ContactLeapfrog; [] ExplicitLeapfrog);

/// The steps of [`ContactLeapfrog`] for a system.
type Steps<S, R> = <S as SteppedAs<ContactLeapfrog, R>>::Steps;

/// The steps of [`ContactLeapfrog`] without constraints.
#[derive(Clone, Copy, Debug)]
pub struct ExplicitLeapfrog;

impl From<ContactLeapfrog> for ExplicitLeapfrog {
    fn from(_: ContactLeapfrog) -> Self {
        ExplicitLeapfrog
    }
}

/// Coefficients of a step.
#[derive(Clone)]
pub struct Prepared<S: Mechanical<R>, R: Real> {
    h: R,
    half_kick: S::FreeKick,
    drift: S::FreeDrift,
}

impl<S: Mechanical<R>, R: Real> Method<S, R> for ExplicitLeapfrog {
    type Proof = <S as Mechanical<R>>::Proof;
    type Prepared = Prepared<S, R>;
    type Memory = ();

    fn claims(&self) -> Claims {
        Claims { order: 2, symmetric: true, symplectic: true, conserves_energy: false, perturbed: &[], forces: Some(2) }
    }

    fn name(&self) -> Name {
        Name::new("ContactLeapfrog")
    }

    fn prepare(&self, system: &S, h: R) -> Prepared<S, R> {
        let half_kick = system.prepare_free_kick(R::from_f64(0.5) * h);
        Prepared { h, half_kick, drift: system.prepare_free_drift(h) }
    }

    fn memory(_: &S::Phase) {}

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Prepared<S, R>,
        (): &mut (),
        Step { system, t, x, probe, .. }: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        let Prepared { h, half_kick, drift } = prepared;
        let (one, half) = (R::from_f64(1.0), R::from_f64(0.5) * *h);
        let end = t + *h;
        let drag = [t, end].map(|t| half * system.damping(t));
        let [before, after] = [one - drag[0], one + drag[1]];
        if before.any_not_positive() || after.any_not_positive() {
            return Err(Failure::Singular);
        }
        probe.visit(t, &x.z, &x.s);
        if C::PLAIN {
            scale(before, x);
            // In a run without the action, s is restored at the end. The compiler then drops the terms of s.
            let unread = x.s;
            let [q, p] = &mut x.z;
            system.free_kick(half_kick, t, q, p, &mut x.s);
            system.free_drift(drift, t + half, q, p, &mut x.s);
            probe.visit(end, &x.z, &x.s);
            let [q, p] = &mut x.z;
            system.free_kick(half_kick, end, q, p, &mut x.s);
            scale(one / after, x);
            if !C::ACTION {
                x.s = unread;
            }
        } else {
            // The formulas of the plain branch, with the increment of each flow in `d`. A kick adds to p and s and reads q. A drift adds to q and s and
            // reads p.
            add(x, |x, d| add_scaled(-drag[0], x, d));
            add(x, |x, d| system.free_kick(half_kick, t, &mut x.z[0], &mut d.z[1], &mut d.s));
            add(x, |x, d| system.free_drift(drift, t + half, &mut d.z[0], &mut x.z[1], &mut d.s));
            probe.visit(end, &x.z, &x.s);
            add(x, |x, d| system.free_kick(half_kick, end, &mut x.z[0], &mut d.z[1], &mut d.s));
            add(x, |x, d| add_scaled(-drag[1] / after, x, d));
        }
        Ok(())
    }
}

/// Computes (p, s) ← w·(p, s).
#[inline(always)]
fn scale<A: Array, C>(w: A::Real, x: &mut Point<[A; 2], C, A::Real>) {
    for p in x.z[1].as_mut_slice() {
        *p = w * *p;
    }
    x.s = w * x.s;
}

/// Adds to `x` the increment that `flow` computes from the coordinates of `x`.
#[inline(always)]
fn add<Z: Array, C: Summation<Z>>(
    x: &mut Point<Z, C, Z::Real>,
    flow: impl FnOnce(&mut PerCoordinate<Z, Z::Real>, &mut PerCoordinate<Z, Z::Real>),
) {
    let mut d = PerCoordinate::nothing();
    flow(&mut PerCoordinate::of(x), &mut d);
    x.add_everywhere(&d);
}

/// Adds w·(p, s) of `x` to (p, s) of `d`.
#[inline(always)]
fn add_scaled<A: Array>(w: A::Real, x: &PerCoordinate<[A; 2], A::Real>, d: &mut PerCoordinate<[A; 2], A::Real>) {
    d.z[1].add_scaled(w, &x.z[1]);
    d.s += w * x.s;
}
