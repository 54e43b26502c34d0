mod assign_element_from_branch {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: [f64; 2], p: [f64; 2]) -> f64 {
        let mut reach = [1.0; 2];
        for i in 0..2 {
            if q[i] > 0.0 {
                reach[i] = 2.0;
            }
        }
        p[0] * p[0] + p[1] * p[1] + reach[0] * q[0].powi(4) + reach[1] * q[1].powi(4)
    }

    fn uses() {
        println!("{}", energy([0.5; 2], [1.0; 2]));
    }
}

mod assign_from_branch {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        let mut e = p * p;
        if q > 0.0 {
            e += q;
        }
        e
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod assign_from_closure {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        let mut e = p * p;
        let mut add = |x: f64| e += x;
        add(q);
        e
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod continue_on_data {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: [f64; 3], p: [f64; 3]) -> f64 {
        let mut e = 0.0;
        for i in 0..3 {
            e += p[i] * p[i] / 2.0;
            if q[i] < 0.0 {
                continue;
            }
            e += q[i].powi(4);
        }
        e
    }

    fn uses() {
        println!("{}", energy([0.5; 3], [1.0; 3]));
    }
}

mod filter_by_data {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: [f64; 3], p: [f64; 3]) -> f64 {
        p[0] * p[0] + q.iter().filter(|x| **x > 0.0).sum::<f64>()
    }

    fn uses() {
        println!("{}", energy([0.5; 3], [1.0; 3]));
    }
}

mod if_without_else {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        let e = p * p;
        if q > 0.0 {
            let _unused = q;
        }
        e
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod let_else {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        let Some(x) = Some(q) else { return 0.0 };
        p * p + x * x
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod loop_loop {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        let e = loop {
            break p * p;
        };
        e + q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod match_on_sign {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        p * p
            + match q > 0.0 {
                true => q,
                false => -q,
            }
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod matrix_in_body {
    use geoint_runtime::nalgebra::{Matrix2, Vector2};
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn coupled(q: Vector2<f64>, p: Vector2<f64>, k: f64) -> f64 {
        let stiffness = Matrix2::new(2.0 * k, -k, -k, k);
        p.norm_squared() / 2.0 + q.dot(&(stiffness * q)) / 2.0
    }

    fn uses() {
        println!("{}", coupled(Vector2::zeros(), Vector2::zeros(), 1.0));
    }
}

mod return_early {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        if q > 0.0 {
            return p * p;
        }
        p * p + q
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod struct_literal {
    use geoint_runtime::prelude::*;

    struct Point {
        x: f64,
    }

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        let point = Point { x: q };
        p * p + point.x
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

mod while_loop {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn energy(q: f64, p: f64) -> f64 {
        let mut e = p * p;
        while e < 1.0 {
            e += q;
        }
        e
    }

    fn uses() {
        println!("{}", energy(0.5, 1.0));
    }
}

fn main() {}
