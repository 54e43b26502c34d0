//! Compares a flow with its differential equation, and with the properties of all canonical flows.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::system::Hamiltonian;
use geoint_runtime::system::Pieces;
use geoint_runtime::{Coordinates, Real, StepError};
use geoint_tests::measure::{Noise, extrapolated};
use geoint_tests::scalars::{Double, Dual, Scalar};

/// An energy of one piece, its report and the expected rule.
pub(super) struct Instance {
    pub(super) name: &'static str,
    pub(super) report: &'static str,
    pub(super) rule: &'static str,
}

/// The systems whose flows are tested.
pub(super) trait Closed<const N: usize>: Over<f64, N> + Over<Double, N> + Over<Dual, N> {}
impl<const N: usize, S> Closed<N> for S where S: Over<f64, N> + Over<Double, N> + Over<Dual, N> {}

/// A system in pieces, with N positions.
pub(super) trait Over<R: Real, const N: usize>:
    Pieces<PieceSplitting, R> + Hamiltonian<R, Array = [R; N]>
{
}
impl<R: Real, const N: usize, S: Pieces<PieceSplitting, R> + Hamiltonian<R, Array = [R; N]>> Over<R, N> for S {}

/// The largest accepted error, in units of the condition times ε.
const BOUND: f64 = 4.0;
/// Start time of the flows.
const START: f64 = 0.5;

/// Checks a flow: the rule in the report, the solution, the derivative by h (q' = ∂H/∂p and p' = −∂H/∂q), and symplecticity.
pub(super) fn check<const N: usize, S: Closed<N>>(instance: &Instance, system: S) -> Result<(), String> {
    let Instance { name, report, rule } = instance;
    let pieces = <S as Pieces<PieceSplitting, f64>>::PIECES;
    if pieces.len() != 1 || !report.contains(&format!("\n  {rule}: ")) {
        return Err(format!("{name}: {report}"));
    }
    let mut noise = Noise::new(7);
    let (mut worst, mut rate, mut form) = (0.0_f64, 0.0_f64, 0.0_f64);
    for point in 0..4 + 2 * N {
        let scale = if point == 3 { 1e-7 } else { 0.8 };
        let mut x: Vec<f64> = (&mut noise).take(2 * N).map(|x| scale * x).collect();
        // Each coordinate is zero once.
        if point > 3 {
            x[point - 4] = 0.0;
        }
        for h in [0.3, -0.3, 1e-5] {
            let found = step(system, &x, START, h).map_err(|error| format!("{name}, h = {h}: {error}"))?;
            let (exact, condition) = solved(&system, &x, START, h);
            for i in 0..x.len() {
                let error = (Double::from(found[i]) - exact[i]).magnitude() / condition[i].max(1e-10);
                assert!(error.is_finite(), "{name}, h = {h}: {found:?}, not {exact:?} from {x:?}");
                worst = worst.max(error / f64::EPSILON);
            }
            // Dual numbers give wrong derivatives at points at which a helper function returns its limit.
            if point < 3 {
                rate = rate.max(rate_defect(system, &x, START, h));
                form = form.max(form_defect(system, &x, START, h));
            }
        }
    }
    println!("{name:28} {worst:6.2} ε  {rate:8.1e}  {form:8.1e}");
    let good = worst <= BOUND && rate <= 1e-12 && form <= 1e-13;
    if good { Ok(()) } else { Err(format!("{name}: {worst:.2} ε, d/dh {rate:.1e}, dp∧dq {form:.1e}")) }
}

