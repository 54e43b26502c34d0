//! What a step costs: each generated stepper beside an expert's hand-written one.
//!
//! `cargo bench -p geoint-benches --bench step` prints the table of ratios, then criterion's absolute figures, a step each.
//! `RATIOS=only` leaves the second part out.

#[allow(dead_code, reason = "run time against error has all of it")]
mod by_hand;
mod paired;
mod systems;

use by_hand::Stages;
use criterion::Criterion;
use geoint_runtime::method::Method;
use geoint_runtime::prelude::*;
use geoint_runtime::space::Array;
use geoint_runtime::space::{Coordinates, Snapshot};
use geoint_runtime::system::StateOf;
use geoint_tests::outer_planets;
use nalgebra::{UnitQuaternion, Vector3};
use paired::{Pair, Ratio, Run};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Steps after which generated and hand-written trajectories are compared, and how far they may be apart.
const COMPARED: (u64, f64) = (1000, 1e-12);

fn main() {
    let by_hand: Vec<Pair> =
        [pendulum(), kepler(), contact(), henon_heiles(), outer_solar_system(), double_pendulum(), flows(), bodies()]
            .into_iter()
            .flatten()
            .collect();
    for pair in &by_hand {
        let (steps, bound) = COMPARED;
        let difference = pair.difference(steps);
        assert!(difference <= bound, "{}: generated and hand-written differ by {difference:.1e}", pair.name);
    }
    let discrete = discrete_gradients();
    let action = without_action();
    let single = single_steps();
    let exact = exact_parts();

    // A test run only wants to know whether this runs.
    if !std::env::args().any(|arg| arg == "--test" || arg == "--list") {
        table("generated / hand-written", &by_hand);
        table("discrete gradient / Verlet", &discrete);
        table("without the action / with it", &action);
        table("step() in a loop / advance(n)", &single);
        table("A + B / BlanesMoanSrkn14a, same error", &exact);
    }
    if std::env::var("RATIOS").is_ok_and(|value| value == "only") {
        return;
    }
    let mut criterion = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(800))
        .without_plots()
        .configure_from_args();
    for pair in &by_hand {
        absolute(&mut criterion, &format!("{}, generated", pair.name), &pair.subject);
        absolute(&mut criterion, &format!("{}, by hand", pair.name), &pair.unit);
    }
    criterion.final_summary();
}

fn table(title: &str, pairs: &[Pair]) {
    // As for criterion, the first argument that is not an option selects by name.
    let selected = std::env::args().skip(1).find(|arg| !arg.starts_with('-')).unwrap_or_default();
    println!("\n{title:<40} ratio  quartiles       ns/step");
    for pair in pairs.iter().filter(|pair| pair.name.contains(&selected)) {
        let Ratio { median, quartiles: [low, high], nanoseconds: [subject, unit] } = pair.ratio();
        println!("{:<40} {median:.3}  {low:.3} … {high:.3}  {subject:.1} / {unit:.1}", pair.name);
    }
}

/// One step as criterion's unit.
fn absolute(criterion: &mut Criterion, name: &str, run: &Run) {
    criterion.bench_function(name, |bencher| {
        bencher.iter_custom(|steps| {
            let start = Instant::now();
            black_box(run(steps));
            start.elapsed()
        });
    });
}

// ---------------------------------------------------------------------------------------------------------- problems

const PENDULUM: (f64, f64) = (2.0, 0.0);
const KEPLER: [f64; 4] = [0.4, 0.0, 0.0, 2.6];
const HENON_HEILES: [f64; 4] = [0.1, 0.2, 0.3, 0.1];

fn pendulum_system() -> systems::Pendulum {
    black_box(systems::Pendulum { m: 1.3, l: 0.7, g: 9.81 })
}

fn kepler_system() -> systems::Kepler {
    black_box(systems::Kepler { m: 1.3, mu: 1.0 })
}

fn henon_heiles_system() -> systems::HenonHeiles {
    black_box(systems::HenonHeiles { lambda: 0.9 })
}

