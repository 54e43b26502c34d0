//! Thirteen scenes with a structure that saves operations, each compared with the same scene without a visible structure. A term with the factor `z` hides
//! the structure. This parameter is zero in the run and unknown at compile time. Other scenes hide it by their spelling.

mod costs;

use geoint_runtime::prelude::*;
use geoint_runtime::system::StateOf;
use geoint_tests::scalars::{Tallied, Tally};
use geoint_tests::scene::{flat, point};
use std::time::Instant;

/// A scene, and the same scene with its structure hidden.
struct Pair {
    /// The structure that the compiler finds.
    found: &'static str,
    /// The operations that the step skips.
    absent: &'static str,
    /// The methods of both scenes.
    methods: [&'static str; 2],
    /// The numbers of operations in a step.
    operations: [Tally; 2],
    /// The nanoseconds of a step.
    time: [f64; 2],
    /// The relative difference of both ends: rounding alone if the method is the same.
    gap: f64,
}

/// Numbers of steps: the steps whose operations are counted, and the steps before. In the latter, implicit methods build up their extrapolation.
const STEPS: u64 = 200;
const BEFORE: u64 = 40;

fn counted<S, M>(system: S, method: M, h: f64, (t, x): (f64, &[f64])) -> Tally
where
    S: PhaseSpace<Tallied>,
    M: Method<S, Tallied>,
{
    let x: Vec<Tallied> = x.iter().map(|x| Tallied::from(*x)).collect();
    let mut sim = Integrator::new(system, method, h.into(), point::<StateOf<S, Tallied>>(t.into(), &x));
    sim.advance(BEFORE).expect("steps");
    let Tally { arithmetic, divisions, functions } = Tally::during(|| sim.advance(STEPS).expect("steps"));
    let each = |n: u64| n.div_ceil(STEPS);
    Tally { arithmetic: each(arithmetic), divisions: each(divisions), functions: each(functions) }
}

fn ran<S, M>((system, method): (S, M), h: f64, (t, x): (f64, &[f64]), rounds: u32) -> (Vec<f64>, f64)
where
    S: PhaseSpace,
    M: Method<S>,
{
    let mut sim = Integrator::new(system, method, h, point::<StateOf<S, f64>>(t, x));
    sim.advance(STEPS).expect("steps");
    let end = flat(&sim.state());
    let mut least = f64::INFINITY;
    for _ in 0..rounds {
        let begin = Instant::now();
        sim.advance(STEPS).expect("steps");
        least = least.min(begin.elapsed().as_nanos() as f64 / STEPS as f64);
    }
    (end, least)
}

macro_rules! pairs {
    ($($found:literal, $absent:literal, $h:literal from $t:literal, $x:expr;
        $System:ident { $($field:ident: $value:expr),* } by $method:expr,
        $Hidden:ident { $($other:ident: $hidden:expr),* } by $way:expr;)*) => {
        /// Returns all pairs with counts of operations, timed in `rounds` rounds.
        fn pairs(rounds: u32) -> Vec<Pair> {
            vec![$( {
                let (h, start): (f64, (f64, &[f64])) = ($h, ($t, &$x));
                let operations = [
                    counted($System::<Tallied> { $($field: $value.into()),* }, $method, h, start),
                    counted($Hidden::<Tallied> { $($other: $hidden.into()),* }, $way, h, start),
                ];
                let (end, time) = ran(($System::<f64> { $($field: $value),* }, $method), h, start, rounds);
                let (other, longer) = ran(($Hidden::<f64> { $($other: $hidden),* }, $way), h, start, rounds);
                let size = end.iter().filter(|x| x.is_finite()).fold(0.0, |size: f64, x| size.max(x.abs()));
                let gaps = end.iter().zip(&other).map(|(a, b)| (a - b).abs()).filter(|gap| gap.is_finite());
                Pair {
                    found: $found,
                    absent: $absent,
                    methods: [stringify!($method), stringify!($way)],
                    operations,
                    time: [time, longer],
                    gap: gaps.fold(0.0, f64::max) / size,
                }
            } ),*]
        }
    };
}

#[hamiltonian]
fn swing(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) - q.cos()
}

