//! How accurate are contact integrators compared with other methods of equal cost?
//!
//! The problem is q'' + γq' + q = 0 with a known flow, as in M. Vermeeren, A. Bravetti & M. Seri, J. Phys. A 52 (2019) 445206. Three other
//! schemes for (q, p) treat friction as one more force: leapfrog, the scheme of order 3 of R. D. Ruth, and the classical Runge–Kutta method
//! RK4. Friction reduces leapfrog and Ruth's scheme to order 1.
//!
//! - Constant friction, short time: RK4 is more accurate than contact methods of order 2 at the same cost. Contact methods of high order are
//!   more accurate than RK4.
//! - Little friction, long time: RK4 adds numerical friction.
//! - Much friction: the exact drift of contact methods is stable.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{claim, largest, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Method, StepError};
use std::error::Error;

/// An oscillator with friction, taken apart as one with any other potential would be.
#[contact_hamiltonian(split = "p * p / 2.0 + gamma * s | q * q / 2.0")]
fn oscillator(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 + gamma * s
}

type Phase = [f64; 2];
/// Returns the points after 0, 1, 2, … steps. Arguments are the friction γ, the step size h and the duration.
type Run = fn(f64, f64, f64) -> Result<Vec<Phase>, StepError>;

/// A scheme, with the number of forces that a step takes.
struct Scheme {
    name: &'static str,
    forces: u32,
    run: Run,
    colour: Ink,
}

const START: Phase = [-0.25, 0.75];

const SCHEMES: [Scheme; 7] = [
    Scheme { name: "leapfrog", forces: 1, run: |g, h, t| iterated(leapfrog, g, h, t), colour: palette::PURPLE },
    Scheme { name: "Ruth 3", forces: 3, run: |g, h, t| iterated(ruth, g, h, t), colour: palette::ORANGE },
    Scheme { name: "RK4", forces: 4, run: |g, h, t| iterated(runge_kutta, g, h, t), colour: palette::VERMILION },
    Scheme {
        name: "ContactLeapfrog",
        forces: 1,
        run: |g, h, t| contact(ContactLeapfrog, g, h, t),
        colour: palette::BLACK,
    },
    Scheme {
        name: "ContactSplitting",
        forces: 1,
        run: |g, h, t| contact(ContactSplitting, g, h, t),
        colour: palette::SKY,
    },
    Scheme {
        name: "BlanesMoanSrkn6b",
        forces: 6,
        run: |g, h, t| contact(BlanesMoanSrkn6b, g, h, t),
        colour: palette::GREEN,
    },
    Scheme {
        name: "BlanesMoanSrkn11b",
        forces: 11,
        run: |g, h, t| contact(BlanesMoanSrkn11b, g, h, t),
        colour: palette::BLUE,
    },
];

fn contact<M: Method<Oscillator, f64>>(method: M, gamma: f64, h: f64, duration: f64) -> Result<Vec<Phase>, StepError> {
    let mut sim = Oscillator { gamma }.integrator(method, h, ContactState::new(START[0], START[1], 0.0));
    let later = sim.sampled(1).take((duration / h).round() as usize).map(|x| x.map(|x| [x.q, x.p]));
    std::iter::once(Ok(START)).chain(later).collect()
}

fn iterated(step: fn(f64, f64, Phase) -> Phase, gamma: f64, h: f64, duration: f64) -> Result<Vec<Phase>, StepError> {
    let points = std::iter::successors(Some(START), |x| Some(step(gamma, h, *x)));
    Ok(points.take((duration / h).round() as usize + 1).collect())
}

fn leapfrog(gamma: f64, h: f64, [q, p]: Phase) -> Phase {
    let p = p - h / 2.0 * (q + gamma * p);
    let q = q + h * p;
    [q, p - h / 2.0 * (q + gamma * p)]
}

fn ruth(gamma: f64, h: f64, x: Phase) -> Phase {
    let weights = [(7.0 / 24.0, 2.0 / 3.0), (0.75, -2.0 / 3.0), (-1.0 / 24.0, 1.0)];
    weights.into_iter().fold(x, |[q, p], (kick, drift)| {
        let p = p - kick * h * (q + gamma * p);
        [q + drift * h * p, p]
    })
}

fn runge_kutta(gamma: f64, h: f64, x: Phase) -> Phase {
    let rate = |[q, p]: Phase| [p, -q - gamma * p];
    let ahead = |h: f64, k: Phase| [x[0] + h * k[0], x[1] + h * k[1]];
    let a = rate(x);
    let b = rate(ahead(h / 2.0, a));
    let c = rate(ahead(h / 2.0, b));
    let d = rate(ahead(h, c));
    [0, 1].map(|i| x[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]))
}

/// Returns the exact q at a time. At γ = 2 both roots of λ² + γλ + 1 are −1, so the sine becomes t.
fn exact(gamma: f64, t: f64) -> f64 {
    let omega = (1.0 - gamma * gamma / 4.0).sqrt();
    let sine = if omega == 0.0 { t } else { (omega * t).sin() / omega };
    (-gamma * t / 2.0).exp() * (START[0] * (omega * t).cos() + (START[1] + gamma * START[0] / 2.0) * sine)
}

