//! The attributes of `geoint-runtime`, which re-exports them: a compiler from energy functions to integrators.
//!
//! Depend on `geoint-runtime`; the code that is emitted here names it.

// In reading order, which is the order of dependence too.
mod diagnostics;
mod ir;
mod parse;
mod lower;
mod analyze;
mod check;
mod diff;
mod schedule;
mod emit;
mod expand;
#[cfg(test)]
mod tests;

use proc_macro::TokenStream;

/// Makes an integrable system from an energy H(q, p), or H(q, p, t) if it has an argument `t`.
///
/// The function stays as it is. A struct is added, named after it (`fn double_pendulum` gives `DoublePendulum`), with a
/// field for every argument that is not q, p or t, and with `system.integrator(method, h, state)`.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// Two bodies; q is the vector between them.
/// #[hamiltonian]
/// fn kepler(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
///     (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - k / (q[0] * q[0] + q[1] * q[1]).sqrt()
/// }
///
/// let start = State::new([1.0, 0.0], [0.0, 1.0]);
/// let mut sim = Kepler { m: 1.0, k: 1.0 }.integrator(BlanesMoanSrkn14a, 0.1, start);
/// for state in sim.until(6.28) {
///     println!("{:?}", state?.q);
/// }
/// # Ok::<(), StepError>(())
/// ```
///
/// # Arguments of the function
///
/// `q` and `p` have one type: `f64` (or `f32`), `[f64; N]`, `[[f64; D]; N]`, `VectorN<f64>`, `SVector<f64, N>`, or an array of
/// vectors. `t` is a scalar. Every other argument is a parameter, in one of the same shapes.
///
/// # Arguments of the attribute
///
/// - `name = Type`: the name of the struct.
/// - `q = x`, `p = px`, `t = time`: other names for positions, momenta and time.
/// - `crate = path`: where the runtime is, if not at `::geoint_runtime`.
/// - `require(separable, quadratic_kinetic)`: what you rely on; an error at the guilty term if it does not hold.
///
/// # The body
///
/// Ordinary Rust on numbers: literals, `let` with patterns and shadowing, blocks, `+ - * /`, `if … else` as an expression,
/// constant indices, `const` items and constants from outside, nested `fn`s and closures (inlined), `for` over ranges with
/// `+=` and `-=`, `(a..b).map(…).sum::<f64>()` and the usual iterators (unrolled), the methods of `f64` that have a
/// derivative, and vectors of nalgebra with `dot`, `cross`, `norm`, `norm_squared`. Anything else is an error where it
/// stands, which says what is accepted.
///
/// Both sides of an `if` are differentiated, each where it holds; the branch stays a branch. Where the sides do not meet
/// smoothly no method has the order that it claims.
#[proc_macro_attribute]
pub fn hamiltonian(args: TokenStream, item: TokenStream) -> TokenStream {
    expand::hamiltonian(args.into(), item.into()).into()
}
