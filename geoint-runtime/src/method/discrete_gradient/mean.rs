//! Steps along a mean of ∇H between their ends: one driver for all of them.

use super::energy::{Energy, Slope};
use super::matrix::turned;
use crate::method::composition::SymmetricMap;
use crate::method::corrected::rounded;
use crate::method::{Name, Probe, Refusal, Step, check_conditions, check_end};
use crate::scalar::Real;
use crate::solving::quasi_newton::QuasiNewton;
use crate::space::Array;
use crate::space::vector::{entries, moved, scaled, sum};
use crate::space::{Compensated, Record, Summation, Tape};
use crate::system::{Conservative, DiscreteField, Poles};

/// A mean g of ∇H between x and x + d: the step is x₁ = x₀ + h J g(x₀, x₁).
///
/// A discrete gradient has g·d = H(x + d) − H(x), and then the energy is kept: d·g = h Jg·g = 0.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a step along a mean of gradients",
    note = "means of order 2: `DiscreteGradient`, `Gonzalez`, `MeanValue`, `SymmetrisedItohAbe`"
)]
pub trait MeanGradient: Copy {
    /// Whether ∂g/∂d is symmetric.
    const CURL_FREE: bool = false;

    /// Whether g is computed from the change of the energy: that must neither underflow nor overflow.
    const OF_ENERGIES: bool = false;

    /// The name of the method.
    fn mean_name(&self) -> Name;

    /// Whether g is a discrete gradient of the system, so that steps keep the energy.
    fn is_exact<S: DiscreteField<R>, R: Real>() -> bool {
        true
    }

    /// g and ∂g/∂d. Something near the latter is enough for the solution to converge, but not for [`FourthOrder`](crate::FourthOrder), which has
    /// its order from it.
    ///
    /// # Errors
    /// Where g does not exist.
    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &S::Phase,
        d: &S::Phase,
    ) -> Result<Slope<S::Array>, Refusal>;
}

/// A symmetric mean for which a modified structure matrix is needed to have order 4. The tree discrete gradient is projected instead.
pub trait Corrected: MeanGradient + SymmetricMap {}

/// Coefficients of a step.
#[derive(Clone, Debug)]
pub struct Prepared<G, S: DiscreteField<R>, R: Real> {
    mean: G,
    constants: S::Constants,
    parameters: S::Parameters,
    h: R,
    poles: Poles,
}

/// What a step hands on to the next one: the compensations of the sums of q and p, and sizes of increments.
#[derive(Clone, Debug)]
pub struct Memory<A: Array> {
    sums: Compensated<[A; 2]>,
    solver: QuasiNewton<[A; 2]>,
}

impl<A: Array> Record<A::Real> for Memory<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.sums.record(tape);
        self.solver.record(tape);
    }
}

impl<A: Array> Memory<A> {
    pub(super) fn new() -> Self {
        Memory { sums: Compensated::new(), solver: QuasiNewton::new() }
    }
}

impl<G: MeanGradient, S: DiscreteField<R> + Conservative<R>, R: Real> Prepared<G, S, R> {
    pub(super) fn new(mean: G, system: &S, h: R) -> Self {
        Prepared { mean, constants: system.constants(), parameters: system.parameters(h), h, poles: Poles::of(system) }
    }

    #[inline]
    pub(super) fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        Memory { sums, solver }: &mut Memory<S::Array>,
        Step { system, t, end, x: point, probe }: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let Prepared { mean, constants, parameters, h, poles } = self;
        let (n, half) = (S::Array::LEN, R::from_f64(0.5) * *h);
        let mut energy = Energy { system, constants, parameters, probe, t: t + half, h: *h };
        let x = point.z;
        // The explicit midpoint rule.
        let rate = turned(&energy.gradient(t, &x).g);
        let rate = turned(&energy.gradient(t + half, &moved(&x, half, &rate)).g);
        let guess = scaled(*h, &rate);
        // The end of the step at which conditions of the energy were decided last.
        let mut decided = x;
        let d = solver.solve(&x, guess, &mut energy, |energy, d, residual, matrix| {
            let Slope { g, mut derivative } = mean.between(energy, &x, d)?;
            if !S::JUMPS.is_empty() {
                decided = sum(&x, d);
            }
            // d − h J g and 1 − h J ∂g/∂d.
            *residual = moved(d, -*h, &turned(&g));
            let (derivative, rows) = (derivative.rows(), <S::Phase>::entries::<S::Phase>(matrix));
            for i in 0..n {
                rows[i] = scaled(-*h, &derivative[n + i]);
                rows[n + i] = scaled(*h, &derivative[i]);
            }
            for (i, row) in rows.iter_mut().enumerate() {
                entries(row)[i] += R::from_f64(1.0);
            }
            Ok(())
        })?;
        point.add_with(sums, &d, &S::Phase::zero());
        if G::is_exact::<S, R>() {
            point.doubtful |= !P::EFFORT.is_thorough() && solver.leaves_rounding;
            rounded::check_step::<S, R, P, C>(system, [t, end], &x, point)?;
        }
        check_conditions(system, t + half, &decided, point)?;
        check_end(poles, &(x, ()), Step { system, t, end, x: point, probe })
    }
}
