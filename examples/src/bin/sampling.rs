//! Can steps of contact flows draw states from a given distribution?
//!
//! Thermostats. A thermostat adds a coordinate ξ to q and p, so that the flow keeps the density e^(−βE) f(ξ). For Nosé and Hoover f is a Gaussian, for the
//! logistic thermostat f = 1/cosh²(ξ/(2Q)) (D. Tapias, A. Bravetti & D. Sanders, Comput. Methods Sci. Technol. 23 (2017) 11). Both are contact flows
//! after a change of time (A. Bravetti & D. Tapias, Phys. Rev. E 93 (2016) 022139). Here they are fields x' = X(x) with x = (q, p, ξ). `lift` accepts
//! H = P·X, whose flow moves x by X. The momenta P do not act on x and start at 0.
//!
//! The macro proves that the exact flow keeps the density. Steps keep it up to O(h²). No proof shows that one orbit reaches all states; means along orbits
//! are therefore compared with exact ones. The control, Nosé and Hoover's thermostat of an oscillator, fails this test: its orbits stay on tori.
//!
//! Tempered trajectories. Friction −a in the first half of a trajectory heats the system, so it crosses barriers. Friction +a in the second half cools it
//! again. Both halves multiply volumes by factors whose product is 1, and the trajectory is reversible. So one test makes the distribution exact for every h:
//! accept the end with the probability min(1, e^(−ΔE)), where E does not contain the action (R. Neal, Handbook of Markov Chain Monte Carlo, 2011, 5.5.7).

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, table};
use geoint_runtime::StepError;
use geoint_runtime::prelude::*;
use std::error::Error;
use std::f64::consts::TAU;
use std::fmt;

/// The logistic thermostat of the double well V = q⁴/4 − q²/2 with m = β = 1. x is (q, p, ξ), the argument p is P, and `width` is Q.
#[contact_hamiltonian(
    lift,
    q = x,
    measure = (-x[1] * x[1] / 2.0 - x[0].powi(4) / 4.0 + x[0] * x[0] / 2.0).exp() / (x[2] / (2.0 * width)).cosh().powi(2)
)]
fn logistic(x: [f64; 3], p: [f64; 3], _s: f64, width: f64) -> f64 {
    let g = -(x[2] / (2.0 * width)).tanh() / width;
    p[0] * x[1] + p[1] * (x[0] - x[0].powi(3) + g * x[1]) + p[2] * (x[1] * x[1] - 1.0)
}

/// The control, Nosé and Hoover's thermostat of an oscillator with m = β = 1. x is (q, p, ξ), and the argument p is P.
#[contact_hamiltonian(lift, q = x, measure = (-(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / 2.0).exp())]
fn nose_hoover(x: [f64; 3], p: [f64; 3], _s: f64) -> f64 {
    p[0] * x[1] + p[1] * (-x[0] - x[2] * x[1]) + p[2] * (x[1] * x[1] - 1.0)
}

/// Two wells with a barrier of 8, and the friction of a tempered trajectory; s is the action. The friction changes its sign at the time `middle`. This is
/// the end of a step, so both signs never act in one step. The action does not act on q and p, because H is linear in it.
#[contact_hamiltonian]
fn tempered(q: f64, p: f64, s: f64, t: f64, a: f64, middle: f64) -> f64 {
    let friction = if t < middle { -a } else { a };
    p * p / 2.0 + 8.0 * (q * q - 1.0).powi(2) + friction * s
}

fn double_well(q: f64) -> f64 {
    q.powi(4) / 4.0 - q * q / 2.0
}

fn high_barrier(q: f64) -> f64 {
    8.0 * (q * q - 1.0).powi(2)
}

/// Pseudorandom numbers, SplitMix64 (G. Steele, D. Lea & C. Flood, 2014).
struct Random(u64);

impl Random {
    /// Returns a number in (0, 1]. It is never 0, so it has a logarithm.
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64 + f64::EPSILON / 4.0
    }

    /// Returns a number with the standard normal distribution, by the transform of Box and Muller.
    fn normal(&mut self) -> f64 {
        (-2.0 * self.uniform().ln()).sqrt() * (TAU * self.uniform()).cos()
    }
}

/// A mean over independent runs.
struct Estimate {
    mean: f64,
    /// The standard error of the mean, printed as its error bar.
    error: f64,
}

impl Estimate {
    fn of(values: &[f64]) -> Self {
        let n = values.len() as f64;
        let mean = values.iter().sum::<f64>() / n;
        let variance = values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0);
        Estimate { mean, error: (variance / n).sqrt() }
    }

    /// Returns whether the mean agrees with a number to three error bars.
    fn agrees(&self, exact: f64) -> bool {
        (self.mean - exact).abs() < 3.0 * self.error
    }
}

impl fmt::Display for Estimate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.4} ± {:.4}", self.mean, self.error)
    }
}

