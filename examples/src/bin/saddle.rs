//! Which schemes keep the energy of a saddle?
//!
//! H = qp + p²/2 − q²/2 is neither T(p) + V(q) nor a potential well: orbits are hyperbolas, and grow like exp(√2 t). A scheme of divided
//! differences keeps H exactly. Two similar schemes do not, at any step size. The first lacks its terms in h². The second lacks the term q of
//! the divided difference over p, and is a scheme for another system.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, table};
use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;

/// A saddle at the origin.
#[hamiltonian]
fn saddle(q: f64, p: f64) -> f64 {
    q * p + p * p / 2.0 - q * q / 2.0
}

/// q and p.
type Phase = (f64, f64);

const START: Phase = (1.0, 0.5);
const DURATION: f64 = 2.0;
const STEP_SIZES: [f64; 3] = [0.1, 0.05, 0.01];

/// Scheme with a wrong quotient. The right scheme is q₁ = q₀ + h (H(q₁, p₁) − H(q₁, p₀))/(p₁ − p₀) and
/// p₁ = p₀ − h (H(q₁, p₀) − H(q₀, p₀))/(q₁ − q₀). Its first quotient is q₁ + (p₀ + p₁)/2; the term q₁ is missing here.
fn term_lost(h: f64, (q, p): Phase) -> Phase {
    // q₁ − h/2 p₁ = a and p₁ − h/2 q₁ = b.
    let (a, b) = (q + h / 2.0 * p, p - h * p + h / 2.0 * q);
    let determinant = 1.0 - h * h / 4.0;
    ((a + h / 2.0 * b) / determinant, (b + h / 2.0 * a) / determinant)
}

/// Scheme with both quotients complete, but without its terms in h².
fn squares_dropped(h: f64, (q, p): Phase) -> Phase {
    (q + h * (q + p), p + h * (q - p))
}

/// Computes the flow in closed form. The matrix of q' = q + p, p' = q − p has the square 2.
fn exact(t: f64, (q, p): Phase) -> Phase {
    let root = 2.0_f64.sqrt();
    let (cosh, sinh) = ((root * t).cosh(), (root * t).sinh() / root);
    (cosh * q + sinh * (q + p), cosh * p + sinh * (q - p))
}

