//! How does an oscillator lose energy if a step is longer than its oscillation?
//!
//! Duffing's oscillator with friction is q'' = −q − q³ − c q'. A step of the discrete gradient removes exactly the work of friction at the
//! mean velocity v = (q₁ − q₀)/h: H₁ − H₀ = −h c v². Long steps lose too little energy, but no step gains any. The midpoint rule also decays,
//! but some of its steps gain energy.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, table};
use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;

/// A mass on a spring that hardens, in a medium with friction.
#[hamiltonian(damping = c)]
fn damped_duffing(q: f64, p: f64, c: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 + q.powi(4) / 4.0
}

const SYSTEM: DampedDuffing = DampedDuffing { c: 0.1 };
const STEP_SIZES: [f64; 4] = [0.1, 1.0, 3.0, 10.0];
const STEPS: usize = 400;

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", DampedDuffing::REPORT);
    let conserving = STEP_SIZES.map(|h| Run::new(DiscreteGradient, h, STEPS));
    let midpoint = STEP_SIZES.map(|h| Run::new(ImplicitMidpoint, h, STEPS));
    let euler = STEP_SIZES.map(|h| Run::new(ExplicitEuler, h, STEPS));
    println!("q'' = −q − q³ − 0.1 q', {STEPS} steps from q = 1 at rest\n");
    let names = ["DiscreteGradient", "ImplicitMidpoint"];
    let mut rows = Vec::new();
    for (name, runs) in names.into_iter().zip([&conserving, &midpoint]) {
        for run in runs {
            rows.push(run.row(name)?);
        }
    }
    println!("{}", table(["method", "h", "energy left", "of the flow", "gains", "imbalance"], &rows));
    println!("gains: steps after which there is more energy than before; imbalance: largest |H₁ − H₀ + h c v²|\n");

    let kept = |run: &Run| run.energies.len() == STEPS + 1;
    claim(
        "with the discrete gradient no step gains energy",
        conserving.iter().all(|run| kept(run) && run.gains() == 0),
    )?;
    claim("it loses what friction takes, to 1e-15", conserving.iter().all(|run| run.imbalance() < 1e-15))?;
    let [_, _, three, ten] = midpoint.each_ref().map(Run::gains);
    claim(&format!("the midpoint rule gains energy in {three} steps of 3 and {ten} of 10"), three > 0 && ten > 0)?;
    claim("explicit Euler gains without bounds, at all four step sizes", {
        euler.iter().all(|run| run.gains() > 5 && run.energies.iter().any(|energy| *energy > 100.0))
    })?;
    let error = |h: f64| -> Result<f64, StepError> {
        let (x, truth) = (after(DiscreteGradient, h, 20.0)?, after(Gauss::<6>, 0.1, 20.0)?);
        Ok((x.q - truth.q).hypot(x.p - truth.p))
    };
    let order = (error(0.05)? / error(0.025)?).log2();
    claim(&format!("small steps are of order 2 (observed {order:.2})"), (order - 2.0).abs() < 0.05)?;
    println!();
    draw()
}

/// Positions and energies after every step.
struct Run {
    h: f64,
    positions: Vec<f64>,
    energies: Vec<f64>,
}

impl Run {
    /// Runs a method until a step fails, for at most `steps` steps.
    fn new<M: Method<DampedDuffing>>(method: M, h: f64, steps: usize) -> Self {
        let mut sim = SYSTEM.integrator(method, h, start());
        let later = sim.sampled(1).take(steps).map_while(Result::ok);
        let states = std::iter::once(start()).chain(later);
        let (positions, energies) = states.map(|state| (state.q, SYSTEM.energy(&state))).unzip();
        Run { h, positions, energies }
    }

    fn gains(&self) -> usize {
        self.energies.windows(2).filter(|pair| pair[1] > pair[0]).count()
    }

    fn imbalance(&self) -> f64 {
        let steps = self.positions.windows(2).zip(self.energies.windows(2));
        let imbalance = |(q, energy): (&[f64], &[f64])| {
            let v = (q[1] - q[0]) / self.h;
            (energy[1] - energy[0] + self.h * SYSTEM.c * v * v).abs()
        };
        steps.map(imbalance).fold(0.0, f64::max)
    }

    fn row(&self, name: &str) -> Result<[String; 6], StepError> {
        let truth = SYSTEM.energy(&after(Gauss::<6>, 0.1, self.h * STEPS as f64)?);
        let left = self.energies.last().map(|energy| format!("{energy:.1e}")).unwrap_or_default();
        let (gains, imbalance) = (self.gains().to_string(), format!("{:.1e}", self.imbalance()));
        Ok([name.into(), self.h.to_string(), left, format!("{truth:.1e}"), gains, imbalance])
    }
}

fn start() -> State<f64> {
    State::new(1.0, 0.0)
}

fn after<M: Method<DampedDuffing>>(method: M, h: f64, t: f64) -> Result<State<f64>, StepError> {
    let mut sim = SYSTEM.integrator(method, h, start());
    sim.advance((t / h).round() as u64)?;
    Ok(sim.state())
}

fn draw() -> Result<(), Box<dyn Error>> {
    let curve = |run: &Run, name: String, colour| {
        let points = run.energies.iter().enumerate().map(|(n, energy)| (n as f64 * run.h, *energy));
        Curve::line(name, colour, points.collect()).marked(if run.h < 3.0 { 0.0 } else { 2.8 })
    };
    let truth = |duration: f64| {
        curve(&Run::new(Gauss::<6>, 0.1, (10.0 * duration) as usize), "reference".into(), palette::GREY)
    };

    let duration = 200.0;
    let mut decay = vec![truth(duration)];
    let colours = [palette::BLUE, palette::GREEN, palette::ORANGE, palette::VERMILION];
    for (h, colour) in STEP_SIZES.into_iter().zip(colours) {
        let run = Run::new(DiscreteGradient, h, (duration / h) as usize);
        decay.push(curve(&run, format!("h = {h}"), colour));
    }
    let decay = Panel::new(
        "DiscreteGradient loses energy in every step",
        "q'' = −q − q³ − 0.1 q' from rest at q = 1; dimensionless",
        [Axis::linear("time", 0.0..duration), Axis::decades("energy", -10.0..0.0)],
        decay,
    );

    let duration = 60.0;
    let steps = (duration / 3.0) as usize;
    let midpoint = Run::new(ImplicitMidpoint, 3.0, steps);
    let gradient = Run::new(DiscreteGradient, 3.0, steps);
    let methods = vec![
        truth(duration),
        curve(&midpoint, "ImplicitMidpoint".into(), palette::PURPLE),
        curve(&gradient, "DiscreteGradient".into(), palette::ORANGE),
    ];
    let methods = Panel::new(
        "ImplicitMidpoint gains energy in some steps",
        "q'' = −q − q³ − 0.1 q' from rest at q = 1, h = 3; dimensionless",
        [Axis::linear("time", 0.0..duration), Axis::decades("energy", -3.0..0.0)],
        methods,
    );
    figure("damped_duffing.svg", (3, 2), &[decay, methods])
}
