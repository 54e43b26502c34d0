//! How long may steps be for a stiff oscillation?
//!
//! Van der Pol's oscillator q' = s, s' = ε(1 − q²)s − q is the base of H = p s − ε(1 − q²)s + q. The option `lift` of the attribute states
//! this. The momentum p grows and is left out. The macro finds two pieces. The piece with ε is solved exactly with an exponential;
//! F. Zadra, A. Bravetti & M. Seri, Mathematics 9 (2021) 1960. A splitting into three pieces and RK4 are less accurate or unstable. All
//! methods give a wrong period if hε is near 1: the runs are stable but not accurate, and no two turns take the same time.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, orbit, table};
use geoint_runtime::prelude::*;
use geoint_runtime::{Method, PhaseSpace, StepError};
use std::error::Error;

/// Van der Pol's oscillator in (q, s).
#[contact_hamiltonian(lift)]
fn van_der_pol(q: f64, p: f64, s: f64, eps: f64) -> f64 {
    p * s - eps * (1.0 - q * q) * s + q
}

/// Van der Pol's oscillator, split into three pieces.
#[contact_hamiltonian(lift, split = "p * s | -eps * (1.0 - q * q) * s | q")]
fn three_pieces(q: f64, p: f64, s: f64, eps: f64) -> f64 {
    p * s - eps * (1.0 - q * q) * s + q
}

/// Van der Pol's oscillator under a periodic force.
#[contact_hamiltonian(lift)]
fn forced(q: f64, p: f64, s: f64, t: f64, eps: f64, a: f64, omega: f64) -> f64 {
    p * s - eps * (1.0 - q * q) * s + q - a * (omega * t).cos()
}

type Point = (f64, f64, f64);

/// Returns (t, q, s) after each step of the splitting, from (q, s) = (2, 0).
fn splitting<S: PhaseSpace<Action = f64, State = ContactState<f64>>>(
    system: S,
    h: f64,
    end: f64,
) -> Result<Vec<Point>, StepError>
where
    ContactSplitting: Method<S, f64>,
{
    let states = orbit(system, ContactSplitting, h, ContactState::new(2.0, 0.0, 0.0), end)?;
    Ok(states.into_iter().map(|x| (x.t, x.q, x.s)).collect())
}