/// One step of length h from x = (q, p).
pub(super) fn step<R: Scalar + From<f64>, const N: usize, S: Over<R, N>>(
    system: S,
    x: &[R],
    t: f64,
    h: impl Into<R>,
) -> Result<Vec<R>, StepError> {
    let state = State::at(R::from_f64(t), point::<R, N, S>(&x[..N]), point::<R, N, S>(&x[N..]));
    let mut sim = Integrator::new(system, PieceSplitting, h.into(), state);
    let outcome = sim.step();
    let state = sim.state();
    let end = [state.q.into_array().as_slice(), state.p.into_array().as_slice()].concat();
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

/// q' = ∂H/∂p, p' = −∂H/∂q.
pub(super) fn field<R: Scalar, const N: usize, S: Over<R, N>>(system: &S, t: R, x: &[R]) -> Vec<R> {
    let zero = [R::from_f64(0.0); N];
    let (mut z, mut slopes) = ([zero; 2], [zero; 2]);
    z.as_flattened_mut().copy_from_slice(x);
    system.gradient(t, &z, &mut slopes);
    let [by_q, by_p] = slopes;
    by_p.into_iter().chain(by_q.into_iter().map(|force| -force)).collect()
}

/// Returns the solution after h, and the condition of each component. The condition is the sensitivity to relative changes of x, t, h and the component
/// itself.
fn solved<const N: usize, S: Over<Double, N>>(system: &S, x: &[f64], t: f64, h: f64) -> (Vec<Double>, Vec<f64>) {
    const GAP: f64 = 1e-10;
    const PARTS: usize = 4;
    let solve =
        |t: Double, x: Vec<Double>| extrapolated(|t, x: &[Double]| field(system, t, x), t, x, Double::from(h), PARTS);
    let (t, x) = (Double::from(t), x.iter().map(|x| Double::from(*x)).collect::<Vec<_>>());
    let exact = solve(t, x.clone());
    let mut condition: Vec<f64> = exact.iter().map(|x| x.magnitude()).collect();
    let mut count = |moved: Vec<Double>| {
        for (sum, (moved, exact)) in condition.iter_mut().zip(moved.iter().zip(&exact)) {
            *sum += (*moved - *exact).magnitude() / GAP;
        }
    };
    for j in 0..x.len() {
        let mut x = x.clone();
        x[j] *= Double::from(1.0 + GAP);
        count(solve(t, x));
    }
    count(solve(t * Double::from(1.0 + GAP), x.clone()));
    for (sum, rate) in condition.iter_mut().zip(field(system, t + Double::from(h), &exact)) {
        *sum += rate.magnitude() * h.abs();
    }
    (exact, condition)
}

/// Returns the distance between the derivative of a step by its length and J∇H at its end, relative to the size.
fn rate_defect<const N: usize, S: Closed<N>>(system: S, x: &[f64], t: f64, h: f64) -> f64 {
    let duals: Vec<Dual> = x.iter().map(|x| Dual::from(*x)).collect();
    let end = step(system, &duals, t, Dual::variable(h)).expect("a step");
    let place: Vec<f64> = end.iter().map(|x| x.value()).collect();
    let field = field(&system, t + h, &place);
    let size = 1.0 + field.iter().fold(0.0_f64, |size, rate| size.max(rate.abs()));
    end.iter().zip(field).map(|(end, rate)| (end.derivative() - rate).abs() / size).fold(0.0, f64::max)
}

/// Returns the largest entry of MᵀJM − J for the derivative M of the step, relative to the squared entries of M.
fn form_defect<const N: usize, S: Closed<N>>(system: S, x: &[f64], t: f64, h: f64) -> f64 {
    let columns: Vec<Vec<f64>> = (0..x.len())
        .map(|j| {
            let mut x: Vec<Dual> = x.iter().map(|x| Dual::from(*x)).collect();
            x[j] = Dual::variable(x[j].value());
            step(system, &x, t, h).expect("a step").iter().map(|x| x.derivative()).collect()
        })
        .collect();
    let size = columns.iter().flatten().fold(1.0_f64, |size, entry| size.max(entry * entry));
    let mut defect = 0.0_f64;
    for (i, a) in columns.iter().enumerate() {
        for (j, b) in columns.iter().enumerate() {
            let form: f64 = (0..N).map(|k| a[k] * b[N + k] - a[N + k] * b[k]).sum();
            let expected = if j == i + N {
                1.0
            } else if i == j + N {
                -1.0
            } else {
                0.0
            };
            defect = defect.max((form - expected).abs() / size);
        }
    }
    defect
}
