//! Fields that derive from an energy. The macro recovers the energy from the field alone. Steps conserve it, and its terms and planes are pieces.

use super::{FOURTH, Motion, end};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::system::FirstIntegrals;

/// Hénon and Heiles, by their equations.
#[vector_field]
fn henon_field(x: [f64; 4]) -> [f64; 4] {
    [x[2], x[3], -x[0] - 2.0 * x[0] * x[1], -x[1] - x[0] * x[0] + x[1] * x[1]]
}

/// Example 2.2.7 of the thesis with F = eᵖ: neither separable nor a polynomial.
#[vector_field]
fn not_separable(x: [f64; 2], c: f64) -> [f64; 2] {
    let [q, p] = x;
    [-2.0 * p * q - 2.0 * q + c * p.exp(), p * p - 2.0 * q + 2.0 * p]
}

/// Example 2.2.5: H reads time.
#[vector_field]
fn driven(x: [f64; 2], t: f64) -> [f64; 2] {
    [x[0] * t + 2.0 * x[1], x[0] * x[0] - x[1] * t]
}

/// Example 2.2.4: div f = t + 2.
#[vector_field]
fn swelling(x: [f64; 2], t: f64) -> [f64; 2] {
    [x[0] * t - 2.0 * x[1], x[0] + 2.0 * x[1]]
}

/// A charge that another one repels, on a line: the field has two sides.
#[vector_field]
fn repelled(x: [f64; 2], m: f64, c: f64) -> [f64; 2] {
    [x[1] / m, c / x[0]]
}

/// H is the angle, which has no one value around the origin.
#[vector_field]
fn from_a_source(x: [f64; 2]) -> [f64; 2] {
    let square = x[0] * x[0] + x[1] * x[1];
    [x[0] / square, x[1] / square]
}

/// e^(−p²) has no elementary antiderivative.
#[vector_field]
fn bell(x: [f64; 2]) -> [f64; 2] {
    [(-x[1] * x[1]).exp(), -x[0]]
}

/// div f = 0, and yet no energy: the force turns.
#[vector_field]
fn turning_force(x: [f64; 4], w: f64) -> [f64; 4] {
    [x[2], x[3], -x[0] - w * x[1], -x[1] + w * x[0]]
}

/// Three particles of a ring: Σp is linear, and kept beside H.
#[vector_field]
fn toda_field(x: [f64; 6], m: f64) -> [f64; 6] {
    let [q1, q2, q3, p1, p2, p3] = x;
    let (a, b, c) = ((q1 - q2).exp(), (q2 - q3).exp(), (q3 - q1).exp());
    [p1 / m, p2 / m, p3 / m, c - a, a - b, b - c]
}

/// An oscillator of which another function than H is listed, and called energy.
#[vector_field(keeps(energy = x[0] * x[0] + x[2] * x[2]))]
fn listed(x: [f64; 4], w: f64) -> [f64; 4] {
    [w * x[2], x[3], -w * x[0], -x[1]]
}

#[vector_field]
fn prey(x: [f64; 2], a: f64, b: f64, c: f64) -> [f64; 2] {
    [x[0] * (a - b * x[1]), x[1] * (b * x[0] - c)]
}

/// Separable orbits: dy/dx = 2 tan x · y/(1 + y²)/(−c).
#[vector_field]
fn separable_orbits(x: [f64; 2], c: f64) -> [f64; 2] {
    [c * x[0].cos() * (1.0 + x[1] * x[1]), -2.0 * x[0].sin() * x[1]]
}

/// A gate behind which all is slower: H = p·v(q) would jump there, and p does not.
#[vector_field]
fn gate(x: [f64; 2]) -> [f64; 2] {
    [if x[0] > 0.0 { 1.0 } else { 2.0 }, 0.0]
}

/// A charge in a uniform magnetic field.
#[vector_field]
fn gyration(x: [f64; 4], b: f64) -> [f64; 4] {
    let [v, w] = [x[2] + b * x[1], x[3] - b * x[0]];
    [v, w, b * w, -b * v]
}

fn reports(report: &str, line: &str) {
    assert!(report.contains(line), "{line} is missing in\n{report}");
}

const HENON: Motion<HenonField, 4> = Motion {
    name: "Hénon and Heiles",
    system: HenonField,
    start: [0.1, -0.2, 0.3, 0.25],
    time: 2.0,
    end: [0.19978796855935517248, 0.23415479193657240149, -0.31368408051810332377, 0.023625090875938378016],
    steps: 10,
};

