//! Time of a run with steps of one length, changes of the step size, and runs in `f32`.

use geoint_runtime::Method;
use geoint_runtime::prelude::*;
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::*;

/// Asserts that the time is t₀ + n·h bit for bit, for each method, after `advance` and in samples.
struct Clock;

impl Visitor<DrivenPendulum, f64> for Clock {
    fn visit<M: Method<DrivenPendulum, f64> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let (t0, h) = (0.3, 0.01);
        let mut sim = DrivenPendulum::system::<f64>().integrator(method, h, DrivenPendulum::initial(t0));
        let mut n = 0_u64;
        for steps in [0, 1, 2, 7, 90] {
            sim.advance(steps).unwrap();
            n += steps;
            assert_eq!(sim.time().to_bits(), (t0 + n as f64 * h).to_bits(), "{name} after {n} steps");
            assert_eq!(sim.state().t.to_bits(), sim.time().to_bits());
            assert_eq!(sim.steps(), n);
        }
        for sample in sim.sampled(3).take(5) {
            n += 3;
            assert_eq!(sample.unwrap().t.to_bits(), (t0 + n as f64 * h).to_bits(), "{name}");
        }
    }
}

/// The time is computed as a product, not as a running sum, which would accumulate rounding errors.
#[test]
fn time_is_a_product_not_a_sum() {
    methods::kinds_of_general(&mut Clock);
    methods::kinds_of_discrete_gradient(&mut Clock);
    methods::kinds_of_separable(&mut Clock);
    methods::kinds_of_nystrom(&mut Clock);
    methods::kinds_of_force_gradient(&mut Clock);
    // Control: the running sum is a different number, so the test can fail.
    let sum = (0..100).fold(0.3, |t, _| t + 0.01);
    assert_ne!(sum, 0.3 + 100.0 * 0.01);
}

/// `set_step_size` keeps the state and the number of steps. The time continues as a new product from the current time.
#[test]
fn a_new_step_size_continues_the_run() {
    let system = DrivenPendulum::system::<f64>();
    let mut sim = system.integrator(BlanesMoan4, 0.1, DrivenPendulum::initial(0.3));
    sim.advance(7).unwrap();
    let before = sim.state();
    sim.set_step_size(0.03);
    assert_eq!(sim.state(), before);
    assert_eq!((sim.step_size(), sim.steps()), (0.03, 7));
    sim.advance(11).unwrap();
    assert_eq!(sim.time(), (0.3 + 7.0 * 0.1) + 11.0 * 0.03);
    assert_eq!(sim.steps(), 18);
    let mut fresh = system.integrator(BlanesMoan4, 0.03, before);
    fresh.advance(11).unwrap();
    assert_eq!(sim.state(), fresh.state());
}

/// Runs in `f32`. An energy written with `f32` agrees with a precise `f64` solution, to the error of the method and the rounding of `f32`. An energy
/// written with `f64` gives the same bits in `f32` as the energy written with `f32`.
#[test]
fn short_numbers() {
    struct Short;
    impl Visitor<ShortPendulum, f32> for Short {
        fn visit<M: Method<ShortPendulum, f32> + 'static>(&mut self, method: M) {
            let name = method.name().to_string();
            let system = ShortPendulum { m: 1.3, l: 0.7, g: 9.81 };
            let mut sim = system.integrator(method, 0.01, State::new(1.1, 0.4));
            sim.advance(50).unwrap();
            // Reference: order 12 in `f64`.
            let exact = Pendulum::system::<f64>().integrator(Gauss::<6>, 0.01, Pendulum::initial(0.0));
            let exact = { exact }.sampled(50).next().unwrap().unwrap();
            let tolerance = if method.claims().order == 1 { 0.2 } else { 2e-3 };
            let gap = (f64::from(sim.state().q) - exact.q).abs();
            let limit = if method.claims().order >= 4 { 5e-5 } else { tolerance };
            assert!(gap < limit, "{name}: {gap:.1e}");
            assert_eq!(sim.time(), (50.0 * f64::from(0.01_f32)) as f32);
        }
    }
    methods::kinds_of_general(&mut Short);
    methods::kinds_of_discrete_gradient(&mut Short);
    methods::kinds_of_separable(&mut Short);
    methods::kinds_of_nystrom(&mut Short);
    methods::kinds_of_force_gradient(&mut Short);

    let short = ShortPendulum { m: 1.3, l: 0.7, g: 9.81 };
    let long = Pendulum { m: 1.3_f32, l: 0.7, g: 9.81 };
    let mut a = short.integrator(StormerVerlet, 0.01, State::new(1.1, 0.4));
    let mut b = long.integrator(StormerVerlet, 0.01, State::new(1.1_f32, 0.4));
    a.advance(1000).unwrap();
    b.advance(1000).unwrap();
    assert_eq!(a.state(), b.state());
}
