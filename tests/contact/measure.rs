//! What is measured of steps of contact systems.

use geoint_runtime::prelude::*;
use geoint_runtime::space::{Array, Snapshot};
use geoint_runtime::{Contact, Coordinates};
use geoint_tests::measure::extrapolated;
use geoint_tests::scalars::{Double, Dual, Scalar};

/// A state as a list: q, p, s.
pub(crate) fn flat<Q: Coordinates>(state: &ContactState<Q>) -> Vec<Q::Real> {
    [state.q.into_array().as_slice(), state.p.into_array().as_slice(), &[state.s]].concat()
}

/// A list as a state.
pub(crate) fn state<Q: Coordinates>(t: Q::Real, x: &[Q::Real]) -> ContactState<Q> {
    let n = Q::Array::LEN;
    let coordinates = |x: &[Q::Real]| {
        let mut array = Q::Array::zero();
        array.as_mut_slice().copy_from_slice(x);
        Q::from_array(array)
    };
    ContactState::at(t, coordinates(&x[..n]), coordinates(&x[n..2 * n]), x[2 * n])
}

/// q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H.
pub(crate) fn field<R: Scalar, S: Contact<R>>(system: &S, t: R, x: &[R]) -> Vec<R> {
    let (_, z, s) = state::<S::Coordinates>(t, x).parts();
    let energy = system.hamiltonian(t, &z, &s);
    let (mut slopes, mut ds) = (S::Phase::zero(), R::from_f64(0.0));
    system.gradient(t, &z, &s, &mut slopes, &mut ds);
    let (p, dq, dp) = (z[1].as_slice(), slopes[0].as_slice(), slopes[1].as_slice());
    let power = p.iter().zip(dp).fold(R::from_f64(0.0), |sum, (p, rate)| sum + *p * *rate);
    let forces = p.iter().zip(dq).map(|(p, slope)| -*slope - *p * ds);
    dp.iter().copied().chain(forces).chain([power - energy]).collect()
}

/// The solution after `duration`, to some twenty digits.
pub(crate) fn solution<S: Contact<Double>>(system: &S, t: f64, x: &[f64], duration: f64, parts: usize) -> Vec<Double> {
    let x = x.iter().map(|x| Double::from(*x)).collect();
    extrapolated(|t, x| field(system, t, x), Double::from(t), x, Double::from(duration), parts)
}

/// q, p and s after some steps.
pub(crate) fn run<R: Scalar, S: Contact<R>, M: Method<S, R>>(
    system: S,
    method: M,
    (t, x): (f64, &[R]),
    h: f64,
    steps: u64,
) -> Result<Vec<R>, StepError> {
    let start = state::<S::Coordinates>(R::from_f64(t), x);
    let mut sim = Integrator::new(system, method, R::from_f64(h), start);
    sim.advance(steps)?;
    Ok(flat(&sim.state()))
}

/// How far ds − p dq is, after some steps, from a multiple of what it was: by derivatives of the steps.
pub(crate) fn form_defect<S: Contact<Dual>, M: Method<S, Dual>>(
    system: S,
    method: M,
    (t, x): (f64, &[f64]),
    h: f64,
    steps: u64,
) -> Result<f64, StepError> {
    let n = S::Array::LEN;
    let mut forms = vec![];
    for j in 0..x.len() {
        let mut x: Vec<Dual> = x.iter().map(|x| Dual::from(*x)).collect();
        x[j] = Dual::variable(x[j].value());
        let end = run(system, method, (t, &x), h, steps)?;
        let along: f64 = (0..n).map(|i| end[n + i].value() * end[i].derivative()).sum();
        forms.push(end[2 * n].derivative() - along);
    }
    let factor = forms[2 * n];
    let before = |j: usize| if j < n { -x[n + j] } else { 0.0 };
    Ok((0..2 * n).map(|j| (forms[j] - factor * before(j)).abs()).fold(0.0, f64::max))
}
