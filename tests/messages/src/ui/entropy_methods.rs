use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// Two bodies in contact.
#[hamiltonian(
    structure = |_, _| 0.0,
    entropy = x[0].ln() + x[1].ln(),
    friction = [[k, -k], [-k, k]],
)]
fn bodies(x: [f64; 2], k: f64) -> f64 {
    x[0] + x[1]
}

fn steps_back_in_time() {
    let start = FlowState::new([1.0, 2.0]);
    let _ = Bodies { k: 0.1 }.integrator(Suzuki4.of(DiscreteGradient), 0.1, start);
    let _ = Bodies { k: 0.1 }.integrator(Yoshida4.of(DiscreteGradient), 0.1, start);
}

fn order_4() {
    let start = FlowState::new([1.0, 2.0]);
    let _ = Bodies { k: 0.1 }.integrator(FourthOrder(DiscreteGradient), 0.1, start);
}

fn pieces() {
    let start = FlowState::new([1.0, 2.0]);
    let _ = Bodies { k: 0.1 }.integrator(PlanarSplitting, 0.1, start);
}

fn main() {}
