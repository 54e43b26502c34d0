mod error_function {
    use geoint_runtime::prelude::*;

    fn erf(x: f64) -> f64 {
        x.tanh()
    }

    #[hamiltonian]
    fn screened(q: f64, p: f64) -> f64 {
        p * p / 2.0 + erf(q) / q
    }

    fn uses() {
        println!("{}", screened(0.5, 1.0));
    }
}

mod function_of_a_number {
    use geoint_runtime::prelude::*;

    mod math {
        pub fn sqrt(x: f64) -> f64 {
            x.sqrt()
        }
    }

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        p * p / 2.0 + math::sqrt(1.0 + q * q)
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod generic_nested_function {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        fn square<T: Copy + std::ops::Mul<Output = T>>(x: T) -> T {
            x * x
        }
        square(p) + square(q)
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod import_inside {
    use geoint_runtime::prelude::*;

    mod outside {
        pub const STIFFNESS: f64 = 2.0;
    }

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        use outside::STIFFNESS;
        p * p + STIFFNESS * q * q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod macro_call {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        assert!(q > 0.0);
        p * p + q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod method_floor {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        let cell = q.floor();
        p * p + cell * cell
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod outside_function {
    use geoint_runtime::prelude::*;

    fn potential(q: f64) -> f64 {
        q * q
    }

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + potential(q)
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod recursion {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        fn power(x: f64, n: i32) -> f64 {
            if n == 0 { 1.0 } else { x * power(x, n - 1) }
        }
        power(p, 2) + power(q, 4)
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod recursion_mutual {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        fn even(x: f64) -> f64 {
            if x < 1.0 { x } else { odd(x - 1.0) }
        }
        fn odd(x: f64) -> f64 {
            if x < 1.0 { -x } else { even(x - 1.0) }
        }
        p * p + even(q)
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod static_inside {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        static STIFFNESS: f64 = 2.0;
        p * p + STIFFNESS * q * q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod unknown_variable {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        p * p / (2.0 * m) + q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

fn main() {}
