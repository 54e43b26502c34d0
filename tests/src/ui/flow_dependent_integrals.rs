use geoint_runtime::prelude::*;

#[vector_field(keeps(sum = x[0] + x[1] + x[2], product = x[0] * x[1] * x[2], square = (x[0] + x[1] + x[2]).powi(2)))]
fn ring(x: [f64; 3]) -> [f64; 3] {
    [x[0] * (x[1] - x[2]), x[1] * (x[2] - x[0]), x[2] * (x[0] - x[1])]
}

fn main() {}