/// Returns (t, q, s) after each step of RK4, from (q, s) = (2, 0). The run ends if |q| exceeds 1000.
fn runge_kutta(eps: f64, h: f64, end: f64) -> Vec<Point> {
    let rate = |[q, s]: [f64; 2]| [s, eps * (1.0 - q * q) * s - q];
    let ahead = |x: [f64; 2], h: f64, k: [f64; 2]| [x[0] + h * k[0], x[1] + h * k[1]];
    let step = |&(t, q, s): &Point| {
        let x = [q, s];
        let a = rate(x);
        let b = rate(ahead(x, h / 2.0, a));
        let c = rate(ahead(x, h / 2.0, b));
        let d = rate(ahead(x, h, c));
        let [q, s] = [0, 1].map(|i| x[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        (q.abs() < 1e3).then_some((t + h, q, s))
    };
    std::iter::successors(Some((0.0, 2.0, 0.0)), step).take((end / h).round() as usize).collect()
}

/// Returns the mean of the periods between upward passages of q = 0, and half of their range. The first period is left out.
fn period(points: &[Point]) -> Option<(f64, f64)> {
    let upwards = points.windows(2).filter(|x| x[0].1 < 0.0 && x[1].1 >= 0.0);
    let times: Vec<f64> = upwards.map(|x| x[0].0 + (x[1].0 - x[0].0) * x[0].1 / (x[0].1 - x[1].1)).collect();
    let [_, first, .., last] = times[..] else { return None };
    let periods = times[1..].windows(2).map(|pair| pair[1] - pair[0]);
    let (least, most) = periods.fold((f64::MAX, 0.0_f64), |(least, most), x| (least.min(x), most.max(x)));
    Some(((last - first) / (times.len() - 2) as f64, (most - least) / 2.0))
}

/// Formats a period with its significant digits. The period of an irregular motion has fewer than four decimals.
fn shown((mean, spread): (f64, f64)) -> String {
    if spread < 5e-5 {
        return format!("{mean:.4}");
    }
    let decimals = (-spread.log10().floor()).clamp(0.0, 4.0) as usize;
    format!("{mean:.decimals$} ± {spread:.decimals$}")
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", VanDerPol::REPORT);
    let (mut rows, mut two_pieces) = (vec![], vec![]);
    let periods = [(5.0, 11.6122, [0.1, 0.05]), (50.0, 82.5083, [0.02, 0.005]), (100.0, 162.837, [0.01, 0.002])];
    for (eps, known, steps) in periods {
        for h in steps {
            let end = 6.0 * known;
            let two = period(&splitting(VanDerPol { eps }, h, end)?);
            let three = period(&splitting(ThreePieces { eps }, h, end)?);
            let rk4 = period(&runge_kutta(eps, h, end));
            // Error of the mean period, and relative spread of the periods.
            two_pieces.push(two.map_or([f64::NAN; 2], |(mean, spread)| [mean - known, spread / known]));
            let cells = [two, three, rk4].map(|x| x.map_or("none".into(), shown));
            let [a, b, c] = cells;
            rows.push([eps.to_string(), known.to_string(), h.to_string(), a, b, c]);
        }
    }
    println!("periods of the flow and of the methods; ±: half of the range of the periods of an irregular motion\n");
    println!("{}", table(["ε", "period", "h", "two pieces", "three pieces", "RK4"], &rows));
    claim("two pieces, ε = 50, h = 0.005: the period is right to 2e-4", two_pieces[3][0].abs() < 2e-4)?;
    claim("at hε = 1 they are stable but irregular: turns differ by more than 2 %", {
        [two_pieces[2], two_pieces[4]].iter().all(|[_, irregular]| *irregular > 0.01)
    })?;
    claim("RK4 is not: it is gone before the first period", period(&runge_kutta(50.0, 0.02, 500.0)).is_none())?;

    let mut stiff = vec![];
    for (h, name, colour) in [(0.005, "h = 0.005", palette::GREY), (0.02, "h = 0.02", palette::BLUE)] {
        let points = splitting(VanDerPol { eps: 50.0 }, h, 300.0)?;
        let curve = Curve::line(name, colour, points.iter().map(|x| (x.0, x.1)).collect());
        // Rounding errors determine the periods of an irregular motion.
        stiff.push(if h == 0.02 { curve.rounding() } else { curve });
    }
    let stiff = Panel::new(
        "Van der Pol's oscillator, ε = 50",
        "ContactSplitting from (2, 0), dimensionless; at hε = 1 the run is stable but irregular",
        [Axis::linear("time", 0.0..300.0), Axis::linear("q", -2.5..2.5)],
        stiff,
    );
    let cycles = [(0.5, palette::VERMILION), (2.0, palette::GREEN), (5.0, palette::BLUE)].map(|(eps, colour)| {
        let points = splitting(VanDerPol { eps }, 0.02, 45.0)?;
        // Draw one turn, because several dashed turns would fill each other's gaps.
        let around = period(&points).map_or(0, |(mean, _)| (mean / 0.02).ceil() as usize);
        let cycle = points[points.len() - 1 - around..].iter().map(|x| (x.1, x.2)).collect();
        Ok::<_, StepError>(Curve::line(format!("ε = {eps}"), colour, cycle))
    });
    let cycles = Panel::new(
        "Limit cycles of van der Pol's oscillator",
        "ContactSplitting, h = 0.02; dimensionless",
        [Axis::linear("q", -2.5..2.5), Axis::linear("s = q'", -8.0..8.0)],
        cycles.into_iter().collect::<Result<_, _>>()?,
    );
    let points = splitting(Forced { eps: 5.0, a: 5.0, omega: 2.463 }, 0.02, 300.0)?;
    let points = points[5000..].iter().map(|x| (x.1, x.2)).collect();
    let forced = vec![Curve::line("t = 100 to 300", palette::VERMILION, points).width(0.4).solid().rounding()];
    let forced = Panel::new(
        "Van der Pol's oscillator with the force 5 cos 2.463t",
        "ε = 5; ContactSplitting, h = 0.02; dimensionless",
        [Axis::linear("q", -2.5..2.5), Axis::linear("s = q'", -11.0..8.0)],
        forced,
    );
    figure("van_der_pol.svg", (4, 3), &[stiff, cycles, forced])
}
