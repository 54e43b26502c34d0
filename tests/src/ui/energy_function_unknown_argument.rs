use geoint_runtime::prelude::*;

#[energy_function(name = Potential)]
fn potential(q: f64) -> f64 {
    q * q
}

fn main() {
    println!("{}", potential(0.5));
}
