mod cascade {
    use geoint_runtime::{methods::*, prelude::*};

    /// One wrong method, and everything that may be done with its run.
    #[hamiltonian]
    fn polar(q: [f64; 2], p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1] / (q[0] * q[0])) / 2.0 - 1.0 / q[0]
    }

    fn uses() {
        let mut sim = Polar {}.integrator(BlanesMoan6, 0.1, State::new([1.0, 0.0], [0.0, 1.0]));
        let start = sim.energy();
        sim.advance(100).unwrap();
        for state in sim.sampled(3).take(4) {
            println!("{:?}", state.unwrap());
        }
        for state in sim.until(3.0) {
            println!("{}", state.unwrap().q[0]);
        }
        println!("{} {:?} {}", sim.energy() - start, sim.state(), sim.time());
        sim.set_step_size(0.2);
        sim.step().unwrap();
        sim.compensated().advance_to(3.0).unwrap();
    }
}

mod cascade_of_a_composition {
    use geoint_runtime::{methods::*, prelude::*};

    #[contact_hamiltonian]
    fn van_der_pol(q: f64, p: f64, s: f64, e: f64) -> f64 {
        p * s - e * (1.0 - q * q) * s + q
    }

    fn uses() {
        let mut sim = VanDerPol { e: 5.0 }.integrator(Suzuki4.of(ContactLeapfrog), 0.1, ContactState::new(1.0, 0.0, 0.0));
        let start = sim.energy();
        sim.advance(100).unwrap();
        for state in sim.until(3.0) {
            println!("{}", state.unwrap().s);
        }
        println!("{} {:?}", sim.energy() - start, sim.state());
        sim.step().unwrap();
    }
}

mod cascade_of_steps_that_adapt {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian]
    fn driven(q: f64, p: f64, t: f64) -> f64 {
        p * p / 2.0 - q.cos() * t.sin()
    }

    fn uses() {
        let mut sim = Driven.adaptive(Projection(DOP853, Energy), 1e-9, State::new(1.0, 0.0)).steps_between(1e-3, 1.0);
        let start = sim.energy();
        sim.advance_to(10.0).unwrap();
        for state in sim.until(20.0) {
            println!("{}", state.unwrap().q);
        }
        println!("{} {:?} {}", sim.energy() - start, sim.state(), sim.rejections());
    }
}

mod compose_asymmetric_map {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian]
    fn oscillator(q: f64, p: f64) -> f64 {
        p * p / 2.0 + q * q / 2.0
    }

    fn uses() {
        let _ = Oscillator.integrator(Yoshida4.of(SymplecticEuler), 0.01, State::new(0.5, 1.0));
    }
}

mod composition_on_coupled {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian]
    fn spiral(q: f64, p: f64, b: f64) -> f64 {
        p * p / 2.0 + q * q / 2.0 + b * q * p
    }

    fn uses() {
        let _ = Spiral { b: 0.1 }.integrator(Yoshida4.of(StormerVerlet), 0.01, State::new(0.5, 1.0));
    }
}

mod force_gradient_on_relativistic {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian]
    fn relativistic(q: f64, p: f64) -> f64 {
        (1.0 + p * p).sqrt() + q * q / 2.0
    }

    fn uses() {
        let _ = Relativistic.integrator(Chin4A, 0.01, State::new(0.5, 1.0));
    }
}

mod nystrom_on_relativistic {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian]
    fn relativistic(q: f64, p: f64) -> f64 {
        (1.0 + p * p).sqrt() + q * q / 2.0
    }

    fn uses() {
        let _ = Relativistic.integrator(BlanesMoanSrkn6b, 0.01, State::new(0.5, 1.0));
    }
}

mod pieces_of_separable {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian]
    fn pendulum(q: f64, p: f64) -> f64 {
        p * p / 2.0 - q.cos()
    }

    fn uses() {
        let mut sim = Pendulum.integrator(PieceSplitting, 0.1, State::new(1.0, 0.0));
        let _ = sim.step();
    }
}

mod pieces_split_without_flow {
    use geoint_runtime::prelude::*;

    #[hamiltonian(split = "p[0] * p[0] / 2.0 + q[0].cos() | (p[1] - b * q[0] * q[0]).powi(2) / 2.0 | q[1].cos()")]
    fn charge(q: [f64; 2], p: [f64; 2], b: f64) -> f64 {
        (p[0] * p[0] + (p[1] - b * q[0] * q[0]).powi(2)) / 2.0 + q[0].cos() + q[1].cos()
    }
}

mod pieces_verlet {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn charge(q: [f64; 2], p: [f64; 2], b: f64) -> f64 {
        (p[0] * p[0] + (p[1] - b * q[0] * q[0]).powi(2)) / 2.0
    }

    fn uses() {
        let mut sim = Charge { b: 1.0 }.integrator(StormerVerlet, 0.1, State::new([1.0, 0.5], [0.0, 0.0]));
        let _ = sim.step();
    }
}

mod pieces_without_flow {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian]
    fn rods(q: [f64; 2], p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / (2.0 + (q[0] * p[1]).cos() + q[1].cos() * p[0].cos()) - q[1].cos()
    }

    fn uses() {
        let mut sim = Rods.integrator(PieceSplitting, 0.1, State::new([1.0, 0.5], [0.0, 0.0]));
        let _ = sim.step();
    }
}

mod pieces_without_nystrom {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian]
    fn charge(q: [f64; 2], p: [f64; 2], b: f64) -> f64 {
        (p[0] * p[0] + (p[1] - b * q[0] * q[0]).powi(2)) / 2.0 + q[1].cos()
    }

    fn uses() {
        let mut sim = Charge { b: 1.0 }.integrator(BlanesMoanSrkn14a.of(PieceSplitting), 0.1, State::new([1.0, 0.5], [0.0, 0.0]));
        let _ = sim.step();
    }
}

mod splitting_without_a_flow {
    use geoint_runtime::{methods::*, prelude::*};

    /// The products of inertia couple momenta that are not in involution.
    #[hamiltonian(structure = so3)]
    fn skew_body(x: [f64; 3], a: f64, b: f64) -> f64 {
        x[0] * x[0] / a + x[1] * x[1] + x[2] * x[2] / b + x[0] * x[1] / 10.0
    }

    fn uses() {
        let mut sim = SkewBody { a: 1.2, b: 3.0 }.integrator(PoissonSplitting, 0.01, FlowState::new([1.0; 3]));
        sim.advance(10).unwrap();
    }
}

mod verlet_on_coupled {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn spiral(q: f64, p: f64, b: f64) -> f64 {
        p * p / 2.0 + q * q / 2.0 + b * q * p
    }

    fn uses() {
        let system = Spiral { b: 0.1 };
        let mut sim = system.integrator(StormerVerlet, 0.01, State::new(0.5, 1.0));
        sim.advance(10).unwrap();
    }
}

fn main() {}
