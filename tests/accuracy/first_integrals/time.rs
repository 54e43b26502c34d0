//! Integrals that read time, and integrals that change by a known amount.

use super::FOURTH;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::system::FirstIntegrals;

/// All that is listed reads time.
#[vector_field(keeps(ahead = m * x[0] - t * t, decayed = x[1] * (0.5 * t).exp()))]
fn timed(x: [f64; 2], t: f64, m: f64) -> [f64; 2] {
    [2.0 * t / m, -0.5 * x[1]]
}

/// One reads time, one does not.
#[vector_field(keeps(ahead = x[2] - t.sin(), energy = m * x[0] * x[0] + x[1] * x[1]))]
fn turning(x: [f64; 3], t: f64, m: f64) -> [f64; 3] {
    [x[1] * x[2], -m * x[0] * x[2], t.cos()]
}

/// A loss and a drive change what the rest keeps.
#[vector_field(keeps(work = (x[0] * x[0] + x[1] * x[1]) / 2.0, but = [c * (3.0 * t).cos(), -k * x[1]]))]
fn driven(x: [f64; 2], t: f64, c: f64, k: f64) -> [f64; 2] {
    [x[1] * (1.0 + x[0]) + c * (3.0 * t).cos(), -x[0] * (1.0 + x[0]) - k * x[1]]
}

/// The largest change of all integrals.
fn change<S, M, const N: usize>(system: S, method: M, h: f64, start: [f64; N]) -> Vec<f64>
where
    S: FirstIntegrals<State = FlowState<[f64; N]>>,
    M: Method<S>,
{
    let mut sim = Integrator::new(system, method, h, FlowState { t: 0.3, x: start });
    let values = |sim: &Integrator<S, M>| geoint_runtime::space::Array::as_slice(&sim.integrals()).to_vec();
    let before = values(&sim);
    let mut largest = vec![0.0_f64; before.len()];
    for _ in 0..100 {
        sim.step().unwrap_or_else(|error| panic!("{error}"));
        for (largest, (a, b)) in largest.iter_mut().zip(values(&sim).iter().zip(&before)) {
            *largest = largest.max((a - b).abs());
        }
    }
    largest
}

#[test]
fn integrals_may_read_time() {
    assert_eq!(<Timed as FirstIntegrals>::NAMES, ["ahead", "decayed"]);
    let (timed, turning) = (Timed { m: 1.5 }, Turning { m: 1.5 });
    for h in [0.05, -0.02] {
        for found in [
            change(timed, DiscreteGradient, h, [0.3, 0.7]),
            change(timed, FOURTH, h, [0.3, 0.7]),
            change(turning, DiscreteGradient, h, [0.3, 0.7, 0.1]),
            change(turning, FOURTH, h, [0.3, 0.7, 0.1]),
        ] {
            assert!(found.iter().all(|change| *change < 4e-14), "{h}: {found:?}");
        }
        // A projection conserves only integrals that do not read time.
        let projected = change(turning, Projection(RK4, Integrals), h, [0.3, 0.7, 0.1]);
        assert!(projected[1] < 4e-15 && projected[0] > 1e-13, "{projected:?}");
        let control = change(turning, RK4, h, [0.3, 0.7, 0.1]);
        assert!(control[1] > 1e-10, "{control:?}");
    }
}

/// A function of time alone times a coordinate.
#[vector_field(keeps(scaled = m * x[0] * (2.0 + t.cos())))]
fn breath(x: [f64; 1], t: f64, m: f64) -> [f64; 1] {
    [x[0] * t.sin() / (2.0 + t.cos())]
}

/// Returns the relative change of `scaled`.
fn off(breath: Breath, [start, end]: [&FlowState<[f64; 1]>; 2]) -> f64 {
    (breath.scaled(end) / breath.scaled(start) - 1.0).abs()
}

/// Returns the relative change of `scaled` after 10⁵ steps.
fn off_in_the_end<M: Method<Breath>>(method: M, h: f64) -> f64 {
    let (breath, start) = (Breath { m: 1.5 }, FlowState { t: 0.3, x: [0.7] });
    let mut sim = breath.integrator(method, h, start);
    sim.advance(100_000).unwrap_or_else(|error| panic!("{error}"));
    off(breath, [&start, &sim.state()])
}

/// Steps of 2.814 round t and t ± h/2 in the same way again and again. Divided differences of cos t between t ± h/2 let `scaled` drift by 1.3e-9 in
/// 10⁵ steps. Divided differences between the start and end times of steps let it drift by 2.5e-8.
#[test]
fn a_clock_that_shows_much_moves_no_integral() {
    for h in [0.05, 2.814, -2.89] {
        for found in [
            off_in_the_end(DiscreteGradient, h),
            off_in_the_end(FOURTH, h),
            off_in_the_end(Suzuki4.of(DiscreteGradient), h),
        ] {
            assert!(found < 5e-13, "{h}: {found:e}");
        }
    }
    let (turning, start) = (Turning { m: 1.5 }, FlowState { t: 0.3, x: [0.3, 0.7, 0.1] });
    let mut sim = turning.adaptive(DiscreteGradient, 1e-4, start);
    sim.advance_to(2e4).unwrap_or_else(|error| panic!("{error}"));
    let found = (turning.ahead(&sim.state()) - turning.ahead(&start)).abs();
    assert!(found < 5e-13 && sim.steps() > 10_000, "{found:e} in {} steps", sim.steps());
}

