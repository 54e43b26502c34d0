//! S24: the action s(T) of Herglotz' principle is stationary under variations of the curve, and so is its discrete sum.

use geoint_runtime::Lagrangian;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::measure::extrapolated;
use geoint_tests::scalars::Dual;
use geoint_tests::scenes::contact_field;
use std::f64::consts::PI;

/// A pendulum with friction that grows with the action.
#[lagrangian]
fn braked(q: f64, v: f64, s: f64, a: f64, b: f64) -> f64 {
    v * v / 2.0 + q.cos() - a * s - b * s * s / 2.0
}

/// The same pendulum with friction in proportion to the velocity.
#[lagrangian]
fn damped(q: f64, v: f64, s: f64, a: f64) -> f64 {
    v * v / 2.0 + q.cos() - a * s
}

/// Coefficients of friction.
const A: f64 = 0.1;
const B: f64 = 0.05;

/// Duration of the variation.
const T: f64 = 2.0;

/// Number of steps of the discrete sums.
const STEPS: usize = 20;
const H: f64 = 0.1;

/// Position, velocity and action at the start.
const START: [f64; 3] = [1.0, 0.5, 0.3];

/// Returns s(T) along q(t) + ε sin(πt/T), with s' = L. The curve q(t) solves the equations of a pendulum `along`, L is that of [`Braked`] with A and B.
fn action(along: Braked<f64>, epsilon: f64) -> f64 {
    let system = Braked { a: A, b: B };
    // Coordinates: q, p = v and the action of the curve, then the action of the curve that is varied.
    let field = |t: f64, x: &[f64]| {
        let mut rate = contact_field(&along, t, &x[..3]);
        let w = PI / T;
        let (q, v) = (x[0] + epsilon * (w * t).sin(), rate[0] + epsilon * w * (w * t).cos());
        rate.push(system.lagrangian(t, q, v, x[3]));
        rate
    };
    let [q, v, s] = START;
    extrapolated(field, 0.0, vec![q, v, s, s], T, 8)[3]
}

#[test]
fn the_action_is_stationary_along_solutions() {
    let solution = Braked { a: A, b: B };
    let frictionless = Braked { a: 0.0, b: 0.0 };
    let unvaried = action(solution, 0.0);
    assert!((unvaried - 1.587_279_100_961).abs() < 1e-12, "{unvaried}");
    let changes = |along: Braked<f64>| [0.1, 0.05, 0.025].map(|e| action(along, e) - action(along, 0.0));
    let [stationary, control] = [changes(solution), changes(frictionless)];
    for (found, noted) in
        [(stationary, [8.4226e-3, 2.0916e-3, 5.2116e-4]), (control, [1.4946e-2, 5.3466e-3, 2.1469e-3])]
    {
        assert!(found.iter().zip(noted).all(|(found, noted)| (found / noted - 1.0).abs() < 3e-5), "{found:?}");
    }
    // Half the variation changes s(T) by a quarter; on the curve without friction the ratio tends to two.
    for (ratio, of_control) in [(0, 1), (1, 2)].map(|(i, j)| (stationary[i] / stationary[j], control[i] / control[j])) {
        assert!((ratio - 4.0).abs() < 0.03 && of_control < 2.8, "{ratio} {of_control}");
    }
}

/// Returns the discrete action after all steps. `step` maps (q₀, q₁, s₀) to s₁.
fn sum(points: &[Dual], step: impl Fn(Dual, Dual, Dual) -> Dual) -> Dual {
    points.windows(2).fold(START[2].into(), |s, q| step(q[0], q[1], s))
}

/// Returns the discrete action and its largest derivative by an inner point.
fn slopes(points: &[f64], step: impl Fn(Dual, Dual, Dual) -> Dual) -> (f64, f64) {
    let mut dual: Vec<Dual> = points.iter().map(|q| Dual::from(*q)).collect();
    let mut largest = 0.0_f64;
    for k in 1..points.len() - 1 {
        dual[k] = Dual::variable(points[k]);
        largest = largest.max(sum(&dual, &step).derivative().abs());
        dual[k] = points[k].into();
    }
    (sum(&dual, &step).value(), largest)
}

/// Positions of a run, with that of the start.
fn positions<S, M>(system: S, method: M, start: ContactState<f64>) -> Vec<f64>
where
    S: geoint_runtime::Contact<Coordinates = f64>,
    M: Method<S>,
{
    let mut sim = Integrator::new(system, method, H, start);
    let run = (0..STEPS).map(|_| {
        sim.step().expect("a step");
        sim.state().q
    });
    [start.q].into_iter().chain(run).collect()
}

/// L of a system over dual numbers.
fn lagrangian<S>(system: &S, q: Dual, v: Dual, s: Dual) -> Dual
where
    S: Lagrangian<Dual, Array = [Dual; 1], Action = Dual>,
{
    system.lagrangian(0.0.into(), &[q], &[v], &s)
}

/// s₁ = s₀ + h L((q₀ + q₁)/2, (q₁ − q₀)/h, (s₀ + s₁)/2), an equation for s₁.
fn midpoint(q: Dual, r: Dual, s: Dual) -> Dual {
    let system = Braked { a: Dual::from(A), b: Dual::from(B) };
    let mut end = s;
    // The contraction is by h(a + bs)/2 < 0.01.
    for _ in 0..20 {
        end = s + lagrangian(&system, (q + r) * 0.5, (r - q) / H, (s + end) * 0.5) * H;
    }
    end
}

/// s₁ = s₀ + h (L(q₀, v, s₀) + L(q₁, v, s₁))/2 with v = (q₁ − q₀)/h.
fn trapezoid(q: Dual, r: Dual, s: Dual) -> Dual {
    let system = Damped { a: Dual::from(A) };
    let v = (r - q) / H;
    let [first, last] = [lagrangian(&system, q, v, s), lagrangian(&system, r, v, 0.0.into())];
    (s + (first + last) * (H / 2.0)) / (1.0 + H * A / 2.0)
}

#[test]
fn the_discrete_action_of_the_midpoint_rule_is_stationary() {
    let ([q, v, s], system) = (START, Braked { a: A, b: B });
    let start = system.at(q, v, s);
    let (action, slope) = slopes(&positions(system, ContactMidpoint, start), midpoint);
    assert!((action - 1.587_260_575_0).abs() < 1e-10, "{action}");
    assert!(slope < 5e-15, "{slope:e}");
    // Control: points of the motion without friction.
    let (_, slope) = slopes(&positions(Braked { a: 0.0, b: 0.0 }, ContactGauss::<6>, start), midpoint);
    assert!((slope / 1.742e-2 - 1.0).abs() < 1e-3, "{slope:e}");
}

#[test]
fn the_discrete_action_of_the_leapfrog_is_stationary() {
    let ([q, v, s], system) = (START, Damped { a: A });
    let (action, slope) = slopes(&positions(system, ContactLeapfrog, system.at(q, v, s)), trapezoid);
    assert!((action - 1.638_083_458_1).abs() < 1e-10, "{action}");
    assert!(slope < 5e-15, "{slope:e}");
    // Control: leapfrog with friction −ap as one more force of each kick.
    let (mut q, mut p) = (q, v);
    let mut points = vec![q];
    for _ in 0..STEPS {
        p -= H / 2.0 * (q.sin() + A * p);
        q += H * p;
        p -= H / 2.0 * (q.sin() + A * p);
        points.push(q);
    }
    let (_, slope) = slopes(&points, trapezoid);
    assert!((slope / 1.961e-4 - 1.0).abs() < 1e-3, "{slope:e}");
}
