use geoint_runtime::prelude::*;

#[vector_field(structure = so3)]
fn free_body(x: [f64; 3]) -> [f64; 3] {
    [x[1] * x[2], -x[2] * x[0], 0.0]
}

fn main() {}
