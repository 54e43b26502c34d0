//! Choose the attribute that fits your variables, and the best form for friction, motors and constraints.
//!
//! This program writes one pendulum in three ways. All runs end at the same angle:
//!
//! ```standalone_crate
//! use geoint_runtime::prelude::*;
//!
//! /// Angle q and momentum p: the energy.
//! #[hamiltonian]
//! fn by_energy(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
//!     p * p / (2.0 * m * l * l) - m * g * l * q.cos()
//! }
//!
//! /// Angle q and angular velocity v: kinetic minus potential energy.
//! #[lagrangian]
//! fn by_velocity(q: f64, v: f64, m: f64, l: f64, g: f64) -> f64 {
//!     m * l * l * v * v / 2.0 + m * g * l * q.cos()
//! }
//!
//! /// x is the angle and the angular velocity: the equations of motion.
//! #[vector_field]
//! fn by_equations(x: [f64; 2], l: f64, g: f64) -> [f64; 2] {
//!     [x[1], -g / l * x[0].sin()]
//! }
//!
//! let (m, l, g) = (2.0, 1.5, 9.81);
//! let velocity = ByVelocity { m, l, g };
//! let mut a = ByEnergy { m, l, g }.integrator(Gauss::<4>, 0.01, State::new(1.0, 0.0));
//! let mut b = velocity.integrator(Gauss::<4>, 0.01, velocity.at(1.0, 0.0));
//! let mut c = ByEquations { l, g }.integrator(Gauss::<4>, 0.01, FlowState::new([1.0, 0.0]));
//! (a.advance(1000)?, b.advance(1000)?, c.advance(1000)?);
//! println!("{:.6} {:.6} {:.6}", a.state().q, b.state().q, c.state().x[0]); // 0.415911 0.415911 0.415911
//! # assert!([a.state().q, b.state().q, c.state().x[0]].iter().all(|q| (q - 0.415910533587).abs() < 1e-11));
//! # assert!((velocity.velocity(&State::new(1.0, 0.5)) - 0.111).abs() < 1e-3 && velocity.velocity(&velocity.at(1.0, 0.5)) == 0.5);
//! # Ok::<(), StepError>(())
//! ```
//!
//! | you have | attribute | arguments | first state, and its type for two coordinates, or one body |
//! |---|---|---|---|
//! | an energy in positions and momenta | [`#[hamiltonian]`](crate::hamiltonian) | `q`, `p` | `State::new(q, p)`, `State<[f64; 2]>` |
//! | kinetic minus potential energy, in positions and velocities | [`#[lagrangian]`](crate::lagrangian) | `q`, `v` | `system.at(q, v)`, `State<[f64; 2]>` |
//! | an energy with friction −γp, one γ for all momenta | [`#[contact_hamiltonian]`](crate::contact_hamiltonian) | `q`, `p`, `s` | `ContactState::new(q, p, s)`, `ContactState<[f64; 2]>` |
//! | rigid bodies, by unit quaternions | `#[hamiltonian(attitude = r)]` | `r`, `m`, or with `q`, `p` | `BodyState::new(r, m)`, `BodyState<UnitQuaternion<f64>>` |
//! | an energy H(x) and an antisymmetric matrix S, x' = S(x) ∇H | `#[hamiltonian(structure = S)]` | `x` | `FlowState::new(x)`, `FlowState<[f64; 2]>` |
//! | equations x' = f(x, t), perhaps with known invariants | [`#[vector_field]`](crate::vector_field) | `x` | `FlowState::new(x)` |
//!
//! If you know both an energy and the equations, write the energy. More methods apply to it.
//! The number s of a contact system is an auxiliary variable. Start with s = 0. In a term γ s with constant γ, the value of s never changes q and p.
//!
//! **Warning.** The state of a Lagrangian is (q, p). In the program above, `State::new(1.0, 0.5)` sets the *momentum* to 0.5, without an error. The
//! velocity is then 0.5/(m l²) = 0.11. Write `velocity.at(1.0, 0.5)` to set the velocity to 0.5. Read it with `sim.velocity()`.
//!
//! # Friction
//! A joint with the friction torque −b q' can be written in three ways. Units are those of an angle q:
//!
//! | attribute | coefficient | unit | prefer it if |
//! |---|---|---|---|
//! | `#[contact_hamiltonian]`, with a term `+ gamma * s` | γ = b/(m l²), a rate | 1/s | friction is linear, with one rate for all coordinates |
//! | `#[hamiltonian(damping = C)]` | C = b, a torque per velocity | N m s | rates differ, C depends on q, p or t, or no step may gain energy |
//! | `#[lagrangian(rayleigh = R)]` | R = b v²/2, half of the lost power | W | L is given, or friction is nonlinear, as `c * v.abs().powi(3) / 3.0` |
//!
//! Only the first form has explicit methods of high order that keep structure. This program compares methods of order 2 and 6. It measures the
//! largest error of the angle in 20 s, for steps of 0.02 s:
//!
//! ```
//! # use geoint_runtime::{methods::*, prelude::*};
//! #[hamiltonian(damping = b)]
//! fn damped(q: f64, p: f64, m: f64, l: f64, g: f64, b: f64) -> f64 {
//!     p * p / (2.0 * m * l * l) - m * g * l * q.cos()
//! }
//! #[contact_hamiltonian]
//! fn contact(q: f64, p: f64, s: f64, m: f64, l: f64, g: f64, gamma: f64) -> f64 {
//!     p * p / (2.0 * m * l * l) - m * g * l * q.cos() + gamma * s
//! }
//! let (m, l, g, b) = (2.0, 1.5, 9.81, 0.3);
//! let mut a = Damped { m, l, g, b }.integrator(DiscreteGradient, 0.02, State::new(1.0, 0.0));
//! let mut c = Contact { m, l, g, gamma: b / (m * l * l) }.integrator(BlanesMoanSrkn11b, 0.02, ContactState::new(1.0, 0.0, 0.0));
//! let mut errors = [0.0_f64; 2];
//! for exact in a.system().taylor(Taylor::default(), a.state()).sampled_every(0.02).take(1001).skip(1) {
//!     (a.step()?, c.step()?);
//!     let q = exact?.q;
//!     errors = [errors[0].max((a.state().q - q).abs()), errors[1].max((c.state().q - q).abs())];
//! }
//! println!("{:.1e} {:.1e}", errors[0], errors[1]); // 5.0e-3 1.6e-14
//! # assert!((4e-3..6e-3).contains(&errors[0]) && errors[1] < 1e-13);
//! # Ok::<(), StepError>(())
//! ```
//!
//! `BlanesMoanSrkn11b` evaluates 11 forces a step. In steps of 0.2 s its error after 20 s is 4e-9 here, and 2e-7 for a pendulum that starts at 2 rad:
//! halve h and compare. `damping` with `Gauss::<3>`, h = 0.02 s: 4e-12.
//! # Motors, driving, constraints
//! - **A force with a potential** is a term of the energy, as `- a * (w * t).sin() * q` with an argument `t: f64`. Methods for T(p) + V(q) still
//!   apply.
//! - **Any other force** is `force = F(q, v, t)` under `hamiltonian` and `lagrangian`; v is the velocity. Use `Gauss` or `DiscreteGradient`.
//! - **Bars and closed chains** are `constraint = [g]`, **wheels and blades** `rolling = [A·v + b]`. See [mechanisms](super::_10_mechanisms).
//! # Recipes
//! - **Poincaré section.** `sim.crossings(Direction::Up, |x| x.q[0]).take(100)` yields the points with q₀ = 0. See [events](super::_12_events).
//! - **Impact.** `sim.until_event(t, Direction::Down, |x| x.q)` stops at q = 0. Then `set_state` reverses the momentum.
//! - **Control.** `sim.set_system(Motor { torque, ..*sim.system() })` changes a torque in a run. See [`set_system`](crate::Integrator::set_system).
//! - **Lyapunov exponent** λ of an energy H(q, p). A small deviation (δq, δp) grows as exp(λt). Orbit and deviation together have the energy K =
//!   δq·∂H/∂q + δp·∂H/∂p. The partner of q is δp, and the partner of δq is p: positions [q, δq], momenta [δp, p]. Stop or rescale δ before λt = 700,
//!   where it overflows. With friction, write x' and the linearised δx' as a `#[vector_field]`. For Hénon and Heiles, H = 0.16:
//! ```
//! # use geoint_runtime::prelude::*;
//! #[hamiltonian(q = x, p = y)] // The argument x holds the positions, y the momenta.
//! fn tangent(x: [[f64; 2]; 2], y: [[f64; 2]; 2]) -> f64 {
//!     let ([q, dq], [dp, p]) = (x, y);
//!     dq[0] * (q[0] + 2.0 * q[0] * q[1]) + dq[1] * (q[1] + q[0] * q[0] - q[1] * q[1]) + dp[0] * p[0] + dp[1] * p[1]
//! }
//! let start = State::new([[0.0, -0.1], [1.0, 0.0]], [[0.0, 0.0], [0.557, 0.0]]);
//! let mut sim = Tangent.integrator(BlanesMoanSrkn14a, 0.2, start);
//! sim.advance(20_000)?;
//! println!("{:.2}", sim.state().q[1][0].abs().ln() / sim.time()); // near 0.11
//! # assert!((0.09..0.14).contains(&(sim.state().q[1][0].abs().ln() / sim.time())));
//! # Ok::<(), StepError>(())
//! ```
//! Errors: an argument of the wrong attribute does not compile, and the message names the right one. A step with a negative coefficient in
//! `damping` or `rayleigh` returns [`OutsideDomain`](crate::Failure::OutsideDomain).
//!
//! Next: [which method](super::_03_which_method), [friction, heat, driving](super::_08_friction), [Lagrangians](super::_10_mechanisms).
