//! Implicit methods: an equation for each step, and one driver that solves it.
//!
//! An [`ImplicitStep`] states the equation r(x) = 0 of a step, a guess of x, and the increments of the state that belong to x. The driver predicts x from the steps
//! before, solves the equation to rounding, and refuses a step whose solution is not that of short steps. An [`ImplicitMethod`] names the step of a method for
//! a system. The attributes implement it for the methods of this crate.
//!
//! You can write a method of your own. The following one is the average vector field method for one energy with a potential of degree four:
//!
//! q₁ − q₀ = h (p₀ + p₁)/2m, p₁ − p₀ = −h k ∫₀¹ (q₀ + s d)³ ds with d = q₁ − q₀, solved for d.
//!
//! ```
//! use geoint_runtime::implicit_method;
//! use geoint_runtime::method::implicit::*;
//! use geoint_runtime::method::{Claims, Name, Probe, Refusal};
//! use geoint_runtime::prelude::*;
//!
//! /// A mass on a spring of the third degree.
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
//! type Moving<'a> = Equation<'a, AverageVectorField, Quartic, f64>;
//!
//! /// The mean of the force from q₀ to q₀ + d.
//! fn mean_force(equation: &Moving<'_>, d: f64) -> f64 {
//!     let (k, [[q], _]) = (equation.from.system.k, equation.from.z);
//!     -k * (q.powi(3) + 1.5 * q * q * d + q * d * d + 0.25 * d.powi(3))
//! }
//!
//! impl ImplicitStep<Quartic> for AverageVectorField {
//!     type Unknown = [f64; 1];
//!     type Constants = ();
//!     type Start = ();
//!     type History = ();
//!     type Seen = ();
//!     type Kept = ();
//!     type Solver = Newton<[f64; 1]>;
//!
//!     const POLICY: Policy = Policy {
//!         branch: Branch::OfEnergy,
//!         sums: Sums::Compensated,
//!         evaluated: Evaluated::ByDifferences,
//!         ..Policy::of(Units { alike: 1, kinds: 1 })
//!     };
//!
//!     fn constants(self, _: &Quartic, _: f64) {}
//!     fn history() {}
//!     fn unseen() {}
//!     fn begin(_: &Departure<'_, Quartic, f64>, _: &(), _: &mut ()) -> Result<(), Refusal> {
//!         Ok(())
//!     }
//!
//!     fn origin(equation: &Moving<'_>) -> [f64; 1] {
//!         equation.from.z[0]
//!     }
//!
//!     fn guess(equation: &Moving<'_>) -> [f64; 1] {
//!         [equation.from.h * equation.from.z[1][0] / equation.from.system.m]
//!     }
//!
//!     fn residual<P: Probe<Quartic, f64>>(
//!         equation: &Moving<'_>,
//!         watch: &mut Watch<'_, Quartic, f64, P, ()>,
//!         [d]: &[f64; 1],
//!         [[slope]]: &mut [[f64; 1]; 1],
//!     ) -> [f64; 1] {
//!         let Departure { system, t, h, z: [[q], [p]], .. } = equation.from;
//!         watch.visit(t, &[[q + d], [p]], &());
//!         *slope = 1.0 + h * h / (2.0 * system.m) * system.k * (1.5 * q * q + 2.0 * q * d + 0.75 * d * d);
//!         [d - h / system.m * (p + 0.5 * h * mean_force(equation, *d))]
//!     }
//!
//!     fn update(
//!         equation: &Moving<'_>,
//!         solution: &Solution<[f64; 1]>,
//!         _: &(),
//!     ) -> Result<Increment<[[f64; 1]; 2], ()>, Refusal> {
//!         let [d] = solution.x;
//!         Ok(Increment::of([[d], [equation.from.h * mean_force(equation, d)]]))
//!     }
//! }
//!
//! let system = Quartic { m: 1.3, k: 0.8 };
//! let mut sim = system.integrator(AverageVectorField, 0.2, State::new(1.1, 0.3));
//! let mut other = system.integrator(MeanValue::<2>, 0.2, State::new(1.1, 0.3));
//! let energy = sim.energy();
//! sim.advance(10_000)?;
//! other.advance(10_000)?;
//! assert!((sim.energy() / energy - 1.0).abs() < 1e-13);
//! // Two points of Gauss integrate the force exactly.
//! assert!((sim.state().q - other.state().q).abs() < 1e-9);
//! # Ok::<(), StepError>(())
//! ```

mod driver;
mod method;
mod points;
mod step;
mod watch;

#[doc(hidden)]
pub use driver::{Memory, Prepared};
pub use method::{ImplicitMethod, SolvedBy};
#[doc(hidden)]
pub use method::{MemoryFor, PreparedFor, StepFor, composes_to, is_rough_if_short, keeps};
pub use points::{Arrival, Departure, Increment, Stage};
pub use step::{Branch, Equation, Evaluated, ImplicitStep, Policy, Sums};
pub use watch::Watch;

pub use crate::solving::equation::{Magnitudes, Solution, Solver, Units};
pub use crate::solving::newton::Newton;
pub use crate::solving::quasi_newton::QuasiNewton;
