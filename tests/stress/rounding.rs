//! Energies that move by rounding alone, and how this grows with the number of steps.

use geoint_runtime::prelude::*;
use geoint_runtime::space::Summation;
use geoint_tests::problems::{Kepler, Pendulum, Problem};

/// Energy errors after 10⁴, 10⁵ … steps, the root mean square over a few starts, in units of the energy.
fn growth<S, M, C>(runs: Vec<Integrator<S, M, f64, C>>, most: u32) -> Vec<(f64, f64)>
where
    S: PhaseSpace,
    M: Method<S>,
    C: Summation<S::Phase>,
{
    let mut squares = vec![0.0; most as usize - 3];
    let count = runs.len() as f64;
    for mut run in runs {
        let energy = run.energy();
        for (power, square) in (4..=most).zip(&mut squares) {
            run.advance(10_u64.pow(power) - run.steps()).expect("steps");
            *square += (run.energy() / energy - 1.0).powi(2) / count;
        }
    }
    (4..=most).zip(squares).map(|(power, square)| (10_f64.powi(power as i32), square.sqrt())).collect()
}

/// Starts that differ in the last digits, and so in all roundings.
fn pendulums<M: Method<Pendulum>>(method: M, h: f64, starts: u32) -> Vec<Integrator<Pendulum, M>> {
    let start = |i: u32| State::new(1.1 + 1e-3 * f64::from(i), 0.4);
    (0..starts).map(|i| Pendulum::system::<f64>().integrator(method, h, start(i))).collect()
}

fn orbits<M: Method<Kepler>>(method: M, h: f64, starts: u32) -> Vec<Integrator<Kepler, M>> {
    let start = |i: u32| State::new([0.9 + 1e-3 * f64::from(i), 0.2], [-0.3, 1.9]);
    (0..starts).map(|i| Kepler::system::<f64>().integrator(method, h, start(i))).collect()
}

/// Numbers of steps, and the errors after them.
pub(crate) type Growth = Vec<(f64, f64)>;

/// A method whose energy error is rounding alone, on a system: its growth up to a power of ten of steps, from so many starts.
pub(crate) struct Walk {
    pub(crate) name: &'static str,
    pub(crate) plain: fn(u32, u32) -> Growth,
    pub(crate) compensated: fn(u32, u32) -> Growth,
}

/// All of them.
pub(crate) fn walks() -> Vec<Walk> {
    macro_rules! walks {
        ($($system:literal, $starts:ident: $($method:expr, $h:literal),+;)*) => { vec![$($( Walk {
            name: concat!($system, ", ", stringify!($method), ", h = ", $h),
            plain: |most, starts| growth($starts($method, $h, starts), most),
            compensated: |most, starts| growth($starts($method, $h, starts).into_iter().map(Integrator::compensated).collect(), most),
        } ),+),*] };
    }
    walks! {
        "pendulum", pendulums: StormerVerlet, 1e-7, BlanesMoanSrkn14a, 0.003, Gauss::<3>, 0.003, DiscreteGradient, 0.02;
        "Kepler", orbits: StormerVerlet, 1e-7, BlanesMoanSrkn14a, 0.003, Gauss::<3>, 0.003, DiscreteGradient, 0.02;
    }
}