#[hamiltonian]
fn swing_coupled(q: f64, p: f64, m: f64, z: f64) -> f64 {
    p * p / (2.0 * m) - q.cos() + z * q * p.powi(3)
}

#[hamiltonian]
fn swing_of_time(q: f64, p: f64, t: f64, m: f64, z: f64) -> f64 {
    p * p / (2.0 * m) - (1.0 + z * t.sin()) * q.cos()
}

#[hamiltonian]
fn lit(q: f64, p: f64, m: f64, a: f64) -> f64 {
    p * p / (2.0 * m) - (-a * m).exp() * q.cos()
}

#[hamiltonian]
fn lit_in_time(q: f64, p: f64, t: f64, m: f64, a: f64, z: f64) -> f64 {
    p * p / (2.0 * m) - (-a * m - z * t).exp() * q.cos()
}

#[hamiltonian]
fn galaxy(q: [f64; 2], p: [f64; 2], m: f64, a: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m)
        + (q[0] * q[0] + q[1] * q[1]) / 2.0
        + a * (q[0] * q[0] * q[1] - q[1].powi(3) / 3.0)
}

#[hamiltonian]
fn galaxy_not_quadratic(q: [f64; 2], p: [f64; 2], m: f64, a: f64, z: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m)
        + z * p[0].powi(4)
        + (q[0] * q[0] + q[1] * q[1]) / 2.0
        + a * (q[0] * q[0] * q[1] - q[1].powi(3) / 3.0)
}

#[hamiltonian]
fn polar(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] / (q[0] * q[0])) / (2.0 * m) - 1.0 / q[0]
}

#[hamiltonian]
fn polar_not_cyclic(q: [f64; 2], p: [f64; 2], m: f64, z: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] / (q[0] * q[0])) / (2.0 * m) - 1.0 / q[0] + z * q[1].sin()
}

#[hamiltonian]
fn springs(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + k * (q[0] * q[0] + (q[1] - q[0]).powi(2)) / 2.0
}

#[hamiltonian]
fn springs_not_linear(q: [f64; 2], p: [f64; 2], m: f64, k: f64, z: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + k * (q[0] * q[0] + (q[1] - q[0]).powi(2)) / 2.0 + z * q[0].powi(4)
}

#[contact_hamiltonian]
fn fading(q: f64, p: f64, s: f64, c: f64) -> f64 {
    p * p / 2.0 - q.cos() + c * s
}

#[contact_hamiltonian]
fn fading_in_time(q: f64, p: f64, s: f64, t: f64, c: f64, z: f64) -> f64 {
    p * p / 2.0 - q.cos() + (c + z * t.sin()) * s
}

#[contact_hamiltonian]
fn rubbed(q: f64, p: f64, s: f64, c: f64) -> f64 {
    p * p / 2.0 - q.cos() + c * s
}

#[contact_hamiltonian(split = "p * p / 2.0 | -q.cos() | c * s")]
fn rubbed_in_three(q: f64, p: f64, s: f64, c: f64) -> f64 {
    p * p / 2.0 - q.cos() + c * s
}

#[hamiltonian]
fn row(q: [f64; 4], p: [f64; 4], w: f64) -> f64 {
    let kinetic: f64 = p.iter().map(|p| p * p / 2.0).sum();
    kinetic - (0..4).map(|i| w * q[i].cos()).sum::<f64>()
}

#[hamiltonian]
fn row_coupled(q: [f64; 4], p: [f64; 4], w: f64, z: f64) -> f64 {
    let kinetic: f64 = p.iter().map(|p| p * p / 2.0).sum();
    kinetic - (0..4).map(|i| w * q[i].cos()).sum::<f64>() + z * (q[0] * q[1] * q[2] * q[3])
}

