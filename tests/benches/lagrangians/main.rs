//! What a Lagrangian costs: beside the energy that one derives by hand, beside the energy that LDLᵀ makes of it, and beside its steps
//! written by hand.
//!
//! `cargo bench -p geoint-benches --bench lagrangians` prints the ratios; an argument selects rows by name.

mod chain;
#[path = "../paired.rs"]
mod paired;
mod systems;

use geoint_runtime::Coordinates;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::system::StateOf;
use paired::{Pair, Ratio, Run};
use std::hint::black_box;

/// Steps after which both sides are compared, and how far they may be apart: two solutions of the same equations, or two methods of order 4.
const COMPARED: u64 = 200;
const EQUAL: f64 = 1e-11;
const CLOSE: f64 = 1e-5;

fn main() {
    let tables = [
        ("from L / from H by hand", EQUAL, double_pendulums()),
        ("constant mass, from L / from H", EQUAL, constant_masses()),
        ("velocities / H by LDLᵀ", EQUAL, chains()),
        ("velocities / by hand", EQUAL, by_hand()),
        ("ContactGauss<2> / Suzuki4 of midpoints", CLOSE, with_actions()),
    ];
    for (_, bound, pairs) in &tables {
        for pair in pairs {
            let difference = pair.difference(COMPARED);
            assert!(difference <= *bound, "{}: both sides differ by {difference:.1e}", pair.name);
        }
    }
    // A test run only wants to know whether this runs.
    if std::env::args().any(|arg| arg == "--test" || arg == "--list") {
        return;
    }
    let selected = std::env::args().skip(1).find(|arg| !arg.starts_with('-')).unwrap_or_default();
    for (title, _, pairs) in tables {
        println!("\n{title:<40} ratio  quartiles       ns/step");
        for pair in pairs.iter().filter(|pair| pair.name.contains(&selected)) {
            let Ratio { median, quartiles: [low, high], nanoseconds: [subject, unit] } = pair.ratio();
            println!("{:<40} {median:.3}  {low:.3} … {high:.3}  {subject:.1} / {unit:.1}", pair.name);
        }
    }
}

fn run<S, M, const N: usize>(system: S, method: M, h: f64, start: State<[f64; N]>) -> Run
where
    S: PhaseSpace<State = State<[f64; N]>> + 'static,
    M: Method<S> + 'static,
    StateOf<S, f64>: Copy,
{
    Box::new(move |steps| {
        let mut sim = Integrator::new(black_box(system), black_box(method), black_box(h), black_box(start));
        sim.advance(black_box(steps)).expect("a regular problem");
        let State { q, p, .. } = sim.state();
        [q, p].concat()
    })
}

/// Two velocities: the energy is made of L, and is compared with the one derived by hand.
fn double_pendulums() -> Vec<Pair> {
    let (m, l, g, h) = ([1.3, 0.7], [0.9, 1.1], 9.81, 0.01);
    let start = State::new([0.5, 0.9], [0.0, 0.0]);
    let (by_velocities, by_momenta) =
        (systems::PendulumOfVelocities { m, l, g }, systems::PendulumOfMomenta { m, l, g });
    macro_rules! pairs {
        ($($name:literal, $method:expr;)*) => { vec![$(
            Pair {
                name: concat!("double pendulum, ", $name).into(),
                subject: run(by_velocities, $method, h, start),
                unit: run(by_momenta, $method, h, start),
            },
        )*] };
    }
    let mut pairs = pairs! {
        "ImplicitMidpoint", ImplicitMidpoint;
        "Gauss<2>", Gauss::<2>;
        "Gauss<3>", Gauss::<3>;
    };
    pairs.push(Pair {
        name: "double pendulum, DiscreteGradient".into(),
        subject: energy(by_velocities, h, start),
        unit: energy(by_momenta, h, start),
    });
    pairs
}

const G: f64 = 9.81;
const THREE: ([f64; 3], [f64; 3]) = ([1.3, 0.7, 0.9], [0.9, 1.1, 0.8]);
const SIX: ([f64; 6], [f64; 6]) = ([1.3, 0.7, 0.9, 0.5, 1.1, 0.8], [0.9, 1.1, 0.8, 1.0, 0.7, 0.6]);
/// Regular motion: trajectories of a chaotic one part, however equal the programs are.
const HANGING: [f64; 6] = [0.3, 0.35, 0.4, 0.3, 0.2, 0.25];

fn hanging<const N: usize>() -> State<[f64; N]> {
    State::new(core::array::from_fn(|i| HANGING[i]), [0.0; N])
}