/// The rows of the energy on the canonical structure, from the field.
#[test]
fn what_is_recovered_is_kept() {
    HENON.holds(DiscreteGradient, &[3.159e-3, 7.921e-4, 1.982e-4]);
    HENON.holds(FOURTH, &[3.890e-6, 2.439e-7, 1.525e-8]);
    let start = FlowState::new(HENON.start);
    let [q1, q2, p1, p2] = HENON.start;
    let energy = (q1 * q1 + q2 * q2 + p1 * p1 + p2 * p2) / 2.0 + q1 * q1 * q2 - q2 * q2 * q2 / 3.0;
    assert!((HenonField.energy(&start) - energy).abs() < 1e-16);
    assert_eq!(<HenonField as FirstIntegrals>::NAMES, ["energy"]);
    reports(HenonField::REPORT, "div f = 0, proven by multiplying out");
    reports(HenonField::REPORT, "canonical, H = ");
    // Control: the implicit midpoint rule does not conserve the energy.
    let midpoint = end(HenonField, ImplicitMidpoint, HENON.start, 2.0, 10);
    assert!((HenonField.energy(&midpoint) - energy).abs() > 1e-6);

    let system = NotSeparable { c: 0.3 };
    let before = system.energy(&FlowState::new([0.4, -0.3]));
    let after = end(system, FOURTH, [0.4, -0.3], 0.5, 10);
    assert!((system.energy(&after) - before).abs() < 2e-15, "{:e}", system.energy(&after) - before);
    reports(NotSeparable::<f64>::REPORT, "c·exp(x[1])");
}

/// T and V are pieces of the recovered energy.
#[test]
fn what_is_recovered_is_split() {
    /// The same with an energy.
    #[hamiltonian]
    fn reference(q: [f64; 2], p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1] + q[0] * q[0] + q[1] * q[1]) / 2.0 + q[0] * q[0] * q[1] - q[1].powi(3) / 3.0
    }
    let [q1, q2, p1, p2] = HENON.start;
    let mut sim = Reference.integrator(StormerVerlet, 0.1, State::new([q1, q2], [p1, p2]));
    sim.advance(20).unwrap_or_else(|error| panic!("{error}"));
    let split = end(HenonField, PoissonSplitting, HENON.start, 2.0, 20).x;
    let State { q, p, .. } = sim.state();
    let [a, b] = [[q[0], q[1], p[0], p[1]], split];
    // The order of both flows is free. The error is the error of Störmer and Verlet, from either side.
    let error = |x: [f64; 4]| x.iter().zip(HENON.end).map(|(x, end)| (x - end).abs()).fold(0.0, f64::max);
    assert!((0.3..3.0).contains(&(error(a) / error(b))), "{:e} {:e}", error(a), error(b));
    let claims = <PoissonSplitting as Method<HenonField>>::claims(&PoissonSplitting);
    assert!(claims.symplectic && claims.symmetric);

    let energy = HenonField.energy(&FlowState::new(HENON.start));
    let planes = end(HenonField, Suzuki4.of(PlanarSplitting), HENON.start, 2.0, 20);
    assert!((HenonField.energy(&planes) - energy).abs() < 1e-14);
}

#[test]
fn what_jumps_on_the_way_is_not_kept() {
    reports(Gate::REPORT, "not kept, because it may jump where x[0] = 0");
    let mut sim = Gate.integrator(RK4, 0.1, FlowState::new([-1.05, 1.0]));
    sim.advance(20).unwrap_or_else(|error| panic!("{error}"));
    assert!(sim.state().x[0] > 0.4 && sim.state().x[1] == 1.0, "{:?}", sim.state());
}

#[test]
fn products_of_sums_have_an_energy() {
    let (system, start) = (Gyration { b: 0.8 }, FlowState::new([0.3, -0.2, 0.5, 0.4]));
    let [v, w] = [0.5 - 0.8 * 0.2, 0.4 - 0.8 * 0.3];
    assert!((system.energy(&start) - (v * v + w * w) / 2.0).abs() < 1e-16);
    let end = end(system, DiscreteGradient, start.x, 700.0, 1000);
    assert!((system.energy(&end) - system.energy(&start)).abs() < 1e-14);
}

#[test]
fn energies_may_read_time() {
    let state = FlowState { t: 0.5, x: [0.3, -0.7] };
    let expected = 0.3 * -0.7 * 0.5 + 0.49 - 0.027 / 3.0;
    assert!((Driven.energy(&state) - expected).abs() < 1e-15);
    reports(Driven::REPORT, "x[0]·x[1]·t");
    // An energy that reads time is not constant.
    reports(Driven::REPORT, "none was listed, and none was found");
}

/// A logarithm on both sides of the pole, as the field.
#[test]
fn fields_stay_as_large_as_they_were() {
    let system = Repelled { m: 1.3, c: 0.7 };
    for x in [[0.4, -0.5], [-0.4, 0.5]] {
        let before = system.energy(&FlowState::new(x));
        for state in [end(system, DiscreteGradient, x, 2.0, 100), end(system, RK4, x, 2.0, 1000)] {
            assert!((system.energy(&state) - before).abs() < 1e-8, "{state:?}");
            assert!(state.x[0] * x[0] > 0.0);
        }
    }
}

