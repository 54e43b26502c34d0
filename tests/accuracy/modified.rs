//! Steps of Störmer and Verlet conserve H + h²H₂ to the next order.

use geoint_runtime::Hamiltonian;
use geoint_runtime::prelude::*;
use geoint_runtime::private::ModifiedEnergy;
use geoint_tests::measure::{distance, extrapolated};
use geoint_tests::scalars::Dual;

/// Coupled masses.
#[hamiltonian]
fn chain(q: [f64; 2], p: [f64; 2]) -> f64 {
    let kinetic = p[0] * p[0] / 3.4 + p[1] * p[1] / 1.2 + 0.3 * p[0] * p[1];
    kinetic + q[0].powi(4) / 4.0 + (q[0] - q[1]).cosh() + q[1].sin()
}

/// A kinetic energy that is not quadratic, and both parts depend on time.
#[hamiltonian]
fn driven(q: [f64; 2], p: [f64; 2], t: f64) -> f64 {
    let kinetic = (1.0 + p[0] * p[0] + p[1] * p[1]).sqrt() * (1.4 + (1.3 * t).sin());
    kinetic + q[0].powi(4) / 4.0 + (q[0] - q[1]).cosh() * t.cos()
}

/// A step against the exact flow of H + h²H₂.
fn defect<S, D>(system: S, dual: D, h: f64) -> f64
where
    S: Hamiltonian<Coordinates = [f64; 2], Array = [f64; 2]>,
    geoint_runtime::Splitting<1>: Method<S>,
    D: ModifiedEnergy<Dual, State = State<[Dual; 2]>, Action = ()>,
{
    let (t, x) = (0.3, [0.7, -0.4, 0.5, 0.8]);
    let mut sim = Integrator::new(system, StormerVerlet, h, State::at(t, [x[0], x[1]], [x[2], x[3]]));
    sim.step().unwrap();
    let State { q, p, .. } = sim.state();
    let field = |now: f64, x: &[f64]| -> Vec<f64> {
        let slope = |j: usize| {
            let mut x: Vec<Dual> = x.iter().map(|x| Dual::from(*x)).collect();
            x[j] = Dual::variable(x[j].value());
            let state = State::at(Dual::from(now), [x[0], x[1]], [x[2], x[3]]);
            dual.modified_energy(Dual::from(h), &state).derivative()
        };
        vec![slope(2), slope(3), -slope(0), -slope(1)]
    };
    distance(&[q[0], q[1], p[0], p[1]], &extrapolated(field, t, x.to_vec(), h, 1))
}

#[test]
fn a_step_is_their_flow_but_for_the_fifth_order() {
    for (name, [coarse, fine]) in [
        ("chain", [0.1, 0.05].map(|h| defect(Chain, Chain, h))),
        ("driven", [0.1, 0.05].map(|h| defect(Driven, Driven, h))),
    ] {
        let order = (coarse / fine).log2();
        assert!((order - 5.0).abs() < 0.3, "{name}: {coarse:.1e}, {fine:.1e}, order {order:.2}");
    }
}

/// Along a trajectory H goes off by h², H + h²H₂ by h⁴.
#[test]
fn a_trajectory_keeps_them_better() {
    let offs = [0.1, 0.05].map(|h| {
        let mut sim = Chain.integrator(StormerVerlet, h, State::new([0.7, -0.4], [0.5, 0.8]));
        let start = (Chain.energy(&sim.state()), Chain.modified_energy(h, &sim.state()));
        let mut largest = (0.0_f64, 0.0_f64);
        for state in sim.until(50.0) {
            let state = state.unwrap();
            largest.0 = largest.0.max((Chain.energy(&state) - start.0).abs());
            largest.1 = largest.1.max((Chain.modified_energy(h, &state) - start.1).abs());
        }
        largest
    });
    let [plain, modified] = [(offs[0].0 / offs[1].0).log2(), (offs[0].1 / offs[1].1).log2()];
    assert!((plain - 2.0).abs() < 0.2 && (modified - 4.0).abs() < 0.4, "{plain:.2}, {modified:.2}");
}
