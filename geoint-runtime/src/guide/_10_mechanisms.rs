//! Simulate a mechanism from its Lagrangian. You give angles and their rates. The momenta and the mass matrix are derived.
//!
//! The function returns L(q, v): kinetic minus potential energy. `q` are the coordinates and `v` their rates, q' = v.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// Two links in a vertical plane; q angles from below in rad, v their rates in rad/s.
//! #[lagrangian(rayleigh = friction * (v[0] * v[0] + v[1] * v[1]) / 2.0, force = [0.0, torque])]
//! fn arm(q: [f64; 2], v: [f64; 2], m: [f64; 2], l: [f64; 2], g: f64, friction: f64, torque: f64) -> f64 {
//!     let (mut vx, mut vy, mut height, mut sum) = (0.0, 0.0, 0.0, 0.0);
//!     for i in 0..2 {
//!         vx += l[i] * v[i] * q[i].cos();
//!         vy += l[i] * v[i] * q[i].sin();
//!         height -= l[i] * q[i].cos();
//!         sum += m[i] * (vx * vx + vy * vy) / 2.0 - m[i] * g * height;
//!     }
//!     sum
//! }
//!
//! fn main() -> Result<(), StepError> {
//!     let (h, friction) = (0.01, 0.05);
//!     let system = Arm { m: [1.0, 0.6], l: [1.0, 0.8], g: 9.81, friction, torque: 0.0 };
//!     let mut sim = system.integrator(DiscreteGradient, h, system.at([0.0, 1.4], [0.0, 0.0]));
//!     let (start, mut work, mut heat) = (sim.energy(), 0.0, 0.0);
//!     for _ in 0..1000 {
//!         let before = sim.state();
//!         let torque = -2.0 * (before.q[1] - 0.5) - 0.3 * sim.velocity()[1];
//!         sim.set_system(Arm { torque, ..*sim.system() }); // held during the step
//!         sim.step()?;
//!         let rate = [0, 1].map(|i| (sim.state().q[i] - before.q[i]) / h);
//!         work += h * torque * rate[1];
//!         heat += h * friction * (rate[0] * rate[0] + rate[1] * rate[1]);
//!     }
//!     assert!((sim.energy() - start - work + heat).abs() < 1e-13); // the energy balance is closed
//!     Ok(())
//! }
//! ```
//!
//! - [`State::new`](crate::State::new) takes q and the **momenta** p = ∂L/∂v. `system.at(q, v)` takes velocities. Use `at` for every start.
//! - `sim.velocity()` returns the rates. `system.velocity(&state)` and `system.momentum(t, q, v)` convert.
//! - The energy is H = p·v − L. It equals T + V if L = T − V and T is quadratic in v. The report states both.
//! - `set_system` changes parameters between steps. A feedback law of q and v may also stand in `force` itself.
//!
//! # Friction and motors
//!
//! `force = F(q, v, t)` is added to p', one entry for each coordinate. `rayleigh = R(q, v, t)` adds the friction force −∂R/∂v. The function
//! R = c v²/2 gives viscous friction with the coefficient c. Dry friction is R = c √(v² + ε²). A step that would feed energy by R is refused.
//!
//! A step of [`DiscreteGradient`](crate::DiscreteGradient) changes the energy by exactly h v̄·F − h v̄·∂R/∂v. Here v̄ = (q₁ − q₀)/h is the
//! displacement divided by h, not the mean of the velocities at both ends. F and ∂R/∂v are evaluated at v̄ and at the midpoints of q and t.
//!
//! # Bars and closed chains
//!
//! A closed chain has no independent coordinates. Write Cartesian positions, and one constraint g(q) = 0 for each bar:
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// Four-bar linkage: joints (q₀, q₁) and (q₂, q₃) between the fixed points (0, 0) and (d, 0).
//! #[lagrangian(constraint = [
//!     (q[0].powi(2) + q[1].powi(2) - bars[0].powi(2)) / 2.0,
//!     ((q[2] - q[0]).powi(2) + (q[3] - q[1]).powi(2) - bars[1].powi(2)) / 2.0,
//!     ((q[2] - d).powi(2) + q[3].powi(2) - bars[2].powi(2)) / 2.0,
//! ])]
//! fn four_bar(q: [f64; 4], v: [f64; 4], m: f64, bars: [f64; 3], d: f64, g: f64) -> f64 {
//!     m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]) / 2.0 - m * g * (q[1] + q[3])
//! }
//!
//! let system = FourBar { m: 1.0, bars: [1.0, 2.0, 1.8], d: 2.2, g: 9.81 };
//! let guess = system.at([0.0, 1.0, 1.8, 1.8], [-9.0, 0.0, -5.0, 0.0]);
//! let start = system.state_on_constraint(&guess)?;
//! let mut sim = system.integrator(DiscreteGradient, 0.01, start);
//! let energy = sim.energy();
//! sim.advance(2000)?;
//! assert!((sim.state().q[0].hypot(sim.state().q[1]) - 1.0).abs() < 1e-14);
//! assert!((sim.energy() / energy - 1.0).abs() < 1e-12);
//! # assert!(system.integrator(Rattle, 0.01, guess).step().is_err());
//! # Ok::<(), StepError>(())
//! ```
//!
//! [`Rattle`](crate::Rattle) is symplectic. `DiscreteGradient` keeps the energy. `Suzuki4.of(Rattle)` has order 4. All keep the bars to rounding.
//! The momenta of `DiscreteGradient` are off by O(h²) at the end of a step; `sim.state_on_constraint()` returns corrected momenta.
//!
//! # Kinds of Lagrangians
//!
//! | L | methods |
//! |---|---|
//! | quadratic in v, constant mass matrix | all methods for H = T(p) + V(q) |
//! | quadratic in v, mass matrix M(q) couples at most two velocities | all methods for any H(q, p) |
//! | quadratic in v, M(q) couples three or more: robot arms | `DiscreteGradient`, [`Gauss`](crate::Gauss), `DOP853`; no Taylor series |
//! | A√(S + v·Cv), A\|v\|ⁿ, A eᵛ, A ln v, A cosh v: relativity, optics | all methods for the derived H, often T(p) + V(q) |
//! | any other function of v | `Gauss`, `DOP853` |
//! | linear in v: L = ϑ(q)·v − H(q) | first-order equations with [`FlowState`](crate::FlowState); methods of [fields](super::_11_fields) |
//! | with an argument `s`, s' = L (Herglotz) | contact methods, see [friction](super::_08_friction); states are `system.at(q, v, s)` |
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! #[lagrangian] // a relativistic mass on a spring
//! fn oscillator(q: f64, v: f64, m: f64, c: f64, k: f64) -> f64 {
//!     -m * c * c * (1.0 - v * v / (c * c)).sqrt() - k * q * q / 2.0
//! }
//! let system = Oscillator { m: 1.0, c: 1.0, k: 1.0 };
//! system.integrator(BlanesMoan4, 0.1, system.at(0.0, 0.9)).advance(1000)?;
//! let too_fast = system.integrator(BlanesMoan4, 0.1, system.at(0.0, 1.1)).step();
//! assert!(matches!(too_fast, Err(StepError::NoMomentum { .. })));
//! # Ok::<(), StepError>(())
//! ```
//!
//! # Errors and limits
//!
//! - A mass matrix that is singular at every state is a compile error. The message names a motion without inertia.
//! - A singular mass matrix on the way of a step, as at the pole of spherical angles: [`OutsideDomain`](crate::StepError::OutsideDomain).
//! - A start off a constraint: [`OffConstraint`](crate::StepError::OffConstraint). `state_on_constraint` returns the nearest valid state.
//! - Bars in one line, with two possible motions: [`DependentConstraints`](crate::StepError::DependentConstraints) or `Singular`.
//! - A velocity outside the domain of L, such as v > c, or with the same momentum as another one: [`NoMomentum`](crate::StepError::NoMomentum).
//! - Constraints depend on q and parameters only. They exclude `force`, adaptive runs and explicit methods; `rayleigh` is possible.
//! - Put a prescribed motion into L as a function of `t`. Write rolling without slip as a [`#[vector_field]`](super::_11_fields) with multipliers.
//!
//! Next: [fields with integrals and rigid bodies](super::_11_fields), [events](super::_12_events), [games and real time](super::_13_real_time).
