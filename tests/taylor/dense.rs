//! States between steps, and events, with every kind of run.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Adaptive, Crossing};
use std::f64::consts::PI;

#[hamiltonian]
fn henon_heiles(q: [f64; 2], p: [f64; 2]) -> f64 {
    let [x, y] = q;
    (p[0] * p[0] + p[1] * p[1] + x * x + y * y) / 2.0 + x * x * y - y * y * y / 3.0
}

#[hamiltonian]
fn pendulum(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) - m * q.cos()
}

#[contact_hamiltonian]
fn damped_pendulum(q: f64, p: f64, s: f64) -> f64 {
    p * p / 2.6 - q.cos() + 0.1 * s
}

type Section = (usize, f64, f64, f64);

/// Sections x = 0, p_x > 0, of three orbits: number, t, y and p_y (Taylor of order 40 with 50 digits).
const SECTIONS: [([f64; 4], &[Section]); 3] = [
    (
        [0.0, 0.55, 0.2417, 0.0],
        &[
            (1, 6.22355695353420179, 0.323756531007703918, 0.125357772785123855),
            (2, 12.8198461654052485, 0.0129637035050559866, 0.0489985088545604898),
            (3, 19.2169123994635525, 0.117379500755034268, -0.102930371645817573),
            (4, 25.9581835711753213, 0.404918029731665600, -0.151901256498760686),
            (8, 51.7564747513303686, -0.0180689297932052621, -0.0596225257134262615),
            (12, 77.5314902035495306, 0.0776507218264229247, 0.0755166863699931560),
        ],
    ),
    (
        [0.0, -0.016, 0.49974, 0.0],
        &[
            (1, 6.47400118982143403, 0.209965470369610506, -0.119235882335632197),
            (2, 13.0585840113453348, 0.482391178334824782, -0.109202999682124160),
            (4, 25.5590309539735519, 0.200367172889842154, 0.115629223242462673),
        ],
    ),
    ([0.1, 0.0, 0.0, 0.5], &[(1, 3.41651196240961831, 0.529527454545363729, -0.249557371709824143)]),
];

fn start([x, y, u, v]: [f64; 4]) -> State<[f64; 2]> {
    State::new([x, y], [u, v])
}

#[test]
fn sections_of_taylor_series() {
    for (first, points) in SECTIONS {
        let mut sim = HenonHeiles.taylor(Taylor::default(), start(first));
        let crossings = sim.crossings(Direction::Up, |state| state.q[0]).until(100.0);
        let found: Vec<Crossing<State<[f64; 2]>>> = crossings.map(Result::unwrap).collect();
        for &(n, t, y, v) in points {
            let State { t: found, q, p } = found[n - 1].state;
            // Both errors grow with time. The second orbit is chaotic.
            let bar = 1e-14 * (1.0 + t / 10.0);
            assert!((found - t).abs() < 4.0 * bar, "{n}: {:e}", found - t);
            assert!(
                q[0].abs() < bar && (q[1] - y).abs() < bar && (p[1] - v).abs() < bar,
                "{n}: {:e} {:e}",
                q[1] - y,
                p[1] - v
            );
        }
    }
}

#[test]
fn sections_of_discrete_flows() {
    // The exact section of the discrete flow. Its last digits depend on the order of operations.
    let expected = [
        (1, 6.221230612225447, 0.3229065555278594, 0.1248040468106364),
        (4, 25.944105066597757, 0.4070357905555069, -0.1516265336976678),
    ];
    let mut sim = HenonHeiles.integrator(StormerVerlet, 0.1, start(SECTIONS[0].0));
    check(sim.crossings(Direction::Up, |state| state.q[0]), &expected, 1e-13);
    let expected = [
        (1, 6.223556959715499, 0.3237565441013157, 0.1253577808694073),
        (4, 25.958183676906895, 0.4049179926064063, -0.1519012609559202),
    ];
    let mut sim = HenonHeiles.integrator(BlanesMoan4, 0.1, start(SECTIONS[0].0));
    check(sim.crossings(Direction::Up, |state| state.q[0]), &expected, 1e-13);
    // The run itself continues with whole steps.
    let mut whole = HenonHeiles.integrator(BlanesMoan4, 0.1, start(SECTIONS[0].0));
    while whole.time() < sim.time() {
        whole.step().unwrap();
    }
    assert_eq!(whole.state(), sim.state());
    // An adaptive run.
    let mut sim: Adaptive<_, _> = HenonHeiles.adaptive(DOP853, 1e-13, start(SECTIONS[0].0));
    check(sim.crossings(Direction::Up, |state| state.q[0]), SECTIONS[0].1, 1e-9);
}

