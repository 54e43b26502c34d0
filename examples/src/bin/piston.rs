//! Do steps obey both laws of thermodynamics?
//!
//! Two gases of heat capacities 1.5 and 2.5 fill a cylinder of length 2. The piston between them has mass 1 and conducts heat: x = (place q, momentum
//! p, energies U₁, U₂). The equations are x' = L∇E + M∇S (M. Grmela & H. C. Öttinger, Phys. Rev. E 56 (1997) 6620) with E = p²/2 + U₁ + U₂ and
//! S = 1.5 ln U₁ + ln q + 2.5 ln U₂ + ln(2 − q). L holds the pressures U₁/(1.5 q) and U₂/(2.5 (2 − q)), and M conducts heat from the hot gas to the cold
//! one. The attribute proves L∇S = 0 and M∇E = 0. A step of `DiscreteGradient` keeps E to rounding, and S falls in no step. The midpoint rule keeps this
//! quadratic E as well, but its entropy falls in some steps.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, largest, orbit, order, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;

/// x is (place, momentum, energy of the left gas, energy of the right gas).
#[hamiltonian(
    structure = |i, j| if i == 0 && j == 1 {
        1.0
    } else if i == 1 && j == 2 {
        x[2] / (1.5 * x[0])
    } else if i == 1 && j == 3 {
        -x[3] / (2.5 * (2.0 - x[0]))
    } else {
        0.0
    },
    entropy = 1.5 * x[2].ln() + x[0].ln() + 2.5 * x[3].ln() + (2.0 - x[0]).ln(),
    friction = {
        let flow = kappa * (x[2] / 1.5) * (x[3] / 2.5);
        [[0.0; 4], [0.0; 4], [0.0, 0.0, flow, -flow], [0.0, 0.0, -flow, flow]]
    },
)]
fn piston(x: [f64; 4], kappa: f64) -> f64 {
    x[1] * x[1] / 2.0 + x[2] + x[3]
}

type Gases = FlowState<[f64; 4]>;

const SYSTEM: Piston = Piston { kappa: 0.2 };
const START: [f64; 4] = [0.6, 0.3, 1.0, 2.0];
/// The exact solution at t = 10, from an extrapolation method in 22 digits.
const END: [f64; 4] = [1.1326358962788234, -0.098_882_836_219_990_43, 0.960_846_833_573_062_9, 2.0792642587774824];
const DURATION: f64 = 40.0;

fn temperatures(x: &Gases) -> [f64; 2] {
    [x.x[2] / 1.5, x.x[3] / 2.5]
}

/// How far a run is from both laws, and from the exact solution at t = 10.
struct Found {
    energy: f64,
    /// The largest fall of the entropy in a step.
    fall: f64,
    error: f64,
}

fn found(states: &[Gases], h: f64) -> Found {
    let energy = SYSTEM.energy(&states[0]);
    let at_10 = states[(10.0 / h).round() as usize].x;
    Found {
        energy: largest(states.iter().map(|x| SYSTEM.energy(x) / energy - 1.0)),
        fall: largest(states.windows(2).map(|x| (SYSTEM.entropy(&x[0]) - SYSTEM.entropy(&x[1])).max(0.0))),
        error: largest((0..4).map(|i| at_10[i] - END[i])),
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", Piston::<f64>::REPORT);
    let start = FlowState::new(START);
    let (mut rows, mut errors) = (vec![], vec![]);
    for h in [0.2, 0.1, 0.05] {
        let gradient = found(&orbit(SYSTEM, DiscreteGradient, h, start, DURATION)?, h);
        let midpoint = found(&orbit(SYSTEM, ImplicitMidpoint, h, start, DURATION)?, h);
        let explicit = found(&orbit(SYSTEM, RK4, h, start, DURATION)?, h);
        let show = |found: &Found| [found.energy, found.fall, found.error].map(|x| format!("{x:.1e}")).join(" ");
        let [a, b, c] = [&gradient, &midpoint, &explicit].map(show);
        rows.push([h.to_string(), a, b, c]);
        errors.push([gradient, midpoint, explicit]);
    }
    println!(
        "change of the energy, largest fall of the entropy in a step, both up to t = {DURATION}; error at t = 10\n"
    );
    println!("{}", table(["h", "DiscreteGradient", "ImplicitMidpoint", "RK4"], &rows));
    let [coarse, fine, finest] = &errors[..] else { return Ok(()) };
    claim("DiscreteGradient keeps the energy, and its entropy falls in no step, to rounding", {
        errors.iter().all(|[gradient, ..]| gradient.energy < 1e-14 && gradient.fall < 4e-15)
    })?;
    claim("with ImplicitMidpoint the entropy falls, with steps of 0.2 and of 0.05", {
        coarse[1].fall > 1e-6 && finest[1].fall > 1e-8
    })?;
    claim("RK4 does not keep the energy", coarse[2].energy > 1e-6)?;
    let observed = order(fine[0].error, finest[0].error);
    claim(&format!("DiscreteGradient has order 2 (observed {observed:.2})"), (observed - 2.0).abs() < 0.1)?;
    let states = orbit(SYSTEM, DiscreteGradient, 0.1, start, 200.0)?;
    let [left, right] = temperatures(&states[states.len() - 1]);
    claim("in the end both gases are equally warm", (left - right).abs() < 1e-3)?;

    let insulator = Piston { kappa: 0.0 };
    let entropy = insulator.entropy(&start);
    let drift = |states: &[Gases]| -> Vec<(f64, f64)> {
        states.iter().skip(1).map(|x| (x.t, (insulator.entropy(x) - entropy).abs())).collect()
    };
    let kept = drift(&orbit(insulator, DiscreteGradient, 0.1, start, DURATION)?);
    let lost = drift(&orbit(insulator, ImplicitMidpoint, 0.1, start, DURATION)?);
    let [most, least] = [&kept, &lost].map(|drift| largest(drift.iter().map(|point| point.1)));
    claim("without conduction DiscreteGradient keeps the entropy, and ImplicitMidpoint does not", {
        most < 1e-14 && least > 1e-5
    })?;

    let curve = |name: &str, colour, of: &dyn Fn(&Gases) -> f64| {
        let points = states.iter().take_while(|x| x.t <= DURATION).map(|x| (x.t, of(x)));
        Curve::line(name, colour, points.collect())
    };
    let motion = vec![
        curve("entropy", palette::GREEN, &|x| SYSTEM.entropy(x)),
        curve("place of the piston", palette::BLACK, &|x| x.x[0]),
        curve("temperature, left", palette::BLUE, &|x| temperatures(x)[0]),
        curve("temperature, right", palette::VERMILION, &|x| temperatures(x)[1]),
    ];
    let motion = Panel::new(
        "A piston between two gases comes to rest",
        "DiscreteGradient, h = 0.1; length 2, mass 1, heat capacities 1.5 and 2.5, conductivity 0.2",
        [Axis::linear("time", 0.0..DURATION), Axis::linear("place, temperatures, entropy", 0.4..2.2)],
        motion,
    );
    let entropies = Panel::new(
        "Error of the entropy without conduction of heat",
        "h = 0.1; the entropy of the exact solution is constant",
        [Axis::linear("time", 0.0..DURATION), Axis::decades("|error|", -17.0..-2.0)],
        vec![
            Curve::line("ImplicitMidpoint", palette::VERMILION, lost).width(1.0).solid(),
            Curve::line("DiscreteGradient", palette::BLUE, kept).width(1.0).solid(),
        ],
    );
    figure("piston.svg", (3, 2), &[motion, entropies])
}