/// A constant mass matrix: the energy that is made of L is the one that one would write.
fn constant_masses() -> Vec<Pair> {
    let (m, h, start) = ([1.3, 0.7], 0.05, State::new([0.1, -0.2], [0.15, 0.1]));
    let (of_velocities, of_momenta) = (systems::CubicOfVelocities { m }, systems::CubicOfMomenta { m });
    macro_rules! pairs {
        ($($method:expr),*) => { vec![$(Pair {
            name: format!("Hénon–Heiles, {}", stringify!($method)),
            subject: run(of_velocities, $method, h, start),
            unit: run(of_momenta, $method, h, start),
        }),*] };
    }
    pairs![StormerVerlet, BlanesMoan4, Gauss::<2>, DiscreteGradient]
}

/// Chains of point masses, by velocities and by the energy that LDLᵀ makes.
fn chains() -> Vec<Pair> {
    let [short, long] = [0.002, 0.001];
    let (three, six) = (systems::Chain3 { m: THREE.0, l: THREE.1, g: G }, systems::Chain6 { m: SIX.0, l: SIX.1, g: G });
    let three_h = systems::Chain3Energy { m: THREE.0, l: THREE.1, g: G };
    let six_h = systems::Chain6Energy { m: SIX.0, l: SIX.1, g: G };
    let pair = |name: &str, subject, unit| Pair { name: name.into(), subject, unit };
    let (start, far) = (hanging::<3>(), hanging::<6>());
    vec![
        pair(
            "chain of 3, ImplicitMidpoint",
            run(three, ImplicitMidpoint, short, start),
            run(three_h, ImplicitMidpoint, short, start),
        ),
        pair(
            "chain of 6, ImplicitMidpoint",
            run(six, ImplicitMidpoint, long, far),
            run(six_h, ImplicitMidpoint, long, far),
        ),
        pair("chain of 6, DiscreteGradient", energy(six, long, far), energy(six_h, long, far)),
    ]
}

/// Steps of the discrete gradient that show their energy: those of energies that are written in different ways are different maps.
fn energy<S: PhaseSpace<State = State<[f64; N]>> + 'static, const N: usize>(
    system: S,
    h: f64,
    start: State<[f64; N]>,
) -> Run
where
    DiscreteGradient: Method<S>,
{
    Box::new(move |steps| {
        let mut sim = Integrator::new(black_box(system), DiscreteGradient, black_box(h), black_box(start));
        sim.advance(black_box(steps)).expect("a regular problem");
        black_box(sim.state());
        vec![sim.energy()]
    })
}

fn by_hand() -> Vec<Pair> {
    fn flat<const N: usize>((q, p): ([f64; N], [f64; N])) -> Vec<f64> {
        [q, p].concat()
    }
    macro_rules! pairs {
        ($n:literal, $system:ident, $of:ident, $h:literal) => {{
            let ((m, l), start) = ($of, hanging::<$n>());
            let system = systems::$system { m, l, g: G };
            let hand = move || black_box(chain::Chain::<$n>::new(m, l, G));
            [
                Pair {
                    name: format!("chain of {}, ImplicitMidpoint", $n),
                    subject: run(system, ImplicitMidpoint, $h, start),
                    unit: Box::new(move |n| flat(hand().midpoint(black_box($h), n, (start.q, start.p)))),
                },
                Pair {
                    name: format!("chain of {}, DiscreteGradient", $n),
                    subject: run(system, DiscreteGradient, $h, start),
                    unit: Box::new(move |n| flat(hand().discrete_gradient(black_box($h), n, (start.q, start.p)))),
                },
            ]
        }};
    }
    [pairs!(3, Chain3, THREE, 0.002), pairs!(6, Chain6, SIX, 0.001)].into_iter().flatten().collect()
}

/// Lagrangians with an action: one step of order 4, or five of order 2.
fn with_actions() -> Vec<Pair> {
    fn run<S, M, Q>(system: S, method: M, at: ContactState<Q>) -> Run
    where
        S: PhaseSpace<State = ContactState<Q>, Action = f64> + 'static,
        M: Method<S> + 'static,
        Q: Coordinates<Real = f64> + 'static,
        ContactState<Q>: Copy,
    {
        Box::new(move |steps| {
            let mut sim = Integrator::new(black_box(system), black_box(method), black_box(0.01), black_box(at));
            sim.advance(black_box(steps)).expect("a regular problem");
            vec![black_box(sim.state()).s]
        })
    }
    macro_rules! pairs {
        ($($name:literal: $system:expr, $start:expr;)*) => { vec![$(Pair {
            name: $name.into(),
            subject: run($system, ContactGauss::<2>, $start),
            unit: run($system, Suzuki4.of(ContactMidpoint), $start),
        }),*] };
    }
    let (m, l) = ([1.0, 0.6], [1.0, 0.8]);
    pairs! {
        "double pendulum − γs": systems::Braked { m, l, g: G, gamma: 0.3 }, ContactState::new([0.0, 1.4], [0.0; 2], 0.0);
        "one velocity, momentum reads s": systems::Growing { a: 0.1 }, ContactState::new(1.0, 0.53, 0.3);
        "two velocities, s²": systems::Fading { a: 0.1 }, ContactState::new([1.0, 0.2], [0.1, 0.8], 0.0);
    }
}
