//! When do two pairs of vortices pass through each other?
//!
//! Point vortices of strengths Γ move each other in the plane. The coordinates x and y of each vortex are conjugate, {x, y} = 1/Γ. Two pairs on
//! one axis pass through each other in turn if the ratio of their widths is above 3 − 2√2 (A. E. H. Love, Proc. London Math. Soc. 25 (1893)
//! 185). Below this ratio the narrow pair leaves the wide pair behind. The energy, the centre and ΣΓr² are integrals.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{changes, claim, largest, orbit, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Method, PhaseSpace};
use std::error::Error;

/// x₁…x₄, y₁…y₄, with strengths `gamma`.
#[hamiltonian(structure = |i, j| if j == i + 4 { 1.0 / gamma[i] } else { 0.0 })]
fn vortices(x: [f64; 8], gamma: [f64; 4]) -> f64 {
    let mut energy = 0.0;
    for i in 0..4 {
        for j in 0..i {
            let (dx, dy) = (x[i] - x[j], x[4 + i] - x[4 + j]);
            energy -= gamma[i] * gamma[j] * (dx * dx + dy * dy).ln() / 12.566370614359172;
        }
    }
    energy
}

/// Point vortices as a vector field with all four integrals.
#[vector_field(keeps(
    energy = {
        let mut energy = 0.0;
        for i in 0..4 {
            for j in 0..i {
                let (dx, dy) = (x[i] - x[j], x[4 + i] - x[4 + j]);
                energy -= gamma[i] * gamma[j] * (dx * dx + dy * dy).ln() / 12.566370614359172;
            }
        }
        energy
    },
    across = (0..4).map(|i| gamma[i] * x[i]).sum::<f64>(),
    along = (0..4).map(|i| gamma[i] * x[4 + i]).sum::<f64>(),
    moment = (0..4).map(|i| gamma[i] * (x[i] * x[i] + x[4 + i] * x[4 + i])).sum::<f64>(),
))]
fn vortex_field(x: [f64; 8], gamma: [f64; 4]) -> [f64; 8] {
    let mut f = [0.0; 8];
    for i in 0..4 {
        for j in 0..4 {
            if i != j {
                let (dx, dy) = (x[i] - x[j], x[4 + i] - x[4 + j]);
                let square = std::f64::consts::TAU * (dx * dx + dy * dy);
                f[i] -= gamma[j] * dy / square;
                f[4 + i] += gamma[j] * dx / square;
            }
        }
    }
    f
}

type Plane = FlowState<[f64; 8]>;

/// Circulations in m²/s: two pairs.
const PAIRS: Vortices = Vortices { gamma: [1.0, -1.0, 1.0, -1.0] };
/// Above this ratio of their widths, pairs pass through each other.
const LOVE: f64 = 0.171_572_875_253_809_9;

/// Returns two pairs on one axis, with half-widths of 1 m and `ratio` m.
fn pairs(ratio: f64) -> Plane {
    FlowState::new([0.0, 0.0, 0.0, 0.0, 1.0, -1.0, ratio, -ratio])
}

/// Returns the distance by which the second pair is ahead.
fn ahead(state: &Plane) -> f64 {
    state.x[2] - state.x[0]
}

