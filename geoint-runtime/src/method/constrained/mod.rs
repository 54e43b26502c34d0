//! Methods for systems with constraints g(q, t) = 0, as closed chains in Cartesian coordinates have, and A(q, t)v + b(q, t) = 0, as wheels without slip have.
//!
//! Two methods keep constraints of positions to rounding: [`Rattle`], which is symplectic, and [`DiscreteGradient`](crate::DiscreteGradient), which keeps the
//! energy. The latter also keeps constraints of velocities. Constraints must be independent: the rows of ∂g/∂q and A may not depend on each other.
//!
//! ```
//! use geoint_runtime::methods::*;
//! use geoint_runtime::prelude::*;
//!
//! /// A spherical pendulum without angles: a mass m at a distance l of the origin.
//! #[hamiltonian(constraint = [(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - l * l) / 2.0])]
//! fn spherical_pendulum(q: [f64; 3], p: [f64; 3], m: f64, l: f64, g: f64) -> f64 {
//!     (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m) + m * g * q[2]
//! }
//!
//! let system = SphericalPendulum { m: 0.7, l: 1.3, g: 9.81 };
//! // The given state is only near the sphere. `state_on_constraint` moves it onto the sphere, along the gradient of the constraint.
//! let start = system.state_on_constraint(&State::new([1.0, 0.0, -0.8], [0.0, 1.5, 0.0]))?;
//! let mut rattle = system.integrator(Rattle, 0.01, start);
//! let mut gradient = system.integrator(DiscreteGradient, 0.01, start);
//! let energy = gradient.energy();
//! rattle.advance(1000)?;
//! gradient.advance(1000)?;
//! assert!((gradient.energy() - energy).abs() < 1e-12);
//! for q in [rattle.state().q, gradient.state().q] {
//!     let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
//!     assert!((length - 1.3).abs() < 1e-15);
//! }
//! # Ok::<(), StepError>(())
//! ```

mod damped;
mod rattle;
pub(crate) mod step;

pub use damped::DampedRattle;
pub use rattle::Rattle;
