//! Divided differences as they are emitted: an energy is kept by a step if and only if its slopes are exact.
//!
//! The tests of the macro compare the building blocks with quotients of hundreds of digits.

use geoint_runtime::Real;
use geoint_runtime::prelude::*;
use geoint_runtime::private::slope;
use geoint_tests::measure::Noise;
use geoint_tests::scalars::{Double, Lanes};

/// One energy per line, with its start. The discrete gradient keeps the energy to a few roundings in every step.
macro_rules! kept {
    ($q:ident $p:ident: $($name:ident $System:ident at $start:expr => $energy:expr;)*) => {
        $(
            #[hamiltonian(name = $System)]
            fn $name($q: f64, $p: f64) -> f64 {
                $energy
            }
        )*

        #[test]
        fn energies_are_kept() {
            $( keeps(stringify!($name), $System, $start, $name); )*
        }
    };
}

fn keeps<S>(name: &str, system: S, start: (f64, f64), written: fn(f64, f64) -> f64)
where
    S: Hamiltonian<Coordinates = f64>,
    DiscreteGradient: Method<S, f64>,
{
    for h in [1e-9, 0.02, -0.05] {
        let mut sim = system.integrator(DiscreteGradient, h, State::new(start.0, start.1));
        let (energy, mut largest, mut farthest) = (written(start.0, start.1), 0.0_f64, 0.0_f64);
        for step in 0..20 {
            sim.step().unwrap_or_else(|error| panic!("{name}, h = {h}, step {step}: {error}"));
            largest = largest.max((written(sim.state().q, sim.state().p) - energy).abs());
            farthest = farthest.max((sim.state().q - start.0).abs());
        }
        assert!(largest < 4e-15 * (1.0 + energy.abs()), "{name}, h = {h}: {largest:.1e}");
        assert!(farthest > 2.0 * h.abs(), "{name} rests");
    }
}

kept! { q p:
    sin Sin at (0.6, 0.5) => p * p / 1.4 + q.sin();
    cos Cos at (0.6, 0.5) => p * p / 1.4 - 2.0 * q.cos();
    tan Tan at (0.2, 0.5) => p * p / 1.4 + (0.4 * q).tan();
    asin Asin at (0.1, 0.5) => p * p / 1.4 + (0.4 * q).asin();
    acos Acos at (0.1, 0.5) => p * p / 1.4 + (0.4 * q).acos();
    atan Atan at (0.6, 0.5) => p * p / 1.4 + (p - 2.0 * q).atan();
    atan2 Atan2 at (0.1, -0.9) => (p * p + q * q) * (1.4 + 0.3 * (2.0 * q.atan2(p)).cos());
    sinh Sinh at (0.6, 0.5) => p * p / 1.4 + q.sinh();
    cosh Cosh at (0.6, 0.5) => p.cosh() + (p * q).cosh();
    tanh Tanh at (0.6, 0.5) => p * p / 1.4 + q.tanh();
    asinh Asinh at (0.6, 0.5) => p * p / 1.4 + q.asinh();
    acosh Acosh at (0.6, 0.5) => p * p / 1.4 + (1.1 + q * q).acosh();
    atanh Atanh at (0.1, 0.5) => p * p / 1.4 + (0.3 * q).atanh();
    exp Exp at (0.6, 0.5) => p * p / 1.4 + (q * p).exp();
    exp2 Exp2 at (0.6, 0.5) => p * p / 1.4 + q.exp2();
    exp_m1 ExpM1 at (0.6, 0.5) => p * p / 1.4 + q.exp_m1();
    ln Ln at (1.6, 0.5) => p * p / 1.4 + 0.3 * q.ln();
    ln_1p Ln1p at (0.6, 0.5) => p * p / 1.4 + (0.3 * q).ln_1p();
    log2 Log2 at (1.6, 0.5) => p * p / 1.4 + 0.3 * q.log2();
    log10 Log10 at (1.6, 0.5) => p * p / 1.4 + q.log10();
    cbrt Cbrt at (1.6, 0.5) => p * p / 1.4 + q.cbrt();
    hypot Hypot at (0.6, 0.5) => q.hypot(0.3) + p.hypot(q);
    powf Powf at (0.6, 0.5) => p * p / 1.4 + (0.2 + q * q).powf(1.7) - (0.2 + q * q).powf(-0.3);
    power Power at (0.6, 0.5) => p.abs().powf(1.3) + (0.2 + q * q).powf(p);
    abs Abs at (0.3, 0.5) => p * p / 1.4 + 0.8 * q.abs();
    min Min at (0.3, 0.5) => p * p / 1.4 + (q * q).min(0.5 - q);
    max Max at (0.3, 0.5) => p * p / 1.4 + q.max(-0.3 * q);
    signum Signum at (0.05, 1.5) => p * p / 1.4 - 0.2 * q.signum() * q.cos();
    sqrt Sqrt at (0.6, 0.5) => (1.0 + p * p).sqrt() + 0.3 * (2.0 + q).sqrt();
    contact Contact at (0.1, -0.9) => p * p / 1.4 + 3.0 * (-q).max(0.0).powf(2.5);
    inverse Inverse at (1.6, 0.5) => p * p / 1.4 + q.powi(-6) - q.powi(-3) - 1.0 / q;
    quotient Quotient at (0.6, 0.5) => (p * p + q.cos()) / (1.0 + q * q * p.sin());
    branch Branch at (0.1, -0.9) => p * p / 1.4 + if q < 0.0 { q * q } else { 0.3 * (1.0 + q).ln() };
}

