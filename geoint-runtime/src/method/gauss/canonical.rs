//! The Gauss step of a system with canonical coordinates y(x) of its state x. These systems are Lagrangians ϑ(q)·v − H(q, t), linear in the velocities v,
//! with x = q. [`CanonicalForm`] states which of them have such coordinates. The unknowns are the increments xᵢ − x₀ to all stages xᵢ:
//!
//! y(xᵢ) = y(x₀) + h Σ aᵢⱼ y'(xⱼ). The end x̂ of the step follows from y(x̂) = y(x₀) + h Σ bⱼ y'(xⱼ).
//!
//! Here y' = dy/dt, and aᵢⱼ and bⱼ are the coefficients and weights of the method. y depends on x only, and y' may also read time. Collocation applied to
//! y is symplectic. Applied to x, it is not. The equations are solved for x, so no formula for x(y) is needed.
//!
//! A step is refused if ∂y/∂x is singular at its start, or if the sign of a determinant shows that ∂y/∂x was singular on the way. Limits: two changes of
//! the sign cancel. With more than twelve unknowns, the solver first iterates without a matrix. If this succeeds, no determinant of the stages is
//! checked.

use super::prepared::Scaled;
use super::stages::{Form, Part, Rows, Slopes, Values, assemble};
use super::{Gauss, GaussTableau};
use crate::method::implicit::{Departure, Equation, ImplicitStep, Increment, Policy, Stage, Units, Watch};
use crate::method::{Failure, Probe};
use crate::scalar::Real;
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::solving::rounding::{Convergence, Correction, Corrections, Stuck, correct};
use crate::solving::size::Sizes;
use crate::solving::{Inverse, Inverted, linear};
use crate::space::vector::{difference, scaled, sum};
use crate::space::{Array, Snapshot, Square};
use crate::system::{CanonicalForm, row_scale};

/// The step with `S` stages whose unknowns are the increments of x up to its stages.
#[derive(Clone, Copy, Debug)]
pub struct CanonicalStages<const S: usize>;

/// The derivatives ∂y/∂x and ∂y'/∂x are given. The shift of stage i is the sum h Σ aᵢⱼ uⱼ of all unknowns u. The point xᵢ follows from the unknown
/// xᵢ − x₀ of its own stage, so no derivative by the shift is needed. Rows are in units of x already.
const FORM: Form = Form {
    value: Slopes { by_unknown: Part::Given, by_shift: Part::Zero },
    rate: Slopes { by_unknown: Part::Given, by_shift: Part::Zero },
    rows: Rows::Plain,
};

/// Coefficients of a step.
#[derive(Clone, Copy, Debug)]
pub struct Coefficients<P, R, const S: usize> {
    /// Coefficients of the system.
    kernel: P,
    /// The table of the method, times h.
    scaled: Scaled<R, S>,
}

/// y, y' and (∂y/∂x)⁻¹ at the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<A: Array> {
    y: A,
    rate: A,
    inverse: Inverted<A>,
}

/// y and y' at a point, and the derivatives ∂y/∂x and ∂y'/∂x.
#[derive(Clone, Copy)]
struct At<A: Array> {
    value: A,
    rate: A,
    derivatives: [Square<A>; 2],
}

/// Indices of ∂y/∂x and ∂y'/∂x in `At::derivatives`.
const VALUE: usize = 0;
const RATE: usize = 1;

impl<A: Array> At<A> {
    #[inline(always)]
    fn new<Y: CanonicalForm<R, Phase = A>, R: Real>(
        system: &Y,
        constants: &Y::CanonicalConstants,
        t: R,
        z: A,
    ) -> At<A> {
        let none = A::zero();
        let mut at = At { value: none, rate: none, derivatives: [A::fill(none); 2] };
        system.canonical(constants, t, &z, [&mut at.value, &mut at.rate], &mut at.derivatives);
        at
    }
}