/// Returns the integral of e^(−V) times a function, by a sum of spacing 0.001 over [−5, 5). Both tails are below rounding.
fn integral(potential: fn(f64) -> f64, function: impl Fn(f64) -> f64) -> f64 {
    let points = (-5000..5000).map(|i| f64::from(i) / 1000.0);
    points.map(|q| (-potential(q)).exp() * function(q) / 1000.0).sum()
}

/// Returns the mean of a power of q with the density e^(−V)/Z.
fn exact(potential: fn(f64) -> f64, power: i32) -> f64 {
    integral(potential, |q| q.powi(power)) / integral(potential, |_| 1.0)
}

const RUNS: usize = 100;
const BINS: usize = 50;
/// Bins divide the positions between −EDGE and EDGE.
const EDGE: f64 = 2.5;

/// Samples of orbits with the logistic thermostat.
struct Samples {
    /// The mean of q² in each run.
    squares: Vec<f64>,
    /// The mean of q⁴ in each run.
    fourth_powers: Vec<f64>,
    /// The fraction of all positions in each bin.
    histogram: [f64; BINS],
}

fn samples(random: &mut Random) -> Result<Samples, StepError> {
    let mut samples = Samples { squares: vec![], fourth_powers: vec![], histogram: [0.0; BINS] };
    // A sample is taken every 4 steps, 0.05 units of time. A run discards 2000 samples, 100 units of time, and takes 20 000 samples, 1000 units.
    let (h, every, discarded, taken) = (0.0125, 4, 2000, 20_000);
    for _ in 0..RUNS {
        let start = [random.normal(), random.normal(), 0.0];
        let mut sim = Logistic { width: 0.1 }.integrator(ContactSplitting, h, ContactState::new(start, [0.0; 3], 0.0));
        let (mut square, mut fourth_power) = (0.0, 0.0);
        for state in sim.sampled(every).skip(discarded).take(taken) {
            let q = state?.q[0];
            square += q * q / taken as f64;
            fourth_power += q.powi(4) / taken as f64;
            let bin = ((q / EDGE + 1.0) / 2.0 * BINS as f64).floor();
            if let Some(count) = samples.histogram.get_mut(bin as usize).filter(|_| bin >= 0.0) {
                *count += 1.0 / (taken * RUNS) as f64;
            }
        }
        samples.squares.push(square);
        samples.fourth_powers.push(fourth_power);
    }
    Ok(samples)
}

/// Chains of tempered trajectories.
struct Chains {
    /// Accepted trajectories as a fraction of all.
    accepted: f64,
    /// Accepted trajectories that end in the other well, as a fraction of all.
    changed: f64,
    /// The mean of q² over all chains.
    square: Estimate,
    /// Positions of the first chain.
    first: Vec<f64>,
}

/// Runs 200 chains of 2000 trajectories. Each trajectory starts at the last accepted position, with a new random momentum.
fn chains(a: f64, random: &mut Random) -> Result<Chains, StepError> {
    let (h, steps, runs, length) = (0.05, 40_u32, 200, 2000);
    let system = Tempered { a, middle: h * f64::from(steps / 2) };
    let energy = |q: f64, p: f64| p * p / 2.0 + high_barrier(q);
    let (mut accepted, mut changed, mut squares, mut first) = (0, 0, vec![], vec![]);
    for run in 0..runs {
        let (mut q, mut square) = (-1.0, 0.0);
        for _ in 0..length {
            let p = random.normal();
            let mut sim = system.integrator(ContactSplitting, h, ContactState::new(q, p, 0.0));
            sim.advance(steps.into())?;
            let end = sim.state();
            if random.uniform() < (energy(q, p) - energy(end.q, end.p)).exp() {
                accepted += 1;
                changed += u32::from(q.signum() != end.q.signum());
                q = end.q;
            }
            square += q * q / f64::from(length);
            if run == 0 {
                first.push(q);
            }
        }
        squares.push(square);
    }
    let all = f64::from(runs * length);
    let [accepted, changed] = [accepted, changed].map(|count| f64::from(count) / all);
    Ok(Chains { accepted, changed, square: Estimate::of(&squares), first })
}

