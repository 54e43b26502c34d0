//! Find a message here, read its meaning, and copy a repair that compiles.
//!
//! This page is generated: each message occurs in a test, and each program compiles. Every message of the compiler points at the term in the way.
//!
//! # When the program is compiled
//!
//! **this term couples positions and momenta, so kick and drift do not exist; use `ImplicitMidpoint`, `Gauss` or `DiscreteGradient`**
//!
//! Splittings need H = T(p) + V(q). The printed term reads q and p. Take a method that needs no splitting, or `PieceSplitting`.
//! ```
//! # use geoint_runtime::{methods::*, prelude::*};
//! #[hamiltonian]
//! fn coupled(q: f64, p: f64) -> f64 {
//!     p * p / (2.0 * q * q + 1.0) + q * q
//! }
//! let _ = Coupled.integrator(DiscreteGradient, 0.1, State::new(1.0, 0.0));
//! ```
//! **so Runge–Kutta–Nyström tables, and those with force gradients, would lose their order; use a table for every separable energy**
//!
//! Methods with `Srkn` in the name need a kinetic energy that is quadratic in p, with constant masses. Others take every T(p) + V(q).
//! ```
//! # use geoint_runtime::{methods::*, prelude::*};
//! #[hamiltonian]
//! fn relativistic(q: f64, p: f64) -> f64 {
//!     (1.0 + p * p).sqrt() + q * q / 2.0
//! }
//! let _ = Relativistic.integrator(BlanesMoan6, 0.1, State::new(1.0, 0.0));
//! ```
//! **an energy of `x` alone does not say how x moves: add S of x' = S(x) ∇H**
//!
//! The argument `x` stands for all coordinates of a general phase space. If x is a position, name it and its momentum.
//! ```
//! # use geoint_runtime::{methods::*, prelude::*};
//! #[hamiltonian(q = x, p = px)]
//! fn spring(x: f64, px: f64, k: f64) -> f64 {
//!     px * px / 2.0 + k * x * x / 2.0
//! }
//! let _ = Spring { k: 1.0 }.integrator(StormerVerlet, 0.1, State::new(1.0, 0.0));
//! ```
//! **the macro cannot see into functions outside of the energy: put `#[energy_function]` above this one**
//!
//! The macro reads one function. A second function is read if both attributes say so.
//! ```
//! # use geoint_runtime::{methods::*, prelude::*};
//! #[energy_function]
//! fn square(x: f64) -> f64 {
//!     x * x
//! }
//! #[hamiltonian(with(square))]
//! fn quartic(q: f64, p: f64) -> f64 {
//!     square(p) / 2.0 + square(square(q))
//! }
//! let _ = Quartic.integrator(StormerVerlet, 0.1, State::new(1.0, 0.0));
//! ```
//! **a length is known when the program is compiled**
//!
//! Loops are unrolled, so the macro needs every length. A constant outside of the function is repeated in the attribute.
//! ```
//! # use geoint_runtime::{methods::*, prelude::*};
//! const N: usize = 3;
//! #[hamiltonian(const N = 3)]
//! fn chain(q: [f64; N], p: [f64; N]) -> f64 {
//!     p.iter().map(|p| p * p).sum::<f64>() / 2.0 + q.windows(2).map(|q| (q[1] - q[0]).powi(4)).sum::<f64>()
//! }
//! let _ = Chain.integrator(StormerVerlet, 0.1, State::new([0.0, 0.1, 0.0], [0.0; 3]));
//! ```
//! **damping takes energy away, but the coefficient of coordinate 0 is -2: write one that is not negative**
//!
//! Methods prove that the energy falls. A motor that feeds energy is a force.
//! ```
//! # use geoint_runtime::{methods::*, prelude::*};
//! #[hamiltonian(force = 2.0 * v)]
//! fn driven(q: f64, p: f64) -> f64 {
//!     p * p / 2.0 + q * q / 2.0
//! }
//! let _ = Driven.integrator(DiscreteGradient, 0.1, State::new(1.0, 0.0));
//! ```
//! | message | meaning and repair |
//! |---|---|
//! | velocities are called `v`; say that they are `qdot`: `v = qdot` | Write `#[lagrangian(v = qdot)]`. |
//! | an integer stands beside a number of type `f64` or `f32` | Write `0.5 * p * p`: Rust has no conversion between integers and floating-point numbers, and 1/2 is 0. |
//! | leave out this, or `structure`, `attitude`, `split`, `coordinates` and `force` | `constraint` excludes these. Write a motor as a term of the energy, see [mechanisms](super::_10_mechanisms). |
//! | rigid bodies are moved by their energy alone | `attitude` excludes `force` and `damping`. Write the equations, see [fields](super::_11_fields). |
//! | is not a method for | Rigid bodies need kicks and drifts such as `BlanesMoanSrkn14a`; contact systems `ContactDiscreteGradient`. |
//! | are no functions of its state | Explicit methods do not keep a `constraint`. Take `Rattle` or `DiscreteGradient`. |
//! | is singular at every state, so that these velocities do not follow from momenta | A motion has no kinetic energy. Give it a mass, or write the equations. |
//! | is not constant along the field: what remains of its derivative is | The named function is no first integral. Correct it, or the field. |
//!
//! # When it runs
//!
//! `step` returns a [`StepError`](crate::StepError): the time `t`, the length `h` of the step, and the [`failure`](crate::Failure). The run still holds the last
//! good state. Change the step, the state or the system, and go on. `error.is_shortest()` tells that an adaptive run has tried shorter steps already.
//!
//! | `failure` | meaning | remedy |
//! |---|---|---|
//! | `InvalidParameter` | a parameter of the system is not a number | set it; the message has its name |
//! | `NonFiniteState`, `InvalidStepSize`, `NotNormalised`, … | an input is not finite, or a quaternion not of length 1 | check it; `r.renormalize()` |
//! | `NoMomentum` | the velocities have no momenta, for instance v > c | choose v inside the domain of L; see [mechanisms](super::_10_mechanisms) |
//! | `OffConstraint` | the state does not satisfy a constraint | start from `system.state_on_constraint(…)` |
//! | `DependentConstraints` | constraints do not determine the motion: bars in one line | start elsewhere, or choose other lengths |
//! | `OutsideDomain`, `Pole` | a root, logarithm, pole or singular mass matrix on the way, or friction that adds energy | shorten the step, or correct the friction; the message has the term |
//! | `NonFinite`, `NotConverged`, `Unsolved`, `Turned` | the step is too long for its equation | shorten the step |
//! | `Singular` | several solutions: long step, dead point of a linkage, parallel gradients of integrals | shorten the step; start elsewhere; `Projection(RK4, Integrals)` |
//! | `LedAstray`, `Rounded` | a correction exceeds half of the step, or rounding changes an invariant | shorten the step; take other units |
//! | `OutOfRange` | a value is too small or too large for `f32` or `f64` | take other units, or `f64` |
//! | `Inaccurate`, `Diverges`, `NoRates`, `Sliding`, `TooManySteps` | an adaptive run or a Taylor series cannot go on: a collision, a jump | stop there; shorten the shortest step; raise `steps_at_most` |
//! | `NoEvent` | the event function is zero all along, or not a number | change the function |
//! | `TimePassed`, `NotInLastStep` | the time lies behind the run; for `at`, outside of the last step | `sampled_at` with times ahead |
//!
//! Next: [limits](super::_18_limits), [a run in practice](super::_06_runs).
