//! Pieces whose time dependence cannot be separated. Their flows freeze the time at the middle of the step, so steps have order 2.

use geoint_runtime::Coordinates;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// Declares one energy per line, as one piece.
macro_rules! pieces {
    ($of:ty, $start:expr, ($q:ident $p:ident $t:ident): $($System:ident, $energy:literal => $value:expr;)*) => { $({
        #[hamiltonian(name = $System, split = $energy)]
        fn energy($q: $of, $p: $of, $t: f64) -> f64 {
            $value
        }
        let start = State { t: 0.3, ..$start };
        let flat = |state: &State<$of>| [state.q.into_array().to_vec(), state.p.into_array().to_vec()].concat();
        let mut exact = $System.integrator(Gauss::<4>, 0.8 / 256.0, start);
        exact.advance(256).expect("steps");
        let error = |steps: u64| {
            let mut sim = $System.integrator(PieceSplitting, 0.8 / steps as f64, start);
            sim.advance(steps).expect("steps");
            flat(&sim.state()).iter().zip(flat(&exact.state())).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        let [long, short] = [32, 64].map(error);
        assert!(short < 1e-13 || long / short > 3.6 && short < 1e-2, "{}: {long:e}, {short:e}", stringify!($System));
    })* };
}

#[test]
fn one_degree_of_freedom() {
    pieces! { f64, State::new(0.4, 0.3), (q p t):
        Geodesic, "(2.0 + q + t) * p * p" => (2.0 + q + t) * p * p;
        GeodesicOfRate, "(2.0 + q * t) * p * p" => (2.0 + q * t) * p * p;
        Lift, "p * (q + t).sin()" => p * (q + t).sin();
        Oscillator, "p * p + t * q * q" => p * p + t * q * q;
        Shifted, "p * p + (q - t.sin()).powi(2)" => p * p + (q - t.sin()).powi(2);
        Pushed, "p * p + q * t.exp()" => p * p + q * t.exp();
        Conjugate, "q * (p + t).sin()" => q * (p + t).sin();
        Shear, "(q + t * p).powi(3)" => (q + t * p).powi(3);
        ShearOfForm, "(q + p + t).powi(4)" => (q + p + t).powi(4);
        Monomial, "(1.0 + t) * q.powi(2) * p.powi(3)" => (1.0 + t) * q.powi(2) * p.powi(3);
        Function, "(p * p + t * q * q).powi(2)" => (p * p + t * q * q).powi(2);
        FunctionOfTime, "(1.0 + t + p * p + q * q).sqrt()" => (1.0 + t + p * p + q * q).sqrt();
        Gauge, "(p - t * q * q).powi(2) + q * q" => (p - t * q * q).powi(2) + q * q;
        GaugeOfWave, "(p - (q + t).cos()).powi(4)" => (p - (q + t).cos()).powi(4);
        Wall, "p * p + 1.0 / (q + 1.0 + t).powi(2)" => p * p + 1.0 / (q + 1.0 + t).powi(2);
        WallInTime, "p * p + (1.0 + t) / q.powi(2)" => p * p + (1.0 + t) / q.powi(2);
    }
}

#[test]
fn two_degrees_of_freedom() {
    pieces! { [f64; 2], State::new([0.9, -0.2], [0.1, 0.8]), (q p t):
        Orbit, "p[0] * p[0] + p[1] * p[1] - (1.0 + t) / q[0].hypot(q[1])" =>
            p[0] * p[0] + p[1] * p[1] - (1.0 + t) / q[0].hypot(q[1]);
        MovingCentre, "p[0] * p[0] + p[1] * p[1] - 1.0 / (q[0] + t).hypot(q[1])" =>
            p[0] * p[0] + p[1] * p[1] - 1.0 / (q[0] + t).hypot(q[1]);
        Field, "p[0] * p[0] + (p[1] - t * q[0]).powi(2)" => p[0] * p[0] + (p[1] - t * q[0]).powi(2);
        Sheet, "(p[1] - (q[0] + t).sin()).powi(2)" => (p[1] - (q[0] + t).sin()).powi(2);
        OwnField, "(p[0] - t * q[0] * q[1]).powi(2) + q[1].powi(4)" => (p[0] - t * q[0] * q[1]).powi(2) + q[1].powi(4);
    }
}
