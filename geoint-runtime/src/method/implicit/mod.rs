//! Implicit methods: a trait that states the equation of one step, and a driver that solves the equation.
//!
//! An [`ImplicitStep`] states the equation r(x) = 0 for the unknown x of a step, a guess of x, and the increments of the state that follow from x.
//! The driver lets [`Newton`] or [`QuasiNewton`] solve the equation to rounding, adds the increments, and checks the end of the step. It refuses
//! the step if no solution is found, or if [`Branch`] excludes the solution. It also refuses the step if a pole of the energy on the way is not excluded.
//! An [`ImplicitMethod`] names the step of a method for a kind of system. The attribute macros implement it for the methods of this crate.
//!
//! You can write a method of your own. The program below states the average vector field method (G. R. W. Quispel & D. I. McLaren, J. Phys. A 41
//! (2008) 045206) for the energy p²/2m + k q⁴/4. The unknown is the increment d = q₁ − q₀, and F is the mean of the force on the straight line:
//!
//! d = h (p₀ + h F/2)/m, p₁ = p₀ + h F, F = −k ∫₀¹ (q₀ + s d)³ ds.
//!
//! The energy is kept for every h: F d is the loss of potential energy, and (p₁² − p₀²)/2m = h F (p₀ + h F/2)/m = F d is the gain of kinetic energy.
//!
//! ```
//! use geoint_runtime::implicit_method;
//! use geoint_runtime::method::implicit::*;
//! use geoint_runtime::method::{Claims, Name, Probe, Failure};
//! use geoint_runtime::methods::*;
//! use geoint_runtime::prelude::*;
//!
//! /// A mass m on a spring with the force −k q³.
//! #[hamiltonian]
//! fn quartic(q: f64, p: f64, m: f64, k: f64) -> f64 {
//!     p * p / (2.0 * m) + k * q.powi(4) / 4.0
//! }
//!
//! #[derive(Clone, Copy, Debug)]
//! struct AverageVectorField;
//!
//! implicit_method!(
//!     AverageVectorField,
//!     |_| Name::new("AverageVectorField"),
//!     Claims::of_order(2).symmetric().conserving_energy()
//! );
//!
//! impl ImplicitMethod<Quartic> for AverageVectorField {
//!     type Proof = ();
//!     type Step = Self;
//!
//!     fn step(self) -> Self {
//!         self
//!     }
//! }
//!
//! type StepEquation<'a> = Equation<'a, AverageVectorField, Quartic, f64>;
//!
//! /// Returns the mean F of the force from q₀ to q₀ + d.
//! fn mean_force(equation: &StepEquation<'_>, d: f64) -> f64 {
//!     let (k, [[q], _]) = (equation.from.system.k, equation.from.z);
//!     -k * (q.powi(3) + 1.5 * q * q * d + q * d * d + 0.25 * d.powi(3))
//! }
//!
//! impl ImplicitStep<Quartic> for AverageVectorField {
//!     type Unknown = [f64; 1];
//!     type Coefficients = ();
//!     type Start = ();
//!     type History = ();
//!     type LastEvaluation = ();
//!     type Kept = ();
//!     type Solver = Newton<[f64; 1]>;
//!
//!     const POLICY: Policy = Policy {
//!         // Every solution keeps the energy.
//!         branch: Branch::OfEnergy,
//!         sums: Sums::Compensated,
//!         // F is a divided difference of the potential between both ends.
//!         evaluated: Evaluated::ByDifferences,
//!         // One unknown, and one unit.
//!         ..Policy::of(Units { alike: 1, kinds: 1 })
//!     };
//!
//!     fn coefficients(self, _: &Quartic, _: f64) {}
//!     fn history() {}
//!     fn no_evaluation() {}
//!     fn begin(_: &Departure<'_, Quartic, f64>, _: &(), _: &mut ()) -> Result<(), Failure> {
//!         Ok(())
//!     }
//!
//!     fn origin(equation: &StepEquation<'_>) -> [f64; 1] {
//!         equation.from.z[0]
//!     }
//!
//!     fn guess(equation: &StepEquation<'_>) -> [f64; 1] {
//!         [equation.from.h * equation.from.z[1][0] / equation.from.system.m]
//!     }
//!
//!     fn residual<P: Probe<Quartic, f64>>(
//!         equation: &StepEquation<'_>,
//!         watch: &mut Watch<'_, Quartic, f64, P, ()>,
//!         [d]: &[f64; 1],
//!         [[slope]]: &mut [[f64; 1]; 1],
//!     ) -> [f64; 1] {
//!         let Departure { system, t, h, z: [[q], [p]], .. } = equation.from;
//!         // This energy has no conditions, so a momentum that is not that of the end does no harm.
//!         watch.visit(t, &[[q + d], [p]], &());
//!         *slope = 1.0 + h * h / (2.0 * system.m) * system.k * (1.5 * q * q + 2.0 * q * d + 0.75 * d * d);
//!         [d - h / system.m * (p + 0.5 * h * mean_force(equation, *d))]
//!     }
//!
//!     fn update(
//!         equation: &StepEquation<'_>,
//!         solution: &Solution<[f64; 1]>,
//!         _: &(),
//!     ) -> Result<Increment<[[f64; 1]; 2], ()>, Failure> {
//!         let [d] = solution.x;
//!         Ok(Increment::of([[d], [equation.from.h * mean_force(equation, d)]], ()))
//!     }
//! }
//!
//! let system = Quartic { m: 1.3, k: 0.8 };
//! let mut sim = system.integrator(AverageVectorField, 0.2, State::new(1.1, 0.3));
//! let mut reference = system.integrator(MeanValue::<2>, 0.2, State::new(1.1, 0.3));
//! let energy = sim.energy();
//! sim.advance(10_000)?;
//! reference.advance(10_000)?;
//! assert!((sim.energy() / energy - 1.0).abs() < 1e-13);
//! // `MeanValue` with two Gauss points integrates the cubic force exactly, so it is the same method.
//! assert!((sim.state().q - reference.state().q).abs() < 1e-9);
//! # Ok::<(), StepError>(())
//! ```

mod driver;
mod method;
mod points;
mod step;
mod watch;

#[doc(hidden)]
pub use driver::{Memory, Prepared};
pub use method::{ImplicitMethod, SolvedBy, SteppedBy};
#[doc(hidden)]
pub use method::{MemoryFor, PreparedFor, StepFor, composes_to, handling};
pub use points::{Arrival, Departure, Increment, Stage};
pub use step::{Branch, Equation, Evaluated, ImplicitStep, Policy, Sums};
pub use watch::Watch;

pub use crate::solving::equation::{Magnitudes, Solution, Units};
pub use crate::solving::newton::Newton;
pub use crate::solving::quasi_newton::QuasiNewton;
