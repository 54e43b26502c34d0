mod energy_function_calls_another {
    use geoint_runtime::prelude::*;

    fn square(x: f64) -> f64 {
        x * x
    }

    #[energy_function]
    fn potential(q: f64) -> f64 {
        square(q)
    }

    #[hamiltonian(with(potential))]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + potential(q)
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod energy_function_calls_itself {
    use geoint_runtime::prelude::*;

    #[energy_function]
    fn legendre(n: u32, x: f64) -> f64 {
        if n == 0 { 1.0 } else { x * legendre(n - 1, x) }
    }

    #[hamiltonian(with(legendre))]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + legendre(2, q)
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod energy_function_not_annotated {
    use geoint_runtime::prelude::*;

    fn potential(q: f64) -> f64 {
        q * q
    }

    #[hamiltonian(with(potential))]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + potential(q)
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod energy_function_of_another_type {
    use geoint_runtime::prelude::*;

    #[energy_function]
    fn potential(q: f64) -> f64 {
        (q as f32).sin() as f64
    }

    #[hamiltonian(with(potential))]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + potential(q)
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod energy_function_on_a_method {
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

    fn uses() {
        println!("{}", Well { depth: 2.0 }.potential(0.5));
    }
}

mod energy_function_reads_a_constant {
    use geoint_runtime::prelude::*;

    mod forces {
        use geoint_runtime::prelude::*;

        const DEPTH: f64 = 0.5;

        #[energy_function]
        pub fn potential(q: f64) -> f64 {
            DEPTH * q * q
        }
    }
    use forces::potential;

    const DEPTH: f64 = 2.0;

    #[hamiltonian(with(potential))]
    fn energy(q: f64, p: f64) -> f64 {
        DEPTH * p * p + potential(q)
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod energy_function_unknown_argument {
    use geoint_runtime::prelude::*;

    #[energy_function(name = Potential)]
    fn potential(q: f64) -> f64 {
        q * q
    }

    fn uses() {
        println!("{}", potential(0.5));
    }
}

fn main() {}