#[hamiltonian]
fn chain(q: [f64; 6], p: [f64; 6], m: f64) -> f64 {
    let kinetic: f64 = p.iter().map(|p| p * p / (2.0 * m)).sum();
    kinetic
        + q.windows(2).map(|pair| (pair[1] - pair[0]).powi(2) / 2.0 + (pair[1] - pair[0]).powi(4) / 4.0).sum::<f64>()
}

#[hamiltonian]
fn chain_coupled(q: [f64; 6], p: [f64; 6], m: f64, z: f64) -> f64 {
    let kinetic: f64 = p.iter().map(|p| p * p / (2.0 * m)).sum();
    kinetic
        + q.windows(2).map(|pair| (pair[1] - pair[0]).powi(2) / 2.0 + (pair[1] - pair[0]).powi(4) / 4.0).sum::<f64>()
        + z * q[0] * p[1] * p[2]
}

#[hamiltonian]
fn weighed(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
    p[0] * p[0] / 2.0 + p[1] * p[1] / 2.0 - k * q[0].cos() - (q[1] - q[0]).cos()
}

#[hamiltonian]
fn weighed_by_parameters(q: [f64; 2], p: [f64; 2], m: f64, n: f64, k: f64, l: f64) -> f64 {
    p[0] * p[0] / (2.0 * m) + p[1] * p[1] / (2.0 * n) - k * q[0].cos() - l * (q[1] - q[0]).cos()
}