fn check(
    crossings: impl Iterator<Item = Result<Crossing<State<[f64; 2]>>, StepError>>,
    expected: &[(usize, f64, f64, f64)],
    bar: f64,
) {
    let found: Vec<_> = crossings.take(4).map(Result::unwrap).collect();
    for &(n, t, y, v) in expected.iter().filter(|(n, ..)| *n <= 4) {
        let State { t: found, q, p } = found[n - 1].state;
        let errors = [found - t, q[0], q[1] - y, p[1] - v];
        assert!(errors.iter().all(|error| error.abs() < bar * 5.0), "{n}: {errors:?}");
    }
}

#[test]
fn events_of_contact_systems() {
    let state = ContactState::new(1.2, 0.0, 0.0);
    let mut exact = DampedPendulum.taylor(Taylor::default(), state);
    let zeros: Vec<f64> =
        exact.crossings(Direction::Any, |state| state.q).take(6).map(|c| c.unwrap().state.t).collect();
    let mut sim = DampedPendulum.integrator(Suzuki4.of(ContactSplitting), 0.02, state);
    let found: Vec<f64> = sim.crossings(Direction::Any, |state| state.q).take(6).map(|c| c.unwrap().state.t).collect();
    for (found, exact) in found.iter().zip(&zeros) {
        assert!((found - exact).abs() < 1e-6, "{found} {exact}");
    }
}

#[test]
fn two_zeros_within_a_step() {
    // q = cos t is above 0.9999 for |t − 2π| < 0.01414…; the longest steps of the series are longer.
    #[hamiltonian]
    fn oscillator(q: f64, p: f64) -> f64 {
        (p * p + q * q) / 2.0
    }
    let mut sim = Oscillator.taylor(Taylor::default(), State::new(0.0, 1.0));
    let exact = 0.9999_f64.acos();
    let found: Vec<_> = sim.crossings(Direction::Any, |state| state.q - 0.9999).take(6).map(Result::unwrap).collect();
    for (n, crossing) in found.iter().enumerate() {
        let top = 0.5 * PI + 2.0 * PI * (n / 2) as f64;
        let expected = if n % 2 == 0 { top - exact } else { top + exact };
        assert!((crossing.state.t - expected).abs() < 2e-12, "{:e}", crossing.state.t - expected);
        assert_eq!(crossing.rises, n % 2 == 0);
    }
    assert!(sim.last_step() > 0.1);
    let mut sim = Oscillator.taylor(Taylor::default(), State::new(0.0, 1.0));
    for (n, crossing) in sim.crossings(Direction::Any, |state| state.q * state.p).take(8).enumerate() {
        let error = crossing.unwrap().state.t - 0.5 * PI * (n + 1) as f64;
        assert!(error.abs() < 5e-14, "{n}: {error:e}");
    }
    // Several functions at once, in the order of their events, and a direction.
    let mut sim = Oscillator.taylor(Taylor::default(), State::new(0.5, 1.0));
    let times: Vec<(usize, f64)> = sim
        .crossings(Direction::Down, |state| [state.q, state.p, state.q * state.p])
        .take(10)
        .map(|crossing| crossing.map(|c| (c.which, c.state.t)).unwrap())
        .collect();
    assert!(times.windows(2).all(|pair| pair[0].1 <= pair[1].1), "{times:?}");
    // In one period q and p fall once, and their product falls twice, once together with p. Rounding decides the order, so the test counts both.
    assert_eq!([0, 1, 2].map(|i| times.iter().filter(|(which, _)| *which == i).count()), [2, 3, 5]);
}

