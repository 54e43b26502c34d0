//! Is the heavy ball of optimisation a contact map?
//!
//! A ball with friction, H = |p|²/2 + γs + f(q), rolls to a minimum of f. `ContactSplitting` alternates the exact flow of |p|²/2 + γs with kicks
//! −h∇f. The positions yₖ of its kicks obey yₖ₊₁ = yₖ + μ(yₖ − yₖ₋₁) − ε∇f(yₖ) with μ = e^(−γh) and ε = h(1 − μ)/γ: this is the heavy ball
//! of B. Polyak (1964), for every f and to rounding. A step reports positions between those of two kicks. Often f is smaller there, and a small f needs
//! fewer steps. This does not make either of them better. Y. Nesterov's method (1983) is no contact map.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{claim, largest, table};
use geoint_runtime::prelude::*;
use geoint_runtime::{Contact, Method};
use std::error::Error;

const N: usize = 50;

/// A quadratic form in its principal axes.
#[contact_hamiltonian(
    const N = 50,
    split = "(0..N).map(|i| p[i] * p[i]).sum::<f64>() / 2.0 + gamma * s | (0..N).map(|i| rates[i] * q[i] * q[i]).sum::<f64>() / 2.0"
)]
fn diagonal(q: [f64; N], p: [f64; N], s: f64, rates: [f64; N], gamma: f64) -> f64 {
    (0..N).map(|i| p[i] * p[i] + rates[i] * q[i] * q[i]).sum::<f64>() / 2.0 + gamma * s
}

/// uᵢ = √i qᵢ, coupled by 2^(−|i − j|).
#[energy_function]
fn chain(q: [f64; 50], roots: [f64; 50]) -> f64 {
    let (mut f, mut earlier, mut before) = (0.0, 0.0, 0.0);
    for i in 0..50 {
        let u = roots[i] * q[i];
        earlier = (earlier + before) / 2.0;
        f += u * u / 2.0 + u * earlier;
        before = u;
    }
    f
}

#[contact_hamiltonian(
    const N = 50,
    with(chain),
    split = "(0..N).map(|i| p[i] * p[i]).sum::<f64>() / 2.0 + gamma * s | chain(q, roots)"
)]
fn coupled(q: [f64; N], p: [f64; N], s: f64, roots: [f64; N], gamma: f64) -> f64 {
    (0..N).map(|i| p[i] * p[i]).sum::<f64>() / 2.0 + gamma * s + chain(q, roots)
}

/// H. Rosenbrock's valley (1960).
#[contact_hamiltonian]
fn valley(q: [f64; 2], p: [f64; 2], s: f64, gamma: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 + gamma * s + 100.0 * (q[1] - q[0] * q[0]).powi(2) + (1.0 - q[0]).powi(2)
}

/// A function with its gradient, a start, and the parameters of the methods.
struct Problem<const M: usize> {
    name: &'static str,
    f: fn(&[f64; M]) -> f64,
    gradient: fn(&[f64; M]) -> [f64; M],
    start: [f64; M],
    parameters: Parameters,
}

/// Step ε and momentum μ of a method with memory.
#[derive(Clone, Copy)]
struct Momentum {
    epsilon: f64,
    mu: f64,
}

/// Fixed parameters of all methods.
#[derive(Clone, Copy)]
struct Parameters {
    /// Step ε of steepest descent.
    descent: f64,
    ball: Momentum,
    nesterov: Momentum,
    /// Step length and friction of the contact flow.
    h: f64,
    gamma: f64,
}

impl Parameters {
    /// Returns the parameters that are best for a quadratic form with these extreme eigenvalues.
    fn tuned_to([least, largest]: [f64; 2]) -> Self {
        let condition = (largest / least).sqrt();
        let ratio = (condition - 1.0) / (condition + 1.0);
        let ball = Momentum { epsilon: 4.0 / (largest.sqrt() + least.sqrt()).powi(2), mu: ratio * ratio };
        let decay = -ball.mu.ln();
        let h = (ball.epsilon * decay / (1.0 - ball.mu)).sqrt();
        let nesterov = Momentum { epsilon: 1.0 / largest, mu: ratio };
        Parameters { descent: 2.0 / (largest + least), ball, nesterov, h, gamma: decay / h }
    }
}

/// f after 0, 1, 2, … gradients, down to 10⁻⁸.
type Heights = Vec<f64>;

const GOAL: f64 = 1e-8;

