use geoint_runtime::prelude::*;

/// atan x + atan 1/x is π/2 for positive x.
#[vector_field(keeps(energy = (x[0] * x[0] + x[1] * x[1]) / 2.0))]
fn swing(x: [f64; 2]) -> [f64; 2] {
    [x[1] * ((x[1] * x[1]).atan() + (1.0 / (x[1] * x[1])).atan()), -x[0] * std::f64::consts::FRAC_PI_2]
}

fn main() {}