/// A particle at rest in the kink or in the zero of an energy stays there.
#[test]
fn what_rests_at_zero_stays() {
    for step in Contact.integrator(DiscreteGradient, 0.1, State::new(0.0, 0.0)).sampled(1).take(10) {
        let state = step.expect("a step");
        assert_eq!((state.q, state.p), (0.0, 0.0));
    }
}

/// A helper of one to three arguments.
type Helper<R> = (&'static str, fn([R; 3]) -> R);

/// All helpers, with their numbers of arguments.
fn helpers<R: Real>() -> Vec<Helper<R>> {
    macro_rules! list {
        ($($name:ident $arity:tt),*) => { vec![$( (stringify!($name), list!(call $name $arity)) ),*] };
        (call $name:ident 1) => { |[x, _, _]| slope::$name(x) };
        (call $name:ident 2) => { |[x, y, _]| slope::$name(x, y) };
        (call $name:ident 3) => { |[x, y, z]| slope::$name(x, y, z) };
    }
    list![
        sinc 1, sinc_derivative 1, sinhc 1, sinhc_derivative 1, arc 2, arc_derivative 2, exp 2, exp_derivative 2,
        exp2 2, ln 2, ln_derivative 2, tanh 2, tanh_derivative 2, powf 3, powf_derivative 3, abs 2, abs_derivative 2,
        recip_positive 1, root 1, phi_1 1, phi_1_derivative 1, stumpff_c0 1, stumpff_c1 1, stumpff_c1_derivative 1
    ]
}

/// Pairs of every kind, and an exponent.
fn arguments() -> Vec<[f64; 3]> {
    let mut noise = Noise::new(3);
    let mut next = || noise.next().expect("endless");
    let near =
        |x: f64| [[x, x], [x, x * (1.0 + 1e-15)], [x, x * (1.0 - 1e-9)], [x, 0.9 * x], [0.2 * x, x], [x, 30.0 * x]];
    let pairs = [1e-12, 0.03, 0.7, 1.0, 4.0].into_iter().flat_map(near);
    pairs.map(|[a, b]| [a, b, 1.7 + next()]).collect()
}

/// Each component is computed as if alone, independent of its neighbour.
#[test]
fn helpers_hold_in_every_lane() {
    for ((name, alone), (_, beside)) in helpers::<f64>().into_iter().zip(helpers::<Lanes>()) {
        for x in arguments() {
            for y in arguments() {
                let expected = [alone(x), alone(y)];
                let Lanes(found) = beside([0, 1, 2].map(|i| Lanes([x[i], y[i]])));
                for (found, expected) in found.into_iter().zip(expected) {
                    let error = (found - expected).abs() / expected.abs();
                    assert!(error < 1e-15 || found == expected, "{name} of {x:?} beside {y:?}: {found:e} {expected:e}");
                }
            }
        }
    }
}

/// In single precision helpers are accurate to single precision.
#[test]
fn helpers_hold_in_single_precision() {
    for ((name, wide), (_, narrow)) in helpers::<f64>().into_iter().zip(helpers::<f32>()) {
        for x in arguments() {
            let x = x.map(|x| x as f32);
            let (found, expected) = (f64::from(narrow(x)), wide(x.map(f64::from)));
            // Second differences are smaller than their terms.
            let size = expected.abs() + if name.ends_with("_derivative") { 0.3 } else { 0.0 };
            let error = (found - expected).abs() / size / f64::from(f32::EPSILON);
            assert!(error < 60.0 || expected.abs() > 1e30, "{name} of {x:?}: {found:e} {expected:e}");
        }
    }
}

/// Coefficients have the digits of `f64`: their sums stand in for no function of a scalar that has more.
#[test]
fn friction_has_all_digits() {
    for x in [-1.0, -0.3, -0.02, 0.02, 0.3, 1.0].map(Double::from) {
        let mut expected = Double::from(0.0);
        for k in (1..40).rev() {
            expected = (expected * x + 1.0) / f64::from(k);
        }
        let error = (slope::phi_1(x) - expected).magnitude();
        assert!(error < 1e-28, "{x:?}: {error:e}");
    }
}