fn heights<const M: usize>(problem: &Problem<M>, points: impl Iterator<Item = [f64; M]>) -> Heights {
    let mut heights = vec![];
    for x in points {
        heights.push((problem.f)(&x));
        if heights.last().is_some_and(|f| *f <= GOAL) {
            break;
        }
    }
    heights
}

/// Points of the heavy ball with `ahead` = 0, and of Nesterov's method, which takes the gradient ahead, with `ahead` = 1.
fn with_momentum<const M: usize>(
    problem: &Problem<M>,
    Momentum { epsilon, mu }: Momentum,
    ahead: f64,
) -> impl Iterator<Item = [f64; M]> {
    let (gradient, mut x, mut v) = (problem.gradient, problem.start, [0.0; M]);
    std::iter::from_fn(move || {
        let now = x;
        let slope = gradient(&std::array::from_fn(|i| x[i] + ahead * mu * v[i]));
        v = std::array::from_fn(|i| mu * v[i] - epsilon * slope[i]);
        x = std::array::from_fn(|i| x[i] + v[i]);
        Some(now)
    })
}

/// States of the contact flow after 0, 1, 2, … steps.
fn contact<S, const M: usize>(system: S, h: f64, start: [f64; M]) -> impl Iterator<Item = ContactState<[f64; M]>>
where
    S: Contact<Coordinates = [f64; M]>,
    ContactSplitting: Method<S, f64>,
{
    let start = ContactState::new(start, [0.0; M], 0.0);
    let mut sim = geoint_runtime::Integrator::new(system, ContactSplitting, h, start);
    std::iter::once(start).chain(std::iter::from_fn(move || sim.step().ok().map(|()| sim.state())))
}

/// Returns the largest distance of the kicks of the contact flow from a method with momentum and 0.9 h, in 100 steps.
fn distance<S, const M: usize>(problem: &Problem<M>, system: S, ahead: f64) -> f64
where
    S: Contact<Coordinates = [f64; M]>,
    ContactSplitting: Method<S, f64>,
{
    let (h, gamma) = (0.9 * problem.parameters.h, problem.parameters.gamma);
    let mu = (-gamma * h).exp();
    let points = with_momentum(problem, Momentum { epsilon: h * (1.0 - mu) / gamma, mu }, ahead);
    let half = (1.0 - (-gamma * h / 2.0).exp()) / gamma;
    let kicks =
        contact(system, h, problem.start).map(|x| -> [f64; M] { std::array::from_fn(|i| x.q[i] + half * x.p[i]) });
    largest(kicks.zip(points).take(100).flat_map(|(a, b)| (0..M).map(move |i| a[i] - b[i])))
}

/// Runs all methods on a problem.
fn runs<S, const M: usize>(problem: &Problem<M>, system: S) -> [Heights; 4]
where
    S: Contact<Coordinates = [f64; M]>,
    ContactSplitting: Method<S, f64>,
{
    let Parameters { descent, ball, nesterov, h, .. } = problem.parameters;
    let descent = Momentum { epsilon: descent, mu: 0.0 };
    [
        heights(problem, with_momentum(problem, descent, 0.0)),
        heights(problem, with_momentum(problem, ball, 0.0)),
        heights(problem, with_momentum(problem, nesterov, 1.0)),
        heights(problem, contact(system, h, problem.start).map(|x| x.q)),
    ]
}

/// λᵢ = 10^(−4i/49).
fn rates() -> [f64; N] {
    std::array::from_fn(|i| 10_f64.powf(-4.0 * i as f64 / 49.0))
}

fn roots() -> [f64; N] {
    std::array::from_fn(|i| (i as f64 + 1.0).sqrt())
}

fn quadratic() -> Problem<N> {
    Problem {
        name: "50 eigenvalues from 10⁻⁴ to 1",
        f: |x| x.iter().zip(rates()).map(|(x, rate)| rate * x * x).sum::<f64>() / 2.0,
        gradient: |x| {
            let rates = rates();
            std::array::from_fn(|i| rates[i] * x[i])
        },
        start: [1.0; N],
        parameters: Parameters::tuned_to([1e-4, 1.0]),
    }
}

