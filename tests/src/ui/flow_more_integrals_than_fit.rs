use geoint_runtime::prelude::*;

/// In the plane there is one.
#[vector_field(keeps(radius = x[0] * x[0] + x[1] * x[1], other = (x[0] * x[0] + x[1] * x[1]).sin()))]
fn turning(x: [f64; 2]) -> [f64; 2] {
    [x[1], -x[0]]
}

#[vector_field(keeps(square = w * w))]
fn constant(x: [f64; 2], w: f64) -> [f64; 2] {
    [w * x[1], -w * x[0]]
}

fn main() {}
