//! Explicit Runge–Kutta methods. By themselves they keep linear invariants only.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// Two bodies; q is the vector between them.
//! #[hamiltonian]
//! fn kepler(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
//!     (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - k / (q[0] * q[0] + q[1] * q[1]).sqrt()
//! }
//!
//! let mut sim = Kepler { m: 2.0, k: 3.0 }.integrator(DOP853, 0.05, State::new([1.0, 0.0], [0.0, 2.5]));
//! let energy = sim.energy();
//! sim.advance(200)?;
//! // The method is accurate for short runs. In long runs the energy error grows linearly with time.
//! assert!((sim.energy() / energy - 1.0).abs() < 1e-9);
//! # Ok::<(), StepError>(())
//! ```

mod euler;
pub mod runge_kutta;
pub mod tableau;
mod tables;

use crate::scalar::Real;
use crate::solving::Failure;
use crate::space::{PerCoordinate, Point, Snapshot, Summation, normalisation};
use crate::system::{Known, PhaseSpace, Poles};

pub use euler::ExplicitEuler;
pub use runge_kutta::RungeKutta;
pub use tables::{DOP853, RK4};

/// Adds the increment of a step, and normalises the quaternions of attitudes. The addition changes the length of a quaternion by the error of the step.
#[inline(always)]
fn add_and_normalise<S: PhaseSpace<R>, R: Real, C: Summation<S::Phase>>(
    x: &mut Point<S::Phase, C, S::Action>,
    increment: &PerCoordinate<S::Phase, S::Action>,
) {
    x.add_everywhere(increment);
    if S::State::ATTITUDES {
        x.add(&normalisation::<S, R>(&x.z));
    }
}

/// Returns whether a mass matrix ∂²L/∂v² may be singular at some state of the system. Known at compile time.
const fn may_be_singular<S: PhaseSpace<R>, R: Real>() -> bool {
    S::SOLVED_FOR_VELOCITIES || Known::<S, R>::OF_MASS
}

/// Refuses a step unless the mass matrix is found to be regular on the straight line from `x` along `increment`. `times` are the times of both ends.
fn check_mass<S: PhaseSpace<R>, R: Real, C>(
    poles: &Poles,
    system: &S,
    times: [R; 2],
    x: &Point<S::Phase, C, S::Action>,
    increment: &PerCoordinate<S::Phase, S::Action>,
) -> Result<(), Failure> {
    let mut end = PerCoordinate::of(x);
    end.add_scaled(R::from_f64(1.0), increment);
    let ends = (times, [&x.z, &end.z], [&x.s, &end.s]);
    Failure::outside(poles.of_mass_between(system, ends))?;
    Failure::outside(system.singular_mass(ends.0, ends.1, ends.2))
}
