use geoint_runtime::prelude::*;

#[vector_field]
fn pendulum(q: f64, p: f64) -> [f64; 2] {
    [p, -q.sin()]
}

fn main() {}