/// Counts the passages of one pair through the other.
fn passages(states: &[Plane]) -> usize {
    states.windows(2).skip(1).filter(|ends| ahead(&ends[0]) * ahead(&ends[1]) < 0.0).count()
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Vortices::REPORT);
    let fourth = FourthOrder(DiscreteGradient);
    let wide = orbit(PAIRS, fourth, 0.05, pairs(0.5), 30.0)?;
    let [above, below] = [LOVE + 0.03, LOVE - 0.03].map(|ratio| orbit(PAIRS, fourth, 0.02, pairs(ratio), 200.0));
    let (above, below) = (above?, below?);
    let counts = [&wide, &above, &below].map(|states| passages(states));
    println!("passages of pairs with ratios 0.5, 0.2016, 0.1416 of their widths: {counts:?}\n");
    claim("pairs pass through each other if the ratio of widths is above 3 − 2√2, and else never", {
        counts[0] > 3 && counts[1] > 1 && counts[2] == 0
    })?;
    claim("the pair that leaves is ahead by 10 m and more", below.last().is_some_and(|state| ahead(state) > 10.0))?;

    let runs = [
        run("RK4", PAIRS, RK4, palette::VERMILION)?,
        run("PoissonSplitting", PAIRS, PoissonSplitting, palette::PURPLE)?,
        run("Suzuki4 of splitting", PAIRS, Suzuki4.of(PoissonSplitting), palette::ORANGE)?,
        run("DiscreteGradient", PAIRS, DiscreteGradient, palette::GREEN)?,
        run("FourthOrder", PAIRS, fourth, palette::SKY)?,
        run("FourthOrder, all integrals", VortexField { gamma: PAIRS.gamma }, fourth, palette::BLUE)?,
    ];
    println!(
        "{STEPS} steps of {STEP} s with ratio 0.5: largest changes of energy (m⁴/s²), ΣΓx, ΣΓy (m³/s) and ΣΓr²/Σ|Γ|r²\n"
    );
    println!("{}", table(["method", "energy", "ΣΓx", "ΣΓy", "ΣΓr²"], &runs.each_ref().map(Run::row)));
    let [rk4, poisson, suzuki, second, order4, all] = runs.each_ref().map(Run::last);
    claim("discrete gradients keep the energy to 1e-11", largest([second[0], order4[0], all[0]]) < 1e-11)?;
    claim(
        "splittings, the discrete gradient of order 2, and that of order 4 if they are named, keep the rest as well",
        {
            [poisson, suzuki, second, all].iter().all(|run| largest([run[1], run[2], run[3]]) < 1e-10)
                && order4[2] > 1e-9
        },
    )?;
    claim("the energy of splittings stays near, that of RK4 does not", {
        let at = |run: &Run, time| run.changes.iter().find(|x| x.0 > time).map_or(f64::NAN, |x| x.1[0]);
        rk4[0] > 4.0 * at(&runs[0], 500.0) && suzuki[0] < 1.5 * at(&runs[2], 500.0)
    })?;

    let path = |i: usize| wide.iter().map(|state| (state.x[i], state.x[4 + i])).collect();
    let paths = vec![
        Curve::line("wide pair", palette::BLUE, path(0)).marked_at_end(4.0),
        Curve::line("", palette::BLUE, path(1)).marked_at_end(4.0),
        Curve::line("narrow pair", palette::VERMILION, path(2)).marked_at_end(4.0),
        Curve::line("", palette::VERMILION, path(3)).marked_at_end(4.0),
    ];
    let distance = |states: &[Plane]| states.iter().map(|state| (state.t, ahead(state))).collect();
    let distances = vec![
        Curve::line("ratio 0.5", palette::BLUE, distance(&wide)),
        Curve::line("ratio 0.2016", palette::GREEN, distance(&above)),
        Curve::line("ratio 0.1416", palette::VERMILION, distance(&below)),
    ];
    let energies = runs.iter().map(|run| {
        let points = run.changes.iter().map(|(t, change)| (*t, change[0])).collect();
        let curve = Curve::line(run.name, run.ink, points);
        if run.last()[0] < 1e-11 { curve.rounding() } else { curve }
    });
    figure(
        "vortices.svg",
        (3, 2),
        &[
            Panel::new(
                "Two pairs of vortices pass through each other",
                "FourthOrder(DiscreteGradient), h = 0.05 s, 30 s; ratio 0.5, circulations of 1 m²/s",
                [Axis::linear("x (m)", -0.5..9.5), Axis::linear("y (m)", -1.5..1.5)],
                paths,
            ),
            Panel::new(
                "Lead of the narrow pair of vortices",
                "FourthOrder(DiscreteGradient), h = 0.05 and 0.02 s; Love's ratio is 0.1716",
                [Axis::linear("time (s)", 0.0..60.0), Axis::linear("lead (m)", -4.0..6.0)],
                distances,
            ),
            Panel::new(
                "Vortices: change of the energy",
                format!("h = {STEP} s, ratio 0.5; the pairs move 2 km, and the rounding of their coordinates grows"),
                [Axis::decades("time (s)", -1.0..4.0), Axis::decades("|H − H₀| (m⁴/s²), largest so far", -16.5..0.0)],
                energies.collect(),
            ),
        ],
    )
}

const STEP: f64 = 0.1;
const STEPS: u64 = 100_000;

/// Changes of the integrals with one method.
struct Run {
    name: &'static str,
    ink: Ink,
    /// Times, each with the largest changes of energy, ΣΓx, ΣΓy and ΣΓr²/Σ|Γ|r² so far.
    changes: Vec<(f64, [f64; 4])>,
}

impl Run {
    fn last(&self) -> [f64; 4] {
        self.changes[self.changes.len() - 1].1
    }

    fn row(&self) -> [String; 5] {
        let [a, b, c, d] = self.last().map(|change| format!("{change:.1e}"));
        [self.name.into(), a, b, c, d]
    }
}

fn run<S, M>(name: &'static str, system: S, method: M, ink: Ink) -> Result<Run, StepError>
where
    S: PhaseSpace<State = Plane>,
    M: Method<S>,
{
    let mut sim = Integrator::new(system, method, STEP, pairs(0.5));
    let integrals = |state: &Plane| {
        let sum =
            |f: fn(f64, f64, f64) -> f64| (0..4).map(|i| f(PAIRS.gamma[i], state.x[i], state.x[4 + i])).sum::<f64>();
        let moment = sum(|gamma, x, y| gamma * (x * x + y * y)) / sum(|gamma, x, y| gamma.abs() * (x * x + y * y));
        [PAIRS.energy(state), sum(|gamma, x, _| gamma * x), sum(|gamma, _, y| gamma * y), moment]
    };
    Ok(Run { name, ink, changes: changes(&mut sim, STEPS, integrals)? })
}
