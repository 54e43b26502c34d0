use geoint_runtime::prelude::*;

#[lagrangian]
fn stiff(q: f64, v: f64) -> f64 {
    0.5 * v * v + 0.25 * v.powi(4) - 0.5 * q * q
}

fn main() -> Result<(), StepError> {
    let mut sim = Stiff.integrator(DiscreteGradient, 0.1, Stiff.at(0.1, 0.2));
    sim.advance(10)
}
