mod rolling_under_gauss2 {
    use geoint_runtime::{methods::*, prelude::*};

    #[lagrangian(rolling = [v[1] * q[2].cos() - v[0] * q[2].sin()])]
    fn blade(q: [f64; 3], v: [f64; 3]) -> f64 {
        0.7 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 6.9 * q[0]
    }

    fn uses() {
        let _ = Blade.integrator(Gauss::<2>, 0.1, Blade.at([0.0; 3], [0.1, 0.0, 0.3]));
    }
}

mod rolling_under_rattle {
    use geoint_runtime::{methods::*, prelude::*};

    #[lagrangian(rolling = [v[1] * q[2].cos() - v[0] * q[2].sin()])]
    fn blade(q: [f64; 3], v: [f64; 3]) -> f64 {
        0.7 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 6.9 * q[0]
    }

    fn uses() {
        let _ = Blade.integrator(Rattle, 0.1, Blade.at([0.0; 3], [0.1, 0.0, 0.3]));
    }
}

mod rolling_under_stormerverlet {
    use geoint_runtime::{methods::*, prelude::*};

    #[lagrangian(rolling = [v[1] * q[2].cos() - v[0] * q[2].sin()])]
    fn blade(q: [f64; 3], v: [f64; 3]) -> f64 {
        0.7 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 6.9 * q[0]
    }

    fn uses() {
        let _ = Blade.integrator(StormerVerlet, 0.1, Blade.at([0.0; 3], [0.1, 0.0, 0.3]));
    }
}

mod rolling_under_projection {
    use geoint_runtime::{methods::*, prelude::*};

    #[lagrangian(rolling = [v[1] * q[2].cos() - v[0] * q[2].sin()])]
    fn blade(q: [f64; 3], v: [f64; 3]) -> f64 {
        0.7 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 6.9 * q[0]
    }

    fn uses() {
        let _ = Blade.integrator(Projection(RK4, Energy), 0.1, Blade.at([0.0; 3], [0.1, 0.0, 0.3]));
    }
}

fn main() {}
