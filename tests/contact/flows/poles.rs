//! Flows that end. A step beyond the end is refused with the name of the piece, and the state does not change.

use super::check::Over;
use super::check::step;
use geoint_runtime::StepError;
use geoint_runtime::prelude::*;

/// An energy with a start, a start time, and the lengths, of either sign, after which its flow ends.
macro_rules! poles {
    ($test:ident, $of:ty, ($q:ident $p:ident $s:ident $t:ident): $($System:ident at ($x:expr, $start:expr) => $energy:expr, ends $ends:expr;)*) => {
        #[test]
        fn $test() {
            $({
                #[contact_hamiltonian(name = $System)]
                #[allow(unused_variables)]
                fn energy($q: $of, $p: $of, $s: f64, $t: f64) -> f64 {
                    $energy
                }
                for end in $ends {
                    ends(stringify!($System), $System, &$x, $start, end);
                }
            })*
        }
    };
}

fn ends<const N: usize, S: Over<f64, N>>(name: &str, system: S, x: &[f64], t: f64, end: f64) {
    let [piece] = S::PIECES else { panic!("{name}: {:?}", S::PIECES) };
    for part in [0.3, 0.9, 1.0 - 1e-7] {
        step(system, x, t, part * end).unwrap_or_else(|error| panic!("{name} before {end}: {error}"));
    }
    for part in [1.0 + 1e-7, 1.01, 1.2, 1.5, 1.99, 2.01, 2.5, 3.1, 4.0, 5.3, 7.7, 23.4, 100.0, 12_345.6] {
        match step(system, x, t, part * end) {
            Err(StepError { failure: Failure::Pole { piece: name }, .. }) => assert_eq!(name, piece.name),
            other => panic!("{name} at {part} of {end}: {other:?}"),
        }
    }
}

use std::f64::consts::PI;