/// Checks the balance of each step, and its entry in the report.
#[test]
fn what_a_drive_changes_is_known() {
    let system = Driven { c: 0.4, k: 0.2 };
    for h in [0.1, -0.07] {
        let mut sim = system.integrator(DiscreteGradient, h, FlowState::new([0.3, 0.7]));
        for _ in 0..200 {
            let before = sim.state();
            sim.step().unwrap_or_else(|error| panic!("{error}"));
            let after = sim.state();
            let [x, y] = [0, 1].map(|i| (before.x[i] + after.x[i]) / 2.0);
            let gain = h * (0.4 * (3.0 * (before.t + h / 2.0)).cos() * x - 0.2 * y * y);
            let miss = system.work(&after) - system.work(&before) - gain;
            let size = 1.0 + system.work(&after);
            assert!(miss.abs() < 2e-15 * size && gain.abs() > 1e-9, "{miss:e} {gain:e}");
        }
    }
    let report = Driven::<f64>::REPORT;
    assert!(report.contains("change work by h times the mean of b·∇I") && !report.contains("keep work"), "{report}");
}

/// A body that friction slows down: S ∇C = 0 of its momentum's length alone is no longer enough.
#[hamiltonian(structure = so3, damping = d)]
fn slowed(x: [f64; 3], d: f64) -> f64 {
    x[0] * x[0] / 2.0 + x[1] * x[1] / 3.0 + x[2] * x[2] / 5.0
}

/// A Casimir of a structure that reads time: constant along its rows, and not along the flow.
#[hamiltonian(structure = nambu((x[0] * x[0] + (1.0 + k * t) * x[1] * x[1] + x[2] * x[2]) / 2.0))]
fn breathing(x: [f64; 3], t: f64, k: f64) -> f64 {
    x[0] * x[0] / 2.0 + x[1] * x[1] / 3.0 + x[2]
}

#[test]
fn damping_takes_casimirs_as_well() {
    let report = Slowed::<f64>::REPORT;
    assert!(report.contains("x[0]² + x[1]² + x[2]², but for b·∇I with b = [-x[0]·d, "), "{report}");
    let (system, start) = (Slowed { d: 0.3 }, FlowState::new([0.9, -0.5, 0.7]));
    let end = |h: f64, n: u64| {
        let mut sim = system.integrator(FOURTH, h, start);
        sim.advance(n).unwrap_or_else(|error| panic!("{error}"));
        sim.state().x
    };
    let mut exact = system.integrator(DOP853, 0.01, start);
    exact.advance(200).unwrap_or_else(|error| panic!("{error}"));
    let miss = |x: [f64; 3]| (0..3).map(|i| (x[i] - exact.state().x[i]).abs()).fold(0.0, f64::max);
    let [coarse, fine] = [miss(end(0.1, 20)), miss(end(0.05, 40))];
    assert!((coarse / fine).log2() > 3.8 && fine < 1e-7, "{coarse:e} {fine:e}");
    let length = |x: [f64; 3]| x.iter().map(|x| x * x).sum::<f64>();
    assert!(length(exact.state().x) < 0.7 * length(start.x));

    assert_eq!(<Breathing as FirstIntegrals>::NAMES, ["energy"]);
    let found = change(Breathing { k: 0.3 }, FOURTH, 0.05, [0.3, 0.7, 0.1]);
    assert!(found[0] < 4e-15, "{found:?}");
}

/// A top whose moments of inertia change in time.
#[hamiltonian(structure = so3)]
fn driven_top(x: [f64; 3], t: f64) -> f64 {
    x[0] * x[0] / 2.0 + x[1] * x[1] * (2.0 + t.cos()) / 6.0 + x[2].powi(4) / 5.0
}

#[test]
fn a_driven_top_stays_on_its_sphere() {
    assert!(DrivenTop::REPORT.contains("`DiscreteGradient` keeps every C(x) of degree 2"), "{}", DrivenTop::REPORT);
    let start = FlowState::new([0.9, -0.5, 0.7]);
    let mut sim = DrivenTop.integrator(DiscreteGradient, 0.1, start);
    let length = |x: [f64; 3]| x.iter().map(|x| x * x).sum::<f64>();
    let energy = sim.energy();
    let (mut off, mut moved) = (0.0_f64, 0.0_f64);
    for _ in 0..1000 {
        sim.step().unwrap_or_else(|error| panic!("{error}"));
        off = off.max((length(sim.state().x) / length(start.x) - 1.0).abs());
        moved = moved.max((sim.energy() - energy).abs());
    }
    assert!(off < 2e-14 && moved > 1e-2, "{off:e} {moved:e}");
}
