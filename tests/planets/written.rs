//! Different notations of an attraction give the same motion.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// Two bodies with a potential of their distance r, and the rest that Kepler's motion leaves of the potential.
macro_rules! two_bodies {
    ($($System:ident: $rest:literal, |$r:ident, $k:ident, $a:ident| $potential:expr;)*) => { $({
        #[hamiltonian(name = $System, coordinates = jacobi)]
        fn energy(q: [[f64; 2]; 2], p: [[f64; 2]; 2], m: [f64; 2], $k: f64, $a: f64) -> f64 {
            let $r = (q[1][0] - q[0][0]).hypot(q[1][1] - q[0][1]);
            (p[0][0].powi(2) + p[0][1].powi(2)) / (2.0 * m[0]) + (p[1][0].powi(2) + p[1][1].powi(2)) / (2.0 * m[1]) + $potential
        }
        let rest = $System::<f64>::REPORT.lines().find(|line| line.starts_with("- B = "));
        assert_eq!(rest, Some(concat!("- B = ", $rest)), stringify!($System));
        let system = $System { m: [1.5, 0.5], $k: 1.25, $a: 0.05 };
        let start = State::new([[0.1, -0.2], [1.0, 0.1]], [[0.05, -0.6], [-0.1, 0.65]]);
        let mut sim = system.integrator(Aba10_6_4, 0.01, start);
        sim.advance(100).expect("no collision");
        let mut exact = system.integrator(Gauss::<4>, 0.001, start);
        exact.advance(1000).expect("no collision");
        for i in 0..2 {
            for d in 0..2 {
                let error = (sim.state().q[i][d] - exact.state().q[i][d]).abs();
                assert!(error < 1e-12, "{}, q[{i}][{d}]: {error:e}", stringify!($System));
            }
        }
    })* };
}

#[test]
fn attraction_in_any_words() {
    two_bodies! {
        Coulomb: "0", |r, k, a| -k / (4.0 * std::f64::consts::PI * a * r);
        Reciprocal: "0", |r, k, a| -(k * a) * r.recip();
        Root: "0", |r, k, a| -k * a / (r * r).sqrt();
        Factored: "-k·a/hypot(q[1][0], q[1][1])²", |r, k, a| -k / r * (1.0 + a / r);
        Divided: "-a/hypot(q[1][0], q[1][1])²", |r, k, a| -(k + a / r) / r;
        Yukawa: "-k·a·exp(-hypot(q[1][0], q[1][1]))/hypot(q[1][0], q[1][1])", |r, k, a| -k * (1.0 + a * (-r).exp()) / r;
    }
}

/// Charges on a line. Charges that attract each other collide.
#[test]
fn bodies_on_a_line() {
    #[hamiltonian(coordinates = jacobi)]
    fn charges(q: [[f64; 1]; 3], p: [[f64; 1]; 3], m: [f64; 3], e: [f64; 3]) -> f64 {
        let mut energy = 0.0;
        for i in 0..3 {
            energy += p[i][0] * p[i][0] / (2.0 * m[i]);
            for j in 0..i {
                energy += e[i] * e[j] / (q[i][0] - q[j][0]).abs();
            }
        }
        energy
    }
    let start = State::new([[0.1], [1.0], [-2.0]], [[0.2], [-0.3], [0.1]]);
    let system = Charges { m: [2.0, 1.0, 0.5], e: [1.0, 0.5, 0.25] };
    let mut sim = system.integrator(Aba10_6_4, 0.02, start);
    sim.advance(100).expect("no collision");
    let mut exact = system.integrator(Gauss::<4>, 0.005, start);
    exact.advance(400).expect("no collision");
    for i in 0..3 {
        let error = (sim.state().q[i][0] - exact.state().q[i][0]).abs();
        assert!(error < 1e-11, "q[{i}]: {error:e}");
    }
    let mut falling = Charges { e: [1.0, -0.5, 1e-9], ..system }.integrator(WisdomHolman, 0.02, start);
    let end = falling.advance(1000).expect_err("a collision");
    assert!(matches!(end, StepError { failure: Failure::Pole { piece: "Kepler's motion of q[1]" }, .. }), "{end}");
}
