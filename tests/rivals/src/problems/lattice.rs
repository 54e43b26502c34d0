//! A chain of many masses.

use super::{AT_THE_END, Problem, Way, adaptive, by_hand, ours, reference, taylor};
use crate::by_hand::Stages;
use crate::by_hand::chain as hand;
use crate::field::Field;
use crate::rivals::{Seen, of_field, of_separable};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::scalars::Scalar;
use std::hint::black_box;

const N: usize = 64;
const ALPHA: f64 = 0.25;

/// 64 masses between walls on springs that are not quite linear.
#[hamiltonian(const N = 64)]
fn chain(q: [f64; N], p: [f64; N], alpha: f64) -> f64 {
    let spring = |d: f64| d * d / 2.0 + alpha * d * d * d / 3.0;
    let mut energy = spring(q[0]) + spring(-q[N - 1]);
    for i in 0..N {
        energy += p[i] * p[i] / 2.0;
    }
    for i in 1..N {
        energy += spring(q[i] - q[i - 1]);
    }
    energy
}

#[derive(Clone, Copy)]
struct Springs;

impl Field<128> for Springs {
    /// The first mode.
    fn start(&self) -> [f64; 128] {
        let mode = |i: usize| (std::f64::consts::PI * (i + 1) as f64 / (N + 1) as f64).sin();
        std::array::from_fn(|i| if i < N { mode(i) } else { 0.0 })
    }
    fn rate<R: Scalar>(_: R, y: &[R; 128], dy: &mut [R; 128]) {
        let pull = |d: R| d + R::from_f64(ALPHA) * d * d;
        let mut before = pull(y[0]);
        for i in 0..N {
            let after = pull(if i + 1 < N { y[i + 1] - y[i] } else { -y[i] });
            dy[i] = y[N + i];
            dy[N + i] = after - before;
            before = after;
        }
    }
}

/// Fermi, Pasta, Ulam and Tsingou.
pub(super) fn fput() -> Problem {
    let (duration, system) = (300.0, Chain { alpha: ALPHA });
    let (judge, reference) = reference(Springs, duration, 1.0);
    let begin = Springs.start();
    let start = State::new(std::array::from_fn(|i| begin[i]), [0.0; N]);
    let way = Way::new(start, duration);
    let mut entries = vec![];
    ours! { entries, system, way;
        "Verlet" from 300: StormerVerlet;
        "splitting" from 150: ForestRuth4, BlanesMoan4, BlanesMoan6, KahanLi8_17a.of(StormerVerlet);
        "Nyström" from 100: BlanesMoanSrkn6b, BlanesMoanSrkn11b, BlanesMoanSrkn14a, BceRkn17_8, BceRkn19_8;
        "force gradients" from 100: Chin4C, Omelyan4_5F2GP, Omelyan6_5F3GP, Omelyan6_5F4GV, Omelyan8_11F11GP;
        "Runge–Kutta" from 100: DOP853;
    }
    entries.push(adaptive((system, DOP853), way));
    entries.push(taylor(system, way));
    let by = || hand::Chain { alpha: black_box(ALPHA) };
    let (from, list) = (Way::new((start.q, start.p), duration), |(q, p): ([f64; N], [f64; N])| [q, p].concat());
    entries.extend([
        by_hand("StormerVerlet", 300, from, list, move |h, n, z| by().verlet(h, n, z)),
        by_hand("ForestRuth4", 150, from, list, move |h, n, z| by().drifts_first(Stages::of(&ForestRuth4), h, n, z)),
        by_hand("BlanesMoan4", 150, from, list, move |h, n, z| by().kicks_first(Stages::of(&BlanesMoan4), h, n, z)),
        by_hand("KahanLi8_17a of StormerVerlet", 150, from, list, move |h, n, z| {
            by().kicks_first(Stages::composed(&KahanLi8_17a), h, n, z)
        }),
    ]);
    entries.extend(of_field(Springs, duration, Seen::End));
    entries.extend(of_separable(Springs, duration, 300, Seen::End));
    let note = "64 masses, α = 0.25, the first mode with amplitude 1, T = 300".into();
    Problem {
        name: "fput",
        title: "Fermi, Pasta, Ulam, Tsingou",
        note,
        duration,
        measured: AT_THE_END,
        reference,
        entries,
        judge,
    }
}
