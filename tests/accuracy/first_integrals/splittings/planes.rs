//! Splittings by planes.

use super::*;

#[test]
fn euler_by_planes() {
    let (energy, momentum) =
        (EULER.energy(), |w: &[f64; 3]| (w[0].powi(2) + 4.0 * w[1].powi(2) + 9.0 * w[2].powi(2)) / 2.0);
    EULER.splits(PlanarSplitting, &[2.193e-3, 5.492e-4, 1.373e-4], &[(&energy, None), (&momentum, Some(5.2e-4))]);
    EULER.splits(
        Suzuki4.of(PlanarSplitting),
        &[5.214e-8, 3.260e-9, 2.038e-10],
        &[(&energy, None), (&momentum, Some(8.6e-8))],
    );
}

#[test]
fn species_by_planes() {
    let wealth = PREDATORS.energy();
    PREDATORS.splits(PlanarSplitting, &[7.339e-3, 1.838e-3, 4.597e-4], &[(&wealth, None)]);
    let sum = VOLTERRA.energy();
    VOLTERRA.splits(PlanarSplitting, &[9.265e-4, 2.317e-4, 5.793e-5], &[(&sum, None), (&odd, Some(3.6e-4))]);
    VOLTERRA.splits(
        Suzuki4.of(PlanarSplitting),
        &[3.544e-8, 2.212e-9, 1.382e-10],
        &[(&sum, None), (&odd, Some(5.1e-8))],
    );
    let (sum, product) = (RING.energy(), |x: &[f64; 3]| x[0] * x[1] * x[2]);
    RING.splits(PlanarSplitting, &[5.310e-4, 1.324e-4, 3.309e-5], &[(&sum, None), (&product, Some(3.5e-4))]);
    RING.splits(
        Suzuki4.of(PlanarSplitting),
        &[1.185e-7, 7.414e-9, 4.634e-10],
        &[(&sum, None), (&product, Some(4.5e-8))],
    );
}

/// Two planes are solved for, and one turns. The turning plane dominates the error if it is solved for as well.
#[test]
fn lorenz_by_planes() {
    let energy = LORENZ.energy();
    LORENZ.splits(PlanarSplitting, &[1.201e-4, 3.004e-5, 7.509e-6], &[(&energy, None)]);
}

/// Four sites, none of whose planes has a flow in closed form.
#[test]
fn sites_by_planes() {
    let (energy, norm) =
        (WAVES.energy(), |x: &[f64; 8]| (0..4).map(|i| (1.0 + x[i] * x[i] + x[4 + i] * x[4 + i]).ln()).sum::<f64>());
    WAVES.splits(PlanarSplitting, &[5.108e-4, 1.278e-4, 3.196e-5], &[(&energy, None), (&norm, Some(1.2e-4))]);
}

/// One plane of a charge is solved for, and three turn. All nine planes of heavy tops turn or move on parabolas.
#[test]
fn more_than_three_coordinates_by_planes() {
    let energy = CHARGE.energy();
    CHARGE.splits(PlanarSplitting, &[2.227e-3, 5.561e-4, 1.390e-4], &[(&energy, None)]);
    let length = |x: &[f64; 6]| x[3] * x[3] + x[4] * x[4] + x[5] * x[5];
    let rows: [(&Motion<HeavyTop, 6>, &[f64], f64); 3] = [
        (&LAGRANGE, &[2.251e-2, 5.634e-3, 1.409e-3], 6.12e-3),
        (&KOVALEVSKAYA, &[3.461e-3, 8.677e-4, 2.171e-4], 2.16e-3),
        (&GORYACHEV, &[3.419e-3, 8.550e-4, 2.138e-4], 3.08e-3),
    ];
    for (top, row, moves) in rows {
        let energy = top.energy();
        top.splits(PlanarSplitting, row, &[(&energy, None), (&length, Some(moves))]);
    }
}

