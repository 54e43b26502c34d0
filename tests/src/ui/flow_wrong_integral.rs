use geoint_runtime::prelude::*;

#[vector_field(keeps(
    energy = (a * x[0] * x[0] + b * x[1] * x[1] + c * x[2] * x[2]) / 2.0,
    momentum = (a * a * x[0] * x[0] + b * b * x[1] * x[1] - c * c * x[2] * x[2]) / 2.0,
))]
fn euler_top(x: [f64; 3], a: f64, b: f64, c: f64) -> [f64; 3] {
    [(b - c) / a * x[1] * x[2], (c - a) / b * x[2] * x[0], (a - b) / c * x[0] * x[1]]
}

fn main() {}
