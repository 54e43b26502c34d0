//! Keep the energy of a simulation exactly, up to rounding, over any number of steps.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// A comet; q in AU, p in AU/yr per unit mass, k = 4π² AU³/yr².
//! #[hamiltonian]
//! fn comet(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
//!     (p[0] * p[0] + p[1] * p[1]) / 2.0 - k / (q[0] * q[0] + q[1] * q[1]).sqrt()
//! }
//!
//! let mut sim = Comet { k: 39.478 }.integrator(DiscreteGradient, 0.005, State::new([1.0, 0.0], [0.0, 7.5]));
//! let energy = sim.energy();
//! sim.advance(20_000)?;
//! let State { q, p, .. } = sim.state();
//! let angular_momentum = q[0] * p[1] - q[1] * p[0];
//! println!("relative changes: {:.0e} and {:.0e}", sim.energy() / energy - 1.0, angular_momentum / 7.5 - 1.0);
//! # assert!((sim.energy() / energy - 1.0).abs() < 2e-14 && (angular_momentum / 7.5 - 1.0).abs() < 2e-14);
//! # Ok::<(), StepError>(())
//! ```
//!
//! Energy and angular momentum of the comet change by less than 2e-14 in 100 years. For comparison, take a pendulum and a million steps of
//! 0.02 s. The largest relative error of its energy is 3e-15 with `DiscreteGradient`, 2e-3 with `StormerVerlet`, and 9e-4 with `RK4`. The error of
//! `RK4` grows with the number of steps. Every 1024 steps, `DiscreteGradient` removes the drift of the energy by rounding.
//!
//! # Which method
//! | method | order | keeps beside the energy | error | ns | use it for |
//! |---|---|---|---|---|---|
//! | [`DiscreteGradient`](crate::DiscreteGradient) | 2 | momenta in the report, time symmetry | 3e-4 | 40 | long runs, impacts, games, friction |
//! | [`FourthOrder(DiscreteGradient)`](crate::FourthOrder) | 4 | momenta in the report, time symmetry | 2e-8 | 270 | positions, short steps |
//! | [`Suzuki4.of(DiscreteGradient)`](crate::Suzuki4) | 4 | momenta in the report, time symmetry | 1e-8 | 390 | positions, long steps, constraints |
//! | [`Projection(RK4, Energy)`](crate::Projection) | 4 | invariants that you name | 1e-7 | 160 | short runs, several invariants |
//! | [`Relaxation(RK4)`](crate::Relaxation) | 4 | linear invariants | – | – | short runs; it stretches each step a little |
//! | [`Gonzalez`](crate::Gonzalez) | 2 | momenta of cyclic coordinates, time symmetry | 3e-4 | 620 | comparison with the literature |
//! | [`MeanValue::<2>`](crate::MeanValue) | 2 | time symmetry | 3e-4 | 400 | comparison with the literature |
//! | [`Kahan`](crate::Kahan) | 2 | time symmetry; the energy oscillates | 3e-4 | – | polynomials of degree 3, one linear solve a step |
//!
//! - *error*: distance from the exact (q, p) at t = 2, with h = 0.05, for the energy of Hénon and Heiles. *ns*: time of one step there. The example
//!   `which_discrete_gradient` prints both (release build, one core of a shared Xeon, shortest of four runs). A step of `RK4` takes 26 ns. The
//!   example does not contain `Relaxation` and `Kahan`.
//! - [`MeanValue::<K>`](crate::MeanValue), K = 1 to 6, keeps the energy if H is a sum of a polynomial of degree ≤ 2K and of functions of one
//!   linear combination of coordinates, such as cos(q₀ − q₁). The report names the terms that prevent this.
//! - `Kahan` keeps a modified energy, so that the error of the energy stays bounded.
//! - [`SymmetrisedItohAbe`](crate::SymmetrisedItohAbe), [`ItohAbePair`](crate::ItohAbePair), [`ItohAbe`](crate::ItohAbe) and
//!   [`CoordinateIncrement`](crate::CoordinateIncrement) also keep the energy. Use them to compare with the literature.
//! - [`Projection`](crate::Projection) and [`Relaxation`](crate::Relaxation) accept other methods too, for instance `DOP853`.
//! - None of these methods is symplectic in general. Choose [another method](super::_03_which_method) if accurate orbits matter more than the energy:
//!   `DiscreteGradient` keeps the energy of the [outer planets](super::_09_planets) to 1e-15, but one planet ends 2.4 AU from its true position.
//! - Implicit methods solve an equation in each step. Beyond 12 coordinates, long steps need full matrices, and their cost grows as n³.
//!
//! `DiscreteGradient` keeps angular momentum if central forces are written as functions of `x * x + y * y`, as above. Print `Comet::<f64>::REPORT`
//! and check the sections *Conserved by the flow* and *Discrete gradients*.
//!
//! # Invariants of your own
//! Implement [`Invariants`](crate::Invariants) and list it after [`Energy`](crate::Energy). `DiscreteGradient` keeps it in adaptive runs, and
//! `Projection` in Taylor series.
//!
//! ```standalone_crate
//! use geoint_runtime::{Invariants, methods::*, prelude::*};
//! # #[hamiltonian]
//! # fn comet(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
//! #     (p[0] * p[0] + p[1] * p[1]) / 2.0 - k / (q[0] * q[0] + q[1] * q[1]).sqrt()
//! # }
//! /// L = q₀p₁ − q₁p₀.
//! #[derive(Clone, Copy)]
//! struct AngularMomentum;
//!
//! impl Invariants<Comet> for AngularMomentum {
//!     type Values = f64;
//!     /// (q + dq) × (p + dp) − q × p, multiplied out: the difference of two values would lose digits.
//!     fn changes(&self, _: &Comet, [q, p]: &[[f64; 2]; 2], [dq, dp]: &[[f64; 2]; 2]) -> f64 {
//!         let cross = |a: &[f64; 2], b: &[f64; 2]| a[0] * b[1] - a[1] * b[0];
//!         cross(dq, p) + cross(q, dp) + cross(dq, dp)
//!     }
//!     /// ∂L/∂q and ∂L/∂p.
//!     fn gradients(&self, _: &Comet, [q, p]: &[[f64; 2]; 2]) -> [[f64; 2]; 2] {
//!         [[p[1], -p[0]], [-q[1], q[0]]]
//!     }
//! }
//! let (system, start) = (Comet { k: 39.478 }, State::new([1.0, 0.0], [0.0, 7.5]));
//! let mut fixed = system.integrator(Projection(RK4, (Energy, AngularMomentum)), 0.005, start);
//! fixed.advance(10_000)?;
//! let mut adaptive = system.adaptive(DiscreteGradient, 1e-6, start);
//! adaptive.advance_to(10.0)?;
//! let mut series = system.taylor(Projection(Taylor { tolerance: 1e-10 }, Energy), start);
//! series.advance_to(10.0)?;
//! # let (energy, State { q, p, .. }) = (system.energy(&start), fixed.state());
//! # assert!([fixed.energy(), adaptive.energy(), series.energy()].iter().all(|e| (e / energy - 1.0).abs() < 1e-13));
//! # assert!(((q[0] * p[1] - q[1] * p[0]) / 7.5 - 1.0).abs() < 1e-13);
//! # Ok::<(), StepError>(())
//! ```
//!
//! # Energies with bends
//!
//! `abs`, `max` and `min` bend the energy. `DiscreteGradient` keeps the energy across a bend, for instance at a floor that is a stiff spring.
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! /// A mass that a constant force pulls to q = 0.
//! #[hamiltonian]
//! fn wedge(q: f64, p: f64, k: f64) -> f64 {
//!     p * p / 2.0 + k * q.abs()
//! }
//! let mut sim = Wedge { k: 2.0 }.integrator(DiscreteGradient, 0.01, State::new(1.0, 0.0));
//! sim.advance(10_000)?;
//! assert!((sim.energy() - 2.0).abs() < 1e-13); // With StormerVerlet: 0.04.
//! # Ok::<(), StepError>(())
//! ```
//!
//! # Refused steps and limits
//!
//! - [`NotConverged`](crate::Failure::NotConverged), [`Singular`](crate::Failure::Singular): the step is far too large, or the energy jumps.
//!   A pendulum with a period of 2.7 s takes 10 000 steps of 1 s with `DiscreteGradient`. Steps of 3 s end with `Singular` after eight.
//! - [`LedAstray`](crate::Failure::LedAstray): a projection would correct more than half of the step.
//! - After each of these errors, the state is the last good state. Halve the step size with `set_step_size` and continue.
//! - An energy that reads `t` is not constant: `DiscreteGradient` runs, and `Projection` does not compile. Rigid bodies (`attitude = r`) have no
//!   discrete gradient.
//! - The step across a bend has a larger error than the order promises.
//!
//! Next: [friction, heat, driving](super::_08_friction), [fields with integrals](super::_11_fields), [errors and remedies](super::_16_errors).
