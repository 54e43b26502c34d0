//! Can steps begin at the centre of a star, where the equation is singular?
//!
//! A polytrope of index n in equilibrium obeys q'' + (2/t) q' + qⁿ = 0, with H = p²/2 + (2/t)s + qⁿ⁺¹/(n + 1). The flow of p²/2 + (2/t)s is
//! exact in its own time, so steps may begin at t = 0, with order 2. Methods of high order begin at a small t, with a state from the
//! series of the solution.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{claim, largest, orbit, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;

/// V = a q + b q²/2 + c q⁶/6: of index 0, 1 or 5 if one of the three is 1 and the others 0.
#[contact_hamiltonian]
fn lane_emden(q: f64, p: f64, s: f64, t: f64, a: f64, b: f64, c: f64) -> f64 {
    p * p / 2.0 + 2.0 / t * s + a * q + b * q * q / 2.0 + c * q.powi(6) / 6.0
}

/// An index with a solution in closed form.
struct Star {
    n: f64,
    system: LaneEmden,
    end: f64,
    exact: fn(f64) -> f64,
    /// Colours of the curves of order 2 and order 6.
    colours: [Ink; 2],
}

const STARS: [Star; 3] = [
    Star {
        n: 0.0,
        system: LaneEmden { a: 1.0, b: 0.0, c: 0.0 },
        end: 2.4,
        exact: |t| 1.0 - t * t / 6.0,
        colours: [palette::VERMILION, palette::ORANGE],
    },
    Star {
        n: 1.0,
        system: LaneEmden { a: 0.0, b: 1.0, c: 0.0 },
        end: 3.4,
        exact: |t| if t == 0.0 { 1.0 } else { t.sin() / t },
        colours: [palette::GREEN, palette::BLACK],
    },
    Star {
        n: 5.0,
        system: LaneEmden { a: 0.0, b: 0.0, c: 1.0 },
        end: 30.0,
        exact: |t| 1.0 / (1.0 + t * t / 3.0).sqrt(),
        colours: [palette::BLUE, palette::SKY],
    },
];

const CENTRE: ContactState<f64> = ContactState { t: 0.0, q: 1.0, p: 0.0, s: 0.0 };

/// Returns the state at a small t from the series of the solution in powers of t².
fn series(n: f64, t: f64) -> ContactState<f64> {
    let coefficients = [
        1.0,
        -1.0 / 6.0,
        n / 120.0,
        -n * (8.0 * n - 5.0) / 15120.0,
        n * (122.0 * n * n - 183.0 * n + 70.0) / 3_265_920.0,
    ];
    let (mut q, mut p) = (0.0, 0.0);
    for (k, c) in (0..).zip(coefficients) {
        q += c * t.powi(2 * k);
        p += c * f64::from(2 * k) * t.powi(2 * k - 1);
    }
    ContactState::at(t, q, p, 0.0)
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", LaneEmden::REPORT);
    let (mut rows, mut curves, mut stars, mut worst) = (vec![], vec![], vec![], [0.0_f64; 2]);
    for Star { n, system, end, exact, colours: [colour, other] } in STARS {
        let error = |x: &[ContactState<f64>]| largest(x.iter().map(|x| x.q - exact(x.t)));
        let errors = |x: &[ContactState<f64>]| x.iter().map(|x| (x.t, (x.q - exact(x.t)).abs())).collect();
        let centre = orbit(system, ContactSplitting, 0.01, CENTRE, end)?;
        let coarse = orbit(system, ContactSplitting, 0.2, CENTRE, end)?;
        let begin = 0.1;
        let sixth = orbit(system, Yoshida6a.of(ContactSplitting), 0.01, series(n, begin), end - begin)?;
        worst = [worst[0].max(error(&centre)), worst[1].max(error(&sixth))];
        let [a, b, c] = [&coarse, &centre, &sixth].map(|x| format!("{:.1e}", error(x)));
        rows.push([n.to_string(), end.to_string(), a, b, c]);
        curves.push(Curve::line(format!("order 2, n = {n}"), colour, errors(&centre[1..])));
        curves.push(Curve::line(format!("order 6, n = {n}"), other, errors(&sixth)).width(1.0).rounding());
        let shown = |x: &[ContactState<f64>]| x.iter().map(|x| (x.t, x.q)).take_while(|x| x.0 <= 10.0).collect();
        stars.push(Curve::line(format!("n = {n}"), colour, shown(&centre)));
        stars.push(Curve::dots("", colour, shown(&coarse)).open());
    }
    println!("largest error of q\n");
    let head = ["n", "up to t =", "from t = 0, h = 0.2", "h = 0.01", "order 6 from t = 0.1, h = 0.01"];
    println!("{}", table(head, &rows));
    claim("from the centre, steps of 0.01 err by less than 8.5e-6", worst[0] < 8.5e-6)?;
    claim("with a series for the first 0.1, order 6 errs by less than 1e-10", worst[1] < 1e-10)?;

    let stars = Panel::new(
        "Polytropic stars of index n",
        "ContactSplitting from the centre; lines: h = 0.01, markers: h = 0.2; the density is qⁿ, lengths in Emden's unit",
        [Axis::linear("t, the distance from the centre", 0.0..10.0), Axis::linear("q", -0.2..1.0)],
        stars,
    );
    let errors = Panel::new(
        "Polytropic stars: error of q",
        "h = 0.01; order 2: ContactSplitting from t = 0; order 6: Yoshida6a.of(ContactSplitting) from t = 0.1",
        [Axis::decades("t, the distance from the centre", -2.0..1.5), Axis::decades("|error of q|", -17.0..-3.0)],
        curves,
    );
    figure("lane_emden.svg", (4, 3), &[stars, errors])
}
