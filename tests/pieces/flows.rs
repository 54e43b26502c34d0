//! Compares the flow of every family of pieces, for energies without an action, with the differential equation solved to 20 digits and more.

use crate::check::{Instance, check};
use geoint_runtime::prelude::*;

/// Declares one energy per line, with the rule that must find its flow. A split is given if the compiler would otherwise not keep the energy as one piece.
macro_rules! instances {
    ($test:ident, $of:ty, ($q:ident $p:ident $t:ident): $($System:ident, $rule:literal $(, $split:literal)? => $energy:expr;)*) => {
        #[test]
        fn $test() {
            let mut failed = vec![];
            $({
                #[hamiltonian(name = $System $(, split = $split)?)]
                #[allow(unused_variables)]
                fn energy($q: $of, $p: $of, $t: f64) -> f64 {
                    $energy
                }
                let instance = Instance { name: stringify!($System), report: $System::REPORT, rule: $rule };
                failed.extend(check(&instance, $System).err());
            })*
            assert!(failed.is_empty(), "{}", failed.join("\n"));
        }
    };
}

instances! { one_degree_of_freedom, f64, (q p t):
    Kick, "kick", "q.sin() * (1.5 + t.cos())" => q.sin() * (1.5 + t.cos());
    Drift, "drift", "(1.0 + p * p).sqrt()" => (1.0 + p * p).sqrt();
    Oscillator, "oscillators", "p * p * 0.6875 + 1.1875 * q * q" => p * p * 0.6875 + 1.1875 * q * q;
    Mixed, "oscillators", "p * p * 0.6875 + 1.1875 * q * q + 0.3125 * q * p" => p * p * 0.6875 + 1.1875 * q * q + 0.3125 * q * p;
    Shifted, "coupled oscillators", "p * p * 0.6875 + 1.1875 * q * q + 0.3125 * q * p + 0.75 * q - 0.5 * p" =>
        p * p * 0.6875 + 1.1875 * q * q + 0.3125 * q * p + 0.75 * q - 0.5 * p;
    ShiftedSaddle, "coupled oscillators", "p * p * 0.6875 - 1.1875 * q * q + 0.75 * q - 0.5 * p" =>
        p * p * 0.6875 - 1.1875 * q * q + 0.75 * q - 0.5 * p;
    Parabolic, "coupled oscillators", "(p + 0.5 * q).powi(2) / 2.0 + 0.25 * q" => (p + 0.5 * q).powi(2) / 2.0 + 0.25 * q;
    Field, "uniform field", "p * p / 2.0 + 0.75 * q" => p * p / 2.0 + 0.75 * q;
    Lift, "prolongation" => p * q.sin();
    Geodesic, "geodesic" => (1.0 + 0.5 * q) * p * p;
    GeodesicBehind, "geodesic" => (0.25 - q) * p * p;
    Conjugate, "Legendre conjugate" => p.sin() * q;
    Shear, "forms in involution" => (q + p).powi(4) / 8.0;
    ShearOfSine, "forms in involution" => (0.75 * q - 1.25 * p).sin();
    ShearInTime, "forms in involution" => (q + p).powi(3) * (1.5 * t).cos();
    ShearOfTwoPowers, "forms in involution" => (q - 2.0 * p).powi(3) / 4.0 + (q - 2.0 * p).powi(2);
    Monomial, "geodesic" => q * q * p * p / 2.0;
    MonomialOfThird, "Legendre conjugate" => 0.25 * q.powi(2) * p.powi(3);
    MonomialOfFourth, "monomial" => 0.25 * q.powi(4) * p.powi(3);
    MonomialEqual, "monomial" => -0.5 * q.powi(3) * p.powi(3);
    MonomialInTime, "monomial" => 0.25 * q.powi(3) * p.powi(3) * t;
    SquareOfOscillator, "function of a piece" => (p * p + q * q).powi(2) / 4.0;
    RootOfOscillator, "function of a piece" => (1.0 + p * p + 2.0 * q * q).sqrt();
    SineOfProduct, "function of a piece" => (q * p).sin();
    // A momentum shifted by a function of its own position.
    OwnShift, "function of a piece" => (p - q * q).powi(2) / 2.0;
    OwnShiftWithSpring, "change of gauge", "(p - 0.5 * q.powi(3)).powi(2) * 0.6875 + 1.1875 * q * q" =>
        (p - 0.5 * q.powi(3)).powi(2) * 0.6875 + 1.1875 * q * q;
    OwnShiftOfAWave, "change of gauge" => (1.0 + (p - q.cos()).powi(2)).sqrt();
    OwnShiftOfAPower, "change of gauge" => (2.0 * p - q.exp()).powi(4) / 64.0;
}

