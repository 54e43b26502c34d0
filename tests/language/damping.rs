#![deny(warnings)]

use geoint_runtime::method::implicit::SolvedBy;
use geoint_runtime::prelude::*;
use geoint_runtime::private::DiscreteField;
use nalgebra::Vector2;

const DRAG: f64 = 0.25;

/// One coefficient from outside.
#[hamiltonian(damping = DRAG)]
fn outside(q: f64, p: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0
}

/// A parameter that nothing else reads, in single precision, with a branch.
#[hamiltonian(damping = if q > 0.0 { c } else { 2.0 * c })]
fn single(q: f32, p: f32, c: f32) -> f32 {
    p * p / 2.0 + q * q / 2.0
}

/// A vector of coefficients.
#[hamiltonian(damping = c)]
fn vector(q: Vector2<f64>, p: Vector2<f64>, c: Vector2<f64>) -> f64 {
    p.norm_squared() / 2.0 + q.norm_squared() / 2.0
}

/// Coefficients in the shape of q.
#[hamiltonian(damping = [[a, 0.0], [b, a + b]])]
fn nested(q: [[f64; 2]; 2], p: [[f64; 2]; 2], a: f64, b: f64) -> f64 {
    (0..2).map(|i| p[i][0] * p[i][0] + p[i][1] * p[i][1] + q[i][0] * q[i][0] + q[i][1] * q[i][1]).sum()
}

/// Numbers that are singular on paper, and as they are rounded: 0.1·0.1 is above 0.01.
#[hamiltonian(damping = [[1.0, 0.1], [0.1, 0.01]])]
fn singular(q: [f64; 2], p: [f64; 2]) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + q[0] * q[0] + 2.0 * q[1] * q[1]) / 2.0
}

/// A matrix that is made where it stands; time, and other names.
#[hamiltonian(q = x, damping = { let v = [1.0, (0.3 * t).sin()]; [[v[0] * v[0], v[0] * v[1]], [v[0] * v[1], v[1] * v[1]]] })]
fn rank_one(x: [f64; 2], p: [f64; 2], t: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + x[0] * x[0] + 2.0 * x[1] * x[1]) / 2.0
}

/// The energy falls in every step.
fn falls<S: SolvedBy<DiscreteGradient> + DiscreteField<State = State<[f64; 2]>>>(system: S) {
    let mut sim = system.integrator(DiscreteGradient, 0.1, State::new([0.3, 0.4], [0.5, -0.2]));
    let mut energy = sim.energy();
    for _ in 0..100 {
        sim.step().unwrap();
        assert!(sim.energy() < energy);
        energy = sim.energy();
    }
}

#[test]
fn compiles_and_means_what_it_says() {
    // The lost energy of the first step, h times C times the square of the mean velocity.
    let mut sim = Outside.integrator(DiscreteGradient, 0.1, State::new(0.0, 1.0));
    sim.step().unwrap();
    let mean = (1.0 + sim.state().p) / 2.0;
    assert!((0.5 - sim.energy() - 0.1 * DRAG * mean * mean).abs() < 1e-15);

    let mut sim = Single { c: 0.2 }.integrator(Gauss::<2>, 0.1, State::new(0.0, 1.0));
    sim.advance(100).unwrap();
    assert!(sim.energy() < 0.05);

    // The second coordinate is not damped.
    let start = State::new(Vector2::new(1.0, 1.0), Vector2::new(0.0, 0.0));
    let mut sim = Vector { c: Vector2::new(0.3, 0.0) }.integrator(DiscreteGradient, 0.1, start);
    sim.advance(1000).unwrap();
    assert!(sim.energy() < 0.5 + 1e-6 && sim.energy() > 0.5 - 1e-6);

    let start = State::new([[1.0, 1.0]; 2], [[0.0, 0.0]; 2]);
    let mut sim = Nested { a: 0.5, b: 0.7 }.integrator(ImplicitMidpoint, 0.1, start);
    sim.advance(1000).unwrap();
    assert!((sim.energy() - 1.0).abs() < 1e-6, "all but q[0][1]: {}", sim.energy());

    falls(RankOne);
    falls(Singular);
    assert_eq!(outside(0.0, 1.0) + f64::from(single(0.0, 1.0, 0.1)), 1.0);
    assert_eq!(vector(start.q[0].into(), start.p[0].into(), start.p[0].into()), 1.0);
    assert_eq!(nested([[0.0; 2]; 2], [[0.0; 2]; 2], 0.1, 0.1) + rank_one([0.0; 2], [0.0; 2], 0.0), 0.0);
    assert_eq!(singular([0.0; 2], [1.0, 0.0]), 0.5);
}
