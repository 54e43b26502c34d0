use geoint_runtime::prelude::*;

/// The integral of Goryachev and Chaplygin is one for m·γ = 0 alone.
#[vector_field(keeps(goryachev = x[2] * (x[0] * x[0] + x[1] * x[1]) - 4.0 * x[0] * x[5]))]
fn top(x: [f64; 6]) -> [f64; 6] {
    let [m1, m2, m3, g1, g2, g3] = x;
    let [u, v, w] = [m1 / 4.0, m2 / 4.0, m3];
    [m2 * w - m3 * v, m3 * u - m1 * w + g3, m1 * v - m2 * u - g2, g2 * w - g3 * v, g3 * u - g1 * w, g1 * v - g2 * u]
}

fn main() {}
