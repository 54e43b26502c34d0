//! Every family of pieces with a flow in closed form, against the differential equation solved to 20 digits and more.

mod check;
mod frozen;
mod limits;
mod poles;

use check::{Instance, check};
use geoint_runtime::prelude::*;

/// One energy per line, with the rule that must find its flow. (Constants with few digits are exact in every scalar.)
macro_rules! instances {
    ($test:ident, $of:ty, ($q:ident $p:ident $s:ident $t:ident): $($System:ident, $rule:literal => $energy:expr;)*) => {
        #[test]
        fn $test() {
            let mut failed = vec![];
            $({
                #[contact_hamiltonian(name = $System)]
                #[allow(unused_variables)]
                fn energy($q: $of, $p: $of, $s: f64, $t: f64) -> f64 {
                    $energy
                }
                let instance = Instance { name: stringify!($System), report: $System::REPORT, rule: $rule };
                failed.extend(check(&instance, $System).err());
            })*
            assert!(failed.is_empty(), "{}", failed.join("\n"));
        }
    };
}

instances! { one_degree_of_freedom, f64, (q p s t):
    // 1–3: a constant, a potential, a kinetic energy.
    Reeb, "drift" => 0.75 + 0.0 * q;
    Potential, "prolongation" => q.sin() + 1.375;
    Parabola, "prolongation" => 0.8125 * q * q;
    ThirdPower, "prolongation" => q.powi(3) - 0.75 * q;
    Driven, "prolongation" => q * q * t.cos() - (0.40625 + 2.25 * t).sin() * q + t * t * q.powi(3);
    Free, "drift" => p * p * 0.6875;
    Relativistic, "drift" => (1.0 + p * p).sqrt();
    Drifting, "drift" => p.powi(4) / 4.0 + 0.3125 * p;
    DrivenDrift, "drift" => p * p * (1.5 + t.sin()) + p * t;
    // 4: damping.
    Decay, "prolongation" => 0.75 * s;
    DecayBySine, "prolongation" => (2.25 * t).sin() * s;
    DecayByCosine, "prolongation" => (0.3125 - 2.25 * t).cos() * s;
    DecayByExponential, "prolongation" => 0.8125 * (-1.375 * t).exp() * s;
    DecayByPower, "prolongation" => (0.40625 + 1.6875 * t * t) * s;
    DecayByRoot, "prolongation" => s * t.sqrt();
    DecayByInverseSquare, "prolongation" => s / (t * t);
    DecayInTime, "prolongation" => 2.0 / t * s;
    DecayInTimeByRoot, "prolongation" => 1.5 * s / t;
    DecayInTimeByPower, "prolongation" => 1.6875 * s / t;
    // 5–6: damping that depends on position.
    Friction, "prolongation" => (q.sin() + 1.375) * s;
    FrictionInTime, "prolongation" => (q.sin() + 1.375) * (2.25 * t).cos() * s;
    FrictionOverTime, "prolongation" => (q.sin() + 1.375) / t * s;
    Affine, "prolongation" => (q.sin() + 1.375) * s + q.powi(3) / 4.0 - q;
    VanDerPol, "prolongation" => -5.0 * (1.0 - q * q) * s + q;
    // 7–8: squares of s.
    SquareOfAction, "prolongation" => 0.75 * s * s;
    Quadratic, "prolongation" => (q.sin() + 1.375) * s * s;
    QuadraticInTime, "prolongation" => (q.sin() + 1.375) * (2.0 * t).sin() * s * s;
    Riccati, "prolongation" => s * s / 2.0 - 1.125;
    Tangent, "prolongation" => s * s / 2.0 + 1.125;
    RiccatiOfPosition, "prolongation" => (1.1875 + q * q) * s * s - q.sin() * s + 0.40625 * q.cos();
    RiccatiOfPositionTurning, "prolongation" => (1.1875 + q * q) * s * s - q.sin() * s - q.cos() - 1.5;
    // 9–10: functions of s.
    Cube, "prolongation" => 0.75 * s.powi(3);
    CubeOfPosition, "prolongation" => (q.sin() + 1.375) * s.powi(3);
    InversePower, "prolongation" => 0.3125 / (1.375 + 0.40625 * s);
    Fourth, "prolongation" => 0.75 * s + 0.40625 * s.powi(4);
    BernoulliOfPosition, "prolongation" => q * s + (0.40625 + q * q) * s.powi(3);
    Exponential, "prolongation" => 0.75 * s.exp();
    ExponentialOfPosition, "prolongation" => q * (0.625 * s).exp() + q * q;
    ExponentialInTime, "prolongation" => t * t * (0.625 * s).exp();
    Arctangent, "prolongation" => 1.0 + s * s;
    SineOfAction, "prolongation" => 1.375 * (0.8125 * s + 0.125).sin();
    CosineOfAction, "prolongation" => 1.375 * (0.8125 * s + 0.125).cos();
    SinhOfAction, "prolongation" => 0.875 * (0.8125 * s + 0.125).sinh();
    TanhOfAction, "prolongation" => 1.375 * (0.8125 * s + 0.125).tanh();
    SechOfAction, "prolongation" => 1.375 / (0.8125 * s + 0.125).cosh();
    ExponentialOfProduct, "prolongation" => 0.375 * (q * s).exp();
    ExponentialOfProductDriven, "prolongation" => 0.375 * (q * s).exp() + q.sin();
    SineOfProduct, "prolongation" => 1.375 * (q * s + 0.25).sin();
    TanhOfProduct, "prolongation" => 1.375 * (q * s + 0.25).tanh();
    PowerOfProduct, "prolongation" => 0.0625 * (1.5 + q * s).powi(4);
    // 11–12: products with functions of s.
    ExponentialTimesPotential, "prolongation" => q.cos() * (0.625 * s).exp();
    SineTimesPotential, "prolongation" => (0.3125 + q * q) * (1.375 * s).sin();
    WeightedByExponential, "weighted drift" => p * p / 2.0 * (0.625 * s).exp();
    WeightedByAction, "weighted drift" => p * p * 0.6875 * (2.0 + s);
    WeightedByRoot, "weighted drift" => p * p * 0.6875 * (2.0 + s).sqrt();
    WeightedByHyperbolicCosine, "weighted drift" => p * p * 0.6875 * (0.8125 * s).cosh();
    // 13: s pᵏ.
    PowerTwo, "weighted drift" => s * p * p / 2.0;
    PowerThree, "weighted power" => 0.75 * s * p.powi(3) * 0.375;
    PowerFour, "weighted power" => t * s * p.powi(4);
    // 14: lifts of q' = X(q).
    Shift, "drift" => 0.75 * p;
    Scale, "prolongation" => p * q;
    SquareLift, "prolongation" => p * q * q;
    CubicLift, "prolongation" => p * (q - q.powi(3));
    RiccatiLift, "prolongation" => p * (q * q - 0.3125 * q + 0.40625);
    SineLift, "prolongation" => p * q.sin();
    SqrtLift, "prolongation" => p * (1.5 + q).sqrt();
    TimedLift, "prolongation" => p * q * q * (1.6875 * t).cos();
    // 15–17: lifts that read s.
    ContactLift, "prolongation" => p * s;
    SquareOfActionLift, "prolongation" => p * s * s;
    TimedContact, "prolongation" => p * s.sin() * t.exp();
    Turning, "prolongation" => p * s + q;
    TurningInto, "prolongation" => 1.375 * p * s + 0.40625 * p * q - 0.75 * q + 0.1875 * s;
    Scaling, "prolongation" => 0.40625 * q * p + 0.875 * s;
    // 18–19: damped drifts.
    Damped, "damped drift" => p * p * 0.6875 + 0.75 * s;
    Driving, "damped drift" => p * p * 0.6875 - 0.75 * s;
    LaneEmden, "damped drift" => p * p / 2.0 + 2.0 / t * s;
    DampedOverTime, "damped drift" => p * p * 0.6875 + 1.6875 * s / t;
    DampedOverTimeByOne, "damped drift" => p * p * 0.6875 + s / t;
    DampedOverTimeByRoot, "damped drift" => p * p * 0.6875 + 0.5 * s / t;
    DampedOverShiftedTime, "damped drift" => p * p * 0.6875 + 1.6875 / (0.75 + t) * s;
    DampedOverScaledTime, "damped drift" => p * p * 0.6875 + 3.0 * s / (0.75 + 2.0 * t);
    DampedBeforeItsEnd, "damped drift" => p * p * 0.6875 + 2.0 / (t - 2.5) * s;
    DampedInSum, "damped drift" => p * p * 0.6875 + (1.25 / (t + 0.5) + 1.75 / (0.5 + t)) * s;
    DecayOverShiftedTime, "prolongation" => 1.6875 * s / (0.75 + t);
    FrictionOverShiftedTime, "prolongation" => (q.sin() + 1.375) / (0.75 + t) * s;
    LaneEmdenThree, "damped drift" => p * p * 0.6875 + 3.0 / t * s;
    LaneEmdenFour, "damped drift" => p * p * 0.6875 + 4.0 * s / t;
    // 20–22: quadratic in (q, p).
    Oscillator, "oscillators" => p * p / 2.0 + 1.6875 * 1.6875 * q * q / 2.0;
    Saddle, "oscillators" => p * p * 0.6875 - 1.1875 * q * q + 0.3125 * q * p;
    DampedOscillator, "oscillators" => p * p / 2.0 + 1.6875 * 1.6875 * q * q / 2.0 + 0.75 * s;
    OverdampedOscillator, "oscillators" => p * p * 0.6875 + q * q * 0.375 + 6.0 * s;
    CriticalOscillator, "oscillators" => p * p / 2.0 + q * q / 2.0 + 2.0 * s;
    Gravity, "uniform field" => p * p / 2.0 + 0.75 * q;
    Throw, "uniform field" => p * p * 0.6875 + 0.3125 * p + 0.75 * q - 0.1875;
    // 23: geodesics.
    Geodesic, "geodesic" => q * q * p * p / 2.0;
    HyperbolicGeodesic, "geodesic" => (1.0 + 0.5 * q) * p * p;
    GeodesicInTime, "geodesic" => -0.75 * t.cos() * q * q * p * p;
    GeodesicThroughZero, "geodesic" => 0.75 * q * p * p;
    GeodesicOfCube, "geodesic" => -0.1875 * q.powi(3) * p * p;
    ShiftedGeodesic, "geodesic" => 0.75 * (q - 0.25) * p * p;
    ShiftedGeodesicOfSquare, "geodesic" => -0.75 * (0.5 * q - 0.25).powi(2) * p * p;
    ShiftedGeodesicInTime, "geodesic" => t.cos() * (0.125 - q) * p * p;
    ConjugateOfShifted, "Legendre conjugate" => (p - 0.5) * q * q;
    CubicGeodesic, "geodesic" => (2.0 + q).powi(4) * p * p / 16.0;
    // 24–25: conjugates.
    ConjugateFriction, "Legendre conjugate" => (p.sin() + 1.375) * (s - p * q);
    ConjugateDecay, "prolongation" => 0.75 * (s - p * q);
    ConjugateSquare, "Legendre conjugate" => 0.75 * (s - p * q).powi(2);
    ConjugateGeodesic, "Legendre conjugate" => (1.0 + 0.5 * p) * q * q;
}

