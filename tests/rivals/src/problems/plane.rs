//! One and two degrees of freedom: pendulum, Kepler, double pendulum.

use super::{AT_THE_END, Problem, Way, adaptive, by_hand, ours, reference, taylors};
use crate::by_hand::{self as hand, Stages};
use crate::field::Field;
use crate::rivals::{Seen, of_field, of_separable};
use crate::systems::{DoublePendulum, Kepler, Pendulum};
use geoint_runtime::Real;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::scalars::Scalar;
use std::f64::consts::PI;
use std::hint::black_box;

#[derive(Clone, Copy)]
struct Swing;

impl Field<2> for Swing {
    fn start(&self) -> [f64; 2] {
        [1.5, 0.0]
    }
    fn rate<R: Scalar>(_: R, y: &[R; 2], dy: &mut [R; 2]) {
        *dy = [y[1], -y[0].sin()];
    }
}

/// q'' = −sin q.
pub(super) fn pendulum() -> Problem {
    let (duration, system) = (1000.0, Pendulum { m: 1.0, l: 1.0, g: 1.0 });
    let (judge, reference) = reference(Swing, duration, 1.5);
    let way = Way::new(State::new(1.5, 0.0), duration);
    let mut entries = vec![];
    ours! { entries, system, way;
        "Verlet" from 2000: StormerVerlet;
        "splitting" from 1000: ForestRuth4, BlanesMoan4, BlanesMoan6, KahanLi8_17a.of(StormerVerlet), SofroniouSpaletta10_35.of(StormerVerlet);
        "Nyström" from 700: BlanesMoanSrkn6b, BlanesMoanSrkn11b, BlanesMoanSrkn14a, BceRkn17_8, BceRkn19_8;
        "force gradients" from 700: Chin4C, Omelyan4_5F2GP, Omelyan6_5F3GP, Omelyan6_5F4GV, Omelyan8_11F11GP;
        "Gauss" from 500: Gauss::<2>, Gauss::<3>, Gauss::<4>, Gauss::<6>;
        "energy kept" from 1000: DiscreteGradient, FourthOrder(DiscreteGradient), Suzuki4.of(DiscreteGradient);
        "Runge–Kutta" from 500: DOP853;
    }
    entries.push(adaptive((system, DOP853), way));
    entries.extend(taylors(system, way));
    let by = || hand::pendulum::Pendulum { m: black_box(1.0), l: black_box(1.0), g: black_box(1.0) };
    let (from, list) = (Way::new((1.5, 0.0), duration), |(q, p): (f64, f64)| vec![q, p]);
    entries.extend([
        by_hand("StormerVerlet", 2000, from, list, move |h, n, z| by().verlet(h, n, z)),
        by_hand("ForestRuth4", 1000, from, list, move |h, n, z| by().drifts_first(Stages::of(&ForestRuth4), h, n, z)),
        by_hand("BlanesMoan4", 1000, from, list, move |h, n, z| by().kicks_first(Stages::of(&BlanesMoan4), h, n, z)),
        by_hand("KahanLi8_17a of StormerVerlet", 1000, from, list, move |h, n, z| {
            by().kicks_first(Stages::composed(&KahanLi8_17a), h, n, z)
        }),
        by_hand("DiscreteGradient", 1000, from, list, move |h, n, z| by().discrete_gradient::<true>(h, n, z)),
    ]);
    entries.extend(of_field(Swing, duration, Seen::End));
    entries.extend(of_separable(Swing, duration, 2000, Seen::End));
    let note = "q = 1.5, p = 0, T = 1000".into();
    Problem { name: "pendulum", title: "Pendulum", note, duration, measured: AT_THE_END, reference, entries, judge }
}

#[derive(Clone, Copy)]
struct Orbit;

impl Field<4> for Orbit {
    fn start(&self) -> [f64; 4] {
        [0.4, 0.0, 0.0, 2.0]
    }
    fn rate<R: Scalar>(_: R, y: &[R; 4], dy: &mut [R; 4]) {
        let square = y[0] * y[0] + y[1] * y[1];
        let factor = R::from_f64(-1.0) / (square * Real::sqrt(square));
        *dy = [y[2], y[3], factor * y[0], factor * y[1]];
    }
}

