//! What a lint says of the function, or is told not to say, holds for the struct: once, and where it is expected.
#![deny(warnings)]

use geoint_runtime::prelude::*;

#[hamiltonian]
#[allow(non_snake_case)]
fn kepler(q: [f64; 2], p: [f64; 2], M: f64, G: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * M) - G * M / q[0].hypot(q[1])
}

#[expect(non_snake_case, reason = "as in the book")]
#[contact_hamiltonian]
fn book(q: f64, p: f64, s: f64, M: f64) -> f64 {
    p * p / (2.0 * M) + q.cos() + 0.1 * s
}

#[hamiltonian]
fn argument(q: f64, p: f64, #[expect(non_snake_case)] M: f64, #[allow(non_snake_case)] K: f64) -> f64 {
    p * p / (2.0 * M) + K * q.cos()
}

#[hamiltonian]
#[cfg_attr(all(), allow(non_snake_case))]
fn conditional(q: f64, p: f64, M: f64) -> f64 {
    p * p / (2.0 * M) + q.cos()
}

#[expect(dead_code)]
#[hamiltonian]
fn nobody_calls(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + q.cos()
}

#[allow(dead_code)]
#[hamiltonian]
fn nobody_integrates(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + q.cos()
}

#[hamiltonian]
#[cfg(any())]
fn does_not_exist(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + q.cos()
}

/// What uses the struct is told so, and nothing else is.
#[deprecated(note = "use `book`")]
#[hamiltonian]
fn old(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + q.cos()
}

#[hamiltonian]
#[expect(clippy::too_many_arguments)]
fn many(q: f64, p: f64, a: f64, b: f64, c: f64, d: f64, e: f64, f: f64) -> f64 {
    a * p * p + b * q * q + c * q + d * p + e * q * p + f
}

#[hamiltonian]
#[expect(unused_variables)]
fn reads_no_time(q: f64, p: f64, t: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + q.cos()
}

#[hamiltonian]
#[expect(unused)]
fn unused_variable(q: f64, p: f64, m: f64) -> f64 {
    let x = 1.0;
    p * p / (2.0 * m) + q.cos()
}

#[test]
fn compiles_and_means_what_it_says() {
    let _ = (Kepler { M: 1.0, G: 2.0 }, Book { M: 2.0 }, Argument { M: 2.0, K: 1.0 }, Conditional { M: 2.0 });
    let _ =
        (Many { a: 1.0, b: 1.0, c: 1.0, d: 1.0, e: 1.0, f: 1.0 }, ReadsNoTime { m: 1.0 }, UnusedVariable { m: 1.0 });
    #[expect(deprecated)]
    let _ = Old { m: 1.0 };
}
