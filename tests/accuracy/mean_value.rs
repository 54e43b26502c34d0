//! The mean value of the gradient. If it is exact, it agrees with quadrature. If it is not exact, the claims say so and the energy shows it.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Hamiltonian, Method, Real};
use geoint_tests::measure::{Noise, distance};
use geoint_tests::problems::{HenonHeiles, flat};
use geoint_tests::scalars::Double;

/// Functions of linear forms beside a polynomial in several coordinates, of degree 4.
#[hamiltonian]
fn mixed(q: [f64; 2], p: [f64; 2], m: [f64; 2], a: f64, b: f64) -> f64 {
    let [x, y] = q;
    let kinetic = p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]);
    kinetic + a * x.powi(4) + 3.0 * b * x * x * y * y - x.cos() + (0.3 * (x + 2.0 * y)).exp() + (x - y).powi(6) / 9.0
}

/// The same with q and p coupled, by a polynomial of degree 6.
#[hamiltonian]
fn coupled(q: [f64; 2], p: [f64; 2], m: [f64; 2], a: f64, b: f64) -> f64 {
    let [x, y] = q;
    let kinetic = p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]);
    kinetic + a * (x * x + y * y) * (1.0 + p[1] * p[1] * x * x) - b * (x - 0.4 * p[0]).cos() + (1.0 + y * y).sqrt()
}

/// A function of a form that is not linear.
#[hamiltonian]
fn control(q: [f64; 2], p: [f64; 2], m: [f64; 2], a: f64, b: f64) -> f64 {
    let [x, y] = q;
    p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]) + a * (x * x + y * y) + b * (x * y).sin()
}

macro_rules! with_masses {
    ($System:ident) => {
        $System { m: [1.7, 0.6].map(Into::into), a: 0.35.into(), b: 0.45.into() }
    };
}

const START: State<[f64; 2]> = State { q: [0.9, -0.4], p: [0.3, 0.8], t: 0.0 };

/// Returns the largest relative error of the energy in 2000 steps, and the claim of the method.
fn energy<S: Hamiltonian<Coordinates = [f64; 2]>, M: Method<S>>(system: S, method: M, h: f64) -> (f64, bool) {
    let claims = method.claims().conserves_energy;
    let before = system.energy(&START);
    let mut sim = system.integrator(method, h, START);
    let largest = sim
        .sampled(1)
        .take(2000)
        .fold(0.0, |largest: f64, state| largest.max((system.energy(&state.unwrap()) / before - 1.0).abs()));
    (largest, claims)
}

macro_rules! energies {
    ($($System:ident, $method:expr, $h:expr => $expected:expr;)*) => { $({
        let (observed, claims) = energy(with_masses!($System), $method, $h);
        println!(concat!(stringify!($System), " ", stringify!($method), " {:.1e}"), observed);
        let expected: core::ops::Range<f64> = $expected;
        assert!(expected.contains(&observed), concat!(stringify!($System), " ", stringify!($method), " {:e}"), observed);
        assert_eq!(claims, expected.start == 0.0, stringify!($System $method));
    })* };
}

/// The energy is conserved if and only if the mean is exact. The claims of the method say beforehand whether it is.
#[test]
fn energy_is_kept_where_the_mean_is_exact() {
    energies! {
        Mixed, MeanValue::<2>, 0.1 => 0.0..1e-14;
        Mixed, MeanValue::<5>, 0.1 => 0.0..1e-14;
        Mixed, FourthOrder(MeanValue::<2>), 0.1 => 0.0..1e-14;
        // Steps in which the iteration shrinks slowly, and not in every turn.
        Mixed, FourthOrder(MeanValue::<2>), 0.25 => 0.0..1e-13;
        Mixed, Suzuki4.of(MeanValue::<2>), 0.1 => 0.0..1e-14;
        Coupled, MeanValue::<3>, 0.1 => 0.0..1e-14;
        Coupled, FourthOrder(MeanValue::<4>), 0.1 => 0.0..1e-14;
        // Too few points.
        Mixed, MeanValue::<1>, 0.1 => 1e-5..1.0;
        Coupled, MeanValue::<2>, 0.1 => 1e-8..1.0;
        // No number of points is enough.
        Control, MeanValue::<1>, 0.1 => 1e-5..1.0;
        Control, MeanValue::<2>, 0.1 => 1e-9..1e-5;
        Control, FourthOrder(MeanValue::<2>), 0.1 => 1e-9..1e-5;
    }
}

