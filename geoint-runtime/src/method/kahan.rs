//! Kahan's method for energies of degree 3. It solves one linear system a step.
//!
//! ```
//! use geoint_runtime::methods::*;
//! use geoint_runtime::prelude::*;
//!
//! /// A star in a galaxy. M. Hénon & C. Heiles, Astron. J. 69 (1964) 73.
//! #[hamiltonian]
//! fn henon_heiles(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
//!     let [x, y] = q;
//!     (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + (x * x + y * y) / 2.0 + x * x * y - y * y * y / 3.0
//! }
//!
//! let mut sim = HenonHeiles { m: 1.3 }.integrator(Kahan, 0.1, State::new([0.1, -0.2], [0.3, 0.25]));
//! let energy = sim.energy();
//! sim.advance(100_000)?;
//! // The method keeps a modified energy near H, so the error of H does not grow.
//! assert!((sim.energy() / energy - 1.0).abs() < 1e-2);
//! # Ok::<(), StepError>(())
//! ```

use crate::method::composition::substeps;
use crate::method::{Claims, Failure, Method, Name, Probe, Step};
use crate::scalar::Real;
use crate::solving::linear;
use crate::solving::size::Sizes;
use crate::space::Array;
use crate::space::Summation;
use crate::system::QuadraticField;

/// x₁ = x₀ + h (1 − h/2 f'(x₀))⁻¹ f(x₀). For quadratic f this is (x₁ − x₀)/h = 2f(m) − ½f(x₀) − ½f(x₁) with the midpoint m.
///
/// Order 2, symmetric, for H of degree 3 at most. One linear solve a step, no iteration. For autonomous systems it keeps
/// H + ⅓∇H(x₀)·(x₁ − x₀) to rounding for every h, and a volume form. It does not keep H. E. Celledoni, R. I. McLachlan,
/// B. Owren & G. R. W. Quispel, J. Phys. A 46 (2013) 025201.
#[doc(alias = "Hirota-Kimura")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Kahan;

impl<S: QuadraticField<R>, R: Real> Method<S, R> for Kahan {
    type Proof = <S as QuadraticField<R>>::Proof;
    type Prepared = (S::Constants, R);
    type Memory = ();

    fn claims(&self) -> Claims {
        Claims {
            order: 2,
            symmetric: true,
            symplectic: false,
            conserves_energy: false,
            perturbed: &[],
            forces: Some(1),
        }
    }

    fn name(&self) -> Name {
        Name::new("Kahan")
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        (system.constants(), h)
    }

    fn memory(_: &S::Phase) {}

    /// If T is quadratic, only the impulse is unknown: the increment of q is h ∂T/∂p at the mean momentum.
    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        (constants, h): &Self::Prepared,
        (): &mut (),
        Step { system, t, x, probe, .. }: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        let (zero, one, half) = (S::Unknown::zero(), R::from_f64(1.0), R::from_f64(0.5) * *h);
        probe.visit(t, &x.z, &());
        let (y, changed) = S::start(&x.z);
        let (mut f, mut matrix) = (zero, S::Unknown::fill(zero));
        system.field(constants, t + half, &y, &mut f, &mut matrix);

        // Linear system: (1 − h/2 f'·∂dy/∂impulse) impulse = h f + h/2 f'·dy₀, with the increment dy of y, and dy₀ for zero impulse.
        let velocity = system.velocity(constants, &changed);
        let w = if S::EQUATION_ORDER.is_first() { -half } else { -half * half };
        let mut impulse = zero;
        for (i, row) in S::Unknown::entries::<S::Unknown>(&mut matrix).iter_mut().enumerate() {
            let slope = core::mem::replace(row, zero);
            let bend = slope
                .as_slice()
                .iter()
                .zip(velocity.as_slice())
                .fold(f.as_slice()[i], |sum, (a, v)| (half * *a).multiply_add(*v, sum));
            impulse.as_mut_slice()[i] = *h * bend;
            system.add(constants, w, &slope, row);
            row.as_mut_slice()[i] += one;
        }
        let sizes = Sizes::along([&changed, &impulse]);
        match linear::solve(&mut matrix, &mut impulse, &sizes) {
            Some(true) if impulse.is_finite() => {}
            _ => return Err(Failure::Singular),
        }
        let change = if S::EQUATION_ORDER.is_first() {
            impulse
        } else {
            let (mut mean, mut change) = (changed, zero);
            mean.add_scaled(R::from_f64(0.5), &impulse);
            change.add_scaled(*h, &system.velocity(constants, &mean));
            change
        };
        x.add(&S::increments(&change, &impulse));
        Ok(())
    }
}

substeps!([] Kahan);
