//! Poles of Lagrangians that are solved for velocities. A root of the velocities has an edge that belongs to no state.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// A pole in time. The velocity grows without bound after t = 1.8.
#[lagrangian]
fn fading(q: f64, v: f64, t: f64, a: f64) -> f64 {
    (1.0 + v * v).sqrt() / t * (1.0 + a * q)
}

/// A pole in the position.
#[lagrangian]
fn hanging(q: f64, v: f64, a: f64) -> f64 {
    (1.0 + v * v).sqrt() * (1.0 + a * q) + v.powi(4) / 4.0 + a / q
}

impl Fading {
    /// The state with q = 0.4 and v = 0.5 at t = 1, from p = ∂L/∂v by hand.
    fn start(&self) -> State<f64> {
        State::at(1.0, 0.4, 0.5 / 1.25_f64.sqrt() * (1.0 + 0.4 * self.a))
    }
}

/// Gauss's method agrees with an explicit method, which does not solve the same equations.
#[test]
fn a_root_of_velocities_beside_a_pole() {
    macro_rules! agree {
        ($system:expr, $start:expr) => {{
            let mut gauss = $system.integrator(Gauss::<3>, 0.01, $start);
            let mut explicit = $system.adaptive(DOP853, 1e-12, $start);
            gauss.advance(50).unwrap();
            explicit.advance_to(gauss.time()).unwrap();
            let (a, b) = (gauss.state(), explicit.state());
            assert!((a.q - b.q).abs() < 1e-10 && (a.p - b.p).abs() < 1e-10, "{a:?} {b:?}");
            assert!((a.q - $start.q).abs() > 0.1, "{a:?}");
        }};
    }
    let fading = Fading { a: 0.3 };
    agree!(fading, fading.start());
    let hanging = Hanging { a: 0.3 };
    agree!(hanging, hanging.at(0.8, 0.5));
}

/// The steps that meet a pole are refused, and name it.
#[test]
fn poles_are_named() {
    let hanging = Hanging { a: 0.3 };
    let mut sim = hanging.integrator(Gauss::<2>, 0.05, hanging.at(0.4, -1.2));
    let error = sim.advance(1000).unwrap_err();
    assert!(sim.state().q > 0.0 && error.to_string().contains('q'), "{error}");
    let fading = Fading { a: 0.3 };
    let mut sim = fading.integrator(Gauss::<2>, -0.07, fading.start());
    let error = sim.advance(1000).unwrap_err();
    assert!(sim.time() > 0.0 && error.to_string().contains('t'), "{error}");
}
