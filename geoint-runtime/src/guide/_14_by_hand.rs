//! Write a system by hand if its size is read at run time or its forces need code outside the [language of energies](super::_04_language).
//!
//! An attribute needs the number of bodies at compile time. This program reads the masses of a star cluster from a text. It implements four traits of
//! [`system`](crate::system) itself. The arrays have a fixed capacity (no `Vec`; a run copies its state: box it if it is large), and the field `n`
//! holds the number of bodies.
//!
//! ```
//! use geoint_runtime::prelude::*;
//! use geoint_runtime::system::{Cotangent, QuadraticKinetic, Separable};
//!
//! const MAX: usize = 128; // The capacity.
//! type X = [[f64; 3]; MAX];
//! /// `n` bodies that attract each other (G = 1). `eps` softens close encounters.
//! #[derive(Clone, Copy)]
//! struct Cluster { n: usize, m: [f64; MAX], eps: f64 }
//! impl Cluster {
//!     /// Calls `visit(i, j, d, r2)` for each pair, with d = qᵢ − qⱼ and r2 = |d|² + eps².
//!     fn pairs(&self, q: &X, mut visit: impl FnMut(usize, usize, [f64; 3], f64)) {
//!         for i in 0..self.n { for j in 0..i {
//!             let d = [0, 1, 2].map(|k| q[i][k] - q[j][k]);
//!             visit(i, j, d, d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + self.eps * self.eps);
//!         } }
//!     }
//! }
//! impl PhaseSpace for Cluster {
//!     type State = State<X>;
//!     type Phase = [X; 2]; // q and p.
//!     type Action = (); // Another type only in contact systems.
//!     fn hamiltonian(&self, _t: f64, [q, p]: &[X; 2], _: &()) -> f64 {
//!         let mut energy = (0..self.n).map(|i| p[i].map(|p| p * p / (2.0 * self.m[i])).iter().sum::<f64>()).sum();
//!         self.pairs(q, |i, j, _, r2| energy -= self.m[i] * self.m[j] / r2.sqrt());
//!         energy
//!     }
//!     fn outside_domain(&self, _t: f64, _z: &[X; 2], _: &()) -> Option<&'static str> { None } // Or a text, if H is not defined.
//! }
//! impl Cotangent for Cluster { type Coordinates = X; type Array = X; }
//! impl QuadraticKinetic for Cluster { type Proof = (); } // The author vouches for a quadratic T.
//! impl Separable for Cluster {
//!     type Proof = (); // The author vouches for H = T(p) + V(q).
//!     type Kick = f64; // The length of a kick.
//!     type Drift = f64;
//!     fn prepare_kick(&self, h: f64) -> f64 { h }
//!     fn prepare_drift(&self, h: f64) -> f64 { h }
//!     fn kick(&self, h: &f64, _t: f64, q: &mut X, p: &mut X, _: &mut ()) { // p ← p − h ∂V/∂q
//!         self.pairs(q, |i, j, d, r2| {
//!             let c = h * self.m[i] * self.m[j] / (r2 * r2.sqrt());
//!             for k in 0..3 { p[i][k] -= c * d[k]; p[j][k] += c * d[k]; }
//!         });
//!     }
//!     fn drift(&self, h: &f64, _t: f64, q: &mut X, p: &mut X, _: &mut ()) { // q ← q + h ∂T/∂p
//!         for i in 0..self.n { for k in 0..3 { q[i][k] += h * p[i][k] / self.m[i]; } }
//!     }
//! }
//!
//! let text = "0.3 0.25 0.2 0.15 0.1"; // Or std::fs::read_to_string("masses.txt").
//! let (mut m, mut n) = ([1.0; MAX], 0);
//! for mass in text.split_whitespace() { m[n] = mass.parse()?; n += 1; }
//! let q = core::array::from_fn(|i| [(1.3 * i as f64).sin(), (2.7 * i as f64).cos(), 0.1 * i as f64]);
//! let mut sim = Cluster { n, m, eps: 0.2 }.integrator(BlanesMoanSrkn14a, 0.02, State::new(q, [[0.0; 3]; MAX]));
//! let start = sim.energy();
//! sim.advance(500)?;
//! assert!((sim.energy() / start - 1.0).abs() < 1e-6);
//! # let mut halves = [0.01, 0.005].map(|h| sim.system().integrator(StormerVerlet, h, State::new(q, [[0.0; 3]; MAX])));
//! # halves[0].advance(50)?; halves[1].advance(100)?;
//! # assert!(((halves[0].energy() - start) / (halves[1].energy() - start) - 4.0).abs() < 0.2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//! The program compiles in a second. With 100 bodies, a step of `StormerVerlet` takes about 23 µs (one core, release build). For one coordinate write
//! `State<f64>`, `Phase = [[f64; 1]; 2]`, `Coordinates = f64` and `Array = [f64; 1]`. All four traits take the scalar:
//! `impl PhaseSpace<f32> for …`. `prepare_kick` may compute what all steps of length h share.
//! - These traits give all methods of kicks and drifts (`StormerVerlet`, `BlanesMoan6`, …), `energy`, `until`, events and saved runs.
//! - With [`VectorField`](crate::system::VectorField) also adaptive steps, [`RK4`](crate::RK4) and [`DOP853`](crate::DOP853) work.
//! - `REPORT`, [`DiscreteGradient`](crate::DiscreteGradient), [`Gauss`](crate::Gauss), and Taylor series do not exist. Poles are found only by
//!   `outside_domain`.
//! - Nothing checks that `kick` fits `hamiltonian`. Test it: with `StormerVerlet` and half the step, the error of the energy is a quarter.
//! # Tables, and functions of other crates
//! In a system by hand, `kick` may look up a table or call `libm::erf`. In an attribute, write the table as a natural cubic spline a + b q + Σ cᵢ
//! max(q − xᵢ, 0)³, and replace `erf` by an approximation. At a knot, the third derivative jumps, and methods of high order lose digits in this step.
//! A natural spline is inaccurate near an end where V curves: add knots beyond it.
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! /// Coefficients a, b, c of the natural spline through the points (xᵢ, yᵢ).
//! fn natural<const N: usize>(x: [f64; N], y: [f64; N]) -> (f64, f64, [f64; N]) {
//!     let h = |i: usize| x[i + 1] - x[i];
//!     let slope = |i: usize| (y[i + 1] - y[i]) / h(i);
//!     let (mut pivot, mut second) = ([f64::INFINITY; N], [0.0; N]); // Second derivatives at the knots, by elimination.
//!     for i in 1..N - 1 {
//!         let factor = h(i - 1) / pivot[i - 1];
//!         pivot[i] = 2.0 * (h(i - 1) + h(i)) - factor * h(i - 1);
//!         second[i] = 6.0 * (slope(i) - slope(i - 1)) - factor * second[i - 1];
//!     }
//!     for i in (1..N - 1).rev() { second[i] = (second[i] - h(i) * second[i + 1]) / pivot[i]; }
//!     let third = |i: usize| if i < N - 1 { (second[i + 1] - second[i]) / h(i) } else { 0.0 };
//!     let b = slope(0) - h(0) * second[1] / 6.0;
//!     (y[0] - b * x[0], b, std::array::from_fn(|i| (third(i) - if i > 0 { third(i - 1) } else { 0.0 }) / 6.0))
//! }
//! #[hamiltonian]
//! fn table(q: f64, p: f64, x: [f64; 9], a: f64, b: f64, c: [f64; 9]) -> f64 {
//!     p * p / 2.0 + a + b * q + x.iter().zip(c).map(|(x, c)| c * (q - x).max(0.0).powi(3)).sum::<f64>()
//! }
//! #[hamiltonian] // A charge in the field of a Gaussian charge of width w.
//! fn cloud(q: [f64; 3], p: [f64; 3], w: f64) -> f64 {
//!     fn erf(x: f64) -> f64 { // For x ≥ 0, accurate to 3e-7: Abramowitz & Stegun 7.1.28.
//!         let a = [0.0705230784, 0.0422820123, 0.0092705272, 0.0001520143, 0.0002765672, 0.0000430638];
//!         1.0 - (1.0 + x * a.iter().rev().fold(0.0, |sum, a| sum * x + a)).powi(-16)
//!     }
//!     let r = (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt();
//!     (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 2.0 - erf(r / w) / r
//! }
//! let x = [-2.0, -1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0];
//! let (a, b, c) = natural(x, x.map(|x| -x.cos()));
//! let energy = |q: f64| Table { x, a, b, c }.energy(&State::new(q, 0.0));
//! assert!(x.iter().all(|&q| (energy(q) + q.cos()).abs() < 1e-13) && (energy(0.25) + 0.25_f64.cos()).abs() < 1e-3);
//! # assert!((cloud([1.0, 0.0, 0.0], [0.0; 3], 1.0) + 0.8427007929).abs() < 3e-7);
//! ```
//! A step of `StormerVerlet` takes 26 ns with 20 knots, 50 ns with `erf`, and 21 ns with 1/r alone. For a long table write `kick` by hand: it finds
//! the interval of q and evaluates one cubic.
//!
//! Next: [limits](super::_18_limits) and [errors and remedies](super::_16_errors).