/// Kepler's motion with e = 0.6.
pub(super) fn kepler() -> Problem {
    let (duration, system) = (200.0 * PI, Kepler { m: 1.0, mu: 1.0 });
    let (judge, reference) = reference(Orbit, duration, 6.0);
    let way = Way::new(State::new([0.4, 0.0], [0.0, 2.0]), duration);
    let mut entries = vec![];
    ours! { entries, system, way;
        "Verlet" from 10_000: StormerVerlet;
        "splitting" from 4000: ForestRuth4, BlanesMoan4, BlanesMoan6, KahanLi8_17a.of(StormerVerlet), SofroniouSpaletta10_35.of(StormerVerlet);
        "Nyström" from 3000: BlanesMoanSrkn6b, BlanesMoanSrkn11b, BlanesMoanSrkn14a, BceRkn17_8, BceRkn19_8;
        "force gradients" from 3000: Chin4C, Omelyan4_5F2GP, Omelyan6_5F3GP, Omelyan6_5F4GV, Omelyan8_11F11GP;
        "Gauss" from 2000: Gauss::<2>, Gauss::<3>, Gauss::<4>, Gauss::<6>;
        "energy kept" from 5000: DiscreteGradient, FourthOrder(DiscreteGradient);
        "Runge–Kutta" from 2000: DOP853;
    }
    entries.push(adaptive((system, DOP853), way));
    entries.extend(taylors(system, way));
    let by = || hand::kepler::Kepler { m: black_box(1.0), mu: black_box(1.0) };
    let (from, list) = (Way::new(Orbit.start(), duration), |z: [f64; 4]| z.to_vec());
    entries.extend([
        by_hand("StormerVerlet", 10_000, from, list, move |h, n, z| by().verlet(h, n, z)),
        by_hand("ForestRuth4", 4000, from, list, move |h, n, z| by().drifts_first(Stages::of(&ForestRuth4), h, n, z)),
        by_hand("BlanesMoan4", 4000, from, list, move |h, n, z| by().kicks_first(Stages::of(&BlanesMoan4), h, n, z)),
        by_hand("KahanLi8_17a of StormerVerlet", 4000, from, list, move |h, n, z| {
            by().kicks_first(Stages::composed(&KahanLi8_17a), h, n, z)
        }),
        by_hand("DiscreteGradient", 5000, from, list, move |h, n, z| by().discrete_gradient::<true>(h, n, z)),
    ]);
    entries.extend(of_field(Orbit, duration, Seen::End));
    entries.extend(of_separable(Orbit, duration, 10_000, Seen::End));
    let note = "e = 0.6, 100 revolutions".into();
    Problem { name: "kepler", title: "Kepler", note, duration, measured: AT_THE_END, reference, entries, judge }
}

#[derive(Clone, Copy)]
struct Rods;

impl Field<4> for Rods {
    fn start(&self) -> [f64; 4] {
        [0.9, -0.4, 0.3, 0.2]
    }
    /// Unit masses and lengths: H = (p₀² + 2p₁² − 2p₀p₁ cos δ)/(2(1 + sin² δ)) − 2g cos q₀ − g cos q₁.
    fn rate<R: Scalar>(_: R, y: &[R; 4], dy: &mut [R; 4]) {
        let [a, b, u, v] = *y;
        let (two, g) = (R::from_f64(2.0), R::from_f64(9.81));
        let (sin, cos) = ((a - b).sin(), (a - b).cos());
        let below = R::from_f64(1.0) + sin * sin;
        let above = u * u + two * v * v - two * u * v * cos;
        let by_angle = (u * v * sin - above * sin * cos / below) / below;
        *dy =
            [(u - v * cos) / below, (two * v - u * cos) / below, -by_angle - two * g * a.sin(), by_angle - g * b.sin()];
    }
}

/// A double pendulum.
pub(super) fn double_pendulum() -> Problem {
    let (duration, system) = (50.0, DoublePendulum { m: [1.0; 2], l: [1.0; 2], g: 9.81 });
    let (judge, reference) = reference(Rods, duration, 20.0);
    let way = Way::new(State::new([0.9, -0.4], [0.3, 0.2]), duration);
    let mut entries = vec![];
    ours! { entries, system, way;
        "Gauss" from 400: ImplicitMidpoint, Gauss::<2>, Gauss::<3>, Gauss::<4>, Gauss::<6>;
        "composed" from 200: KahanLi8_17a.of(ImplicitMidpoint);
        "energy kept" from 400: DiscreteGradient, FourthOrder(DiscreteGradient);
        "Runge–Kutta" from 200: DOP853;
    }
    entries.push(adaptive((system, DOP853), way));
    entries.extend(taylors(system, way));
    let by =
        || hand::double_pendulum::DoublePendulum { m: black_box([1.0; 2]), l: black_box([1.0; 2]), g: black_box(9.81) };
    let (from, list) = (Way::new(Rods.start(), duration), |z: [f64; 4]| z.to_vec());
    entries.extend([
        by_hand("ImplicitMidpoint", 400, from, list, move |h, n, z| by().implicit_midpoint(h, n, z)),
        by_hand("KahanLi8_17a of ImplicitMidpoint", 200, from, list, move |h, n, z| {
            by().composed(KahanLi8_17a.weights(), h, n, z)
        }),
    ]);
    entries.extend(of_field(Rods, duration, Seen::End));
    let note = "unit rods, angles 0.9 and −0.4, momenta 0.3 and 0.2, T = 50".into();
    Problem {
        name: "double_pendulum",
        title: "Double pendulum",
        note,
        duration,
        measured: AT_THE_END,
        reference,
        entries,
        judge,
    }
}
