//! Measurements of steps of contact systems.

use geoint_runtime::Contact;
use geoint_runtime::prelude::*;
use geoint_tests::measure::extrapolated;
use geoint_tests::scalars::{Double, Scalar};
pub(crate) use geoint_tests::scene::{flat, point as state};
pub(crate) use geoint_tests::scenes::contact_field as field;

/// The solution after `duration`, to some twenty digits.
pub(crate) fn solution<S: Contact<Double>>(system: &S, t: f64, x: &[f64], duration: f64, parts: usize) -> Vec<Double> {
    let x = x.iter().map(|x| Double::from(*x)).collect();
    extrapolated(|t, x| field(system, t, x), Double::from(t), x, Double::from(duration), parts)
}

/// q, p and s after some steps.
pub(crate) fn run<R: Scalar, S: PhaseSpace<R>, M: Method<S, R>>(
    system: S,
    method: M,
    (t, x): (f64, &[R]),
    h: f64,
    steps: u64,
) -> Result<Vec<R>, StepError> {
    let start = state(R::from_f64(t), x);
    let mut sim = Integrator::new(system, method, R::from_f64(h), start);
    sim.advance(steps)?;
    Ok(flat(&sim.state()))
}
