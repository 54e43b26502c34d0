//! Requirements that hold cost nothing.
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

#[hamiltonian(require(separable, quadratic_kinetic), name = Chain,)]
fn chain(q: [f64; 3], p: [f64; 3], k: f64) -> f64 {
    p.iter().map(|x| 0.5 * x * x).sum::<f64>() + q.windows(2).map(|w| k * (w[1] - w[0]).powi(2)).sum::<f64>()
}

#[test]
fn compiles_and_means_what_it_says() {
    Chain { k: 1.0 }.integrator(BlanesMoanSrkn6b, 0.1, State::new([0.0, 0.1, 0.2], [0.0; 3])).advance(9).unwrap();
}
