use geoint_runtime::prelude::*;

/// Nothing is named that could be kept.
#[vector_field]
fn circle(x: [f64; 3], w: f64) -> [f64; 3] {
    [w * x[1], -w * x[0], x[2].sin()]
}

fn main() {
    let mut sim = Circle { w: 1.3 }.integrator(Relaxation(RK4), 0.01, FlowState::new([1.0; 3]));
    sim.advance(10).unwrap();
}
