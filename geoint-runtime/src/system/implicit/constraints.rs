//! Systems whose velocities satisfy A v + b = 0: q' = ∂H/∂p, p' = −∂H/∂q + Aᵀμ, where A and b are functions of positions and time. With an action,
//! H = H₀(q, p, t) + γ(t)·s and p' = −∂H₀/∂q − γp + Aᵀμ. The checks of this file do not read s.
//!
//! Some rows are rates of constraints g(q, t) = 0, with A = ∂g/∂q and b = ∂g/∂t. μ are the multipliers. A state obeys a row if its velocity does, and g = 0 if
//! there is a g. This file checks states and steps, and projects states onto the constraints. The rows of A must not depend on each other. W = ∂²H/∂p², the
//! inverse mass matrix, measures their lengths.

use crate::scalar::Real;
use crate::solving::rounding::{Convergence, Correction, Corrections, ROUNDINGS, Stuck, correct};
use crate::solving::size::Sizes;
use crate::solving::{Failure, linear};
use crate::space::vector::{difference, dot, scaled, times};
use crate::space::{Array, PerCoordinate, Square};
use crate::system::Cotangent;

/// A system with constraints on its velocities, some of which may be rates of constraints g(q, t) = 0 of positions.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no constraints",
    label = "this is for systems with `constraint = [g]` or `rolling = [A·v + b]`"
)]
#[doc(alias("DAE", "holonomic constraint", "nonholonomic constraint"))]
pub trait Constrained<R: Real = f64>: Cotangent<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// One number for each constraint.
    type Multipliers: Array<Real = R>;
    /// Names for messages, two for each constraint: the formula of g, and its rate A ∂H/∂p + b.
    const CONSTRAINTS: &'static [[&'static str; 2]];
    /// True if ∂H/∂p is affine in p. One correction then makes a momentum tangent.
    const QUADRATIC: bool;

    /// Computes g, the rows of A, and b. g is 0 for a row that binds velocities only.
    fn constraints(
        &self,
        t: R,
        q: &Self::Array,
        values: &mut Self::Multipliers,
        gradients: &mut Gradients<Self, R>,
        drifts: &mut Self::Multipliers,
    );
    /// Computes ∂H/∂p and W = ∂²H/∂p².
    fn velocity(&self, t: R, z: &Self::Phase, velocity: &mut Self::Array, inverse_mass: &mut Square<Self::Array>);
    /// Returns two pairs: g with its sizes, and A ∂H/∂p + b with its sizes. A size is the change of the value by the rounding of coordinates and parameters, in
    /// units of the machine epsilon. Sizes of g include the rounding of coordinates that other constraints couple to it.
    fn departure(&self, t: R, z: &Self::Phase) -> [[Self::Multipliers; 2]; 2];
    /// Returns the multipliers with which a motion through z obeys the constraints: λ of the force −Gᵀλ for constraints of positions, and μ of the force Aᵀμ
    /// for the others.
    fn multipliers(&self, t: R, z: &Self::Phase) -> Self::Multipliers;
}

/// One row of the shape of positions for each constraint.
pub type Gradients<S, R> = <<S as Constrained<R>>::Multipliers as Array>::Map<<S as Cotangent<R>>::Array>;

/// The equation of a step of the method `M` from a point z = (q, p). The unknowns are multipliers in a row, and increments before them if the method needs
/// these.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no constraints of positions alone",
    label = "`{M}` is for systems with `constraint = [g]`",
    note = "methods beside an action: `ContactSplitting`, `ContactLeapfrog`, `ContactDiscreteGradient`",
    note = "methods that keep `rolling`: `DiscreteGradient`, `RK4`, `DOP853`",
    note = "without constraints `Rattle` is `StormerVerlet`, if the energy is T(p) + V(q)"
)]
pub trait ConstrainedStep<M, R: Real = f64>: Constrained<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// The unknowns in a row.
    type Unknown: Array<Real = R>;
    /// Coefficients that depend on parameters and h.
    type Constants: Copy + core::fmt::Debug;
    /// Coefficients that depend on z and the times of the step.
    type Start: Copy + core::fmt::Debug;

    /// Computes the coefficients that depend on parameters and h.
    fn constants(&self, h: R) -> Self::Constants;
    /// Computes the coefficients that all evaluations of a step from z have in common, with the action s. The times are those of its middle, its start and
    /// its end.
    fn begin(
        &self,
        constants: &Self::Constants,
        middle: R,
        start: R,
        end: R,
        z: &Self::Phase,
        s: &Self::Action,
    ) -> Self::Start;
    /// Computes the residual and its derivative. Row i has the unit of unknown i.
    fn residual(
        &self,
        constants: &Self::Constants,
        start: &Self::Start,
        x: &Self::Unknown,
        residual: &mut Self::Unknown,
        matrix: &mut Square<Self::Unknown>,
    );
    /// Returns the increments of positions, momenta and the action that belong to the unknowns `x`.
    fn end(
        &self,
        constants: &Self::Constants,
        start: &Self::Start,
        x: &Self::Unknown,
    ) -> PerCoordinate<Self::Phase, Self::Action>;
    /// Returns for each unknown the magnitude to which its rounding is relative. Multipliers have the rounding of positions.
    fn origin(&self, constants: &Self::Constants, start: &Self::Start) -> Self::Unknown;
}

