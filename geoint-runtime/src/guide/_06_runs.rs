//! Choose a step size, run to a time, change parameters, write files, sweep parameters, and save a run.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! #[hamiltonian] // Planar pendulum; q in rad, p in kg m²/s.
//! fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 { p * p / (2.0 * m * l * l) - m * g * l * q.cos() }
//!
//! /// The angle after 10 s, in steps of length h.
//! fn angle(h: f64) -> Result<f64, StepError> {
//!     let mut sim = Pendulum { m: 1.0, l: 1.0, g: 9.81 }.integrator(BlanesMoanSrkn14a, h, State::new(1.0, 0.0));
//!     sim.advance_to(10.0)?;
//!     Ok(sim.state().q)
//! }
//! let (coarse, fine) = (angle(0.2)?, angle(0.1)?);
//! println!("{fine} rad, error below {:.0e} rad", (fine - coarse).abs()); // -0.463 rad, error below 3e-9 rad
//! # assert!((angle(0.0125)? - fine).abs() < (fine - coarse).abs() && (fine - coarse).abs() < 4e-9);
//! # Ok::<(), StepError>(())
//! ```
//! # The step size
//!
//! Let T be the period of the fastest oscillation in your system, or of the driving if it is faster. Take the first h from this table. Then halve h
//! until the result changes by less than your tolerance. The difference of two runs estimates the error of the coarser run.
//!
//! | method | error 10⁻² | error 10⁻³ | error 10⁻⁶ | error 10⁻⁹ | unstable above |
//! |---|---|---|---|---|---|
//! | `StormerVerlet` | T/100 | T/340 | T/11 000 | | 0.318 T |
//! | `DiscreteGradient`, `ImplicitMidpoint` | T/140 | T/430 | T/14 000 | | none |
//! | `RK4` | T/16 | T/23 | T/160 | T/940 | 0.45 T |
//! | `BlanesMoan4` | T/4 | T/8 | T/41 | T/240 | 0.49 T |
//! | `Gauss::<3>` | T/4 | T/7 | T/19 | T/61 | none |
//! | `DOP853` | T/3 | T/5 | T/12 | T/24 | 0.94 T |
//! | `BlanesMoanSrkn14a`; with friction begin likewise with `BlanesMoanSrkn11b` | T/2 | T/4 | T/7 | T/17 | 0.97 T |
//!
//! Measured on a pendulum with m g l = 1, m l² = 1 and amplitude 1 rad: the largest error of (q, p) in ten periods. The last column is the limit for
//! a harmonic oscillator; *none* means stable up to 4.9 T. The phase error of a symplectic method grows in proportion to time. Costs of a step
//! differ: `StormerVerlet` evaluates one force, `BlanesMoan4` six, `BlanesMoanSrkn14a` fourteen. See [which method](super::_03_which_method).
//!
//! For planets, T is the shortest orbital period, and on an eccentric orbit 2π r/v with distance r and speed v at the perihelion. The steps of
//! [methods for planets](super::_09_planets) are at most T/8. Under `system.adaptive(method, tolerance, state)` and `system.taylor(Taylor { tolerance
//! }, state)` the run chooses the step size. The tolerance is relative to the largest size of each coordinate so far. Divide it by 10 and compare.
//! `longest_step(h)` and `steps_between(a, b)` bound the steps.
//! # Where a run stops
//! | call | fixed steps | adaptive and Taylor |
//! |---|---|---|
//! | `step()`, `advance(n)`, `sampled(k)` | after 1, n, every k steps | after 1, n, every k steps |
//! | `advance_to(t)`, `until(t)` | after the last whole step that does not pass t | exactly at t |
//! | `sampled_every(dt)` | yields states exactly at t₀, t₀ + dt, …; the run itself ends past the last one | as for fixed steps |
//! | `until_event(t, direction, g)` | at the event, or exactly at t | at the event, or exactly at t |
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! # #[hamiltonian]
//! # fn oscillator(q: f64, p: f64, k: f64) -> f64 { p * p / 2.0 + k * q * q / 2.0 }
//! let (system, start) = (Oscillator { k: 1.0 }, State::new(1.0, 0.0));
//! let mut fixed = system.integrator(StormerVerlet, 0.3, start);
//! fixed.advance_to(1.0)?; // whole steps: 0.3, 0.6, 0.9
//! assert!((fixed.time() - 0.9).abs() < 1e-12);
//! let mut adaptive = system.adaptive(DOP853, 1e-9, start);
//! adaptive.advance_to(1.0)?;
//! assert_eq!(adaptive.time(), 1.0);
//! fixed.set_system(Oscillator { k: 4.0 }); // New parameters. Time, q, p and step size stay: a new mass m changes the velocity p/m.
//! # assert!((fixed.time() - 0.9).abs() < 1e-12 && fixed.system().k == 4.0);
//! println!("t,q,p"); // CSV. Redirect it: cargo run --release > run.csv
//! for state in adaptive.sampled_every(0.1).take(11) {
//!     let state = state?;
//!     println!("{},{},{}", state.t, state.q, state.p);
//! }
//! # Ok::<(), StepError>(())
//! ```
//! # Many runs, many steps
//! Systems and states are `Copy`. Runs are `Clone`, `Send` and `Sync`. With the crate `rayon`, a parameter sweep is one parallel iterator:
//!
//! ```text
//! let ends: Result<Vec<_>, StepError> = lengths.par_iter().map(|&l| {
//!     let mut sim = Pendulum { m: 1.0, l, g: 9.81 }.integrator(StormerVerlet, 0.01, start);
//!     sim.advance(1000).map(|()| sim.state())
//! }).collect();
//! ```
//!
//! `.integrator(…).compensated()` carries the rounding errors of sums to the next step. In a million steps of 0.001, `BlanesMoanSrkn14a` changed the
//! energy of a pendulum by 1.8·10⁻¹³ with plain sums, and by less than 10⁻¹⁵ with compensated sums. Adaptive and Taylor runs always compensate.
//! # A method chosen by name, saved and resumed
//! Every run has `saved()` and `resume(&saved)` of [`Resumable`](crate::running::Resumable). [`Named`](crate::running::Named) chooses a method by its
//! name:
//! ```standalone_crate
//! use geoint_runtime::{method::catalogue, prelude::*, running::{DynTrajectory, Named, UnknownMethod}};
//! # #[hamiltonian]
//! # fn oscillator(q: f64, p: f64, k: f64) -> f64 { p * p / 2.0 + k * q * q / 2.0 }
//! # fn run<T: Clone + Send + Sync>(_: T) {} fn copied<T: Copy>(_: T) {}
//! # run(Oscillator { k: 1.0 }.integrator(RK4, 0.3, State::new(1.0, 0.0))); copied((Oscillator { k: 1.0 }, State::new(1.0, 0.0)));
//! fn start(name: &str) -> Result<DynTrajectory<Oscillator>, UnknownMethod> {
//!     let mut named = Named::new(name, Oscillator { k: 1.0 }, 0.01, State::new(1.0, 0.0));
//!     catalogue::general(&mut named); // Gauss<3>, RK4, DOP853, …
//!     catalogue::separable(&mut named); // StormerVerlet, BlanesMoan6, Yoshida4 of StormerVerlet, …
//!     // catalogue::discrete_gradient: DiscreteGradient, Suzuki4 of DiscreteGradient, …
//!     named.run()
//! }
//! for name in ["Gauss<3>", "KahanLi8_17a of StormerVerlet"] {
//!     let mut run = start(name)?; // Or an error with the nearest names.
//!     run.advance(500)?;
//!     let saved = run.saved();
//!     let mut resumed = start(name)?;
//!     resumed.resume(&saved)?; // The same method, system and scalar type.
//!     run.advance(500)?;
//!     resumed.advance(500)?;
//!     assert_eq!(run.state(), resumed.state()); // the same bits
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The compiler builds every method of each [catalogue](crate::method::catalogue). Four catalogues for a pendulum took 48 s to compile.
//! [`Saved`](crate::running::Saved) implements `Serialize` and `Deserialize` with the feature `serde`. [`resume`](crate::running::Resumable::resume)
//! takes time, state, fixed step size and the method's history from the saved run. Parameters, tolerances and bounds of steps are not saved: set them
//! in the new run.
//!
//! A failed step returns a [`StepError`](crate::StepError); the run keeps its last good state. Call `set_step_size` with a smaller step and continue.
//!
//! Next: [events and states between steps](super::_12_events), [games and real time](super::_13_real_time), [errors and remedies](super::_16_errors).
