//! The problems: each with its field, its reference, our methods on its energy, steps by hand, and rivals.

mod contact;
mod flows;
mod lattice;
mod plane;
mod planets;

use crate::entry::{Entry, Whose};
use crate::measure::relative_to;
use geoint_runtime::prelude::*;
use geoint_runtime::system::{Jets, Rates, StateOf};
use geoint_tests::measure::extrapolated;
use geoint_tests::scalars::{Double, Scalar};
use geoint_tests::scene::flat;
use std::hint::black_box;

/// y' = rate(t, y) in every scalar, from a start at t = 0.
pub trait Field<const N: usize>: Copy + Send + Sync + 'static {
    /// Where it starts.
    fn start(&self) -> [f64; N];
    /// y'.
    fn rate<R: Scalar>(&self, t: R, y: &[R; N], dy: &mut [R; N]);
}

/// A problem with all ways to its end.
pub struct Problem {
    /// Of the files.
    pub name: &'static str,
    /// A heading.
    pub title: &'static str,
    /// Parameters, start, what the error is.
    pub note: String,
    /// Until when.
    pub duration: f64,
    /// How the reference was had.
    pub reference: String,
    /// All ways to the end.
    pub entries: Vec<Entry>,
    /// The error of a final state.
    pub judge: Box<dyn Fn(&[f64]) -> f64>,
}

/// All problems, made when they are wanted, because references take time.
pub const ALL: [(&str, fn() -> Problem); 10] = [
    ("pendulum", plane::pendulum),
    ("kepler", plane::kepler),
    ("henon_heiles", plane::henon_heiles),
    ("double_pendulum", plane::double_pendulum),
    ("outer_solar_system", planets::outer_solar_system),
    ("fput", lattice::fput),
    ("damped_oscillator", contact::damped_oscillator),
    ("perturbed_kepler", contact::perturbed_kepler),
    ("van_der_pol", contact::van_der_pol),
    ("euler_top", flows::euler_top),
];

/// The error at the end by Gragg's extrapolation to order 24 in double-double, with `parts` a unit of time; and in words how far a run with
/// half as many is from it.
fn reference<F: Field<N>, const N: usize>(field: F, duration: f64, parts: f64) -> (Box<dyn Fn(&[f64]) -> f64>, String) {
    let solve = |parts: usize| -> Vec<f64> {
        let rate = |t: Double, y: &[Double]| {
            let (mut now, mut rate) = ([Double::from(0.0); N], [Double::from(0.0); N]);
            now.copy_from_slice(y);
            field.rate(t, &now, &mut rate);
            rate.to_vec()
        };
        let start = field.start().iter().map(|y| Double::from(*y)).collect();
        extrapolated(rate, Double::from(0.0), start, Double::from(duration), parts).iter().map(|y| y.value()).collect()
    };
    let whole = (parts * duration).ceil() as usize;
    let (end, coarse) = (solve(whole), solve(whole.div_ceil(2)));
    let gap = relative_to(end.clone())(&coarse);
    let said = format!("extrapolation to order 24 in double-double, {whole} parts; with half of them {gap:.0e} away");
    (Box::new(relative_to(end)), said)
}

/// Where our runs start and end.
#[derive(Clone, Copy)]
struct Way<T> {
    start: T,
    duration: f64,
}

/// Steps of one length.
fn fixed<S: PhaseSpace + 'static, M: Method<S> + 'static>(
    family: &'static str,
    (system, method): (S, M),
    way: Way<StateOf<S, f64>>,
    first: u64,
) -> Entry {
    Entry::steps(Whose::Ours, family, method.name().to_string(), first, move |n| {
        let mut sim = Integrator::new(black_box(system), method, way.duration / n as f64, black_box(way.start));
        sim.advance(n).ok()?;
        Some(flat(&sim.state()))
    })
}

/// Steps that adapt.
fn adaptive<S: PhaseSpace + Rates + 'static, M: Method<S> + 'static>(
    (system, method): (S, M),
    way: Way<StateOf<S, f64>>,
) -> Entry {
    Entry::tolerances(Whose::Ours, "adaptive", format!("adaptive({})", method.name()), move |tolerance| {
        let mut sim = Adaptive::new(black_box(system), method, tolerance, black_box(way.start));
        sim.advance_to(way.duration).ok()?;
        Some(flat(&sim.state()))
    })
}

/// Taylor series.
fn taylor<S: Jets + 'static>(system: S, way: Way<StateOf<S, f64>>) -> Entry {
    Entry::tolerances(Whose::Ours, "Taylor", "Taylor", move |tolerance| {
        let mut sim =
            geoint_runtime::TaylorIntegrator::new(black_box(system), Taylor { tolerance }, black_box(way.start));
        sim.advance_to(way.duration).ok()?;
        Some(flat(&sim.state()))
    })
}

/// Steps by hand.
fn by_hand(name: &'static str, first: u64, run: impl Fn(u64) -> Vec<f64> + 'static) -> Entry {
    Entry::steps(Whose::Hand, "by hand", name, first, move |n| Some(run(n)))
}

/// Methods with one family, from so many steps on.
macro_rules! ours {
    ($entries:ident, $system:expr, $way:expr; $($family:literal from $first:literal: $($method:expr),+;)*) => {
        $($( $entries.push($crate::problems::fixed($family, ($system, $method), $way, $first)); )+)*
    };
}
use ours;
