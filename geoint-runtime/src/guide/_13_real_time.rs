//! Step bodies in a frame loop, in `f32`, without allocation, with the same bits on every machine.
//!
//! A ball bounces at 60 frames per second. Each call of `frame` simulates one frame, with or without a hit:
//!
//! ```
//! use geoint_runtime::{Splitting, prelude::*};
//!
//! /// A ball; q = (x, height) in m, p in kg m/s.
//! #[hamiltonian]
//! pub fn ball(q: [f32; 2], p: [f32; 2], m: f32, g: f32) -> f32 { (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + m * g * q[1] }
//!
//! const FRAME: f32 = 1.0 / 60.0;
//! const BOUNCE: f32 = 0.5;
//! type Run = Integrator<Ball<f32>, Splitting<1>, f32>; // System (with its parameters), method, scalar type of the time.
//!
//! /// Simulates to the end of a frame. Returns whether the ball has stopped bouncing.
//! fn frame(run: &mut Run, end: f32) -> Result<bool, StepError> {
//!     while let Some(hit) = run.until_event(end, Direction::Down, |state| state.q[1])? {
//!         let (along, up) = (0.8 * hit.state.p[0], -BOUNCE * hit.state.p[1]); // The ground brakes both.
//!         run.set_state(State { q: [hit.state.q[0], 0.0], p: [along, up], ..hit.state });
//!         let Ball { m, g } = *run.system();
//!         if up < 0.5 * FRAME * m * g {
//!             return Ok(true); // The next bounce would be shorter than a frame: the game freezes the ball.
//!         }
//!     }
//!     Ok(false)
//! }
//!
//! let mut run = Ball { m: 1.0, g: 9.81 }.integrator(StormerVerlet, FRAME, State::new([0.0, 2.0], [1.0, 0.0]));
//! let (mut frames, mut frozen) = (0_u16, false);
//! while !frozen { // A game loop skips a frozen body until something touches it.
//!     if frames == 600 { // Ten seconds. The clock and its counter restart.
//!         run.set_state(State { t: 0.0, ..run.state() });
//!         frames = 0;
//!     }
//!     frames += 1;
//!     frozen = frame(&mut run, f32::from(frames) * FRAME)?;
//! }
//! println!("frozen after {frames} frames at x = {:.2} m", run.state().q[0]);
//! # assert!((frames, run.state().q[1]) == (114, 0.0) && (run.state().q[0] - 1.48).abs() < 0.02);
//! # Ok::<(), StepError>(())
//! ```
//!
//! - **Scalar and step.** With `f32` in the arguments of the energy, the whole run computes in `f32`. Take one or a few steps for each frame, such as
//!   `FRAME / 4.0`. [`until_event`](crate::Dense::until_event) shortens the last step if necessary.
//! - **The clock.** A time in `f32` has a resolution of 0.0002 s after one hour. Restart the clock as above, if the energy does not depend on time.
//! - **Rest.** Bounces become infinitely short. If a bounce is shorter than 2·10⁻⁴ of a step (clock near 0) or a tenth of a step (clock at 10⁵
//!   steps), an `f32` run misses it, and the body falls through the ground. The program freezes the ball well before. To wake it, call `set_state`
//!   with a new p and the time of the frame.
//! # Bodies that hit each other
//! `g` returns an array, one gap for each pair. `hit.which` is the index of the pair. These are three discs of equal mass and radius on a
//! table. Discs that touch, as billiard balls in a rack, pass a push on: events at one time come one by one.
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! #[hamiltonian]
//! fn discs(q: [[f32; 2]; 3], p: [[f32; 2]; 3]) -> f32 { (0..3).map(|i| p[i][0].powi(2) + p[i][1].powi(2)).sum::<f32>() / 2.0 }
//! let start = State::new([[0.0_f32, 0.0], [1.0, 0.02], [2.0, 0.0]], [[1.0, 0.0], [0.0; 2], [0.0; 2]]);
//! let (mut run, radius, end) = (Discs.integrator(StormerVerlet, 1.0 / 60.0, start), 0.1, 5.0);
//! const PAIRS: [[usize; 2]; 3] = [[0, 1], [0, 2], [1, 2]];
//! let gap = |a: [f32; 2], b: [f32; 2]| (b[0] - a[0]).hypot(b[1] - a[1]) - 2.0 * radius;
//! while let Some(hit) = run.until_event(end, Direction::Down, |state| PAIRS.map(|[i, j]| gap(state.q[i], state.q[j])))? {
//!     let ([i, j], State { q, mut p, .. }) = (PAIRS[hit.which], hit.state);
//!     let n = [0, 1].map(|k| (q[j][k] - q[i][k]) / (2.0 * radius)); // The line of centres.
//!     let push = n[0] * (p[i][0] - p[j][0]) + n[1] * (p[i][1] - p[j][1]);
//!     for k in 0..2 { (p[i][k], p[j][k]) = (p[i][k] - push * n[k], p[j][k] + push * n[k]); }
//!     run.set_state(State { p, ..hit.state });
//! }
//! # assert!(run.state().p[2][0] > 0.6 && run.time() == 5.0 && (run.energy() - 0.5).abs() < 1e-6);
//! # Ok::<(), StepError>(())
//! ```
//! # Size and speed
//! A run is a plain value, and a step allocates nothing. The table was measured on one laptop-class core, in `f32`, with steps of 1/60 s:
//!
//! | system | method | bytes | ns per step |
//! |---|---|---|---|
//! | ball in the plane | `StormerVerlet` | 240 | 11 |
//! | ball in the plane | `DiscreteGradient` | 448 | 18 |
//! | double pendulum | `DiscreteGradient` | 696 | 140 |
//! | chain of 16 masses | `StormerVerlet` | 832 | 50 |
//! | chain of 16 masses | `DiscreteGradient` | 2064 | 570 |
//!
//! The times are good to 20 %. The state of the ball takes 20 bytes; the method takes the rest. A frame by `until_event` costs nine plain steps of
//! this ball (100 ns) while `g` stays far from zero, and up to thirty near a hit: it copies the run, and measures the slope of `g` by a short step.
//! - **A thousand balls** that do not hit each other are a `Vec<Run>`. A frame of all takes 0.1 ms in flight. One energy with 32 copies of a
//!   small system halves the time of explicit methods; an error or event in one copy stops all.
//! - **Pairs.** n bodies in one energy have n(n − 1)/2 gaps: fine for ten bodies. For more, find pairs by a grid of your own after each
//!   frame, and change the runs by `set_state`. For stacks of resting bodies take a physics engine.
//! - **Springs and ropes** are one energy, as the chain on the page on [the language](super::_04_language), with at most 150 points in space. A rope
//!   only pulls: `k * (d - l).max(0.0).powi(2) / 2.0`. With `StormerVerlet`, h √(k/m) of a single spring must stay below 2, and below 1 in a chain.
//!   `DiscreteGradient` has no such limit. [Friction](super::_08_friction) makes it calm.
//! - **Ground for many points:** a soft one in the energy, `k * (-y).max(0.0).powi(2) / 2.0`. For few hard bounces: `until_event`.
//! # Consoles and microcontrollers: `no_std`
//! ```toml
//! [dependencies]
//! geoint-runtime = { version = "0.1", default-features = false }
//! ```
//!
//! `core` has no `cos` and no `sqrt`. The trait [`Real`](crate::Real) of the prelude adds them from the crate `libm`. Events need no
//! allocation: `until_event` works without `alloc`.
//!
//! ```
//! #![no_std]
//! use geoint_runtime::prelude::*;
//!
//! #[hamiltonian]
//! pub fn pendulum(q: f32, p: f32, g: f32) -> f32 { p * p / 2.0 - g * q.cos() }
//! # fn main() { assert!(Pendulum { g: 9.81_f32 }.integrator(StormerVerlet, 0.01, State::new(1.0, 0.0)).advance(100).is_ok()); }
//! ```
//! # The same bits on every machine
//! | requirement | setting |
//! |---|---|
//! | no fused multiply-add | `default-features = false`, or the feature `strict-math` |
//! | the same `sin`, `exp`, … everywhere | `default-features = false`, for `libm`; no crate of the program may enable `std` |
//! | the same sequence of steps | the same calls with the same numbers on every machine |
//!
//! For a replay or a network game, [`saved()`](crate::running::Resumable::saved) returns all data on which the next step depends, as `u64` words.
//! [`resume`](crate::running::Resumable::resume) continues with the same bits. Both need the feature `alloc`. For a rollback, `clone()` the run.
//!
//! Next: [events](super::_12_events), [a run in practice](super::_06_runs), [limits](super::_18_limits).
