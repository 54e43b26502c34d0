//! Steps of fixed length at the end of a series. No run continues unnoticed behind a vanishing power or behind a pole.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::Jets;
use geoint_runtime::{Failure, TaylorIntegrator};

macro_rules! potentials {
    ($($name:ident($q:ident): $potential:expr;)*) => { $(
        #[hamiltonian]
        fn $name($q: f64, p: f64, m: f64) -> f64 {
            p * p / (2.0 * m) + $potential
        }
    )* };
}

potentials! {
    root(q): q.abs().sqrt();
    inverse_root(q): 0.1 * q * q - 1.0 / q.abs().sqrt();
    three_halves(q): q.abs().powf(1.5);
    of_a_square(q): (q * q).powf(0.75);
    logarithm(q): q.abs().ln();
    inverse(q): -1.0 / q.abs();
    cube_root(q): q * q.cbrt();
    hypotenuse(q): q.hypot(2.0 * q);
}

/// Asserts that the run is refused in front of the end of the series, or just behind. Until then the energy is kept.
fn is_refused<S: Jets<State = State<f64>> + Copy, const P: usize>(name: &str, system: S) {
    for h in [0.1, 0.013, -0.04] {
        for p in [-0.3, 0.2] {
            let start = State::new(1.0, p);
            let mut sim = TaylorIntegrator::new(system, TaylorFixed::<P> { h }, start);
            let error = sim.advance_to(5.0 * f64::signum(h)).expect_err(name);
            let is_named =
                matches!(error, StepError { failure: Failure::Diverges | Failure::OutsideDomain { .. }, .. });
            let here = sim.state();
            assert!(is_named && here.q.abs() < 0.6, "{name}, order {P}, {h}: {error}, {here:?}");
            assert!(sim.step().is_err() && sim.state() == here, "{name}, order {P}, {h}");
        }
    }
}

#[test]
fn no_run_goes_on_behind_the_end_of_a_series() {
    macro_rules! all {
        ($($order:literal)*) => { $(
            is_refused::<_, $order>("√|q|", Root { m: 1.3 });
            is_refused::<_, $order>("1/√|q|", InverseRoot { m: 1.3 });
            is_refused::<_, $order>("|q|^1.5", ThreeHalves { m: 1.3 });
            is_refused::<_, $order>("(q²)^0.75", OfASquare { m: 1.3 });
            is_refused::<_, $order>("ln|q|", Logarithm { m: 1.3 });
            is_refused::<_, $order>("1/|q|", Inverse { m: 1.3 });
            is_refused::<_, $order>("q·∛q", CubeRoot { m: 1.3 });
            is_refused::<_, $order>("hypot(q, 2q)", Hypotenuse { m: 1.3 });
        )* };
    }
    all!(5 8 12 20);
}

#[hamiltonian]
fn kepler(q: [f64; 2], p: [f64; 2]) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// Coarse steps around a pole are accepted in both directions. A step into the pole is refused.
#[test]
fn coarse_steps_are_steps() {
    for h in [0.05, -0.05] {
        let mut sim = Kepler.taylor(TaylorFixed::<4> { h }, State::new([0.4, 0.0], [0.0, 2.0]));
        sim.advance(2000).unwrap();
        assert!(sim.energy() < -0.3 && sim.energy() > -0.7, "{}", sim.energy());
        let mut sim = Kepler.taylor(TaylorFixed::<4> { h }, State::new([0.4, 0.0], [0.0, 0.0]));
        assert!(sim.advance(100).is_err());
        assert!(sim.state().q[0].abs() < 0.4);
    }
}
