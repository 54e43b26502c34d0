//! Methods that keep the energy to rounding, and other integrals; the controls are symplectic or explicit methods of the same order.

use crate::claim::{change, energy, has_order, holds};
use crate::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

const STEPS: u64 = 2000;
/// Relative change of the energy that rounding explains after [`STEPS`] steps.
const ROUNDING: f64 = 1e-13;

fn start() -> State<[f64; 2]> {
    State::new([0.3, -0.2], [0.2, 0.4])
}

/// Each method of a list keeps the energy of one system; the control does not.
macro_rules! keep_the_energy {
    ($system:expr, from $start:expr, h = $h:literal, control $control:expr => $($method:expr),* $(,)?) => { $(
        holds(
            stringify!($method),
            ROUNDING,
            energy(STEPS),
            $system.integrator($method, $h, $start),
            $system.integrator($control, $h, $start),
        );
    )* };
}

#[test]
fn discrete_gradients() {
    keep_the_energy! { HENON_HEILES, from start(), h = 0.1, control ImplicitMidpoint =>
        DiscreteGradient, Gonzalez, MeanValue::<2>, ItohAbe, SymmetrisedItohAbe, ItohAbePair,
        FourthOrder(DiscreteGradient), Suzuki4.of(DiscreteGradient),
    }
    keep_the_energy! { PENDULUM, from State::new(2.0, 0.3), h = 0.05, control StormerVerlet => CoordinateIncrement::default() }
}

#[test]
fn corrected_steps() {
    keep_the_energy! { HENON_HEILES, from start(), h = 0.1, control RK4 => Projection(RK4, Energy), Relaxation(RK4) }
}

#[test]
fn order_four_with_exact_energy() {
    let mut series = HENON_HEILES.taylor(Taylor { tolerance: 1e-16 }, start());
    series.advance_to(2.0).expect("the problem is regular");
    let run = |h| HENON_HEILES.integrator(FourthOrder(DiscreteGradient), h, start());
    let control = |h| HENON_HEILES.integrator(DiscreteGradient, h, start());
    has_order("FourthOrder(DiscreteGradient)", 4, 0.1, series.state(), run, control);
}

/// H of degree 3: Kahan's map is reversible and keeps a modified energy, which RK4 does not for long.
#[test]
fn kahan() {
    let run = |h| HENON_HEILES.integrator(Kahan, h, start());
    let mut series = HENON_HEILES.taylor(Taylor { tolerance: 1e-16 }, start());
    series.advance_to(2.0).expect("the problem is regular");
    has_order("Kahan", 2, 0.1, series.state(), run, |h| HENON_HEILES.integrator(ExplicitEuler, h, start()));
}

/// The tree discrete gradient and splittings keep angular momentum to rounding.
#[test]
fn angular_momentum() {
    let start = State::new([0.8, 0.1], [0.2, 1.4]);
    let momentum = || change(STEPS, |x: &State<[f64; 2]>| x.q[0] * x.p[1] - x.q[1] * x.p[0]);
    let control = || KEPLER.integrator(RK4, 0.05, start);
    holds("DiscreteGradient", ROUNDING, momentum(), KEPLER.integrator(DiscreteGradient, 0.05, start), control());
    holds("StormerVerlet", ROUNDING, momentum(), KEPLER.integrator(StormerVerlet, 0.05, start), control());
    holds("Gauss", ROUNDING, momentum(), KEPLER.integrator(Gauss::<2>, 0.05, start), control());
}

/// Rattle and the discrete gradient stay on the constraint; the discrete gradient keeps the energy as well, Rattle does not.
#[test]
fn constraints() {
    let start = State::new([1.0, -1.0, -0.5], [0.7, 0.4, 0.6]);
    let run = |method| ON_A_SPHERE.integrator(method, 0.02, start);
    let off = change(STEPS, |x: &State<[f64; 3]>| x.q.iter().map(|q| q * q).sum::<f64>());
    for defect in [off(&mut ON_A_SPHERE.integrator(Rattle, 0.02, start)), off(&mut run(DiscreteGradient))] {
        assert!(defect < ROUNDING, "{defect:.1e}");
    }
    // The control: the same motion by forces alone leaves the sphere by its error.
    holds("constraint", ROUNDING, energy(STEPS), run(DiscreteGradient), ON_A_SPHERE.integrator(Rattle, 0.02, start));
}
