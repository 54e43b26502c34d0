//! The struct is as visible as the function, and the order of arguments is free.
#![deny(missing_docs, unreachable_pub, dead_code)]

mod inner {
    use geoint_runtime::prelude::*;

    /// Visible in this crate.
    #[hamiltonian]
    pub(crate) fn oscillator(k: f64, p: f64, q: f64) -> f64 {
        0.5 * p * p + 0.5 * k * q * q
    }

    /// Visible one level up.
    #[hamiltonian]
    pub(super) fn free(q: f64, p: f64) -> f64 {
        let _at = q;
        0.5 * p * p
    }
}

#[test]
fn compiles_and_means_what_it_says() {
    let state = geoint_runtime::State::new(0.5, 2.0);
    assert_eq!(inner::Oscillator { k: 8.0 }.energy(&state), inner::oscillator(8.0, 2.0, 0.5));
    assert_eq!(inner::Free.energy(&state), inner::free(0.5, 2.0));
}
