mod contact_leapfrog_on_van_der_pol {
    use geoint_runtime::{methods::*, prelude::*};

    #[contact_hamiltonian]
    fn van_der_pol(q: f64, p: f64, s: f64, e: f64) -> f64 {
        p * s - e * (1.0 - q * q) * s + q
    }

    fn uses() {
        let _ = VanDerPol { e: 5.0 }.integrator(ContactLeapfrog, 0.1, ContactState::new(1.0, 0.0, 0.0));
    }
}

mod contact_lift_implicit {
    use geoint_runtime::{methods::*, prelude::*};

    #[contact_hamiltonian(lift)]
    fn decay(q: f64, p: f64, _s: f64) -> f64 {
        p * (q - q.powi(3))
    }

    fn uses() {
        let _ = Decay.integrator(ContactMidpoint, 0.1, ContactState::new(1.0, 0.0, 0.0));
    }
}

mod contact_lift_of_a_drift {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian(lift)]
    fn swing(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
        p * p / 2.0 + q.cos() + gamma * s
    }
}

mod contact_lift_without_action {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian(lift)]
    fn growth(q: f64, p: f64, rate: f64) -> f64 {
        p * rate * q
    }

    fn uses() {
        println!("{}", growth(1.0, 0.0, 0.5));
    }
}

mod contact_method_of_hamiltonian {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian]
    fn swing(q: f64, p: f64, s: f64) -> f64 {
        p * p / 2.0 + q.cos() + 0.1 * s
    }

    fn uses() {
        let _ = Swing.integrator(DiscreteGradient, 0.1, ContactState::new(1.0, 0.0, 0.0));
    }
}

mod contact_method_on_hamiltonian {
    use geoint_runtime::prelude::*;

    #[hamiltonian]
    fn swing(q: f64, p: f64) -> f64 {
        p * p / 2.0 + q.cos()
    }

    fn uses() {
        let _ = Swing.integrator(ContactSplitting, 0.1, State::new(1.0, 0.0));
    }
}

mod contact_no_split {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian]
    fn entangled(q: f64, p: f64, s: f64) -> f64 {
        p * p / 2.0 + (q * p).sin() * s
    }

    fn uses() {
        let _ = Entangled.integrator(ContactSplitting, 0.1, ContactState::new(1.0, 0.0, 0.0));
    }
}

mod contact_nystrom_on_frozen_time {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian]
    fn swing(q: f64, p: f64, s: f64, t: f64) -> f64 {
        p * p / 2.0 + q.cos() + 0.1 * t.sin() * s
    }

    fn uses() {
        let _ = Swing.integrator(BlanesMoanSrkn14a, 0.1, ContactState::new(1.0, 0.0, 0.0));
    }
}

mod contact_projection {
    use geoint_runtime::{methods::*, prelude::*};

    #[contact_hamiltonian]
    fn swing(q: f64, p: f64, s: f64) -> f64 {
        p * p / 2.0 + q.cos() + 0.1 * s
    }

    fn uses() {
        let _ = Swing.integrator(Projection(RK4, Energy), 0.1, ContactState::new(1.0, 0.0, 0.0));
    }
}

mod contact_without_action {
    use geoint_runtime::prelude::*;

    #[contact_hamiltonian]
    fn swing(q: f64, p: f64, s: f64) -> f64 {
        p * p / 2.0 + q.cos() + 0.1 * q * s
    }

    fn uses() {
        let _ = Swing.integrator(ContactSplitting, 0.1, ContactState::new(1.0, 0.0, 0.0)).without_action();
    }
}

fn main() {}