/// Returns the points (q, p) of an orbit of the control, every 0.1 up to the time 5000.
fn control(q: f64, p: f64) -> Result<Vec<(f64, f64)>, StepError> {
    let mut sim = NoseHoover.integrator(ContactSplitting, 0.025, ContactState::new([q, p, 0.0], [0.0; 3], 0.0));
    sim.sampled(4).take(50_000).map(|state| state.map(|state| (state.q[0], state.q[1]))).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Logistic::REPORT);
    let mut random = Random(1);
    let samples = samples(&mut random)?;
    let [square, fourth_power] = [&samples.squares, &samples.fourth_powers].map(|values| Estimate::of(values));
    let [exact_square, exact_fourth_power] = [2, 4].map(|power| exact(double_well, power));
    let rows = [
        ["q²".into(), square.to_string(), format!("{exact_square:.4}")],
        ["q⁴".into(), fourth_power.to_string(), format!("{exact_fourth_power:.4}")],
    ];
    println!("logistic thermostat of a double well: {RUNS} runs, T = 1000 after 100, h = 0.0125\n");
    println!("{}", table(["mean", "measured", "exact"], &rows));
    claim("q² and q⁴ agree with e^(−V) to three error bars, as measured, not proven", {
        square.agrees(exact_square) && fourth_power.agrees(exact_fourth_power)
    })?;
    let width = 2.0 * EDGE / BINS as f64;
    let bins: Vec<(f64, f64)> =
        (0..BINS).map(|i| ((i as f64 + 0.5) * width - EDGE, samples.histogram[i] / width)).collect();
    let all = integral(double_well, |_| 1.0);
    let density = |q: f64| (-double_well(q)).exp() / all;
    let deviation = largest(bins.iter().map(|(q, found)| found - density(*q)));
    claim(&format!("the histogram differs from e^(−V)/Z by at most {deviation:.4}"), deviation < 0.01)?;

    let orbits = [control(1.0, 0.0)?, control(0.0, 2.5)?];
    let squares = orbits.each_ref().map(|orbit| orbit.iter().map(|(q, _)| q * q).sum::<f64>() / orbit.len() as f64);
    // 0.792 and 0.863 are the means of q² on these two tori, computed by an independent program.
    let [inner, outer] = squares;
    claim(
        &format!("control: Nosé–Hoover stays on tori of the oscillator, q² = {inner:.3} and {outer:.3} instead of 1"),
        (inner - 0.792).abs() < 0.01 && (outer - 0.863).abs() < 0.01,
    )?;

    let [plain, tempered] = [chains(0.0, &mut random)?, chains(1.5, &mut random)?];
    let row = |name: &str, chains: &Chains| {
        let [accepted, changed] = [format!("{:.3}", chains.accepted), format!("{:.1e}", chains.changed)];
        [name.into(), accepted, changed, chains.square.to_string()]
    };
    let exact_square = exact(high_barrier, 2);
    println!("\n400 000 trajectories of 40 steps of 0.05 over a barrier of 8; exactly q² = {exact_square:.5}\n");
    let rows = [row("a = 0", &plain), row("a = 1.5", &tempered)];
    println!("{}", table(["friction", "accepted", "well changed", "q²"], &rows));
    claim("tempered trajectories change the well hundreds of times as often", {
        tempered.changed > 100.0 * plain.changed
            && (plain.accepted - 0.993).abs() < 0.002
            && (tempered.accepted - 0.885).abs() < 0.005
            && (plain.changed - 1.8e-4).abs() < 1e-4
            && (tempered.changed - 5.3e-2).abs() < 3e-3
    })?;
    // Both wells have the same mean of q². The mean is therefore right for a = 0 as well, although the well rarely changes.
    claim(
        "q² agrees with e^(−V) to three error bars",
        plain.square.agrees(exact_square) && tempered.square.agrees(exact_square),
    )?;

    let curve = (-250..=250).map(|i| f64::from(i) / 100.0).map(|q| (q, density(q))).collect();
    let histogram = Panel::new(
        "A thermostat samples a double well",
        "ContactSplitting, h = 0.0125, Q = 0.1, 100 runs of T = 1000; dimensionless",
        [Axis::linear("q", -EDGE..EDGE), Axis::linear("density", 0.0..0.5)],
        vec![Curve::line("e^(−V)/Z", palette::GREY, curve), Curve::dots("histogram", palette::BLUE, bins).rounding()],
    );
    let points = |orbit: &[(f64, f64)]| orbit.iter().step_by(20).copied().collect();
    let tori = Panel::new(
        "Control: Nosé–Hoover on an oscillator",
        "ContactSplitting, h = 0.025, every 2 units of time up to 5000; dimensionless",
        [Axis::linear("q", -4.0..4.0), Axis::linear("p", -3.0..3.0)],
        vec![
            Curve::dots("from (1, 0)", palette::BLUE, points(&orbits[0])).marked(1.0),
            Curve::dots("from (0, 2.5)", palette::VERMILION, points(&orbits[1])).marked(1.0),
        ],
    );
    let chain = |chains: &Chains| (0..400).map(f64::from).zip(chains.first.iter().copied()).collect();
    let tempering = Panel::new(
        "Trajectories over a barrier of 8",
        "ContactSplitting, 40 steps of 0.05, with the acceptance test; dimensionless",
        [Axis::linear("trajectory", 0.0..400.0), Axis::linear("q", -1.6..1.6)],
        vec![
            Curve::dots("a = 1.5", palette::BLUE, chain(&tempered)).marked(1.5).rounding(),
            Curve::dots("a = 0", palette::VERMILION, chain(&plain)).marked(1.5).rounding(),
        ],
    );
    figure("sampling.svg", (4, 3), &[histogram, tori.equal(), tempering])
}
