use geoint_runtime::prelude::*;

/// S is 1 + x², the sum that ∇I is divided by: no quotient of terms of both.
#[vector_field(keeps(square = (1.0 + x[0] * x[0] + x[1] * x[1]).ln() + x[0] * x[1]))]
fn turning(x: [f64; 2], w: f64) -> [f64; 2] {
    let [a, b] = x;
    let c = 1.0 + a * a + b * b;
    [w * (2.0 * b + c * a), -w * (2.0 * a + c * b)]
}

fn main() {
    let mut sim = Turning { w: 1.3 }.integrator(PlanarSplitting, 0.01, FlowState::new([1.0; 2]));
    sim.advance(10).unwrap();
}
