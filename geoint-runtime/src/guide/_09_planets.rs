//! Simulate planets over centuries, satellites and close encounters, each with the method that fits.
//!
//! ```standalone_crate
//! use geoint_runtime::{nalgebra::Vector3, methods::*, prelude::*};
//!
//! /// Sun, asteroid, Jupiter, Saturn; q in AU, p in M☉ AU/d, m in M☉, g in AU³/(d² M☉).
//! #[hamiltonian(coordinates = jacobi)]
//! fn planets(q: [Vector3<f64>; 4], p: [Vector3<f64>; 4], m: [f64; 4], g: f64) -> f64 {
//!     let mut energy = 0.0;
//!     for i in 0..4 { energy += p[i].norm_squared() / (2.0 * m[i]); }
//!     for i in 0..4 { for j in 0..i { energy -= g * m[i] * m[j] / (q[i] - q[j]).norm(); } }
//!     energy
//! }
//! let m = [1.00000597682, 1e-30, 0.000954786104043, 0.000285583733151]; // The Sun with the inner planets. September 5, 1994.
//! let q = [[0.0; 3], [2.34, 0.0, 0.0], [-3.5023653, -3.8169847, -1.5507963], [9.0755314, -3.0458353, -1.6483708]];
//! let v = [[0.0; 3], [0.0, 0.0108, 0.0046], [0.00565429, -0.00412490, -0.00190589], [0.00168318, 0.00483525, 0.00192462]]; // AU/d
//! let start = State::new(q.map(Vector3::from), [0, 1, 2, 3].map(|i| m[i] * Vector3::from(v[i])));
//! let mut sim = Planets { m, g: 2.95912208286e-4 }.integrator(WisdomHolmanGradient, 100.0, start);
//! for state in sim.sampled_every(36_525.0).take(11) { // A thousand years, one line a century.
//!     let State { t, q, .. } = state?;
//!     println!("{t},{},{},{}", q[1].x - q[0].x, q[1].y - q[0].y, q[1].z - q[0].z);
//! }
//! # assert!((sim.energy() / sim.system().energy(&start) - 1.0).abs() < 1e-11);
//! # Ok::<(), StepError>(())
//! ```
//!
//! The macro splits the energy into A + B. The Kepler motion A of the planets has an exact flow. The rest B is about 1/1000 of A and acts as a kick.
//! States stay in your coordinates q and p = m v, in any consistent units. The Sun starts at rest here, so the centre of mass drifts. A run with the
//! centre of mass at rest gave the same relative positions to 7e-12 AU after 547 years.
//!
//! # Accuracy and cost
//! Sun and five outer planets, 547 years. The example `outer_solar_system` prints these numbers (release build, one core of a shared Xeon):
//!
//! | method | step / d | forces | time / ms | relative error of the energy | largest error of a position at the end / AU |
//! |---|---|---|---|---|---|
//! | [`StormerVerlet`](crate::StormerVerlet) | 10 | 20 000 | 1.1 | 8e-6 | 1e-1 |
//! | [`BlanesMoanSrkn14a`](crate::BlanesMoanSrkn14a) | 140 | 20 000 | 1.1 | 2e-11 | 5e-7 |
//! | [`WisdomHolmanGradient`](crate::WisdomHolmanGradient) | 100 | 2 000 | 0.6 | 4e-12 | 9e-10 |
//! | [`Aba10_6_4`](crate::Aba10_6_4) | 400 | 4 000 | 0.8 | 2e-12 | 6e-9 |
//! | [`Taylor`](crate::Taylor), tolerance 1e-16 | 235 on average | – | 7 | 1e-15 | 5e-12 |
//! | [`DiscreteGradient`](crate::DiscreteGradient) | 100 | 15 000 | 1.8 | 1e-15 | 2.4 |
#![doc = include_str!("../../docs/figures/outer_solar_system_energy.svg")]
//!
//! # Methods for A + B
//! Take `WisdomHolmanProcessed` for errors of positions down to 1e-6 AU, and `WisdomHolmanGradient` or `Aba10_6_4` for smaller errors. *Gradient*:
//! the kick also contains the derivative of the force, at the price of about one more force.
//!
//! | method | kicks in a step | terms of the error (h: step, ε: size of B relative to A) |
//! |---|---|---|
//! | [`WisdomHolman`](crate::WisdomHolman) | 1 | ε h² + ε² h² |
//! | [`WisdomHolmanProcessed`](crate::WisdomHolmanProcessed) | 1 | ε h¹⁰ + ε² h² |
//! | [`WisdomHolmanGradient`](crate::WisdomHolmanGradient) | 1, gradient | ε h¹⁰ + ε² h⁴ |
//! | [`Saba4`](crate::Saba4) | 4 | ε h⁸ + ε² h² |
//! | [`Aba8_4`](crate::Aba8_4) | 5 | ε h⁸ + ε² h⁴ |
//! | [`Aba8_6_4`](crate::Aba8_6_4) | 7 | ε h⁸ + ε² h⁶ + ε³ h⁴ |
//! | [`Aba10_6_4`](crate::Aba10_6_4) | 8 | ε h¹⁰ + ε² h⁶ + ε³ h⁴ |
//! | [`Saba2Gradient`](crate::Saba2Gradient) to [`Saba5Gradient`](crate::Saba5Gradient) | n = 2 to 5, gradient | ε h²ⁿ + ε² h⁴ |
//! | [`Rnia10_8_6`](crate::Rnia10_8_6), for oscillators | 12 | ε h¹⁰ + ε² h⁸ + ε³ h⁶ |
//! | [`Perturbation(X)`](crate::Perturbation), X a method of kicks and drifts | as X | as X, with A for the drift and B for the kick |
//! # Which coordinates
//! - `coordinates = jacobi`: each body moves about the centre of mass of all bodies before it. Order them by distance. More terms of q, as J₂, join
//!   B.
//! - `coordinates = heliocentric`: each body moves about body 0, in any order; orbits may cross, as of an asteroid and a planet (democratic
//!   heliocentric coordinates; the Sun's term belongs to B). Methods with force gradients do not compile.
//! - `split = "A | B"`: parts of your own. A needs a flow in closed form. B reads positions and time only. This is a satellite of the oblate Earth:
//!
//! ```
//! # use geoint_runtime::{nalgebra::Vector3, methods::*, prelude::*};
//! #[hamiltonian(split = "p.norm_squared() / 2.0 - mu / q.norm() | mu * c / 2.0 * (3.0 * q.z * q.z / q.norm_squared() - 1.0) / q.norm().powi(3)")]
//! fn satellite(q: Vector3<f64>, p: Vector3<f64>, mu: f64, c: f64) -> f64 { // q in km, p in km/s per unit mass; mu = GM, c = J₂R².
//!     p.norm_squared() / 2.0 - mu / q.norm() + mu * c / 2.0 * (3.0 * q.z * q.z / q.norm_squared() - 1.0) / q.norm().powi(3)
//! }
//! let start = State::new(Vector3::new(7000.0, 0.0, 0.0), Vector3::new(0.0, 4.687, 5.914));
//! let mut sim = Satellite { mu: 398600.4418, c: 44043.7 }.integrator(WisdomHolmanGradient, 300.0, start);
//! sim.advance(2880)?; // Ten days. The orbital plane turns by 44.9°.
//! # let State { q, p, .. } = sim.state(); assert!(((q[1] * p[2] - q[2] * p[1]).atan2(q[0] * p[2] - q[2] * p[0]).to_degrees() + 44.9).abs() < 0.1);
//! # Ok::<(), StepError>(())
//! ```
//!
//! # Millions of years
//! `WisdomHolmanGradient` with h = 100 d takes the outer planets of the table through 10⁷ years in 12 s. The energy is right to 1e-12, and positions
//! differ by at most 1e-4 AU from those with h = 50 d. With `.compensated()` the energy is right to 2e-13.
//!
//! With a mass of 1e-30, the asteroid does not change the energy, and the energy does not show its error: compare runs with h and h/2. For Sun,
//! asteroid (a = 2.6 AU, e = 0.1), Jupiter and Saturn, `Aba10_6_4` with `heliocentric` and h = 156 d takes 0.4 s for 10⁵ years. Positions with h and
//! h/2 differ by 6e-8, 7e-7 and 7e-6 AU after 10³, 10⁴ and 10⁵ years. The growth is linear, as for every symplectic method on a regular orbit: expect
//! 7e-4 AU for 10⁷ years. For e = 0.6 and h = 38 d they differ by 6e-8, 1e-5 and 4 AU: the orbit is chaotic. Choose h from the shortest perihelion
//! distance d: h ≤ T/8 with T = 2π √(d³/(GM(1 + e))).
//! # Close encounters
//! B is not small in an encounter, and a method with fixed steps then loses accuracy without an error. Take Taylor series or an adaptive run. The
//! asteroid with e = 0.1 costs 2 s by Taylor series or 3 s by `adaptive(DOP853, 1e-12, start)` for 10⁵ years. Burrau's three bodies start at
//! distances 3, 4 and 5, and come as close as 4e-4. The run takes about 3500 steps of very different lengths. `Projection` keeps the energy to
//! rounding:
//!
//! ```
//! # use geoint_runtime::{methods::*, prelude::*};
//! #[hamiltonian]
//! fn burrau(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3]) -> f64 {
//!     let kinetic = |i: usize| (p[i][0].powi(2) + p[i][1].powi(2)) / (2.0 * m[i]);
//!     let attraction = |i: usize, j: usize| m[i] * m[j] / ((q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2)).sqrt();
//!     kinetic(0) + kinetic(1) + kinetic(2) - attraction(0, 1) - attraction(0, 2) - attraction(1, 2)
//! }
//! let start = State::new([[1.0, 3.0], [-2.0, -1.0], [1.0, -1.0]], [[0.0; 2]; 3]);
//! let mut sim = Burrau { m: [3.0, 4.0, 5.0] }.taylor(Projection(Taylor::default(), Energy), start);
//! sim.advance_to(70.0)?;
//! assert!((sim.energy() + 12.0 / 5.0 + 15.0 / 4.0 + 20.0 / 3.0).abs() < 1e-12 && sim.steps() < 3700);
//! # Ok::<(), StepError>(())
//! ```
//! # Errors and limits
//! - h ≤ T/8 with `WisdomHolman…`, and h ≤ T/5 with `Aba10_6_4`, are upper limits, for the shortest T as above. Longer steps resonate with the
//!   orbits and give wrong results without an error. Halve h and compare.
//! - No method changes to another one in an encounter by itself. To find encounters, stop at a distance by [`until_event`](super::_12_events).
//! - Processed methods (`WisdomHolmanProcessed`, `WisdomHolmanGradient`) compute 12 kicks and 13 flows for each state that you read, and
//!   an event search reads one in each step.
//! - `OutsideDomain`: a mass is zero, or all bodies before a body together have less than 1e-16 of its mass: write the Sun first.
//! - [`Pole`](crate::Failure::Pole): an orbit meets its focus.
//! - A planet's moon makes B large: take `BlanesMoanSrkn14a` or Taylor series.
//! - Up to about 20 bodies in space compile. For more bodies, [write the system by hand](super::_14_by_hand).
//!
//! Next: [energy kept exactly](super::_07_energy), [events and sections](super::_12_events), [a run in practice](super::_06_runs).
