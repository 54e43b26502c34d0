//! See the derivatives, conserved quantities, suitable methods and costs that an attribute derived from your energy.
//!
//! Every system has a constant `REPORT`, and `cargo doc` shows it as the documentation of the generated struct. This program prints the report of two
//! bodies and compares it with its text:
//!
//! ```
//! use geoint_runtime::{methods::*, prelude::*};
//!
//! /// Two bodies on a line with a softened attraction.
//! #[hamiltonian]
//! fn pair(q: [f64; 2], p: [f64; 2], m: [f64; 2], k: f64) -> f64 {
//!     p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]) - k / (1.0 + (q[0] - q[1]).powi(2)).sqrt()
//! }
//!
//! println!("{}", Pair::REPORT);
//! assert_eq!(Pair::REPORT, "\
//! H = p[0]²/(2·m[0]) + p[1]²/(2·m[1]) - k/√((q[0] - q[1])² + 1)
//! ∂H/∂q[0] = k·(q[0] - q[1])/((q[0] - q[1])² + 1)^(3/2)
//! ∂H/∂q[1] = -k·(q[0] - q[1])/((q[0] - q[1])² + 1)^(3/2)
//! ∂H/∂p[0] = p[0]/m[0]
//! ∂H/∂p[1] = p[1]/m[1]
//! L = k/√((q[0] - q[1])² + 1) + (m[0]·v[0]² + m[1]·v[1]²)/2, with v = ∂H/∂p
//!
//! Structure
//! - H = T(p) + V(q): kick and drift are exact flows
//! - T = p[0]²/(2·m[0]) + p[1]²/(2·m[1])
//! - V = -k/√((q[0] - q[1])² + 1)
//! - T is quadratic in p with a constant mass matrix
//! - H is not a polynomial in q and p
//! - H does not depend on time
//!
//! Conserved by the flow, at least
//! - the energy
//! - total momentum: p[0] + p[1]
//!
//! Discrete gradients
//! - `DiscreteGradient` and `FourthOrder(DiscreteGradient)` keep all of that, to rounding
//! - on an orbit on which the gradient of a momentum depends on that of H all along, as on a circle, `FourthOrder(DiscreteGradient)` keeps H alone
//! - `MeanValue` has a closed form: it is `DiscreteGradient`
//!
//! Operations (a sine with its cosine counts as two)
//! - gradient of H: sums and products 6, divisions and roots 4
//! - kick: sums and products 8, divisions and roots 3
//! - drift: sums and products 4
//! - stage of a Newton iteration of collocation: sums and products 17, divisions and roots 2
//! - Newton iteration of the discrete gradient: sums and products 32, divisions and roots 4
//!
//! Implicit steps
//! - `DiscreteGradient`, unknowns 2: Newton's iteration with elimination
//!
//! Skipped
//! - Newton's iteration in explicit methods: T and V have exact flows
//! - half of the unknowns of implicit methods: T is quadratic
//! - the clock: H does not depend on time
//! - recomputing what depends on parameters and the step size: prepared once
//! ");
//! ```
//!
//! # Line by line
//!
//! | line | meaning |
//! |---|---|
//! | `H = …` | The energy after simplification. Compare it with your formula: a forgotten parenthesis shows here. |
//! | `∂H/∂q[0] = …`, `L = …` | The derivatives, and the Lagrangian. The motion is q' = ∂H/∂p, p' = −∂H/∂q. |
//! | `H = T(p) + V(q)` | H is separable. All tables of kicks and drifts exist, such as [`StormerVerlet`](crate::StormerVerlet). |
//! | `T is quadratic in p …` | Runge–Kutta–Nyström tables exist too, such as [`BlanesMoanSrkn14a`](crate::BlanesMoanSrkn14a). |
//! | `H is not a polynomial …` | Up to degree 3, [`Kahan`](crate::Kahan) exists. |
//! | `H does not depend on time` | Without friction the motion conserves the energy. |
//! | `Conserved by the flow, at least` | Found: the energy, momenta of unread coordinates, total and angular momentum. Others may exist. |
//! | `DiscreteGradient … keep all of that` | The numerical solution conserves these too, up to rounding; on a circular orbit, `FourthOrder` keeps the energy only. |
//! | `MeanValue …` | Whether [`MeanValue`](crate::MeanValue) conserves the energy exactly. If not, the line names the term. |
//! | `Operations` | The cost of a kick, a drift, or an iteration. `StormerVerlet` needs one kick and one drift a step, `Gauss::<S>` has S stages. |
//! | `unknowns 2` | The size of the implicit equation. The momenta follow from the positions here, because T is quadratic. |
//! | `Skipped` | Work that this energy does not need, or methods that do not exist for it. |
//!
//! # Lines about problems
//!
//! ```
//! # use geoint_runtime::prelude::*;
//! #[hamiltonian] // q and p are coupled.
//! fn field(q: [f64; 2], p: [f64; 2], b: f64) -> f64 { ((p[0] + b * q[1] * q[1]).powi(2) + p[1] * p[1]) / 2.0 }
//!
//! #[hamiltonian(damping = c)] // Friction, and a force that depends on time.
//! fn driven(q: f64, p: f64, t: f64, c: f64) -> f64 { p * p / 2.0 + q * q / 2.0 - q * t.cos() }
//!
//! #[hamiltonian] // A step of the potential at q = 1.
//! fn ledge(q: f64, p: f64, height: f64) -> f64 { p * p / 2.0 + if q < 1.0 { 0.0 } else { height } }
//!
//! #[hamiltonian] // The potential contains an angle.
//! fn screw(q: [f64; 2], p: [f64; 2], a: f64) -> f64 { (p[0] * p[0] + p[1] * p[1]) / 2.0 + a * q[1].atan2(q[0]) }
//! # let contains = |report: &str, lines: &[&str]| for line in lines { assert!(report.contains(line), "{line}\n{report}") };
//! # contains(Field::REPORT, &["not separable, q and p are coupled by: ", "Pieces with flows in closed form"]);
//! # contains(Driven::REPORT, &["H depends on time", "nothing that was found", "kick and drift do not exist: damping is no part of either"]);
//! # contains(Ledge::REPORT, &["H may jump where q = 1"]);
//! # contains(Screw::REPORT, &["the term jumps where the angle by `atan2` comes round"]);
//! ```
//!
//! | line | system | meaning |
//! |---|---|---|
//! | `not separable, q and p are coupled by: …` | `field` | Kicks and drifts do not exist because of this term. |
//! | `Pieces with flows in closed form` | `field` | `PieceSplitting` exists, unless `none` follows. |
//! | `H depends on time`, `nothing that was found` | `driven` | No conserved quantity was found. All methods keep their order. |
//! | `kick and drift do not exist: damping …` | `driven` | Use `DiscreteGradient`, `ImplicitMidpoint` or `Gauss`. |
//! | `H may jump where q = 1` | `ledge` | Methods that conserve the energy cross the jump. Others end with an error: shift one side of the `if`. |
//! | `… comes round` | `screw` | The energy jumps by 2πa when the angle passes ±π. The motion does not jump. |
//!
//! # Other attributes
//!
//! - `#[lagrangian]`: first L, the momenta ∂L/∂v and the mass matrix, then the report of H.
//! - `#[contact_hamiltonian]`: the law of decay of the energy, and the pieces of `ContactSplitting`.
//! - `constraint`, `rolling`: the constraints, what they bind, the degrees of freedom, and the cost of steps.
//! - `#[vector_field]`, `structure = …`: each integral with its proof, the divergence, the brackets, and the pieces of the splittings.
//! - `attitude = r`: T, V, the principal axes of each body, and the cost of a kick.
//!
//! # Limits
//!
//! The report does not list poles, such as 1/q at q = 0. An implicit step that would cross a pole fails with [`Failure::Pole`](crate::Failure::Pole)
//! with the term. Long formulas are cut and end with `…`. To make a line a condition of the build, write `#[hamiltonian(require(separable))]`.
//!
//! Next: [a run in practice](super::_06_runs) and [which method](super::_03_which_method).
