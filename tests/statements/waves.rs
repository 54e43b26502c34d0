//! T40: fields in space, as lattices that are refined.

use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::f64::consts::TAU;

/// Half the length of the string.
const HALF: f64 = 12.0;

/// Speed of the kink.
const SPEED: f64 = 0.6;
const DENSITY: f64 = 1.7;
const TENSION: f64 = 2.3;
const WEIGHT: f64 = 1.4;

/// A kink of ρ φ'' = τ φₓₓ − κ sin φ: φ = 4 atan exp(γ (x − vt)/l) with l² = τ/κ and γ² = 1/(1 − v² ρ/τ).
fn kink(x: f64, t: f64) -> f64 {
    4.0 * (steepness() * (x - SPEED * t)).exp().atan()
}

/// ∂φ/∂t at t = 0.
fn velocity(x: f64) -> f64 {
    -2.0 * SPEED * steepness() / (steepness() * x).cosh()
}

/// γ/l.
fn steepness() -> f64 {
    (WEIGHT / (TENSION - SPEED * SPEED * DENSITY)).sqrt()
}

/// The largest error of φ at t = 4, and the largest relative change of the energy.
struct Outcome {
    error: f64,
    change: f64,
}

/// Lattices with `N` points between fixed ends, φ = 0 and φ = 2π.
macro_rules! lattices {
    ($($name:ident: $points:literal;)*) => { $(
        mod $name {
            use super::*;

            const N: usize = $points;
            const DX: f64 = 2.0 * HALF / (N + 1) as f64;

            #[hamiltonian(const N = $points)]
            pub(super) fn string(q: [f64; N], p: [f64; N], dx: f64, density: f64, tension: f64, weight: f64) -> f64 {
                let mut energy = tension * (q[0] * q[0] + (TAU - q[N - 1]) * (TAU - q[N - 1])) / (2.0 * dx);
                for i in 0..N {
                    energy += p[i] * p[i] / (2.0 * density * dx) + weight * dx * (1.0 - q[i].cos());
                }
                for i in 1..N {
                    energy += tension * (q[i] - q[i - 1]) * (q[i] - q[i - 1]) / (2.0 * dx);
                }
                energy
            }

            pub(super) fn run<M: Method<String>>(method: M) -> Result<Outcome, StepError> {
                let x: [f64; N] = std::array::from_fn(|i| (i + 1) as f64 * DX - HALF);
                let start = State::new(x.map(|x| kink(x, 0.0)), x.map(|x| DENSITY * DX * velocity(x)));
                let system = String { dx: DX, density: DENSITY, tension: TENSION, weight: WEIGHT };
                let mut sim = system.integrator(method, DX / 2.0, start);
                let (energy, mut change) = (sim.energy(), 0.0_f64);
                while sim.time() < 4.0 - DX / 4.0 {
                    sim.step()?;
                    change = change.max((sim.energy() / energy - 1.0).abs());
                }
                let end = sim.state();
                let error = (0..N).map(|i| (end.q[i] - kink(x[i], end.t)).abs()).fold(0.0, f64::max);
                Ok(Outcome { error, change })
            }
        }
    )* };
}

lattices! {
    coarse: 29;
    middle: 59;
    fine: 119;
}

/// The error of a kink is O(Δx²) with h = Δx/2, and the energy stays on each lattice.
#[test]
fn a_kink_on_lattices_that_are_refined() -> Result<(), StepError> {
    let outcomes = [coarse::run(DiscreteGradient)?, middle::run(DiscreteGradient)?, fine::run(DiscreteGradient)?];
    for pair in outcomes.windows(2) {
        let order = (pair[0].error / pair[1].error).log2();
        assert!((order - 2.0).abs() < 0.15, "{order}");
    }
    for Outcome { change, .. } in outcomes {
        assert!(change < 2e-14, "{change:e}");
    }
    // Control: explicit steps do not keep the energy.
    let verlet = middle::run(StormerVerlet)?;
    assert!(verlet.change > 1e-6, "{:e}", verlet.change);
    Ok(())
}
