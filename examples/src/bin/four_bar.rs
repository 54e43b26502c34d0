//! How does a closed linkage move? Three bars between two fixed points, with constraints.
//!
//! A crank turns about (0, 0), a rocker turns about (2.2, 0), and a coupler joins their ends. The coordinates are those of the two joints;
//! each bar is a constraint. A point of the coupler draws the curve for which such linkages are built.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, order, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;

/// Joints with masses m, in the order crank, rocker.
#[lagrangian(constraint = [
    (q[0].powi(2) + q[1].powi(2) - bars[0] * bars[0]) / 2.0,
    ((q[2] - q[0]).powi(2) + (q[3] - q[1]).powi(2) - bars[1] * bars[1]) / 2.0,
    ((q[2] - d).powi(2) + q[3].powi(2) - bars[2] * bars[2]) / 2.0
])]
fn four_bar(q: [f64; 4], v: [f64; 4], m: [f64; 2], bars: [f64; 3], d: f64, g: f64) -> f64 {
    let kinetic = m[0] * (v[0] * v[0] + v[1] * v[1]) / 2.0 + m[1] * (v[2] * v[2] + v[3] * v[3]) / 2.0;
    kinetic - g * (m[0] * q[1] + m[1] * q[3])
}

const LINKAGE: FourBar = FourBar { m: [0.7, 1.1], bars: [1.0, 2.0, 1.8], d: 2.2, g: 9.81 };
const H: f64 = 0.01;
const TIME: f64 = 20.0;

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", FourBar::<f64>::REPORT);
    // A rough guess. The projection onto the constraints makes it consistent.
    let rough = LINKAGE.at([0.0, 1.0, 1.8, 1.8], [-9.0, 0.0, -5.0, 0.0]);
    let start = LINKAGE.state_on_constraint(&rough)?;
    let rattle = run(Rattle, H, start)?;
    let gradient = run(DiscreteGradient, H, start)?;
    let fourth = run(Suzuki4.of(Rattle), H, start)?;

    let worst = |run: &[Sample], of: fn(&Sample) -> f64| largest(run.iter().map(of));
    let rows =
        [("Rattle", &rattle), ("DiscreteGradient", &gradient), ("Suzuki4 of Rattle", &fourth)].map(|(name, run)| {
            let [energy, bars] = [|e: &Sample| e.energy.abs(), |e: &Sample| e.bars].map(|of| worst(run, of));
            [name.into(), format!("{energy:.1e}"), format!("{bars:.1e}")]
        });
    println!("{}", table(["", "energy", "lengths of bars"], &rows));
    let exact = end(KahanLi8_17a.of(Rattle), 0.005, start)?;
    let error = |h: f64| -> Result<f64, StepError> { Ok(distance(end(Rattle, h, start)?, exact)) };

    claim(
        "the bars keep their lengths to 1e-15",
        [&rattle, &gradient, &fourth].iter().all(|run| worst(run, |e| e.bars) < 1e-15),
    )?;
    claim("the discrete gradient keeps the energy to 1e-12", worst(&gradient, |e| e.energy.abs()) < 1e-12)?;
    let half = rattle.len() / 2;
    let [early, late] = [&rattle[..half], &rattle[half..]].map(|run| worst(run, |e| e.energy.abs()));
    claim("the energy of RATTLE swings, and does not drift", late < 1.2 * early && early > 1e-3)?;
    claim("RATTLE has order 2", (order(error(0.005)?, error(0.0025)?) - 2.0).abs() < 0.1)?;
    claim("the crank goes round", rattle.iter().any(|e| e.q[1] < -0.99) && rattle.iter().any(|e| e.q[1] > 0.99))?;
    let outside = State { q: [0.0, 1.1, 1.8, 1.8], ..start };
    let refused = LINKAGE.integrator(Rattle, H, outside).step();
    claim(
        "a joint that its bar does not reach is refused",
        matches!(refused, Err(StepError { failure: Failure::OffConstraint { .. }, .. })),
    )?;
    println!();
    draw(&rattle, &gradient)
}

