use geoint_runtime::prelude::*;

/// S is not known.
#[vector_field(keeps(square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2]))]
fn turning(x: [f64; 3], w: f64) -> [f64; 3] {
    [w * x[1] * x[2], -w * x[0] * x[2], 0.0 * x[2]]
}

fn main() {
    let mut sim = Turning { w: 1.3 }.integrator(PlanarSplitting, 0.01, FlowState::new([1.0; 3]));
    sim.advance(10).unwrap();
}