/// The macro searches for S. For predators and for Volterra's lattice it finds the S of their energies.
#[test]
fn fields_by_planes() {
    /// Returns the motion with a field in place of its energy.
    fn of<S, const N: usize>(motion: &Motion<impl Copy, N>, system: S) -> Motion<S, N> {
        let Motion { name, start, time, end, steps, .. } = *motion;
        Motion { name, system, start, time, end, steps }
    }
    let predators = of(&PREDATORS, Predators { a: 2.0, b: 1.0, c: 1.0 });
    let wealth = PREDATORS.energy();
    predators.splits(PlanarSplitting, &[7.339e-3, 1.838e-3, 4.597e-4], &[(&wealth, None)]);
    predators.splits(PoissonSplitting, &[3.565e-3, 8.839e-4, 2.205e-4], &[(&wealth, Some(9.1e-3))]);
    let sum = VOLTERRA.energy();
    let volterra = of(&VOLTERRA, VolterraField);
    volterra.splits(PlanarSplitting, &[9.265e-4, 2.317e-4, 5.793e-5], &[(&sum, None), (&odd, Some(3.6e-4))]);
    volterra.splits(
        Suzuki4.of(PlanarSplitting),
        &[3.544e-8, 2.212e-9, 1.382e-10],
        &[(&sum, None), (&odd, Some(5.1e-8))],
    );
    let charge = CHARGE.energy();
    of(&CHARGE, ChargeField).splits(PlanarSplitting, &[2.227e-3, 5.561e-4, 1.390e-4], &[(&charge, None)]);
    // The macro chooses one of many S, with fewer planes.
    let (euler, lorenz) = (EULER.energy(), LORENZ.energy());
    let top = of(&EULER, EulerTop { a: 1.0, b: 2.0, c: 3.0 });
    top.splits(PlanarSplitting, &[2.982e-4, 7.454e-5, 1.863e-5], &[(&euler, None)]);
    of(&LORENZ, LorenzField { b: 4.0 }).splits(PlanarSplitting, &[1.201e-4, 3.004e-5, 7.509e-6], &[(&lorenz, None)]);
}

/// Volterra's lattice with thirteen planes: more than there are traits of tuples for.
#[hamiltonian(structure = |i, j| if j == i + 1 { x[i] * x[j] } else { 0.0 })]
fn long_lattice(x: [f64; 14]) -> f64 {
    x.iter().sum()
}

#[test]
fn there_may_be_any_number_of_planes() {
    let start = FlowState::new(std::array::from_fn(|i| 0.3 + 0.1 * (i as f64).sin()));
    let mut sim = LongLattice.integrator(Suzuki4.of(PlanarSplitting), 0.1, start);
    sim.advance(20).unwrap_or_else(|error| panic!("{error}"));
    let mut exact = LongLattice.integrator(RK4, 1e-3, start);
    exact.advance(2000).unwrap_or_else(|error| panic!("{error}"));
    let [x, y] = [sim.state().x, exact.state().x];
    assert!(x.iter().zip(y).all(|(x, y)| (x - y).abs() < 1e-7), "{x:?} {y:?}");
    assert!((sim.energy() - LongLattice.energy(&start)).abs() < 1e-14);
}

/// A weight that is drawn to the axis from both sides.
#[vector_field(keeps(energy = x[1] * x[1] / (2.0 * m) + w * x[0].abs()))]
fn drawn(x: [f64; 2], m: f64, w: f64) -> [f64; 2] {
    [x[1] / m, -w * x[0].signum()]
}

/// Time goes faster on one side.
#[hamiltonian(structure = |_, _| if x[0] > 0.0 { a } else { 1.0 })]
fn two_rates(x: [f64; 2], a: f64) -> f64 {
    x[0] * x[0] + 1.7 * x[1] * x[1]
}