poles! { flows_that_end, f64, (q p s t):
    Square1 at ([0.3, 0.7, 0.8], 0.5) => 0.75 * s * s, ends [-1.0 / 0.6];
    Square2 at ([0.3, 0.7, -0.8], 0.5) => 0.75 * s * s, ends [1.0 / 0.6];
    SquareOfPosition at ([0.3, 0.7, 0.8], 0.5) => (1.5 + q.sin()) * s * s, ends [-1.0 / ((1.5 + 0.3_f64.sin()) * 0.8)];
    SquareInTime at ([0.3, 0.7, -0.8], 0.5) => t * s * s, ends [(0.25 + 2.0 / 0.8_f64).sqrt() - 0.5];
    Tangent at ([0.3, 0.7, 0.8], 0.5) => s * s / 2.0 + 1.125,
        ends [((0.8_f64 / 1.5).atan() + PI / 2.0) / 0.75, ((0.8_f64 / 1.5).atan() - PI / 2.0) / 0.75];
    TangentAtRest at ([0.3, 0.7, 0.0], 0.5) => s * s / 2.0 + 1.125, ends [PI / 1.5, -PI / 1.5];
    Riccati at ([0.3, 0.7, 2.0], 0.5) => s * s / 2.0 - 1.125, ends [-0.75_f64.atanh() / 0.75];
    RiccatiBelow at ([0.3, 0.7, -2.0], 0.5) => s * s / 2.0 - 1.125, ends [0.75_f64.atanh() / 0.75];
    Cube at ([0.3, 0.7, 0.8], 0.5) => 0.75 * s.powi(3), ends [-1.0 / 0.96];
    CubeBelow at ([0.3, 0.7, -0.8], 0.5) => -0.75 * s.powi(3), ends [1.0 / 0.96];
    Fourth at ([0.3, 0.7, 0.8], 0.5) => 0.75 * s + 0.5 * s.powi(4), ends [-(1.0_f64 + 1.5 / 0.512).ln() / 2.25];
    FourthBelow at ([0.3, 0.7, -0.8], 0.5) => -0.75 * s + 0.5 * s.powi(4), ends [-(1.0_f64 + 1.5 / 0.512).ln() / -2.25];
    Exponential at ([0.3, 0.7, 0.8], 0.5) => 0.75 * s.exp(), ends [-1.0 / (0.75 * 0.8_f64.exp())];
    Inverse at ([0.3, 0.7, 0.8], 0.5) => 0.75 / (1.5 + 0.5 * s), ends [1.9_f64.powi(2) / 0.75];
    Sinh at ([0.3, 0.7, 0.8], 0.5) => 0.75 * s.sinh(), ends [0.4_f64.tanh().ln() / 0.75];
    PotentialTimesExponential at ([0.3, 0.7, 0.8], 0.5) => (1.0 + q * q) * (0.5 * s).exp(), ends [-2.0 * (-0.4_f64).exp() / 1.09];
    SquareLift at ([0.8, 0.7, 0.3], 0.5) => p * q * q, ends [1.0 / 0.8];
    SquareLiftBelow at ([-0.8, 0.7, 0.3], 0.5) => p * q * q, ends [-1.0 / 0.8];
    CubicLift at ([1.5, 0.7, 0.3], 0.5) => p * (q - q.powi(3)), ends [(1.0_f64 - 1.0 / 2.25).ln() / 2.0];
    TangentLift at ([0.8, 0.7, 0.3], 0.5) => p * (1.0 + q * q), ends [PI / 2.0 - 0.8_f64.atan(), -PI / 2.0 - 0.8_f64.atan()];
    RootLift at ([0.8, 0.7, 0.3], 0.5) => p * (1.5 + q).sqrt(), ends [-2.0 * 2.3_f64.sqrt()];
    Contact1 at ([0.3, 0.7, 0.8], 0.5) => p * s, ends [-1.0 / 0.7];
    Contact2 at ([0.3, -0.7, 0.8], 0.5) => p * s, ends [1.0 / 0.7];
    SquareOfActionLift at ([0.3, 0.7, 0.8], 0.5) => p * s * s, ends [-1.0 / 1.12];
    Turning at ([0.3, 0.7, 0.8], 0.5) => p * s + q, ends [PI - (1.0_f64 / 0.7).atan(), -(1.0_f64 / 0.7).atan()];
    TurningAtRest at ([0.3, 0.0, 0.8], 0.5) => p * s + q, ends [PI / 2.0, -PI / 2.0];
    PowerTwo at ([0.3, 0.7, 0.8], 0.5) => s * p * p / 2.0, ends [-1.0 / 0.49];
    PowerThree at ([0.3, 0.7, 0.8], 0.5) => 0.25 * s * p.powi(3), ends [-1.0 / (0.75 * 0.343)];
    PowerThreeBelow at ([0.3, -0.7, 0.8], 0.5) => 0.25 * s * p.powi(3), ends [1.0 / (0.75 * 0.343)];
    WeightedByExponential at ([0.3, 0.7, 0.8], 0.5) => p * p / 2.0 * (0.5 * s).exp(), ends [-2.0 / (0.245 * 0.4_f64.exp())];
    WeightedByAction at ([0.3, 0.7, 0.8], 0.5) => p * p / 2.0 * (2.0 + s), ends [-1.0 / 0.49];
    Geodesic at ([0.3, 0.7, 0.8], 0.5) => (1.0 + 0.5 * q) * p * p, ends [-2.0 / 0.7];
    ConjugateSquare at ([0.3, 0.7, 0.8], 0.5) => 0.75 * (s - p * q).powi(2), ends [-1.0 / (0.75 * (0.8 - 0.21))];
    LaneEmden at ([0.3, 0.7, 0.8], 0.5) => p * p * 0.75 + 2.0 / t * s, ends [-0.5];
    LaneEmdenBefore at ([0.3, 0.7, 0.8], -0.5) => p * p * 0.75 + 3.0 / t * s, ends [0.5];
    DampedByOne at ([0.3, 0.7, 0.8], 0.5) => p * p * 0.75 + s / t, ends [-0.5];
    DampedByPowerBefore at ([0.3, 0.7, 0.8], -0.5) => p * p * 0.75 + 1.7 / t * s, ends [0.5];
    DampedOverShiftedTime at ([0.3, 0.7, 0.8], 0.5) => p * p * 0.75 + 2.0 / (0.75 + t) * s, ends [-1.25];
    DampedOverShiftedTimeByPower at ([0.3, 0.7, 0.8], 0.5) => p * p * 0.75 + 1.7 / (t - 0.75) * s, ends [0.25];
    DecayOverShiftedTime at ([0.3, 0.7, 0.8], 0.5) => 2.0 / (0.75 + 2.0 * t) * s, ends [-0.875];
    Decay at ([0.3, 0.7, 0.8], 0.5) => 2.0 / t * s, ends [-0.5];
    DecayBefore at ([0.3, 0.7, 0.8], -0.5) => 2.0 / t * s, ends [0.5];
    DecayByPower at ([0.3, 0.7, 0.8], 0.5) => 1.7 / t * s, ends [-0.5];
    DecayByPowerBefore at ([0.3, 0.7, 0.8], -0.5) => 1.7 / t * s, ends [0.5];
    DecayInSquare at ([0.3, 0.7, 0.8], 0.5) => (0.75 - 1.0 / (t * t)) * s, ends [-0.5];
    DecayInSquareBefore at ([0.3, 0.7, 0.8], -0.5) => (0.75 + 1.0 / (t * t)) * s, ends [0.5];
}