instances! { two_degrees_of_freedom, [f64; 2], (q p t):
    // Magnetic fields: uniform in two gauges, with a trap, with an electric field, with a free direction.
    Symmetric, "coupled oscillators" => (p[0] + 0.75 * q[1]).powi(2) / 2.0 + (p[1] - 0.75 * q[0]).powi(2) / 2.0;
    Landau, "coupled oscillators" => (p[0] * p[0] + (p[1] - 1.25 * q[0]).powi(2)) / 2.0;
    Trap, "coupled oscillators" => (p[0] * p[0] + (p[1] - 1.25 * q[0]).powi(2) + 0.5 * q[0] * q[0] - q[1] * q[1]) / 2.0;
    CrossedFields, "coupled oscillators", "(p[0] * p[0] + (p[1] - 1.25 * q[0]).powi(2)) / 2.0 + 0.5 * q[0] - 0.25 * p[1]" =>
        (p[0] * p[0] + (p[1] - 1.25 * q[0]).powi(2)) / 2.0 + 0.5 * q[0] - 0.25 * p[1];
    Rotating, "coupled oscillators" => (p[0] * p[0] + p[1] * p[1]) / 2.0 + 0.75 * (q[1] * p[0] - q[0] * p[1]) + q[0] * q[0];
    Springs, "coupled oscillators", "(p[0] * p[0] + 2.0 * p[1] * p[1]) / 2.0 + q[0] * q[0] - 0.75 * q[0] * q[1] + 0.5 * q[1] * q[1]" =>
        (p[0] * p[0] + 2.0 * p[1] * p[1]) / 2.0 + q[0] * q[0] - 0.75 * q[0] * q[1] + 0.5 * q[1] * q[1];
    // Equal, complex and widely separated eigenvalues. (Over an angle of 3 in a step the error is 7 ε, because the condition does not count the
    // coefficients.)
    Equal, "coupled oscillators" => (p[0] * p[0] + p[1] * p[1] + q[0] * q[0] + q[1] * q[1]) / 2.0 + 0.5 * q[0] * p[1];
    Focus, "coupled oscillators" => q[0] * p[1] - q[1] * p[0] + 0.5 * (q[0] * p[0] + q[1] * p[1]) + 0.25 * p[0] * p[0];
    Apart, "coupled oscillators" => (p[0] + 2.0 * q[1]).powi(2) / 2.0 + (p[1] - 2.0 * q[0]).powi(2) / 2.0 + 0.0625 * q[0] * q[0];
    // Nonuniform fields, direction by direction.
    Sheet, "forms in involution" => (p[1] - (q[0] + 0.25 * q[0] * q[0])).powi(2) / 2.0;
    SheetWithPotential, "forms in involution" => (p[1] - q[0].sin()).powi(2) / 2.0 + q[0].cos();
    Relativistic, "forms in involution" => (1.0 + (p[1] - q[0].sin()).powi(2)).sqrt();
    SheetInTime, "forms in involution" => (p[1] - q[0] * q[0]).powi(2) * (1.0 + 0.5 * t);
    PositionAndOtherMomentum, "forms in involution" => q[0].sin() * p[1].cos();
    TwoForms, "forms in involution" => ((q[0] + p[1]) * (q[1] + p[0])).sin();
    Waves, "forms in involution" => (2.0 * q[0] - p[1] + 0.5 * q[1]).cos();
    MonomialOfTwo, "monomial" => 0.5 * q[0].powi(2) * p[0].powi(3) * q[1];
    MonomialOfTwoPairs, "monomial" => 0.25 * q[0].powi(2) * p[0].powi(1) * q[1] * p[1].powi(2);
    // Fields whose components depend on their own coordinate, with other dependences and gradients.
    OwnField, "change of gauge", "(p[0] - 0.75 * q[0] * q[1]).powi(2) / 3.0 + q[1].powi(4)" =>
        (p[0] - 0.75 * q[0] * q[1]).powi(2) / 3.0 + q[1].powi(4);
    OwnFieldOfWaves, "change of gauge", "(p[0] - 0.75 * (2.0 * q[0]).sin() * q[1].cos()).powi(2) / 3.0 + q[1].powi(3)" =>
        (p[0] - 0.75 * (2.0 * q[0]).sin() * q[1].cos()).powi(2) / 3.0 + q[1].powi(3);
    OwnFieldOfBoth, "change of gauge", "(p[0] - q[0] * q[1] * q[1]).powi(2) / 2.0 + (p[1] - q[0] * q[0] * q[1] - q[1].powi(3)).powi(2) / 3.0" =>
        (p[0] - q[0] * q[1] * q[1]).powi(2) / 2.0 + (p[1] - q[0] * q[0] * q[1] - q[1].powi(3)).powi(2) / 3.0;
    OwnFieldUniform, "change of gauge", "(p[0] - 0.5 * q[0] * q[0] + 0.75 * q[1]).powi(2) / 2.0 + (p[1] - 0.75 * q[0]).powi(2) / 3.0" =>
        (p[0] - 0.5 * q[0] * q[0] + 0.75 * q[1]).powi(2) / 2.0 + (p[1] - 0.75 * q[0]).powi(2) / 3.0;
    Independent, "independent parts", "q[0].powi(4) * p[0].powi(3) / 4.0 + (1.0 + p[1] * p[1] + 2.0 * q[1] * q[1]).sqrt()" =>
        q[0].powi(4) * p[0].powi(3) / 4.0 + (1.0 + p[1] * p[1] + 2.0 * q[1] * q[1]).sqrt();
    OscillatorBesideMonomial, "independent parts", "(p[0] * p[0] + 2.0 * q[0] * q[0]) / 2.0 + q[1].powi(4) * p[1].powi(3) * t / 4.0" =>
        (p[0] * p[0] + 2.0 * q[0] * q[0]) / 2.0 + q[1].powi(4) * p[1].powi(3) * t / 4.0;
    SquareOfSpin, "function of a piece" => (q[0] * p[1] - q[1] * p[0]).powi(2) / 2.0;
    SquareOfLandau, "function of a piece" => (1.0 + p[0] * p[0] + (p[1] - 0.5 * q[0]).powi(2)).sqrt();
}

