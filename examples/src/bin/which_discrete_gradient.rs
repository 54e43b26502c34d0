//! Which discrete gradient is the most efficient?
//!
//! All discrete gradients keep the energy; they differ in order and cost. The comparison includes methods that do not keep the energy, and a
//! method that corrects a step afterwards. In the short time from t = 0 to 2 the explicit methods cost least. `energy_exact` shows the
//! effect of an exact energy in long runs.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, evaluations, shortest, table};
use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;
use std::time::Duration;

/// A star in a galaxy with a symmetry of three parts. M. Hénon & C. Heiles, Astron. J. 69 (1964) 73.
#[hamiltonian]
fn henon_heiles(q: [f64; 2], p: [f64; 2]) -> f64 {
    let [x, y] = q;
    (p[0] * p[0] + p[1] * p[1]) / 2.0 + (x * x + y * y) / 2.0 + x * x * y - y * y * y / 3.0
}

const DURATION: f64 = 2.0;
const STEPS: [u64; 6] = [5, 10, 20, 40, 80, 160];

/// A star at a time.
type Star = State<[f64; 2]>;

fn start() -> Star {
    State::new([0.1, -0.2], [0.3, 0.25])
}

/// Errors from an independent program in another language. Gonzalez' formula and projections depend on a norm. The other program
/// uses the coordinates without scaling; the library scales each coordinate by its own size.
const EXPECTED: [(&str, [f64; 3]); 13] = [
    ("ItohAbe", [2.836e-2, 1.334e-2, 6.457e-3]),
    ("ItohAbePair", [1.206e-3, 3.018e-4, 7.546e-5]),
    ("SymmetrisedItohAbe", [4.747e-3, 1.194e-3, 2.990e-4]),
    ("Gonzalez", [4.793e-3, 1.207e-3, 3.022e-4]),
    ("MeanValue::<2>", [4.778e-3, 1.203e-3, 3.012e-4]),
    ("FourthOrder(MeanValue::<2>)", [3.501e-5, 2.208e-6, 1.383e-7]),
    ("FourthOrder(SymmetrisedItohAbe)", [3.421e-5, 2.158e-6, 1.352e-7]),
    ("FourthOrder(Gonzalez)", [3.463e-5, 2.184e-6, 1.368e-7]),
    ("Yoshida4.of(Gonzalez)", [2.638e-4, 1.731e-5, 1.095e-6]),
    ("Suzuki4.of(Gonzalez)", [3.582e-6, 2.253e-7, 1.410e-8]),
    ("ImplicitMidpoint", [4.759e-3, 1.198e-3, 3.000e-4]),
    ("RK4", [3.008e-5, 1.846e-6, 1.141e-7]),
    ("Projection(RK4, Energy)", [2.810e-5, 1.788e-6, 1.123e-7]),
];

macro_rules! runs {
    ($end:expr; $($method:expr),* $(,)?) => { vec![ $( Run::new(stringify!($method), $method, $end)? ),* ] };
}

fn main() -> Result<(), Box<dyn Error>> {
    // With order 12 the reference has rounding errors only.
    let end = &after(Gauss::<6>, 20)?;
    let runs = runs![end;
        ItohAbe,
        ItohAbePair,
        SymmetrisedItohAbe,
        Gonzalez,
        MeanValue::<2>,
        DiscreteGradient,
        FourthOrder(MeanValue::<2>),
        FourthOrder(SymmetrisedItohAbe),
        FourthOrder(Gonzalez),
        FourthOrder(DiscreteGradient),
        Yoshida4.of(Gonzalez),
        Suzuki4.of(Gonzalez),
        Suzuki4.of(DiscreteGradient),
        ImplicitMidpoint,
        RK4,
        Projection(RK4, Energy),
        BlanesMoan4,
    ];
    println!("Hénon–Heiles up to t = {DURATION}\n");
    let head = ["method", "error: h = 0.2", "0.1", "0.05", "order", "|H − H₀|", "step / ns"];
    println!("{}", table(head, &runs.iter().map(Run::row).collect::<Vec<_>>()));
    println!("error: distance from the true (q, p) at the end; |H − H₀|: largest value for all step sizes\n");

    let find = |name: &str| runs.iter().find(|run| run.name == name).ok_or_else(|| format!("no {name}"));
    let agree = |bound: f64, (name, errors): (&str, [f64; 3])| {
        let near = |(found, expected): (f64, f64)| (found / expected - 1.0).abs() < bound;
        runs.iter().any(|run| run.name == name && run.errors().into_iter().zip(errors).all(near))
    };
    let (with_lengths, others): (Vec<_>, Vec<_>) =
        EXPECTED.into_iter().partition(|(name, _)| name.contains("Gonzalez") || name.starts_with("Projection"));
    claim(
        &format!("another program in another language finds the same errors for {} of them", others.len()),
        others.into_iter().all(|expected| agree(2e-3, expected)),
    )?;
    claim(
        &format!("and errors within 2 % for {} more, which measure lengths, there in other units", with_lengths.len()),
        with_lengths.into_iter().all(|expected| agree(2e-2, expected)),
    )?;
    claim("each has the order that it claims", {
        runs.iter().all(|run| (run.order() - f64::from(run.claimed_order)).abs() < 0.1)
    })?;
    claim("all but ImplicitMidpoint, RK4 and BlanesMoan4 keep the energy to 1e-15", {
        let loses = |run: &Run| ["ImplicitMidpoint", "RK4", "BlanesMoan4"].contains(&run.name);
        runs.iter().all(|run| if loses(run) { run.energy_error > 1e-8 } else { run.energy_error < 1e-15 })
    })?;
    let same = distance(&after(DiscreteGradient, 10)?, &after(SymmetrisedItohAbe, 10)?);
    claim("for this energy DiscreteGradient is SymmetrisedItohAbe", same < 1e-14)?;
    claim(
        "CoordinateIncrement has steps of 0.2 and of 0.05, but none of 0.1 over the place where the force is sideways",
        {
            let refused = after(CoordinateIncrement::default(), 20).err();
            let potential: Vec<_> =
                states(Gauss::<6>, 40)?.iter().map(|x| HenonHeiles.energy(&State::new(x.q, [0.0; 2]))).collect();
            let turns = (potential[5] - potential[4]) * (potential[6] - potential[5]) < 0.0;
            after(CoordinateIncrement::default(), 10)?;
            after(CoordinateIncrement::default(), 40)?;
            // The step from t = 0.2 to 0.3 contains this place.
            turns && matches!(refused, Some(StepError { t: 0.2, failure: Failure::NotConverged { .. }, .. }))
        },
    )?;
    let ratio = find("Projection(RK4, Energy)")?.errors()[1] / find("FourthOrder(MeanValue::<2>)")?.errors()[1];
    claim(
        &format!(
            "on so short a way, projected steps of RK4 do no worse than an implicit method of order 4 ({ratio:.2})"
        ),
        ratio < 1.0,
    )?;
    println!();
    draw(&runs)
}