/// State and errors after a step.
struct Sample {
    t: f64,
    q: [f64; 4],
    /// Change of the energy since the start.
    energy: f64,
    /// Largest error of the length of a bar.
    bars: f64,
}

fn run<M: Method<FourBar>>(method: M, h: f64, start: State<[f64; 4]>) -> Result<Vec<Sample>, StepError> {
    let mut sim = Integrator::new(LINKAGE, method, h, start);
    let first = sim.energy();
    let mut samples = vec![];
    for _ in 0..=(TIME / h).round() as u32 {
        let State { t, q, .. } = sim.state();
        let lengths = [q[0].hypot(q[1]), (q[2] - q[0]).hypot(q[3] - q[1]), (q[2] - LINKAGE.d).hypot(q[3])];
        let bars = largest(lengths.iter().zip(LINKAGE.bars).map(|(length, bar)| (length - bar).abs()));
        samples.push(Sample { t, q, energy: sim.energy() - first, bars });
        sim.step()?;
    }
    Ok(samples)
}

/// Returns the positions of the joints after two units of time.
fn end<M: Method<FourBar>>(method: M, h: f64, start: State<[f64; 4]>) -> Result<[f64; 4], StepError> {
    let mut sim = Integrator::new(LINKAGE, method, h, start);
    sim.advance((2.0 / h).round() as u64)?;
    Ok(sim.state().q)
}

fn distance(a: [f64; 4], b: [f64; 4]) -> f64 {
    largest(a.iter().zip(b).map(|(a, b)| (a - b).abs()))
}

/// Returns the position of a point that is fixed to the coupler, beside its middle.
fn carried(q: &[f64; 4]) -> (f64, f64) {
    let (x, y) = (q[2] - q[0], q[3] - q[1]);
    (q[0] + 0.5 * x - 0.6 * y, q[1] + 0.5 * y + 0.6 * x)
}

fn draw(rattle: &[Sample], gradient: &[Sample]) -> Result<(), Box<dyn Error>> {
    let turn = &rattle[..400.min(rattle.len())];
    let mut curves = vec![
        Curve::line("crank", palette::SKY, turn.iter().map(|e| (e.q[0], e.q[1])).collect()).width(1.2),
        Curve::line("rocker", palette::GREEN, turn.iter().map(|e| (e.q[2], e.q[3])).collect()).width(2.4).solid(),
        Curve::line("point of the coupler", palette::BLUE, turn.iter().map(|e| carried(&e.q)).collect()).solid(),
    ];
    let q = &rattle[0].q;
    let bars = vec![(0.0, 0.0), (q[0], q[1]), (q[2], q[3]), (LINKAGE.d, 0.0)];
    curves.push(Curve::line("bars", palette::BLACK, bars.clone()).solid());
    curves.push(Curve::dots("", palette::BLACK, bars));
    let linkage = Panel::new(
        "A four-bar linkage",
        "Rattle, h = 0.01 s, for 4 s",
        [Axis::linear("x in m", -1.8..3.4), Axis::linear("y in m", -1.6..2.9)],
        curves,
    )
    .equal();
    // The error vanishes now and then. The largest error of each 20 steps gives a legible curve.
    let energy = |run: &[Sample]| {
        run.chunks(20).map(|some| (some[some.len() / 2].t, largest(some.iter().map(|e| e.energy.abs())))).collect()
    };
    let energies = vec![
        Curve::line("Rattle", palette::VERMILION, energy(rattle)),
        Curve::line("DiscreteGradient", palette::BLUE, energy(gradient)).rounding(),
    ];
    let energy = Panel::new(
        "Four-bar linkage: error of the energy",
        "h = 0.01 s; masses of 0.7 and 1.1 kg",
        [Axis::linear("time in s", 0.0..TIME), Axis::decades("largest error in 0.2 s, in J", -16.0..1.0)],
        energies,
    );
    figure("four_bar.svg", (4, 3), &[linkage, energy])
}
