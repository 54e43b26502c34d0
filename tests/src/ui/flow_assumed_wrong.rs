use geoint_runtime::prelude::*;

/// Only what may be true is assumed.
#[vector_field(keeps(assume(saddle = x[0] * x[0] - x[1] * x[1])))]
fn turning(x: [f64; 2]) -> [f64; 2] {
    [x[1], -x[0]]
}

fn main() {}
