//! Simulate a mechanism from its Lagrangian. You give angles and their rates. The momenta and the mass matrix are derived.
//!
//! The function returns L(q, v): kinetic minus potential energy. `q` are the coordinates and `v` their rates, q' = v.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// Two links in a vertical plane; q absolute angles from below in rad, v their rates in rad/s.
//! #[lagrangian(rayleigh = friction * (v[0] * v[0] + (v[1] - v[0]).powi(2)) / 2.0, force = [-torque, torque])]
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
//! let (h, friction) = (0.01, 0.05);
//! let system = Arm { m: [1.0, 0.6], l: [1.0, 0.8], g: 9.81, friction, torque: 0.0 };
//! let mut sim = system.integrator(DiscreteGradient, h, system.at([0.0, 1.4], [0.0, 0.0]));
//! let (start, mut work, mut heat) = (sim.energy(), 0.0, 0.0);
//! for _ in 0..1000 {
//!     let before = sim.state();
//!     let torque = -2.0 * (before.q[1] - before.q[0] - 0.5) - 0.3 * (sim.velocity()[1] - sim.velocity()[0]);
//!     sim.set_system(Arm { torque, ..*sim.system() }); // held until the next call
//!     sim.step()?;
//!     let rate = [0, 1].map(|i| (sim.state().q[i] - before.q[i]) / h);
//!     work += h * torque * (rate[1] - rate[0]);
//!     heat += h * friction * (rate[0] * rate[0] + (rate[1] - rate[0]).powi(2));
//! }
//! assert!((sim.energy() - start - work + heat).abs() < 1e-13); // the energy balance is closed
//! # Ok::<(), StepError>(())
//! ```
//!
//! - [`State::new`](crate::State::new) takes q and the **momenta** p = ∂L/∂v. `system.at(q, v)` takes velocities. Use `at` for every start.
//! - `sim.velocity()` returns the rates. `system.velocity(&state)` and `system.momentum(t, q, v)` convert.
//! - The energy is H = p·v − L. It equals T + V if L = T − V and T is quadratic in v. `Arm::REPORT`, the [report](super::_05_report), states both.
//! - `set_system` changes parameters between steps. A feedback law of q and v may also stand in `force` itself.
//! # Friction and motors
//! `force = F(q, v, t)` is added to p', one entry for each coordinate. `rayleigh = R(q, v, t)` adds the friction force −∂R/∂v. A motor between two
//! links has F = [−τ, τ] if the angles are absolute, and its own entry if they are relative. A motor at the base has F = [τ, 0]. Viscous friction in
//! this joint has R = c w²/2 with w = v₁ − v₀. Dry friction with the torque c has R = c √(w² + ε²). Take ε = 1e-3 rad/s: a joint under a load f < c
//! then creeps at ε f/√(c² − f²). A step in which R adds energy returns `OutsideDomain`. Let v̄ = (qₙ₊₁ − qₙ)/h. A step of
//! [`DiscreteGradient`](crate::DiscreteGradient) changes the energy by exactly h v̄·F − h v̄·∂R/∂v. Both forces are taken at v̄ and at the midpoints
//! of q and t. Compute the work with v̄, as above, and not with `sim.velocity()`.
//! A closed balance is not an accurate path: with a driven elbow, the arm above ends 0.3 rad off after 10 s. For the path, keep each torque for
//! `sim.advance(4)?` at h = 2.5 ms (0.02 rad), or write `Gauss::<3>` (h = 10 ms: 1e-7 rad, balance to 5e-3 J). Without friction,
//! `Suzuki4.of(DiscreteGradient)` closes the balance and is right to 4e-5 rad.
//!
//! # Bars and closed chains
//! A closed chain has no independent coordinates. Write Cartesian positions, and one constraint g(q, t) = 0 for each bar:
//!
//! ```
//! use geoint_runtime::{methods::*, prelude::*};
//! /// Four-bar linkage: joints (q[0], q[1]) and (q[2], q[3]) between the fixed points (0, 0) and (d, 0).
//! #[lagrangian(constraint = [
//!     (q[0].powi(2) + q[1].powi(2) - bars[0].powi(2)) / 2.0,
//!     ((q[2] - q[0]).powi(2) + (q[3] - q[1]).powi(2) - bars[1].powi(2)) / 2.0,
//!     ((q[2] - d).powi(2) + q[3].powi(2) - bars[2].powi(2)) / 2.0,
//! ])]
//! fn four_bar(q: [f64; 4], v: [f64; 4], m: f64, bars: [f64; 3], d: f64, g: f64) -> f64 {
//!     m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]) / 2.0 - m * g * (q[1] + q[3])
//! }
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
//! - **Methods.** [`Rattle`](crate::Rattle) is symplectic, `DiscreteGradient` keeps the energy, `Suzuki4.of(…)` of them has order 4. They keep the
//!   bars and their rates to rounding, and accept a quadratic `rayleigh`. For friction γ(t)·s: `ContactSplitting`, `ContactDiscreteGradient`.
//! - **Drives.** `force` does not compile with constraints. Add the potential of a torque: here `+ torque * q[1].atan2(q[0])` in L. H contains it. At
//!   ±π the angle jumps by 2π, and `sim.energy()` by 2π·torque: this is the work of one turn. The motion does not jump. Change `torque` by
//!   `set_system`. A prescribed motion is a constraint that reads t, as in the example `crank`.
//! - **Forces.** `sim.multipliers()` returns λ of the forces −Gᵀλ in the order of the constraints, G = ∂g/∂q: tensions and torques of motors.
//! - **Momenta** are tangent to the constraints, but for `DiscreteGradient` with a T that is not quadratic: use `sim.state_on_constraint()?` there.
//! # Wheels and blades
//! `rolling = [r]` with r = A(q, t)v + b(q, t) stands alone or beside `constraint`. The examples `sleigh` and `rolling` show a blade, a disk and a ball.
//! `DiscreteGradient` keeps r, and the energy if b = 0. `RK4`, `DOP853` and `adaptive` keep r to their error. `multipliers()` has Aᵀμ.
//! # Kinds of Lagrangians
//! | L | methods |
//! |---|---|
//! | quadratic in v, constant mass matrix | all methods for H = T(p) + V(q) |
//! | quadratic in v, M(q) couples at most two velocities (two links) | methods that need no splitting: `DiscreteGradient`, `Gauss`, `RK4`, Taylor series |
//! | *long arms*: quadratic in v, M(q) couples three or more (M = ∂²L/∂v²) | `DiscreteGradient`, [`Gauss`](crate::Gauss), `RK4`, `DOP853`; no Taylor series |
//! | A√(S + v·Cv), A\|v\|ⁿ, A eᵛ, A ln v, A cosh v: relativity, optics | all methods for the derived H, often T(p) + V(q) |
//! | any other function of v | `Gauss`, `RK4`, `DOP853` |
//! | linear in v: L = ϑ(q)·v − H(q) | first-order equations with [`FlowState`](crate::FlowState); methods of [fields](super::_11_fields) |
//! | with an argument `s`, s' = L (Herglotz) | contact methods, see [friction](super::_08_friction); states are `system.at(q, v, s)` |
//!
//! The report of a long arm says `steps are solved for v`: Newton's iteration has one unknown for each velocity. On one core of a Xeon, a step of the
//! example `robot_arm` with six joints takes 14 µs with `DiscreteGradient`, 10 µs with `Gauss::<2>`, 11 µs with `DOP853`, 3 µs with `RK4`.
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! #[lagrangian] // a relativistic mass on a spring
//! fn oscillator(q: f64, v: f64, m: f64, c: f64, k: f64) -> f64 { -m * c * c * (1.0 - v * v / (c * c)).sqrt() - k * q * q / 2.0 }
//! let system = Oscillator { m: 1.0, c: 1.0, k: 1.0 };
//! system.integrator(BlanesMoan4, 0.1, system.at(0.0, 0.9)).advance(1000)?;
//! let too_fast = system.integrator(BlanesMoan4, 0.1, system.at(0.0, 1.1)).step();
//! assert!(matches!(too_fast, Err(StepError { failure: Failure::NoMomentum, .. })));
//! # Ok::<(), StepError>(())
//! ```
//! # Errors and limits
//! - A mass matrix that is singular at every state is a compile error. The message names a velocity without kinetic energy.
//! - A singular mass matrix on the way of a step, as at the pole of spherical angles: [`OutsideDomain`](crate::Failure::OutsideDomain).
//! - A start off a constraint: [`OffConstraint`](crate::Failure::OffConstraint). `state_on_constraint` returns the nearest valid state.
//! - A dead point with all bars in one line, from which two motions lead on: [`DependentConstraints`](crate::Failure::DependentConstraints), `Singular`.
//! - A velocity outside the domain of L, such as v > c, or one that its momentum does not determine: [`NoMomentum`](crate::Failure::NoMomentum).
//! - With constraints, `force` does not compile, nor `rolling` beside an action. With `constraint`, adaptive runs and explicit methods do not.
//!
//! Next: [fields with integrals and rigid bodies](super::_11_fields), [events](super::_12_events), [games and real time](super::_13_real_time).
