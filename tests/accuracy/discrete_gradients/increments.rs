//! Increments of coordinates: Itoh and Abe.

use super::*;

/// A saddle that is not separable, and grows as exp(√2 t).
#[hamiltonian]
fn saddle(q: f64, p: f64) -> f64 {
    q * p + p * p / 2.0 - q * q / 2.0
}

/// Runs three schemes on the saddle up to t = 2. The scheme of coordinate increments keeps the energy. A misprinted variant forgets a term in the
/// equation for q, and its energy error exceeds 3. Without its h² terms only explicit Euler is left. The figures of the last two come from another
/// program.
#[test]
fn coordinate_increments_keep_the_energy_of_a_saddle() {
    const START: (f64, f64) = (1.0, 0.5);
    let error = |(q, p): (f64, f64)| (saddle(q, p) - saddle(START.0, START.1)).abs();
    let largest = |h: f64, step: &mut dyn FnMut((f64, f64)) -> (f64, f64)| {
        let mut x = START;
        (0..(2.0 / h).round() as usize).fold(0.0, |largest: f64, _| {
            x = step(x);
            largest.max(error(x))
        })
    };
    for (h, forgotten, explicit) in [(0.1, 3.40, 4.2e-2), (0.05, 3.27, 2.3e-2), (0.01, 3.16, 4.9e-3)] {
        let mut sim = Saddle.integrator(CoordinateIncrement::default(), h, State::new(START.0, START.1));
        let kept = largest(h, &mut |(q, p)| {
            sim.step().unwrap();
            let State { q: q1, p: p1, .. } = sim.state();
            // (1 − h)q₁ − h/2 p₁ = q + h/2 p, −h/2 q₁ + p₁ = (1 − h)p + h/2 q.
            let (a, b) = (q + 0.5 * h * p, (1.0 - h) * p + 0.5 * h * q);
            let determinant = 1.0 - h - 0.25 * h * h;
            let expected = ((a + 0.5 * h * b) / determinant, ((1.0 - h) * b + 0.5 * h * a) / determinant);
            assert!((q1 - expected.0).abs().max((p1 - expected.1).abs()) <= 1e-14 * q1.abs());
            (q1, p1)
        });
        let loses = |(q, p): (f64, f64)| {
            // q₁ = q + h/2 (p₁ + p), p₁ = p − hp + h/2 (q₁ + q).
            let q1 = (q + 0.5 * h * ((2.0 - h) * p + 0.5 * h * q)) / (1.0 - 0.25 * h * h);
            (q1, p - h * p + 0.5 * h * (q1 + q))
        };
        let observed = [largest(h, &mut { loses }), largest(h, &mut |(q, p)| (q + h * (q + p), p - h * (p - q)))];
        println!("h = {h}: {kept:.1e} {observed:?}");
        // |x|² grows to 400.
        assert!(kept <= 4e-13, "h = {h}: {kept:.1e}");
        assert!((observed[0] / forgotten - 1.0).abs() < 0.01 && (observed[1] / explicit - 1.0).abs() < 0.05);
    }
}

/// The adjoint goes back.
#[test]
fn itoh_abe_has_an_adjoint() {
    let start = DoublePendulum::initial::<f64>(0.0);
    let mut there = DoublePendulum::system::<f64>().integrator(ItohAbe, 0.1, start);
    there.step().unwrap();
    let gap = |method_gap: State<[f64; 2]>| distance(&flat(&method_gap), &flat(&start));
    let mut back = there.system().integrator(ItohAbeAdjoint, -0.1, there.state());
    let mut again = there.system().integrator(ItohAbe, -0.1, there.state());
    back.step().unwrap();
    again.step().unwrap();
    assert!(gap(back.state()) <= 1e-15, "{:.1e}", gap(back.state()));
    assert!(gap(again.state()) > 1e-3);
}

/// A throw.
#[hamiltonian]
fn throw(q: [f64; 2], p: [f64; 2], m: f64, g: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + m * g * q[1]
}