/// Condition that a state of a system with constraints violates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unmet {
    /// The constraint or rate with this formula is not zero.
    Off(&'static str),
    /// The gradient of the constraint with this formula depends on the gradients of the constraints before it, or does not exist.
    Dependent(&'static str),
}

impl From<Unmet> for Failure {
    fn from(unmet: Unmet) -> Failure {
        match unmet {
            Unmet::Off(what) => Failure::OffConstraint { what },
            Unmet::Dependent(what) => Failure::DependentConstraints { what },
        }
    }
}

/// Returns the condition that a state violates at the start of steps of length `h`, if any.
///
/// Rounding is no violation. This includes rounding of coordinates and parameters, and a rate that changes a constraint in a step by rounding only.
#[cold]
#[inline(never)]
pub fn unmet<S: Constrained<R>, R: Real>(system: &S, t: R, h: R, z: &S::Phase) -> Option<Unmet> {
    let rounding = ROUNDINGS * R::epsilon();
    let [[values, sizes], [rates, sizes_of_rates]] = system.departure(t, z);
    let magnitude = |x: &S::Multipliers, k: usize| x.as_slice()[k].magnitude();
    for (k, [formula, rate]) in S::CONSTRAINTS.iter().enumerate() {
        let reach = rounding * magnitude(&sizes, k);
        // NaN is off the constraint. Zero is on it even if the reach is NaN, as at the tip of a cone, which has no gradient.
        let on = magnitude(&values, k) <= reach || magnitude(&values, k) == 0.0;
        let moves = magnitude(&rates, k);
        if on && moves.is_nan() {
            return Some(Unmet::Dependent(formula));
        }
        let stays = moves <= rounding * magnitude(&sizes_of_rates, k) || moves * h.magnitude() <= reach;
        if !on || !stays {
            return Some(Unmet::Off(if on { rate } else { formula }));
        }
    }
    let here = At { t, q: &z[0] };
    let dependent = on_one_side(system, z, [here, here]).err()?;
    Some(Unmet::Dependent(dependent))
}

/// Refuses a step from `before` to `z` if a constraint is not zero at its end, to rounding. This happens if the step is so long that positions lose digits in
/// the sum with h ∂H/∂p.
#[inline(always)]
pub(crate) fn held<S: Constrained<R>, R: Real>(system: &S, t: R, [before, z]: [&S::Phase; 2]) -> Result<(), Failure> {
    let [[values, sizes], _] = system.departure(t, z);
    let are_small = |of_start: &S::Multipliers| {
        let rounding = ROUNDINGS * R::epsilon();
        let sizes = sizes.as_slice().iter().zip(of_start.as_slice());
        let mut reaches = sizes.map(|(end, start)| rounding * (end.magnitude() + start.magnitude()));
        // Zero is on a constraint even if the reach is NaN.
        values.as_slice().iter().all(|value| {
            let reach = reaches.next();
            value.magnitude() == 0.0 || reach.is_some_and(|reach| value.magnitude() <= reach)
        })
    };
    // Increments carry the rounding of positions at both ends. The sizes at the start are computed only if those at the end do not suffice.
    if are_small(&S::Multipliers::zero()) || are_small(&system.departure(t, before)[0][1]) {
        return Ok(());
    }
    Err(Failure::Singular)
}

/// Positions at a time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct At<'a, A, R> {
    pub(crate) t: R,
    pub(crate) q: &'a A,
}

