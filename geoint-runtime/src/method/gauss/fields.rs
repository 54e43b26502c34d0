//! The Gauss step of y' = f(y, t), or of q'' = M⁻¹f(q, t) with y = q. The unknowns are the values kᵢ = f(Yᵢ, t₀ + cᵢh) of all stages. aᵢⱼ, bᵢ and cᵢ are
//! the coefficients, weights and nodes of the method.
//!
//! - y' = f: Yᵢ = y₀ + h Σ aᵢⱼ kⱼ, y₁ = y₀ + h Σ bᵢ kᵢ.
//! - q'' = M⁻¹f: Yᵢ = q₀ + cᵢ h q'₀ + h² Σ (A²)ᵢⱼ M⁻¹kⱼ, q₁ = q₀ + h q'₀ + h² Σ bᵢ(1 − cᵢ) M⁻¹kᵢ, p₁ = p₀ + h Σ bᵢ kᵢ.
//!
//! Both forms are one method (Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2006, II.2.3). The second form has half of the unknowns.

use super::defect;
use super::prepared::Scaled;
use super::{Gauss, GaussTableau};
use crate::method::explicit::tableau::Tableau;
use crate::method::implicit::{Departure, Equation, ImplicitStep, Increment, Policy, Stage, Units, Watch};
use crate::method::{Estimate, Failure, Probe};
use crate::scalar::Real;
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::vector::{difference, scaled, sum};
use crate::space::{Array, PerCoordinate, Snapshot, Square};
use crate::system::Collocation;
use core::array::from_fn;

/// The step with `S` stages that is solved for the values of f at its stages.
#[derive(Clone, Copy, Debug)]
pub struct FieldStages<const S: usize>;

/// The smallest and the largest number S of stages with an error estimate by the defect. With fewer stages, step halving is cheaper, although it solves
/// three equations. With more stages, the margin 4ˢ of the estimate costs too much, and it enlarges rounding too much for tolerances near 10⁻¹².
const ESTIMATED_STAGES: [usize; 2] = [3, 4];

/// The largest number of unknowns of a stage with an estimate. With more, the eliminations of an estimate cost more than the two half steps of step
/// halving.
const MOST_ESTIMATED_UNKNOWNS: usize = 6;

/// Coefficients of a step.
#[derive(Clone, Copy, Debug)]
pub struct Coefficients<P, R, const S: usize> {
    /// Coefficients of the system.
    pub(super) kernel: P,
    /// The table of the method times h.
    pub(super) scaled: Scaled<R, S>,
    /// The weight of kⱼ in Yᵢ: h·A, or h²·A².
    coupling: [[R; S]; S],
    /// The weight of kⱼ in the increment of y: h·b, or h²·b(1 − c).
    increments: [R; S],
}

/// Values that depend on the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<A> {
    /// y₀.
    y: A,
    /// The coordinates that f changes: y₀, or p₀.
    pub(super) changed: A,
    /// q'₀ = ∂T/∂p at p₀, or zero for an equation of first order.
    velocity: A,
}

