//! Energies that change by rounding alone, and the growth of this change with the number of steps.

use geoint_runtime::prelude::*;
use geoint_runtime::space::Summation;
use geoint_tests::problems::{Kepler, Pendulum, Problem};

/// Returns energy errors after 10⁴, 10⁵ … steps, in units of the energy. Up to 10^`most` steps this is the root mean square over all runs. Beyond, it is
/// the error of the first run alone.
fn growth<S, M, C>(runs: Vec<Integrator<S, M, f64, C>>, most: u32, first: u32) -> Growth
where
    S: PhaseSpace,
    M: Method<S>,
    C: Summation<S::Phase>,
{
    let (energies, mut runs): (Vec<f64>, _) = (runs.iter().map(Integrator::energy).collect(), runs);
    let errors = (4..=first).map(|power| {
        if power > most {
            runs.truncate(1);
        }
        let square = |(run, energy): (&mut Integrator<S, M, f64, C>, &f64)| {
            run.advance(10_u64.pow(power) - run.steps()).expect("steps");
            (run.energy() / energy - 1.0).powi(2)
        };
        let count = runs.len() as f64;
        let sum: f64 = runs.iter_mut().zip(&energies).map(square).sum();
        (10_f64.powi(power as i32), (sum / count).sqrt())
    });
    errors.collect()
}

/// Returns runs whose starts differ slightly, and therefore in all rounding errors.
fn pendulums<M: Method<Pendulum>>(method: M, h: f64, starts: u32) -> Vec<Integrator<Pendulum, M>> {
    let start = |i: u32| State::new(1.1 + 1e-3 * f64::from(i), 0.4);
    (0..starts).map(|i| Pendulum::system::<f64>().integrator(method, h, start(i))).collect()
}

fn orbits<M: Method<Kepler>>(method: M, h: f64, starts: u32) -> Vec<Integrator<Kepler, M>> {
    let start = |i: u32| State::new([0.9 + 1e-3 * f64::from(i), 0.2], [-0.3, 1.9]);
    (0..starts).map(|i| Kepler::system::<f64>().integrator(method, h, start(i))).collect()
}

fn keeps<S: PhaseSpace, M: Method<S>>(_: &Integrator<S, M>) -> bool {
    M::HANDLING.keeps_invariants
}

/// Numbers of steps, and the errors after them.
pub(crate) type Growth = Vec<(f64, f64)>;

/// A method on a system whose energy error is rounding alone. The arguments of the functions are a power of ten of steps, a number of starts, and the power
/// of ten for the first start.
pub(crate) struct Walk {
    pub(crate) name: &'static str,
    /// True if the drift of the energy is removed, so nothing grows.
    pub(crate) settled: bool,
    pub(crate) plain: fn((u32, u32), u32) -> Growth,
    pub(crate) compensated: fn((u32, u32), u32) -> Growth,
}

/// Returns all walks.
pub(crate) fn walks() -> Vec<Walk> {
    macro_rules! walks {
        ($($system:literal, $starts:ident: $($method:expr, $h:literal),+;)*) => { vec![$($( Walk {
            name: concat!($system, ", ", stringify!($method), ", h = ", $h),
            settled: keeps(&$starts($method, $h, 1)[0]),
            plain: |(most, starts), first| growth($starts($method, $h, starts), most, first),
            compensated: |(most, starts), first| growth($starts($method, $h, starts).into_iter().map(Integrator::compensated).collect(), most, first),
        } ),+),*] };
    }
    walks! {
        "pendulum", pendulums: StormerVerlet, 1e-7, BlanesMoanSrkn14a, 0.003, Gauss::<3>, 0.003, DiscreteGradient, 0.02;
        "Kepler", orbits: StormerVerlet, 1e-7, BlanesMoanSrkn14a, 0.003, Gauss::<3>, 0.003, DiscreteGradient, 0.02;
    }
}
