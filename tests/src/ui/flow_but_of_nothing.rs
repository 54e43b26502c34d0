use geoint_runtime::prelude::*;

#[vector_field(keeps(but = [-x[0], -x[1]]))]
fn decay(x: [f64; 2]) -> [f64; 2] {
    [-x[0], -x[1]]
}

fn main() {}
