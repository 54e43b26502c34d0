//! The galaxy of Hénon and Heiles: a regular orbit, and a chaotic one, of which the energy is what can be judged.

use super::{AT_THE_END, Judge, Problem, Way, adaptive, by_hand, ours, reference, taylors};
use crate::by_hand::{self as hand, Stages};
use crate::entry::Entry;
use crate::field::Field;
use crate::rivals::{Seen, of_field, of_separable};
use crate::systems::HenonHeiles;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::scalars::Scalar;
use std::hint::black_box;

/// x, y and their momenta at the start.
#[derive(Clone, Copy)]
pub(crate) struct Galaxy(pub(crate) [f64; 4]);

/// A regular orbit.
pub(crate) const REGULAR: Galaxy = Galaxy([0.1, 0.15, 0.3, 0.0]);
/// Energy 0.16, of 1/6 with which stars leave.
const CHAOTIC: Galaxy = Galaxy([0.0, 0.1, 0.55, 0.0]);

impl Field<4> for Galaxy {
    fn start(&self) -> [f64; 4] {
        self.0
    }
    fn rate<R: Scalar>(_: R, y: &[R; 4], dy: &mut [R; 4]) {
        let [a, b, ..] = *y;
        *dy = [y[2], y[3], -a - R::from_f64(2.0) * a * b, -b - a * a + b * b];
    }
}

/// H.
pub(crate) fn energy([x, y, u, v]: [f64; 4]) -> f64 {
    (u * u + v * v + x * x + y * y) / 2.0 + (x * x * y - y * y * y / 3.0)
}

/// The largest error of the energy over the states of a run, relative.
pub(crate) fn energy_error(states: &[f64], start: f64) -> f64 {
    let states = states.as_chunks::<4>().0;
    // Not `max`: that would lose a NaN.
    let worse = |most: f64, off: f64| if off > most || off.is_nan() { off } else { most };
    states.iter().map(|z| (energy(*z) / start - 1.0).abs()).fold(0.0, worse)
}

const DURATION: f64 = 1000.0;
const SYSTEM: HenonHeiles = HenonHeiles { lambda: 1.0 };

/// Methods that do not keep the energy as such.
fn entries(galaxy: Galaxy, times: u64) -> Vec<Entry> {
    let [x, y, u, v] = galaxy.0;
    let way = Way { start: State::new([x, y], [u, v]), duration: DURATION, times };
    let mut entries = vec![];
    ours! { entries, SYSTEM, way;
        "Verlet" from 2000: StormerVerlet;
        "splitting" from 1000: ForestRuth4, BlanesMoan4, BlanesMoan6, KahanLi8_17a.of(StormerVerlet),
            SofroniouSpaletta10_35.of(StormerVerlet);
        "Nyström" from 700: BlanesMoanSrkn6b, BlanesMoanSrkn11b, BlanesMoanSrkn14a, BceRkn17_8, BceRkn19_8;
        "force gradients" from 700: Chin4C, Omelyan4_5F2GP, Omelyan6_5F3GP, Omelyan6_5F4GV, Omelyan8_11F11GP;
        "exact oscillators" from 500: Rnia10_8_6, Aba8_6_4, Perturbation(BlanesMoanSrkn14a);
        "Gauss" from 500: Gauss::<2>, Gauss::<3>, Gauss::<4>, Gauss::<6>;
        "Runge–Kutta" from 500: DOP853;
    }
    entries.push(adaptive((SYSTEM, DOP853), way));
    entries.extend(taylors(SYSTEM, way));
    let by = || hand::henon_heiles::HenonHeiles { lambda: black_box(1.0) };
    let (from, list) = (Way { start: galaxy.0, duration: DURATION, times }, |z: [f64; 4]| z.to_vec());
    entries.extend([
        by_hand("StormerVerlet", 2000, from, list, move |h, n, z| by().verlet::<false>(h, n, z)),
        by_hand("ForestRuth4", 1000, from, list, move |h, n, z| {
            by().drifts_first::<false, 3>(Stages::of(&ForestRuth4), h, n, z)
        }),
        by_hand("BlanesMoan4", 1000, from, list, move |h, n, z| {
            by().kicks_first::<false, 6>(Stages::of(&BlanesMoan4), h, n, z)
        }),
        by_hand("KahanLi8_17a of StormerVerlet", 1000, from, list, move |h, n, z| {
            by().kicks_first::<false, 17>(Stages::composed(&KahanLi8_17a), h, n, z)
        }),
    ]);
    let seen = if times == 1 { Seen::End } else { Seen::Steps };
    entries.extend(of_field(galaxy, DURATION, seen));
    entries.extend(of_separable(galaxy, DURATION, 2000, seen));
    entries
}

/// A regular orbit.
pub(super) fn regular() -> Problem {
    let (judge, reference) = reference(REGULAR, DURATION, 2.0);
    let mut entries = entries(REGULAR, 1);
    let way = Way::new(State::new([0.1, 0.15], [0.3, 0.0]), DURATION);
    ours! { entries, SYSTEM, way; "energy kept" from 1000: DiscreteGradient, FourthOrder(DiscreteGradient); }
    let by = || hand::henon_heiles::HenonHeiles { lambda: black_box(1.0) };
    let from = Way::new(REGULAR.0, DURATION);
    entries.push(by_hand(
        "DiscreteGradient",
        1000,
        from,
        |z: [f64; 4]| z.to_vec(),
        move |h, n, z| by().discrete_gradient::<true>(h, n, z),
    ));
    Problem {
        name: "henon_heiles",
        title: "Hénon–Heiles, a regular orbit",
        note: "q = (0.1, 0.15), p = (0.3, 0), T = 1000".into(),
        duration: DURATION,
        measured: AT_THE_END,
        reference,
        entries,
        judge,
    }
}

/// A chaotic orbit.
pub(super) fn chaotic() -> Problem {
    let start = energy(CHAOTIC.0);
    let judge: Judge = Box::new(move |states| energy_error(states, start));
    Problem {
        name: "henon_heiles_chaotic",
        title: "Hénon–Heiles, a chaotic orbit",
        note: format!(
            "q = (0, 0.1), p = (0.55, 0), energy {start:.3}, T = 1000; methods that keep the energy are left out"
        ),
        duration: DURATION,
        measured: "the largest |H/H₀ − 1| of 16 times or more, since no method follows the orbit",
        reference: "H at the start".into(),
        entries: entries(CHAOTIC, 16),
        judge,
    }
}
