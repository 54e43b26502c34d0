//! Integrals that become steep in a coordinate, because the coordinate falls by many orders of magnitude. A step keeps them, or is refused.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::system::StateOf;
use geoint_runtime::{Method, PhaseSpace, Real};

/// x₀ grows, x₁ falls like e^(−bx₀): the integral is steep in x₁ as that is small. Units of both coordinates are parameters.
#[vector_field(keeps(i = (x[0] / u).exp() * (b * x[1] / v).sin()))]
fn wave(x: [f64; 2], b: f64, u: f64, v: f64) -> [f64; 2] {
    [u * b * (b * x[1] / v).cos(), -v * (b * x[1] / v).sin()]
}

/// The same in single precision.
#[vector_field(keeps(i = x[0].exp() * (b * x[1]).sin()))]
fn single(x: [f32; 2], b: f32) -> [f32; 2] {
    [b * (b * x[1]).cos(), -(b * x[1]).sin()]
}

/// x₁ falls faster and faster.
#[vector_field(keeps(i = (x[0] * x[0]).exp() * x[1]))]
fn bell(x: [f64; 2], a: f64) -> [f64; 2] {
    [a, -2.0 * a * x[0] * x[1]]
}

/// Two integrals of three coordinates.
#[vector_field(keeps(i = x[0].powi(3) * x[1] * x[1], j = x[0].exp() * x[2]))]
fn powers(x: [f64; 3], a: f64) -> [f64; 3] {
    let g = a * (1.0 + x[1] * x[1]) / (1.0 + x[0] * x[0]);
    [2.0 * g * x[0], -3.0 * g * x[1], -2.0 * g * x[0] * x[2]]
}

/// Asserts that `n` steps change the integrals by at most 8 n `factor` units of ε, relative to their values at the start. A coordinate that falls by a
/// `factor` in one step is rounded by this number of its last digits.
fn stays<S, M, R, const N: usize>(
    (system, method, h): (S, M, R),
    start: StateOf<S, R>,
    value: impl Fn(&S, &StateOf<S, R>) -> [R; N],
    (n, factor): (u32, f64),
) where
    S: PhaseSpace<R>,
    M: Method<S, R>,
    R: Real,
{
    let first = value(&system, &start);
    let mut sim = Integrator::new(system, method, h, start);
    let mut largest = 0.0;
    for _ in 0..n {
        sim.step().unwrap_or_else(|error| panic!("{}: {error}", method.name()));
        for (now, first) in value(&system, &sim.state()).into_iter().zip(first) {
            largest = f64::max(largest, (now - first).magnitude() / first.magnitude());
        }
    }
    let roundings = largest / R::epsilon();
    println!("{} h = {}: {roundings:.0} of {n} steps", method.name(), h.magnitude());
    assert!(roundings <= 8.0 * f64::from(n) * factor, "{}: {roundings} roundings", method.name());
}

#[test]
fn in_a_coordinate_that_falls_evenly() {
    for (u, v) in [(1.0, 1.0), (1e20, 1e-9)] {
        let (system, start) = (Wave { b: 1.0, u, v }, FlowState::new([0.0, v]));
        for (h, n) in [(0.1, 1000), (0.3, 330), (1.0, 100), (3.0, 33)] {
            let (steps, value) = ((n, f64::exp(h)), |system: &Wave, x: &_| [system.i(x)]);
            stays((system, DiscreteGradient, h), start, value, steps);
            stays((system, FourthOrder(DiscreteGradient), h), start, value, steps);
            stays((system, Suzuki4.of(DiscreteGradient), h), start, value, steps);
        }
    }
}

#[test]
fn in_single_precision() {
    for (h, n) in [(0.3, 200), (1.0, 60), (3.0, 20)] {
        let steps = (n, f64::exp(f64::from(h)));
        let (system, start) = (Single { b: 1.0 }, FlowState::new([0.0, 1.0]));
        stays((system, DiscreteGradient, h), start, |system: &Single<f32>, x| [system.i(x)], steps);
        stays((system, FourthOrder(DiscreteGradient), h), start, |system: &Single<f32>, x| [system.i(x)], steps);
    }
}