impl<Y: Collocation<R>, R: Real, const S: usize> Equation<'_, FieldStages<S>, Y, R>
where
    Gauss<S>: GaussTableau<S>,
{
    /// Returns f and ∂f/∂y on the collocation polynomial of the step, at the time `x` after its start. There y₀ changes by x q'₀ plus the `coefficients` times
    /// h·k, or times h²·M⁻¹k.
    #[inline(always)]
    pub(super) fn at<P: Probe<Y, R>>(
        &self,
        probe: &mut P,
        x: R,
        k: &[Y::Unknown; S],
        coefficients: &[f64; S],
    ) -> (Y::Unknown, Square<Y::Unknown>) {
        let h = self.from.h;
        let power = if Y::EQUATION_ORDER.is_first() { h } else { h * h };
        let mut change = scaled(x, &self.start.velocity);
        for (coefficient, k) in coefficients.iter().zip(k) {
            self.from.system.add(&self.coefficients.kernel, R::from_f64(*coefficient) * power, k, &mut change);
        }
        let mut slope = Y::Unknown::fill(Y::Unknown::zero());
        probe.visit(self.from.t + x, &self.point(&change), &());
        (self.field(x, &change, &mut slope), slope)
    }

    /// Returns Yᵢ − y₀ for the values `k` of all stages.
    #[inline(always)]
    fn change(&self, i: usize, k: &[Y::Unknown; S]) -> Y::Unknown {
        let Coefficients { kernel, scaled: Scaled { nodes, .. }, coupling, .. } = self.coefficients;
        let mut change = scaled(nodes[i], &self.start.velocity);
        for j in 0..S {
            self.from.system.add(kernel, coupling[i][j], &k[j], &mut change);
        }
        change
    }

    /// Returns the point after a change of y. If y is q, its momenta are those at the start of the step.
    #[inline(always)]
    fn point(&self, change: &Y::Unknown) -> Y::Phase {
        sum(&self.from.z, &Y::increments(change, &Y::Unknown::zero()))
    }

    /// Returns f after a change of y, at the time `x` after the start of the step. Writes ∂f/∂y to `slope`.
    #[inline(always)]
    fn field(&self, x: R, change: &Y::Unknown, slope: &mut Square<Y::Unknown>) -> Y::Unknown {
        let mut f = Y::Unknown::zero();
        self.from.system.field(&self.coefficients.kernel, self.from.t + x, &sum(&self.start.y, change), &mut f, slope);
        f
    }

    /// Returns f(Yᵢ), writes ∂f/∂y to `slope`, and shows Yᵢ to `watch`.
    #[inline(always)]
    fn stage<P: Probe<Y, R>>(
        &self,
        watch: &mut Watch<'_, Y, R, P, ()>,
        i: usize,
        k: &[Y::Unknown; S],
        slope: &mut Square<Y::Unknown>,
    ) -> Y::Unknown {
        let (node, change) = (self.coefficients.scaled.nodes[i], self.change(i, k));
        watch.visit(self.from.t + node, &self.point(&change), &());
        self.field(node, &change, slope)
    }
}