/// Checks that the constraints are independent at two positions and between. It is a test, and no proof.
///
/// The test is det(G W G₁ᵀ) > 0 with the gradients G and G₁ at the two positions, and W at `z` and the first time. Each row is divided by its diagonal entry
/// of G W Gᵀ. If constraints depend on each other between the positions, the space of their gradients usually changes its orientation, and the determinant
/// its sign. Two such places between the positions are not found. Rows are not exchanged, so a minor of the first rows that vanishes also fails the test.
///
/// # Errors
/// The formula of the constraint with the vanishing pivot, or of the last constraint if the determinant is negative.
#[inline(always)]
pub(crate) fn on_one_side<S: Constrained<R>, R: Real>(
    system: &S,
    z: &S::Phase,
    [first, last]: [At<'_, S::Array, R>; 2],
) -> Result<(), &'static str> {
    let (_, inverse_mass) = velocity(system, first.t, z);
    let [first, last] = [first, last].map(|At { t, q }| Rows::of(system, t, q).gradients);
    let mut matrix = S::Multipliers::fill(S::Multipliers::zero());
    let rows = S::Multipliers::entries::<S::Multipliers>(&mut matrix);
    for (row, gradient) in rows.iter_mut().zip(S::Multipliers::entries_of::<S::Array>(&first)) {
        let direction = times(&inverse_mass, gradient);
        // The diagonal of G W Gᵀ as the divisor makes pivots independent of units.
        let scale = R::from_f64(1.0) / dot(gradient, &direction);
        for (x, other) in row.as_mut_slice().iter_mut().zip(S::Multipliers::entries_of::<S::Array>(&last)) {
            *x = scale * dot(&direction, other);
        }
    }
    // A smaller pivot is rounding.
    let least = ROUNDINGS * R::epsilon() * S::Multipliers::LEN as f64;
    let mut positive = true;
    for k in 0..rows.len() {
        let (upper, lower) = rows.split_at_mut(k + 1);
        let top = upper[k].as_slice();
        let pivot = top[k];
        let large = pivot.magnitude() > least;
        if !large || !pivot.magnitude().is_finite() {
            return Err(S::CONSTRAINTS[k][0]);
        }
        positive ^= pivot.any_below(0.0);
        for row in lower {
            let factor = -(row.as_slice()[k] / pivot);
            row.add_scaled(factor, &upper[k]);
        }
    }
    if positive { Ok(()) } else { Err(S::CONSTRAINTS[rows.len() - 1][0]) }
}

/// Returns the momenta p − Aᵀμ, with μ from A ∂H/∂p + b = 0: the momenta of z = (q, p) without the part that leads away from the constraints.
///
/// # Errors
/// If constraints depend on each other at z, or if Newton's iteration for μ does not converge.
#[inline(always)]
pub(crate) fn tangent<S: Constrained<R>, R: Real>(system: &S, t: R, z: S::Phase) -> Result<S::Array, Failure> {
    let none = S::Array::zero();
    let Rows { gradients, drifts, .. } = Rows::of(system, t, &z[0]);
    let rows = S::Multipliers::entries_of::<S::Array>(&gradients);
    let correction = |p: &S::Array| {
        let (velocity, inverse_mass) = velocity(system, t, &[z[0], *p]);
        let mut multipliers = drifts;
        for (multiplier, gradient) in multipliers.as_mut_slice().iter_mut().zip(rows) {
            *multiplier += dot(gradient, &velocity);
        }
        solve::<S, R>(&gradients, &gradients, &inverse_mass, &mut multipliers)?;
        let mut delta = none;
        for (multiplier, gradient) in multipliers.as_slice().iter().zip(rows) {
            delta.add_scaled(*multiplier, gradient);
        }
        // The first correction of a linear equation is its solution.
        let relative = if S::QUADRATIC { 0.0 } else { Sizes::new().relative(&delta, &none, &difference(p, &delta)) };
        Ok(Correction { delta, relative })
    };
    correct(z[1], Corrections::of(Convergence::Quadratic), |Stuck { after, .. }| Some(*after), correction)
}

