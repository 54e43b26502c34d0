//! Energies whose flows are not exact in time. Time is frozen in the middle of the step, so the order is kept. No step passes a pole in time.

use crate::measure::{run, solution};
use geoint_runtime::prelude::*;
use geoint_runtime::system::{Clock, Pieces};
use geoint_runtime::{Contact, StepError};
use geoint_tests::measure::distance;
use geoint_tests::scalars::Double;

/// An energy a line.
macro_rules! second_order {
    ($test:ident, $of:ty, $x:expr, ($q:ident $p:ident $s:ident $t:ident): $($System:ident => $energy:expr;)*) => {
        #[test]
        fn $test() {
            $({
                #[contact_hamiltonian(name = $System)]
                #[allow(unused_variables)]
                fn energy($q: $of, $p: $of, $s: f64, $t: f64) -> f64 {
                    $energy
                }
                assert_eq!(<$System as Pieces<ContactSplitting>>::PIECES[0].clock, Clock::Stage, "{}", stringify!($System));
                let truth: Vec<f64> = solution(&$System, 0.5, &$x, 0.4, 40).into_iter().map(Double::value).collect();
                let error = |n: u64| {
                    let end = run($System, ContactSplitting, (0.5, &$x[..]), 0.4 / n as f64, n).unwrap();
                    distance(&end, &truth)
                };
                let order = (error(16) / error(32)).log2();
                assert!((order - 2.0).abs() < 0.1, "{}: {order}", stringify!($System));
            })*
        }
    };
}

second_order! { one_degree_of_freedom, f64, [0.5, 0.4, 0.3], (q p s t):
    Exponential => (s * t).exp() + 0.0 * q;
    ExponentialOfDifference => (s - t).exp() + 0.25;
    Sine => 0.75 * (s - t).sin();
    HyperbolicTangent => (s + t).tanh();
    LiftedSine => p * (q - t).sin();
}

second_order! { two_degrees_of_freedom, [f64; 2], [0.5, 0.3, 0.4, -0.2, 0.3], (q p s t):
    Masses => 0.6875 * p[0] * p[0] * s.exp() + t * t * p[1] * p[1] * s.exp();
}

/// Asserts that no step passes a pole in time. Each kind of term has a pole at t = 1, and one term has another pole at t = 1 + π.
macro_rules! not_passed {
    (($q:ident $p:ident $s:ident $t:ident): $($System:ident => $energy:expr;)*) => {
        #[test]
        fn poles_in_time_are_not_passed() {
            $({
                #[contact_hamiltonian(name = $System)]
                fn energy($q: f64, $p: f64, $s: f64, $t: f64) -> f64 {
                    $energy
                }
                for h in [0.0731, 0.31, 0.125] {
                    for steps in [1, 20] {
                        stops(stringify!($System), $System, ContactSplitting, h, steps);
                        stops(stringify!($System), $System, Suzuki4.of(ContactSplitting), h, steps);
                    }
                }
            })*
        }
    };
}

fn stops<S, M>(name: &str, system: S, method: M, h: f64, steps: u64)
where
    S: Pieces<ContactSplitting> + Contact<Coordinates = f64>,
    M: Method<S, f64>,
{
    let mut sim = Integrator::new(system, method, h, ContactState::at(0.0, 0.3, 0.2, 0.1));
    let outcome = (0..80 / steps).try_for_each(|_| sim.advance(steps));
    let refused = matches!(outcome, Err(StepError::OutsideDomain { .. } | StepError::Pole { .. }));
    assert!(refused, "{name}, h = {h}: {outcome:?}");
    assert!((1.0 - h..=1.0).contains(&sim.time()), "{name}, h = {h}: {outcome:?}");
}

not_passed! { (q p s t):
    Friction => p * p / 2.0 + q * q + 2.0 * s / (t - 1.0);
    FrictionBySquare => p * p / 2.0 + q * q + s / (t - 1.0).powi(2);
    FrictionBySine => p * p / 2.0 + q * q + s / (t - 1.0).sin();
    Force => p * p / 2.0 + q * q / (1.0 - t) + s;
    Mass => p * p / (t - 1.0) + q * q + s;
}
