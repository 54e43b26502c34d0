//! Events of several functions at one time: corners, and bodies that touch.

use geoint_runtime::Crossing;
use geoint_runtime::prelude::*;

/// A ball in the plane, or another body of unit mass.
#[hamiltonian]
fn ball(q: [f64; 2], p: [f64; 2], m: f64, g: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + m * g * q[1]
}

#[hamiltonian]
fn light(q: [f32; 2], p: [f32; 2], m: f32, g: f32) -> f32 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + m * g * q[1]
}

const M: f64 = 1.7;
const G: f64 = 9.81;

/// Returns a start from which the ball reaches the floor at the time `t`, and the wall by `apart` later.
fn to_the_corner(t: f64, apart: f64) -> State<[f64; 2]> {
    State::new([1.0, 0.5 * G * t * t], [-M / (t + apart), 0.0])
}

/// Reflects the coordinate that is zero.
fn reflected(hit: Crossing<State<[f64; 2]>>) -> State<[f64; 2]> {
    let State { mut q, mut p, t } = hit.state;
    (q[hit.which], p[hit.which]) = (0.0, -p[hit.which]);
    State { t, q, p }
}

/// Runs into the corner, and asserts that both walls reflect the ball once.
fn reflects<T: Dense<State = State<[f64; 2]>> + Trajectory<State = State<[f64; 2]>>>(
    mut run: T,
    what: core::fmt::Arguments<'_>,
) where
    [f64; 2]: geoint_runtime::space::Array<Real = geoint_runtime::running::Scalar<T>>,
{
    let mut hits = vec![];
    while let Some(hit) = run.until_event(geoint_runtime::Real::from_f64(1.0), Direction::Down, |x| x.q).unwrap() {
        hits.push(hit.which);
        assert!(hits.len() < 5, "{what}: {hits:?}");
        run.set_state(reflected(hit));
    }
    hits.sort();
    assert_eq!(hits, [0, 1], "{what}");
    let [x, y] = run.state().q;
    assert!(x > 0.1 && y > 0.0, "{what}: {x} {y}");
}

#[test]
fn a_corner_reflects_a_ball() {
    let ball = Ball { m: M, g: G };
    for i in 0..60 {
        let t = 0.4 + 0.003 * f64::from(i);
        for apart in [0.0, 1e-17, -1e-16, 1e-14, -1e-12, 1e-9, 1e-6, -1e-6, 1e-3] {
            let start = to_the_corner(t, apart);
            reflects(ball.integrator(StormerVerlet, 1.0 / 60.0, start), format_args!("steps, {t}, {apart:e}"));
            reflects(ball.adaptive(DOP853, 1e-10, start), format_args!("adaptive, {t}, {apart:e}"));
        }
    }
}

#[test]
fn a_corner_reflects_series() {
    for i in 0..60 {
        let t = 0.4 + 0.003 * f64::from(i);
        for apart in [0.0, 1e-17, -1e-16, 1e-14, -1e-12, 1e-9, 1e-6, 1e-3] {
            let mut run = Ball { m: M, g: G }.taylor(Taylor::default(), to_the_corner(t, apart));
            let mut hits = vec![];
            while let Some(hit) = run.until_event(1.0, Direction::Down, |x| x.q).unwrap() {
                hits.push(hit.which);
                assert!(hits.len() < 5, "{t}, {apart:e}: {hits:?}");
                run.set_state(reflected(hit));
            }
            hits.sort();
            assert_eq!(hits, [0, 1], "{t}, {apart:e}");
        }
    }
}

