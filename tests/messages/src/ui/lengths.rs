mod alias_by_a_path {
    use geoint_runtime::prelude::*;

    mod model {
        pub type Pair = [f64; 2];
    }

    #[hamiltonian]
    fn energy(q: model::Pair, p: model::Pair) -> f64 {
        (0..2).map(|i| p[i] * p[i] + q[i] * q[i]).sum()
    }

    fn uses() {
        println!("{}", energy([0.5; 2], [1.0; 2]));
    }
}

mod alias_from_outside {
    use geoint_runtime::prelude::*;

    type Plane = [f64; 2];

    #[hamiltonian]
    fn energy(q: Plane, p: Plane) -> f64 {
        p[0] * p[0] + p[1] * p[1] + q[0] * q[1]
    }

    fn uses() {
        println!("{}", energy([0.5; 2], [1.0; 2]));
    }
}

mod bound_from_data {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64, n: usize) -> f64 {
        let mut e = p * p;
        for i in 0..n {
            e += q * i as f64;
        }
        e
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0, 2));
    }
}

mod bound_from_outside {
    use geoint_runtime::prelude::*;

    const N: usize = 3;

    #[hamiltonian]
    fn energy(q: [f64; 3], p: [f64; 3]) -> f64 {
        let mut e = 0.0;
        for i in 0..N {
            e += p[i] * p[i] + q[i] * q[i];
        }
        e
    }

    fn uses() {
        println!("{}", energy([0.5; 3], [1.0; 3]));
    }
}

mod index_out_of_bounds {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: [f64; 3], p: [f64; 3]) -> f64 {
        (0..3).map(|i| p[i] * p[i] + (q[i + 1] - q[i]).powi(2)).sum()
    }
}

mod length_by_a_path {
    use geoint_runtime::prelude::*;

    mod model {
        pub const N: usize = 2;
    }

    #[hamiltonian]
    fn energy(q: [f64; model::N], p: [f64; model::N]) -> f64 {
        (0..2).map(|i| p[i] * p[i] + q[i] * q[i]).sum()
    }

    fn uses() {
        println!("{}", energy([0.5; 2], [1.0; 2]));
    }
}

mod length_from_body {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: [f64; N], p: [f64; N]) -> f64 {
        const N: usize = 3;
        (0..N).map(|i| p[i] * p[i] + q[i] * q[i]).sum()
    }
}

mod length_from_outside {
    use geoint_runtime::prelude::*;

    const SIZE: usize = 3;

    #[hamiltonian]
    fn energy(q: [f64; SIZE], p: [f64; SIZE]) -> f64 {
        (0..SIZE).map(|i| p[i] * p[i] + q[i] * q[i]).sum()
    }

    fn uses() {
        println!("{}", energy([0.5; SIZE], [1.0; SIZE]));
    }
}

mod length_in_terms_of_another {
    use geoint_runtime::prelude::*;

    const N: usize = 2;
    const M: usize = 2 * N;

    #[hamiltonian(const M = 2 * N)]
    fn energy(q: [f64; M], p: [f64; M]) -> f64 {
        (0..M).map(|i| p[i] * p[i] + q[i] * q[i]).sum()
    }

    fn uses() {
        println!("{}", energy([0.5; M], [1.0; M]));
    }
}

mod length_is_no_integer {
    use geoint_runtime::prelude::*;

    const G: f64 = 9.81;

    #[hamiltonian(const G = 9.81)]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + G * q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod length_too_large {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: [f64; 2000], p: [f64; 2000]) -> f64 {
        p[0] * p[0] + q[0] * q[0]
    }

    fn uses() {
        println!("{}", energy([0.5; 2000], [1.0; 2000]));
    }
}

mod loop_too_large {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        let mut e = p * p;
        for i in 0..20_000 {
            e += (q * i as f64).cos();
        }
        e
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod loop_too_long {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        let mut e = p * p;
        for i in 0..1_000_000 {
            e += q * i as f64;
        }
        e
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod nested_too_deeply {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + q.cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos().cos()
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod vec_argument {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64, weights: Vec<f64>) -> f64 {
        p * p + weights.iter().sum::<f64>() * q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0, vec![1.0]));
    }
}

mod length_without_its_value {
    use geoint_runtime::prelude::*;

    const N: usize = 2;

    #[hamiltonian(const N)]
    fn energy(q: [f64; N], p: [f64; N]) -> f64 {
        p[0] * p[0] + q[0] * p[1] + q[1]
    }

    fn uses() {
        println!("{}", energy([0.5; 2], [1.0; 2]));
    }
}

fn main() {}
