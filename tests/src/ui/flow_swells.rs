use geoint_runtime::prelude::*;

/// Of the thesis: div f = t + 2, so that there is no H to be kept.
#[vector_field]
fn swelling(x: [f64; 2], t: f64) -> [f64; 2] {
    [x[0] * t - 2.0 * x[1], x[0] + 2.0 * x[1]]
}

fn main() {
    let mut sim = Swelling.integrator(DiscreteGradient, 0.01, FlowState::new([1.0; 2]));
    sim.advance(10).unwrap();
}