#[test]
fn backwards() {
    let state = State::new(1.0, 0.0);
    let times = |backwards: bool| -> Vec<f64> {
        let end = if backwards { -20.0 } else { 20.0 };
        let mut sim = Pendulum { m: 1.7 }.taylor(Taylor::default(), state);
        let taylor: Vec<f64> =
            sim.crossings(Direction::Any, |s| s.q).until(end).map(|c| c.unwrap().state.t.abs()).collect();
        let h = if backwards { -0.01 } else { 0.01 };
        let mut sim = Pendulum { m: 1.7 }.integrator(BlanesMoan4, h, state);
        let steps: Vec<f64> =
            sim.crossings(Direction::Any, |s| s.q).until(end).map(|c| c.unwrap().state.t.abs()).collect();
        assert_eq!(taylor.len(), steps.len());
        assert!(taylor.iter().zip(&steps).all(|(a, b)| (a - b).abs() < 1e-7));
        taylor
    };
    let (forth, back) = (times(false), times(true));
    assert!(forth.len() > 4 && forth.iter().zip(&back).all(|(a, b)| (a - b).abs() < 1e-13));
}

/// Both ends of the last step belong to the step, even if their times are rounded.
#[test]
fn ends_of_steps_are_within_them() {
    macro_rules! check {
        ($($run:expr),*) => { $({
            let mut sim = $run;
            for _ in 0..200 {
                let before = sim.state();
                sim.step().unwrap();
                let after = sim.state();
                assert_eq!([sim.at(before.t), sim.at(after.t)], [Ok(before), Ok(after)], "{}", stringify!($run));
                assert!(sim.at(before.t - 0.1 * (after.t - before.t)).is_err());
            }
        })* };
    }
    let (first, single) =
        (start([0.1, 0.0, 0.0, 0.5]), Single.taylor(Taylor { tolerance: 1e-5 }, State::new(0.3, 0.1)));
    check!(
        HenonHeiles.taylor(Taylor { tolerance: 1e-7 }, first),
        HenonHeiles.taylor(TaylorFixed::<12> { h: -0.03 }, first)
    );
    check!(HenonHeiles.taylor(Projection(TaylorFixed::<12> { h: 0.03 }, Energy), first), single);
}

/// A pendulum in single precision.
#[hamiltonian]
fn single(q: f32, p: f32) -> f32 {
    p * p / 2.0 - q.cos()
}

#[test]
fn samples_do_not_change_a_run() {
    let (system, state) = (Pendulum { m: 1.7 }, State::new(1.0, 0.0));
    let mut exact = system.taylor(Taylor::default(), state);
    let exact: Vec<State<f64>> = exact.sampled_every(0.37).take(40).map(Result::unwrap).collect();
    assert_eq!((exact[0], exact[3].t), (state, 3.0 * 0.37));
    for h in [0.05, -0.05] {
        let dt = f64::copysign(0.37, h);
        let mut sim = system.integrator(BlanesMoan4, h, state);
        let found: Vec<State<f64>> = sim.sampled_every(dt).take(40).map(Result::unwrap).collect();
        for (found, exact) in found.iter().zip(&exact) {
            assert!((found.q - exact.q).abs() < 1e-7 && found.t == exact.t.copysign(h), "{found:?} {exact:?}");
        }
        let mut whole = system.integrator(BlanesMoan4, h, state);
        (0..sim.steps()).for_each(|_| whole.step().unwrap());
        assert_eq!(whole.state(), sim.state());
    }
    let mut adaptive = system.adaptive(DOP853, 1e-12, state);
    let found: Vec<State<f64>> = adaptive.sampled_every(0.37).take(40).map(Result::unwrap).collect();
    assert!(found.iter().zip(&exact).all(|(a, b)| (a.q - b.q).abs() < 1e-10));
    let mut whole = system.adaptive(DOP853, 1e-12, state);
    whole.advance(adaptive.steps()).unwrap();
    assert_eq!(whole.state(), adaptive.state());
    // Samples at given times.
    let times = [0.0, 0.1, 0.1, 3.0, 3.0001, 14.0];
    let mut sim = system.taylor(Taylor::default(), state);
    let found: Vec<State<f64>> = sim.sampled_at(times).map(Result::unwrap).collect();
    assert_eq!(found.iter().map(|state| state.t).collect::<Vec<_>>(), times);
    let mut there = system.taylor(Taylor::default(), state);
    there.advance_to(14.0).unwrap();
    assert!((there.state().q - found[5].q).abs() < 1e-13);
    let mut errors = sim.sampled_at([15.0, 2.0, 3.0]);
    assert!(errors.next().unwrap().is_ok());
    assert!(matches!(errors.next(), Some(Err(StepError { failure: Failure::TimePassed, .. }))));
    assert!(errors.next().is_none());
    assert!(matches!(
        sim.sampled_every(0.0).next(),
        Some(Err(StepError { failure: Failure::InvalidStepSize { .. }, .. }))
    ));
    assert!(matches!(
        sim.sampled_at([f64::NAN]).next(),
        Some(Err(StepError { failure: Failure::InvalidStepSize { .. }, .. }))
    ));
}