/// A velocity with a jump has the derivative of a field without a jump, whose flow is known. The field is different, so planes must be solved for.
#[test]
fn planes_with_jumps_are_solved_for() {
    let system = Drawn { m: 1.3, w: 0.7 };
    for (x, h) in [([0.5, 0.3], 0.05), ([0.5, 0.3], -0.1), ([-0.2, 0.4], 0.4)] {
        let start = FlowState::new(x);
        let mut sim = system.integrator(PlanarSplitting, h, start);
        sim.advance(40).unwrap_or_else(|error| panic!("{error}"));
        let there = sim.state();
        assert!((system.energy(&there) - system.energy(&start)).abs() < 1e-14, "h = {h}: {there:?}");
        let mut back = system.integrator(PlanarSplitting, -h, there);
        back.advance(40).unwrap_or_else(|error| panic!("{error}"));
        let missed = back.state().x.iter().zip(x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(missed < 1e-11, "h = {h}: {missed:e}");
    }
    let report = TwoRates::<f64>::REPORT;
    assert!(report.contains("none, because of 17·x[1]²/10"), "{report}");
    assert!(report.contains("planar discrete gradient") && !report.contains("linear field"), "{report}");
}

/// The plane turns about an axis that is at rest, so that all steps turn it by the same angle.
#[hamiltonian(structure = |i, j| if i == 0 && j == 1 { x[2] } else { 0.0 })]
fn about_an_axis(x: [f64; 3], a: f64) -> f64 {
    (x[0] * x[0] + a * x[1] * x[1]) / 2.0
}

/// In short steps the cosine differs from 1 in few digits. If it were rounded, a circle would grow by the same factor in each step.
#[test]
fn what_turns_has_no_trend() {
    for axis in [-1.3, 0.71, 0.9, 1.7] {
        for (a, h) in [(1.0, 1e-2), (1.0, 1e-3), (0.5, 1e-3)] {
            let start = FlowState::new([0.5, 1.6, axis]);
            let mut sim = AboutAnAxis::<f32> { a }.integrator(PlanarSplitting, h, start);
            let energy = sim.energy();
            sim.advance(100_000).unwrap_or_else(|error| panic!("{error}"));
            let change = sim.energy() / energy - 1.0;
            assert!(change.abs() < 1e-4, "{axis} {a} {h}: {change:e}");
        }
    }
    let (system, start) = (HeavyTop::<f32> { inertia: [1.0, 2.0, 3.0], r: [0.0; 3] }, [0.5, 1.6, -1.2, 0.6, 0.0, 0.8]);
    let mut sim = system.integrator(PoissonSplitting, 1e-3, FlowState::new(start));
    sim.advance(100_000).unwrap_or_else(|error| panic!("{error}"));
    let square = |x: [f32; 6]| x[3] * x[3] + x[4] * x[4] + x[5] * x[5];
    let change = square(sim.state().x) / square(start) - 1.0;
    assert!(change.abs() < 2e-4, "{change:e}");
}

/// What is a line on both sides, with the same slope, and jumps.
#[hamiltonian(structure = |_, _| (2.0 * x[0] + if x[0] > a { 1.0 } else { 2.0 }).powi(2))]
fn broken(x: [f64; 2], a: f64) -> f64 {
    x[1]
}

#[hamiltonian(structure = |_, _| (k * x[0] + x[0].signum()).exp())]
fn broken_exponent(x: [f64; 2], k: f64) -> f64 {
    x[1]
}

#[hamiltonian(structure = |_, _| (x[0] + if x[0] + c * x[1] > a { 1.0 } else { 2.0 }).sin())]
fn broken_angle(x: [f64; 2], a: f64, c: f64) -> f64 {
    x[1]
}

/// The flow of one side would continue straight beyond the jump, where the field is different.
#[test]
fn lines_with_jumps_are_no_lines() {
    for report in [Broken::<f64>::REPORT, BrokenExponent::<f64>::REPORT, BrokenAngle::<f64>::REPORT] {
        assert!(report.contains("- none, because of x[1]") && report.contains("planar discrete gradient"), "{report}");
    }
}
