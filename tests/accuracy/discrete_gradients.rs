//! Methods that keep the energy, against figures of another program.
//!
//! That program is written in another language, forms its discrete gradients from quotients of H in long arithmetic, and takes its
//! references from an explicit solver of order 8 at a relative tolerance of 10⁻¹³.

use geoint_runtime::Method;
use geoint_runtime::prelude::*;
use geoint_tests::measure::{distance, solution};
use geoint_tests::problems::{HenonHeiles, flat};
use geoint_tests::scalars::Double;

const SYSTEM: HenonHeiles = HenonHeiles { m: [1.0, 1.0], lambda: 1.0 };

/// Errors at `time` from `start`, a step size each.
fn errors<M: Method<HenonHeiles>, const N: usize>(
    method: M,
    start: State<[f64; 2]>,
    time: f64,
    steps: [f64; N],
) -> [f64; N] {
    let lifted = HenonHeiles { m: [1.0, 1.0].map(Double::from), lambda: 1.0.into() };
    let from = State::new(start.q.map(Double::from), start.p.map(Double::from));
    let exact: Vec<f64> = solution(&lifted, &from, time.into(), 20).iter().map(|x| x.value()).collect();
    steps.map(|h| {
        let mut sim = SYSTEM.integrator(method, h, start);
        distance(&flat(&sim.until(time).last().unwrap().unwrap()), &exact)
    })
}

fn near(name: &str, observed: &[f64], expected: &[f64]) {
    println!("{name:36} {observed:?} expected {expected:?}");
    for (o, e) in observed.iter().zip(expected) {
        assert!((o / e - 1.0).abs() < 0.05, "{name}: {observed:?}, expected {expected:?}");
    }
}

macro_rules! rows {
    ($start:expr, $time:expr, $steps:expr; $($method:expr => $expected:expr;)*) => { $({
        let observed = errors($method, $start, $time, $steps);
        near(stringify!($method), &observed, &$expected);
    })* };
}

#[test]
fn errors_of_another_program_after_a_short_time() {
    rows! { State::new([0.1, -0.2], [0.3, 0.25]), 2.0, [0.2, 0.1, 0.05];
        ItohAbe => [2.836e-2, 1.334e-2, 6.457e-3];
        ItohAbePair => [1.206e-3, 3.018e-4, 7.546e-5];
        SymmetrisedItohAbe => [4.747e-3, 1.194e-3, 2.990e-4];
        Gonzalez => [4.793e-3, 1.207e-3, 3.022e-4];
        MeanValue::<2> => [4.778e-3, 1.203e-3, 3.012e-4];
        FourthOrder(MeanValue::<2>) => [3.501e-5, 2.208e-6, 1.383e-7];
        FourthOrder(SymmetrisedItohAbe) => [3.421e-5, 2.158e-6, 1.352e-7];
        FourthOrder(Gonzalez) => [3.463e-5, 2.184e-6, 1.368e-7];
        Yoshida4.of(Gonzalez) => [2.638e-4, 1.731e-5, 1.095e-6];
        Suzuki4.of(Gonzalez) => [3.582e-6, 2.253e-7, 1.410e-8];
    }
}

#[test]
fn errors_of_another_program_after_a_longer_time() {
    rows! { State::new([0.1, 0.0], [0.0, 0.5]), 10.0, [0.1, 0.05];
        ItohAbe => [3.306e-3, 2.036e-3];
        ItohAbePair => [7.780e-4, 1.949e-4];
        SymmetrisedItohAbe => [2.650e-3, 6.676e-4];
        MeanValue::<2> => [2.670e-3, 6.727e-4];
        FourthOrder(MeanValue::<2>) => [5.534e-6, 3.468e-7];
    }
}
