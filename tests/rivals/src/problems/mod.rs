//! The problems: each with its field, its reference, our methods on its energy, steps by hand, and rivals.

mod contact;
mod flows;
pub(crate) mod galaxy;
mod lattice;
mod plane;
mod planets;

use crate::entry::{Entry, Whose};
use crate::field::Field;
use geoint_runtime::TaylorIntegrator;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::{Jets, TaylorMethod};
use geoint_runtime::system::{Rates, StateOf};
use geoint_tests::measure::extrapolated;
use geoint_tests::scalars::Double;
use geoint_tests::scene::flat;
use std::hint::black_box;

/// A problem with all ways to its end.
pub struct Problem {
    /// Of the files.
    pub name: &'static str,
    /// A heading.
    pub title: &'static str,
    /// Parameters, start, duration.
    pub note: String,
    /// Until when.
    pub duration: f64,
    /// What the error is.
    pub measured: &'static str,
    /// How the reference was had.
    pub reference: String,
    /// All ways to the end.
    pub entries: Vec<Entry>,
    /// The error of the states of a run.
    pub judge: Judge,
}

/// From states to an error.
pub type Judge = Box<dyn Fn(&[f64]) -> f64>;

/// The name of a problem, and what makes it.
pub type Named = (&'static str, fn() -> Problem);

/// All problems, made when they are wanted, because references take time.
pub const ALL: [Named; 11] = [
    ("pendulum", plane::pendulum),
    ("kepler", plane::kepler),
    ("henon_heiles", galaxy::regular),
    ("henon_heiles_chaotic", galaxy::chaotic),
    ("double_pendulum", plane::double_pendulum),
    ("outer_solar_system", planets::outer_solar_system),
    ("fput", lattice::fput),
    ("damped_oscillator", contact::damped_oscillator),
    ("perturbed_kepler", contact::perturbed_kepler),
    ("van_der_pol", contact::van_der_pol),
    ("euler_top", flows::euler_top),
];

/// What most problems measure.
const AT_THE_END: &str = "|x − x*|/|x*| at the end, x positions and momenta";

/// The error at the end by Gragg's extrapolation to order 24 in double-double; and in words how far a run with half as many parts is from it.
/// There are as many as it takes, `parts` a unit of time at first.
fn reference<F: Field<N>, const N: usize>(field: F, duration: f64, parts: f64) -> (Judge, String) {
    let solve = |parts: usize| -> Vec<f64> {
        let rate = |t: Double, y: &[Double]| {
            let (mut now, mut rate) = ([Double::from(0.0); N], [Double::from(0.0); N]);
            now.copy_from_slice(y);
            F::rate(t, &now, &mut rate);
            rate.to_vec()
        };
        let start = field.start().iter().map(|y| Double::from(*y)).collect();
        extrapolated(rate, Double::from(0.0), start, Double::from(duration), parts).iter().map(|y| y.value()).collect()
    };
    let mut parts = (parts * duration).ceil() as usize;
    let mut coarse = solve(parts);
    loop {
        parts *= 2;
        let end = solve(parts);
        let gap = distance(&coarse, &end);
        if gap < GOOD {
            let gap = if gap == 0.0 { "all digits are the same".into() } else { format!("it is {gap:.0e} away") };
            let said = format!(
                "extrapolation to order 24 in double-double arithmetic, {parts} parts; with half of them {gap}"
            );
            return (Box::new(move |x| distance(&x[x.len() - end.len()..], &end)), said);
        }
        coarse = end;
    }
}

/// A reference is good to the error of the coarser of two runs, which is the largest one of both.
const GOOD: f64 = 1e-15;

/// |x − end| over |end|.
fn distance(x: &[f64], end: &[f64]) -> f64 {
    let square = |x: &mut dyn Iterator<Item = f64>| x.map(|x| x * x).sum::<f64>().sqrt();
    square(&mut x.iter().zip(end).map(|(x, end)| x - end)) / square(&mut end.iter().copied())
}

/// Where runs start and end, and at how many times, evenly spread up to the end, their states are taken.
#[derive(Clone, Copy)]
struct Way<T> {
    start: T,
    duration: f64,
    times: u64,
}

impl<T: Copy> Way<T> {
    fn new(start: T, duration: f64) -> Self {
        Way { start, duration, times: 1 }
    }

    /// The states of a run with about `n` steps of one length in all, which the closure takes: length, number, from where.
    fn steps<Z>(
        &self,
        n: u64,
        mut sim: impl FnMut(f64) -> Z,
        mut go: impl FnMut(&mut Z, f64, u64) -> Option<Vec<f64>>,
    ) -> Option<Vec<f64>> {
        let part = n.div_ceil(self.times);
        let h = self.duration / (part * self.times) as f64;
        let mut sim = sim(h);
        let mut states = vec![];
        for _ in 0..self.times {
            states.extend(go(&mut sim, h, part)?);
        }
        Some(states)
    }

    /// The states of a run that goes from time to time.
    fn times(&self, mut go: impl FnMut(f64) -> Option<Vec<f64>>) -> Option<Vec<f64>> {
        let mut states = vec![];
        for k in 1..=self.times {
            let end = if k == self.times { self.duration } else { self.duration * k as f64 / self.times as f64 };
            states.extend(go(end)?);
        }
        Some(states)
    }
}

/// Steps of one length.
fn fixed<S: PhaseSpace + 'static, M: Method<S> + 'static>(
    family: &'static str,
    (system, method): (S, M),
    way: Way<StateOf<S, f64>>,
    first: u64,
) -> Entry {
    Entry::steps(Whose::Ours, family, method.name().to_string(), first, move |n| {
        way.steps(
            n,
            |h| Integrator::new(black_box(system), method, h, black_box(way.start)),
            |sim, _, n| {
                sim.advance(n).ok()?;
                Some(flat(&sim.state()))
            },
        )
    })
}

/// Steps that adapt.
fn adaptive<S: PhaseSpace + Rates + 'static, M: Method<S> + 'static>(
    (system, method): (S, M),
    way: Way<StateOf<S, f64>>,
) -> Entry {
    Entry::tolerances(Whose::Ours, "adaptive", format!("adaptive({})", method.name()), move |tolerance| {
        let mut sim = Adaptive::new(black_box(system), method, tolerance, black_box(way.start));
        way.times(|t| {
            sim.advance_to(t).ok()?;
            Some(flat(&sim.state()))
        })
    })
}

/// Taylor series. The order follows from the tolerance.
fn taylor<S: Jets + 'static>(system: S, way: Way<StateOf<S, f64>>) -> Entry {
    series("Taylor", |tolerance| Taylor { tolerance }, system, way)
}

