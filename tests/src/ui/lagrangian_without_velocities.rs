use geoint_runtime::lagrangian;

#[lagrangian]
fn still(q: f64, m: f64) -> f64 {
    -m * q * q
}

fn main() {}
