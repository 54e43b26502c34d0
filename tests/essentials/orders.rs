//! The order of convergence of every method family for T + V, for coupled energies, and for A + B; the control of each has a lower order.

use crate::claim::{distance_from, has_order, holds};
use crate::systems::*;
use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// Rows of methods on one system: each must have its order, and its control a lower one.
///
/// The solution is a Taylor series with a tolerance near rounding.
macro_rules! orders {
    ($System:ty, $system:expr, from $start:expr, to $end:literal, h = $h:literal: $($method:expr, control $control:expr;)*) => {{
        let (system, start): ($System, _) = ($system, $start);
        let mut series = system.taylor(Taylor { tolerance: 1e-16 }, start);
        series.advance_to($end).expect("the problem is regular");
        $( has_order(
            stringify!($method),
            Method::<$System>::claims(&$method).order,
            $h,
            series.state(),
            |h| system.integrator($method, h, start),
            |h| system.integrator($control, h, start),
        ); )*
    }};
}

#[test]
fn explicit_and_collocation_methods() {
    orders! { HenonHeiles, HENON_HEILES, from State::new([0.3, -0.2], [0.2, 0.4]), to 2.0, h = 0.1:
        RK4, control ExplicitEuler;
        ImplicitMidpoint, control ExplicitEuler;
        Gauss::<3>, control Gauss::<2>;
        Suzuki4.of(ImplicitMidpoint), control ImplicitMidpoint;
    }
}

#[test]
fn splittings() {
    orders! { HenonHeiles, HENON_HEILES, from State::new([0.3, -0.2], [0.2, 0.4]), to 2.0, h = 0.1:
        StormerVerlet, control SymplecticEuler;
        PositionVerlet, control SymplecticEulerAdjoint;
        BlanesMoan6, control BlanesMoan4;
        BlanesMoanSrkn14a, control BlanesMoan4;
        Chin4C, control StormerVerlet;
        BlanesCasasRos6, control BlanesMoan4;
    }
}

/// Longer steps: with short ones rounding would hide the error.
#[test]
fn order_eight() {
    orders! { HenonHeiles, HENON_HEILES, from State::new([0.3, -0.2], [0.2, 0.4]), to 4.0, h = 0.5:
        DOP853, control RK4;
        KahanLi8_17a.of(StormerVerlet), control BlanesMoan6;
    }
}

#[test]
fn an_exact_part_and_a_rest() {
    orders! { HenonHeiles, HENON_HEILES, from State::new([0.3, -0.2], [0.2, 0.4]), to 2.0, h = 0.1:
        WisdomHolman, control ExplicitEuler;
        Aba8_6_4, control WisdomHolman;
        Saba4Gradient, control WisdomHolman;
        WisdomHolmanGradient, control WisdomHolman;
        Perturbation(BlanesMoan6), control Perturbation(BlanesMoan4);
    }
}

#[test]
fn coupled_energies() {
    orders! { Shears, SHEARS, from State::new(0.5, 0.3), to 2.0, h = 0.1:
        PieceSplitting, control ExplicitEuler;
        BlanesMoan4X.of(PieceSplitting), control PieceSplitting;
    }
}

/// Two planets: exact orbits about the star leave an error of the order of the planets' masses, kicks and drifts do not.
#[test]
fn planets_about_a_star() {
    let start =
        State::new([[0.0, 0.0], [1.0, 0.1], [-1.9, 0.4]], [[0.0, 0.0], [-0.000_2, 0.002_35], [-0.000_1, -0.000_85]]);
    let mut series = PLANETS.taylor(Taylor { tolerance: 1e-15 }, start);
    series.advance_to(6.0).expect("the problem is regular");
    holds(
        "Wisdom and Holman's map of planets",
        1e-4,
        distance_from(series.state()),
        PLANETS.integrator(WisdomHolman, 0.1, start),
        PLANETS.integrator(StormerVerlet, 0.1, start),
    );
}

/// Steps that adapt meet their tolerance. The control tolerates larger errors.
#[test]
fn adaptive_steps_and_series() {
    let start = State::new([0.3, -0.2], [0.2, 0.4]);
    let known = || {
        let mut run = HENON_HEILES.integrator(Gauss::<6>, 0.02, start);
        run.advance(500).expect("the problem is regular");
        distance_from(run.state())
    };
    let series = |tolerance| HENON_HEILES.taylor(Taylor { tolerance }, start);
    holds("Taylor series", 1e-12, known(), series(1e-14), series(1e-6));
    let fixed = HENON_HEILES.taylor(TaylorFixed::<16> { h: 0.1 }, start);
    holds(
        "Taylor series of fixed steps",
        1e-12,
        known(),
        fixed,
        HENON_HEILES.taylor(TaylorFixed::<6> { h: 0.1 }, start),
    );
    let adaptive = |tolerance| HENON_HEILES.adaptive(DOP853, tolerance, start);
    holds("steps that adapt", 1e-9, known(), adaptive(1e-11), adaptive(1e-5));
}
