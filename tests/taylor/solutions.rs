//! Coefficients and solutions against 45 digits (Taylor of order 60, or Kepler's equation).

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::{Jets, TaylorMethod};
use geoint_runtime::space::PerCoordinate;

#[hamiltonian]
fn pendulum(q: f64, p: f64) -> f64 {
    p * p / 2.0 - q.cos()
}

#[hamiltonian]
fn kepler(q: [f64; 2], p: [f64; 2]) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// Returns the coefficients of orders 1 to 32.
fn jet<S: Jets>(system: &S, z: S::Phase, s: S::Action) -> [PerCoordinate<S::Phase, S::Action>; 32] {
    let mut jet = [PerCoordinate { z, s }; 32];
    let mut switches = [<S::Switches as geoint_runtime::space::Array>::zero(); 32];
    system.jet(1.0, 0.0, &z, &s, &mut jet, &mut switches);
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

fn start(e: f64) -> State<[f64; 2]> {
    State::new([1.0 - e, 0.0], [0.0, ((1.0 + e) / (1.0 - e)).sqrt()])
}

#[test]
fn kepler_by_its_equation() {
    for (t, x, y) in [
        (1.0, -0.628948176826624172142970897253, 0.79966473097003942942171406499709),
        (10.0, -1.5350235919098151620369567125936, -0.28366840649977890685897029527584),
    ] {
        let mut sim = Kepler.taylor(Taylor::default(), State::new([1.0 - 0.6, 0.0], [0.0, 2.0]));
        sim.advance_to(t).unwrap();
        close(sim.state().q[0], x, 4e-15);
        close(sim.state().q[1], y, 1e-14);
    }
}

/// Rounding alone makes the energy error grow like √n in n steps. A truncation error would make it drift. The error would be ten times as large for an
/// internal tolerance that is not 64 times below the accuracy of the scalar.
#[test]
fn a_thousand_periods_of_kepler() {
    let mut sim = Kepler.taylor(Taylor::default(), State::new([1.0 - 0.6, 0.0], [0.0, 2.0]));
    let energy = sim.energy();
    let mut worst = 0.0_f64;
    while sim.time() < 1e3 * 2.0 * std::f64::consts::PI {
        sim.advance(50).unwrap();
        worst = worst.max((sim.energy() / energy - 1.0).abs());
    }
    assert!(worst <= 3e-14, "{worst:.1e}");
}

#[test]
fn a_tolerance_that_is_ten_times_larger_gives_larger_errors() {
    let error = |tolerance: f64| {
        let mut sim = Kepler.taylor(TaylorOrder::<16> { tolerance }, start(0.6));
        sim.advance_to(10.0).unwrap();
        (sim.state().q[0] + 1.5350235919098151620369567125936).abs()
    };
    let (coarse, fine) = (error(1e-6), error(1e-10));
    assert!(fine < 1e-9 && coarse > 10.0 * fine && coarse < 1e-3, "{coarse:.1e} {fine:.1e}");
}

/// Three bodies of mass 1 on one curve. A. Chenciner & R. Montgomery, Ann. Math. 152 (2000) 881.
#[hamiltonian]
fn three_bodies(q: [[f64; 2]; 3], p: [[f64; 2]; 3]) -> f64 {
    let mut energy = 0.0;
    for i in 0..3 {
        energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / 2.0;
        for j in 0..i {
            let (x, y) = (q[i][0] - q[j][0], q[i][1] - q[j][1]);
            energy -= 1.0 / (x * x + y * y).sqrt();
        }
    }
    energy
}

fn figure_eight() -> State<[[f64; 2]; 3]> {
    let (x, y) = (0.97000436, -0.24308753);
    let (u, v) = (0.93240737, 0.86473146);
    State::new([[x, y], [-x, -y], [0.0, 0.0]], [[u / 2.0, v / 2.0], [u / 2.0, v / 2.0], [-u, -v]])
}

/// Returns the distance from its start after 100 periods forth and back. The distance of neighbouring orbits grows 1400 times on the way.
fn forth_and_back(method: impl TaylorMethod<ThreeBodies>) -> f64 {
    let (start, mut sim) = (figure_eight(), ThreeBodies.taylor(method, figure_eight()));
    sim.advance_to(632.6).unwrap();
    let there = sim.steps();
    sim.advance_to(0.0).unwrap();
    assert!(sim.steps() > there + 1000);
    assert_eq!(sim.time(), 0.0);
    let end = sim.state();
    let moved = |end: [[f64; 2]; 3], start: [[f64; 2]; 3]| {
        end.as_flattened().iter().zip(start.as_flattened()).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
    };
    moved(end.q, start.q).max(moved(end.p, start.p))
}

/// The remaining distance is rounding. At order 20 it is 0.3 to 5·10⁻¹², depending on start and processor. Lower orders have shorter steps, and leave less.
/// At order 12 it is 1.1 to 1.3·10⁻¹² from this start if the rounding error of the product of h and the rates is dropped.
#[test]
fn a_figure_eight_forth_and_back() {
    let distance = forth_and_back(Taylor::default());
    assert!(distance < 5e-12, "{distance:.1e}");
    let distance = forth_and_back(TaylorOrder::<12>::default());
    assert!(distance < 1e-12, "{distance:.1e}");
}

#[test]
fn what_is_between_the_ends_of_a_step() {
    let mut sim = Pendulum.taylor(Taylor::default(), State::new(1.5, 0.0));
    assert_eq!(sim.at(0.0), Ok(State::new(1.5, 0.0)));
    assert!(sim.at(0.01).is_err());
    sim.step().unwrap();
    let h = sim.last_step();
    for t in [-1e-9, h + 1e-9, f64::NAN] {
        let error = sim.at(t).unwrap_err();
        assert_eq!(error.failure, Failure::NotInLastStep { from: 0.0, to: h });
        assert!(error.to_string().contains(&format!("from 0 to {h}")), "{error}");
    }
    assert_eq!(sim.at(0.0), Ok(State::new(1.5, 0.0)));
    assert_eq!(sim.at(sim.time()), Ok(sim.state()));
    for part in [0.1, 0.5, 0.9] {
        let inside = sim.at(part * h).unwrap();
        let mut there = Pendulum.taylor(Taylor::default(), State::new(1.5, 0.0));
        there.advance_to(part * h).unwrap();
        assert!((inside.q - there.state().q).abs() < 4e-16 && (inside.p - there.state().p).abs() < 4e-16);
    }
    // A run backwards.
    sim.advance_to(-1.0).unwrap();
    let before = sim.at(sim.time() + 0.01).unwrap();
    assert!(before.t > sim.time() && before.q > sim.state().q && sim.at(sim.time() - 0.01).is_err());
}

/// Lower orders, selected by loose tolerances, are as accurate as the highest order.
#[test]
fn the_order_follows_from_the_tolerance() {
    let start = figure_eight();
    let coarse = [(1e-3, 8), (1e-4, 8), (9e-5, 10), (1e-6, 10), (9e-7, 12), (1e-8, 12)];
    let fine = [(9e-9, 16), (1e-13, 16), (9e-14, 20), (1e-15, 20)];
    for (tolerance, order) in coarse.into_iter().chain(fine) {
        let mut sim = ThreeBodies.taylor(Taylor { tolerance }, start);
        assert_eq!(sim.order(), order, "{tolerance:e}");
        assert_eq!(Pendulum.taylor(Taylor { tolerance }, State::new(1.5, 0.0)).order(), order);
        let mut finer = ThreeBodies.taylor(TaylorOrder::<20>::default(), start);
        sim.advance_to(2.0).unwrap();
        finer.advance_to(2.0).unwrap();
        let (found, expected) = (sim.state(), finer.state());
        for i in 0..3 {
            for k in 0..2 {
                let error = (found.q[i][k] - expected.q[i][k]).abs();
                // The error of a step is a 64th of the tolerance, plus a few roundings.
                assert!(error <= tolerance + 1e-14, "{tolerance:e}: {error:.1e}");
            }
        }
    }
}
