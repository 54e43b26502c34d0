use geoint_runtime::hamiltonian;

#[hamiltonian(structure = so3, constraint = [x[0] * x[0] - 1.0])]
fn top(x: [f64; 3], a: f64) -> f64 {
    x[0] * x[0] / a + x[1] * x[1] + x[2] * x[2] / 3.0
}

fn main() {}
