//! Coefficients that go through zero: no flow notices.

use super::check::Over;
use super::check::step;
use geoint_runtime::prelude::*;

/// An energy with a coefficient c a line.
macro_rules! limits {
    ($test:ident, $of:ty, $x:expr, ($q:ident $p:ident $s:ident $t:ident $c:ident): $($System:ident => $energy:expr;)*) => {
        #[test]
        fn $test() {
            $({
                #[contact_hamiltonian(name = $System)]
                #[allow(unused_variables)]
                fn energy($q: $of, $p: $of, $s: f64, $t: f64, $c: f64) -> f64 {
                    $energy
                }
                for h in [0.3, -0.3, 1e-5] {
                    continuous(stringify!($System), |c| $System { c }, &$x, h);
                }
            })*
        }
    };
}

fn continuous<const N: usize, S: Over<f64, N>>(name: &str, of: impl Fn(f64) -> S, x: &[f64], h: f64) {
    assert_eq!(S::PIECES.len(), 1, "{name}");
    let end = |c: f64| step(of(c), x, 0.5, h).unwrap_or_else(|error| panic!("{name}, c = {c:e}: {error}"));
    let at_zero = end(0.0);
    let slope = |i: usize| (end(1e-3)[i] - end(-1e-3)[i]).abs() / 2e-3;
    for size in [5e-324, 1e-300, 1e-150, 1e-30, 1e-17, 1e-12, 1e-9, 1e-6] {
        for c in [size, -size] {
            for (i, (there, limit)) in end(c).into_iter().zip(&at_zero).enumerate() {
                let allowed = 1e-15 * (1.0 + limit.abs()) + 1.5 * slope(i) * size + 10.0 * size * size;
                assert!((there - limit).abs() <= allowed, "{name}, h = {h}, c = {c:e}, {i}: {there:e} {limit:e}");
            }
        }
    }
}

limits! { one_degree_of_freedom, f64, [0.3, 0.7, 0.8], (q p s t c):
    Decay => c * s + 0.0 * q;
    Affine => c * s + q.sin();
    AffineOfPosition => c * q * s + q.sin();
    Riccati => s * s / 2.0 - c;
    RiccatiLeading => c * s * s + 0.4 * s - 0.3;
    RiccatiOfPosition => c * q * s * s + c * q.sin() * s - c;
    RiccatiTurning => s * s - 2.0 * s + 1.0 + c;
    Bernoulli => c * s + 0.4 * s.powi(3);
    BernoulliOther => 0.7 * s + c * s.powi(4);
    Cube => c * s.powi(3);
    Exponential => c * s.exp() + 0.0 * q;
    ExponentialDrift => 0.3 * s.exp() + c * q;
    ExponentialRate => q * q + 0.4 * (c * s).exp();
    ExponentialRateAlone => 0.4 * (c * s).exp() * q;
    Line => 0.3 / (1.0 + c * s);
    SineRate => (c * s + 0.3).sin();
    CosineRate => (c * s).cos();
    SinhRate => (c * s + 0.3).sinh();
    TanhRate => (c * s + 0.3).tanh();
    SechRate => 1.0 / (c * s + 0.3).cosh();
    TimedBySine => (c * t + 0.2).sin() * s;
    TimedByCosine => (c * t).cos() * s;
    TimedByExponential => (c * t).exp() * s;
    OverTime => c * s / t;
    WeightedByExponential => p * p * 0.7 * (c * s).exp();
    WeightedByLine => p * p * 0.7 * (1.0 + c * s);
    WeightedBySquare => c * p * p * (2.0 + s).powi(2);
    WeightedPower => c * s * p.powi(3);
    Lift => p * (c * q + 0.3);
    LiftOfSquare => p * (c * q * q + 0.3 * q);
    LiftOfAction => c * p * s * s;
    Turning => p * s + c * q;
    TurningOther => c * p * s + q;
    TurningBoth => 0.4 * p * q + 0.4 * s + c * p * s;
    Damped => p * p * 0.7 + c * s;
    Oscillator => p * p * 0.7 + c * q * q;
    OscillatorWithDecay => p * p * 0.7 + 0.4 * q * q + c * s;
    CriticalOscillator => p * p * 0.5 + (0.5 + c) * q * q + 2.0 * s;
    OscillatorOfMass => c * p * p + 0.5 * q * q + 0.3 * s;
    Gravity => p * p * 0.7 + c * q;
    Geodesic => (1.0 + c * q) * p * p;
    GeodesicOfPower => c * q.powi(3) * p * p;
    ConjugateFriction => c * p.sin() * (s - p * q);
    ConjugateSquare => c * (s - p * q).powi(2);
}

limits! { two_degrees_of_freedom, [f64; 2], [0.3, 0.4, 0.7, -0.6, 0.8], (q p s t c):
    Linear => 0.3 * p[0] * q[0] + 0.3 * p[1] * q[1] + c * p[0] * q[1] + 0.2 * p[1] * q[0];
    Jordan => 0.3 * p[0] * q[0] + (0.3 + c) * p[1] * q[1] + p[0] * q[1];
    Rotation => c * (p[0] * q[1] - p[1] * q[0]);
    ActionLift => p[0] * s + c * p[1] * s.sin();
    Masses => p[0] * p[0] * 0.7 + c * p[0] * p[1] + 0.9 * p[1] * p[1] + c * s;
    Oscillators => p[0] * p[0] * 0.7 + c * q[0] * q[0] + p[1] * p[1] + q[1] * q[1] + c * s;
}