impl<Y: CanonicalForm<R>, R: Real, const S: usize> Equation<'_, CanonicalStages<S>, Y, R>
where
    Gauss<S>: GaussTableau<S>,
{
    /// Returns the time and the point of a stage.
    #[inline(always)]
    fn place(&self, i: usize, d: &[Y::Phase; S]) -> (R, Y::Phase) {
        (self.from.t + self.coefficients.scaled.nodes[i], sum(&self.from.z, &d[i]))
    }

    /// Evaluates y and y' at a time and a point.
    #[inline(always)]
    fn at(&self, (t, z): (R, Y::Phase)) -> At<Y::Phase> {
        At::new(self.from.system, &self.coefficients.kernel, t, z)
    }

    /// Returns the increment of x over the step, which changes y by `change`. Newton's iteration starts from a guess.
    ///
    /// # Errors
    /// If the iteration does not converge, if ∂y/∂x is singular at one of its points, or if det ∂y/∂x has changed its sign.
    fn end(&self, change: &Y::Phase, guess: Y::Phase) -> Result<Y::Phase, Failure> {
        let (Start { y, inverse, .. }, mut is_positive) = (&self.start, true);
        let correction = |d: &Y::Phase| {
            // The time matters for y' only, which is not read here. A rounding of the end time therefore has no effect.
            let at = self.at((self.from.t + self.from.h, sum(&self.from.z, d)));
            let mut delta = inverse.times(&difference(&difference(&at.value, y), change));
            let mut matrix = scaled_rows(inverse, &at.derivatives[VALUE]);
            // The matrix is near 1 in short steps, so its pivots stay on the diagonal. Equal sizes then suffice.
            is_positive = linear::solve(&mut matrix, &mut delta, &Sizes::equal()).ok_or(Failure::Singular)?;
            let relative = Sizes::new().relative(&delta, &self.from.z, &difference(d, &delta));
            Ok(Correction { delta, relative })
        };
        // Corrections that stop shrinking are taken for the rounding of y.
        let d =
            correct(guess, Corrections::of(Convergence::Quadratic), |Stuck { after, .. }| Some(*after), correction)?;
        // The matrix is (∂y/∂x)₀⁻¹ ∂y/∂x, which is 1 at the start of the step. If its determinant is negative at the end, ∂y/∂x was singular on the way.
        if is_positive { Ok(d) } else { Err(Failure::Singular) }
    }
}

