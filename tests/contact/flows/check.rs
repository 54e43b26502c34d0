//! Compares a flow with its differential equation, and checks the common properties of all contact flows.

use crate::measure::field;
use geoint_runtime::method::SteppedAs;
use geoint_runtime::prelude::*;
use geoint_runtime::system::Contact;
use geoint_runtime::system::{Clock, Pieces};
use geoint_runtime::{Coordinates, PhaseSpace, Real, StepError};
use geoint_tests::measure::{Noise, extrapolated};
use geoint_tests::scalars::{Double, Dual, Scalar};

/// An energy of one piece, its report, and the rule of its flow.
pub(super) struct Instance {
    pub(super) name: &'static str,
    pub(super) report: &'static str,
    pub(super) rule: &'static str,
}

/// The systems whose flows are tested.
pub(super) trait Closed<const N: usize>: Over<f64, N> + Over<Double, N> + Over<Dual, N> {}
impl<const N: usize, S> Closed<N> for S where S: Over<f64, N> + Over<Double, N> + Over<Dual, N> {}

/// A contact system in pieces, with N positions.
pub(super) trait Over<R: Real, const N: usize>:
    Pieces<ContactSplitting, R> + SteppedAs<ContactSplitting, R> + Contact<R, Array = [R; N]>
{
}
impl<R: Real, const N: usize, S> Over<R, N> for S where
    S: Pieces<ContactSplitting, R> + SteppedAs<ContactSplitting, R> + Contact<R, Array = [R; N]>
{
}

/// The largest error, in units of the condition.
const BOUND: f64 = 3.0;
/// When the flows start.
const START: f64 = 0.5;

/// Checks the rule of a flow, the equations q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H, and the contact form.
pub(super) fn check<const N: usize, S: Closed<N>>(instance: &Instance, system: S) -> Result<(), String> {
    let Instance { name, report, rule } = instance;
    let pieces = <S as Pieces<ContactSplitting, f64>>::PIECES;
    if pieces.len() != 1 || pieces[0].clock != Clock::Own || !report.contains(&format!("\n  {rule}: ")) {
        return Err(format!("{name}: {report}"));
    }
    let mut noise = Noise::new(7);
    let (mut worst, mut form) = (0.0_f64, 0.0_f64);
    for point in 0..4 + 2 * N + 1 {
        let scale = if point == 3 { 1e-7 } else { 0.8 };
        let mut x: Vec<f64> = (&mut noise).take(2 * N + 1).map(|x| scale * x).collect();
        // Each coordinate once at zero.
        if point > 3 {
            x[point - 4] = 0.0;
        }
        gradient(name, system, &x);
        for h in [0.3, -0.3, 1e-5] {
            let found = step(system, &x, START, h).map_err(|error| format!("{name}, h = {h}: {error}"))?;
            let (exact, mut condition) = solved(&system, &x, START, h);
            if *rule == "Legendre conjugate" {
                // s − q·p is formed.
                condition[2 * N] += (0..N).map(|i| (x[i] * x[N + i]).abs()).sum::<f64>();
            }
            for i in 0..x.len() {
                let error = (Double::from(found[i]) - exact[i]).magnitude() / condition[i].max(1e-10);
                assert!(error.is_finite(), "{name}, h = {h}");
                worst = worst.max(error / f64::EPSILON);
            }
            // Derivatives are wrong where the value of a helper is its limit.
            if point < 3 {
                form = form.max(form_defect(system, &x, START, h));
            }
        }
    }
    println!("{name:28} {worst:6.2} ε  {form:8.1e}");
    if worst <= BOUND && form <= 1e-13 { Ok(()) } else { Err(format!("{name}: {worst:.2} ε, ds − p dq {form:.1e}")) }
}

/// One step from x = (q, p, s).
pub(super) fn step<R: Scalar, const N: usize, S>(system: S, x: &[R], t: f64, h: f64) -> Result<Vec<R>, StepError>
where
    S: Over<R, N>,
{
    let state = ContactState::at(R::from_f64(t), point::<R, N, S>(&x[..N]), point::<R, N, S>(&x[N..2 * N]), x[2 * N]);
    let mut sim = Integrator::new(system, ContactSplitting, R::from_f64(h), state);
    let outcome = sim.step();
    let state = sim.state();
    let end = [state.q.into_array().as_slice(), state.p.into_array().as_slice(), &[state.s]].concat();
    if outcome.is_err() {
        assert_eq!(end, x, "the state has moved");
    }
    outcome.map(|()| end)
}

