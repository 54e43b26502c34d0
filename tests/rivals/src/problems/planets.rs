//! Six bodies.

use super::{AT_THE_END, Problem, Way, adaptive, by_hand, ours, reference, taylor};
use crate::by_hand::Stages;
use crate::by_hand::outer_solar_system as hand;
use crate::field::Field;
use crate::rivals::{Seen, of_field, of_separable};
use crate::systems::OuterSolarSystem;
use geoint_runtime::Real;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::outer_planets::{G, MASSES, start};
use geoint_tests::scalars::Scalar;
use geoint_tests::scene::flat;
use std::hint::black_box;

#[derive(Clone, Copy)]
struct Planets;

impl Field<36> for Planets {
    fn start(&self) -> [f64; 36] {
        let mut all = [0.0; 36];
        all.copy_from_slice(&flat(&start()));
        all
    }
    fn rate<R: Scalar>(_: R, y: &[R; 36], dy: &mut [R; 36]) {
        for i in 0..6 {
            for k in 0..3 {
                dy[3 * i + k] = y[18 + 3 * i + k] / R::from_f64(MASSES[i]);
                dy[18 + 3 * i + k] = R::from_f64(0.0);
            }
        }
        for i in 0..6 {
            for j in 0..i {
                let d: [R; 3] = std::array::from_fn(|k| y[3 * i + k] - y[3 * j + k]);
                let square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
                let factor =
                    R::from_f64(G) * R::from_f64(MASSES[i]) * R::from_f64(MASSES[j]) / (square * Real::sqrt(square));
                for k in 0..3 {
                    dy[18 + 3 * i + k] -= factor * d[k];
                    dy[18 + 3 * j + k] += factor * d[k];
                }
            }
        }
    }
}

/// Sun, Jupiter to Pluto.
pub(super) fn outer_solar_system() -> Problem {
    let (duration, system) = (200_000.0, OuterSolarSystem { m: MASSES, g: G });
    let (judge, reference) = reference(Planets, duration, 0.005);
    let way = Way::new(start(), duration);
    let mut entries = vec![];
    ours! { entries, system, way;
        "Verlet" from 500: StormerVerlet;
        "splitting" from 200: ForestRuth4, BlanesMoan4, BlanesMoan6, KahanLi8_17a.of(StormerVerlet);
        "Nyström" from 100: BlanesMoanSrkn6b, BlanesMoanSrkn11b, BlanesMoanSrkn14a, BceRkn17_8, BceRkn19_8;
        "force gradients" from 100: Chin4C, Omelyan4_5F2GP, Omelyan6_5F3GP, Omelyan6_5F4GV, Omelyan8_11F11GP;
        "Kepler's motion exact" from 100: WisdomHolman, WisdomHolmanProcessed, WisdomHolmanGradient, Aba10_6_4;
        "Runge–Kutta" from 200: DOP853;
    }
    entries.push(adaptive((system, DOP853), way));
    entries.push(taylor(system, way));
    let by = || hand::OuterSolarSystem { m: black_box(MASSES), g: black_box(G) };
    let list = |(q, p): (hand::Vectors, hand::Vectors)| [q.as_flattened(), p.as_flattened()].concat();
    let from = Way::new((start().q.map(Into::into), start().p.map(Into::into)), duration);
    entries.extend([
        by_hand("StormerVerlet", 500, from, list, move |h, n, z| by().verlet(h, n, z)),
        by_hand("ForestRuth4", 200, from, list, move |h, n, z| by().drifts_first(Stages::of(&ForestRuth4), h, n, z)),
        by_hand("BlanesMoan4", 200, from, list, move |h, n, z| by().kicks_first(Stages::of(&BlanesMoan4), h, n, z)),
        by_hand("BlanesMoanSrkn14a", 100, from, list, move |h, n, z| {
            by().drifts_first(Stages::of(BlanesMoanSrkn14a.table()), h, n, z)
        }),
        by_hand("KahanLi8_17a of StormerVerlet", 200, from, list, move |h, n, z| {
            by().kicks_first(Stages::composed(&KahanLi8_17a), h, n, z)
        }),
    ]);
    entries.extend(of_field(Planets, duration, Seen::End));
    entries.extend(of_separable(Planets, duration, 500, Seen::End));
    let note = "200 000 days, from ephemerides of 1994".into();
    Problem {
        name: "outer_solar_system",
        title: "Outer solar system",
        note,
        duration,
        measured: AT_THE_END,
        reference,
        entries,
        judge,
    }
}