#[test]
fn a_corner_reflects_in_single_precision() {
    for i in 0..200_u8 {
        let t = 0.2 + 0.003 * f32::from(i);
        for apart in [0.0, 1e-8, 1e-7, -1e-6, 1e-5, 1e-4] {
            let start = State::new([1.0, 0.5 * 9.81 * t * t], [-1.7 / (t + apart), 0.0]);
            let mut run = Light { m: 1.7_f32, g: 9.81 }.integrator(StormerVerlet, 1.0 / 60.0, start);
            let mut hits = vec![];
            while let Some(hit) = run.until_event(1.0, Direction::Down, |x| x.q).unwrap() {
                hits.push(hit.which);
                let State { mut q, mut p, t } = hit.state;
                (q[hit.which], p[hit.which]) = (0.0, -p[hit.which]);
                run.set_state(State { t, q, p });
            }
            assert!(run.state().q.iter().all(|q| *q > -1e-3), "{t}, {apart:e}: {hits:?} {:?}", run.state());
        }
    }
}

/// Discs of unit mass on a line, which touch.
#[hamiltonian]
fn discs(_q: [f32; 4], p: [f32; 4]) -> f32 {
    p.iter().map(|p| p * p).sum::<f32>() / 2.0
}

/// The push of the first disc reaches the last disc, for any order of the functions.
#[test]
fn touching_discs_pass_a_push_on() {
    for gap in [0.0, 1e-7, 1e-6, 1e-5, 1e-4, 1e-2_f32] {
        for (first, second, third) in [([0, 1], [1, 2], [2, 3]), ([2, 3], [1, 2], [0, 1]), ([1, 2], [0, 1], [2, 3])] {
            let pairs: [[usize; 2]; 3] = [first, second, third];
            let start = State::new([0.0, 1.0, 1.2 + gap, 1.4 + 2.0 * gap], [1.0, 0.0, 0.0, 0.0]);
            let mut run = Discs.integrator(StormerVerlet, 1.0 / 60.0, start);
            let mut hits = 0;
            while let Some(hit) =
                run.until_event(3.0, Direction::Down, |x| pairs.map(|[i, j]| x.q[j] - x.q[i] - 0.2)).unwrap()
            {
                hits += 1;
                let [i, j] = pairs[hit.which];
                let State { mut p, .. } = hit.state;
                p.swap(i, j);
                run.set_state(State { p, ..hit.state });
            }
            assert_eq!((hits, run.state().p), (3, [0.0, 0.0, 0.0, 1.0]), "{gap:e}, {pairs:?}");
        }
    }
}

/// The orbit crosses two sections at once. A kick that keeps the direction of the motion does not repeat their events.
#[test]
fn a_kick_at_an_event_does_not_repeat_it() {
    let mut run = Ball { m: M, g: 0.0 }.integrator(StormerVerlet, 0.1, State::new([1.0, 1.0], [-1.0, -1.0]));
    let mut hits = vec![];
    while let Some(hit) = run.until_event(5.0, Direction::Down, |x| x.q).unwrap() {
        hits.push(hit.which);
        assert!(hits.len() < 5, "{hits:?}");
        run.set_state(State { p: hit.state.p.map(|p| 1.1 * p), ..hit.state });
    }
    hits.sort();
    assert_eq!(hits, [0, 1]);
    // A new search that starts at a zero does not report it.
    let mut run = Ball { m: M, g: G }.integrator(StormerVerlet, 0.1, State::new([1.0, 0.0], [0.0, 0.0]));
    assert_eq!(run.until_event(1.0, Direction::Down, |x| x.q), Ok(None));
}

/// A run saved between two simultaneous events continues with the second event.
#[test]
fn saved_runs_know_their_events() {
    use geoint_runtime::running::Resumable;
    let (ball, start) = (Ball { m: M, g: G }, to_the_corner(0.5, 0.0));
    let mut run = ball.integrator(StormerVerlet, 1.0 / 60.0, start);
    let hit = run.until_event(1.0, Direction::Down, |x| x.q).unwrap().unwrap();
    run.set_state(reflected(hit));
    let mut resumed = ball.integrator(StormerVerlet, 1.0 / 60.0, start);
    resumed.resume(&run.saved()).unwrap();
    let [a, b] = [&mut run, &mut resumed].map(|run| run.until_event(1.0, Direction::Down, |x| x.q).unwrap());
    assert_eq!(a, b);
    assert_eq!(a.unwrap().which, 1 - hit.which);
}
