//! Taylor series: orders with steps of fixed length, and errors with steps from a tolerance.

use crate::page::{Page, short};
use geoint_runtime::private::{Jets, TaylorMethod};
use geoint_runtime::system::StateOf;
use geoint_runtime::{Taylor, TaylorFixed, TaylorIntegrator, TaylorOrder};
use geoint_tests::counting::allocations_during;
use geoint_tests::measure::{LOOKS, Observed, distance, observed, solutions};
use geoint_tests::problems::{DoublePendulum, HenonHeiles};
use geoint_tests::scalars::{Double, Scalar};
use geoint_tests::scene::{Scene, flat, point};
use std::hint::black_box;

/// Durations with step lengths that are exact in `f64`.
const DURATIONS: [f64; 2] = [6.0, 1.5];
/// Accepted distance between an observed order and the order of the series.
const TOLERANCE: f64 = 0.15;
/// From this order on, errors reach rounding before the leading term dominates. They may fall faster than the leading term, or slower by this amount.
const HIGH: usize = 8;
const ROUNDED: f64 = 1.0;
/// Recurrences divide by whole numbers with reciprocals in `f64`. Errors below this bound come from these reciprocals.
const RECIPROCALS: f64 = 4e-18;
/// Bound on the errors at the end of the runs above, in units of the tolerance or of rounding.
const WORST: f64 = 64.0;

fn started<P: Scene, M: TaylorMethod<P::Over<R>, R>, R: Scalar>(method: M) -> TaylorIntegrator<P::Over<R>, M, R>
where
    P::Over<R>: Jets<R>,
{
    let (t, x) = P::start();
    let x: Vec<R> = x.into_iter().map(R::from_f64).collect();
    TaylorIntegrator::new(P::over::<R>(), method, point::<StateOf<P::Over<R>, R>>(R::from_f64(t), &x))
}

/// Returns the root-mean-square error over the times of the other tables. It is infinite if a step is refused.
fn error<P: Scene, M: TaylorMethod<P::Over<Double>, Double>>(method: M, duration: f64, solutions: &[Vec<Double>]) -> f64
where
    P::Over<Double>: Jets<Double>,
{
    let mut sim = started::<P, M, Double>(method);
    let mut sum = 0.0;
    for (look, expected) in (1..=LOOKS).zip(solutions) {
        let t = Double::from(P::start().0) + Double::from(duration) * look as f64 / LOOKS as f64;
        if sim.advance_to(t).is_err() {
            return f64::INFINITY;
        }
        sum += distance(&flat(&sim.state()), expected).powi(2);
    }
    (sum / LOOKS as f64).sqrt()
}

fn order<P: Scene, const N: usize>(duration: f64, solutions: &[Vec<Double>]) -> Observed
where
    P::Over<Double>: Jets<Double>,
{
    observed(|n| error::<P, _>(TaylorFixed::<N> { h: duration / n as f64 }, duration, solutions).max(RECIPROCALS))
}

/// Returns the error at the end in `f64` relative to the state, the number of steps, and the number of allocations.
fn run<P: Scene, M: TaylorMethod<P::Over<f64>>>(method: M, duration: f64, solutions: &[Vec<Double>]) -> (f64, u64, u64)
where
    P::Over<f64>: Jets<f64>,
{
    let mut sim = started::<P, M, f64>(method);
    let end = P::start().0 + duration;
    let mut result = Ok(());
    let allocations = allocations_during(|| result = black_box(sim.advance_to(end)));
    let expected: Vec<f64> = solutions.last().into_iter().flatten().map(|x| x.value()).collect();
    let size = expected.iter().map(|x| x * x).sum::<f64>().sqrt();
    let error = if result.is_ok() { distance(&flat(&sim.state()), &expected) / size } else { f64::INFINITY };
    (error, sim.steps(), allocations)
}

/// Writes both tables.
pub(crate) fn section(page: &mut Page) {
    page.section(
        3,
        "Taylor series",
        "The runs of `system.taylor` are in no list of the catalogue, because a step is not a map of fixed length. The first table has steps of \
         fixed length on henon_heiles and double_pendulum, in double-double arithmetic. The second table has steps that follow from a tolerance, \
         in f64. Its columns have the error at the end of the same runs, relative to the state, and the number of steps.",
    );
    let [first, second] = [solutions::<HenonHeiles>(DURATIONS[0], 16), solutions::<DoublePendulum>(DURATIONS[1], 16)];
    macro_rules! orders {
        ($($order:literal)*) => {
            [$( ($order, [order::<HenonHeiles, $order>(DURATIONS[0], &first), order::<DoublePendulum, $order>(DURATIONS[1], &second)]) ),*]
        };
    }
    let orders = orders![2 4 8 12 16];
    page.table(
        ["method", "order", "observed", "constants"],
        orders.iter().map(|(order, seen)| {
            let constants: Vec<String> = seen
                .iter()
                .zip(DURATIONS)
                .map(|(seen, duration)| short(seen.constant(duration, *order as u32)))
                .collect();
            let seen: Vec<String> = seen.iter().map(|seen| short(seen.order)).collect();
            [format!("`TaylorFixed<{order}>`"), order.to_string(), seen.join(", "), constants.join(", ")]
        }),
    );
    for (order, seen) in &orders {
        for Observed { order: seen, .. } in seen {
            let excess = seen - *order as f64;
            let good = if *order < HIGH { excess.abs() <= TOLERANCE } else { excess.is_nan() || excess >= -ROUNDED };
            page.claim(good, format_args!("TaylorFixed<{order}>: order {seen:.3} is observed"));
        }
    }
    let mut rows = vec![];
    macro_rules! runs {
        ($($name:literal $tolerance:literal: $method:expr;)*) => { $(
            let runs = [run::<HenonHeiles, _>($method, DURATIONS[0], &first), run::<DoublePendulum, _>($method, DURATIONS[1], &second)];
            for (error, _, allocations) in runs {
                let bound = WORST * f64::max($tolerance, f64::EPSILON);
                page.claim(error <= bound, format_args!("{} at {:.0e}: the error is {error:.1e}", $name, $tolerance));
                page.claim(allocations == 0, format_args!("{}: {allocations} allocations", $name));
            }
            let [errors, steps] = [runs.map(|run| short(run.0)), runs.map(|run| run.1.to_string())].map(|cells| cells.join(", "));
            rows.push([format!("`{}`", $name), format!("{:.0e}", $tolerance), errors, steps, runs[0].2.to_string()]);
        )* };
    }
    runs! {
        "Taylor" 1e-6: Taylor { tolerance: 1e-6 };
        "Taylor" 1e-9: Taylor { tolerance: 1e-9 };
        "Taylor" 1e-12: Taylor { tolerance: 1e-12 };
        "Taylor" 2e-16: Taylor::default();
        "TaylorOrder<8>" 1e-6: TaylorOrder::<8> { tolerance: 1e-6 };
        "TaylorOrder<12>" 1e-9: TaylorOrder::<12> { tolerance: 1e-9 };
        "TaylorOrder<28>" 2e-16: TaylorOrder::<28>::default();
    }
    page.table(["method", "tolerance", "error", "steps", "allocations"], rows);
}
