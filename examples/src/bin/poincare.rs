//! At which points does a star in a galaxy cross a plane? Three sections of Hénon and Heiles: order, islands, chaos.
//!
//! A section is an event, x = 0 with p_x > 0. Each step of a Taylor series is a polynomial, and the event is its zero. The events do not
//! change the steps.
//!
//! M. Hénon & C. Heiles, Astron. J. 69 (1964) 73, figures 4 to 6.

use geoint_examples::claim;
use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_runtime::prelude::*;
use std::error::Error;

/// A star in the plane of a galaxy; q = (x, y).
#[hamiltonian]
fn henon_heiles(q: [f64; 2], p: [f64; 2]) -> f64 {
    let [x, y] = q;
    (p[0] * p[0] + p[1] * p[1] + x * x + y * y) / 2.0 + x * x * y - y * y * y / 3.0
}

const ENERGIES: [(f64, &str); 3] = [(1.0 / 12.0, "1/12"), (1.0 / 8.0, "1/8"), (1.0 / 6.0, "1/6")];
const POINTS: usize = 120;

/// Returns the state with x = 0 and the given energy, y and p_y. Returns `None` if the energy is too low.
fn start(energy: f64, y: f64, py: f64) -> Option<State<[f64; 2]>> {
    let square = 2.0 * energy - py * py - y * y + 2.0 * y * y * y / 3.0;
    (square > 0.0).then(|| State::new([0.0, y], [square.sqrt(), py]))
}

/// Points (y, p_y) of a section, with the largest errors of x and of the energy.
struct Section {
    points: Vec<(f64, f64)>,
    off: f64,
    energy_error: f64,
}

fn section(start: State<[f64; 2]>) -> Result<Section, StepError> {
    let energy = HenonHeiles.energy(&start);
    let mut sim = HenonHeiles.taylor(Taylor::default(), start);
    let mut section = Section { points: vec![], off: 0.0, energy_error: 0.0 };
    for crossing in sim.crossings(Direction::Up, |state| state.q[0]).take(POINTS) {
        let state = match crossing {
            // Above E = 1/6 orbits escape to infinity in a finite time.
            Err(error) if error.is_shortest() => break,
            found => found?.state,
        };
        section.points.push((state.q[1], state.p[1]));
        section.off = section.off.max(state.q[0].abs());
        section.energy_error = section.energy_error.max((HenonHeiles.energy(&state) - energy).abs());
    }
    Ok(section)
}

fn main() -> Result<(), Box<dyn Error>> {
    let colours = [palette::BLUE, palette::VERMILION, palette::GREEN, palette::BLACK, palette::GREY];
    let (mut panels, mut off, mut energy_error, mut points) = (vec![], 0.0_f64, 0.0_f64, 0);
    for (energy, name) in ENERGIES {
        // Time reversal mirrors a section at the y-axis. Start orbits in the mirror images of islands as well.
        let mirrored = [0.1, 0.2, 0.3, -0.1, -0.2, -0.3].map(|py| (0.0, py));
        let starts = (-4..=7).map(|k| (0.1 * f64::from(k), 0.0)).chain(mirrored);
        let mut curves = vec![];
        for (k, state) in starts.filter_map(|(y, py)| start(energy, y, py)).enumerate() {
            let section = section(state)?;
            (off, energy_error) = (off.max(section.off), energy_error.max(section.energy_error));
            points += section.points.len();
            let name = if k == 0 { "x = 0, p_x > 0" } else { "" };
            curves.push(Curve::dots(name, colours[k % colours.len()], section.points).marked(0.9));
        }
        panels.push(
            Panel::new(
                format!("Section of Hénon–Heiles, E = {name}"),
                format!("{} orbits, {POINTS} points each, neighbours in other colours; Taylor series to rounding; dimensionless", curves.len()),
                [Axis::linear("y", -0.6..1.05), Axis::linear("p_y", -0.6..0.6)],
                curves,
            ),
        );
    }
    println!("{points} points of three sections");
    claim("x is zero at all of them to 10⁻¹⁵", off < 1e-15)?;
    claim("and the energy is that of the start to 10⁻¹⁴", energy_error < 1e-14)?;
    figure("poincare.svg", (1, 1), &panels)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An orbit above the saddles escapes. Its section has the points before the escape.
    #[test]
    fn orbits_that_escape_have_a_section() -> Result<(), StepError> {
        let escapes = section(start(0.3, 0.1, 0.2).expect("above the potential"))?;
        assert!(escapes.points.len() < POINTS, "{}", escapes.points.len());
        let stays = section(start(1.0 / 12.0, 0.1, 0.0).expect("above the potential"))?;
        assert_eq!(stays.points.len(), POINTS);
        Ok(())
    }
}
