//! Raw identifiers, documentation and attributes on the function.
use geoint_runtime::prelude::*;

/// The energy of a spring.
///
/// ```text
/// p²/2m + k q²/2
/// ```
#[hamiltonian]
#[must_use]
#[inline]
fn r#spring_energy(q: f64, p: f64, r#type: f64) -> f64 {
    #[allow(unused_variables)]
    let unused = 1.0;
    0.5 * p * p + 0.5 * r#type * q * q
}

#[test]
fn compiles_and_means_what_it_says() {
    let system = SpringEnergy { r#type: 2.0 };
    assert_eq!(system.energy(&State::new(1.0, 1.0)), spring_energy(1.0, 1.0, 2.0));
    assert!(SpringEnergy::<f64>::REPORT.contains("type"));
}
