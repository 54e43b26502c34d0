use geoint_runtime::prelude::*;

#[vector_field(keeps(begun = x[0] * t.cos() + x[1] * t.sin()))]
fn turning(x: [f64; 2], t: f64) -> [f64; 2] {
    [x[1], -x[0]]
}

fn main() {}