/// Error and cost of a method with one step size.
struct Point {
    error: f64,
    /// Number of points at which the run evaluates the energy or its gradient.
    evaluations: u64,
    /// Time of the whole run.
    time: Duration,
}

/// Results of a method with all step sizes.
struct Run {
    name: &'static str,
    claimed_order: u32,
    points: Vec<Point>,
    energy_error: f64,
}

impl Run {
    fn new<M: Method<HenonHeiles>>(name: &'static str, method: M, end: &Star) -> Result<Self, Box<dyn Error>> {
        let mut points = Vec::new();
        let mut energy_error = 0.0_f64;
        for steps in STEPS {
            let time = shortest(|| (0..20).try_for_each(|_| after(method, steps).map(drop)))? / 20;
            let evaluations = evaluations(HenonHeiles, method, DURATION / steps as f64, start(), steps)?;
            points.push(Point { error: distance(&after(method, steps)?, end), evaluations, time });
            let energy_errors = states(method, steps)?;
            let energy_errors =
                energy_errors.iter().map(|x| (HenonHeiles.energy(x) - HenonHeiles.energy(&start())).abs());
            energy_error = energy_errors.fold(energy_error, f64::max);
        }
        Ok(Run { name, claimed_order: method.claims().order, points, energy_error })
    }

    fn errors(&self) -> [f64; 3] {
        [&self.points[1], &self.points[2], &self.points[3]].map(|point| point.error)
    }

    fn order(&self) -> f64 {
        let [_, coarse, fine] = self.errors();
        (coarse / fine).log2()
    }

    fn row(&self) -> [String; 7] {
        let [a, b, c] = self.errors().map(|error| format!("{error:.3e}"));
        let nanoseconds = self.points[3].time.as_nanos() / u128::from(STEPS[3]);
        let order = format!("{:.2}", self.order());
        [self.name.into(), a, b, c, order, format!("{:.1e}", self.energy_error), nanoseconds.to_string()]
    }
}

fn after<M: Method<HenonHeiles>>(method: M, steps: u64) -> Result<Star, StepError> {
    let mut sim = HenonHeiles.integrator(method, DURATION / steps as f64, start());
    sim.advance(steps)?;
    Ok(sim.state())
}

fn states<M: Method<HenonHeiles>>(method: M, steps: u64) -> Result<Vec<Star>, StepError> {
    let mut sim = HenonHeiles.integrator(method, DURATION / steps as f64, start());
    std::iter::once(Ok(start())).chain(sim.sampled(1).take(steps as usize)).collect()
}

fn distance(a: &Star, b: &Star) -> f64 {
    (0..2).map(|i| (a.q[i] - b.q[i]).powi(2) + (a.p[i] - b.p[i]).powi(2)).sum::<f64>().sqrt()
}

fn draw(runs: &[Run]) -> Result<(), Box<dyn Error>> {
    let colours = [
        ("ItohAbe", palette::BLACK),
        ("Gonzalez", palette::SKY),
        ("DiscreteGradient", palette::GREEN),
        ("FourthOrder(MeanValue::<2>)", palette::ORANGE),
        ("Suzuki4.of(DiscreteGradient)", palette::BLUE),
        ("Projection(RK4, Energy)", palette::VERMILION),
        ("BlanesMoan4", palette::GREY),
    ];
    let mut curves = Vec::new();
    for (name, colour) in colours {
        for run in runs.iter().filter(|run| run.name == name) {
            let points = run.points.iter().map(|point| (point.evaluations as f64, point.error));
            let curve = Curve::line(name, colour, points.collect()).width(1.6).marked(3.0);
            // The number of iterations to convergence depends on rounding errors.
            curves.push(if name == "BlanesMoan4" { curve } else { curve.rounding() });
        }
    }
    let panel = Panel::new(
        "Hénon–Heiles: error at t = 2",
        "h = 0.4, 0.2, …, 0.0125; all but BlanesMoan4 keep the energy; each of its kicks and drifts counts as a point; dimensionless",
        [
            Axis::decades("points at which H or its gradient is evaluated", 1.0..4.0),
            Axis::decades("distance from the true end", -12.0..0.0),
        ],
        curves,
    );
    figure("which_discrete_gradient.svg", (4, 3), &[panel])
}
