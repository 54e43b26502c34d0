//! Measures the cost of a run: its time, and its evaluations of the energy.

use geoint_runtime::method::{Observer, Probe, Step};
use geoint_runtime::space::{Coordinates, Plain, Point};
use geoint_runtime::{Hamiltonian, Method, State};
use std::time::{Duration, Instant};

/// Returns the shortest time of ten runs. Other work of the machine can only make a run longer.
///
/// # Errors
/// The first error of `run`.
pub fn shortest<T, E>(mut run: impl FnMut() -> Result<T, E>) -> Result<Duration, E> {
    let mut shortest = Duration::MAX;
    for _ in 0..10 {
        let begin = Instant::now();
        run()?;
        shortest = shortest.min(begin.elapsed());
    }
    Ok(shortest)
}

/// Counts the points at which Newton's iterations of an implicit method evaluate the energy, in `steps` steps of length `h`.
///
/// # Errors
/// If a Newton iteration does not converge.
pub fn evaluations<S: Hamiltonian, M: Method<S, f64>>(
    system: S,
    method: M,
    h: f64,
    start: State<S::Coordinates>,
    steps: u64,
) -> Result<u64, String> {
    let mut x = Point::<S::Phase, Plain>::new([start.q.into_array(), start.p.into_array()]);
    let (prepared, mut memory) = (method.prepare(&system, h), M::memory(&x.z));
    let mut count = Count(0);
    for n in 0..steps {
        let [t, end] = [n, n + 1].map(|n| start.t + n as f64 * h);
        let step = Step { system: &system, t, end, x: &mut x, probe: &mut count };
        let outcome = M::step(&prepared, &mut memory, step);
        outcome.map_err(|refusal| refusal.to_string())?;
    }
    Ok(count.0)
}

struct Count(u64);

impl Observer for Count {
    fn pause(&mut self, _: bool) {}
}

impl<S: Hamiltonian> Probe<S, f64> for Count {
    fn visit(&mut self, _: f64, _: &S::Phase, _: &()) {
        self.0 += 1;
    }
}
