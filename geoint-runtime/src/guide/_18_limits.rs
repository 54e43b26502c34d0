//! Find out whether your problem fits this crate before you start: the limits of size, step, accuracy and platform.
//!
//! A long step can miss a short pulse. Bound the steps by the width of the pulse, and their number by the time that you can spend:
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// A free mass that is hit at t = 5 for about a millisecond.
//! #[hamiltonian]
//! fn hit(q: f64, p: f64, t: f64, width: f64) -> f64 {
//!     p * p / 2.0 - q * (-((t - 5.0) / width).powi(2)).exp()
//! }
//!
//! fn main() -> Result<(), StepError> {
//!     let system = Hit { width: 1e-3 };
//!     let start = State::new(0.0, 1.0);
//!     let expected = 1.0 + 1e-3 * std::f64::consts::PI.sqrt();
//!     let mut missed = system.adaptive(DOP853, 1e-9, start);
//!     missed.advance_to(10.0)?; // 5 steps, and the momentum is still 1
//!     let mut found = system.adaptive(DOP853, 1e-9, start).longest_step(1e-3).steps_at_most(20_000);
//!     found.advance_to(10.0)?; // 10 007 steps
//!     println!("error of p: {:.0e} and {:.0e}", missed.state().p - expected, found.state().p - expected);
//! #   assert!((missed.state().p - 1.0).abs() < 1e-9 && missed.steps() < 10);
//! #   assert!((found.state().p - expected).abs() < 1e-10);
//! #   let mut short = system.adaptive(DOP853, 1e-9, start).longest_step(1e-3).steps_at_most(100);
//! #   assert!(matches!(short.advance_to(10.0), Err(StepError { failure: Failure::TooManySteps { .. }, .. })));
//!     Ok(())
//! }
//! ```
//!
//! # Size and compile time
//!
//! - The number of coordinates is known at compile time. A size from a file needs [traits by hand](super::_14_by_hand).
//! - Loops over coordinates are unrolled. An energy has at most 5000 operations; more is a compile error.
//! - The limit is near 40 bodies in one dimension and near 20 in three, if every pair interacts. A chain may have 200 masses on a line or 150 in space.
//! - Sums over neighbours, with 16 or more equal terms, become loops again in the generated code. Sums over all pairs stay unrolled.
//! - Only the methods that a program uses are compiled.
//! - Set `opt-level = 3` under `[profile.dev.build-override]` in Cargo.toml. The macros then run faster.
//!
//! Compile time of n bodies, every pair interacting, release profile, seconds of one core:
//!
//! | n | dimension | `StormerVerlet` | `DiscreteGradient` |
//! |---|---|---|---|
//! | 8 | 1 | 0.5 | 1.2 |
//! | 16 | 1 | 1.6 | 5 |
//! | 24 | 1 | 4 | 13 |
//! | 40 | 1 | 25 | not measured |
//! | 8 | 3 | 4 | not measured |
//! | 16 | 3 | 17 | not measured |
//! | 20 | 3 | 34 | not measured |
//! | 24 | 3 | more than 5000 operations | |
//!
//! # Implicit steps
//! The report states the number of unknowns. For T quadratic with a constant mass matrix, and for mechanisms with three or more coupled
//! velocities, it is the number of coordinates; otherwise twice this number.
//!
//! | unknowns | solution of a step | cost |
//! |---|---|---|
//! | 1 to 12 | Newton's method with elimination | small |
//! | more than 12, step short compared with the fastest oscillation | fixed-point iteration | n for chains, n² for all pairs |
//! | more than 12, longer step | Newton's method with a full matrix | n³, also for chains |
//!
//! - Sparse and banded matrices are not used. For long chains prefer explicit methods, such as
//!   [`BlanesMoanSrkn14a`](crate::BlanesMoanSrkn14a).
//! - Compositions of implicit steps store their history in the run. A run of several hundred kilobytes can overflow the stack in a build without
//!   optimisation. Start a thread with a larger stack.
//!
//! # Step size and stiffness
//!
//! - An explicit step that is too long makes the energy grow without bound. [`StormerVerlet`](crate::StormerVerlet) needs h ω < 2 for the highest
//!   frequency ω. The run gives no error until a number overflows: check the energy.
//! - [`DiscreteGradient`](crate::DiscreteGradient) keeps the energy for long steps, but the phase of a fast oscillation is wrong.
//! - Stiff dissipative equations, such as chemical kinetics, are not the purpose of this crate. No method is L-stable: a long step leaves a fast
//!   decay as an oscillation. High gains of a controller and strong friction need small steps, or friction by `damping`.
//! - Long runs: the position error of a symplectic method grows in proportion to time.
//! - Chaotic orbits: every method loses digits exponentially. Statistics and the energy remain meaningful.
//! - A step that is much too long for an implicit equation is refused, for instance with [`NotConverged`](crate::Failure::NotConverged).
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! #[hamiltonian]
//! fn spring(q: f64, p: f64, k: f64) -> f64 { p * p / 2.0 + k * q * q / 2.0 }
//!
//! let start = State::new(1.0, 0.0); // ω = 100
//! let energy = |h: f64| {
//!     let mut sim = Spring { k: 1e4 }.integrator(StormerVerlet, h, start);
//!     sim.advance(100).map(|()| sim.energy())
//! };
//! assert!(energy(0.0199)? < 1e4); // h ω = 1.99: bounded
//! assert!(energy(0.0201)? > 1e20); // h ω = 2.01: wrong, without an error
//! # Ok::<(), StepError>(())
//! ```
//!
//! # What a long step can miss
//!
//! - Adaptive runs and Taylor series test the force at points on the way of a step. A pulse much narrower than every visible scale stays unseen.
//! - In a fast oscillation, the error estimate already limits the steps, and the run tests no points. Pulses narrower than one step stay unseen.
//! - Taylor series of an energy with `if`, `abs`, `min` or `max` test no points: such an energy changes its formula on the way.
//! - Two zeros of an event function within one step can be missed, except by Taylor series. See [events](super::_12_events).
//!
//! # Accuracy and scalars
//!
//! - `f64` and `f32` only; no complex numbers. An energy for `f32` is written with `f32` in its arguments.
//! - `f32` carries seven digits. "Up to rounding" then means 1e-7. Small steps gain by `.compensated()`. Times in long runs lose digits, and events
//!   directly after an impact can be missed: restart the clock as in [real time](super::_13_real_time).
//! - Runs, steps and events need neither `std` nor `alloc`: `default-features = false`. Saving a run needs `alloc`.
//! - Momenta and Casimirs that are kept up to rounding drift like a random walk. Energies and named integrals do not.
//! - Results on two processors can differ in the last bit. The feature `strict-math` forbids fused operations, so that
//!   processors of one platform agree. Platforms agree by the [recipe for the same bits](super::_13_real_time).
//! - Compilers make errors. If a release build and a debug build differ by more than rounding, see [`WisdomHolmanGradient`](crate::WisdomHolmanGradient).
//!
//! # Not supported
//!
//! - GPUs, parallel steps, sparse matrices, partial differential equations, stochastic and delay equations.
//! - Taylor series for rigid bodies (`attitude = r`), constraints, and Lagrangians with three or more coupled velocities.
//! - `force` together with `constraint` or `rolling`, and `rolling` beside an action: a motor in a closed chain is possible only by a potential, such as a term `- f * q[0]` in H.
//! - Functions of other crates inside an energy. See [the language](super::_04_language) and [traits by hand](super::_14_by_hand).
//!
//! Next: [traits by hand](super::_14_by_hand), [errors and remedies](super::_16_errors), [which method](super::_03_which_method).
