//! Simulate friction, motors, driving forces and heat. With `DiscreteGradient` the balance of energy closes to rounding.
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
//! | attribute | equation | for the pendulum | use it if |
//! |---|---|---|---|
//! | `hamiltonian(damping = C)` | p' = −∂H/∂q − C ∂H/∂p | C = b, torque per angular velocity, N m s | C reads q, p, t; no step may gain energy |
//! | `lagrangian(rayleigh = R)` | d/dt ∂L/∂v = ∂L/∂q − ∂R/∂v | R = b v²/2, power, W | you write L(q, v); friction is not linear in v |
//! | `contact_hamiltonian`, term `+ gamma * s` | p' = −∂H/∂q − γ p | γ = b/(m l²), rate, 1/s | one γ for all momenta; explicit methods exist |
//!
//! C is a number, an array with one number for each coordinate, or a symmetric matrix: friction in the joint between q₀ and q₁ is `damping = [[c,
//! -c], [-c, c]]`. A sliding mass m with the friction force −b v has C = b in N s/m and γ = b/m. *Contact* means `contact_hamiltonian`. Splittings
//! shrink areas of (q, p) by e^(−γh) in a step, exactly as the motion does: they scale the contact form ds − p dq. Measured on the pendulum above:
//! error of the angle after 20 s, h = 0.02 s, and time of a step on one core of a Xeon.
//!
//! | method | attribute | order | keeps | error / rad | ns |
//! |---|---|---|---|---|---|
//! | [`DiscreteGradient`](crate::DiscreteGradient) | `damping`, `rayleigh` | 2 | balance of energy, at every h at which the step can be solved | 8e-3 | 68 |
//! | [`Suzuki4.of(DiscreteGradient)`](crate::Suzuki4) | `damping`, `rayleigh` | 4 | – (one substep runs backwards, where friction adds energy) | 2e-7 | 310 |
//! | [`Gauss::<3>`](crate::Gauss), 1 to 6 stages | `damping`, `rayleigh` | 6 (twice the stages) | – | 2e-11 | 130 |
//! | [`ContactSplitting`](crate::ContactSplitting) | contact | 2 | contact form up to a factor | 2e-3 | 24 |
//! | [`Suzuki4.of(ContactSplitting)`](crate::Suzuki4) | contact | 4 | contact form up to a factor | 1e-7 | 160 |
//! | [`BlanesMoanSrkn11b`](crate::BlanesMoanSrkn11b) | contact, T quadratic, γ constant | 6 | contact form up to a factor | 2e-13 | 300 |
//! | [`ContactGauss::<3>`](crate::ContactGauss), 1 to 6 stages | contact | 6 (twice the stages) | contact form up to a factor | 1e-11 | 410 |
//! | [`ContactDiscreteGradient`](crate::ContactDiscreteGradient) | contact | 2 | H' = −γ H, with γ s in H | 8e-3 | 62 |
//!
//! In 400 steps of 10 for q'' = −q − q³ − 0.1 q', `DiscreteGradient` never gains energy; such steps are stable, not accurate. The figure compares
//! methods at equal numbers of forces:
//!
#![doc = include_str!("../../docs/figures/contact_compared.svg")]
//!
//! # Motors, and the exact balance of energy
//! `force = F(q, v, t)` under `hamiltonian` or `lagrangian` adds any force. Let v̄ = (qₙ₊₁ − qₙ)/h, q̄ = (qₙ + qₙ₊₁)/2, t̄ = tₙ + h/2. A step of
//! `DiscreteGradient` changes the energy by exactly h v̄·F − h v̄·∂R/∂v at (q̄, v̄, t̄). The loss by `damping` is h v̄·C v̄. Do not take the mean of
//! the velocities before and after the step for v̄: then the balance below fails by up to 7e-5 J. A motor turns the outer link by the torque τ and
//! the inner link by −τ. With absolute angles its power is τ (v₁ − v₀). Friction in the joint depends on v₁ − v₀, too:
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! /// Double pendulum with friction and a motor in the lower joint; absolute angles from below.
//! #[lagrangian(rayleigh = c * (v[1] - v[0]).powi(2) / 2.0, force = [-u * (w * t).sin(), u * (w * t).sin()])]
//! fn arm(q: [f64; 2], v: [f64; 2], t: f64, g: f64, c: f64, u: f64, w: f64) -> f64 {
//!     let kinetic = v[0] * v[0] + 0.5 * v[1] * v[1] + v[0] * v[1] * (q[0] - q[1]).cos();
//!     kinetic + 2.0 * g * q[0].cos() + g * q[1].cos()
//! }
//! let (h, arm) = (0.02, Arm { g: 9.81, c: 0.2, u: 1.5, w: 3.0 });
//! let mut sim = arm.integrator(DiscreteGradient, h, arm.at([0.5, 1.4], [0.0; 2]));
//! for _ in 0..1000 {
//!     let (before, energy) = (sim.state(), sim.energy());
//!     sim.step()?;
//!     let (after, t) = (sim.state(), (before.t + sim.time()) / 2.0);
//!     let relative = (after.q[1] - before.q[1] - after.q[0] + before.q[0]) / h; // v̄₁ − v̄₀
//!     let (work, heat) = (h * arm.u * (arm.w * t).sin() * relative, h * arm.c * relative * relative);
//!     assert!((sim.energy() - energy - work + heat).abs() < 1e-12);
//! }
//! # Ok::<(), StepError>(())
//! ```
//!
//! # Driving and the law of decay
//! A driving force F(t) has the potential −q F(t). Add this term to H with the argument `t`; every method keeps its order. For an exact balance of
//! its work, write it as `force`. The equations of a contact system are q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H. `sim.energy()` is H with
//! γ s; the mechanical energy is `sim.energy() - gamma * s`, with `s` from `sim.state()`. Start with s = 0. Law of decay: without driving H' = −γ H,
//! and `ContactDiscreteGradient` keeps H = H(0) e^(−γt):
//!
//! ```
//! # use geoint_runtime::{methods::*, prelude::*};
//! #[contact_hamiltonian] // A driven Duffing oscillator.
//! fn driven(q: f64, p: f64, s: f64, t: f64, gamma: f64, f: f64, omega: f64) -> f64 {
//!     p * p / 2.0 + q * q / 2.0 + q.powi(4) / 4.0 - f * q * (omega * t).cos() + gamma * s
//! }
//! let (start, driven) = (ContactState::new(1.0, 0.0, 0.0), Driven { gamma: 0.1, f: 0.3, omega: 1.2 });
//! let mut sim = driven.integrator(BlanesMoanSrkn11b, 0.1, start);
//! let section: Vec<_> = sim.sampled_every(std::f64::consts::TAU / driven.omega).take(500).collect(); // The start, and a state after each period.
//! let mut free = Driven { f: 0.0, ..driven }.integrator(ContactDiscreteGradient, 0.1, start);
//! free.advance(500)?;
//! assert!((free.energy() / (0.75 * (-0.1 * 50.0_f64).exp()) - 1.0).abs() < 1e-12);
//! # assert!((section[499].clone()?.q - section[498].clone()?.q).abs() < 1e-11); Ok::<(), StepError>(())
//! ```
//!
//! # Heat as a coordinate, without noise
//! A [`vector_field`](macro@crate::vector_field) with the heat as a coordinate keeps the total energy. With [`entropy`](macro@crate::hamiltonian) S, steps of
//! `DiscreteGradient` never lower S: example `piston`. In `heat_bath`, [`lift`](macro@crate::contact_hamiltonian) gives x' = X(x) to `ContactSplitting`.
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
//! - Splittings do not compile with `damping`, `rayleigh` or `force`. Dry friction −c sign(v) has no model of sticking: smooth it, see
//!   [mechanisms](super::_10_mechanisms).
//! - [`OutsideDomain`](crate::Failure::OutsideDomain): C or R feeds energy. [`Pole`](crate::Failure::Pole): the exact flow of one part of H
//!   reaches infinity within the step. Remedy: a shorter step.
//! - [`Singular`](crate::Failure::Singular): γh ≥ 2 with `ContactLeapfrog` or `ContactMidpoint`. Remedy: a shorter step, or `ContactSplitting`.
//!
//! Next: [mechanisms](super::_10_mechanisms), [fields with integrals](super::_11_fields).
