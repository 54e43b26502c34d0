//! Child program of the ablation: times implicit steps and prints one row for each.
//!
//! The ablation compiles this program once for each variant of the runtime. Columns: name, nanoseconds a step, final state or reason of
//! failure.

#[allow(dead_code, reason = "the ablation times single runs")]
#[path = "../../paired.rs"]
mod paired;
mod systems;

use geoint_runtime::method::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::space::{Array, Snapshot};
use geoint_runtime::system::StateOf;
use std::hint::black_box;

/// Steps of a run: many enough that start-up, the first eleven steps, does not matter.
const STEPS: u64 = 1024;

/// Takes a number of steps and returns the final state.
type Attempt = Box<dyn Fn(u64) -> Result<Vec<f64>, StepError>>;

fn main() {
    println!("name,nanoseconds,state");
    let rows = [gauss(), contact(), fourth_order(), many_unknowns()];
    for (name, attempt) in rows.into_iter().flatten() {
        match attempt(STEPS) {
            Ok(state) => {
                let run: paired::Run = Box::new(move |n| attempt(n).expect("the same steps as before"));
                let state: Vec<_> = state.iter().map(f64::to_string).collect();
                println!("{name},{},{}", paired::nanoseconds(&run, STEPS), state.join(" "));
            }
            Err(error) => println!("{name},NaN,failed: {}", error.to_string().replace([',', '\n', '"'], " ")),
        }
    }
}

fn row<S, M>(name: &str, system: S, method: M, h: f64, start: StateOf<S, f64>) -> (String, Attempt)
where
    S: PhaseSpace + 'static,
    M: Method<S> + 'static,
    StateOf<S, f64>: Copy,
{
    let attempt: Attempt = Box::new(move |steps| {
        let mut run = Integrator::new(black_box(system), method, black_box(h), start);
        run.advance(steps)?;
        let (_, z, _) = run.state().parts();
        Ok(z.as_slice().to_vec())
    });
    (format!("{name}; h = {h}"), attempt)
}

/// The same system and method with several step sizes.
macro_rules! rows {
    ($($group:literal: $name:literal, $system:expr, $method:expr, $start:expr, [$($h:literal),*];)*) => {
        vec![$($(row(concat!($group, ": ", $name), $system, $method, $h, $start)),*),*]
    };
}

fn gauss() -> Vec<(String, Attempt)> {
    let pendulum = systems::Pendulum { m: 1.3, l: 0.7, g: 9.81 };
    let from_rest = State::new(2.0, 0.0);
    let orbit = State::new([0.4, 0.0], [0.0, 2.0]);
    let galaxy = State::new([0.1, 0.2], [0.3, 0.1]);
    let angles = State::new([0.5, 0.9], [0.0, 0.0]);
    let (double, lagrangian) = (systems::DoublePendulum { g: 9.81 }, systems::DoublePendulumLagrangian { g: 9.81 });
    rows! {
        "Gauss": "pendulum; Gauss<2>", pendulum, Gauss::<2>, from_rest, [0.02, 0.2];
        "Gauss": "pendulum; Gauss<3>", pendulum, Gauss::<3>, from_rest, [0.05, 0.3];
        "Gauss": "Kepler; Gauss<2>", systems::Kepler {}, Gauss::<2>, orbit, [0.005, 0.05];
        "Gauss": "Hénon–Heiles; ImplicitMidpoint", systems::HenonHeiles {}, ImplicitMidpoint, galaxy, [0.05, 0.3];
        "Gauss": "double pendulum; ImplicitMidpoint", double, ImplicitMidpoint, angles, [0.01, 0.1];
        "Gauss": "double pendulum; Suzuki4.of(ImplicitMidpoint)", double, Suzuki4.of(ImplicitMidpoint), angles, [0.01, 0.1];
        "Gauss": "double pendulum; Gauss<2>", double, Gauss::<2>, angles, [0.02, 0.1];
        "Gauss": "double pendulum by its Lagrangian; Gauss<2>", lagrangian, Gauss::<2>, angles, [0.02, 0.1];
    }
}

fn contact() -> Vec<(String, Attempt)> {
    let (pendulum, varying) = (systems::DampedPendulum { gamma: 0.001 }, systems::VaryingPendulum { gamma: 0.001 });
    let (kepler, double) =
        (systems::DampedKepler { gamma: 0.001 }, systems::DampedDoublePendulum { g: 9.81, gamma: 0.001 });
    let from_rest = ContactState::new(2.0, 0.0, 0.0);
    let orbit = ContactState::new([0.6, 0.0], [0.0, 1.5], 0.0);
    let angles = ContactState::new([0.5, 0.9], [0.0, 0.0], 0.0);
    rows! {
        "contact": "pendulum; ContactMidpoint", pendulum, ContactMidpoint, from_rest, [0.05, 0.5];
        "contact": "Kepler; ContactMidpoint", kepler, ContactMidpoint, orbit, [0.01, 0.05];
        "contact": "Kepler; ContactGauss<2>", kepler, ContactGauss::<2>, orbit, [0.02, 0.1];
        "contact": "pendulum with friction of s²; ContactGauss<2>", varying, ContactGauss::<2>, from_rest, [0.1, 0.5];
        "contact": "pendulum; ContactDiscreteGradient", pendulum, ContactDiscreteGradient, from_rest, [0.05, 0.5];
        "contact": "Kepler; ContactDiscreteGradient", kepler, ContactDiscreteGradient, orbit, [0.01, 0.1];
        "contact": "double pendulum by its Lagrangian; ContactGauss<2>", double, ContactGauss::<2>, angles, [0.02];
        "contact": "double pendulum by its Lagrangian; ContactDiscreteGradient", double, ContactDiscreteGradient, angles, [0.02];
    }
}

fn fourth_order() -> Vec<(String, Attempt)> {
    let pendulum = systems::Pendulum { m: 1.3, l: 0.7, g: 9.81 };
    let top = systems::Top { inertia: [1.0, 2.0, 3.0] };
    let method = FourthOrder(DiscreteGradient);
    rows! {
        "order 4": "pendulum", pendulum, method, State::new(2.0, 0.0), [0.02, 0.2];
        "order 4": "Kepler", systems::Kepler {}, method, State::new([0.4, 0.0], [0.0, 2.0]), [0.005, 0.05];
        "order 4": "Hénon–Heiles", systems::HenonHeiles {}, method, State::new([0.1, 0.2], [0.3, 0.1]), [0.05, 0.3];
        "order 4": "Euler's top", top, method, FlowState::new([0.5, 1.6, -1.2]), [0.02, 0.6];
    }
}

fn many_unknowns() -> Vec<(String, Attempt)> {
    let start = State::new(std::array::from_fn(|i| 0.2 * (0.3 * i as f64).sin()), [0.0; 20]);
    let (chain, linear) = (systems::Chain { alpha: 0.25 }, systems::LinearChain { k: 1.3 });
    rows! {
        "20 particles": "chain; DiscreteGradient", chain, DiscreteGradient, start, [0.05, 0.3, 1.5];
        "20 particles": "chain; ImplicitMidpoint", chain, ImplicitMidpoint, start, [0.05, 1.5];
        "20 particles": "chain; Gauss<2>", chain, Gauss::<2>, start, [0.1];
        "20 particles": "linear chain; DiscreteGradient", linear, DiscreteGradient, start, [0.1];
    }
}