// Strong damping and fast motion.
instances! { stiff, f64, (q p s t):
    StrongDecay, "prolongation" => 200.0 * s;
    StrongFriction, "prolongation" => 150.0 * (1.5 + q.sin()) * s;
    StrongVanDerPol, "prolongation" => -100.0 * (1.0 - q * q) * s + q;
    StrongAffine, "prolongation" => 150.0 * (1.5 + q.sin()) * s + q.cos();
    StrongRiccati, "prolongation" => 0.5 * s * s - 200.0;
    StrongBernoulli, "prolongation" => 25.0 * s - 0.5 * s.powi(3);
    StrongTanh, "prolongation" => 15.0 * (2.0 * s).tanh();
    StrongSine, "prolongation" => 25.0 * (2.0 * s).sin();
    StronglyDamped, "damped drift" => p * p * 0.75 + 200.0 * s;
    FastOscillator, "oscillators" => p * p * 0.75 + 1500.0 * q * q + 0.5 * s;
    StronglyDampedOscillator, "oscillators" => p * p * 0.75 + q * q + 100.0 * s;
}

instances! { two_degrees_of_freedom, [f64; 2], (q p s t):
    Potentials, "prolongation" => (q[0] + 2.0 * q[1]).sin() * q[1];
    Kinetics, "drift" => p[0] * p[0] * 0.6875 + p[1] * p[0] + 0.875 * p[1] * p[1];
    Relativistics, "drift" => (1.0 + p[0] * p[0] + p[1] * p[1]).sqrt();
    Frictions, "prolongation" => (q[0] * q[0] + q[0] * q[1] + 1.0) * s;
    Affines, "prolongation" => (q[0] * q[0] + q[0] * q[1] + 1.0) * s + (q[0] - q[1]).cos();
    Quadratics, "prolongation" => (q[0] * q[1] + 1.0) * s * s - q[0].sin();
    Exponentials, "prolongation" => (q[0] * q[0] + q[0] * q[1] + 1.0) * (0.625 * s).exp();
    Weighted, "weighted drift" => (p[0] * p[0] + p[1] * p[1]) / 2.0 * (0.625 * s).exp();
    WeightedMasses, "weighted drift" => (p[0] * p[0] * 0.6875 + 0.3125 * p[0] * p[1] + 0.875 * p[1] * p[1]) * (2.0 + s);
    Shear, "prolongation" => p[0] * q[1].sin();
    Shears, "prolongation" => p[0] * q[1].sin() + 0.3125 * s * q[1] + q[1] * q[1];
    Rotation, "prolongation" => p[0] * q[1] - p[1] * q[0];
    Heated, "prolongation" => -0.625 * p[0] * q[0] + p[1] * (0.625 * q[0] * q[0] - 0.25 * q[0]);
    Linear, "prolongation" => 0.3125 * p[0] * q[0] + 1.375 * p[0] * q[1] - 0.40625 * p[1] * q[0] - 0.5 * p[1] * q[1];
    LinearWithDecay, "prolongation" => 0.3125 * p[0] * q[0] + 1.375 * p[0] * q[1] + 0.40625 * p[1] * q[0] + 0.5 * s;
    Componentwise, "prolongation" => p[0] * (q[0] - q[0].powi(3)) + p[1] * (q[1] * q[1] - 0.1875);
    ActionLift, "prolongation" => p[0] * s.sin() + p[1] * s * s;
    ActionAndPlace, "prolongation" => p[0] * s * q[0] + 0.75 * p[1] * q[1];
    TurningPlace, "prolongation" => p[0] * s + q[0] + p[1] * q[1];
    PowerOfOne, "weighted power" => 0.375 * s * p[1].powi(3);
    GeodesicOfOne, "geodesic" => 0.75 * q[1] * p[1] * p[1];
    DampedMasses, "damped drift" => p[0] * p[0] * 0.6875 + 0.3125 * p[0] * p[1] + 0.875 * p[1] * p[1] + 0.75 * s;
    MassesOverShiftedTime, "damped drift" => p[0] * p[0] * 0.6875 + 0.3125 * p[0] * p[1] + 0.875 * p[1] * p[1] + 1.6875 / (t + 0.75) * s;
    LaneEmdenMasses, "damped drift" => p[0] * p[0] * 0.6875 + 0.3125 * p[0] * p[1] + 0.875 * p[1] * p[1] + 3.0 / t * s;
    Oscillators, "oscillators" => (p[0] * p[0] + 3.0 * q[0] * q[0]) / 2.0 + p[1] * p[1] * 0.6875 + 0.75 * q[1] * q[1] + 0.75 * s;
    Fields, "uniform field" => p[0] * p[0] * 0.6875 + 0.3125 * p[0] * p[1] + 0.875 * p[1] * p[1] + 0.40625 * q[0] - 0.75 * q[1] + 0.1875 * p[1];
    Conjugates, "Legendre conjugate" => (p[0] * p[0] + p[0] * p[1] + 1.0) * (s - p[0] * q[0] - p[1] * q[1]);
    ConjugateDecays, "prolongation" => 0.75 * (s - p[0] * q[0] - p[1] * q[1]);
}