fn correlated() -> Problem<N> {
    Problem {
        name: "Bᵢⱼ = √(ij) 2^(−|i − j|)",
        f: |x| chain(*x, roots()),
        gradient: |x| {
            let roots = roots();
            let u: [f64; N] = std::array::from_fn(|i| roots[i] * x[i]);
            let [mut earlier, mut later] = [[0.0; N]; 2];
            for i in 1..N {
                earlier[i] = (earlier[i - 1] + u[i - 1]) / 2.0;
                later[N - 1 - i] = (later[N - i] + u[N - i]) / 2.0;
            }
            std::array::from_fn(|i| roots[i] * (u[i] + earlier[i] + later[i]))
        },
        start: std::array::from_fn(|i| if i % 2 == 0 { -1.0 } else { 1.0 }),
        parameters: Parameters::tuned_to([0.611_020_172, 125.118_825]),
    }
}

fn rosenbrock() -> Problem<2> {
    Problem {
        name: "Rosenbrock's valley",
        f: |[x, y]| 100.0 * (y - x * x).powi(2) + (1.0 - x).powi(2),
        gradient: |[x, y]| {
            let height = y - x * x;
            [-400.0 * x * height - 2.0 * (1.0 - x), 200.0 * height]
        },
        start: [-1.2, 1.0],
        parameters: Parameters {
            descent: 0.002,
            ball: Momentum { epsilon: 0.002, mu: 0.95 },
            nesterov: Momentum { epsilon: 0.001, mu: 0.97 },
            h: 0.05,
            gamma: 1.0,
        },
    }
}

const METHODS: [&str; 4] = ["gradient descent", "heavy ball", "Nesterov", "contact"];
const INKS: [Ink; 4] = [palette::GREEN, palette::VERMILION, palette::ORANGE, palette::BLUE];

/// Draws f over the number of gradients.
fn panel<const M: usize>(problem: &Problem<M>, runs: &[Heights; 4], end: u32) -> Panel {
    let curves = runs.iter().zip(METHODS).zip(INKS).map(|((heights, name), ink)| {
        let points = (0..=end).map(f64::from).zip(heights.iter().copied()).collect();
        Curve::line(name, ink, points).width(1.2)
    });
    let Parameters { h, gamma, .. } = problem.parameters;
    Panel::new(
        problem.name,
        format!("Fixed parameters; ContactSplitting: h = {h:.4}, γ = {gamma:.4}; dimensionless"),
        [Axis::linear("gradients", 0.0..end.into()), Axis::decades("f", -8.0..3.0)],
        curves.collect(),
    )
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Valley::REPORT);
    let [quadratic, correlated] = [quadratic(), correlated()];
    let rosenbrock = rosenbrock();
    let diagonal = Diagonal { rates: rates(), gamma: quadratic.parameters.gamma };
    let coupled = Coupled { roots: roots(), gamma: correlated.parameters.gamma };
    let valley = Valley { gamma: rosenbrock.parameters.gamma };
    let off = largest([distance(&quadratic, diagonal, 0.0), distance(&correlated, coupled, 0.0)]);
    claim(
        &format!("kicks of the contact flow are the points of the heavy ball, to {off:.0e} in 100 steps"),
        off < 1e-12,
    )?;
    claim("in the valley as well, where errors grow at first", distance(&rosenbrock, valley, 0.0) < 1e-10)?;
    claim(
        "control: Nesterov's method with the same ε and μ is another map",
        distance(&quadratic, diagonal, 1.0) > 0.01,
    )?;

    let all = [runs(&quadratic, diagonal), runs(&correlated, coupled), runs(&rosenbrock, valley)];
    let counts = all.each_ref().map(|runs| runs.each_ref().map(|heights| heights.len() - 1));
    println!("\ngradients until f ≤ 10⁻⁸, with fixed parameters\n");
    let names = [quadratic.name, correlated.name, rosenbrock.name];
    let row = |i: usize| {
        let [a, b, c, d] = counts[i].map(|count| count.to_string());
        [names[i].to_string(), a, b, c, d]
    };
    let [descent, ball, nesterov, contact] = METHODS;
    println!("{}", table(["", descent, ball, nesterov, contact], &[row(0), row(1), row(2)]));
    let expected = [[44320, 813, 658, 466], [949, 101, 160, 86], [10373, 362, 358, 383]];
    let differences = counts.concat().into_iter().zip(expected.concat()).map(|(found, count)| found.abs_diff(count));
    claim("the counts are those of an independent program, to 2", differences.max() <= Some(2))?;

    let panels = [panel(&quadratic, &all[0], 1000), panel(&correlated, &all[1], 200), panel(&rosenbrock, &all[2], 500)];
    figure("descent.svg", (4, 3), &panels)
}
