//! Find your library on this page, and the translation of a program from that library.
//!
//! # SciPy
//! ```text
//! f = lambda t, y: [y[1], -9.8 * np.sin(y[0])]
//! sol = solve_ivp(f, (0, 10), [0.05, 0.025], method="DOP853", t_eval=[2.5, 5, 10], rtol=1e-9, atol=1e-9)
//! ```
//! ```standalone_crate
//! use geoint_runtime::prelude::*;
//!
//! #[vector_field]
//! fn pendulum(x: [f64; 2]) -> [f64; 2] {
//!     [x[1], -9.8 * x[0].sin()]
//! }
//! let mut sim = Pendulum.adaptive(DOP853, 1e-9, FlowState::new([0.05, 0.025]));
//! for state in sim.sampled_at([2.5, 5.0, 10.0]) {
//!     let state = state?;
//!     println!("{} {:?}", state.t, state.x); // the last line: 10 [0.04873968738122137, 0.04294234191519487]
//! #   assert!(state.t < 10.0 || (state.x[0] - 0.04873968738598).abs() < 1e-10 && (state.x[1] - 0.04294234187909).abs() < 1e-10);
//! }
//! # assert!((10.05..10.15).contains(&sim.time())); Ok::<(), StepError>(())
//! ```
//! - The tolerance is relative to the largest magnitude that each coordinate has had. `.absolute(state)` adds an `atol` for each coordinate.
//! - A sample costs a short step of the same order. The run itself stops after the last sample: `sim.time()` is 10.1 here.
//! - A field has few methods. Write an energy if you know one, as the programs below do. The state is then (q, **p**).
//!
//! # odeint
//! ```text
//! typedef symplectic_rkn_sb3a_mclachlan<state_type> stepper;
//! integrate_n_steps(stepper(), make_pair(velocity, force), make_pair(boost::ref(q), boost::ref(p)), 0.0, 0.1, 100);
//! ```
//! ```
//! # use geoint_runtime::prelude::*;
//! #[hamiltonian]
//! fn pendulum(q: f64, p: f64) -> f64 {
//!     p * p / 2.0 - 9.8 * q.cos()
//! }
//! let mut sim = Pendulum.integrator(BlanesMoan4, 0.1, State::new(0.05, 0.025));
//! sim.advance(100)?;
//! # assert!((sim.state().q - 0.048739687386).abs() < 1e-7 && sim.time() == 10.0); Ok::<(), StepError>(())
//! ```
//! The functions `velocity` and `force` are derived from the energy. An observer is a loop: `for state in sim.until(10.0)`.
//!
//! # DifferentialEquations.jl
//! ```text
//! prob = SecondOrderODEProblem((dq, q, p, t) -> -9.8sin.(q), [0.025], [0.05], (0.0, 10.0))
//! sol = solve(prob, KahanLi8(), dt = 0.1)
//! ```
//! ```
//! # use geoint_runtime::{methods::*, prelude::*}; #[hamiltonian] fn pendulum(q: f64, p: f64) -> f64 { p * p / 2.0 - 9.8 * q.cos() }
//! let mut sim = Pendulum.integrator(KahanLi8_17a.of(StormerVerlet), 0.1, State::new(0.05, 0.025));
//! let states: Vec<State<f64>> = sim.until(10.0).collect::<Result<_, _>>()?;
//! # assert!(states.len() == 100 && (states[99].q - 0.048739687386).abs() < 1e-9); Ok::<(), StepError>(())
//! ```
//! Julia's problem types take the velocity first. `State::new(q, p)` takes the position first. The collected states do not include the start.
//!
//! # GeometricIntegrators.jl
//! ```text
//! v(v, t, q, p, params) = (v[1] = p[1])
//! f(f, t, q, p, params) = (f[1] = -9.8sin(q[1]))
//! H(t, q, p, params) = p[1]^2 / 2 - 9.8cos(q[1])
//! sol = integrate(HODEProblem(v, f, H, (0.0, 10.0), 0.1, [0.05], [0.025]), Gauss(2))
//! ```
//! ```
//! # use geoint_runtime::prelude::*; #[hamiltonian] fn pendulum(q: f64, p: f64) -> f64 { p * p / 2.0 - 9.8 * q.cos() }
//! let mut sim = Pendulum.integrator(Gauss::<2>, 0.1, State::new(0.05, 0.025));
//! sim.advance_to(10.0)?;
//! # assert!((sim.state().q - 0.048739687386).abs() < 1e-5 && sim.time() == 10.0); Ok::<(), StepError>(())
//! ```
//! `Gauss::<1>` to `Gauss::<6>` exist. An `LODEProblem` is a [`#[lagrangian]`](crate::lagrangian), whose state is (q, p) too.
//!
//! # heyoka.py
//! ```text
//! q, p = hy.make_vars("q", "p")
//! ta = hy.taylor_adaptive(hy.hamiltonian(p**2 / 2 - 9.8 * hy.cos(q), [q], [p]), [0.05, 0.025])
//! ta.propagate_until(10.0)
//! ```
//! ```
//! # use geoint_runtime::prelude::*; #[hamiltonian] fn pendulum(q: f64, p: f64) -> f64 { p * p / 2.0 - 9.8 * q.cos() }
//! let mut sim = Pendulum.taylor(Taylor::default(), State::new(0.05, 0.025));
//! sim.advance_to(10.0)?; // ends exactly at 10
//! # assert!((sim.state().q - 0.04873968738598032).abs() < 1e-14 && sim.time() == 10.0); Ok::<(), StepError>(())
//! ```
//! The energy is compiled with your program, and so is the number of coordinates. Numbers are `f64` or `f32`. A batch mode does not exist.
//!
//! # REBOUND
//! ```text
//! sim.add(m=1); sim.add(m=1e-3, x=1, vy=1); sim.add(m=1e-3, x=-2, vy=-0.7)
//! sim.integrator = "whfast"; sim.dt = 0.05; sim.integrate(1000)
//! ```
//! ```
//! # use geoint_runtime::{methods::*, prelude::*};
//! #[hamiltonian(coordinates = jacobi)]
//! fn planets(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3], g: f64) -> f64 {
//!     let kinetic = (0..3).map(|i| (p[i][0].powi(2) + p[i][1].powi(2)) / (2.0 * m[i])).sum::<f64>();
//!     let pair = |i: usize, j: usize| m[i] * m[j] / ((q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2)).sqrt();
//!     kinetic - g * (pair(0, 1) + pair(0, 2) + pair(1, 2))
//! }
//! let start = State::new([[0.0, 0.0], [1.0, 0.0], [-2.0, 0.0]], [[0.0, 0.0], [0.0, 1e-3], [0.0, -0.7e-3]]);
//! let mut sim = Planets { m: [1.0, 1e-3, 1e-3], g: 1.0 }.integrator(WisdomHolman, 0.05, start);
//! # let energy = sim.energy();
//! sim.advance_to(1000.0)?;
//! # assert!((sim.energy() / energy - 1.0).abs() < 1e-6 && sim.time() == 1000.0); Ok::<(), StepError>(())
//! ```
//! - Momenta are m v. G is a parameter of yours. The centre of mass moves until you subtract its motion from the start.
//! - `integrate(t)` shortens the last step, or passes t if `exact_finish_time=0`. Fixed steps here stop at the last whole step before t.
//! - A body of mass zero is refused with `coordinates = jacobi`. A mass of 1e-30 is accepted. Collisions are [events](super::_12_events).
//!
//! | here | SciPy | DifferentialEquations.jl | heyoka.py | REBOUND |
//! |---|---|---|---|---|
//! | fields of the system | `args` | `p` | `hy.par` | `m`, `G` |
//! | `advance_to(t)` | `t_span` | `tspan` | `propagate_until` | `integrate` |
//! | `sampled_at(times)` | `t_eval` | `saveat` | `propagate_grid` | a loop |
//! | `crossings(direction, g)` | `events` | `ContinuousCallback` | `nt_event` | |
//! | `until_event(t, direction, g)` | `terminal` | `terminate!` | `t_event` | |
//! | `set_system(system)` | | `integrator.p` | `ta.pars` | `m`, `G` |
//! | methods | `DOP853`: `DOP853` | `VelocityVerlet`: `StormerVerlet` | `Taylor` | `leapfrog`: `PositionVerlet`; instead of `ias15`: `Taylor` |
//!
//! The time of fixed steps is t₀ + n h: 100 steps of 0.1 end at exactly 10. Stochastic and delay equations do not exist here.
//! Next: [which attribute](super::_02_which_attribute), [a run in practice](super::_06_runs), [limits](super::_18_limits).
