use geoint_runtime::prelude::*;

struct Well {
    depth: f64,
}

impl Well {
    #[energy_function]
    fn potential(&self, q: f64) -> f64 {
        self.depth * q * q
    }
}

fn main() {
    println!("{}", Well { depth: 2.0 }.potential(0.5));
}