fn error(points: &[Phase], gamma: f64, h: f64) -> f64 {
    largest(points.iter().zip(0..).map(|(x, n)| x[0] - exact(gamma, h * f64::from(n))))
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("largest error of q up to t = 50, or 15 for γ ≥ 1; ten forces a unit of time, then forty\n");
    let mut errors = vec![];
    for forces in [10.0, 40.0] {
        let mut rows = vec![];
        for scheme in &SCHEMES {
            let h = f64::from(scheme.forces) / forces;
            let at =
                |gamma: f64| (scheme.run)(gamma, h, if gamma > 0.5 { 15.0 } else { 50.0 }).map(|x| error(&x, gamma, h));
            let of = [at(0.01)?, at(0.1)?, at(1.0)?, at(2.0)?];
            errors.push(of);
            let [a, b, c, d] = of.map(|x| format!("{x:.1e}"));
            rows.push([scheme.name.into(), format!("{h:.3}"), a, b, c, d]);
        }
        println!("{}", table(["scheme", "h", "γ = 0.01", "0.1", "1", "2"], &rows));
    }
    let [_, _, rk4, herglotz, splitting, _, nystrom] = &errors[SCHEMES.len()..] else {
        return Err("seven schemes".into());
    };
    claim("forty forces: RK4 is far more accurate than contact methods of order 2", {
        (0..4).all(|i| rk4[i] < herglotz[i] / 10.0 && rk4[i] < splitting[i] / 10.0)
    })?;
    claim("that of order 6 is more accurate than RK4", (0..4).all(|i| nystrom[i] < rk4[i] / 10.0))?;

    println!("\nLittle friction for long: γ = 0.0001, eight forces a unit of time, at t = 40 000\n");
    let (gamma, duration) = (1e-4, 40_000.0);
    let (mut rows, mut decays, mut left) = (vec![], vec![], vec![]);
    for scheme in &SCHEMES {
        let h = f64::from(scheme.forces) / 8.0;
        let decay = decay(&(scheme.run)(gamma, h, duration)?, h);
        let last = decay[decay.len() - 1];
        left.push(last.1 / (-gamma * last.0).exp());
        rows.push([
            scheme.name.into(),
            format!("{h:.3}"),
            format!("{:.2e}", last.1),
            format!("{:.1e}", left[left.len() - 1] - 1.0),
        ]);
        let points = decay.into_iter().filter(|x| x.1 > 1e-6).map(|(t, x)| (t / 1000.0, x));
        // All curves but the one of RK4 coincide. Each scheme has markers at its own times, so all schemes are visible.
        let points: Vec<_> = points.skip(rows.len() * 8).step_by(56).collect();
        decays.push(Curve::line(scheme.name, scheme.colour, points).width(0.8).solid().marked(3.0));
    }
    println!("{}", table(["scheme", "h", "energy left", "relative error"], &rows));
    claim("RK4 leaves less than a thousandth of what it should", left[2] < 1e-3)?;
    claim("all others, leapfrog and Ruth 3 too, leave the right energy to 0.5 %", {
        (0..7).filter(|i| *i != 2).all(|i| (left[i] - 1.0).abs() < 0.005)
    })?;

    println!("\nMuch friction: γ = 40, h = 0.1\n");
    for scheme in &SCHEMES {
        let outcome = match (scheme.run)(40.0, 0.1, 10.0) {
            Ok(points) if bounded(&points) => "stable".into(),
            Ok(_) => "unstable".into(),
            Err(error) => error.to_string(),
        };
        println!("{:<18} {outcome}", scheme.name);
    }
    println!();
    let stable = |i: usize| (SCHEMES[i].run)(40.0, 0.1, 10.0).is_ok_and(|points| bounded(&points));
    claim(
        "leapfrog and RK4 are not stable there, ContactLeapfrog refuses the step",
        ![0, 2, 3].into_iter().any(stable),
    )?;
    claim("with the exact decay of the drift all are stable", (4..7).all(stable))?;
    draw(decays)
}

/// Returns whether all points are in the unit disc. An unstable scheme leaves it.
fn bounded(points: &[Phase]) -> bool {
    points.iter().all(|x| x[0].hypot(x[1]) <= 1.0)
}

/// Returns times and energies relative to the start. Means over 100 units of time remove the oscillation of the energy.
fn decay(points: &[Phase], h: f64) -> Vec<(f64, f64)> {
    let block = (100.0 / h).round() as usize;
    let energy = |x: &[Phase]| x.iter().map(|x| x[0] * x[0] + x[1] * x[1]).sum::<f64>() / x.len() as f64;
    let first = energy(&points[..block]);
    points.chunks_exact(block).zip(0..).map(|(x, n)| (h * block as f64 * f64::from(n), energy(x) / first)).collect()
}

fn draw(decays: Vec<Curve>) -> Result<(), Box<dyn Error>> {
    let mut accuracy = vec![];
    for scheme in &SCHEMES {
        let mut points = vec![];
        for forces in [5.0, 10.0, 20.0, 40.0, 80.0] {
            let h = f64::from(scheme.forces) / forces;
            points.push((forces, error(&(scheme.run)(0.1, h, 50.0)?, 0.1, h).min(9.0)));
        }
        accuracy.push(Curve::line(scheme.name, scheme.colour, points).marked(3.0));
    }
    let accuracy = Panel::new(
        "Errors at equal numbers of forces",
        "q'' + γq' + q = 0, γ = 0.1, dimensionless; largest error up to t = 50; a step with more forces is longer",
        [Axis::decades("forces a unit of time", 0.6..2.0), Axis::decades("largest error of q", -13.0..1.0)],
        accuracy,
    );
    let decays = Panel::new(
        "Energy under little friction",
        "q'' + γq' + q = 0, γ = 0.0001, dimensionless; 8 forces a unit of time; means over 100 units of time; all but RK4 coincide",
        [Axis::linear("time (thousands)", 0.0..40.0), Axis::decades("energy / energy at the start", -6.0..0.0)],
        decays,
    );
    figure("contact_compared.svg", (4, 3), &[accuracy, decays])
}
