//! Do steps keep the invariant sets of a contact flow?
//!
//! H = (p² + q² + s²)/2 − R. The flow keeps the sphere H = 0 and the axis q = p = 0, on which s' = R − s²/2. The two points of intersection are
//! at rest; every orbit on the sphere leads from the lower point to the upper one. Steps of the splitting keep the axis exactly. They keep a
//! surface near the sphere, at a distance proportional to h². Steps of the discrete gradient keep the sphere.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, orbit, order, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;

/// The oscillator of a universe that expands.
#[contact_hamiltonian]
fn cosmological(q: f64, p: f64, s: f64, r: f64) -> f64 {
    (p * p + q * q + s * s) / 2.0 - r
}

const SYSTEM: Cosmological = Cosmological { r: 1.0 };

/// Returns the point of the sphere at a height s and an angle.
fn on_sphere(s: f64, angle: f64) -> ContactState<f64> {
    let radius = (2.0 * SYSTEM.r - s * s).sqrt();
    ContactState::new(radius * angle.cos(), radius * angle.sin(), s)
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Cosmological::REPORT);
    let top = (2.0 * SYSTEM.r).sqrt();
    let start = on_sphere(-0.6, 0.8_f64.atan2(0.6));
    let mut rows = vec![];
    let (mut second, mut rounding) = (vec![], 0.0_f64);
    for h in [0.2, 0.1, 0.05] {
        let energy = |states: Vec<ContactState<f64>>| largest(states.iter().map(|x| SYSTEM.energy(x)));
        let [two, four, gradient] = [
            energy(orbit(SYSTEM, ContactSplitting, h, start, 20.0)?),
            energy(orbit(SYSTEM, Suzuki4.of(ContactSplitting), h, start, 20.0)?),
            energy(orbit(SYSTEM, ContactDiscreteGradient, h, start, 20.0)?),
        ];
        second.push(two);
        rounding = rounding.max(gradient);
        rows.push([h.to_string(), format!("{two:.1e}"), format!("{four:.1e}"), format!("{gradient:.1e}")]);
    }
    println!("largest |H| on an orbit that begins on H = 0\n");
    println!("{}", table(["h", "ContactSplitting", "Suzuki4 of it", "ContactDiscreteGradient"], &rows));
    let observed = order(second[1], second[2]);
    claim(&format!("the sphere is kept to order 2 (observed {observed:.2})"), (observed - 2.0).abs() < 0.05)?;
    claim("ContactDiscreteGradient, an implicit method, keeps it to rounding", rounding < 1e-14)?;
    let axis = orbit(SYSTEM, ContactSplitting, 0.1, ContactState::new(0.0, 0.0, -1.3), 20.0)?;
    claim("the axis is kept exactly", axis.iter().all(|x| x.q == 0.0 && x.p == 0.0))?;
    let end = axis.last().map_or(f64::NAN, |x| x.s);
    claim("on it s comes to rest at √2R", (end - top).abs() < 1e-10)?;

    // s − √2R decreases like e^(−√2R t), and (q, p) like e^(−√(R/2) t).
    let mut orbits = vec![Curve::line("the sphere", palette::GREY, circle(top))];
    let mut arrivals = vec![];
    let colours = [palette::BLUE, palette::GREEN, palette::ORANGE, palette::VERMILION, palette::PURPLE];
    for (i, colour) in (0..).zip(colours) {
        let states = orbit(SYSTEM, ContactSplitting, 0.05, on_sphere(-1.414, 1.2566 * f64::from(i)), 30.0)?;
        let name = format!("orbit {}", i + 1);
        orbits.push(Curve::line(name, colour, states.iter().map(|x| (x.q, x.s)).collect()).width(1.2));
        let height = states.last().map_or(f64::NAN, |x| x.s);
        arrivals.push((height - top).abs());
    }
    claim("five orbits from near the lower point end in the upper one", arrivals.iter().all(|gap| *gap < 1e-5))?;
    let mut decay = vec![];
    let energies = |states: Vec<ContactState<f64>>| {
        states.iter().skip(1).map(|x| (x.t, SYSTEM.energy(x).abs())).collect::<Vec<_>>()
    };
    for (h, colour) in [(0.2, palette::VERMILION), (0.1, palette::GREEN), (0.05, palette::BLUE)] {
        let points = energies(orbit(SYSTEM, ContactSplitting, h, start, 20.0)?);
        decay.push(Curve::line(format!("splitting, h = {h}"), colour, points));
    }
    let points = energies(orbit(SYSTEM, ContactDiscreteGradient, 0.2, start, 20.0)?);
    decay.push(Curve::dots("discrete gradient, h = 0.2", palette::BLACK, points).marked(1.6).rounding());
    let orbits = Panel::new(
        "Orbits between the two points of rest",
        "sphere H = 0 from the side; ContactSplitting, h = 0.05, up to t = 30; R = 1, dimensionless",
        [Axis::linear("q", -1.5..1.5), Axis::linear("s", -1.5..1.5)],
        orbits,
    );
    let decay = Panel::new(
        "Distance from the sphere",
        "ContactSplitting leaves the sphere by h², ContactDiscreteGradient by rounding (most values are 0 and not drawn); R = 1, dimensionless",
        [Axis::linear("time", 0.0..20.0), Axis::decades("|H|", -17.0..-1.0)],
        decay,
    );
    figure("cosmological_oscillator.svg", (5, 4), &[orbits.equal(), decay])
}

fn circle(radius: f64) -> Vec<(f64, f64)> {
    let angles = (0..=200).map(|n| std::f64::consts::PI * f64::from(n) / 100.0);
    angles.map(|angle| (radius * angle.cos(), radius * angle.sin())).collect()
}