#[hamiltonian]
fn planet(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

#[hamiltonian]
fn planet_not_central(q: [f64; 2], p: [f64; 2], m: f64, z: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt() + z * q[0].powi(3) * p[1]
}

pairs! {
    "T(p) + V(q)", "Newton's iteration and its matrix", 0.05 from 0.0, [1.1, 0.4];
        Swing { m: 1.3 } by ImplicitMidpoint, SwingCoupled { m: 1.3, z: 0.0 } by ImplicitMidpoint;
    "T(p) + V(q)", "everything but a force a step", 0.05 from 0.0, [1.1, 0.4];
        Swing { m: 1.3 } by StormerVerlet, SwingCoupled { m: 1.3, z: 0.0 } by ImplicitMidpoint;
    "T quadratic, constant masses", "half of the unknowns", 0.05 from 0.0, [0.3, -0.2, 0.35, 0.25];
        Galaxy { m: 1.7, a: 0.8 } by Gauss::<2>, GalaxyNotQuadratic { m: 1.7, a: 0.8, z: 0.0 } by Gauss::<2>;
    "a coordinate is not read", "its force", 0.05 from 0.0, [1.1, 0.3, 0.2, 1.2];
        Polar { m: 1.3 } by DiscreteGradient, PolarNotCyclic { m: 1.3, z: 0.0 } by DiscreteGradient;
    "no explicit time", "the clock", 0.05 from 0.0, [1.1, 0.4];
        Swing { m: 1.3 } by StormerVerlet, SwingOfTime { m: 1.3, z: 0.0 } by StormerVerlet;
    "numbers in place of parameters", "products with 1", 0.05 from 0.0, [0.3, -0.2, 0.35, 0.25];
        Weighed { k: 1.0 } by DiscreteGradient, WeighedByParameters { m: 1.0, n: 1.0, k: 1.0, l: 1.0 } by DiscreteGradient;
    "functions of parameters", "their operations: they are prepared once", 0.05 from 0.0, [1.1, 0.4];
        Lit { m: 1.3, a: 0.4 } by StormerVerlet, LitInTime { m: 1.3, a: 0.4, z: 0.0 } by StormerVerlet;
    "H quadratic", "Newton's iteration: one product with an inverse", 0.05 from 0.0, [0.3, -0.2, 0.35, 0.25];
        Springs { m: 1.7, k: 0.8 } by DiscreteGradient, SpringsNotLinear { m: 1.7, k: 0.8, z: 0.0 } by DiscreteGradient;
    "∂H/∂s constant", "exponentials in the loop", 0.05 from 0.2, [1.1, 0.4, 0.3];
        Fading { c: 0.3 } by ContactSplitting, FadingInTime { c: 0.3, z: 0.0 } by ContactSplitting;
    "pieces that are one", "substeps", 0.05 from 0.2, [1.1, 0.4, 0.3];
        Rubbed { c: 0.3 } by ContactSplitting, RubbedInThree { c: 0.3 } by ContactSplitting;
    "zeros in the matrix of second derivatives", "their operations", 0.05 from 0.0, [0.3, -0.2, 0.35, 0.25, 0.1, 0.2, -0.3, 0.4];
        Row { w: 1.2 } by Gauss::<2>, RowCoupled { w: 1.2, z: 0.0 } by Gauss::<2>;
    "many degrees of freedom, separable", "half of the unknowns", 0.05 from 0.0, [0.3, -0.2, 0.35, 0.25, 0.1, 0.2, -0.3, 0.4, 0.1, 0.2, -0.2, 0.3];
        Chain { m: 1.3 } by DiscreteGradient, ChainCoupled { m: 1.3, z: 0.0 } by DiscreteGradient;
    "a central force", "unknowns, and a solution that is searched for", 0.05 from 0.0, [1.0, 0.1, -0.1, 1.1];
        Planet { m: 1.3 } by DiscreteGradient, PlanetNotCentral { m: 1.3, z: 0.0 } by DiscreteGradient;
}

/// Returns the table of all pairs.
fn table(pairs: &[Pair]) -> String {
    let mut text = String::from(
        "# What is skipped\n\nOperations of a step as they are executed, counted by a scalar: sums and products, quotients and roots, functions. Beside them those of \
         the same scene with its structure hidden, by a term whose factor is a parameter that is zero.\n\n\
         | found | absent | method | operations | ns | hidden | operations | ns |\n|---|---|---|---|---|---|---|---|\n",
    );
    for Pair { found, absent, methods, operations, time, .. } in pairs {
        let [seen, hidden] = operations
            .map(|Tally { arithmetic, divisions, functions }| format!("{arithmetic}, {divisions}, {functions}"));
        let [a, b] = methods;
        text +=
            &format!("| {found} | {absent} | `{a}` | {seen} | {:.0} | `{b}` | {hidden} | {:.0} |\n", time[0], time[1]);
    }
    text
}

/// Returns the path of the table in the output folder.
fn path() -> std::path::PathBuf {
    let target = std::env::var_os("CARGO_TARGET_DIR").map(std::path::PathBuf::from);
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("target");
    target.unwrap_or(root).join("geoint/skipped.md")
}

/// A step with a visible structure executes fewer operations. With the same method, it leads to the same state.
#[test]
fn what_is_not_needed_is_not_executed() {
    let pairs = pairs(0);
    assert_eq!(pairs.len(), 13);
    let mut failures = vec![];
    for Pair { found, absent, methods, operations, gap, .. } in &pairs {
        let [seen, hidden] = operations.map(Tally::weight);
        println!("{found}: {seen} and {hidden}, {gap:.1e}");
        if seen >= hidden {
            failures.push(format!("{found}: {absent} is not absent, {operations:?}"));
        }
        if methods[0] == methods[1] && *found != "pieces that are one" && *gap > 1e-9 {
            failures.push(format!("{found}: both ways lead apart, {gap:.1e}"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// `cargo test --profile bench -p geoint-tests --test skipped table -- --ignored` writes the table with times to `target/geoint/skipped.md`.
#[test]
#[ignore = "times steps"]
fn write_the_table() {
    std::fs::create_dir_all(path().parent().expect("a folder")).expect("the folder of output");
    std::fs::write(path(), table(&pairs(20))).expect("the table");
}