instances! { three_degrees_of_freedom, [f64; 3], (q p t):
    // More than two coupled degrees of freedom: by springs, in a field, with forces, with a free direction, unstable, and with time.
    Chain, "coupled oscillators", "(p[0] * p[0] + 2.0 * p[1] * p[1] + p[2] * p[2]) / 2.0 + (q[1] - q[0]).powi(2) + 0.75 * (q[2] - q[1]).powi(2)" =>
        (p[0] * p[0] + 2.0 * p[1] * p[1] + p[2] * p[2]) / 2.0 + (q[1] - q[0]).powi(2) + 0.75 * (q[2] - q[1]).powi(2);
    ChainInField, "coupled oscillators", "(p[0] * p[0] + (p[1] - 1.25 * q[0]).powi(2) + (p[2] + 0.5 * q[1]).powi(2)) / 2.0 + 0.5 * q[0] * q[2] - 0.75 * q[1] + 0.25 * p[2]" =>
        (p[0] * p[0] + (p[1] - 1.25 * q[0]).powi(2) + (p[2] + 0.5 * q[1]).powi(2)) / 2.0 + 0.5 * q[0] * q[2] - 0.75 * q[1] + 0.25 * p[2];
    Ridge, "coupled oscillators" => p[0] * p[1] - q[1] * q[2] + 0.5 * p[2] * p[2] - q[0] * q[0] + 0.5 * p[0] * q[2];
    Ramp, "coupled oscillators" => t * (p[0] * q[1] - p[1] * q[0] + 0.5 * p[1] * q[2] + p[2] * p[2] / 2.0);
    GeodesicBesideField, "independent parts" =>
        (2.0 - q[1]) * p[1] * p[1] + ((p[0] + 0.75 * q[2]).powi(2) + (p[2] - 0.75 * q[0]).powi(2)) / 2.0;
    SquareOfChain, "function of a piece" =>
        (1.0 + (p[0] + 0.5 * q[1]).powi(2) + (p[1] + 0.5 * q[2]).powi(2) + (p[2] - 0.5 * q[0]).powi(2)).sqrt();
}

// Motion about a centre. Walls 1/y² of one coordinate: with an oscillator, unstable, attractive. Walls of a vector, of two bodies, and of two forms with
// different metrics. Kepler's motion.
instances! { one_centre, f64, (q p t):
    Wall, "inverse square", "p * p * 0.6875 + 0.4375 / (q + 1.5).powi(2)" => p * p * 0.6875 + 0.4375 / (q + 1.5).powi(2);
    WallBehind, "inverse square", "p * p * 0.6875 + 0.4375 / (1.0 - 0.5 * q).powi(2)" => p * p * 0.6875 + 0.4375 / (1.0 - 0.5 * q).powi(2);
    WallAndSpring, "inverse square", "p * p * 0.6875 + 0.4375 / (q + 1.5).powi(2) + 0.375 * (q + 1.5).powi(2)" =>
        p * p * 0.6875 + 0.4375 / (q + 1.5).powi(2) + 0.375 * (q + 1.5).powi(2);
    WallAndHill, "inverse square", "p * p * 0.6875 + 0.4375 / (q + 1.5).powi(2) - 0.375 * (q + 1.5).powi(2)" =>
        p * p * 0.6875 + 0.4375 / (q + 1.5).powi(2) - 0.375 * (q + 1.5).powi(2);
    Well, "inverse square", "p * p * 0.6875 - 0.0625 / (q + 1.5).powi(2)" => p * p * 0.6875 - 0.0625 / (q + 1.5).powi(2);
}

