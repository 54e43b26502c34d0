//! Coefficients and solutions against 45 digits (Taylor of order 60, or Kepler's equation).

use geoint_runtime::prelude::*;
use geoint_runtime::space::PerCoordinate;
use geoint_runtime::system::Jets;

#[hamiltonian]
fn pendulum(q: f64, p: f64) -> f64 {
    p * p / 2.0 - q.cos()
}

#[hamiltonian]
fn kepler(q: [f64; 2], p: [f64; 2]) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// The coefficients of orders 1 to 32.
fn jet<S: Jets>(system: &S, z: S::Phase, s: S::Action) -> [PerCoordinate<S::Phase, S::Action>; 32] {
    let mut jet = [PerCoordinate { z, s }; 32];
    let mut switches = [<S::Switches as geoint_runtime::space::Array>::zero(); 32];
    system.jet(0.0, &z, &s, &mut jet, &mut switches);
    jet
}

fn close(x: f64, y: f64, tolerance: f64) {
    assert!((x - y).abs() <= tolerance * y.abs(), "{x} is not {y}: {:.1e}", (x / y - 1.0).abs());
}

#[test]
fn coefficients_of_a_pendulum() {
    let jet = jet(&Pendulum, [[1.5], [0.0]], ());
    for (n, q) in [
        (2, -0.49874749330202721547086168557074),
        (4, 0.0029400001679139004604321833918356),
        (10, -0.000051015472714456247076745144004859),
        (20, 5.3094121208553497531926935937082e-10),
        (30, 6.360890320930180579106305762566e-14),
    ] {
        close(jet[n - 1].z[0][0], q, 1e-14);
        close(jet[n - 2].z[1][0], n as f64 * q, 1e-14);
        assert_eq!(jet[n].z[0][0], 0.0);
    }
}

#[test]
fn coefficients_of_kepler() {
    let jet = jet(&Kepler, [[1.0 - 0.6, 0.0], [0.0, 2.0]], ());
    for (n, x, y) in [
        (2, -3.1249999999999996530553048046386, 2.0),
        (6, -66.96912977430554049719204881244, 26.041666666666661245655804239145),
        (10, -3801.6357539612558303423995778242, 1319.0812745001787430347298733763),
        (20, 233415012.20245212159685016308592, -74924910.781797409682337322161518),
        (30, -22382248025479.043891766334785098, 7009490471552.3763816577373396258),
    ] {
        close(jet[n - 1].z[0][0], x, 2e-14);
        close(jet[n - 2].z[0][1], y, 2e-14);
    }
}

#[test]
fn a_pendulum() {
    for fixed in [false, true] {
        let state = State::new(1.5, 0.0);
        let end = if fixed {
            let mut sim = Pendulum.taylor(TaylorFixed::<20> { h: 0.1 }, state);
            sim.advance_to(10.0).unwrap();
            assert!(sim.steps() == 100, "{}", sim.steps());
            sim.state()
        } else {
            let mut sim = Pendulum.taylor(Taylor::default(), state);
            sim.advance_to(10.0).unwrap();
            assert!(sim.steps() < 60, "{}", sim.steps());
            sim.state()
        };
        assert_eq!(end.t, 10.0);
        close(end.q, -1.054049155450843232884424488481, 2e-15);
        close(end.p, -0.92012764912536936006733529010043, 2e-15);
    }
}
