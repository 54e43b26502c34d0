//! Errors at three step sizes, compared with another program. The size of the errors must agree, not the order alone.

use crate::references::{ARM, BRAKED, DOUBLE_PENDULUM};
use crate::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::space::{Array, Snapshot};
use geoint_runtime::{Lagrangian, PhaseSpace};

/// Returns the largest entry of the error in (q, p). The reference is a method of order 12.
fn errors<S: Lagrangian, M: Method<S>>(system: S, method: M, start: S::State, time: f64, first: f64) -> [f64; 3]
where
    Gauss<6>: Method<S>,
{
    let state = |state: S::State| Array::as_slice(&state.parts().1).to_vec();
    let mut exact = Integrator::new(system, Gauss::<6>, 0.25 * first, start);
    exact.advance((4.0 * time / first).round() as u64).expect("steps");
    let exact = state(exact.state());
    [1.0, 0.5, 0.25].map(|part| {
        let mut sim = Integrator::new(system, method, part * first, start);
        sim.advance((time / first / part).round() as u64).expect("steps");
        state(sim.state()).iter().zip(&exact).fold(0.0, |far, (a, b)| f64::max(far, (a - b).abs()))
    })
}

fn same(found: [f64; 3], expected: [f64; 3]) {
    for (found, expected) in found.into_iter().zip(expected) {
        // Beside them rounding is not small.
        let within = 0.05 * expected + 2e-14;
        assert!((found - expected).abs() < within, "{found:.3e} in place of {expected:.3e}");
    }
}

macro_rules! errors_are {
    ($($name:ident: $system:expr, $start:expr, $time:expr, $first:expr => $one:expr, $two:expr, $three:expr;)*) => { $(
        #[test]
        fn $name() {
            let system = $system;
            let start = $start(&system);
            same(errors(system, Gauss::<1>, start, $time, $first), $one);
            same(errors(system, ImplicitMidpoint, start, $time, $first), $one);
            same(errors(system, Gauss::<2>, start, $time, $first), $two);
            same(errors(system, Gauss::<3>, start, $time, $first), $three);
        }
    )* };
}

errors_are! {
    cubic: Cubic { epsilon: 0.2, delta: 0.1 }, |s: &Cubic| s.at(0.8, 0.5), 5.0, 0.1
        => [3.85e-3, 9.64e-4, 2.41e-4], [4.16e-7, 2.60e-8, 1.63e-9], [1.60e-10, 2.50e-12, 4e-14];
    spherical_pendulum: SphericalPendulum { m: 1.0, l: 1.0, g: 9.81 }, |s: &SphericalPendulum| s.at([1.0, 0.0], [0.0, 2.0]), 3.0, 0.05
        => [1.05e-1, 2.83e-2, 7.21e-3], [3.65e-4, 2.32e-5, 1.46e-6], [1.24e-6, 2.00e-8, 3.1e-10];
    hoop: Hoop { omega: 4.0, g: 9.81 }, |s: &Hoop| s.at(0.5, 0.0), 3.0, 0.05
        => [7.00e-3, 1.77e-3, 4.45e-4], [3.68e-6, 2.30e-7, 1.44e-8], [1.58e-9, 2.47e-11, 3.9e-13];
    relativistic: Relativistic { m: 1.0, c: 1.0, k: 1.0 }, |s: &Relativistic| s.at(2.0, 0.0), 10.0, 0.1
        => [1.58e-3, 3.93e-4, 9.82e-5], [3.08e-6, 1.89e-7, 1.17e-8], [6.24e-9, 9.34e-11, 1.4e-12];
    moving_pivot: MovingPivot { a: 0.1, omega: 20.0, g: 9.81 }, |s: &MovingPivot| s.at(3.0, 0.1), 1.0, 0.02
        => [1.98e-3, 4.93e-4, 1.23e-4], [1.79e-6, 1.11e-7, 6.91e-9], [2.44e-9, 3.73e-11, 5.7e-13];
    charge: Charge { k: 0.25 }, |s: &Charge| s.at([1.0, 0.0], [0.0, 0.5]), 5.0, 0.1
        => [4.92e-3, 1.21e-3, 3.01e-4], [3.63e-6, 2.28e-7, 1.42e-8], [1.27e-9, 1.99e-11, 3.1e-13];
    arm: ARM, |s: &Arm| s.at([0.5, 0.4, -0.3], [0.0, 0.0, 1.0]), 1.0, 0.05
        => [2.88e-2, 8.67e-3, 2.26e-3], [1.50e-4, 9.41e-6, 5.91e-7], [1.49e-7, 2.40e-9, 3.8e-11];
    double_pendulum: DOUBLE_PENDULUM, |s: &DoublePendulum| s.at([0.0, 1.4], [0.0, 0.0]), 2.0, 0.04
        => [1.71e-2, 4.30e-3, 1.08e-3], [1.24e-5, 7.81e-7, 4.89e-8], [8.96e-8, 1.39e-9, 2.18e-11];
    brachistochrone: Brachistochrone, |s: &Brachistochrone| s.at_time(1.0 - 1_f64.sin(), 1.0 - 1_f64.cos(), 1_f64.sin() / (1.0 - 1_f64.cos())),
        1.0 - 2_f64.sin() + 1_f64.sin(), (1.0 - 2_f64.sin() + 1_f64.sin()) / 8.0
        => [4.07e-2, 9.83e-3, 2.44e-3], [1.07e-3, 8.13e-5, 5.41e-6], [2.56e-5, 5.95e-7, 1.07e-8];
}

/// In (q, p, s).
#[test]
fn herglotz() {
    let start = BRAKED.at([0.0, 1.4], [0.0, 0.0], 0.0);
    let exact = [
        0.333_568_811_836_901_52,
        -0.382_021_839_677_322_04,
        1.732_983_435_190_370_7,
        0.429_924_908_456_404_5,
        30.686_536_218_045_865,
    ];
    let found = [0.1, 0.05, 0.025].map(|h| {
        let mut sim = BRAKED.integrator(ContactMidpoint, h, start);
        sim.advance((2.0 / h).round() as u64).expect("steps");
        let ContactState { q, p, s, .. } = sim.state();
        [q[0], q[1], p[0], p[1], s].iter().zip(exact).fold(0.0, |far, (a, b)| f64::max(far, (a - b).abs()))
    });
    same(found, [9.7e-2, 2.5e-2, 6.2e-3]);
    assert!(PhaseSpace::energy(&BRAKED, &start).is_finite());
}
