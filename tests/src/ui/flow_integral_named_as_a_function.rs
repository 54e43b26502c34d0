use geoint_runtime::prelude::*;

#[vector_field(keeps(field = x[0] * x[0] + x[1] * x[1]))]
fn turning(x: [f64; 2]) -> [f64; 2] {
    [x[1], -x[0]]
}

fn main() {}