/// And of lower orders, which loose tolerances ask for.
fn taylors<S: Jets + 'static>(system: S, way: Way<StateOf<S, f64>>) -> [Entry; 4] {
    [
        taylor(system, way),
        series("TaylorOrder<12>", |tolerance| TaylorOrder::<12> { tolerance }, system, way),
        series("TaylorOrder<10>", |tolerance| TaylorOrder::<10> { tolerance }, system, way),
        series("TaylorOrder<8>", |tolerance| TaylorOrder::<8> { tolerance }, system, way),
    ]
}

fn series<S: Jets + 'static, M: TaylorMethod<S> + 'static>(
    name: &'static str,
    method: fn(f64) -> M,
    system: S,
    way: Way<StateOf<S, f64>>,
) -> Entry {
    Entry::tolerances(Whose::Ours, "Taylor", name, move |tolerance| {
        let mut sim = TaylorIntegrator::new(black_box(system), method(tolerance), black_box(way.start));
        way.times(|t| {
            sim.advance_to(t).ok()?;
            Some(flat(&sim.state()))
        })
    })
}

/// Steps by hand: `run(h, n, from)`. The name is that of the method of ours which takes the same steps.
fn by_hand<Z: Copy + 'static>(
    name: &'static str,
    first: u64,
    way: Way<Z>,
    list: fn(Z) -> Vec<f64>,
    run: impl Fn(f64, u64, Z) -> Z + 'static,
) -> Entry {
    Entry::steps(Whose::Hand, "by hand", name, first, move |n| {
        way.steps(
            n,
            |_| black_box(way.start),
            |z, h, n| {
                *z = run(h, n, *z);
                Some(list(*z))
            },
        )
    })
}

/// Methods with one family, from so many steps on.
macro_rules! ours {
    ($entries:ident, $system:expr, $way:expr; $($family:literal from $first:literal: $($method:expr),+;)*) => {
        $($( $entries.push($crate::problems::fixed($family, ($system, $method), $way, $first)); )+)*
    };
}
use ours;
