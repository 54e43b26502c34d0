//! Flows without momenta, in all forms.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use nalgebra::Vector3;

const N: usize = 4;

/// A scalar.
#[vector_field]
fn logistic(x: f64, r: f64) -> f64 {
    r * x * (1.0 - x)
}

/// Vectors, another name of x, an integral with a block, in single precision.
#[vector_field(x = w, keeps(square = {
    let s = w.dot(&w);
    s / 2.0
}))]
fn turning(w: Vector3<f32>, axis: Vector3<f32>) -> Vector3<f32> {
    w.cross(&axis)
}

/// Arrays of arrays, time, an integral that reads it.
#[vector_field(keeps(first = x[0][0] * x[0][0] + x[0][1] * x[0][1], begun = x[1][0] * (-t).exp()))]
fn two(x: [[f64; 2]; 2], t: f64) -> [[f64; 2]; 2] {
    [[x[0][1] * t.cos(), -x[0][0] * t.cos()], [x[1][0], x[0][0] * x[1][1]]]
}

/// A loss; what is known but not proven.
#[vector_field(keeps(energy = (x[0] * x[0] + x[1] * x[1]) / 2.0, but = [0.0, -c * x[1], 0.0], assume(strange = x[2])))]
fn damped(x: [f64; 3], c: f64) -> [f64; 3] {
    [x[1], -x[0] - c * x[1], 0.0 * x[0]]
}

/// Spins on a line: an array of so(3).
#[hamiltonian(structure = so3, const N = 4)]
fn spins(x: [[f64; 3]; N], j: f64) -> f64 {
    (0..N - 1).map(|i| -j * (0..3).map(|k| x[i][k] * x[i + 1][k]).sum::<f64>()).sum()
}

#[hamiltonian(structure = nambu((x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / 2.0))]
fn nambu_body(x: [f64; 3], inertia: [f64; 3]) -> f64 {
    (x[0] * x[0] / inertia[0] + x[1] * x[1] / inertia[1] + x[2] * x[2] / inertia[2]) / 2.0
}

/// Friction about every axis.
#[hamiltonian(structure = so3, damping = c)]
fn braked(m: f64, x: Vector3<f64>, c: f64) -> f64 {
    x.dot(&x) / (2.0 * m) + x.z * x.z
}

#[test]
fn compiles_and_means_what_it_says() -> Result<(), StepError> {
    let mut sim = Logistic { r: 2.0 }.adaptive(DOP853, 1e-10, FlowState::new(0.1));
    sim.advance_to(1.0)?;
    let end = 1.0 / (1.0 + 9.0 * (-2.0_f64).exp());
    assert!((sim.state().x - end).abs() < 1e-9);
    assert!((Logistic { r: 2.0 }.field(&FlowState::new(0.1)) - 0.18).abs() < 1e-16);

    let system = Turning { axis: Vector3::new(0.3, -0.2, 1.0) };
    let start = FlowState::new(Vector3::new(1.0, 0.5, -0.3));
    let mut sim = system.integrator(DiscreteGradient, 0.1, start);
    sim.advance(100)?;
    assert!((system.square(&sim.state()) - system.square(&start)).abs() < 1e-6);
    let mut sim = system.integrator(Kahan, 0.1, start);
    sim.advance(100)?;

    let start = FlowState::at(0.2, [[0.8, -0.3], [1.1, 0.4]]);
    let mut sim = Two.integrator(FourthOrder(DiscreteGradient), 0.05, start);
    sim.advance(40)?;
    assert!((Two.first(&sim.state()) - Two.first(&start)).abs() < 1e-14);
    assert!((Two.begun(&sim.state()) - Two.begun(&start)).abs() < 1e-14);

    let system = Damped { c: 0.3 };
    let mut sim = system.integrator(DiscreteGradient, 0.1, FlowState::new([0.7, 0.4, 1.0]));
    for _ in 0..20 {
        let before = sim.state();
        sim.step()?;
        let after = sim.state();
        let [p, q] = [before.x[1], after.x[1]];
        // −c ȳ·ȳ, with the mean of y.
        let loss = -0.3 * 0.1 * ((p + q) / 2.0).powi(2);
        assert!((system.energy(&after) - system.energy(&before) - loss).abs() < 1e-15);
    }
    assert!(Damped::<f64>::REPORT.contains("strange = x[2]: assumed"));

    let start = FlowState::new([[1.0, 0.0, 0.2], [0.3, 0.9, 0.1], [-0.5, 0.4, 0.8], [0.1, -0.7, 0.6]]);
    let system = Spins { j: 1.3 };
    let mut sim = system.integrator(DiscreteGradient, 0.1, start);
    sim.advance(50)?;
    assert!((system.energy(&sim.state()) - system.energy(&start)).abs() < 1e-13);
    for (a, b) in sim.state().x.iter().zip(start.x) {
        let square = |x: &[f64; 3]| x.iter().map(|x| x * x).sum::<f64>();
        assert!((square(a) - square(&b)).abs() < 1e-13);
    }

    let start = FlowState::new([0.5, 1.6, -1.2]);
    let mut sim = NambuBody { inertia: [1.0, 2.0, 3.0] }.integrator(DiscreteGradient, 0.1, start);
    sim.advance(100)?;
    assert!((sim.energy() - sim.system().energy(&start)).abs() < 1e-14);

    let mut sim =
        Braked { m: 1.3, c: 0.2 }.integrator(DiscreteGradient, 0.1, FlowState::new(Vector3::new(0.5, 0.8, -0.4)));
    let mut energy = sim.energy();
    for _ in 0..20 {
        sim.step()?;
        assert!(sim.energy() < energy);
        energy = sim.energy();
    }
    Ok(())
}
