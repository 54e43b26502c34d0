mod argument_given_twice {
    use geoint_runtime::prelude::*;

    #[hamiltonian(q = x, q = p)]
    fn energy(x: f64, p: f64) -> f64 {
        x * x + p * p
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod async_function {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    async fn energy(q: f64, p: f64) -> f64 {
        p * p + q
    }

    fn uses() {
        let _ = energy(0.5, 1.0);
    }
}

mod attribute_on_method {
    use geoint_runtime::prelude::*;

    struct Pendulum;

    impl Pendulum {
        #[hamiltonian]
        fn energy(&self, q: f64, p: f64) -> f64 {
            p * p + q
        }
    }
}

mod attribute_on_struct {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    struct Pendulum {
        q: f64,
        p: f64,
    }

    fn uses() {
        let Pendulum { q, p } = Pendulum { q: 0.5, p: 1.0 };
        println!("{}", q + p);
    }
}

mod cfg_inside {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        #[cfg(debug_assertions)]
        let q = 2.0 * q;
        p * p + q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod cfg_on_argument {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64, #[cfg(any())] k: f64) -> f64 {
        p * p + q * q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod const_generic {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy<const N: usize>(q: [f64; N], p: [f64; N]) -> f64 {
        (0..N).map(|i| p[i] * p[i] + q[i] * q[i]).sum()
    }

    fn uses() {
        println!("{}", energy([0.5; 3], [1.0; 3]));
    }
}

mod generic_type {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy<T: Into<f64>>(q: T, p: T) -> f64 {
        0.5 * p.into().powi(2) + q.into()
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod mutable_reference {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        let mut x = q;
        {
            let y = &mut x;
            *y += 1.0;
        }
        p * p + x
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod name_of_generated_code {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian]
    fn state(q: f64, p: f64, s: f64) -> f64 {
        p * p / 2.0 - q.cos() + 0.1 * s
    }
}

mod name_of_the_function {
    use geoint_runtime::prelude::*;

    #[hamiltonian(name = energy)]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod parameter_shadows_coordinate {
    use geoint_runtime::prelude::*;

    #[hamiltonian(q = x, p = y)]
    fn energy(x: f64, y: f64, q: f64) -> f64 {
        y * y + q * x
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0, 2.0));
    }
}

mod pattern_argument {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64, (x, y): (f64, f64)) -> f64 {
        p * p + q * x + y
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0, (0.0, 0.0)));
    }
}

mod reference_argument {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: &[f64; 3], p: &[f64; 3]) -> f64 {
        p[0] * p[0] + q[0] + q[1] + q[2]
    }

    fn uses() {
        println!("{}", energy(&[0.5; 3], &[1.0; 3]));
    }
}

mod returns_integer {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> i32 {
        (p * p + q) as i32
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod returns_nothing {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) {
        let _ = p * p + q;
    }

    fn uses() {
        energy(0.5, 1.0);
    }
}

mod two_mistakes {
    use geoint_runtime::prelude::*;

    fn potential(q: f64) -> f64 {
        q * q
    }

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        let x = q.floor();
        let y = potential(p);
        x + y
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod unknown_attribute_argument {
    use geoint_runtime::prelude::*;

    #[hamiltonian(mass = m)]
    fn energy(q: f64, p: f64) -> f64 {
        p * p + q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod unsafe_function {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    unsafe fn energy(q: f64, p: f64) -> f64 {
        p * p + q * q
    }
}

mod where_clause {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64
    where
        f64: Copy,
    {
        p * p + q * q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod documented_argument {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(
        q: f64,
        p: f64,
        /// The mass.
        m: f64,
    ) -> f64 {
        p * p / m + q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0, 2.0));
    }
}

fn main() {}

mod length_at_run_time {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn chain(q: Vec<f64>, p: Vec<f64>) -> f64 {
        q[0] * q[0] + p[0] * p[0]
    }
}
