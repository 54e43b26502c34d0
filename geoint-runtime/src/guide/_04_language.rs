//! Write an energy with loops, functions, vectors and branches, and know which Rust the attributes accept.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! const N: usize = 6;
//!
//! /// Atoms on a line between two soft walls. Neighbours are bound by Morse potentials.
//! #[hamiltonian(const N = 6)]
//! fn chain(q: [f64; N], p: [f64; N], m: [f64; N], depth: f64, stiffness: f64) -> f64 {
//!     const REST: f64 = 1.0;
//!     fn morse(r: f64, depth: f64) -> f64 {
//!         depth * (1.0 - (REST - r).exp()).powi(2)
//!     }
//!     let wall = |beyond: f64| if beyond > 0.0 { stiffness * beyond.powi(2) / 2.0 } else { 0.0 };
//!     let kinetic: f64 = p.iter().zip(m).map(|(p, m)| p * p / (2.0 * m)).sum();
//!     let mut potential = wall(-q[0]) + wall(q[N - 1] - 5.0);
//!     for i in 1..N {
//!         potential += morse(q[i] - q[i - 1], depth);
//!     }
//!     kinetic + potential
//! }
//!
//! let system = Chain { m: [1.0; N], depth: 2.0, stiffness: 30.0 };
//! let start = State::new([0.1, 1.0, 2.2, 3.0, 4.1, 5.0], [0.4, 0.0, 0.0, 0.0, 0.0, -0.3]);
//! let mut sim = system.integrator(DiscreteGradient, 0.05, start);
//! sim.advance(10_000)?;
//! // The function stays an ordinary function.
//! assert!((sim.energy() - chain(start.q, start.p, [1.0; N], 2.0, 30.0)).abs() < 1e-12);
//! # Ok::<(), StepError>(())
//! ```
//!
//! The attribute evaluates the body at compile time. It unrolls each loop and inlines each function. The result is arithmetic on numbers, and the
//! attribute differentiates it. Therefore lengths, indices and loop bounds must be known at compile time.
//!
//! # Arguments and types
//!
//! | argument | types |
//! |---|---|
//! | `q` and `p`, or `q` and `v` of a Lagrangian | both have the same type, from the next row, without quaternions |
//! | all parameters | `f64`, `[f64; N]`, `[[f64; D]; N]`, `Vector3<f64>`, `SVector<f64, N>`, `UnitQuaternion<f64>`, arrays of vectors |
//! | time `t`, action `s` | `f64` |
//! | `r` and `m` of a [rigid body](super::_11_fields); `x` of a field | `UnitQuaternion<f64>` and `Vector3<f64>`, or arrays of them; `[f64; N]` |
//!
//! - `f32` may stand for `f64` in all of these types, but one energy can not mix both. The struct names its scalar: `Chain<f64>`, `Chain<f32>`.
//! - Write a matrix as an array of arrays, `[[f64; 3]; 3]`. Lengths go from 1 to 1000.
//! - `q = x` and `p = px` in the attribute rename arguments; states keep the fields `q` and `p`. `name = Spring` renames the struct.
//! - The generated struct has the visibility of the function: `pub fn chain` gives `pub struct Chain`. Its fields are always `pub`.
//! - An attribute sees its function only, not the rest of the file. Repeat an integer constant or an alias of a type in it: `const N = 6`, `type
//!   Chain = [f64; N]`. rustc checks both. Other constants, such as `const G: f64 = 6.67e-11`, need no repetition.
//! - The function can not be generic. For two lengths write two functions.
//! - Expressions in the attribute, such as `damping = c * q.powi(2)`, use this language too.
//! - In a `no_std` crate `cos` and the other methods of numbers come from [`Real`](crate::Real), which is in the prelude.
//!
//! # The body
//! | part | accepted |
//! |---|---|
//! | variables | `let` with names, tuples and arrays (`let [x, y] = q`), `let mut`, `x = …`, `x[i] += …` |
//! | items | `const`, `type`, nested `fn`, closures, `use std::f64::consts::PI` |
//! | loops | `for` over ranges, arrays and iterators, with `continue` and `break` |
//! | iterators | `map`, `flat_map`, `filter`, `zip`, `enumerate`, `rev`, `skip`, `take`, `step_by`, `windows`, `sum`, `product`, `fold` |
//! | branches | `if … else …` with a value on both sides, `&&`, `\|\|`, `!`, comparisons |
//! | functions | `sin`, `cos`, `tan`, `sinh`, `cosh`, `tanh`, their inverses (`asin` …), `sin_cos`, `atan2`, `exp`, `exp2`, `exp_m1`, `ln`, `ln_1p` |
//! | | `log2`, `log10`, `powi` (−64 to 64), `powf`, `sqrt`, `cbrt`, `recip`, `hypot`, `abs`, `signum`, `min`, `max`, `clamp`, `mul_add` |
//! | vectors of nalgebra | `+`, `-`, products with numbers, `Vector3::new(x, y, z)`, `dot`, `cross`, `norm`, `norm_squared`, `sum`, `iter`, `v.x`, `v[0]` |
//! | quaternions | `r * v`, `r * s`, `r / s`, `inverse`, `transform_vector`, `inverse_transform_vector`, `rotation_to`, `imag`, `scalar`, `coords`, `r.i` … `r.w` |
//!
//! Both sides of an `if` are differentiated. If the sides meet with a bend (equal values, other slopes), the step across it is less accurate:
//! `powi(2)` instead of `abs` has no bend. If the values differ, H jumps, and [the report](super::_05_report) names the condition. A condition on a
//! loop counter is decided at compile time.
//!
//! # Functions outside of the energy
//!
//! To call another function, put [`energy_function`](macro@crate::energy_function) above it and name it in `with(…)`:
//!
//! ```
//! use geoint_runtime::nalgebra::Vector3;
//! use geoint_runtime::prelude::*;
//!
//! /// Lennard-Jones potential of the distance vector d.
//! #[energy_function]
//! fn lennard_jones(d: Vector3<f64>, epsilon: f64, sigma: f64) -> f64 {
//!     let x = (sigma * sigma / d.norm_squared()).powi(3);
//!     4.0 * epsilon * (x * x - x)
//! }
//!
//! #[hamiltonian(with(lennard_jones))]
//! fn dimer(q: [Vector3<f64>; 2], p: [Vector3<f64>; 2], m: f64, epsilon: f64, sigma: f64) -> f64 {
//!     p.iter().map(|p| p.norm_squared()).sum::<f64>() / (2.0 * m) + lennard_jones(q[1] - q[0], epsilon, sigma)
//! }
//!
//! let start = State::new([Vector3::zeros(), Vector3::new(1.2, 0.0, 0.0)], [Vector3::zeros(); 2]);
//! let mut sim = Dimer { m: 1.0, epsilon: 1.0, sigma: 1.0 }.integrator(BlanesMoanSrkn14a, 0.05, start);
//! let energy = sim.energy();
//! sim.advance(1000)?;
//! assert!((sim.energy() - energy).abs() < 1e-6);
//! # Ok::<(), StepError>(())
//! ```
//!
//! `with(forces::lennard_jones)` takes a path in the same crate. If the function calls a function `g`, write `#[energy_function(with(g))]` above it.
//!
//! # Errors
//!
//! Everything else is a compile error at the place of the mistake. The message names the remedy.
//!
//! | you write | message, or remedy |
//! |---|---|
//! | `match`, `while`, `loop` | "use `if … else if … else`", "use `for` over a range" |
//! | `return x;` | "make the value the last expression" |
//! | `if q > 1.0 { e += q; }` | "make the branch a value, as in `e += if … { … } else { 0.0 }`" |
//! | `q ^ 2`, `1 / 2 * q` | "this is no power: write `x.powi(2)`", "write `0.5` or `1.0 / 2.0`" |
//! | `q.floor()`, `c[q as usize]` | no derivative; for tables see [by hand](super::_14_by_hand) |
//! | `libm::erf(q)` | "write the formula of `libm::erf`, or an approximation, as a nested `fn`" |
//! | `Vec<f64>` | "a length is known when the program is compiled: write `[f64; N]`" |
//! | `x += …` inside of a closure | a closure reads outer variables and does not assign to them |
//!
//! Limits: 5000 operations after unrolling: about 20 bodies in space that all attract each other, or a chain of 200 masses on a line.
//! Expressions have at most 200 levels. Functions can not call themselves. Larger systems are [written by hand](super::_14_by_hand).
//!
//! Next: [the report, line by line](super::_05_report) and [a run in practice](super::_06_runs).