fn pendulum() -> Vec<Pair> {
    let (h, start) = (0.01, State::new(PENDULUM.0, PENDULUM.1));
    let hand = || {
        let systems::Pendulum { m, l, g } = pendulum_system();
        black_box(by_hand::pendulum::Pendulum { m, l, g })
    };
    let flat = |(q, p)| vec![q, p];
    vec![
        Pair {
            name: "pendulum, StormerVerlet".into(),
            subject: generated(pendulum_system(), StormerVerlet, h, start),
            unit: Box::new(move |n| flat(hand().verlet(black_box(h), n, PENDULUM))),
        },
        Pair {
            name: "pendulum, BlanesMoan4".into(),
            subject: generated(pendulum_system(), BlanesMoan4, h, start),
            unit: Box::new(move |n| flat(hand().kicks_first(Stages::of(&BlanesMoan4), black_box(h), n, PENDULUM))),
        },
        Pair {
            name: "pendulum, DiscreteGradient".into(),
            subject: generated(pendulum_system(), DiscreteGradient, h, start),
            unit: Box::new(move |n| flat(hand().discrete_gradient::<false>(black_box(h), n, PENDULUM))),
        },
        Pair {
            name: "pendulum, DiscreteGradient, same sums".into(),
            subject: generated(pendulum_system(), DiscreteGradient, h, start),
            unit: Box::new(move |n| flat(hand().discrete_gradient::<true>(black_box(h), n, PENDULUM))),
        },
    ]
}

fn kepler() -> Vec<Pair> {
    let (h, start) = (0.01, plane(KEPLER));
    let hand = || {
        let systems::Kepler { m, mu } = kepler_system();
        black_box(by_hand::kepler::Kepler { m, mu })
    };
    vec![
        Pair {
            name: "Kepler, StormerVerlet".into(),
            subject: generated(kepler_system(), StormerVerlet, h, start),
            unit: Box::new(move |n| hand().verlet(black_box(h), n, KEPLER).to_vec()),
        },
        Pair {
            name: "Kepler, BlanesMoan4".into(),
            subject: generated(kepler_system(), BlanesMoan4, h, start),
            unit: Box::new(move |n| hand().kicks_first(Stages::of(&BlanesMoan4), black_box(h), n, KEPLER).to_vec()),
        },
        Pair {
            name: "Kepler, DiscreteGradient".into(),
            subject: generated(kepler_system(), DiscreteGradient, h, start),
            unit: Box::new(move |n| hand().discrete_gradient::<false>(black_box(h), n, KEPLER).to_vec()),
        },
        Pair {
            name: "Kepler, DiscreteGradient, same sums".into(),
            subject: generated(kepler_system(), DiscreteGradient, h, start),
            unit: Box::new(move |n| hand().discrete_gradient::<true>(black_box(h), n, KEPLER).to_vec()),
        },
    ]
}

/// Contact systems: S2 of kick and damped drift.
fn contact() -> Vec<Pair> {
    let (h, z, alpha) = (0.01, [0.6, 0.0, 0.0, 1.5, 0.0], 0.07);
    let start = ContactState::new([z[0], z[1]], [z[2], z[3]], z[4]);
    let driven = move || black_box(systems::DrivenKepler { mu: 1.0, alpha, omega: std::f64::consts::TAU });
    let damped = move || black_box(systems::DampedKepler { mu: 1.0, alpha });
    let hand =
        move || black_box(by_hand::perturbed_kepler::PerturbedKepler { mu: 1.0, alpha, omega: std::f64::consts::TAU });
    vec![
        Pair {
            name: "driven Kepler, ContactSplitting".into(),
            subject: contact_run(driven(), ContactSplitting, h, start),
            unit: Box::new(move |n| hand().driven(black_box(h), n, z).to_vec()),
        },
        Pair {
            name: "damped Kepler, ContactSplitting".into(),
            subject: contact_run(damped(), ContactSplitting, h, start),
            unit: Box::new(move |n| hand().damped(black_box(h), n, z).to_vec()),
        },
        Pair {
            name: "damped Kepler, PositionVerlet".into(),
            subject: contact_run(damped(), PositionVerlet, h, start),
            unit: Box::new(move |n| hand().damped(black_box(h), n, z).to_vec()),
        },
    ]
}

