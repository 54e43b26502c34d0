//! Simulate friction, motors, driving forces and heat, with an energy balance that closes to rounding.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// Pendulum in a bearing with friction; q in rad, p in kg m²/s, b in N m s.
//! #[hamiltonian(damping = b)]
//! fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64, b: f64) -> f64 {
//!     p * p / (2.0 * m * l * l) - m * g * l * q.cos()
//! }
//! let mut sim = Pendulum { m: 0.7, l: 1.2, g: 9.81, b: 0.1 }.integrator(DiscreteGradient, 0.02, State::new(2.0, 0.0));
//! for _ in 0..1000 {
//!     let energy = sim.energy();
//!     sim.step()?;
//!     assert!(sim.energy() <= energy); // No step gains energy.
//! }
//! # Ok::<(), StepError>(())
//! ```
//!
//! # Three ways to write friction
//!
//! | attribute | equation | for the pendulum | use it if |
//! |---|---|---|---|
//! | `hamiltonian(damping = C)` | p' = −∂H/∂q − C ∂H/∂p | C = b, torque per angular velocity, N m s | C reads q, p, t; no step may gain energy |
//! | `lagrangian(rayleigh = R)` | d/dt ∂L/∂v = ∂L/∂q − ∂R/∂v | R = b v²/2, power, W | you write L(q, v); friction is not linear in v |
//! | `contact_hamiltonian`, term `+ gamma * s` | p' = −∂H/∂q − γ p | γ = b/(m l²), rate, 1/s | all momenta decay at one rate; you need accuracy |
//!
//! C is a number, an array with one number for each coordinate, or a symmetric matrix. A sliding mass m with the friction force −b v has C = b
//! in N s/m and γ = b/m. The table shows the error of the angle of the pendulum above after 20 s, with h = 0.02 s. *Contact* means
//! `contact_hamiltonian`, and the contact form is ds − p dq.
//!
//! | method | attribute | order | keeps | error / rad |
//! |---|---|---|---|---|
//! | [`DiscreteGradient`](crate::DiscreteGradient) | `damping`, `rayleigh` | 2 | balance of energy, for every h | 8e-3 |
//! | [`Suzuki4.of(DiscreteGradient)`](crate::Suzuki4) | `damping`, `rayleigh` | 4 | balance in each substep, no guarantee for the sum | 2e-7 |
//! | [`Gauss::<3>`](crate::Gauss), 1 to 6 stages | `damping`, `rayleigh` | 6 (twice the stages) | – | 2e-11 |
//! | [`ContactSplitting`](crate::ContactSplitting) | contact | 2 | contact form up to a factor | 2e-3 |
//! | [`Suzuki4.of(ContactSplitting)`](crate::Suzuki4) | contact | 4 | contact form up to a factor | 1e-7 |
//! | [`BlanesMoanSrkn11b`](crate::BlanesMoanSrkn11b) | contact, T quadratic, γ constant | 6 | contact form up to a factor | 2e-13 |
//! | [`ContactGauss::<3>`](crate::ContactGauss), 1 to 6 stages | contact | 6 (twice the stages) | contact form up to a factor | 1e-11 |
//! | [`ContactDiscreteGradient`](crate::ContactDiscreteGradient) | contact | 2 | law of decay of H | 8e-3 |
//!
//! Steps may be longer than the oscillation. In 400 steps of 10 for q'' = −q − q³ − 0.1 q', `DiscreteGradient` gains energy in no step,
//! `ImplicitMidpoint` in 11. The figure compares contact methods with others at equal numbers of forces, for q'' + γq' + q = 0:
//!
#![doc = include_str!("../../docs/figures/contact_compared.svg")]
//!
//! # Motors, and the exact balance of energy
//!
//! `force = F` adds a force without a potential, F(q, v, t) under `lagrangian`. In a step of `DiscreteGradient` the energy changes by exactly
//! h v̄·F(q̄, v̄, t̄) − h v̄·∂R/∂v(q̄, v̄, t̄). Here v̄ = (q₁ − q₀)/h, q̄ = (q₀ + q₁)/2, and t̄ is the middle of the step. With `damping`, the loss
//! is h v̄·C v̄. Do not take the mean of the velocities at both ends for v̄: the balance below would miss up to 1e-4 J in a step.
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! /// Double pendulum with friction and a motor in the lower joint; angles from below.
//! #[lagrangian(rayleigh = c * (v[1] - v[0]).powi(2) / 2.0, force = [0.0, u * (v[1] + t).tanh()])]
//! fn arm(q: [f64; 2], v: [f64; 2], t: f64, g: f64, c: f64, u: f64) -> f64 {
//!     let kinetic = v[0] * v[0] + 0.5 * v[1] * v[1] + v[0] * v[1] * (q[0] - q[1]).cos();
//!     kinetic + 2.0 * g * q[0].cos() + g * q[1].cos()
//! }
//! let (h, arm) = (0.02, Arm { g: 9.81, c: 0.2, u: 1.5 });
//! let mut sim = arm.integrator(DiscreteGradient, h, arm.at([0.5, 1.4], [0.0; 2]));
//! for _ in 0..1000 {
//!     let (before, energy) = (sim.state(), sim.energy());
//!     sim.step()?;
//!     let (after, t) = (sim.state(), (before.t + sim.time()) / 2.0);
//!     let v = [0, 1].map(|i| (after.q[i] - before.q[i]) / h);
//!     let (work, heat) = (h * v[1] * arm.u * (v[1] + t).tanh(), h * arm.c * (v[1] - v[0]).powi(2));
//!     assert!((sim.energy() - energy - work + heat).abs() < 1e-12);
//! }
//! sim.set_system(Arm { u: -0.5, ..*sim.system() }); // A controller sets another torque.
//! # Ok::<(), StepError>(())
//! ```
//!
//! # Driving and the law of decay
//!
//! A driving force F(t) has the potential −q F(t). Add this term to H with the argument `t`. Every method keeps its order. The equations of a contact
//! system are q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H. H includes γ s: the mechanical energy is H − γ s. Start with s = 0.
//! Without driving, H decays like e^(−γt). `ContactDiscreteGradient` multiplies H by exactly e^(−γh) in each step:
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! #[contact_hamiltonian]
//! fn driven(q: f64, p: f64, s: f64, t: f64, gamma: f64, f: f64, omega: f64) -> f64 {
//!     p * p / 2.0 + q * q / 2.0 - f * q * (omega * t).sin() + gamma * s
//! }
//! let (start, driven) = (ContactState::new(1.0, 0.0, 0.0), Driven { gamma: 0.1, f: 0.3, omega: 1.0 });
//! driven.integrator(BlanesMoanSrkn11b, 0.5, start).advance(1000)?;
//! let mut free = Driven { f: 0.0, ..driven }.integrator(ContactDiscreteGradient, 0.1, start);
//! free.advance(500)?;
//! assert!((free.energy() / (0.5 * (-0.1 * 50.0_f64).exp()) - 1.0).abs() < 1e-12);
//! # Ok::<(), StepError>(())
//! ```
//!
//! # Heat baths
//!
//! A [`vector_field`](macro@crate::vector_field) with the heat as a coordinate keeps the total energy. The macro proves `keeps` at compile time. If
//! the entropy must not decrease in any step, use `lift` and `ContactSplitting` as in the example `heat_bath`.
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! /// x = (angle, angular velocity, heat); m = l = 1.
//! #[vector_field(keeps(energy = x[1] * x[1] / 2.0 - g * x[0].cos() + x[2]))]
//! fn bath(x: [f64; 3], g: f64, b: f64) -> [f64; 3] {
//!     [x[1], -g * x[0].sin() - b * x[1], b * x[1] * x[1]]
//! }
//! let mut sim = Bath { g: 9.81, b: 0.1 }.integrator(DiscreteGradient, 0.02, FlowState::new([2.0, 0.0, 5.0]));
//! sim.advance(10_000)?;
//! assert!((sim.energy() - (5.0 - 9.81 * 2_f64.cos())).abs() < 1e-12 && sim.state().x[2] > 5.0);
//! # Ok::<(), StepError>(())
//! ```
//!
//! # Errors and limits
//!
//! - Splittings do not compile with `damping`, `rayleigh` or `force`. With these and an action `s`, use `RK4`, `DOP853` or Taylor series.
//! - [`OutsideDomain`](crate::StepError::OutsideDomain): C or R feeds energy. [`Pole`](crate::StepError::Pole): an exact flow ends in the step.
//! - [`Singular`](crate::StepError::Singular): γh ≥ 2 with `ContactLeapfrog` or `ContactMidpoint`. Remedy: a shorter step, or `ContactSplitting`.
//!
//! Next: [mechanisms](super::_10_mechanisms), [fields with integrals](super::_11_fields).
