//! Integrate equations x' = f(x) with first integrals, energies with a bracket, and rigid bodies with an attitude.
//!
//! This program keeps two first integrals exactly, up to rounding. Name the integrals in the attribute. The compiler proves f·∇I = 0 for each
//! integral I.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// Euler's equations of a free rigid body; x angular velocity in the body frame; a, b, c moments of inertia.
//! #[vector_field(keeps(
//!     energy = (a * x[0] * x[0] + b * x[1] * x[1] + c * x[2] * x[2]) / 2.0,
//!     momentum = (a * a * x[0] * x[0] + b * b * x[1] * x[1] + c * c * x[2] * x[2]) / 2.0,
//! ))]
//! fn euler_top(x: [f64; 3], a: f64, b: f64, c: f64) -> [f64; 3] {
//!     [(b - c) / a * x[1] * x[2], (c - a) / b * x[2] * x[0], (a - b) / c * x[0] * x[1]]
//! }
//! let top = EulerTop { a: 1.0, b: 2.0, c: 3.0 };
//! let mut sim = top.integrator(DiscreteGradient, 0.1, FlowState::new([0.5, 0.8, -0.4]));
//! let before = sim.integrals();
//! sim.advance(100_000)?;
//! let after = sim.integrals();
//! assert!((0..2).all(|i| (after[i] / before[i] - 1.0).abs() < 1e-14));
//! # Ok::<(), StepError>(())
//! ```
//! - The state is a [`FlowState`](crate::FlowState) with the fields `t` and `x`. The field may read `t`. `sim.integrals()` returns the named
//!   integrals; an integral with the name `energy` is also `sim.energy()`.
//! - [`DiscreteGradient`](crate::DiscreteGradient) has order 2 and keeps all named integrals. `FourthOrder(DiscreteGradient)` has order 4.
//! - `Projection(DOP853, Integrals)` keeps all integrals that do not depend on `t`, by explicit steps.
//! - `keeps(name = I, but = [b₁, b₂, …])` names a part b(x) of the field that changes I: for the top with a torque u about the first axis,
//!   `but = [u / a, 0.0, 0.0]`. A step changes I by exactly the work of b.
//! - Without integrals: [`RK4`](crate::RK4), [`DOP853`](crate::DOP853), [`Gauss`](crate::Gauss), Taylor series.
//! # An energy on another phase space: x' = S(x) ∇H(x)
//! Give a skew matrix S and the energy. Point vortices, predator and prey, and rigid bodies have this form.
//! ```standalone_crate
//! # use geoint_runtime::prelude::*;
//! /// Predator and prey (Lotka and Volterra).
//! #[hamiltonian(structure = [[0.0, -x[0] * x[1]], [x[0] * x[1], 0.0]])]
//! fn lotka_volterra(x: [f64; 2], a: f64, b: f64, c: f64, d: f64) -> f64 {
//!     d * x[0] - c * x[0].ln() + b * x[1] - a * x[1].ln()
//! }
//! let animals = LotkaVolterra { a: 2.0, b: 1.0, c: 1.0, d: 1.0 };
//! let mut sim = animals.integrator(DiscreteGradient, 0.1, FlowState::new([1.0, 0.5]));
//! let energy = sim.energy();
//! sim.advance(100_000)?; // RK4 changes the energy by 0.12 on this run.
//! assert!((sim.energy() - energy).abs() < 1e-14);
//! # Ok::<(), StepError>(())
//! ```
//!
//! `structure` is a matrix, a closure that returns the entries above the diagonal (the example `vortices` has one), or a name: `so3` (x' = x × ∇H),
//! `se3` (heavy top, x = (m, γ)), `nambu(C)` (x' = ∇C × ∇H), `canonical`. The report states whether S is a Poisson structure. It lists the Casimirs:
//! functions C with S ∇C = 0, constant for every H.
//!
//! | method | order | keeps |
//! |---|---|---|
//! | `DiscreteGradient` | 2 | H and Casimirs of degree 2, to rounding |
//! | [`PoissonSplitting`](crate::PoissonSplitting) | 2 | the Poisson structure and Casimirs, to rounding; explicit |
//! | [`PlanarSplitting`](crate::PlanarSplitting) | 2 | H, to rounding; one plane of two coordinates at a time |
//! | `Suzuki4.of(…)` and other compositions of these | 4 to 10 | the same as the composed method |
//! # Rigid bodies with an attitude
//! `attitude = r` makes r a unit quaternion from body to space, and m the angular momentum in the body frame:
//!
//! ```
//! use geoint_runtime::{nalgebra::{UnitQuaternion, Vector3}, prelude::*};
//! /// A heavy top; c is weight times centre of mass in the body frame.
//! #[hamiltonian(attitude = r)]
//! fn top(r: UnitQuaternion<f64>, m: Vector3<f64>, inertia: [f64; 3], c: Vector3<f64>) -> f64 {
//!     (m.x * m.x / inertia[0] + m.y * m.y / inertia[1] + m.z * m.z / inertia[2]) / 2.0 + (r * c).z
//! }
//! let (system, m) = (Top { inertia: [1.0, 2.0, 3.0], c: Vector3::new(0.3, -0.2, 0.7) }, Vector3::new(0.5, 1.6, -1.2));
//! let mut sim = system.integrator(BlanesMoanSrkn14a, 0.25, BodyState::new(UnitQuaternion::identity(), m));
//! sim.advance(1000)?;
//! # assert!((sim.energy() - system.energy(&BodyState::new(UnitQuaternion::identity(), m))).abs() < 1e-9);
//! # Ok::<(), StepError>(())
//! ```
//!
//! The energy must be T(m) + V(r, t) with T quadratic in m, for one body or several. Methods: kicks and drifts (`StormerVerlet`, `BlanesMoanSrkn14a`,
//! `Chin4A`), [`FiveRotations`](crate::FiveRotations) (order 2, cheaper than `StormerVerlet`), `RK4`, `DOP853`, and adaptive runs. All keep r at
//! length 1. Implicit methods and Taylor series do not compile. `sim.state().r` is the attitude, `.m` the angular momentum; ω = (m.x/I₁, m.y/I₂,
//! m.z/I₃). `force` and `damping` do not compile. For wheels and thrusters with the torque u write the equations; u changes by `set_system`:
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! #[vector_field(keeps(length = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]))]
//! fn satellite(x: [f64; 7], i: [f64; 3], u: [f64; 3]) -> [f64; 7] { // Quaternion (w, i, j, k) from body to space, and ω in the body frame.
//!     let [w, a, b, c, p, q, r] = x;
//!     [-(a * p + b * q + c * r) / 2.0, (w * p + b * r - c * q) / 2.0, (w * q + c * p - a * r) / 2.0, (w * r + a * q - b * p) / 2.0,
//!      ((i[1] - i[2]) * q * r + u[0]) / i[0], ((i[2] - i[0]) * r * p + u[1]) / i[1], ((i[0] - i[1]) * p * q + u[2]) / i[2]]
//! }
//! let (start, system) = (FlowState::new([1.0, 0.0, 0.0, 0.0, 0.5, 0.8, -0.4]), Satellite { i: [1.0, 2.0, 3.0], u: [0.1, 0.0, 0.0] });
//! let mut sim = system.integrator(FourthOrder(DiscreteGradient), 0.1, start);
//! sim.advance(100)?;
//! assert!((sim.integrals()[0] - 1.0).abs() < 1e-13);
//! # Ok::<(), StepError>(())
//! ```
//!
//! A body that moves has a centre q and its momentum p, both in space. This one computes in `f32`:
//!
//! ```
//! # use geoint_runtime::{nalgebra::{UnitQuaternion, Vector3}, methods::*, prelude::*};
//! #[hamiltonian(attitude = r)] // A spring pulls the point d of the body to the origin.
//! fn stone(r: UnitQuaternion<f32>, m: Vector3<f32>, q: Vector3<f32>, p: Vector3<f32>, mass: f32, i: f32, d: Vector3<f32>, k: f32) -> f32 {
//!     (p.norm_squared() / mass + m.norm_squared() / i + k * (q + r * d).norm_squared()) / 2.0
//! }
//! let system = Stone { mass: 1.0, i: 0.2, d: Vector3::new(0.1, 0.0, 0.2), k: 10.0 };
//! let start = BodyState::new(UnitQuaternion::identity(), Vector3::new(0.1, 0.2, -0.1)).with_centres(Vector3::x(), Vector3::y()); // q, p
//! let mut sim = system.integrator(StormerVerlet, 1.0 / 120.0, start);
//! sim.advance(1200)?;
//! # assert!((sim.energy() / system.energy(&start) - 1.0).abs() < 1e-3);
//! # system.integrator(FiveRotations, 0.01, start).advance(9)?; system.adaptive(DOP853, 1e-6, start).advance(9)?; Ok::<(), StepError>(())
//! ```
//! # The report of a field
//! `EulerTop::REPORT` lists the divergence of f, a matrix S if one was found, the proof of each integral, and integrals that were found but not
//! named. If the field is canonical, q' = ∂H/∂p and p' = −∂H/∂q, the macro finds H for `sim.energy()`.
//! # Errors and limits
//! - A function that is not constant is a compile error. The message shows the remainder of f·∇I, for instance `2·x[0]·x[1]·x[2]·b − …`.
//! - A true integral without a proof is a compile error, too. `keeps(assume(name = I))` accepts it, and the report marks it as assumed.
//! - Parallel gradients of two integrals, as in a rotation about a principal axis or on a circular orbit, give
//!   [`Singular`](crate::Failure::Singular). Use `Projection(RK4, Integrals)`.
//!
//! Next: [events](super::_12_events), [errors](super::_16_errors), [evidence](super::_17_evidence), [limits](super::_18_limits).
