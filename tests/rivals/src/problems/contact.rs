//! Systems with friction: an oscillator, an orbit that is braked and driven, Van der Pol's.

use super::{AT_THE_END, Problem, Way, by_hand, reference};
use crate::by_hand::damped_oscillator::DampedOscillator;
use crate::by_hand::perturbed_kepler::PerturbedKepler;
use crate::entry::{Entry, Whose};
use crate::field::Field;
use crate::rivals::{Seen, of_field};
use crate::systems::DrivenKepler;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::Jets;
use geoint_runtime::system::{Rates, StateOf};
use geoint_runtime::{Conformal, Real};
use geoint_tests::scalars::Scalar;
use geoint_tests::scene::flat;
use std::hint::black_box;

/// q'' + γq' + q = 0.
#[contact_hamiltonian]
fn damped(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 + gamma * s
}

/// The same in two pieces, as if it were not known to be one.
#[contact_hamiltonian(split = "p * p / 2.0 + gamma * s | q * q / 2.0")]
fn damped_in_two(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 + gamma * s
}

/// Steps of one length, without the action: errors are those of positions and momenta, the first `n` numbers.
fn plain<S: Conformal + 'static, M: Method<S> + 'static>(
    family: &'static str,
    (system, method): (S, M),
    (way, n): (Way<StateOf<S, f64>>, usize),
    first: u64,
) -> Entry {
    Entry::steps(Whose::Ours, family, method.name().to_string(), first, move |steps| {
        way.steps(
            steps,
            |h| Integrator::new(black_box(system), method, h, black_box(way.start)).without_action(),
            |sim, _, steps| {
                sim.advance(steps).ok()?;
                Some(flat(&sim.state())[..n].to_vec())
            },
        )
    })
}

/// Taylor series, of which the first `n` numbers are compared.
fn taylors<S: Jets + Rates + 'static>(system: S, (way, n): (Way<StateOf<S, f64>>, usize)) -> [Entry; 4] {
    super::taylors(system, way).map(|Entry { whose, family, name, efforts, run }| {
        let run = Box::new(move |effort| run(effort).map(|state| state[..n].to_vec()));
        Entry { whose, family, name, efforts, run }
    })
}

macro_rules! ours {
    ($entries:ident, $system:expr, $way:expr; $($family:literal from $first:literal: $($method:expr),+;)*) => {
        $($( $entries.push(plain($family, ($system, $method), $way, $first)); )+)*
    };
}

#[derive(Clone, Copy)]
struct Fading;

impl Field<2> for Fading {
    fn start(&self) -> [f64; 2] {
        [1.0, 0.5]
    }
    fn rate<R: Scalar>(_: R, y: &[R; 2], dy: &mut [R; 2]) {
        *dy = [y[1], -y[0] - R::from_f64(0.1) * y[1]];
    }
}

pub(super) fn damped_oscillator() -> Problem {
    let duration = 50.0;
    let (judge, reference) = reference(Fading, duration, 2.0);
    let way = (Way::new(ContactState::new(1.0, 0.5, 0.0), duration), 2);
    let mut entries = vec![];
    ours! { entries, Damped { gamma: 0.1 }, way; "one exact piece" from 1: ContactSplitting; }
    entries[0].name += ", one piece";
    ours! { entries, DampedInTwo { gamma: 0.1 }, way;
        "two pieces" from 50: ContactSplitting, BlanesMoan4, KahanLi8_17a.of(ContactSplitting);
        "Nyström" from 50: BlanesMoanSrkn11b, BlanesMoanSrkn14a, BceRkn17_8;
        "contact Gauss" from 50: ContactGauss::<2>, ContactGauss::<4>;
        "law of decay" from 100: ContactDiscreteGradient;
    }
    entries.extend(taylors(DampedInTwo { gamma: 0.1 }, way));
    let by = || DampedOscillator { gamma: black_box(0.1) };
    let (from, list) = (Way::new(Fading.start(), duration), |z: [f64; 2]| z.to_vec());
    entries.push(by_hand("ContactSplitting", 50, from, list, move |h, n, z| by().steps(h, n, z)));
    entries.extend(of_field(Fading, duration, Seen::End));
    let note = "γ = 0.1, q = 1, p = 0.5, T = 50".into();
    Problem {
        name: "damped_oscillator",
        title: "Damped oscillator",
        note,
        duration,
        measured: AT_THE_END,
        reference,
        entries,
        judge,
    }
}

#[derive(Clone, Copy)]
struct Braked;

const FREQUENCY: f64 = std::f64::consts::TAU;