/// Two degrees of freedom. A step keeps the energy if it exists. Otherwise the error gives the reason.
#[test]
fn coordinate_increments_in_the_plane() {
    // On the way up, where force and velocity are not orthogonal.
    let (system, start) = (HenonHeiles::system::<f64>(), State::new([0.3, 0.2], [0.35, 0.25]));
    for method in
        [CoordinateIncrement::default(), CoordinateIncrement { alpha: 0.2, beta: 0.9, gamma: 1.0, delta: 0.3 }]
    {
        let mut sim = system.integrator(method, 0.02, start);
        sim.advance(10).unwrap();
        let error = (sim.energy() - system.energy(&start)).abs();
        assert!(error <= 1e-15, "{method:?}: {error:.1e}");
    }

    // At the top of its path the step is level, and the force upright: H does not change along its direction.
    let (m, g, h) = (1.5, 2.0, 0.125);
    let top = State::new([0.0, 1.0], [1.0, 0.5 * h * m * g]);
    let mut sim = Throw { m, g }.integrator(CoordinateIncrement::default(), h, top);
    assert_eq!(sim.step(), Err(StepError::new(Failure::SingularDirection, 0.0, h)));
    assert_eq!(sim.state(), top);
    // Shorter steps are not level, if shorter ones are allowed.
    let adaptive = Throw { m, g }.adaptive(CoordinateIncrement::default(), 1e-2, top).first_step(h);
    let mut sim = adaptive.clone().steps_between(h, h);
    let error = sim.step().unwrap_err();
    assert_eq!((error.t, error.h, error.failure, error.is_shortest()), (0.0, h, Failure::SingularDirection, true));
    assert_eq!(sim.state(), top);
    let mut sim = adaptive;
    assert_eq!(sim.step(), Ok(()));
    assert!(sim.rejections() > 0 && sim.time() < h);
    let mut sim = Throw { m, g }.integrator(Gonzalez, h, top);
    assert_eq!(sim.step(), Ok(()));
}

/// The order is 2 if H is separable and both directions are at midpoints. With one degree of freedom the directions cancel.
#[test]
fn coordinate_increments_have_order_2_at_midpoints() {
    fn check(name: &str, expected: f64, errors: [f64; 3]) {
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            println!("{name}: order {order:.3}");
            assert!((order - expected).abs() < 0.05, "{name}: {order:.3}, expected {expected}");
        }
    }
    let with = |alpha, beta, gamma, delta| CoordinateIncrement { alpha, beta, gamma, delta };
    // Precondition: force and velocity are not orthogonal.
    let plane = |method| errors(method, State::new([0.3, 0.2], [0.35, 0.25]), 0.2, [0.02, 0.01, 0.005]);
    check("midpoints", 2.0, plane(CoordinateIncrement::default()));
    check("α, δ elsewhere", 2.0, plane(with(0.2, 0.5, 0.5, 0.9)));
    check("β elsewhere", 1.0, plane(with(0.5, 1.0, 0.5, 0.5)));
    check("γ elsewhere", 1.0, plane(with(0.5, 0.5, 0.0, 0.5)));

    let line = |end: &dyn Fn(f64) -> Vec<f64>, exact: &[f64]| [0.02, 0.01, 0.005].map(|h| distance(&end(h), exact));
    let start = (0.7, 0.4);
    let pendulum = Pendulum::system::<f64>();
    let lifted = State::new(Double::from(start.0), Double::from(start.1));
    let exact = solution(&Pendulum::system::<Double>(), &lifted, 1.0.into(), 20);
    let exact: Vec<f64> = exact.iter().map(|x| x.value()).collect();
    let swing = |h| {
        let mut sim = pendulum.integrator(with(0.1, 0.9, 0.0, 0.3), h, State::new(start.0, start.1));
        flat(&sim.until(1.0).last().unwrap().unwrap())
    };
    check("one degree of freedom", 2.0, line(&swing, &exact));
    // cosh √2 and sinh √2 of the saddle's matrix, whose square is 2.
    let root = 2.0_f64.sqrt();
    let (q, p) = start;
    let (cosh, sinh) = (root.cosh(), root.sinh() / root);
    let exact = [cosh * q + sinh * (q + p), cosh * p + sinh * (q - p)];
    let leave = |h| {
        let mut sim = Saddle.integrator(CoordinateIncrement::default(), h, State::new(start.0, start.1));
        flat(&sim.until(1.0).last().unwrap().unwrap())
    };
    check("not separable", 1.0, line(&leave, &exact));
}
