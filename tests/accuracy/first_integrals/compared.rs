//! The benefit of conserving an integral: errors after many periods, and an integral that is not listed.

use super::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

const PERIOD: f64 = 5.173_375_597_582_038_8;
const FLOW: LotkaVolterra = LotkaVolterra { a: 2.0, b: 1.0, c: 1.0 };
const FIELD: Predators = Predators { a: 2.0, b: 1.0, c: 1.0 };

/// The error of predators and prey after a hundred periods, for each number of steps a period.
fn errors<S, M>(system: S, method: M, row: &[(u64, f64)])
where
    S: PhaseSpace<State = FlowState<[f64; 2]>>,
    M: Method<S> + Copy,
{
    for (steps, expected) in row {
        let mut sim = Integrator::new(system, method, PERIOD / *steps as f64, FlowState::new([1.0, 0.5]));
        sim.advance(100 * steps).unwrap_or_else(|error| panic!("{error}"));
        close(&method.name().to_string(), *steps, miss(sim.state().x), *expected);
    }
}

fn miss([x, y]: [f64; 2]) -> f64 {
    (x - 1.0).abs().max((y - 0.5).abs())
}

fn close(name: &str, steps: u64, error: f64, expected: f64) {
    assert!((error / expected - 1.0).abs() < 0.02, "{name}, {steps} steps: {error:.3e}, not {expected:.3e}");
}

/// A level set in the plane is a curve. A method that conserves the integral can err only in the time along the curve.
#[test]
fn predators_after_a_hundred_periods() {
    errors(FIELD, FourthOrder(DiscreteGradient), &[(40, 7.57e-3), (80, 4.73e-4), (160, 2.96e-5)]);
    errors(FLOW, Suzuki4.of(DiscreteGradient), &[(20, 1.78e-2), (40, 1.09e-3)]);
    errors(FLOW, Suzuki4.of(PoissonSplitting), &[(40, 2.84e-3), (80, 1.80e-4)]);
    errors(FIELD, Gauss::<2>, &[(40, 0.179)]);
    errors(FIELD, RK4, &[(57, 0.228), (100, 1.98e-2), (200, 1.133e-3)]);
    errors(FIELD, Projection(RK4, Integrals), &[(57, 1.565e-3), (100, 2.209e-4), (200, 1.645e-5)]);
}

/// The direction of a projection decides its effect on time. Our direction is the same in all units, because gradients are taken in units of the
/// recent sizes of the coordinates. In the units of this test, the plain gradient gives about a sixth of the error.
#[test]
fn projections_have_a_direction() {
    for (steps, ours, euclidean) in [(57, 1.565e-3, 1.771e-4), (100, 2.209e-4, 3.740e-5), (200, 1.645e-5, 3.096e-6)] {
        close("by hand, units of sizes", steps, miss(projected_by_hand(steps, true)), ours);
        close("by hand", steps, miss(projected_by_hand(steps, false)), euclidean);
    }
}

/// RK4 and Newton's corrections along D²∇I: D the sizes, or 1.
fn projected_by_hand(steps: u64, in_sizes: bool) -> [f64; 2] {
    let (h, start) = (PERIOD / steps as f64, [1.0, 0.5]);
    let field = |[x, y]: [f64; 2]| [x * (2.0 - y), y * (x - 1.0)];
    let wealth = |[x, y]: [f64; 2]| x - x.ln() + y - 2.0 * y.ln();
    let gradient = |[x, y]: [f64; 2]| [1.0 - 1.0 / x, 1.0 - 2.0 / y];
    let along = |z: [f64; 2], w: f64, d: [f64; 2]| [z[0] + w * d[0], z[1] + w * d[1]];
    let (level, mut z, mut sizes) = (wealth(start), start, [0.0_f64; 2]);
    for _ in 0..100 * steps {
        let a = field(z);
        let b = field(along(z, 0.5 * h, a));
        let c = field(along(z, 0.5 * h, b));
        let d = field(along(z, h, c));
        let end = [0, 1].map(|i| z[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        for i in 0..2 {
            sizes[i] = (z[i].abs() + (end[i] - z[i]).abs()).max((1.0 - 1.0 / 64.0) * sizes[i]);
        }
        let slope = gradient(end);
        let direction = [0, 1].map(|i| if in_sizes { sizes[i] * sizes[i] * slope[i] } else { slope[i] });
        let mut multiplier = 0.0;
        for _ in 0..4 {
            let now = along(end, multiplier, direction);
            let rate = gradient(now);
            multiplier -= (wealth(now) - level) / (rate[0] * direction[0] + rate[1] * direction[1]);
        }
        z = along(end, multiplier, direction);
    }
    z
}

/// Kovalevskaya's integral is not listed, so methods conserve only H and both Casimirs. Symmetric methods stay near the integral. A projection
/// drifts, visibly with long steps.
#[test]
fn kovalevskayas_integral_is_not_listed() {
    let stays = |method: &str, [first, last]: [f64; 2], expected: [f64; 2]| {
        for (change, expected) in [first, last].into_iter().zip(expected) {
            assert!((change / expected - 1.0).abs() < 0.02, "{method}: {change:.3e}, not {expected:.3e}");
        }
    };
    stays("order 4", departures(FourthOrder(DiscreteGradient), 0.1, [100, 1000]), [1.66e-6, 6.11e-6]);
    stays("Gauss", departures(Gauss::<2>, 0.1, [100, 1000]), [1.22e-6, 4.85e-6]);
    stays("Poisson", departures(Suzuki4.of(PoissonSplitting), 0.1, [100, 1000]), [3.7e-7, 9.2e-7]);
    stays("order 4, long steps", departures(FourthOrder(DiscreteGradient), 0.3, [120, 1200]), [3.62e-4, 3.65e-4]);
    let [early, late] = departures(Projection(RK4, Integrals), 0.3, [120, 4000]);
    assert!(late > 2.5 * early, "{early:.1e}, {late:.1e}");
}

/// The largest change of it up to two numbers of steps.
fn departures<M: Method<HeavyTop>>(method: M, h: f64, stops: [u64; 2]) -> [f64; 2] {
    let top = HeavyTop { inertia: [2.0, 2.0, 1.0], r: [1.0, 0.0, 0.0] };
    let integral = |[a, b, _, c, d, _]: [f64; 6]| ((a * a - b * b) / 4.0 - c).powi(2) + (a * b / 2.0 - d).powi(2);
    let start = [0.3, -0.2, 0.5, 0.6, 0.0, 0.8];
    let mut sim = Integrator::new(top, method, h, FlowState::new(start));
    let (mut largest, mut steps) = (0.0_f64, 0);
    stops.map(|stop| {
        while steps < stop {
            sim.step().unwrap_or_else(|error| panic!("{error}"));
            largest = largest.max((integral(sim.state().x) - integral(start)).abs());
            steps += 1;
        }
        largest
    })
}