#[test]
fn without_an_energy_the_report_says_why() {
    reports(Swelling::REPORT, "div f = t + 2, not 0: it is ");
    reports(TurningForce::<f64>::REPORT, "no energy has this field: ∂²H/∂x[0]∂x[1] − ∂²H/∂x[1]∂x[0] would be ");
    reports(TurningForce::<f64>::REPORT, "div f = 0, proven by multiplying out");
    reports(Bell::REPORT, "canonical, H = x[0]²/2 + ∫ 1/exp(x[1]²) dx[1]");
    reports(
        FromASource::REPORT,
        "canonical, H = atan(x[1]/x[0]) on a simply connected domain, proven by multiplying out; not kept",
    );
    reports(Prey::<f64>::REPORT, "Jacobi's multiplier: div(μf) = 0 with μ = 1/(x[0]·x[1])");
    reports(Prey::<f64>::REPORT, "f = J ∇H/μ with H = ");
    reports(SeparableOrbits::<f64>::REPORT, "Jacobi's multiplier: div(μf) = 0 with μ = 1/(x[1]·cos(x[0]))");
    reports(SeparableOrbits::<f64>::REPORT, "f = J ∇H/μ with H = ");
}

/// Recovered linear functions are conserved as well. A recovered H stands beside the listed integrals, under another name if its own is taken.
#[test]
fn what_is_recovered_stands_beside_what_is_listed() {
    assert_eq!(<TodaField as FirstIntegrals>::NAMES.len(), 2);
    let system = TodaField { m: 1.5 };
    let start = [0.3, -0.1, 0.0, 0.5, 0.1, -0.2];
    let before = system.energy(&FlowState::new(start));
    let after = end(system, DiscreteGradient, start, 20.0, 100);
    assert!((system.energy(&after) - before).abs() < 1e-14);
    assert!((after.x[3..].iter().sum::<f64>() - 0.4).abs() < 1e-14);

    let system = Listed { w: 1.7 };
    assert_eq!(<Listed as FirstIntegrals>::NAMES.len(), 2);
    let state = FlowState::new([0.3, 0.2, 0.5, -0.4]);
    assert!((system.energy(&state) - 0.34).abs() < 1e-15);
    assert!((system.integrals(0.0, &state.x)[1] - (1.7 * 0.34 + 0.2) / 2.0).abs() < 1e-15);
}

/// A central force in the form of a structure.
#[hamiltonian(structure = canonical)]
fn central(x: [f64; 4], m: f64) -> f64 {
    (x[2] * x[2] + x[3] * x[3]) / (2.0 * m) + (x[0] * x[0] + x[1] * x[1]).powi(2)
}

/// A momentum that is no Casimir is reported, but steps are not projected onto it.
#[test]
fn momenta_of_structures_are_reported() {
    assert!(Central::<f64>::REPORT.contains("- x[0]·x[3] - x[1]·x[2]: constant as well, not listed"));
    assert_eq!(<Central as FirstIntegrals>::NAMES, ["energy"]);
}

/// A field of which the second integral alone is named, under a name of its own.
#[vector_field(keeps(momentum = (a * a * x[0] * x[0] + b * b * x[1] * x[1] + c * c * x[2] * x[2]) / 2.0))]
fn turning(x: [f64; 3], a: f64, b: f64, c: f64) -> [f64; 3] {
    [(b - c) / a * x[1] * x[2], (c - a) / b * x[2] * x[0], (a - b) / c * x[0] * x[1]]
}

/// Relaxation conserves the energy of a field, or the integral that the field names first. The other integral moves.
#[test]
fn steps_of_fields_are_relaxed() {
    use super::systems::EulerTop;
    let start = [0.5, 0.8, -0.4];
    let (top, unnamed) = (EulerTop { a: 1.0, b: 2.0, c: 3.0 }, Turning { a: 1.0, b: 2.0, c: 3.0 });
    let change = |after: FlowState<[f64; 3]>| {
        let before = FlowState::new(start);
        [top.energy(&after) - top.energy(&before), top.momentum(&after) - top.momentum(&before)].map(f64::abs)
    };
    let [energy, momentum] = change(end(top, Relaxation(RK4), start, 100.0, 1000));
    assert!(energy < 4e-15 && momentum > 1e-9, "{energy:e} {momentum:e}");
    let [energy, momentum] = change(end(unnamed, Relaxation(RK4), start, 100.0, 1000));
    assert!(energy > 1e-9 && momentum < 4e-15, "{energy:e} {momentum:e}");
    let [energy, _] = change(end(top, Projection(RK4, Energy), start, 100.0, 1000));
    assert!(energy < 4e-15, "{energy:e}");
    // A control: RK4 alone; and H of a field that was recovered.
    let [energy, momentum] = change(end(top, RK4, start, 100.0, 1000));
    assert!(energy > 1e-8 && momentum > 1e-8, "{energy:e} {momentum:e}");
    let before = HenonField.energy(&FlowState::new(HENON.start));
    let relaxed = end(HenonField, Relaxation(RK4), HENON.start, 20.0, 200);
    assert!((HenonField.energy(&relaxed) - before).abs() < 1e-15);
}
