//! Runge–Kutta methods, projected and relaxed: conditions of their order, figures of another program, several invariants.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Claims, Invariants, Method, RungeKutta};
use geoint_tests::measure::{distance, solution};
use geoint_tests::problems::*;
use geoint_tests::scalars::Double;

/// c = Σ a in every row, and Σ b c^k = 1/(k + 1) up to the order.
#[test]
fn tableaux_meet_their_conditions() {
    fn check<const K: usize>(name: &str, method: RungeKutta<K>) {
        let Claims { order, .. } = Method::<Pendulum>::claims(&method);
        let tableau = method.tableau();
        for (i, (row, c)) in tableau.a.iter().zip(tableau.c).enumerate() {
            let size: f64 = row.iter().map(|a| a.abs()).sum();
            let gap = row.iter().sum::<f64>() - c;
            assert!(gap.abs() <= 2e-16 * (1.0 + size), "{name}: row {i}, {gap:.1e}");
            assert!(row[i..].iter().all(|a| *a == 0.0), "{name} is not explicit");
        }
        for k in 0..order as i32 {
            let sum: f64 = tableau.b.iter().zip(tableau.c).map(|(b, c)| b * c.powi(k)).sum();
            let size: f64 = tableau.b.iter().map(|b| b.abs()).sum();
            let gap = sum - 1.0 / f64::from(k + 1);
            assert!(gap.abs() <= 2e-16 * size, "{name}: Σbc^{k}, {gap:.1e}");
        }
    }
    check("RK4", RK4);
    check("DOP853", DOP853);
}

/// Hénon–Heiles with unit masses, for the figures of another program.
const UNIT: HenonHeiles = HenonHeiles { m: [1.0, 1.0], lambda: 1.0 };

/// The error at `duration`, or at the time that is reached then, and the largest error of the energy.
fn errors<M: Method<HenonHeiles>>(method: M, h: f64, duration: f64, start: State<[f64; 2]>) -> (f64, f64) {
    let mut sim = UNIT.integrator(method, h, start);
    let energy = sim.energy();
    let mut off = 0.0_f64;
    while sim.time() < duration - 0.5 * h {
        sim.step().unwrap();
        off = off.max((sim.energy() - energy).abs());
    }
    let lifted = HenonHeiles { m: [1.0, 1.0].map(Double::from), lambda: 1.0.into() };
    let start = State::new(start.q.map(Double::from), start.p.map(Double::from));
    let exact = solution(&lifted, &start, sim.time().into(), 20);
    (distance(&flat(&sim.state()), &exact.iter().map(|x| x.value()).collect::<Vec<_>>()), off)
}

/// Errors computed once by another program, from an independent solution of relative accuracy 10⁻¹³.
#[test]
fn errors_of_another_program() {
    fn check<M: Method<HenonHeiles>>(
        name: &str,
        method: M,
        expected: &[(f64, f64)],
        duration: f64,
        start: [[f64; 2]; 2],
    ) {
        for (h, expected) in expected {
            let (error, off) = errors(method, *h, duration, State::new(start[0], start[1]));
            println!("{name}, h = {h}: {error:.3e}, expected {expected:.3e}; energy {off:.1e}");
            assert!((error / expected - 1.0).abs() < 0.05, "{name}, h = {h}: {error:.3e}, expected {expected:.3e}");
            let kept = Method::<HenonHeiles>::claims(&method).conserves_energy;
            assert_eq!(off < 1e-15, kept, "{name}, h = {h}: energy {off:.1e}");
        }
    }
    let near = [[0.1, -0.2], [0.3, 0.25]];
    check("RK4", RK4, &[(0.2, 3.008e-5), (0.1, 1.846e-6), (0.05, 1.141e-7)], 2.0, near);
    check("projection", Projection(RK4, Energy), &[(0.2, 2.810e-5), (0.1, 1.788e-6), (0.05, 1.123e-7)], 2.0, near);
    let far = [[0.1, 0.0], [0.0, 0.5]];
    check("RK4", RK4, &[(0.1, 4.87e-6)], 10.0, far);
    check("relaxation", Relaxation(RK4), &[(0.1, 4.99e-6), (0.05, 3.14e-7)], 10.0, far);
}

/// q × p of a body in a plane.
#[derive(Clone, Copy)]
struct AngularMomentum;

impl<R: geoint_tests::scalars::Scalar> Invariants<Kepler<R>, R> for AngularMomentum {
    type Values = R;

    fn changes(&self, _: &Kepler<R>, [q, p]: &[[R; 2]; 2], [dq, dp]: &[[R; 2]; 2]) -> R {
        let [a, b] = [0, 1].map(|i| p[i] + dp[i]);
        dq[0] * b - dq[1] * a + q[0] * dp[1] - q[1] * dp[0]
    }

    fn gradients(&self, _: &Kepler<R>, [q, p]: &[[R; 2]; 2]) -> [[R; 2]; 2] {
        [[p[1], -p[0]], [-q[1], q[0]]]
    }
}