impl<Y: Collocation<R>, R: Real, const S: usize> ImplicitStep<Y, R> for FieldStages<S>
where
    Gauss<S>: GaussTableau<S>,
{
    type Unknown = [Y::Unknown; S];
    type Coefficients = Coefficients<Y::Constants, R, S>;
    type Start = Start<Y::Unknown>;
    type History = ();
    type LastEvaluation = ();
    type Kept = ();
    type Solver = Newton<[Y::Unknown; S]>;

    const POLICY: Policy = Policy {
        // If all kᵢ are −2p₀/h, the momentum is reversed, and q₁ = q₀. The origin is p₀/h.
        standstill: if Y::EQUATION_ORDER.is_first() { 0.0 } else { -2.0 },
        ..Policy::of(Units { alike: Y::State::ALIKE, kinds: Y::Unknown::LEN / Y::State::ALIKE })
    };
    const STAGES: usize = S;
    const ORDER_OF_ESTIMATE: Option<u32> =
        if ESTIMATED_STAGES[0] <= S && S <= ESTIMATED_STAGES[1] && Y::Unknown::LEN <= MOST_ESTIMATED_UNKNOWNS {
            Some(2 * S as u32)
        } else {
            None
        };

    fn coefficients(self, system: &Y, h: R) -> Self::Coefficients {
        let (kernel, scaled) = (system.constants(), Scaled::by(h));
        if Y::EQUATION_ORDER.is_first() {
            return Coefficients { kernel, scaled, coupling: scaled.coupling, increments: scaled.weights };
        }
        let Tableau { a, b, c } = Gauss::<S>::TABLEAU;
        let square = |i: usize, j: usize| (0..S).map(|k| a[i][k] * a[k][j]).sum();
        Coefficients {
            kernel,
            scaled,
            coupling: from_fn(|i| from_fn(|j| R::from_f64(square(i, j)) * h * h)),
            increments: from_fn(|i| R::from_f64(b[i] * (1.0 - c[i])) * h * h),
        }
    }

    fn history() {}

    fn no_evaluation() {}

    #[inline(always)]
    fn begin(
        from: &Departure<'_, Y, R>,
        coefficients: &Self::Coefficients,
        (): &mut (),
    ) -> Result<Self::Start, Failure> {
        let (y, changed) = Y::start(&from.z);
        Ok(Start { y, changed, velocity: from.system.velocity(&coefficients.kernel, &changed) })
    }

    /// Returns y₀/h, or p₀/h. Rounding of kᵢ is relative to it, because multiples of h·kᵢ are added to y₀, or p₀.
    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, Y, R>) -> [Y::Unknown; S] {
        [scaled(R::from_f64(1.0) / equation.from.h, &equation.start.changed); S]
    }

    /// Returns f at the nodes of a motion with the constant rate y'₀.
    fn guess(equation: &Equation<'_, Self, Y, R>) -> [Y::Unknown; S] {
        let mut slope = Y::Unknown::fill(Y::Unknown::zero());
        let mut rate = equation.start.velocity;
        if Y::EQUATION_ORDER.is_first() {
            rate = equation.field(R::from_f64(0.0), &Y::Unknown::zero(), &mut slope);
        }
        equation.coefficients.scaled.nodes.map(|node| equation.field(node, &scaled(node, &rate), &mut slope))
    }

    #[inline(always)]
    fn image<P: Probe<Y, R>>(
        equation: &Equation<'_, Self, Y, R>,
        watch: &mut Watch<'_, Y, R, P, ()>,
        k: &[Y::Unknown; S],
    ) -> [Y::Unknown; S] {
        from_fn(|i| equation.stage(watch, i, k, &mut Y::Unknown::fill(Y::Unknown::zero())))
    }

    /// Returns kᵢ − f(Yᵢ). Block (i, j) of the matrix is δᵢⱼ − ∂f/∂y(Yᵢ) ∂Yᵢ/∂kⱼ. `stages::assemble` would need the slopes of all stages in memory first:
    /// steps of two and more stages would take 1.1 to 1.8 times as long.
    #[inline(always)]
    fn residual<P: Probe<Y, R>>(
        equation: &Equation<'_, Self, Y, R>,
        watch: &mut Watch<'_, Y, R, P, ()>,
        k: &[Y::Unknown; S],
        matrix: &mut Square<[Y::Unknown; S]>,
    ) -> [Y::Unknown; S] {
        let Coefficients { kernel, coupling, .. } = equation.coefficients;
        let rows = <[Y::Unknown; S]>::entries::<[Y::Unknown; S]>(matrix);
        let mut all = [Y::Unknown::zero(); S];
        // A loop in place of `from_fn`, whose closure is not inlined: the processor would stall when it reads the result in other pieces than it was
        // written in.
        for (i, f) in all.iter_mut().enumerate() {
            let mut slope = Y::Unknown::fill(Y::Unknown::zero());
            *f = equation.stage(watch, i, k, &mut slope);
            for (r, slope_row) in Y::Unknown::entries::<Y::Unknown>(&mut slope).iter().enumerate() {
                let row = &mut rows[i * Y::Unknown::LEN + r];
                for j in 0..S {
                    row[j] = Y::Unknown::zero();
                    equation.from.system.add(kernel, -coupling[i][j], slope_row, &mut row[j]);
                }
                row[i].as_mut_slice()[r] += R::from_f64(1.0);
            }
        }
        difference(k, &all)
    }

    #[inline(always)]
    fn stage(equation: &Equation<'_, Self, Y, R>, i: usize, k: &[Y::Unknown; S]) -> Stage<Y, R> {
        let t = equation.from.t + equation.coefficients.scaled.nodes[i];
        Stage { t, z: equation.point(&equation.change(i, k)), s: () }
    }

    #[inline(always)]
    fn update(
        Equation { from, coefficients, start }: &Equation<'_, Self, Y, R>,
        Solution { x: k, .. }: &Solution<[Y::Unknown; S]>,
        (): &(),
    ) -> Result<Increment<Y::Phase, ()>, Failure> {
        let (mut change, mut impulse) = (scaled(from.h, &start.velocity), Y::Unknown::zero());
        for i in 0..S {
            from.system.add(&coefficients.kernel, coefficients.increments[i], &k[i], &mut change);
            impulse.add_scaled(coefficients.scaled.weights[i], &k[i]);
        }
        Ok(Increment::of(Y::increments(&change, &impulse), ()))
    }

    #[inline]
    fn estimate<P: Probe<Y, R>>(
        equation: &Equation<'_, Self, Y, R>,
        k: &[Y::Unknown; S],
        probe: &mut P,
    ) -> Result<Estimate<Y, R>, Failure> {
        let Equation { from: Departure { system, h, .. }, coefficients, start } = equation;
        let step = defect::Step { system: *system, coefficients: &coefficients.kernel, h: *h, changed: &start.changed };
        let at = |x, coefficients: &[f64; S]| equation.at(probe, x, k, coefficients);
        let z = defect::error(step, k, at).ok_or(Failure::Singular)?;
        // The second estimate, of lower order, is zero: this step has one estimate only.
        Ok([PerCoordinate { z, s: () }, PerCoordinate::zero()])
    }
}