#[test]
fn reports_say_which_mean_is_exact() {
    let lines = [
        (HenonHeiles::REPORT, "`MeanValue::<2>` is exact: Gauss points"),
        (Mixed::REPORT, "`MeanValue::<2>` is exact: `DiscreteGradient` over parts of a step"),
        (Coupled::REPORT, "`MeanValue::<3>` is exact: `DiscreteGradient` over parts of a step"),
        (
            Control::REPORT,
            "`MeanValue::<N>` is a quadrature with N Gauss points: no closed form was found for sin(q[0]·q[1])",
        ),
    ];
    for (report, line) in lines {
        assert!(report.contains(line), "{report}");
    }
}

/// Returns the largest distance of steps from h J times the mean of ∇H between their ends. The steps start at random points and run in double-double.
/// The mean is taken in 64 parts with three Gauss points each.
fn off_the_mean<S, M: Method<S, Double>>(system: S, method: M) -> f64
where
    S: Hamiltonian<Double, Coordinates = [Double; 2], Array = [Double; 2]>,
{
    const PARTS: u32 = 64;
    let real = |x: u32| Double::from(f64::from(x));
    let outer = (real(3) / real(5)).sqrt();
    let rule = [(-outer, real(5)), (real(0), real(8)), (outer, real(5))];
    let mut noise = Noise::new(3);
    (0..6).fold(0.0, |largest: f64, _| {
        let mut random = || [(); 2].map(|()| Double::from(noise.next().unwrap_or_default()));
        let (start, h) = (State::new(random(), random()), real(1) / real(5));
        let mut sim = system.integrator(method, h, start);
        sim.step().unwrap();
        let end = sim.state();
        let mut step = [0; 4].map(real);
        for (part, (node, weight)) in (0..PARTS).flat_map(|part| rule.map(|point| (part, point))) {
            let s = (real(2 * part + 1) + node) / real(2 * PARTS);
            let between = |a: [Double; 2], b: [Double; 2]| [0, 1].map(|i| a[i] + s * (b[i] - a[i]));
            let mut slopes = [[real(0); 2]; 2];
            system.gradient(real(0), &[between(start.q, end.q), between(start.p, end.p)], &mut slopes);
            let [dq, dp] = slopes;
            let rate = [dp[0], dp[1], -dq[0], -dq[1]];
            step = [0, 1, 2, 3].map(|i| step[i] + h * weight / real(18 * PARTS) * rate[i]);
        }
        let change: Vec<Double> = flat(&end).into_iter().zip(flat(&start)).map(|(end, start)| end - start).collect();
        largest.max(distance(&change, &step))
    })
}

/// Compares beyond double precision, so that only a closed form passes.
#[test]
fn steps_follow_the_mean() {
    macro_rules! off {
        ($($System:ident, $method:expr => $expected:expr;)*) => { $({
            let observed = off_the_mean(with_masses!($System), $method);
            println!(concat!(stringify!($System), " ", stringify!($method), " {:.1e}"), observed);
            let expected: core::ops::Range<f64> = $expected;
            assert!(expected.contains(&observed), concat!(stringify!($System), " ", stringify!($method), " {:e}"), observed);
        })* };
    }
    off! {
        Mixed, MeanValue::<2> => 0.0..1e-18;
        Mixed, MeanValue::<3> => 0.0..1e-18;
        Coupled, MeanValue::<3> => 0.0..1e-18;
        // Controls: a method with another mean that conserves the energy, and a quadrature.
        Mixed, DiscreteGradient => 1e-6..1.0;
        Mixed, MeanValue::<1> => 1e-6..1.0;
        Coupled, MeanValue::<2> => 1e-9..1.0;
        Control, MeanValue::<3> => 1e-12..1e-3;
    }
}
