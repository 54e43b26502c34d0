//! Stop a run at an event, collect the points of a section, and read states between the ends of steps.
//!
//! A ball bounces and comes to rest. [`until_event`](crate::Dense::until_event) runs to the first impact, or exactly to the given time:
//!
//! ```standalone_crate
//! use geoint_runtime::prelude::*;
//!
//! /// A ball above the ground; q is the height.
//! #[hamiltonian]
//! fn ball(q: f64, p: f64, m: f64, g: f64) -> f64 { p * p / (2.0 * m) + m * g * q }
//!
//! let mut sim = Ball { m: 0.16, g: 9.81 }.integrator(StormerVerlet, 0.01, State::new(2.0, 0.0));
//! let mut impacts = 0;
//! while let Some(impact) = sim.until_event(20.0, Direction::Down, |state| state.q)? {
//!     impacts += 1;
//!     let p = -0.8 * impact.state.p; // 80 % of the speed remain.
//!     sim.set_state(State { q: 0.0, p, ..impact.state });
//!     if p < 1e-3 {
//!         break; // The ball lies on the ground. Step it no longer.
//!     }
//! }
//! println!("{impacts} impacts, at rest at {:.3} s", sim.time()); // 31 impacts, at rest at 5.741 s
//! # assert_eq!((impacts, (sim.time() * 1000.0).round()), (31, 5741.0));
//! # Ok::<(), StepError>(())
//! ```
//!
//! - `g` is a function of the state. An event is a change of its sign. The ball touches the ground where its height `state.q` falls through zero.
//! - For several bodies write `state.q[0][1]` (arrays `[[f64; 2]; N]`) or `state.q[0].y` (`[Vector3<f64>; N]`).
//! - `Direction::Up` selects changes from negative to positive, `Down` from positive to negative, and `Any` both.
//! - `g` may return an array such as `[state.q, state.p]`. `impact.which` is then the index of the function, and `impact.rises` its direction.
//!   Events at one time, as in a corner, are reported one by one.
//! - [`set_state`](crate::Dense::set_state) continues from another state. Set the position exactly onto the ground, as above.
//! - A search that starts at an event does not report it again. A run that starts with `g` at zero, as a ball on the ground, has no event there.
//!
//! **A ball that comes to rest** has infinitely many impacts in a finite time. Directly after an impact, a run with fixed steps misses the next one
//! if it follows within about 10⁻⁶ of a step, and the ball falls through the ground. In `f32` the limit grows with time: 2·10⁻⁴ of a step after 200
//! steps, and a tenth of a step after 10⁵ steps. A Taylor run never ends: it finds ever shorter bounces. Choose a speed below which the ball lies
//! down.
//! # A Poincaré section
//! [`crossings`](crate::Dense::crossings) is an iterator over all events. The section of a driven oscillator is one state in each period:
//! `sampled_every(period)`. Without driving, a section in a plane needs two degrees of freedom: energy and event leave two of the four coordinates
//! free. Give the search an end by `until`: an orbit that never comes back would be followed without end. The program collects points (y, p_y) of a
//! star at x = 0 with p_x > 0:
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! #[hamiltonian] // Hénon–Heiles: a star in the plane of a galaxy; q = (x, y).
//! fn henon_heiles(q: [f64; 2], p: [f64; 2]) -> f64 {
//!     let [x, y] = q;
//!     (p[0] * p[0] + p[1] * p[1] + x * x + y * y) / 2.0 + x * x * y - y * y * y / 3.0
//! }
//! let (energy, y) = (1.0 / 8.0, 0.1_f64); // The start: x = 0, y = 0.1, p_y = 0.
//! let px = (2.0 * energy - y * y + 2.0 / 3.0 * y.powi(3)).sqrt();
//! let mut sim = HenonHeiles.taylor(Taylor::default(), State::new([0.0, y], [px, 0.0]));
//! for crossing in sim.crossings(Direction::Up, |state| state.q[0]).until(2000.0).take(200) {
//!     let state = crossing?.state;
//!     println!("{},{}", state.q[1], state.p[1]);
//!     assert!(state.q[0].abs() < 1e-14 && (HenonHeiles.energy(&state) - energy).abs() < 1e-14);
//! }
//! # Ok::<(), StepError>(())
//! ```
//!
//! The restricted three-body problem couples q and p. In the rotating frame, the momenta are x' − y and y' + x. At the first 100 crossings, a Taylor
//! run keeps the energy H of that frame (the Jacobi constant is −2H) to 10⁻¹⁴, and `KahanLi8_17a.of(PieceSplitting)` with h = 0.02 keeps H to
//! 2·10⁻¹³:
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! #[hamiltonian]
//! fn restricted(q: [f64; 2], p: [f64; 2], mu: f64) -> f64 {
//!     let ([x, y], [px, py]) = (q, p);
//!     (px * px + py * py) / 2.0 + y * px - x * py - (1.0 - mu) / (x + mu).hypot(y) - mu / (x + mu - 1.0).hypot(y)
//! }
//! let (moon, start) = (Restricted { mu: 0.01215 }, State::new([0.5, 0.0], [0.0, 1.2]));
//! let mut sim = moon.taylor(Taylor::default(), start); // Or: moon.integrator(KahanLi8_17a.of(PieceSplitting), 0.02, start)
//! for point in sim.crossings(Direction::Up, |state| state.q[1]).take(100) {
//!     assert!((moon.energy(&point?.state) - moon.energy(&start)).abs() < 1e-14);
//! }
//! # Ok::<(), StepError>(())
//! ```
//! # States at given times
//! Output changes no step. A run with steps of 0.3 passes the last sample, because a step ends only every 0.3:
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! # #[hamiltonian] fn oscillator(q: f64, p: f64) -> f64 { p * p / 2.0 + q * q / 2.0 }
//! let mut sim = Oscillator.integrator(BlanesMoan4, 0.3, State::new(1.0, 0.0));
//! let times: Result<Vec<f64>, StepError> = sim.sampled_every(0.5).take(3).map(|state| Ok(state?.t)).collect();
//! assert_eq!(times?, [0.0, 0.5, 1.0]);
//! assert!((sim.time() - 1.2).abs() < 1e-12);
//! let late: Result<Vec<f64>, StepError> = sim.sampled_at([1.25, 1.9]).map(|state| Ok(state?.t)).collect();
//! assert_eq!(late?, [1.25, 1.9]);
//! assert_eq!(sim.sampled_at([1.0]).next(), Some(Err(StepError::new(Failure::TimePassed, 1.0, 0.0))));
//! assert!(sim.until_event(2.5, Direction::Up, |state| state.q - 5.0)?.is_none());
//! assert_eq!(sim.time(), 2.5); // An event search ends exactly at its time.
//! # Ok::<(), StepError>(())
//! ```
//!
//! | call | result |
//! |---|---|
//! | [`sampled_every(dt)`](crate::Dense::sampled_every) | states at t₀, t₀ + dt, t₀ + 2 dt, …, without end: use `take` |
//! | [`sampled_at(times)`](crate::Dense::sampled_at) | states at the given times, in order |
//! | `.interpolated()` behind either call | one polynomial per step: cheaper for many states per step; invariants are not kept to rounding |
//! | [`at(t)`](crate::Dense::at) | the state at a time within the last step; for other times an error that names this interval |
//!
//! A state between steps comes from a shorter step of the same method and has the order of the method. Taylor runs evaluate the step's polynomial.
//! # Which events are found
//! | run | two zeros within one step |
//! |---|---|
//! | fixed steps, adaptive | found if `g` comes near zero between the ends: a parabola through three values shows where, and the search follows it |
//! | Taylor | all zeros of the polynomial of `g` are found |
//! - An oscillator with 20 fixed steps a period and two zeros 10⁻⁴ of a step apart: 199 of 200 such pairs were found.
//! - If `g` oscillates faster than the steps, use shorter steps or a Taylor run. For `sin(40 q)`, q must change by less than π/40 in a step.
//! - In a Taylor run, `g` computes with power series in place of numbers: `+ − × ÷`, `sqrt`, `sin` and others, but no `norm`, `if` or comparison.
//!   Write a distance by the squares of its components.
//! - Poles of `g` are no events. A `g` that is not finite, or is zero for more than a step, is the error [`NoEvent`](crate::Failure::NoEvent).
//! - A condition inside the energy (`if`, `abs`, `min`) needs no event: see [the language of energies](super::_04_language).
//!
//! Next: [games and real time](super::_13_real_time), [a run in practice](super::_06_runs), [which method](super::_03_which_method).