/// The equations of all stages for the increments d = xᵢ − x₀. They are multiplied by (∂y/∂x)⁻¹ at the start of the step. Rows then have the units of x,
/// and the matrix is near 1 for short steps. The solver refuses a solution with a negative determinant, if it was found with a matrix.
impl<Y: CanonicalForm<R>, R: Real, const S: usize> ImplicitStep<Y, R> for CanonicalStages<S>
where
    Gauss<S>: GaussTableau<S>,
{
    type Unknown = [Y::Phase; S];
    type Coefficients = Coefficients<Y::CanonicalConstants, R, S>;
    type Start = Start<Y::Phase>;
    type History = ();
    type LastEvaluation = ();
    type Kept = ();
    type Solver = Newton<[Y::Phase; S]>;

    // States without momenta have `ALIKE` = 1: every coordinate may have a unit of its own.
    const POLICY: Policy = Policy::of(Units { alike: Y::State::ALIKE, kinds: Y::Phase::LEN / Y::State::ALIKE });
    const STAGES: usize = S;

    fn coefficients(self, system: &Y, h: R) -> Self::Coefficients {
        Coefficients { kernel: system.canonical_constants(), scaled: Scaled::by(h) }
    }

    fn history() {}

    fn no_evaluation() {}

    #[inline(always)]
    fn begin(
        from: &Departure<'_, Y, R>,
        coefficients: &Self::Coefficients,
        (): &mut (),
    ) -> Result<Self::Start, Failure> {
        let At { value, rate, derivatives } = At::new(from.system, &coefficients.kernel, from.t, from.z);
        let inverse = inverse(&derivatives[VALUE], &from.z).ok_or(Failure::Singular)?;
        Ok(Start { y: value, rate, inverse })
    }

    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, Y, R>) -> [Y::Phase; S] {
        [equation.from.z; S]
    }

    /// Returns the increments of a motion with the constant rate x' = (∂y/∂x)⁻¹ y' of the start.
    fn guess(Equation { coefficients, start, .. }: &Equation<'_, Self, Y, R>) -> [Y::Phase; S] {
        let rate = start.inverse.times(&start.rate);
        coefficients.scaled.nodes.map(|node| scaled(node, &rate))
    }

    #[inline(always)]
    fn residual<P: Probe<Y, R>>(
        equation: &Equation<'_, Self, Y, R>,
        watch: &mut Watch<'_, Y, R, P, ()>,
        d: &[Y::Phase; S],
        matrix: &mut Square<[Y::Phase; S]>,
    ) -> [Y::Phase; S] {
        let Equation { coefficients, start: Start { y, inverse, .. }, .. } = equation;
        let mut stages = [Values::none(); S];
        for (i, stage) in stages.iter_mut().enumerate() {
            let (t, z) = equation.place(i, d);
            watch.visit(t, &z, &());
            let At { value, rate, derivatives } = equation.at((t, z));
            stage.value = inverse.times(&difference(&value, y));
            stage.rate = inverse.times(&rate);
            stage.value_slopes.by_unknown = scaled_rows(inverse, &derivatives[VALUE]);
            stage.rate_slopes.by_unknown = scaled_rows(inverse, &derivatives[RATE]);
        }
        assemble(FORM, &coefficients.scaled.coupling, &stages, None, matrix)
    }

    #[inline(always)]
    fn stage(equation: &Equation<'_, Self, Y, R>, i: usize, d: &[Y::Phase; S]) -> Stage<Y, R> {
        let (t, z) = equation.place(i, d);
        Stage { t, z, s: () }
    }

    #[inline(always)]
    fn update(
        equation: &Equation<'_, Self, Y, R>,
        Solution { x: d, .. }: &Solution<[Y::Phase; S]>,
        (): &(),
    ) -> Result<Increment<Y::Phase, ()>, Failure> {
        // The last evaluation was before the last correction, so y' is evaluated at the solution.
        let mut change = Y::Phase::zero();
        for i in 0..S {
            change.add_scaled(equation.coefficients.scaled.weights[i], &equation.at(equation.place(i, d)).rate);
        }
        Ok(Increment::of(equation.end(&change, d[S - 1])?, ()))
    }
}

/// Returns the product of an inverse and a matrix.
#[inline(always)]
fn scaled_rows<A: Array>(inverse: &Inverted<A>, matrix: &Square<A>) -> Square<A> {
    let mut product = A::fill(A::zero());
    for j in 0..A::LEN {
        let mut column = A::zero();
        for (x, row) in column.as_mut_slice().iter_mut().zip(A::entries_of::<A>(matrix)) {
            *x = row.as_slice()[j];
        }
        let column = inverse.times(&column);
        for (row, x) in A::entries::<A>(&mut product).iter_mut().zip(column.as_slice()) {
            row.as_mut_slice()[j] = *x;
        }
    }
    product
}

/// Returns the inverse of ∂y/∂x at the point `z`. Returns `None` if ∂y/∂x is singular. The sign of its determinant is not read, because only a change of the
/// sign shows a singular point.
///
/// Rows of the matrix have the units of y. Divided by their diagonals, rows have the units of x, as the choice of pivots requires. If a diagonal entry is
/// zero, [`row_scale`] is the largest entry of the row.
#[inline(always)]
fn inverse<A: Array>(matrix: &Square<A>, z: &A) -> Option<Inverted<A>> {
    let (mut scaled_matrix, mut scales, mut sizes) = (*matrix, A::zero(), Sizes::new());
    sizes.include(z, &A::zero());
    let rows = A::entries::<A>(&mut scaled_matrix).iter_mut().zip(scales.as_mut_slice());
    for (i, (row, scale)) in rows.enumerate() {
        *scale = A::Real::from_f64(1.0) / row_scale(row, i);
        *row = scaled(*scale, row);
    }
    let (inverse, _) = Inverted::of(&scaled_matrix, &sizes)?;
    Some(inverse.of_rows_scaled(&scales))
}
