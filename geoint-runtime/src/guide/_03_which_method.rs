//! Choose a method by your question, and compare it with others on your own problem.
//!
//! A method is a value. Exchange it, and the rest of the program stays. This program compares four methods on a pendulum. Each explicit method
//! evaluates 9800 forces, and the implicit `DiscreteGradient` takes 9800 steps:
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! #[hamiltonian]
//! fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
//!     p * p / (2.0 * m * l * l) - m * g * l * q.cos()
//! }
//!
//! /// Error of the angle after 98 s, and the largest relative error of the energy.
//! fn errors<M: Method<Pendulum>>(method: M, h: f64) -> Result<[f64; 2], StepError> {
//!     let (system, start) = (Pendulum { m: 1.0, l: 1.0, g: 9.81 }, State::new(2.0, 0.0));
//!     let mut exact = system.taylor(Taylor::default(), start);
//!     exact.advance_to(98.0)?;
//!     let mut sim = system.integrator(method, h, start);
//!     let mut largest = 0.0_f64;
//!     for state in sim.until(98.0) {
//!         largest = largest.max((system.energy(&state?) / system.energy(&start) - 1.0).abs());
//!     }
//!     Ok([(sim.state().q - exact.state().q).abs(), largest])
//! }
//!
//! fn main() -> Result<(), StepError> {
//!     let verlet = errors(StormerVerlet, 0.01)?;
//!     let rk4 = errors(RK4, 0.04)?;
//!     let nystrom = errors(BlanesMoanSrkn14a, 0.14)?;
//!     let gradient = errors(DiscreteGradient, 0.01)?;
//!     println!("{verlet:?} {rk4:?} {nystrom:?} {gradient:?}");
//! #   let near = |[a, b]: [f64; 2], [c, d]: [f64; 2]| (a / c - 1.0).abs() < 0.1 && (b / d - 1.0).abs() < 0.1;
//! #   assert!(near(verlet, [1.02e-2, 6.4e-4]) && near(rk4, [8.6e-3, 2.3e-4]) && near(nystrom, [6.1e-8, 4.9e-9]));
//! #   assert!(near([gradient[0], 1.0], [7.8e-3, 1.0]) && gradient[1] < 1e-14);
//!     Ok(())
//! }
//! ```
//!
//! | method | step | error of the angle | error of the energy | the energy error over a longer time |
//! |---|---|---|---|---|
//! | `StormerVerlet` | 0.01 s | 1e-2 | 6e-4 | stays bounded |
//! | `RK4` | 0.04 s | 9e-3 | 2e-4 | grows with time |
//! | `BlanesMoanSrkn14a` | 0.14 s | 6e-8 | 5e-9 | stays bounded |
//! | `DiscreteGradient` | 0.01 s | 8e-3 | 2e-15 | stays at rounding |
//!
//! # Find your question
//! T is the kinetic and V the potential energy. Every system has a [report](super::_05_report): `println!("{}", Pendulum::REPORT)`. It says
//! whether your energy has the form T(p) + V(q), and whether T is quadratic.
//!
//! | question | take | measured |
//! |---|---|---|
//! | I do not know yet | [`DiscreteGradient`](crate::DiscreteGradient) | pendulum, 10⁶ steps of 0.02 s: energy to 3e-15 |
//! | many bodies, molecules, a game | [`StormerVerlet`](crate::StormerVerlet) (leapfrog) | star in a galaxy, 10⁷ periods of 40 steps: energy 5e-3 |
//! | accurate positions, long runs | [`BlanesMoanSrkn14a`]; T not quadratic: [`BlanesMoan6`] | outer planets, 547 years, 20 000 forces: 5e-7 AU |
//! | planets, no close encounters | [`WisdomHolmanGradient`](crate::WisdomHolmanGradient) with `coordinates = jacobi` | the same planets, 2000 forces: 9e-10 AU |
//! | weakly coupled oscillators, no friction | [`Rnia10_8_6`](crate::Rnia10_8_6), see [planets](super::_09_planets) for A + B | chain of 31 masses, 171 periods of the slowest wave, 1000 steps: positions to 3e-10 |
//! | q and p coupled: jointed arms | [`Gauss::<3>`](crate::Gauss) | double pendulum, regular orbit, 200 s, h = 0.02 s: 8e-8 m |
//! | magnetic field, rotating frame | `Taylor`, or [`BceRkn17_8.of(PieceSplitting)`](crate::PieceSplitting) | charge, 10⁶ gyrations of 12 steps: drift to 2e-10 |
//! | friction −γp, one γ; T quadratic, or else | [`BlanesMoanSrkn11b`], or `ContactGauss::<3>`; [contact form](super::_02_which_attribute) | oscillator, γ = 0.1, t = 50, 40 forces a unit of time: positions to 2e-10 |
//! | other friction; friction never adds energy | `damping = C`, `DiscreteGradient` | Duffing's oscillator without driving, 400 steps of 10 (stable, not accurate): no step gains energy |
//! | bars, closed chains | [`Rattle`](crate::Rattle); for the energy, `DiscreteGradient` | four bars: lengths to 7e-16; energy with `DiscreteGradient`: 2e-13 |
//! | rigid bodies, `attitude = r` | `BlanesMoanSrkn14a` | heavy body, 20 steps of 0.25: 4e-11 rad |
//! | most digits, encounters, chaos, sections | [`Taylor`](crate::Taylor), as in the program above | three bodies, 100 periods and back: positions to 3e-13 |
//! | equations with known invariants | `FourthOrder(DiscreteGradient)` | predators and prey, 10⁵ periods of 50 steps: invariant to 5e-15 |
//!
//! For comparison: with equally many forces, leapfrog misses the planets by 0.1 AU (20 000 forces), and `RK4` has an error of 5e-6 for the
//! oscillator with friction and of 2e-6 rad for the heavy body. With 40 steps in each gyration, `RK4` brakes the charge until it stands.
//!
//! A *piece* is a part of the energy whose flow is known in closed form; `REPORT` lists the pieces. `BceRkn17_8.of(PieceSplitting)` works if
//! `REPORT` lists two pieces and prints `tables of Runge–Kutta–Nyström type keep their order`. Otherwise,
//! take `KahanLi8_17a.of(PieceSplitting)`.
//!
//! **Rules of thumb** for the error of positions:
//!
//! - Planets: `WisdomHolmanProcessed` for errors above 10⁻⁶, `WisdomHolmanGradient` below. Weakly coupled oscillators: `Rnia10_8_6`.
//! - Friction −γp with one γ, T quadratic: `BlanesMoanSrkn11b` at all errors. Any other T(p) + V(q): `BlanesMoanSrkn14a` or `BlanesMoan6` down to
//!   10⁻⁹. Below 10⁻⁹, and with few bodies: `Taylor`.
//! - All other energies: the method of the table down to 10⁻⁹. Below, `Taylor`; for some systems it [does not exist](super::_18_limits).
//! - Two bodies on eccentric orbits: `Taylor` for all errors below 10⁻³.
//! - If only the energy counts, in a long or chaotic run: a symplectic or energy-keeping method. Chaos with friction: the methods of the friction
//!   rows. They give averages and the attractor; no method follows one orbit for long.
//! - On a chaotic orbit every method loses digits exponentially. The error grows as exp(λt), with the Lyapunov exponent λ; page 2 has a
//!   [recipe](super::_02_which_attribute) for it.
//!
//! `system.adaptive(DOP853, 1e-9, state)` is a usual solver with error control, such as `ode45` or `solve_ivp`. Its energy error grows with time. For
//! the length of a step, see [a run in practice](super::_06_runs).
//! # Families
//!
//! | family | order | keeps | names elsewhere |
//! |---|---|---|---|
//! | `StormerVerlet`, `PositionVerlet` | 2 | symplectic form, time symmetry | leapfrog; velocity, position Verlet |
//! | `SymplecticEuler` | 1 | symplectic form | semi-implicit Euler |
//! | kicks and drifts: `PEFRL`, `BlanesMoan6`, `BlanesMoanSrkn14a`, `BceRkn17_8` | 4 to 8 | symplectic form, time symmetry | Runge–Kutta–Nyström |
//! | H = A + B with a small B: `WisdomHolman`, `Aba10_6_4` | several: see [planets](super::_09_planets) | symplectic form | mixed-variable map, SABA |
//! | exact flows: `PieceSplitting`, `ContactSplitting`, `PoissonSplitting` | 2 | the structure of the name, time symmetry | Strang splitting |
//! | `Yoshida4`, `Suzuki4`, `KahanLi8_17a` and others `.of(map)` | 4 to 10 | all that the map in `.of(map)` keeps | triple jump, composition |
//! | `ImplicitMidpoint`, `Gauss::<S>` | 2, 2S | symplectic form, quadratic invariants | Gauss–Legendre, collocation |
//! | `ContactMidpoint`, `ContactGauss::<S>` | 2, 2S | contact form, see [friction](super::_08_friction) | |
//! | `DiscreteGradient`, `Gonzalez`, `ItohAbePair`, `MeanValue` | 2 | energy at any step | energy–momentum; averaged vector field |
//! | `FourthOrder(DiscreteGradient)` | 4 | energy at any step | |
//! | `ContactDiscreteGradient` | 2 | the law of decay of H | |
//! | `Kahan`, for H of degree 3 | 2 | a modified energy | Hirota–Kimura |
//! | `Rattle` | 2 | constraints, symplectic form | SHAKE, RATTLE |
//! | `RK4`, `DOP853` | 4, 8 | nothing | Runge–Kutta, Dormand–Prince |
//! | `Projection(method, Energy)`, `Relaxation(method)` | of the method | energy | |
//! | `Taylor` | 20 | nothing exactly | Taylor integrator, TIDES |
//!
//! `MeanValue` keeps the energy if `REPORT` says so. [`method`](crate::method) lists all methods, and `use geoint_runtime::methods::*` imports them.
//!
//! # Errors
//!
//! If a method does not fit your energy, the program does not compile. The message names the term in the way, and methods that fit. A step whose
//! equation cannot be solved returns a [`StepError`](crate::StepError).
//!
//! Next: [the language of energies](super::_04_language), [a run in practice](super::_06_runs), [energy kept exactly](super::_07_energy).
//!
//! [`BlanesMoan6`]: crate::BlanesMoan6
//! [`BlanesMoanSrkn11b`]: crate::BlanesMoanSrkn11b
//! [`BlanesMoanSrkn14a`]: crate::BlanesMoanSrkn14a