/// A ball above the ground.
#[hamiltonian]
fn ball(q: f64, p: f64, m: f64, g: f64) -> f64 {
    p * p / (2.0 * m) + m * g * q
}

/// Reflects a ball, and returns the times of impacts.
macro_rules! bounces {
    ($sim:expr) => {{
        let mut sim = $sim;
        let mut times = vec![];
        while times.len() < 5 {
            let impact = sim
                .until_event(100.0, Direction::Down, |state| state.q)
                .unwrap()
                .unwrap_or_else(|| panic!("it falls: {times:?} {:?}", sim.state()));
            times.push(impact.state.t);
            assert_eq!(impact.state, sim.state());
            sim.set_state(State { p: -0.8 * impact.state.p, q: 0.0, ..impact.state });
        }
        times
    }};
}

#[test]
fn impacts() {
    let (system, state) = (Ball { m: 2.3, g: 9.81 }, State::new(1.0, 0.0));
    // Each flight takes 0.8 of the time of the flight before.
    let fall = (2.0 / 9.81_f64).sqrt();
    let exact: Vec<f64> = (0..5).map(|n| fall + (1..=n).map(|k| 2.0 * fall * 0.8_f64.powi(k)).sum::<f64>()).collect();
    let all = [
        bounces!(system.taylor(Taylor::default(), state)),
        bounces!(system.integrator(StormerVerlet, 0.01, state)),
        bounces!(system.integrator(Gauss::<2>, 0.01, state)),
        bounces!(system.adaptive(DOP853, 1e-12, state)),
    ];
    for times in all {
        for (found, exact) in times.iter().zip(&exact) {
            assert!((found - exact).abs() < 1e-13, "{found} {exact}");
        }
    }
    // Nothing happens.
    let mut sim = system.taylor(Taylor::default(), state);
    assert_eq!(sim.until_event(0.1, Direction::Any, |state| state.q), Ok(None));
    assert_eq!(sim.time(), 0.1);
}

#[test]
fn events_that_are_none_are_refused() {
    let (system, state) = (Ball { m: 2.3, g: 0.0 }, State::new(1.0, 0.0));
    for nan in [false, true] {
        let mut sim = system.taylor(Taylor::default(), state);
        let error = sim.crossings(Direction::Any, |state| if nan { state.q * f64::NAN } else { state.q * 0.0 }).next();
        assert!(matches!(error, Some(Err(StepError { failure: Failure::NoEvent, .. }))), "{error:?}");
        let mut sim = system.integrator(StormerVerlet, 0.1, state);
        let error = sim.crossings(Direction::Any, |state| if nan { state.q * f64::NAN } else { state.q * 0.0 }).next();
        assert!(matches!(error, Some(Err(StepError { failure: Failure::NoEvent, .. }))), "{error:?}");
    }
}

/// A function that vanishes at both ends of a step has its sign from within the step.
#[test]
fn zeros_at_both_ends_of_steps() {
    let mut sim = Pendulum { m: 1.3 }.integrator(BlanesMoan4, 1.0, State::new(1.0, 0.0));
    let g = |state: &State<f64>| (state.t - 2.0) * (state.t - 3.0) * (state.t - 4.0);
    let found: Vec<_> = sim.crossings(Direction::Any, g).until(10.0).map(|crossing| crossing.unwrap()).collect();
    let times: Vec<f64> = found.iter().map(|crossing| crossing.state.t).collect();
    assert_eq!(times, [2.0, 3.0, 4.0]);
    assert!(found[0].rises && !found[1].rises && found[2].rises);
    // The function touches zero at both ends of a step, and stays negative.
    let mut sim = Pendulum { m: 1.3 }.integrator(BlanesMoan4, 1.0, State::new(1.0, 0.0));
    let g = |state: &State<f64>| -((state.t - 2.0) * (state.t - 3.0)).powi(2);
    assert!(sim.crossings(Direction::Any, g).until(10.0).next().is_none());
}
