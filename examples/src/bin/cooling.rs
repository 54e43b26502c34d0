//! How does a pendulum cool if both its friction and its speed depend on the action?
//!
//! The contact Hamiltonian is H = E(q, p) f(s), with the energy E = p²/2 + V(q) of the pendulum and the action s. It gives
//! q' = f ∂E/∂p and p' = −f ∂E/∂q − E f'(s) p. So f is the speed at which time passes for E, and E f' is the coefficient of friction.
//!
//! Here f = eᵏˢ, for two reasons. First, ∂H/∂s = k H, so H itself decays by an exact law: H' = −k H², hence 1/H = 1/H₀ + k t. The errors of steps
//! are measured against this law. Second, the flows of both parts, (p²/2) f and V f, have closed forms, so a step of a splitting is explicit.
//!
//! E obeys E' = −k p² H, so it never grows. Small swings have the mean p² = E. Then E' = −k E H on average, and E decays as H does: as 1/t, ever more
//! slowly. Systems that keep a temperature are in the example `sampling`.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, orbit, order, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;

/// H = E f. E = 0 if the pendulum hangs at rest. Mass, length and gravity are 1. The method `energy` of `Cooling` returns H.
#[contact_hamiltonian]
fn cooling(q: f64, p: f64, s: f64, k: f64) -> f64 {
    // V = 1 − cos q = 2 sin²(q/2). The second form has no cancellation near q = 0.
    let sine = (q / 2.0).sin();
    (p * p / 2.0 + 2.0 * sine * sine) * (k * s).exp()
}

const SYSTEM: Cooling = Cooling { k: 0.3 };
const START: ContactState<f64> = ContactState { t: 0.0, q: 1.0, p: 1.8, s: 0.0 };

/// Returns E, which is H without the factor f.
fn pendulum_energy(x: &ContactState<f64>) -> f64 {
    x.p * x.p / 2.0 + 1.0 - x.q.cos()
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Cooling::REPORT);
    let law = |t: f64| 1.0 / (1.0 / SYSTEM.energy(&START) + SYSTEM.k * t);
    let deviation = |states: Vec<ContactState<f64>>| largest(states.iter().map(|x| SYSTEM.energy(x) / law(x.t) - 1.0));
    let (mut rows, mut errors) = (vec![], vec![]);
    for h in [0.4, 0.2, 0.1] {
        let two = deviation(orbit(SYSTEM, ContactSplitting, h, START, 100.0)?);
        let four = deviation(orbit(SYSTEM, BlanesMoan4X, h, START, 100.0)?);
        errors.push([two, four]);
        rows.push([h.to_string(), format!("{two:.1e}"), format!("{four:.1e}")]);
    }
    println!("largest relative deviation of H from the law 1/H = 1/H₀ + k t, up to t = 100\n");
    println!("{}", table(["h", "ContactSplitting", "BlanesMoan4X"], &rows));
    let [two, four] = [0, 1].map(|i| order(errors[1][i], errors[2][i]));
    claim(&format!("the law is kept to orders 2 and 4 (observed {two:.2}, {four:.2})"), {
        (two - 2.0).abs() < 0.1 && (four - 4.0).abs() < 0.3
    })?;
    let states = orbit(SYSTEM, ContactSplitting, 0.1, START, 100.0)?;
    // E' is 0 where p = 0. There the error of a step may let E grow. This error is of order h³ = 1e-3, which sets the tolerance.
    let gains = states.windows(2).filter(|x| pendulum_energy(&x[1]) > pendulum_energy(&x[0]) + 1e-3).count();
    claim("E decays, to the error of a step", gains == 0)?;

    let path = states.iter().map(|x| (x.q, x.p)).collect();
    let path = Panel::new(
        "A pendulum that cools",
        "ContactSplitting, h = 0.1, up to t = 100; k = 0.3; unit mass, length and gravity",
        [Axis::linear("q (rad)", -2.5..2.5), Axis::linear("p", -2.2..2.2)],
        vec![Curve::line("(q, p) from (1, 1.8)", palette::BLUE, path).width(1.2)],
    );
    let curve = |name: &str, colour, of: &dyn Fn(&ContactState<f64>) -> f64| {
        Curve::line(name, colour, states.iter().map(|x| (x.t, of(x))).collect())
    };
    let steps = orbit(SYSTEM, ContactSplitting, 0.4, START, 100.0)?;
    let dots = steps.iter().step_by(5).map(|x| (x.t, SYSTEM.energy(x))).collect();
    let decay = vec![
        curve("1/(1/H₀ + k t)", palette::GREY, &|x| law(x.t)),
        Curve::dots("H, h = 0.4", palette::VERMILION, dots).open(),
        curve("E, h = 0.1", palette::BLUE, &pendulum_energy),
    ];
    let decay = Panel::new(
        "Decay of H and E",
        "ContactSplitting, k = 0.3; H at every fifth step; unit mass, length and gravity",
        [Axis::linear("time", 0.0..100.0), Axis::decades("energy", -2.0..0.5)],
        decay,
    );
    figure("cooling.svg", (4, 3), &[path, decay])
}
