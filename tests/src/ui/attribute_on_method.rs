use geoint_runtime::prelude::*;

struct Pendulum;

impl Pendulum {
    #[hamiltonian]
    fn energy(&self, q: f64, p: f64) -> f64 {
        p * p + q
    }
}

fn main() {}
