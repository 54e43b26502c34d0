//! Check any claim of this documentation yourself: this page says how each claim is supported, and how to repeat the check.
//!
//! A claim about an order is checked in a few lines. Halve the step, and compare both errors with a Taylor series:
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! #[hamiltonian]
//! fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
//!     p * p / (2.0 * m * l * l) - m * g * l * q.cos()
//! }
//!
//! fn main() -> Result<(), StepError> {
//!     let system = Pendulum { m: 0.7, l: 1.2, g: 9.81 };
//!     let start = State::new(2.0, 0.0);
//!     let mut reference = system.taylor(Taylor::default(), start);
//!     reference.advance_to(5.0)?;
//!     let error = |steps: u64| -> Result<f64, StepError> {
//!         let mut sim = system.integrator(BlanesMoan4, 5.0 / steps as f64, start);
//!         sim.advance(steps)?;
//!         Ok((sim.state().q - reference.state().q).abs())
//!     };
//!     let order = (error(100)? / error(200)?).log2();
//!     println!("observed order {order:.2}, claimed 4");
//! #   assert!((order - 4.0).abs() < 0.1, "{order}");
//!     Ok(())
//! }
//! ```
//!
//! # Three kinds of support
//!
//! | kind | when | a failure is |
//! |---|---|---|
//! | proof | the attribute derives the fact, in exact arithmetic | a compile error that names the term |
//! | check | every step tests the fact at the current state | a [`StepError`](crate::StepError); the state stays |
//! | measurement | tests of the project compare with known solutions | a failing test |
//!
//! Proven at compile time, from the formula alone:
//!
//! - H = T(p) + V(q), T quadratic with a constant mass matrix, H a polynomial of degree n. Methods require these facts as trait bounds.
//! - Conserved momenta of H, and f·∇I = 0 for each integral I of a field.
//! - S is skew, S satisfies Jacobi's identity, C is a Casimir. Constraints are independent functions of q.
//! - `split = "A | B"` adds up to H. Each piece is an instance of a family whose flow is known in closed form.
//! - The places where H may jump (`if`, `atan2`) or has poles (1/r), and the signs of terms: a sum of squares is never negative.
//!
//! Identities are multiplied out. Very long ones are evaluated at points of finite fields instead. The report then states the error probability.
//!
//! ```compile_fail
//! # use geoint_runtime::prelude::*;
//! #[hamiltonian] // q and p are coupled: kicks and drifts do not exist
//! fn swinging(q: f64, p: f64) -> f64 {
//!     p * p * (1.0 + q * q) / 2.0 + q * q / 2.0
//! }
//! let sim = Swinging.integrator(StormerVerlet, 0.1, State::new(1.0, 0.0)); // error: the term is p²·(q² + 1)/2
//! ```
//!
//! Checked in each step:
//!
//! - The solution of an implicit step is converged to rounding, and continuous in h. Otherwise the step is refused.
//! - Arguments of roots, logarithms and divisions lie in their domain. An implicit step has no pole on the line between its ends.
//! - The mass matrix is regular, constraints hold at the start, damping removes energy, quaternions have length one.
//! - Every 1024 steps, discrete gradients and projections compare the kept integrals with the start, and remove the rounding error.
//!
//! Only measured:
//!
//! - Orders and error constants of the tables, and the rounding errors of the functions of the language.
//! - Run times, and the growth of rounding errors over long runs.
//! - The accuracy of your own run. Repeat it with half the step or another method.
//!
//! # Repeat the measurements
//!
//! Clone the repository and run a command in its root:
//!
//! | question | command | result |
//! |---|---|---|
//! | Do all claims hold? | `cargo run --release -p geoint-verification` | VERIFICATION.md; fails if one claim fails |
//! | Do the essential tests pass? | `cargo test` | about five minutes on two cores |
//! | Do all tests pass? | `cargo test --workspace` | much longer |
//! | Which method is fastest? | `cargo run --release --manifest-path tests/rivals/Cargo.toml` | tables, figures; `-- pendulum`: one problem |
//! | Which hard runs fail? | `cargo test --profile bench -p geoint-tests --test stress -- --ignored` | tests/stress/README.md |
//! | How fast is a step? | `cargo bench -p geoint-benches --bench step` | ratios to hand-written steps |
//! | Are the figures true? | `cargo run --release -p geoint-examples --example energy_exact` | one program for each figure |
//!
//! VERIFICATION.md has one row for each method: claimed and observed order, error constants, symmetry, symplectic form, energy error over 2000 steps,
//! force evaluations, allocations. It also has one row for each function, each example, and each sentence of a report.
//!
//! # Tests beyond single systems
//!
//! - Random systems: the macros receive random tokens, random formulas and damaged energies. They must not panic. Some of the systems are compiled,
//!   and their Taylor coefficients are compared with a second algorithm.
//! - Corpus: the generated code of every annotated function of the repository is hashed. A change of one function is visible.
//! - Controls: a method without the property, such as [`ExplicitEuler`](crate::ExplicitEuler), must fail the same test.
//! - References: solutions to 20 digits and more, published numbers, and other programs.
//! - Equal bits: optimised and unoptimised builds, saved and resumed runs end at the same bits.
//!
//! # Comparison with other crates
//!
//! The work-precision tables compare with `ode_solvers`, `differential-equations`, `diffsol`, `scirs2-integrate` and hand-written steps. They cover
//! eleven problems and errors from 1e-3 to 1e-12, on x86-64 with AVX-512. The best method here took at most 0.56 of the time of the best other crate,
//! and 0.09 for the outer planets at errors of 1e-9 and more. Two warnings:
//!
//! - The winner is the best of many methods here. A method chosen without a comparison can be slower than another crate.
//! - Some discrete-gradient steps take up to 1.6 times the time of a hand-written step.
//!
//! Next: [limits](super::_18_limits), [the report](super::_05_report), [which method](super::_03_which_method).
