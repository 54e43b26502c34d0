//! Planes solved by discrete gradients, and by increments of one coordinate after the other, whether the planes have flows or not.

use super::*;

#[test]
fn euler_solved_for() {
    let (energy, momentum) =
        (EULER.energy(), |w: &[f64; 3]| (w[0].powi(2) + 4.0 * w[1].powi(2) + 9.0 * w[2].powi(2)) / 2.0);
    let kept = |moves: f64| [(&energy as &dyn Fn(&[f64; 3]) -> f64, None), (&momentum, Some(moves))];
    EULER.splits(PlanarDiscreteGradient, &[4.193e-3, 1.047e-3, 2.618e-4], &kept(1.0e-4));
    EULER.splits(PlanarItohAbePair, &[4.287e-3, 1.071e-3, 2.676e-4], &kept(1.1e-4));
    EULER.splits(PlanarItohAbe, &[0.408, 0.167, 7.58e-2], &kept(9.8e-2));
    EULER.splits(Suzuki4.of(PlanarItohAbePair), &[2.977e-7, 1.861e-8, 1.163e-9], &[(&energy, None)]);
}

#[test]
fn species_solved_for() {
    let wealth = PREDATORS.energy();
    PREDATORS.splits(PlanarDiscreteGradient, &[7.339e-3, 1.838e-3, 4.597e-4], &[(&wealth, None)]);
    PREDATORS.splits(PlanarItohAbePair, &[1.485e-2, 3.671e-3, 9.150e-4], &[(&wealth, None)]);
    PREDATORS.splits(PlanarItohAbe, &[2.062e-2, 8.554e-3, 3.851e-3], &[(&wealth, None)]);
}

#[test]
fn what_turns_solved_for() {
    let energy = LORENZ.energy();
    LORENZ.splits(PlanarDiscreteGradient, &[2.817e-3, 7.056e-4, 1.765e-4], &[(&energy, None)]);
    let energy = CHARGE.energy();
    CHARGE.splits(PlanarDiscreteGradient, &[1.764e-3, 4.413e-4, 1.103e-4], &[(&energy, None)]);
    let length = |x: &[f64; 6]| x[3] * x[3] + x[4] * x[4] + x[5] * x[5];
    let rows: [(&Motion<HeavyTop, 6>, &[f64]); 3] = [
        (&LAGRANGE, &[7.347e-3, 1.831e-3, 4.574e-4]),
        (&KOVALEVSKAYA, &[2.821e-3, 7.054e-4, 1.764e-4]),
        (&GORYACHEV, &[4.613e-3, 1.153e-3, 2.883e-4]),
    ];
    for (top, row) in rows {
        let energy = top.energy();
        top.splits(PlanarDiscreteGradient, row, &[(&energy, None)]);
        let steps = [top.steps, 4 * top.steps].map(|n| {
            let mut sim = top.system.integrator(PlanarDiscreteGradient, top.time / n as f64, FlowState::new(top.start));
            sim.advance(n).unwrap_or_else(|error| panic!("{error}"));
            (length(&sim.state().x) - length(&top.start)).abs()
        });
        // A control: a Casimir moves by the error of order 2.
        assert!(steps[0] > 1e-6 && (10.0..24.0).contains(&(steps[0] / steps[1])), "{steps:?}");
    }
}

/// One degree of freedom, in both forms; with c = 0 an oscillator of Duffing's.
#[hamiltonian(structure = canonical)]
fn in_a_plane(x: [f64; 2], m: f64, b: f64, c: f64) -> f64 {
    let [q, p] = x;
    p * p * (1.0 + c * q * q) / (2.0 * m) + q * q / 2.0 + b * q.powi(4) / 4.0
}

#[hamiltonian]
fn in_momenta(q: f64, p: f64, m: f64, b: f64, c: f64) -> f64 {
    p * p * (1.0 + c * q * q) / (2.0 * m) + q * q / 2.0 + b * q.powi(4) / 4.0
}

const STEP: f64 = 0.1;

fn planar<M: Method<InAPlane, Proof = ()>>(method: M, c: f64) -> Vec<[f64; 2]> {
    let mut sim = Integrator::new(InAPlane { m: 1.3, b: 0.7, c }, method, STEP, FlowState::new([0.8, -0.3]));
    (0..50).map(|_| sim.step().map(|()| sim.state().x).unwrap_or_else(|error| panic!("{error}"))).collect()
}

fn canonical<M: Method<InMomenta, Proof = ()>>(method: M, c: f64) -> Vec<[f64; 2]> {
    let mut sim = Integrator::new(InMomenta { m: 1.3, b: 0.7, c }, method, STEP, State::new(0.8, -0.3));
    let mut step = |_| sim.step().map(|()| [sim.state().q, sim.state().p]).unwrap_or_else(|error| panic!("{error}"));
    (0..50).map(&mut step).collect()
}

fn gap(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The step of the thesis is x₁ − x₀ = h (y₀ + y₁)/2m and y₁ − y₀ = −h (x₀ + x₁)/2 (1 + b (x₀² + x₁²)/2). The step of the plane equals it, whichever
/// coordinate comes first. With terms in both coordinates, planes have the steps of Itoh and Abe.
#[test]
fn one_plane_is_the_step_by_coordinate_increments() {
    let states = planar(PlanarItohAbe, 0.0);
    for pair in states.windows(2) {
        let [[q, p], [x, y]] = [pair[0], pair[1]];
        assert!((x - q - STEP * (p + y) / 2.6).abs() < 2e-16);
        assert!((y - p + STEP * (q + x) / 2.0 * (1.0 + 0.35 * (q * q + x * x))).abs() < 2e-16);
    }
    assert!(gap(&states, &planar(PlanarItohAbeAdjoint, 0.0)) < 1e-14);
    assert!(gap(&states, &canonical(CoordinateIncrement::default(), 0.0)) < 1e-14);

    let [there, back] = [planar(PlanarItohAbe, 0.6), planar(PlanarItohAbeAdjoint, 0.6)];
    let [first, second] = [canonical(ItohAbe, 0.6), canonical(ItohAbeAdjoint, 0.6)];
    assert!(gap(&there, &back) > 1e-4);
    assert!(
        gap(&there, &first) < 1e-14 && gap(&back, &second) < 1e-14,
        "{:e} {:e}",
        gap(&there, &first),
        gap(&there, &second)
    );
}