fn main() -> Result<(), Box<dyn Error>> {
    let schemes = [
        Scheme { name: "DiscreteGradient", run: |h, start, steps| points(DiscreteGradient, h, start, steps) },
        Scheme { name: "ItohAbe", run: |h, start, steps| points(ItohAbe, h, start, steps) },
        Scheme { name: "terms in h² dropped", run: |h, start, steps| Ok(iterated(squares_dropped, h, start, steps)) },
        Scheme { name: "term q missing", run: |h, start, steps| Ok(iterated(term_lost, h, start, steps)) },
    ];
    let mut runs = Vec::new();
    for scheme in &schemes {
        runs.push(Runs::new(scheme)?);
    }
    println!("H = qp + p²/2 − q²/2 from (q, p) = {START:?}, where it is 0.125, up to t = {DURATION}\n");
    let head = ["", "|H − H₀|: h = 0.1", "0.05", "0.01", "distance: h = 0.1", "0.05", "0.01", "order"];
    println!("{}", table(head, &runs.iter().map(Runs::row).collect::<Vec<_>>()));
    println!("|H − H₀|: largest value of a run; distance: from the exact state (17.430, 7.225) at t = 2\n");

    let [tree, staircase, dropped, lost] = &runs[..] else { return Err("four schemes".into()) };
    // A step rounds H by ε times the size of its terms.
    let rounding = 2e-16 * (17.43_f64.powi(2) + 7.22_f64.powi(2)) * 8.0;
    let about =
        |found: [f64; 3], expected: [f64; 3]| found.iter().zip(expected).all(|(a, b)| (a / b - 1.0).abs() < 0.05);
    claim(&format!("discrete gradients keep the energy to {rounding:.0e}, at every step size"), {
        [tree, staircase].iter().all(|runs| runs.energy_errors.iter().all(|error| *error < rounding))
    })?;
    claim("without its terms in h² the scheme is explicit Euler, and errors of H are 0.042, 0.023, 0.0049", {
        let euler = points(ExplicitEuler, 0.1, START, 20)?;
        let same = iterated(squares_dropped, 0.1, START, 20);
        let apart = euler.iter().zip(&same).map(|(a, b)| distance(*a, *b)).fold(0.0, f64::max);
        apart < 1e-13 && about(dropped.energy_errors, [0.042, 0.023, 0.0049])
    })?;
    claim("with a term lost H is off by 3.40, 3.27, 3.16: a smaller step does not help", {
        about(lost.energy_errors, [3.40, 3.27, 3.16]) && lost.order().abs() < 0.1
    })?;
    claim("and what should leave to the left from (−1.7, 3.6) leaves to the right", {
        let (start, h, steps) = ((-1.7, 3.6), 0.1, 40);
        let end = iterated(term_lost, h, start, steps)[steps as usize];
        exact(h * steps as f64, start).0 < -1.0 && end.0 > 1.0
    })?;
    claim(
        &format!("orders are 2, 1, 1 and none ({:.2}, {:.2}, {:.2})", tree.order(), staircase.order(), dropped.order()),
        {
            (tree.order() - 2.0).abs() < 0.1
                && (staircase.order() - 1.0).abs() < 0.1
                && (dropped.order() - 1.0).abs() < 0.1
        },
    )?;

    println!("\nAnd a step that is too large?\n");
    too_large()?;
    println!();
    draw(&schemes)
}

/// A scheme and its name: the points after 0, 1, 2, … steps.
struct Scheme {
    name: &'static str,
    run: fn(f64, Phase, u64) -> Result<Vec<Phase>, StepError>,
}

fn points<M: Method<Saddle, f64>>(method: M, h: f64, start: Phase, steps: u64) -> Result<Vec<Phase>, StepError> {
    let mut sim = Saddle.integrator(method, h, State::new(start.0, start.1));
    let later = sim.sampled(1).take(steps as usize).map(|state| state.map(|state| (state.q, state.p)));
    std::iter::once(Ok(start)).chain(later).collect()
}

fn iterated(step: fn(f64, Phase) -> Phase, h: f64, start: Phase, steps: u64) -> Vec<Phase> {
    std::iter::successors(Some(start), |x| Some(step(h, *x))).take(steps as usize + 1).collect()
}

fn energy((q, p): Phase) -> f64 {
    Saddle.energy(&State::new(q, p))
}

fn distance(a: Phase, b: Phase) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

/// One scheme at all step sizes.
struct Runs {
    name: &'static str,
    energy_errors: [f64; 3],
    distances: [f64; 3],
}

impl Runs {
    fn new(scheme: &Scheme) -> Result<Self, StepError> {
        let mut runs = Runs { name: scheme.name, energy_errors: [0.0; 3], distances: [0.0; 3] };
        for (i, h) in STEP_SIZES.into_iter().enumerate() {
            let points = (scheme.run)(h, START, (DURATION / h).round() as u64)?;
            let errors = points.iter().map(|x| (energy(*x) - energy(START)).abs());
            runs.energy_errors[i] = errors.fold(0.0, f64::max);
            runs.distances[i] = points.last().map_or(f64::NAN, |end| distance(*end, exact(DURATION, START)));
        }
        Ok(runs)
    }

    /// Returns the observed order from the two smaller step sizes.
    fn order(&self) -> f64 {
        (self.distances[1] / self.distances[2]).ln() / (STEP_SIZES[1] / STEP_SIZES[2]).ln()
    }

