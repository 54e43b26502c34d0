use geoint_runtime::prelude::*;

#[hamiltonian]
struct Pendulum {
    q: f64,
    p: f64,
}

fn main() {
    let Pendulum { q, p } = Pendulum { q: 0.5, p: 1.0 };
    println!("{}", q + p);
}