/// The squares of the last values of the coordinate underflow to zero in double precision.
#[test]
fn in_a_coordinate_that_falls_faster_and_faster() {
    let (system, start) = (Bell { a: 0.4 }, FlowState::new([0.0, 1.0]));
    stays((system, DiscreteGradient, 0.15), start, |system: &Bell, x| [system.i(x)], (400, 18.0));
    stays((system, FourthOrder(DiscreteGradient), 0.15), start, |system: &Bell, x| [system.i(x)], (400, 18.0));
}

#[test]
fn two_of_them() {
    let start = FlowState::new([1.0, 0.9, 0.8]);
    for (h, n) in [(0.1, 400), (0.6, 300), (2.0, 200)] {
        let value = |system: &Powers, x: &_| [system.i(x), system.j(x)];
        stays((Powers { a: 0.7 }, DiscreteGradient, h), start, value, (n, f64::exp(1.4 * h)));
    }
}

/// x₀ grows, x₁ falls as fast: gradients of two integrals become parallel, and the last coordinate grows with x₀.
#[vector_field(keeps(i = x[0] * x[1] * x[2], j = x[0] * x[0] * x[1]))]
fn parallel(x: [f64; 3], a: f64) -> [f64; 3] {
    let g = a * (1.0 + 1.0 / (1.0 + x[2] * x[2]));
    [g * x[0], -2.0 * g * x[1], g * x[2]]
}

/// One integral of the same kind.
#[vector_field(keeps(i = x[0] * x[1]))]
fn stretched(x: [f64; 2], a: f64) -> [f64; 2] {
    let g = a * (1.0 + 1.0 / (1.0 + x[0] * x[0]));
    [g * x[0], -g * x[1]]
}

/// A relaxed step must not take a change of the integral for the rounding of earlier, larger terms.
#[test]
fn relaxed() {
    for h in [0.05, 0.3, 1.0] {
        let value = |system: &Stretched, x: &_| [system.i(x)];
        let n = (100.0 / h) as u32;
        stays((Stretched { a: 1.0 }, Relaxation(RK4), h), FlowState::new([1.0, 1.3]), value, (n, 1.0));
    }
}

/// A step solves its equation, or is refused because of rounding.
#[test]
fn gradients_that_become_parallel() {
    let (system, start) = (Parallel { a: 1.0 }, FlowState::new([1.0, 1.3, 0.7]));
    let first = [system.i(&start), system.j(&start)];
    for (h, n) in [(0.05, 2000), (0.3, 400), (1.0, 100), (1.3, 80), (2.0, 50)] {
        let mut sim = system.integrator(FourthOrder(DiscreteGradient), h, start);
        let ended = (0..n).find_map(|_| sim.step().err());
        assert!(h > 0.3 || ended.is_none(), "h = {h}: {ended:?}");
        let now = [system.i(&sim.state()), system.j(&sim.state())];
        for (first, now) in first.into_iter().zip(now) {
            assert!((now / first - 1.0).abs() < 1e-12, "h = {h}: {now} after {ended:?}");
        }
    }
}

/// A coordinate may lose all digits in one step. The step is then refused and the state kept. Substeps that go back let the coordinate grow by as much. The
/// midpoint rule leads a projection astray. With h = 1, the largest error over 16 values of `a` from 0.36 to 0.435 is 5e-6.
#[test]
fn refused_where_rounding_is_larger() {
    fn check(method: impl Method<Bell>) {
        let (system, name) = (Bell { a: 0.4 }, method.name());
        for h in [0.3, 1.0, 2.0, 3.0] {
            let mut sim = system.integrator(method, h, FlowState::new([0.0, 1.0]));
            while sim.time() < 63.0 {
                let before = sim.state();
                let error = (system.i(&before) - 1.0).abs();
                assert!(error < 1e-5, "{name}, h = {h}: {before:?} {error:.1e}");
                if let Err(error) = sim.step() {
                    assert_eq!(sim.state(), before);
                    assert!(error.to_string().contains("try a smaller step"), "{error}");
                    break;
                }
            }
        }
    }
    check(DiscreteGradient);
    check(FourthOrder(DiscreteGradient));
    check(Suzuki4.of(DiscreteGradient));
    check(Projection(RK4, Integrals));
    check(Projection(DOP853, Integrals));
    check(Projection(ImplicitMidpoint, Integrals));
    check(Relaxation(RK4));
    check(Relaxation(DOP853));
}