/// What is saved where nobody reads s: the value of the potential, and s itself.
fn without_action() -> Vec<Pair> {
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

fn contact_run<S, M>(system: S, method: M, h: f64, start: ContactState<[f64; 2]>) -> Run
where
    S: PhaseSpace<State = ContactState<[f64; 2]>, Phase = [[f64; 2]; 2], Action = f64> + 'static,
    M: Method<S> + 'static,
{
    Box::new(move |steps| {
        let mut sim = Integrator::new(system, black_box(method), black_box(h), black_box(start));
        sim.advance(black_box(steps)).unwrap();
        let ContactState { q, p, s, .. } = sim.state();
        vec![q[0], q[1], p[0], p[1], s]
    })
}

fn henon_heiles() -> Vec<Pair> {
    let (h, start) = (0.05, plane(HENON_HEILES));
    let hand = || black_box(by_hand::henon_heiles::HenonHeiles { lambda: henon_heiles_system().lambda });
    let verlet = |name: &str, unit| Pair {
        name: name.into(),
        subject: generated(henon_heiles_system(), StormerVerlet, h, start),
        unit,
    };
    let blanes_moan_4 = |name: &str, unit| Pair {
        name: name.into(),
        subject: generated(henon_heiles_system(), BlanesMoan4, h, start),
        unit,
    };
    vec![
        verlet(
            "Hénon–Heiles, StormerVerlet",
            Box::new(move |n| hand().verlet::<false>(black_box(h), n, HENON_HEILES).to_vec()),
        ),
        verlet(
            "Hénon–Heiles, StormerVerlet, by terms",
            Box::new(move |n| hand().verlet::<true>(black_box(h), n, HENON_HEILES).to_vec()),
        ),
        blanes_moan_4(
            "Hénon–Heiles, BlanesMoan4",
            Box::new(move |n| {
                hand().kicks_first::<false, 6>(Stages::of(&BlanesMoan4), black_box(h), n, HENON_HEILES).to_vec()
            }),
        ),
        blanes_moan_4(
            "Hénon–Heiles, BlanesMoan4, by terms",
            Box::new(move |n| {
                hand().kicks_first::<true, 6>(Stages::of(&BlanesMoan4), black_box(h), n, HENON_HEILES).to_vec()
            }),
        ),
        Pair {
            name: "Hénon–Heiles, DiscreteGradient".into(),
            subject: generated(henon_heiles_system(), DiscreteGradient, h, start),
            unit: Box::new(move |n| hand().discrete_gradient::<false>(black_box(h), n, HENON_HEILES).to_vec()),
        },
        Pair {
            name: "Hénon–Heiles, DiscreteGradient, same sums".into(),
            subject: generated(henon_heiles_system(), DiscreteGradient, h, start),
            unit: Box::new(move |n| hand().discrete_gradient::<true>(black_box(h), n, HENON_HEILES).to_vec()),
        },
    ]
}

fn six_bodies() -> (systems::OuterSolarSystem, State<[Vector3<f64>; 6]>, f64) {
    (systems::OuterSolarSystem { m: outer_planets::MASSES, g: outer_planets::G }, outer_planets::start(), 50.0)
}

fn outer_solar_system() -> Vec<Pair> {
    let (bodies, start, h) = six_bodies();
    let system = || black_box(bodies);
    let hand = move || black_box(by_hand::outer_solar_system::OuterSolarSystem { m: bodies.m, g: bodies.g });
    let (q, p) = (start.q.into_array(), start.p.into_array());
    let flat = |(q, p): ([[f64; 3]; 6], [[f64; 3]; 6])| [q, p].as_flattened().as_flattened().to_vec();
    vec![
        Pair {
            name: "outer solar system, StormerVerlet".into(),
            subject: generated(system(), StormerVerlet, h, start),
            unit: Box::new(move |n| flat(hand().verlet(black_box(h), n, (q, p)))),
        },
        Pair {
            name: "outer solar system, BlanesMoanSrkn14a".into(),
            subject: generated(system(), BlanesMoanSrkn14a, h, start),
            unit: Box::new(move |n| {
                flat(hand().drifts_first(Stages::of(BlanesMoanSrkn14a.table()), black_box(h), n, (q, p)))
            }),
        },
    ]
}

/// What an exact part is worth: 547 years to the same error of positions and velocities, of which both sides have the steps that they need.
fn exact_parts() -> Vec<Pair> {
    let (bodies, start, _) = six_bodies();
    let years = 200_000.0;
    macro_rules! pair {
        ($error:literal, $method:ident $own:literal, $others:literal) => {{
            let own = generated(black_box(bodies), $method, years / f64::from($own), start);
            Pair {
                name: format!("outer planets to {}, {}", $error, stringify!($method)),
                // As long a way as so many steps of the other method.
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

fn double_pendulum() -> Vec<Pair> {
    let (m, l, g, h) = ([1.3, 0.7], [0.9, 1.1], 9.81, 0.01);
    // Regular motion: trajectories of a chaotic one part, however equal the programs are.
    let start = [0.5, 0.9, 0.0, 0.0];
    let hand = move || black_box(by_hand::double_pendulum::DoublePendulum { m, l, g });
    let system = || black_box(systems::DoublePendulum { m, l, g });
    let mut pairs = vec![Pair {
        name: "double pendulum, ImplicitMidpoint".into(),
        subject: generated(system(), ImplicitMidpoint, h, plane(start)),
        unit: Box::new(move |n| hand().implicit_midpoint(black_box(h), n, start).to_vec()),
    }];
    // At longer steps increments are no longer extrapolated.
    for h in [0.01, 0.05] {
        pairs.push(Pair {
            name: format!("double pendulum, Suzuki4.of(ImplicitMidpoint), h = {h}"),
            subject: generated(system(), Suzuki4.of(ImplicitMidpoint), h, plane(start)),
            unit: Box::new(move |n| hand().composed(Suzuki4.weights(), black_box(h), n, start).to_vec()),
        });
    }
    pairs
}

/// Fields with integrals: predators and prey, a free body.
fn flows() -> Vec<Pair> {
    let (h, start) = (0.02, [1.0, 0.5]);
    let predators = || black_box(systems::LotkaVolterra { a: 2.0, b: 1.0, c: 1.0 });
    let hand = move || {
        let systems::LotkaVolterra { a, b, c } = predators();
        black_box(by_hand::lotka_volterra::LotkaVolterra { a, b, c })
    };
    let (inertia, velocity) = ([1.0, 2.0, 3.0], [0.5, 0.8, -0.4]);
    let momentum = [0, 1, 2].map(|i| inertia[i] * velocity[i]);
    let body = move || black_box(by_hand::free_body::FreeBody { inertia });
    let (momenta, velocities) = (systems::FreeMomentum { inertia }, systems::FreeVelocity { inertia });
    vec![
        Pair {
            name: "Lotka–Volterra, DiscreteGradient".into(),
            subject: flow(predators(), DiscreteGradient, h, start),
            unit: Box::new(move |n| hand().discrete_gradient::<false>(black_box(h), n, start).to_vec()),
        },
        Pair {
            name: "Lotka–Volterra, DiscreteGradient, same sums".into(),
            subject: flow(predators(), DiscreteGradient, h, start),
            unit: Box::new(move |n| hand().discrete_gradient::<true>(black_box(h), n, start).to_vec()),
        },
        Pair {
            name: "Euler's top, DiscreteGradient".into(),
            subject: flow(momenta, DiscreteGradient, h, momentum),
            unit: Box::new(move |n| body().discrete_gradient::<false>(black_box(h), n, momentum).to_vec()),
        },
        Pair {
            name: "Euler's top, DiscreteGradient, same sums".into(),
            subject: flow(momenta, DiscreteGradient, h, momentum),
            unit: Box::new(move |n| body().discrete_gradient::<true>(black_box(h), n, momentum).to_vec()),
        },
        Pair {
            name: "Euler's top, PlanarSplitting".into(),
            subject: flow(velocities, PlanarSplitting, h, velocity),
            unit: Box::new(move |n| body().rotations(black_box(h), n, velocity).to_vec()),
        },
    ]
}

fn flow<S, M, const N: usize>(system: S, method: M, h: f64, start: [f64; N]) -> Run
where
    S: PhaseSpace<State = FlowState<[f64; N]>> + 'static,
    M: Method<S> + 'static,
{
    Box::new(move |n| {
        let mut sim = Integrator::new(black_box(system), method, black_box(h), FlowState::new(start));
        sim.advance(n).expect("a regular problem");
        sim.state().x.to_vec()
    })
}

/// A heavy body by its attitude.
fn bodies() -> Vec<Pair> {
    let (h, inertia, c) = (0.05, [1.0, 2.0, 3.0], [0.3, -0.2, 0.7]);
    let momentum = [0.5, 1.6, -1.2];
    let hand = move || black_box(by_hand::heavy_body::HeavyBody { inertia, c });
    vec![Pair {
        name: "heavy body, StormerVerlet".into(),
        subject: Box::new(move |n| {
            let system = black_box(systems::HeavyBody { inertia, c: Vector3::from(c) });
            let start = BodyState::new(UnitQuaternion::identity(), Vector3::from(momentum));
            let mut sim = system.integrator(StormerVerlet, black_box(h), start);
            sim.advance(n).expect("a regular problem");
            let BodyState { r, m, .. } = sim.state();
            [r.coords.as_slice(), m.as_slice()].concat()
        }),
        unit: Box::new(move |n| {
            let (r, m) = hand().verlet(black_box(h), n, [0.0, 0.0, 0.0, 1.0], momentum);
            [&r[..], &m].concat()
        }),
    }]
}

/// What exact energy costs: one Newton solve against one force.
fn discrete_gradients() -> Vec<Pair> {
    let method = DiscreteGradient;
    let pendulum = State::new(PENDULUM.0, PENDULUM.1);
    vec![
        Pair {
            name: "pendulum, DiscreteGradient".into(),
            subject: generated(pendulum_system(), method, 0.01, pendulum),
            unit: generated(pendulum_system(), StormerVerlet, 0.01, pendulum),
        },
        Pair {
            name: "Kepler, DiscreteGradient".into(),
            subject: generated(kepler_system(), method, 0.01, plane(KEPLER)),
            unit: generated(kepler_system(), StormerVerlet, 0.01, plane(KEPLER)),
        },
        Pair {
            name: "Hénon–Heiles, DiscreteGradient".into(),
            subject: generated(henon_heiles_system(), method, 0.05, plane(HENON_HEILES)),
            unit: generated(henon_heiles_system(), StormerVerlet, 0.05, plane(HENON_HEILES)),
        },
    ]
}

/// What steps one by one cost, a pendulum and six bodies: with flows that are merged in the loop, and without.
fn single_steps() -> Vec<Pair> {
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
    let (system, start) = (pendulum_system(), State::new(PENDULUM.0, PENDULUM.1));
    let (bodies, bodies_start, h) = six_bodies();
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

/// A state from (q₀, q₁, p₀, p₁).
fn plane([q0, q1, p0, p1]: [f64; 4]) -> State<[f64; 2]> {
    State::new([q0, q1], [p0, p1])
}

/// The generated stepper, parameters and step size hidden from the optimiser.
fn generated<S, M>(system: S, method: M, h: f64, start: State<S::Coordinates>) -> Run
where
    S: Hamiltonian + 'static,
    S::Coordinates: 'static,
    M: Method<S, f64> + 'static,
{
    Box::new(move |n| {
        let mut sim = Integrator::new(black_box(system), method, black_box(h), start);
        sim.advance(n).expect("a regular problem");
        let State { q, p, .. } = sim.state();
        [q, p].iter().flat_map(|x| x.into_array().as_slice().to_vec()).collect()
    })
}