impl Field<4> for Braked {
    fn start(&self) -> [f64; 4] {
        [0.6, 0.0, 0.0, 1.5]
    }
    fn rate<R: Scalar>(t: R, y: &[R; 4], dy: &mut [R; 4]) {
        let square = y[0] * y[0] + y[1] * y[1];
        let factor = R::from_f64(-1.0) / (square * Real::sqrt(square));
        let friction = R::from_f64(-0.07) * (R::from_f64(FREQUENCY) * t).sin();
        *dy = [y[2], y[3], factor * y[0] - friction * y[2], factor * y[1] - friction * y[3]];
    }
}

pub(super) fn perturbed_kepler() -> Problem {
    let (duration, system) = (100.0, DrivenKepler { mu: 1.0, alpha: -0.07, omega: FREQUENCY });
    let (judge, reference) = reference(Braked, duration, 20.0);
    let way = (Way::new(ContactState::new([0.6, 0.0], [0.0, 1.5], 0.0), duration), 4);
    let mut entries = vec![];
    ours! { entries, system, way;
        "contact splitting" from 1000: ContactSplitting, Suzuki4.of(ContactSplitting), BlanesMoan4X, BlanesMoan4, BlanesMoan6,
            KahanLi8_17a.of(ContactSplitting);
        "contact Gauss" from 500: ContactGauss::<2>, ContactGauss::<3>, ContactGauss::<4>;
        "law of decay" from 1000: ContactDiscreteGradient;
    }
    entries.extend(taylors(system, way));
    let by = || PerturbedKepler { mu: black_box(1.0), alpha: black_box(-0.07), omega: black_box(FREQUENCY) };
    let (from, list) = (Way::new([0.6, 0.0, 0.0, 1.5, 0.0], duration), |z: [f64; 5]| z[..4].to_vec());
    entries.push(by_hand("ContactSplitting", 1000, from, list, move |h, n, z| by().driven(h, n, z)));
    entries.extend(of_field(Braked, duration, Seen::End));
    let note = "α = −0.07, Ω = 2π, q = (0.6, 0), p = (0, 1.5), T = 100".into();
    Problem {
        name: "perturbed_kepler",
        title: "Kepler with friction that comes and goes",
        note,
        duration,
        measured: AT_THE_END,
        reference,
        entries,
        judge,
    }
}

const EPSILON: f64 = 5.0;

/// q' = s, s' = ε(1 − q²)s − q, whose momentum is not followed.
#[contact_hamiltonian(lift)]
fn van_der_pol_lifted(q: f64, p: f64, s: f64, eps: f64) -> f64 {
    p * s - eps * (1.0 - q * q) * s + q
}

/// The same as a field.
#[vector_field]
fn relaxing(x: [f64; 2], eps: f64) -> [f64; 2] {
    [x[1], eps * (1.0 - x[0] * x[0]) * x[1] - x[0]]
}

#[derive(Clone, Copy)]
struct Relaxation;

impl Field<2> for Relaxation {
    fn start(&self) -> [f64; 2] {
        [2.0, 0.0]
    }
    fn rate<R: Scalar>(_: R, y: &[R; 2], dy: &mut [R; 2]) {
        let [q, s] = *y;
        *dy = [s, R::from_f64(EPSILON) * (R::from_f64(1.0) - q * q) * s - q];
    }
}

pub(super) fn van_der_pol() -> Problem {
    let (duration, field) = (50.0, Relaxing { eps: EPSILON });
    let (judge, reference) = reference(Relaxation, duration, 100.0);
    let mut entries = vec![];
    macro_rules! lifted {
        ($first:literal: $($method:expr),+) => { $(
            let method = $method;
            let name = Method::<VanDerPolLifted>::name(&method).to_string();
            entries.push(Entry::steps(Whose::Ours, "lifted pieces", name, $first, move |n| {
                let start = black_box(ContactState::new(2.0, 0.0, 0.0));
                let mut sim = VanDerPolLifted { eps: black_box(EPSILON) }.integrator(method, duration / n as f64, start);
                sim.advance(n).ok()?;
                let state = sim.state();
                Some(vec![state.q, state.s])
            }));
        )+ };
    }
    lifted!(500: ContactSplitting, Suzuki4.of(ContactSplitting), BlanesMoan4X, KahanLi8_17a.of(ContactSplitting));
    let way = Way::new(FlowState::new([2.0, 0.0]), duration);
    entries.push(super::fixed("Gauss", (field, Gauss::<3>), way, 500));
    entries.push(super::fixed("Gauss", (field, Gauss::<6>), way, 300));
    entries.push(super::fixed("Runge–Kutta", (field, DOP853), way, 300));
    entries.push(super::adaptive((field, DOP853), way));
    entries.extend(super::taylors(field, way));
    entries.extend(of_field(Relaxation, duration, Seen::End));
    let note = "ε = 5, q = 2, q' = 0, T = 50".into();
    Problem {
        name: "van_der_pol",
        title: "Van der Pol",
        note,
        duration,
        measured: AT_THE_END,
        reference,
        entries,
        judge,
    }
}