    fn row(&self) -> [String; 8] {
        let [a, b, c] = self.energy_errors.map(|x| format!("{x:.2e}"));
        let [d, e, f] = self.distances.map(|x| format!("{x:.2e}"));
        [self.name.into(), a, b, c, d, e, f, format!("{:.2}", (100.0 * self.order()).round() / 100.0 + 0.0)]
    }
}

/// Prints the result of steps that are too large. The determinant of the step is 1 − h²/2 times a positive number, so the step is
/// singular at h = √2. Larger steps would reverse the sign of the growing solution.
fn too_large() -> Result<(), Box<dyn Error>> {
    for h in [1.41, 1.42, 3.0] {
        let mut sim = Saddle.integrator(DiscreteGradient, h, State::new(START.0, START.1));
        let answer = match sim.step() {
            Ok(()) => format!("q = {:.4e}", sim.state().q),
            Err(error) => format!("{error:?}"),
        };
        println!("h = {h:<5} {answer}");
    }
    println!();
    let mut sim = Saddle.integrator(DiscreteGradient, 1.42, State::new(START.0, START.1));
    claim(
        "steps beyond √2 are refused: `Singular`",
        matches!(sim.step(), Err(StepError { t: 0.0, failure: Failure::Singular, .. })),
    )?;
    claim("the state is still there, and goes on with h = 0.01", {
        let unharmed = sim.state() == State::new(START.0, START.1);
        sim.set_step_size(0.01);
        sim.advance(200)?;
        let end = (sim.state().q, sim.state().p);
        unharmed && distance(end, exact(DURATION, START)) < 1e-2
    })
}

fn draw(schemes: &[Scheme]) -> Result<(), Box<dyn Error>> {
    let colours = [palette::BLUE, palette::GREEN, palette::BLACK, palette::VERMILION];
    let h = 0.05;
    let mut errors = Vec::new();
    for (scheme, colour) in schemes.iter().zip(colours) {
        let points = (scheme.run)(h, START, (DURATION / h).round() as u64)?;
        let mut largest = 0.0_f64;
        let error = |(n, x): (usize, &Phase)| {
            largest = largest.max((energy(*x) - energy(START)).abs());
            (n as f64 * h, largest)
        };
        let line = Curve::line(scheme.name, colour, points.iter().enumerate().skip(1).map(error).collect());
        errors.push(if largest < 1e-12 { line.rounding() } else { line });
    }
    let energies = Panel::new(
        "Saddle: error of the energy",
        format!("h = {h}, from (1, 0.5); H = qp + p²/2 − q²/2, dimensionless"),
        [Axis::linear("time", 0.0..DURATION), Axis::decades("|H − H₀|, largest so far", -17.0..1.0)],
        errors,
    );

    // These orbits approach the origin on both sides of the stable line, and then move away.
    let h = 0.1;
    let starts = [(-1.4, 4.2), (-1.7, 3.6)];
    let inside = |x: &Phase| x.0.abs() < 5.0 && x.1.abs() < 4.5;
    let mut curves = Vec::new();
    for (start, name) in starts.into_iter().zip(["exact", ""]) {
        let truth = (0..400).map(|n| exact(0.01 * f64::from(n), start)).take_while(inside).collect();
        curves.push(Curve::line(name, palette::GREY, truth));
    }
    for (scheme, colour) in schemes.iter().zip(colours).filter(|(scheme, _)| scheme.name != "ItohAbe") {
        let mut points = Vec::new();
        for start in starts {
            points.extend((scheme.run)(h, start, 40)?.into_iter().take_while(inside));
        }
        curves.push(Curve::dots(scheme.name, colour, points).marked(2.6));
    }
    let orbits = Panel::new(
        "Saddle: two orbits",
        format!("h = {h}; H = qp + p²/2 − q²/2, dimensionless"),
        [Axis::linear("q", -5.0..5.0), Axis::linear("p", -2.6..4.6)],
        curves,
    );
    figure("saddle.svg", (4, 3), &[energies, orbits])
}