/// Returns a state on the constraints near the state `z`. Positions move by −W Gᵀν with the gradients G and W at `z`: to first order, this is the shortest way
/// in the metric of the mass matrix W⁻¹. The momentum is then made tangent.
///
/// # Errors
/// If constraints depend on each other at `z` or at the result, or if an iteration does not converge.
#[cold]
#[inline(never)]
pub(crate) fn projected<S: Constrained<R>, R: Real>(system: &S, t: R, z: &S::Phase) -> Result<S::Phase, Failure> {
    let none = S::Array::zero();
    let independent = |q: &S::Array| {
        let here = At { t, q };
        on_one_side(system, z, [here, here]).map_err(|what| Failure::DependentConstraints { what })
    };
    independent(&z[0])?;
    let (_, inverse_mass) = velocity(system, t, z);
    let start = Rows::of(system, t, &z[0]).gradients;
    let directions = S::Multipliers::entries_of::<S::Array>(&start);
    let correction = |q: &S::Array| {
        let Rows { values: mut multipliers, gradients: here, .. } = Rows::of(system, t, q);
        solve::<S, R>(&here, &start, &inverse_mass, &mut multipliers)?;
        let mut delta = none;
        for (multiplier, gradient) in multipliers.as_slice().iter().zip(directions) {
            delta.add_scaled(*multiplier, &times(&inverse_mass, gradient));
        }
        let relative = Sizes::new().relative(&delta, &z[0], &difference(q, &delta));
        Ok(Correction { delta, relative })
    };
    let q = correct(z[0], Corrections::of(Convergence::Quadratic), |Stuck { after, .. }| Some(*after), correction)?;
    independent(&q)?;
    Ok([q, tangent(system, t, [q, z[1]])?])
}

/// Solves G W G₀ᵀ ν = r in place of r, with `gradients` G, gradients G₀ = `starts` at the start of the iteration, and `inverse_mass` W.
///
/// # Errors
/// If the matrix is singular.
#[inline(always)]
fn solve<S: Constrained<R>, R: Real>(
    gradients: &Gradients<S, R>,
    starts: &Gradients<S, R>,
    inverse_mass: &Square<S::Array>,
    r: &mut S::Multipliers,
) -> Result<(), Failure> {
    let mut matrix = S::Multipliers::fill(S::Multipliers::zero());
    let gradients = S::Multipliers::entries_of::<S::Array>(gradients);
    let rows = S::Multipliers::entries::<S::Multipliers>(&mut matrix);
    for (l, start) in S::Multipliers::entries_of::<S::Array>(starts).iter().enumerate() {
        let direction = times(inverse_mass, start);
        for (row, gradient) in rows.iter_mut().zip(gradients) {
            row.as_mut_slice()[l] = dot(gradient, &direction);
        }
    }
    // Row k gets the unit of the multiplier k: that of 1/√(G W Gᵀ)ₖₖ, up to a factor that all rows share.
    let mut sizes = S::Multipliers::zero();
    for (k, (row, r)) in rows.iter_mut().zip(r.as_mut_slice()).enumerate() {
        let diagonal = row.as_slice()[k];
        sizes.as_mut_slice()[k] = R::from_f64(1.0 / Real::sqrt(diagonal.magnitude()));
        let scale = R::from_f64(1.0) / diagonal;
        *row = scaled(scale, row);
        *r *= scale;
    }
    linear::solve(&mut matrix, r, &Sizes::of_magnitudes(sizes)).map(drop).ok_or(Failure::Singular)
}

/// Returns ∂H/∂p and W = ∂²H/∂p².
fn velocity<S: Constrained<R>, R: Real>(system: &S, t: R, z: &S::Phase) -> (S::Array, Square<S::Array>) {
    let none = S::Array::zero();
    let (mut velocity, mut inverse_mass) = (none, S::Array::fill(none));
    system.velocity(t, z, &mut velocity, &mut inverse_mass);
    (velocity, inverse_mass)
}

/// The constraints at a position and a time.
struct Rows<S: Constrained<R>, R: Real> {
    values: S::Multipliers,
    gradients: Gradients<S, R>,
    drifts: S::Multipliers,
}

impl<S: Constrained<R>, R: Real> Rows<S, R> {
    #[inline(always)]
    fn of(system: &S, t: R, q: &S::Array) -> Self {
        let none = S::Multipliers::zero();
        let mut rows = Rows { values: none, gradients: S::Multipliers::fill(S::Array::zero()), drifts: none };
        system.constraints(t, q, &mut rows.values, &mut rows.gradients, &mut rows.drifts);
        rows
    }
}
