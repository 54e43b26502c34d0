use geoint_runtime::prelude::*;

/// There is nothing to project onto.
#[vector_field]
fn lorenz(x: [f64; 3], s: f64, r: f64, b: f64) -> [f64; 3] {
    [s * (x[1] - x[0]), r * x[0] - x[1] - x[0] * x[2], x[0] * x[1] - b * x[2]]
}

fn main() {
    let method = FourthOrder(DiscreteGradient);
    let mut sim = Lorenz { s: 10.0, r: 28.0, b: 8.0 / 3.0 }.integrator(method, 0.01, FlowState::new([1.0; 3]));
    sim.advance(10).unwrap();
}