instances! { centres_in_the_plane, [f64; 2], (q p t):
    Radial, "inverse square", "(p[0] * p[0] + p[1] * p[1]) / 3.0 + 0.4375 / ((q[0] + 1.5).powi(2) + q[1] * q[1])" =>
        (p[0] * p[0] + p[1] * p[1]) / 3.0 + 0.4375 / ((q[0] + 1.5).powi(2) + q[1] * q[1]);
    RadialWell, "inverse square", "(p[0] * p[0] + p[1] * p[1]) / 3.0 - 0.1875 / ((q[0] + 1.5).powi(2) + q[1] * q[1])" =>
        (p[0] * p[0] + p[1] * p[1]) / 3.0 - 0.1875 / ((q[0] + 1.5).powi(2) + q[1] * q[1]);
    Turning, "inverse square", "(p[0] * p[0] + p[1] * p[1]) / 3.0 + 0.4375 / ((q[0] + 1.5).powi(2) + q[1] * q[1]) + 0.75 * ((q[0] + 1.5).powi(2) + q[1] * q[1])" =>
        (p[0] * p[0] + p[1] * p[1]) / 3.0 + 0.4375 / ((q[0] + 1.5).powi(2) + q[1] * q[1]) + 0.75 * ((q[0] + 1.5).powi(2) + q[1] * q[1]);
    TwoOnALine, "inverse square", "p[0] * p[0] / 3.0 + p[1] * p[1] / 5.0 + 0.75 / (q[0] - q[1] + 2.0).powi(2)" =>
        p[0] * p[0] / 3.0 + p[1] * p[1] / 5.0 + 0.75 / (q[0] - q[1] + 2.0).powi(2);
    TwoWalls, "inverse square", "p[0] * p[0] / 3.0 + p[1] * p[1] / 5.0 + 0.75 / (q[0] + 2.0).powi(2) + 0.25 / (q[1] - 1.5).powi(2) + 0.125 * (q[1] - 1.5).powi(2)" =>
        p[0] * p[0] / 3.0 + p[1] * p[1] / 5.0 + 0.75 / (q[0] + 2.0).powi(2) + 0.25 / (q[1] - 1.5).powi(2) + 0.125 * (q[1] - 1.5).powi(2);
    Ellipses, "inverse square", "p[0] * p[0] / 3.0 + p[1] * p[1] / 6.0 + 0.75 / ((q[0] + 1.5).powi(2) + 2.0 * q[1] * q[1])" =>
        p[0] * p[0] / 3.0 + p[1] * p[1] / 6.0 + 0.75 / ((q[0] + 1.5).powi(2) + 2.0 * q[1] * q[1]);
    Orbit, "Kepler motion", "(p[0] * p[0] + p[1] * p[1]) / 3.0 - 0.75 / ((q[0] + 1.5).powi(2) + q[1] * q[1]).sqrt()" =>
        (p[0] * p[0] + p[1] * p[1]) / 3.0 - 0.75 / ((q[0] + 1.5).powi(2) + q[1] * q[1]).sqrt();
    Scattered, "Kepler motion", "(p[0] * p[0] + p[1] * p[1]) / 3.0 + 0.75 / (q[0] + 1.5).hypot(q[1])" =>
        (p[0] * p[0] + p[1] * p[1]) / 3.0 + 0.75 / (q[0] + 1.5).hypot(q[1]);
}

instances! { centres_in_space, [f64; 3], (q p t):
    RadialInSpace, "inverse square", "(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 3.0 + 0.25 / ((q[0] + 1.5).powi(2) + q[1] * q[1] + q[2] * q[2])" =>
        (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 3.0 + 0.25 / ((q[0] + 1.5).powi(2) + q[1] * q[1] + q[2] * q[2]);
    OrbitInSpace, "Kepler motion", "(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 3.0 - 0.75 / ((q[0] + 1.5).powi(2) + q[1] * q[1] + (q[2] - 0.5).powi(2)).sqrt()" =>
        (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 3.0 - 0.75 / ((q[0] + 1.5).powi(2) + q[1] * q[1] + (q[2] - 0.5).powi(2)).sqrt();
    OrbitBeside, "Kepler motion", "(p[0] * p[0] + p[1] * p[1]) / 3.0 + p[2] * p[2] - 0.75 / ((q[0] + 1.5).powi(2) + q[1] * q[1]).sqrt()" =>
        (p[0] * p[0] + p[1] * p[1]) / 3.0 + p[2] * p[2] - 0.75 / ((q[0] + 1.5).powi(2) + q[1] * q[1]).sqrt();
}
