//! Generated steppers beside other generated steppers: the price of a property, and the gain of a structure.

use crate::paired::Pair;
use crate::rows::runs::{contact_run, generated, plane};
use crate::rows::{henon_heiles, kepler, pendulum, planets};
use crate::systems;
use geoint_runtime::method::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::space::{Array, Snapshot};
use geoint_runtime::system::StateOf;
use std::hint::black_box;

/// Steps with exact energy beside explicit steps: one Newton solve against one force.
pub(crate) fn discrete_gradients() -> Vec<Pair> {
    let method = DiscreteGradient;
    let start = State::new(pendulum::START.0, pendulum::START.1);
    vec![
        Pair {
            name: "pendulum, DiscreteGradient".into(),
            subject: generated(pendulum::system(), method, 0.01, start),
            unit: generated(pendulum::system(), StormerVerlet, 0.01, start),
        },
        Pair {
            name: "Kepler, DiscreteGradient".into(),
            subject: generated(kepler::system(), method, 0.01, plane(kepler::START)),
            unit: generated(kepler::system(), StormerVerlet, 0.01, plane(kepler::START)),
        },
        Pair {
            name: "Hénon–Heiles, DiscreteGradient".into(),
            subject: generated(henon_heiles::system(), method, 0.05, plane(henon_heiles::START)),
            unit: generated(henon_heiles::system(), StormerVerlet, 0.05, plane(henon_heiles::START)),
        },
    ]
}

/// Steps of a contact system without the action beside steps with the action.
pub(crate) fn without_action() -> Vec<Pair> {
    let (h, start) = (0.01, ContactState::new([0.6, 0.0], [0.0, 1.5], 0.0));
    let system = move || black_box(systems::DampedKepler { mu: 1.0, alpha: 0.07 });
    vec![Pair {
        name: "damped Kepler, PositionVerlet".into(),
        subject: Box::new(move |steps| {
            let mut sim = system().integrator(PositionVerlet, black_box(h), black_box(start)).without_action();
            sim.advance(black_box(steps)).unwrap();
            let ContactState { q, p, .. } = sim.state();
            vec![q[0], q[1], p[0], p[1]]
        }),
        unit: contact_run(system(), PositionVerlet, h, start),
    }]
}

/// Single steps beside one loop over steps, which merges neighbouring flows.
pub(crate) fn single_steps() -> Vec<Pair> {
    fn pair<S, M>(name: &str, system: S, method: M, h: f64, start: StateOf<S, f64>) -> Pair
    where
        S: PhaseSpace + 'static,
        M: Method<S> + 'static,
    {
        let flat = |state: StateOf<S, f64>| {
            let (_, z, _) = state.parts();
            z.as_slice().to_vec()
        };
        let run = move || Integrator::new(black_box(system), method, black_box(h), start);
        Pair {
            name: name.into(),
            subject: Box::new(move |n| {
                let mut sim = run();
                (0..n).for_each(|_| sim.step().expect("a regular problem"));
                flat(sim.state())
            }),
            unit: Box::new(move |n| {
                let mut sim = run();
                sim.advance(n).expect("a regular problem");
                flat(sim.state())
            }),
        }
    }
    let (system, start) = (pendulum::system(), State::new(pendulum::START.0, pendulum::START.1));
    let (bodies, bodies_start, h) = planets::six_bodies();
    let contact = systems::DampedKepler { mu: 1.0, alpha: 0.07 };
    let contact_start = ContactState::new([0.6, 0.0], [0.0, 1.5], 0.0);
    vec![
        pair("pendulum, StormerVerlet", system, StormerVerlet, 0.01, start),
        pair("pendulum, BlanesMoan4", system, BlanesMoan4, 0.01, start),
        pair("pendulum, DiscreteGradient", system, DiscreteGradient, 0.01, start),
        pair("pendulum, ImplicitMidpoint", system, ImplicitMidpoint, 0.01, start),
        pair("outer solar system, StormerVerlet", bodies, StormerVerlet, h, bodies_start),
        pair("outer solar system, BlanesMoan4", bodies, BlanesMoan4, h, bodies_start),
        pair("outer solar system, DiscreteGradient", bodies, DiscreteGradient, h, bodies_start),
        pair("outer solar system, ImplicitMidpoint", bodies, ImplicitMidpoint, h, bodies_start),
        pair("damped Kepler, ContactSplitting", contact, ContactSplitting, 0.01, contact_start),
    ]
}

/// Methods with an exact part beside a Nyström table: 547 years, with as many steps as each side needs for the same error.
pub(crate) fn exact_parts() -> Vec<Pair> {
    let (bodies, start, _) = planets::six_bodies();
    let years = 200_000.0;
    macro_rules! pair {
        ($error:literal, $method:ident $own:literal, $others:literal) => {{
            let own = generated(black_box(bodies), $method, years / f64::from($own), start);
            Pair {
                name: format!("outer planets to {}, {}", $error, stringify!($method)),
                // The subject covers the time of n steps of the other method.
                subject: Box::new(move |n| own((n * $own).div_ceil($others))),
                unit: generated(black_box(bodies), BlanesMoanSrkn14a, years / f64::from($others), start),
            }
        }};
    }
    vec![
        pair!("1e-3", WisdomHolman 369, 211),
        pair!("1e-6", WisdomHolmanProcessed 646, 743),
        pair!("1e-9", WisdomHolmanGradient 1129, 2271),
        pair!("1e-11", WisdomHolmanGradient 2612, 4569),
        pair!("1e-11", Saba5Gradient 854, 4569),
    ]
}
