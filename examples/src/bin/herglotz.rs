//! Which order do steps have if the Lagrangian contains the action, s' = L(q, v, s)?
//!
//! G. Herglotz' equations d/dt ∂L/∂v = ∂L/∂q + ∂L/∂s ∂L/∂v describe friction if L contains a term −γs. Their flow is a contact map. Contact
//! Gauss methods of every even order are contact maps, too. All momenta that are conserved without friction decay by one factor.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{claim, table};
use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;

/// Two pendulums that are braked; q angles from below.
#[lagrangian]
fn braked(q: [f64; 2], v: [f64; 2], s: f64, m: [f64; 2], l: [f64; 2], g: f64, gamma: f64) -> f64 {
    let x = [l[0] * v[0], l[1] * v[1]];
    let coupling = 2.0 * x[0] * x[1] * (q[0] - q[1]).cos();
    let kinetic = 0.5 * m[0] * x[0].powi(2) + 0.5 * m[1] * (x[0].powi(2) + x[1].powi(2) + coupling);
    kinetic + (m[0] + m[1]) * g * l[0] * q[0].cos() + m[1] * g * l[1] * q[1].cos() - gamma * s
}

/// A pendulum on a sphere that is braked: the angle from below, and that about the vertical, which is not read.
#[lagrangian]
fn spherical(q: [f64; 2], v: [f64; 2], s: f64, m: f64, g: f64, gamma: f64) -> f64 {
    0.5 * m * (v[0] * v[0] + (q[0].sin() * v[1]).powi(2)) + m * g * q[0].cos() - gamma * s
}

const BRAKED: Braked = Braked { m: [1.0, 0.6], l: [1.0, 0.8], g: 9.81, gamma: 0.3 };
const SPHERICAL: Spherical = Spherical { m: 1.3, g: 9.81, gamma: 0.1 };
/// q, p and s of the braked pendulum after 2 s, by a method of thirty digits.
const KNOWN: [f64; 5] = [
    0.333_568_811_836_901_5,
    -0.382_021_839_677_322,
    1.732_983_435_190_370_7,
    0.429_924_908_456_404_5,
    30.686_536_218_045_864,
];

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Braked::<f64>::REPORT);
    let methods: [(&str, Ink, [f64; 4]); 4] = [
        ("contact midpoint", palette::BLACK, errors(ContactMidpoint)?),
        ("Suzuki4 of midpoint", palette::VERMILION, errors(Suzuki4.of(ContactMidpoint))?),
        ("contact Gauss, 2 stages", palette::GREEN, errors(ContactGauss::<2>)?),
        ("contact Gauss, 3 stages", palette::BLUE, errors(ContactGauss::<3>)?),
    ];
    let row = |(name, _, errors): &(&str, Ink, [f64; 4])| {
        let [a, b, c, d] = errors.map(|error| format!("{error:.1e}"));
        [(*name).into(), a, b, c, d]
    };
    println!("{}", table(["error at t = 2", "h = 0.1", "0.05", "0.025", "0.0125"], &methods.each_ref().map(row)));
    let order = |errors: [f64; 4]| (errors[2] / errors[3]).log2();
    let [one, suzuki, two, three] = methods.each_ref().map(|(_, _, errors)| order(*errors));
    claim("their orders are 2, 4, 4 and 6", {
        [(one, 2.0), (suzuki, 4.0), (two, 4.0), (three, 6.0)].iter().all(|(found, order)| (found - order).abs() < 0.25)
    })?;

    let samples = decay()?;
    let strayed = samples.iter().fold(0.0, |most, sample| f64::max(most, (sample.momentum * sample.grown - 1.0).abs()));
    claim("the momentum about the vertical falls as e^(−γt), to 1e-9", strayed < 1e-9)?;
    let energy = samples.iter().fold(0.0, |most, sample| f64::max(most, (sample.energy * sample.grown - 1.0).abs()));
    claim("and so does the energy function, to the order of the method", energy < 1e-5)?;
    println!();
    draw(&methods, &samples)
}

/// Errors in (q, p, s) for four steps.
fn errors<M: Method<Braked>>(method: M) -> Result<[f64; 4], StepError> {
    let mut errors = [0.0; 4];
    for (error, h) in errors.iter_mut().zip([0.1, 0.05, 0.025, 0.0125]) {
        let mut sim = BRAKED.integrator(method, h, BRAKED.at([0.0, 1.4], [0.0, 0.0], 0.0));
        sim.advance((2.0 / h).round() as u64)?;
        let ContactState { q, p, s, .. } = sim.state();
        let found = [q[0], q[1], p[0], p[1], s];
        *error = found.iter().zip(KNOWN).fold(0.0, |most, (a, b)| f64::max(most, (a - b).abs()));
    }
    Ok(errors)
}

/// Momentum and energy at the time t, relative to their values at the start. `grown` is the factor exp(γt).
struct Decay {
    t: f64,
    angle: f64,
    momentum: f64,
    energy: f64,
    grown: f64,
}

fn decay() -> Result<Vec<Decay>, StepError> {
    let start = SPHERICAL.at([1.0, 0.0], [0.0, 2.0], 0.0);
    let mut sim = SPHERICAL.integrator(ContactGauss::<3>, 0.05, start);
    let (momentum, energy) = (start.p[1], sim.energy());
    let mut samples = vec![];
    for _ in 0..600 {
        let state = sim.state();
        samples.push(Decay {
            t: state.t,
            angle: state.q[0],
            momentum: state.p[1] / momentum,
            energy: sim.energy() / energy,
            grown: (SPHERICAL.gamma * state.t).exp(),
        });
        sim.step()?;
    }
    Ok(samples)
}

fn draw(methods: &[(&str, Ink, [f64; 4])], samples: &[Decay]) -> Result<(), Box<dyn Error>> {
    let steps = [0.1, 0.05, 0.025, 0.0125_f64];
    let curve = |(name, ink, errors): &(&str, Ink, [f64; 4])| {
        let points = steps.iter().zip(errors).map(|(h, error)| (-h.log2(), *error)).collect();
        Curve::line(*name, *ink, points).marked(3.0)
    };
    let errors = Panel::new(
        "Double pendulum with friction: error after 2 s",
        "friction by −0.3 s in L; masses 1 and 0.6 kg, arms 1 and 0.8 m",
        [Axis::linear("−log₂ h, h in s", 3.0..6.6), Axis::decades("largest error of q, p, s in SI units", -12.0..0.0)],
        methods.iter().map(curve).collect(),
    );
    let of = |value: fn(&Decay) -> f64| samples.iter().map(|sample| (sample.t, value(sample))).collect::<Vec<_>>();
    let laws = Panel::new(
        "A spherical pendulum with friction",
        "contact Gauss, 3 stages, h = 0.05 s, γ = 0.1/s",
        [Axis::linear("time in s", 0.0..30.0), Axis::linear("part of the start", -0.1..1.1)],
        vec![
            Curve::line("angle from below", palette::GREY, of(|sample| sample.angle)).width(0.9).solid(),
            Curve::line("momentum about the vertical", palette::BLUE, of(|sample| sample.momentum)),
            Curve::line("p·v − L", palette::VERMILION, of(|sample| sample.energy)),
        ],
    );
    figure("herglotz.svg", (4, 3), &[errors, laws])
}
