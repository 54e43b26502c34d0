use geoint_runtime::prelude::*;

#[vector_field(keeps(square = x[0] * x[0] + x[1] * x[1], but = [-x[0], x[1]]))]
fn decay(x: [f64; 2]) -> [f64; 2] {
    [x[1] - x[0], -x[0] - x[1]]
}

fn main() {}