fn point<R: Scalar, const N: usize, S: Over<R, N>>(x: &[R]) -> S::Coordinates {
    let mut array = [R::from_f64(0.0); N];
    array.copy_from_slice(x);
    S::Coordinates::from_array(array)
}

/// The solution after h, and how much each of its components changes with relative changes of x, t and h, and of itself.
fn solved<const N: usize, S: Contact<Double, Array = [Double; N]>>(
    system: &S,
    x: &[f64],
    t: f64,
    h: f64,
) -> (Vec<Double>, Vec<f64>) {
    const GAP: f64 = 1e-10;
    let doubles = |x: &[f64]| x.iter().map(|x| Double::from(*x)).collect::<Vec<_>>();
    let solve =
        |t: Double, x: Vec<Double>, parts| extrapolated(|t, x| field(system, t, x), t, x, Double::from(h), parts);
    let (t, x) = (Double::from(t), doubles(x));
    // Doubles the number of parts until the solution no longer changes in the digits that count.
    let mut parts = 1;
    let mut exact = solve(t, x.clone(), parts);
    loop {
        let finer = solve(t, x.clone(), 2 * parts);
        if finer
            .iter()
            .zip(&exact)
            .all(|(finer, coarser)| (*finer - *coarser).magnitude() <= 1e-19 * finer.magnitude() + 1e-27)
        {
            break;
        }
        (parts, exact) = (2 * parts, finer);
        assert!(parts <= 256, "no solution to compare with");
    }
    let mut condition: Vec<f64> = exact.iter().map(|x| x.magnitude()).collect();
    let exact_in_one = if parts == 1 { exact.clone() } else { solve(t, x.clone(), 1) };
    let mut count = |moved: Vec<Double>| {
        for (sum, (moved, exact)) in condition.iter_mut().zip(moved.iter().zip(&exact_in_one)) {
            *sum += (*moved - *exact).magnitude() / GAP;
        }
    };
    for j in 0..x.len() {
        let mut x = x.clone();
        x[j] *= Double::from(1.0 + GAP);
        count(solve(t, x, 1));
    }
    count(solve(t * (1.0 + GAP), x.clone(), 1));
    for (sum, rate) in condition.iter_mut().zip(field(system, t + h, &exact)) {
        *sum += rate.magnitude() * h.abs();
    }
    (exact, condition)
}

/// Asserts that the gradient is the derivative of the energy.
fn gradient<const N: usize, S: Closed<N>>(name: &str, system: S, x: &[f64]) {
    let (mut z, mut slopes, mut ds) = ([[0.0; N]; 2], [[0.0; N]; 2], 0.0);
    z.as_flattened_mut().copy_from_slice(&x[..2 * N]);
    Contact::<f64>::gradient(&system, START, &z, &x[2 * N], &mut slopes, &mut ds);
    for (j, found) in slopes.as_flattened().iter().copied().chain([ds]).enumerate() {
        let mut x: Vec<Dual> = x.iter().map(|x| Dual::from(*x)).collect();
        x[j] = Dual::variable(x[j].value());
        let z = [0, N].map(|first| std::array::from_fn(|i| x[first + i]));
        let energy = PhaseSpace::<Dual>::hamiltonian(&system, START.into(), &z, &x[2 * N]);
        let error = (energy.derivative() - found).abs();
        assert!(error <= 1e-14 * (1.0 + found.abs()), "{name}: {found} {}", energy.derivative());
    }
}

/// Returns the distance of ds − p dq after the step from a multiple of its value before, by derivatives of the step.
fn form_defect<const N: usize, S: Closed<N>>(system: S, x: &[f64], t: f64, h: f64) -> f64 {
    let columns: Vec<Vec<Dual>> = (0..x.len())
        .map(|j| {
            let mut x: Vec<Dual> = x.iter().map(|x| Dual::from(*x)).collect();
            x[j] = Dual::variable(x[j].value());
            step(system, &x, t, h).expect("a step")
        })
        .collect();
    let form = |column: &Vec<Dual>| {
        let parts: Vec<f64> = (0..N).map(|i| -column[N + i].value() * column[i].derivative()).collect();
        let s = column[2 * N].derivative();
        (s + parts.iter().sum::<f64>(), 1.0 + s.abs() + parts.iter().map(|x| x.abs()).sum::<f64>())
    };
    let (factor, _) = form(&columns[2 * N]);
    let mut defect = 0.0_f64;
    for (j, column) in columns.iter().enumerate().take(2 * N) {
        let (value, size) = form(column);
        let expected = if j < N { -factor * x[N + j] } else { 0.0 };
        defect = defect.max((value - expected).abs() / size);
    }
    defect
}
