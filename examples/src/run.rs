//! Runs of a system, and numbers about them.

use geoint_runtime::running::{Scalar, Trajectory};
use geoint_runtime::system::StateOf;
use geoint_runtime::{Method, PhaseSpace, StepError};

/// Returns the states after 0, 1, 2, … steps up to a time.
///
/// # Errors
/// The first error of a step.
pub fn orbit<S: PhaseSpace, M: Method<S, f64>>(
    system: S,
    method: M,
    h: f64,
    start: StateOf<S, f64>,
    duration: f64,
) -> Result<Vec<StateOf<S, f64>>, StepError> {
    let mut sim = geoint_runtime::Integrator::new(system, method, h, start);
    let later = sim.sampled(1).take((duration / h).round() as usize);
    std::iter::once(Ok(start)).chain(later).collect()
}

/// A time of a run, and the largest changes of functions of the state up to this time.
pub type Sample<T, const N: usize> = (Scalar<T>, [f64; N]);

/// Advances a run and returns samples, about twenty in each decade of steps. A sample has a time and the largest changes of
/// `functions` so far.
///
/// # Errors
/// The first error of a step.
pub fn changes<T: Trajectory, const N: usize>(
    run: &mut T,
    steps: u64,
    functions: impl Fn(&T::State) -> [f64; N],
) -> Result<Vec<Sample<T, N>>, StepError> {
    let before = functions(&run.state());
    let (mut so_far, mut samples, mut due) = ([0.0; N], vec![], 0);
    for n in 1..=steps {
        run.step()?;
        let after = functions(&run.state());
        so_far = std::array::from_fn(|i| largest([so_far[i], after[i] - before[i]]));
        if n >= due || n == steps {
            samples.push((run.time(), so_far));
            due = n + n.div_ceil(9);
        }
    }
    Ok(samples)
}

/// Returns the largest absolute value, or NaN if a value is NaN.
pub fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |largest, x| if x.abs() > largest || x.is_nan() { x.abs() } else { largest })
}

/// Returns the observed order from the errors at the step sizes h and h/2.
pub fn order(whole: f64, half: f64) -> f64 {
    (whole / half).log2()
}
