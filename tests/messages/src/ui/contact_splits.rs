mod contact_split_empty_piece {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian(split = "p * p / 2.0 + gamma * s || -q.cos()")]
    fn swing(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
        p * p / 2.0 - q.cos() + gamma * s
    }
}

mod contact_split_forgotten_branch {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian(split = "p * p / 2.0 | gamma * s")]
    fn wall(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
        p * p / 2.0 + gamma * s + if q < 0.0 { 100.0 * q * q } else { 0.0 }
    }
}

mod contact_split_forgotten_small_term {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian(split = "p * p / (2.0 * m) | gamma * s")]
    fn weak(q: f64, p: f64, s: f64, m: f64, gamma: f64, big: f64) -> f64 {
        p * p / (2.0 * m) + gamma * s - 6.674e-11 * big * q.cos()
    }
}

mod contact_split_not_a_string {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian(split = p * p / 2.0)]
    fn free(q: f64, p: f64, s: f64) -> f64 {
        p * p / 2.0 + q * s
    }
}

mod contact_split_not_the_sum {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian(split = "p * p / 2.0 | gamma * s")]
    fn swing(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
        p * p / 2.0 + q.cos() + gamma * s
    }
}

mod contact_split_without_flow {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian(split = "p * p / 2.0 + q.cos() | gamma * s")]
    fn swing(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
        p * p / 2.0 + q.cos() + gamma * s
    }
}

fn main() {}
