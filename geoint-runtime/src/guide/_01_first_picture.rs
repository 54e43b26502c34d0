//! Simulate a pendulum for 3000 swings and see its energy stay constant.
//!
//! Add the crate to a new project beside a clone of the repository `geoint`. It needs Rust 1.89 or later:
//!
//! ```sh
//! cargo new pendulum && cd pendulum
//! cargo add --path ../geoint/geoint-runtime   # after the first release: cargo add geoint-runtime
//! ```
//!
//! Replace `src/main.rs` by this program and start it with `cargo run --release`. The first build takes one to two
//! minutes, later builds take seconds. Programs run up to 60 times slower without `--release`.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// Planar pendulum; q in rad, p in kg m²/s.
//! #[hamiltonian]
//! fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
//!     p * p / (2.0 * m * l * l) - m * g * l * q.cos()
//! }
//!
//! fn main() -> Result<(), StepError> {
//!     let system = Pendulum { m: 1.0, l: 1.0, g: 9.81 };
//!     let mut sim = system.integrator(DiscreteGradient, 0.01, State::new(2.0, 0.0));
//!     let start = sim.energy();
//!     sim.advance(1_000_000)?;
//!     println!("angle {:.3} rad, energy changed by {:.0e} J", sim.state().q, sim.energy() - start);
//! #   assert!((sim.energy() - start).abs() < 1e-13);
//!     Ok(())
//! }
//! ```
//!
//! It takes a fraction of a second and prints a change of the energy near 1e-15 J: the rounding error of a single number.
//!
//! # Line by line
//!
//! - `#[hamiltonian]` reads the energy H(q, p) of the function below it. `q` is the position and `p` the momentum. All other arguments are
//!   parameters.
//! - The attribute adds a struct `Pendulum` with one field for each parameter. It also derives the equations of motion, q' = ∂H/∂p and p' = −∂H/∂q,
//!   when the program is compiled.
//! - [`integrator`](crate::IntoIntegrator::integrator) combines the system with a method, a step size of 0.01 s and a state. `State::new(2.0, 0.0)`
//!   is the angle 2 rad at rest.
//! - [`DiscreteGradient`](crate::DiscreteGradient) keeps the energy to rounding at every step size at which its equation has a solution. If a step is
//!   too long, it returns an error. Constant energy does not mean accurate positions: see [which method](super::_03_which_method).
//!
//! Classical methods do not keep the energy. This is the error of the energy over a million steps, for four methods:
//!
#![doc = include_str!("../../docs/figures/energy_exact.svg")]
//!
//! # The report
//!
//! Every system has a report of its derivatives. Print it with `println!("{}", Pendulum::REPORT)`:
//!
//! ```text
//! H = p²/(2·(m·l²)) - m·l·g·cos(q)
//! ∂H/∂q = m·l·g·sin(q)
//! ∂H/∂p = p/(m·l²)
//! ```
//!
//! It also lists proven properties, for instance that H is the sum of T(p) and V(q). [The report, line by line](super::_05_report) explains the
//! rest.
//!
//! # A table for a plot
//!
//! [`until`](crate::Integrator::until) returns the state after every step. Each state has the fields `t`, `q` and `p`:
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! # #[hamiltonian]
//! # fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
//! #     p * p / (2.0 * m * l * l) - m * g * l * q.cos()
//! # }
//! let system = Pendulum { m: 1.0, l: 1.0, g: 9.81 };
//! let mut sim = system.integrator(DiscreteGradient, 0.01, State::new(2.0, 0.0));
//! println!("t,q,p");
//! for state in sim.until(10.0) {
//!     let state = state?;
//!     println!("{},{},{}", state.t, state.q, state.p);
//! }
//! # Ok::<(), StepError>(())
//! ```
//!
//! # Errors
//!
//! A step returns a [`StepError`](crate::StepError) if its equation cannot be solved or its state is invalid. The state stays as it was
//! before the step. Nothing panics. A step that is merely inaccurate is no error: halve the step size and compare.
//!
//! Next: [which attribute](super::_02_which_attribute) suits your problem, and [which method](super::_03_which_method).
