//! Does a magnetic bottle hold a charge, and at which height does the charge turn back?
//!
//! The field B = B₀ (1 + z²/L²) along z is stronger at both ends. With A = (−y, x) B(z)/2 the energy is H = |p − A|²/2. The magnetic moment
//! μ = v⊥²/2B is nearly constant. The charge turns back at the height z with v² = 2μB, if the field
//! changes little in one gyration. Each of the three squares of H moves one coordinate at constant speed, so its flow is exact and the splitting
//! solves no equation. Implicit methods solve for six unknowns. The table compares their times.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, orbit, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Method, StepError};
use std::error::Error;
use std::time::Instant;

/// A charge of unit mass. `b`: gyration frequency at z = 0. `l`: height z at which the frequency is 2b.
#[hamiltonian]
fn bottle(q: [f64; 3], p: [f64; 3], b: f64, l: f64) -> f64 {
    let [x, y, z] = q;
    let half = b * (1.0 + z * z / (l * l)) / 2.0;
    ((p[0] + half * y).powi(2) + (p[1] - half * x).powi(2) + p[2] * p[2]) / 2.0
}

type Charge = State<[f64; 3]>;

/// In rad/s and m.
const SYSTEM: Bottle = Bottle { b: 10.0, l: 1.0 };

fn start() -> Charge {
    State::new([0.02, 0.0, 0.0], [0.0, 0.5, 0.6])
}

fn field(z: f64) -> f64 {
    SYSTEM.b * (1.0 + z * z / (SYSTEM.l * SYSTEM.l))
}

/// μ = v⊥²/2B.
fn moment(state: &Charge) -> f64 {
    let [x, y, z] = state.q;
    let half = field(z) / 2.0;
    ((state.p[0] + half * y).powi(2) + (state.p[1] - half * x).powi(2)) / (2.0 * field(z))
}

/// Returns the last state of a run, the relative change of the energy, and the time of the computation in s.
fn run<M: Method<Bottle, f64>>(method: M, h: f64, duration: f64) -> Result<(Charge, f64, f64), StepError> {
    let mut sim = SYSTEM.integrator(method, h, start());
    let (energy, clock) = (sim.energy(), Instant::now());
    sim.advance((duration / h).round() as u64)?;
    Ok((sim.state(), sim.energy() / energy - 1.0, clock.elapsed().as_secs_f64()))
}

fn distance(a: &Charge, b: &Charge) -> f64 {
    largest((0..3).flat_map(|i| [a.q[i] - b.q[i], a.p[i] - b.p[i]]))
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Bottle::REPORT);
    // Predicted turning point: with a constant μ the velocity along z vanishes at 2μB = v².
    let (mu, speed) = (moment(&start()), SYSTEM.energy(&start()) * 2.0);
    let turn = SYSTEM.l * (speed / (2.0 * mu * SYSTEM.b) - 1.0).sqrt();
    let long = orbit(SYSTEM, BlanesMoan6X.of(PieceSplitting), 0.05, start(), 2000.0)?;
    let moments: Vec<f64> = long.iter().map(moment).collect();
    let reached = largest(long.iter().map(|state| state.q[2]));
    let passages = long.windows(2).filter(|pair| pair[0].q[2] * pair[1].q[2] < 0.0).count();
    println!("2000 s: {passages} passages; largest |z| {reached:.3} m, predicted from μ {turn:.3} m\n");
    let [least, most] = [f64::min as fn(f64, f64) -> f64, f64::max].map(|of| moments.iter().copied().reduce(of));
    let (least, most) = (least.unwrap_or(f64::NAN), most.unwrap_or(f64::NAN));
    claim(
        "the charge is held, and turns where its moment says, to 5 %",
        passages > 200 && (reached / turn - 1.0).abs() < 0.05,
    )?;
    claim(&format!("the moment stays between {:.2} and {:.2} of its start", least / mu, most / mu), {
        least > 0.7 * mu && most < 1.4 * mu
    })?;

    let duration = 50.0;
    let (truth, ..) = run(SofroniouSpaletta10_35.of(PieceSplitting), 0.01, duration)?;
    let row = |name: &str, h: f64, (end, energy, seconds): (Charge, f64, f64)| {
        let error = distance(&end, &truth);
        (
            [
                name.into(),
                format!("{h}"),
                format!("{error:.1e}"),
                format!("{energy:.1e}"),
                format!("{:.2}", 1e3 * seconds),
            ],
            error,
            seconds,
        )
    };
    let runs = [
        row("Gauss::<4>", 0.05, run(Gauss::<4>, 0.05, duration)?),
        row("Gauss::<6>", 0.1, run(Gauss::<6>, 0.1, duration)?),
        row("BlanesMoan6X", 0.0125, run(BlanesMoan6X.of(PieceSplitting), 0.0125, duration)?),
        row("KahanLi8_17a", 0.02, run(KahanLi8_17a.of(PieceSplitting), 0.02, duration)?),
    ];
    println!("{duration} s, against the finest steps\n");
    println!(
        "{}",
        table(["method", "h in s", "error", "of the energy", "ms"], &runs.each_ref().map(|(row, ..)| row.clone()))
    );
    claim("all come to the same end", runs.iter().all(|(_, error, _)| *error < 1e-4))?;

    let few: Vec<&Charge> = long.iter().take_while(|state| state.t <= 14.0).collect();
    let path = few.iter().map(|state| (state.q[2], state.q[0])).collect();
    let along = |of: &dyn Fn(&Charge) -> f64| few.iter().map(|state| (state.t, of(state))).collect::<Vec<_>>();
    figure(
        "bottle.svg",
        (3, 2),
        &[
            Panel::new(
                "A charge in a magnetic bottle",
                "BlanesMoan6X of pieces, h = 0.05 s, for 14 s; the field is along z, 10 (1 + z²) rad/s",
                [Axis::linear("z in m", -1.7..1.7), Axis::linear("x in m", 0.0..0.12)],
                vec![Curve::line("charge", palette::BLUE, path).width(0.7)],
            ),
            Panel::new(
                "Motion along the field",
                "BlanesMoan6X of pieces, h = 0.05 s; the charge turns at v² = 2μB",
                [Axis::linear("time in s", 0.0..14.0), Axis::linear("z in m", -1.7..1.7)],
                vec![
                    Curve::line("z", palette::BLUE, along(&|state| state.q[2])),
                    Curve::line("turning points", palette::GREY, vec![(0.0, turn), (14.0, turn)]),
                    Curve::line("", palette::GREY, vec![(0.0, -turn), (14.0, -turn)]),
                ],
            ),
            Panel::new(
                "The magnetic moment",
                "BlanesMoan6X of pieces, h = 0.05 s; μ = v⊥²/2B, at the start μ₀",
                [Axis::linear("time in s", 0.0..14.0), Axis::linear("μ/μ₀", 0.9..1.15)],
                vec![Curve::line("μ/μ₀", palette::VERMILION, along(&|state| moment(state) / mu)).solid()],
            ),
        ],
    )
}