/// A step of 2 or 3 is refused with `Rounded`. A shorter step succeeds.
#[test]
fn refused_by_name() {
    let system = Bell { a: 0.4 };
    for h in [2.0, 3.0] {
        let mut sim = system.integrator(DiscreteGradient, h, FlowState::new([0.0, 1.0]));
        let error = (0..30).find_map(|_| sim.step().err()).expect("a refusal");
        assert!(matches!(error, StepError { failure: Failure::Rounded, .. }), "{error}");
        let mut adaptive = system.adaptive(DiscreteGradient, 1e-6, sim.state());
        adaptive.advance_to(sim.time() + h).expect("shorter steps");
        sim.set_step_size(h / 16.0);
        sim.step().expect("a shorter step");
    }
}

/// A series is projected to the integral at the start of the run. x₁ falls by a factor of 20 in one step, so its rounding changes the integral by some
/// 10⁻¹³ in a few of 39 steps. Without projection the error of the series is 3·10⁻⁶.
#[test]
fn series() {
    let system = Stretched { a: 1.0 };
    for x1 in [0.3, 0.7, 1.1, 1.3, 2.3] {
        let start = FlowState::new([1.0, x1]);
        let mut sim = system.taylor(Projection(TaylorOrder::<20> { tolerance: 1e-6 }, Integrals), start);
        for (time, bound) in [(1.0, 1e-15), (10.0, 4e-12), (40.0, 1e-11), (100.0, 1e-11)] {
            sim.advance_to(time).expect("no pole");
            let error = (system.i(&sim.state()) / x1 - 1.0).abs();
            assert!(error < bound, "from {x1}, t = {time}: {error:.1e}");
        }
        let mut plain = system.taylor(TaylorOrder::<20> { tolerance: 1e-6 }, start);
        plain.advance_to(100.0).expect("no pole");
        assert!((system.i(&plain.state()) / x1 - 1.0).abs() > 1e-6);
    }
}

/// Euler's equations of a top that nearly rotates about its middle axis: rounding of what is kept is more of its two small coordinates than a series is off.
#[vector_field(keeps(
    e = a * x[0] * x[0] + b * x[1] * x[1] + c * x[2] * x[2],
    m = a * a * x[0] * x[0] + b * b * x[1] * x[1] + c * c * x[2] * x[2]
))]
fn rotation(x: [f64; 3], a: f64, b: f64, c: f64) -> [f64; 3] {
    [(b - c) / a * x[1] * x[2], (c - a) / b * x[2] * x[0], (a - b) / c * x[0] * x[1]]
}

/// The projection does not shorten the steps.
#[test]
fn series_beside_a_large_coordinate() {
    let system = Rotation { a: 1.0, b: 2.0, c: 3.0 };
    for small in [1e-3, 1e-6, 1e-9, 1e-12] {
        let start = FlowState::new([small, 0.8, 0.0]);
        let mut plain = system.taylor(Taylor::default(), start);
        plain.advance_to(10.0).expect("no pole");
        let mut projected = system.taylor(Projection(Taylor::default(), Integrals), start);
        while projected.time() < 10.0 {
            assert!(projected.steps() < 2 * plain.steps(), "{small}: {:?}", projected.state());
            projected.step_towards(10.0).expect("no pole");
        }
        let error = (projected.state().x[0] / plain.state().x[0] - 1.0).abs();
        assert!(error < 1e-6, "{small}: {error:.1e}");
    }
}
