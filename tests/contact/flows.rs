//! Every family of pieces with a flow in closed form, against the differential equation solved to 20 digits and more.

mod check;
mod poles;

use check::{Instance, check};
use geoint_runtime::prelude::*;

/// An energy a line, with the rule that is to know its flow and how accurate that is, in units of its condition.
macro_rules! instances {
    ($test:ident, $of:ty, ($q:ident $p:ident $s:ident $t:ident): $($System:ident, $rule:literal, $bound:literal => $energy:expr;)*) => {
        #[test]
        fn $test() {
            let mut failed = vec![];
            $({
                #[contact_hamiltonian(name = $System)]
                #[allow(unused_variables)]
                fn energy($q: $of, $p: $of, $s: f64, $t: f64) -> f64 {
                    $energy
                }
                let instance = Instance { name: stringify!($System), report: $System::REPORT, rule: $rule, bound: $bound };
                failed.extend(check(&instance, $System).err());
            })*
            assert!(failed.is_empty(), "{}", failed.join("\n"));
        }
    };
}

instances! { one_degree_of_freedom, f64, (q p s t):
    // 1–3: a constant, a potential, a kinetic energy.
    Reeb, "drift", 4.0 => 0.7 + 0.0 * q;
    Potential, "prolongation", 4.0 => q.sin() + 1.3;
    Parabola, "prolongation", 4.0 => 0.85 * q * q;
    ThirdPower, "prolongation", 4.0 => q.powi(3) - 0.7 * q;
    Driven, "prolongation", 4.0 => q * q * t.cos() - (0.4 + 2.3 * t).sin() * q + t * t * q.powi(3);
    Free, "drift", 4.0 => p * p / 1.4;
    Relativistic, "drift", 4.0 => (1.0 + p * p).sqrt();
    Drifting, "drift", 4.0 => p.powi(4) / 4.0 + 0.3 * p;
    DrivenDrift, "drift", 4.0 => p * p * (1.5 + t.sin()) + p * t;
    // 4: damping.
    Decay, "prolongation", 4.0 => 0.7 * s;
    DecayBySine, "prolongation", 4.0 => (2.3 * t).sin() * s;
    DecayByCosine, "prolongation", 4.0 => (0.3 - 2.3 * t).cos() * s;
    DecayByExponential, "prolongation", 4.0 => 0.8 * (-1.3 * t).exp() * s;
    DecayByPower, "prolongation", 4.0 => (0.4 + 1.7 * t * t) * s;
    DecayByRoot, "prolongation", 4.0 => s * t.sqrt();
    DecayByInverseSquare, "prolongation", 4.0 => s / (t * t);
    DecayInTime, "prolongation", 4.0 => 2.0 / t * s;
    DecayInTimeByRoot, "prolongation", 4.0 => 1.5 * s / t;
    DecayInTimeByPower, "prolongation", 4.0 => 1.7 * s / t;
    // 5–6: damping that depends on position.
    Friction, "prolongation", 4.0 => (q.sin() + 1.3) * s;
    FrictionInTime, "prolongation", 4.0 => (q.sin() + 1.3) * (2.3 * t).cos() * s;
    FrictionOverTime, "prolongation", 4.0 => (q.sin() + 1.3) / t * s;
    Affine, "prolongation", 4.0 => (q.sin() + 1.3) * s + q.powi(3) / 4.0 - q;
    VanDerPol, "prolongation", 4.0 => -5.0 * (1.0 - q * q) * s + q;
    // 7–8: squares of s.
    SquareOfAction, "prolongation", 4.0 => 0.7 * s * s;
    Quadratic, "prolongation", 4.0 => (q.sin() + 1.3) * s * s;
    QuadraticInTime, "prolongation", 4.0 => (q.sin() + 1.3) * (2.0 * t).sin() * s * s;
    Riccati, "prolongation", 4.0 => s * s / 2.0 - 1.1;
    Tangent, "prolongation", 4.0 => s * s / 2.0 + 1.1;
    RiccatiOfPosition, "prolongation", 4.0 => (1.2 + q * q) * s * s - q.sin() * s + 0.4 * q.cos();
    RiccatiOfPositionTurning, "prolongation", 4.0 => (1.2 + q * q) * s * s - q.sin() * s - q.cos() - 1.5;
    // 9–10: functions of s.
    Cube, "prolongation", 4.0 => 0.7 * s.powi(3);
    CubeOfPosition, "prolongation", 4.0 => (q.sin() + 1.3) * s.powi(3);
    InversePower, "prolongation", 4.0 => 0.3 / (1.3 + 0.4 * s);
    Fourth, "prolongation", 4.0 => 0.7 * s + 0.4 * s.powi(4);
    BernoulliOfPosition, "prolongation", 4.0 => q * s + (0.4 + q * q) * s.powi(3);
    Exponential, "prolongation", 4.0 => 0.7 * s.exp();
    ExponentialOfPosition, "prolongation", 4.0 => q * (0.6 * s).exp() + q * q;
    ExponentialInTime, "prolongation", 4.0 => t * t * (0.6 * s).exp();
    Arctangent, "prolongation", 4.0 => 1.0 + s * s;
    SineOfAction, "prolongation", 4.0 => 1.3 * (0.8 * s + 0.1).sin();
    CosineOfAction, "prolongation", 4.0 => 1.3 * (0.8 * s + 0.1).cos();
    SinhOfAction, "prolongation", 4.0 => 0.9 * (0.8 * s + 0.1).sinh();
    TanhOfAction, "prolongation", 4.0 => 1.3 * (0.8 * s + 0.1).tanh();
    SechOfAction, "prolongation", 4.0 => 1.3 / (0.8 * s + 0.1).cosh();
    // 11–12: products with functions of s.
    ExponentialTimesPotential, "prolongation", 4.0 => q.cos() * (0.6 * s).exp();
    SineTimesPotential, "prolongation", 4.0 => (0.3 + q * q) * (1.3 * s).sin();
    WeightedByExponential, "weighted drift", 4.0 => p * p / 2.0 * (0.6 * s).exp();
    WeightedByAction, "weighted drift", 4.0 => p * p / 1.4 * (2.0 + s);
    WeightedByRoot, "weighted drift", 4.0 => p * p / 1.4 * (2.0 + s).sqrt();
    WeightedByHyperbolicCosine, "weighted drift", 4.0 => p * p / 1.4 * (0.8 * s).cosh();
    // 13: s pᵏ.
    PowerTwo, "weighted drift", 4.0 => s * p * p / 2.0;
    PowerThree, "weighted power", 4.0 => 0.7 * s * p.powi(3) / 3.0;
    PowerFour, "weighted power", 4.0 => t * s * p.powi(4);
    // 14: lifts of q' = X(q).
    Shift, "drift", 4.0 => 0.7 * p;
    Scale, "prolongation", 4.0 => p * q;
    SquareLift, "prolongation", 4.0 => p * q * q;
    CubicLift, "prolongation", 4.0 => p * (q - q.powi(3));
    RiccatiLift, "prolongation", 4.0 => p * (q * q - 0.3 * q + 0.4);
    SineLift, "prolongation", 4.0 => p * q.sin();
    SqrtLift, "prolongation", 4.0 => p * (1.5 + q).sqrt();
    TimedLift, "prolongation", 4.0 => p * q * q * (1.7 * t).cos();
    // 15–17: lifts that read s.
    ContactLift, "prolongation", 4.0 => p * s;
    SquareOfActionLift, "prolongation", 4.0 => p * s * s;
    TimedContact, "prolongation", 4.0 => p * s.sin() * t.exp();
    Turning, "prolongation", 4.0 => p * s + q;
    TurningInto, "prolongation", 4.0 => 1.3 * p * s + 0.4 * p * q - 0.7 * q + 0.2 * s;
    Scaling, "prolongation", 4.0 => 0.4 * q * p + 0.9 * s;
    // 18–19: damped drifts.
    Damped, "damped drift", 4.0 => p * p / 1.4 + 0.7 * s;
    Driving, "damped drift", 4.0 => p * p / 1.4 - 0.7 * s;
    LaneEmden, "damped drift", 4.0 => p * p / 2.0 + 2.0 / t * s;
    LaneEmdenThree, "damped drift", 4.0 => p * p / 1.4 + 3.0 / t * s;
    LaneEmdenFour, "damped drift", 4.0 => p * p / 1.4 + 4.0 * s / t;
    // 20–22: quadratic in (q, p).
    Oscillator, "damped oscillator", 4.0 => p * p / 2.0 + 1.7 * 1.7 * q * q / 2.0;
    Saddle, "damped oscillator", 4.0 => p * p / 1.4 - 1.2 * q * q + 0.3 * q * p;
    DampedOscillator, "damped oscillator", 4.0 => p * p / 2.0 + 1.7 * 1.7 * q * q / 2.0 + 0.7 * s;
    OverdampedOscillator, "damped oscillator", 4.0 => p * p / 1.4 + q * q / 3.0 + 6.0 * s;
    CriticalOscillator, "damped oscillator", 4.0 => p * p / 2.0 + q * q / 2.0 + 2.0 * s;
    Gravity, "uniform field", 4.0 => p * p / 2.0 + 0.7 * q;
    Throw, "uniform field", 4.0 => p * p / 1.4 + 0.3 * p + 0.7 * q - 0.2;
    // 23: geodesics.
    Geodesic, "geodesic", 4.0 => q * q * p * p / 2.0;
    HyperbolicGeodesic, "geodesic", 4.0 => (1.0 + 0.5 * q) * p * p;
    CubicGeodesic, "geodesic", 4.0 => (2.0 + q).powi(4) * p * p / 16.0;
    // 24–25: conjugates.
    ConjugateFriction, "Legendre conjugate", 4.0 => (p.sin() + 1.3) * (s - p * q);
    ConjugateDecay, "prolongation", 4.0 => 0.7 * (s - p * q);
    ConjugateSquare, "Legendre conjugate", 4.0 => 0.7 * (s - p * q).powi(2);
    ConjugateGeodesic, "Legendre conjugate", 4.0 => (1.0 + 0.5 * p) * q * q;
}