poles! { flows_in_the_plane_that_end, [f64; 2], (q p s t):
    ActionLift at ([0.3, 0.4, 0.7, -0.6, 0.8], 0.5) => p[0] * s.sin() + p[1] * s * s,
        ends [-1.0 / (0.7 * 0.8_f64.cos() - 0.96)];
    ActionAndPlace at ([0.3, 0.4, 0.7, -0.6, 0.8], 0.5) => p[0] * s + 0.7 * p[1] * q[1], ends [-1.0 / 0.7];
    WeightedPlane at ([0.3, 0.4, 0.7, -0.6, 0.8], 0.5) => s * (p[0] * p[0] + p[1] * p[1]) / 2.0, ends [-1.0 / 0.85];
    ConjugatePlane at ([0.3, 0.4, 0.7, -0.6, 0.8], 0.5) => (s - p[0] * q[0] - p[1] * q[1]).powi(2), ends [-1.0 / 0.83];
}

/// A flow may begin at a singular time, but not end there.
#[test]
fn singular_times() {
    #[contact_hamiltonian]
    fn lane_emden(q: f64, p: f64, s: f64, t: f64) -> f64 {
        p * p * 0.75 + 2.0 / t * s + 0.0 * q
    }
    #[contact_hamiltonian]
    fn decay(q: f64, p: f64, s: f64, t: f64, k: f64) -> f64 {
        k * s / t + 0.0 * p * q
    }
    #[contact_hamiltonian]
    fn emden_fowler(q: f64, p: f64, s: f64, t: f64, k: f64, since: f64) -> f64 {
        p * p * 0.75 + k / (since + t) * s + 0.0 * q
    }
    let x = [0.3, 0.7, 0.8];
    for k in [0.01, 0.5, 1.0, 2.0, 3.7] {
        // A step may start at the singular time, for any power of time. A step across the singular time, or onto it, is refused.
        let system = EmdenFowler { k, since: 0.25 };
        assert_eq!(step(system, &x, -0.25, 0.1).unwrap(), [0.3, 0.0, 0.0]);
        assert!(matches!(step(system, &x, -0.5, 0.5), Err(StepError { failure: Failure::Pole { .. }, .. })));
        assert!(matches!(step(system, &x, 0.25, -0.5), Err(StepError { failure: Failure::Pole { .. }, .. })));
        assert!(matches!(step(system, &x, 0.25, -0.75), Err(StepError { failure: Failure::Pole { .. }, .. })));
        assert!(step(system, &x, -0.5, 0.2).is_ok() && step(system, &x, 0.25, -0.4).is_ok());
    }
    assert_eq!(step(LaneEmden, &x, 0.0, 0.1).unwrap(), [0.3, 0.0, 0.0]);
    assert_eq!(step(Decay { k: 1.7 }, &x, 0.0, 0.1).unwrap(), [0.3, 0.0, 0.0]);
    for h in [0.5, -0.5] {
        assert!(matches!(step(LaneEmden, &x, -h, h), Err(StepError { failure: Failure::Pole { .. }, .. })));
        assert!(matches!(step(Decay { k: 1.7 }, &x, -h, h), Err(StepError { failure: Failure::Pole { .. }, .. })));
    }
    // On either side.
    assert!(step(LaneEmden, &x, -0.5, 0.4).is_ok() && step(LaneEmden, &x, -0.1, -0.4).is_ok());
}
