use geoint_runtime::prelude::*;

#[vector_field]
fn lorenz(x: [f64; 3], s: f64, r: f64) -> [f64; 2] {
    [s * (x[1] - x[0]), r * x[0] - x[1] - x[0] * x[2]]
}

fn main() {}