instances! { two_degrees_of_freedom, [f64; 2], (q p s t):
    Potentials, "prolongation", 4.0 => (q[0] + 2.0 * q[1]).sin() * q[1];
    Kinetics, "drift", 4.0 => p[0] * p[0] / 1.4 + p[1] * p[0] + 0.9 * p[1] * p[1];
    Relativistics, "drift", 4.0 => (1.0 + p[0] * p[0] + p[1] * p[1]).sqrt();
    Frictions, "prolongation", 4.0 => (q[0] * q[0] + q[0] * q[1] + 1.0) * s;
    Affines, "prolongation", 4.0 => (q[0] * q[0] + q[0] * q[1] + 1.0) * s + (q[0] - q[1]).cos();
    Quadratics, "prolongation", 4.0 => (q[0] * q[1] + 1.0) * s * s - q[0].sin();
    Exponentials, "prolongation", 4.0 => (q[0] * q[0] + q[0] * q[1] + 1.0) * (0.6 * s).exp();
    Weighted, "weighted drift", 4.0 => (p[0] * p[0] + p[1] * p[1]) / 2.0 * (0.6 * s).exp();
    WeightedMasses, "weighted drift", 4.0 => (p[0] * p[0] / 1.4 + 0.3 * p[0] * p[1] + 0.9 * p[1] * p[1]) * (2.0 + s);
    Shear, "prolongation", 4.0 => p[0] * q[1].sin();
    Shears, "prolongation", 4.0 => p[0] * q[1].sin() + 0.3 * s * q[1] + q[1] * q[1];
    Rotation, "prolongation", 4.0 => p[0] * q[1] - p[1] * q[0];
    Linear, "prolongation", 4.0 => 0.3 * p[0] * q[0] + 1.3 * p[0] * q[1] - 0.4 * p[1] * q[0] - 0.5 * p[1] * q[1];
    LinearWithDecay, "prolongation", 4.0 => 0.3 * p[0] * q[0] + 1.3 * p[0] * q[1] + 0.4 * p[1] * q[0] + 0.5 * s;
    Componentwise, "prolongation", 4.0 => p[0] * (q[0] - q[0].powi(3)) + p[1] * (q[1] * q[1] - 0.2);
    ActionLift, "prolongation", 4.0 => p[0] * s.sin() + p[1] * s * s;
    ActionAndPlace, "prolongation", 4.0 => p[0] * s * q[0] + 0.7 * p[1] * q[1];
    TurningPlace, "prolongation", 4.0 => p[0] * s + q[0] + p[1] * q[1];
    DampedMasses, "damped drift", 4.0 => p[0] * p[0] / 1.4 + 0.3 * p[0] * p[1] + 0.9 * p[1] * p[1] + 0.7 * s;
    LaneEmdenMasses, "damped drift", 4.0 => p[0] * p[0] / 1.4 + 0.3 * p[0] * p[1] + 0.9 * p[1] * p[1] + 3.0 / t * s;
    Oscillators, "damped oscillator", 4.0 => (p[0] * p[0] + 3.0 * q[0] * q[0]) / 2.0 + p[1] * p[1] / 1.4 + 0.7 * q[1] * q[1] + 0.7 * s;
    Fields, "uniform field", 4.0 => p[0] * p[0] / 1.4 + 0.3 * p[0] * p[1] + 0.9 * p[1] * p[1] + 0.4 * q[0] - 0.7 * q[1] + 0.2 * p[1];
    Conjugates, "Legendre conjugate", 4.0 => (p[0] * p[0] + p[0] * p[1] + 1.0) * (s - p[0] * q[0] - p[1] * q[1]);
    ConjugateDecays, "prolongation", 4.0 => 0.7 * (s - p[0] * q[0] - p[1] * q[1]);
}
