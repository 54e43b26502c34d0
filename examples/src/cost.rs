//! What a run costs: time, and looks at the energy.

use geoint_runtime::method::{Probe, Refusal};
use geoint_runtime::space::Coordinates;
use geoint_runtime::space::{Plain, Point};
use geoint_runtime::{Hamiltonian, Method, State};
use std::time::{Duration, Instant};

/// The shortest of ten runs: what else the machine does only ever adds.
///
/// # Errors
/// Those of `run`.
pub fn shortest<T, E>(mut run: impl FnMut() -> Result<T, E>) -> Result<Duration, E> {
    let mut shortest = Duration::MAX;
    for _ in 0..10 {
        let begin = Instant::now();
        run()?;
        shortest = shortest.min(begin.elapsed());
    }
    Ok(shortest)
}

/// At how many points Newton's iterations of an implicit method look at the energy in `steps` steps of length `h`.
///
/// # Errors
/// If one of them does not converge.
pub fn looks<S: Hamiltonian, M: Method<S, f64>>(
    system: S,
    method: M,
    h: f64,
    start: State<S::Coordinates>,
    steps: u64,
) -> Result<u64, String> {
    let mut prepared = method.prepare(&system, h);
    let mut x = Point::<S::Array, Plain>::new(start.q.into_array(), start.p.into_array());
    let mut looks = Looks(0);
    for n in 0..steps {
        let outcome = M::step(&mut prepared, start.t + n as f64 * h, &mut x, &mut looks);
        outcome.map_err(|refusal| match refusal {
            Refusal::NotConverged { iterations, .. } => format!("no convergence in {iterations} iterations"),
            Refusal::Singular => "no unique solution".into(),
            Refusal::SingularDirection => "an increment orthogonal to its direction".into(),
            Refusal::OutsideDomain { what } => what.into(),
        })?;
    }
    Ok(looks.0)
}

struct Looks(u64);

impl<S: Hamiltonian> Probe<S, f64> for Looks {
    fn look(&mut self, _: f64, _: &S::Array, _: &S::Array, _: &()) {
        self.0 += 1;
    }
}