/// A projection conserves energy and angular momentum at once. Conserving one of the two does not conserve the other.
#[test]
fn energy_and_angular_momentum_together() {
    let start = Kepler::initial::<f64>(0.0);
    let spin = |state: &State<[f64; 2]>| state.q[0] * state.p[1] - state.q[1] * state.p[0];
    let system = Kepler::system::<f64>();
    let (energy, momentum) = (system.energy(&start), spin(&start));
    fn run<M: Method<Kepler>>(method: M, h: f64) -> impl Iterator<Item = State<[f64; 2]>> {
        let mut sim = Kepler::system::<f64>().integrator(method, h, Kepler::initial(0.0));
        (0..3000).map(move |_| {
            sim.step().unwrap();
            sim.state()
        })
    }
    let off = |states: &mut dyn Iterator<Item = State<[f64; 2]>>| {
        states.fold((0.0_f64, 0.0_f64), |(h, l), state| {
            (h.max((system.energy(&state) - energy).abs()), l.max((spin(&state) - momentum).abs()))
        })
    };
    let both = off(&mut run(Projection(RK4, (Energy, AngularMomentum)), 0.04));
    let one = off(&mut run(Projection(RK4, Energy), 0.04));
    let other = off(&mut run(Projection(RK4, AngularMomentum), 0.04));
    println!("both {both:?}, energy {one:?}, angular momentum {other:?}");
    assert!(both.0 < 1e-13 && both.1 < 1e-13, "{both:?}");
    assert!(one.0 < 1e-13 && one.1 > 1e-8, "{one:?}");
    assert!(other.0 > 1e-8 && other.1 < 1e-13, "{other:?}");
    let claims = |keep: bool, claims: Claims| assert_eq!(claims.conserves_energy, keep);
    claims(true, Method::<Kepler>::claims(&Projection(RK4, (AngularMomentum, Energy))));
    claims(false, Method::<Kepler>::claims(&Projection(RK4, AngularMomentum)));
}

/// If the energy is straight along a step, no relaxation factor corrects it. The step is refused, and the state is kept.
#[test]
fn relaxation_needs_a_curved_energy() {
    let mut sim = DoublePendulum::system::<f64>().integrator(Relaxation(RK4), 0.1, DoublePendulum::initial(0.0));
    let mut last = sim.state();
    let refusal = loop {
        match sim.step() {
            Ok(()) => last = sim.state(),
            Err(refusal) => break refusal,
        }
        assert!(sim.steps() < 1000, "never refused");
    };
    assert!(matches!(refusal, StepError { failure: Failure::NotConverged { .. }, .. }), "{refusal}");
    assert_eq!(sim.state(), last);
    // Time is where the factors have led, not at a multiple of h.
    assert!(sim.steps() > 0 && (sim.time() - sim.steps() as f64 * 0.1).abs() > 1e-9, "{}", sim.time());
}

/// In single precision a step corrects hardly more than rounding, and the energy is almost straight along some steps. Other steps correct the
/// remainder. No factor may follow from rounding alone. Earlier, such factors changed the energy by a third of its terms here.
#[test]
fn what_relaxation_leaves_does_not_add_up() {
    const STEPS: u64 = 20_000;
    let system = DoublePendulum { m1: 1.3_f32, m2: 0.7, l1: 1.1, l2: 0.8, g: 1.7 };
    for angle in [0.5, 0.9, 1.3, 1.5, 1.7] {
        let mut sim = Integrator::new(system, Relaxation(RK4), 0.03_f32, State::new([angle, -0.4], [0.2, 0.1]));
        let energy = sim.energy();
        sim.advance(STEPS).unwrap();
        // Terms of ten units are rounded, and that walks at random.
        let walk = 4.0 * f32::EPSILON * 10.0 * (STEPS as f32).sqrt();
        assert!((sim.energy() - energy).abs() < walk, "from {angle}: {:e}", sim.energy() - energy);
    }
}

/// A large energy that has nothing to do with the motion.
#[hamiltonian]
fn ballast(q: f64, p: f64, m: f64, rest: f64) -> f64 {
    p * p / (2.0 * m) - q.cos() + rest
}

/// At rest, close to rest and with a large constant in the energy: differences of values would be noise there.
#[test]
fn corrections_are_not_noise() {
    fn check<M: Method<Ballast>>(name: &str, method: M) {
        let rest = State::new(0.0, 0.0);
        let mut sim = Ballast { m: 1.7, rest: 1.0 }.integrator(method, 0.1, rest);
        sim.advance(10).unwrap();
        assert_eq!((sim.state().q, sim.state().p), (0.0, 0.0), "{name}: rest");
        for (amplitude, rest) in [(1e-9, 0.0), (0.5, 1e9)] {
            let [mut with, mut without] =
                [rest, 0.0].map(|rest| Ballast { m: 1.7, rest }.integrator(method, 0.1, State::new(amplitude, 0.0)));
            let mut free = Ballast { m: 1.7, rest: 0.0 }.integrator(RK4, 0.1, State::new(amplitude, 0.0));
            with.advance(50).and(without.advance(50)).and(free.advance(50)).unwrap();
            assert_eq!(with.state(), without.state(), "{name}: a constant changes nothing");
            let gap = (with.state().q - free.state().q).abs();
            assert!(gap < 2e-5 * amplitude, "{name}: from {amplitude}, {gap:.1e}");
        }
    }
    check("projection", Projection(RK4, Energy));
    check("relaxation", Relaxation(RK4));
}
