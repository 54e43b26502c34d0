//! Methods for pieces against their claims: energies with two pieces, with three pieces, with time, and with a flow that ends.

use crate::check::{Over, field};
use geoint_runtime::method::catalogue::{self, Visitor};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::system::Pieces;
use geoint_runtime::{Coordinates, Cotangent, Method, Real};
use geoint_tests::measure::{extrapolated, observed_order};
use geoint_tests::methods;
use geoint_tests::scalars::{Double, Dual, Scalar};
use geoint_tests::scenes::{Pulsating, Shears, Sheet};

fn end<R: Scalar, const N: usize, S: Over<R, N>, M: Method<S, R>>(system: S, method: M, x: &[R], steps: u64) -> Vec<R> {
    let point = |x: &[R]| {
        let mut array = [R::from_f64(0.0); N];
        array.copy_from_slice(x);
        <S as Cotangent<R>>::Coordinates::from_array(array)
    };
    let start = State::at(R::from_f64(0.4), point(&x[..N]), point(&x[N..]));
    let mut sim = Integrator::new(system, method, R::from_f64(DURATION / steps as f64), start);
    sim.advance(steps).expect("steps");
    let state = sim.state();
    [state.q.into_array().as_ref(), state.p.into_array().as_ref()].concat()
}

const DURATION: f64 = 1.5;

struct Orders<'a, const N: usize, S> {
    system: S,
    start: &'a [Double],
    exact: Vec<Double>,
}

impl<const N: usize, S: Over<Double, N>> Visitor<S, Double> for Orders<'_, N, S> {
    fn visit<M: Method<S, Double> + 'static>(&mut self, method: M) {
        let error = |n| {
            let found = end(self.system, method, self.start, n);
            found.iter().zip(&self.exact).map(|(a, b)| (*a - *b).magnitude()).fold(0.0, f64::max)
        };
        let claimed = f64::from(method.claims().order);
        // The digits of the table limit the error before an order is observed.
        if claimed > 8.0 {
            assert!(error(40) < 1e-13, "{}: {:.1e}", method.name(), error(40));
            return;
        }
        let order = observed_order(error);
        // Tables have the digits of `f64`.
        let floor = claimed >= 8.0;
        let good = if floor { order > claimed - 0.5 } else { (order - claimed).abs() < 0.2 };
        assert!(good, "{} has order {order:.2}", method.name());
    }
}

fn orders<const N: usize, S: Over<Double, N>>(system: S, start: &[f64], nystrom: impl Fn(&mut Orders<'_, N, S>)) {
    let start: Vec<Double> = start.iter().map(|x| Double::from(*x)).collect();
    let exact = extrapolated(
        |t, x: &[Double]| field(&system, t, x),
        Double::from(0.4),
        start.clone(),
        Double::from(DURATION),
        8,
    );
    let mut orders = Orders { system, start: &start, exact };
    methods::kinds_of_coupled(&mut orders);
    nystrom(&mut orders);
}

#[test]
fn methods_have_their_orders() {
    let real = Double::from;
    orders(Sheet { m: real(1.5), b: real(1.25) }, &[0.3, 0.1, 0.5, -0.4], |orders| catalogue::nystrom_pieces(orders));
    orders(Pulsating { m: real(1.5), b: real(1.25) }, &[0.3, 0.1, 0.5, -0.4], |_| {});
    orders(Shears { a: real(0.2) }, &[0.5, 0.3], |_| {});
}

/// Flows merged between steps, and between parts of steps, give the result of separate flows.
#[test]
fn merged_flows_are_the_same() {
    let system = Sheet { m: 1.5, b: 1.25 };
    let start = State::new([0.3, 0.1], [0.5, -0.4]);
    let mut merged = system.integrator(KahanLi8_17a.of(PieceSplitting), 0.1, start);
    let mut single = merged.clone();
    merged.advance(100).expect("steps");
    for _ in 0..100 {
        single.step().expect("a step");
    }
    let (merged, single) = (merged.state(), single.state());
    for i in 0..2 {
        assert!((merged.q[i] - single.q[i]).abs() < 1e-13 && (merged.p[i] - single.p[i]).abs() < 1e-13);
    }
}

/// The split into three pieces is used as given. A composition of their flows keeps the energy to 10⁻⁶.
#[test]
fn what_is_given_is_taken() {
    #[hamiltonian(split = "p * p / 2.0 | q * q / 2.0 | 0.1 * q.powi(4)")]
    fn duffing(q: f64, p: f64) -> f64 {
        p * p / 2.0 + q * q / 2.0 + 0.1 * q.powi(4)
    }
    assert_eq!(<Duffing as Pieces<PieceSplitting>>::PIECES.len(), 3);
    let mut sim = Duffing.integrator(Suzuki4.of(PieceSplitting), 0.05, State::new(1.0, 0.0));
    let energy = sim.energy();
    sim.advance(1000).expect("steps");
    assert!((sim.energy() / energy - 1.0).abs() < 1e-6);
}

/// A charge in a field that hardly grows.
#[hamiltonian]
fn growing(q: [f64; 2], p: [f64; 2], m: f64, b: f64, l: f64) -> f64 {
    let [x, _] = q;
    (p[0] * p[0] + (p[1] - b * (x + x * x / (2.0 * l))).powi(2)) / (2.0 * m)
}

/// Quadratic terms in the square of a sum form one piece with the other quadratic terms. The error is then as small as the remaining terms, at any step
/// size.
#[test]
fn linear_motion_is_one_piece() {
    let report = Growing::<f64>::REPORT;
    assert!(report.contains("linear motion is one piece") && report.contains("- rejected, at a cost of"), "{report}");
    let error = |l: f64| {
        let system = Growing { m: 1.5, b: 3.0, l };
        let mut sim = system.integrator(PieceSplitting, 1.7, State::new([0.0, 0.0], [1.5, 0.0]));
        sim.advance(10).expect("steps");
        // The exact solution is a circle of radius v/ω, with ω = b/m.
        let ([x, y], (sin, cos)) = (sim.state().q, 34.0_f64.sin_cos());
        (x - sin / 2.0).abs().max((y - (cos - 1.0) / 2.0).abs())
    };
    assert!(error(1e12) < 1e-10, "{:e}", error(1e12));
    assert!(error(1e6) < 1e-4 && error(1e6) > 1e-9, "{:e}", error(1e6));
}

/// A flow of one piece has no error, and the motion ends when its flow ends. It is not replaced by a sum of other pieces, which would continue beyond the
/// pole.
#[test]
fn one_piece_is_the_motion() {
    #[hamiltonian]
    fn ending(q: f64, p: f64, a: f64) -> f64 {
        a * q * p * p
    }
    // p' = −ap²: p = p₀/(1 + a p₀ t), q = q₀ (1 + a p₀ t)².
    let end = |h: f64| {
        let mut sim = Ending { a: 2.0 }.integrator(PieceSplitting, h, State::new(3.0, -0.5));
        sim.step().map(|()| sim.state())
    };
    let half = end(0.5).expect("a step");
    assert!((half.q - 0.75).abs() < 1e-15 && (half.p + 1.0).abs() < 1e-15, "{half:?}");
    let beyond = end(1.5).expect_err("p has a pole at 1");
    assert!(beyond.to_string().contains("q·p²·a"), "{beyond}");
}

/// Linear forms would add positions to momenta. The compiler forms no such sum if nothing relates their scales. Other units give the same bits.
#[test]
fn units_do_not_matter() {
    #[hamiltonian]
    fn dilating(q: f64, p: f64, a: f64, b: f64, c: f64) -> f64 {
        a * q * q * p * p + b * q * p + c / q
    }
    let run = |length: f64, mass: f64| {
        let system = Dilating { a: 0.7 / (length * length * mass), b: 0.85, c: length.powi(3) * mass };
        let mut sim = system.integrator(PieceSplitting, 0.1, State::new(0.75 * length, 0.64 * length * mass));
        sim.advance(10).expect("steps");
        (sim.state().q / length, sim.state().p / (length * mass))
    };
    assert_eq!(run(1.0, 1.0), run(2.0_f64.powi(30), 2.0_f64.powi(-100)));
}

/// An overflow, and parameters that are not numbers, are not reported as the end of a flow. This holds for flows without an end, and for flows that are
/// undefined from the start.
#[test]
fn what_is_not_finite_is_no_end() {
    let start = State::new([0.3, 0.1], [0.5, -0.4]);
    let mut sim = Growing { m: 1.0, b: f64::NAN, l: 1.0 }.integrator(PieceSplitting, 0.1, start);
    assert_eq!(sim.step(), Err(StepError::new(Failure::InvalidParameter { name: "b" }, 0.0, 0.1)));
    assert_eq!(sim.state(), start);
    let mut sim = Growing { m: 1.0, b: 1e200, l: 1e-200 }.integrator(PieceSplitting, 0.1, start);
    assert!(matches!(sim.step(), Err(StepError { failure: Failure::NonFinite, .. })), "{:?}", sim.step());
    assert_eq!(sim.state(), start);
    #[hamiltonian(split = "k * q * q * p | p * p / 2.0")]
    fn may_end(q: f64, p: f64, k: f64) -> f64 {
        k * q * q * p + p * p / 2.0
    }
    let mut sim = MayEnd { k: f64::NAN }.integrator(PieceSplitting, 0.1, State::new(2.0, 0.1));
    let named = StepError::new(Failure::InvalidParameter { name: "k" }, 0.0, 0.1);
    assert_eq!(sim.step(), Err(named));
    #[hamiltonian(split = "p * p / 2.0 - k * q * q / 2.0 | q.powi(3)")]
    fn hill(q: f64, p: f64, k: f64) -> f64 {
        p * p / 2.0 - k * q * q / 2.0 + q.powi(3)
    }
    let start = State::new(2.0, 0.1);
    assert_eq!(Hill { k: f64::NAN }.integrator(PieceSplitting, 0.1, start).step(), Err(named));
    assert_eq!(Hill { k: f64::NAN }.integrator(WisdomHolman, 0.1, start).step(), Err(named));
    let mut pieces = Hill { k: 1.0 }.integrator(PieceSplitting, 1e4, start);
    assert!(matches!(pieces.step(), Err(StepError { failure: Failure::NonFinite, .. })), "{:?}", pieces.step());
    let mut parts = Hill { k: 1.0 }.integrator(WisdomHolman, 1e4, start);
    assert!(matches!(parts.step(), Err(StepError { failure: Failure::NonFinite, .. })), "{:?}", parts.step());
}

/// After any number of turns, the error of linear flows is the rounding of the angle. If no digit of the angle is left, the step is refused.
#[test]
fn long_steps_of_linear_flows() {
    #[hamiltonian]
    fn landau(q: [f64; 2], p: [f64; 2], b: f64) -> f64 {
        (p[0] * p[0] + (p[1] - b * q[0]).powi(2)) / 2.0
    }
    #[hamiltonian(
        split = "(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + k * (q[0] * q[0] + (q[1] - q[0]).powi(2) + (q[2] - q[1]).powi(2))) / 2.0"
    )]
    fn row(q: [f64; 3], p: [f64; 3], k: f64) -> f64 {
        let springs = q[0] * q[0] + (q[1] - q[0]).powi(2) + (q[2] - q[1]).powi(2);
        (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + k * springs) / 2.0
    }
    for h in [30.0, -1e3, 1e5, 1e8] {
        let mut sim = Landau { b: 1.25 }.integrator(PieceSplitting, h, State::new([0.0, 0.0], [1.5, 0.0]));
        sim.step().expect("a step");
        // The exact solution is a circle of radius v/ω.
        let ([x, y], (sin, cos)) = (sim.state().q, (1.25 * h).sin_cos());
        let error = (x - 1.2 * sin).abs().max((y - 1.2 * (cos - 1.0)).abs());
        assert!(error < 1e-15 * h.abs(), "h = {h}: {error:e}");
        let mut row = Row { k: 1.25 }.integrator(PieceSplitting, h, State::new([0.3, -0.2, 0.4], [0.1, 0.5, -0.7]));
        let energy = row.energy();
        row.step().expect("a step");
        let error = (row.energy() / energy - 1.0).abs();
        assert!(error < 1e-15 * h.abs(), "h = {h}: {error:e}");
    }
    for h in [1e17, -1e30, 1e200] {
        let mut sim = Landau { b: 1.25 }.integrator(PieceSplitting, h, State::new([0.0, 0.0], [1.5, 0.0]));
        assert!(matches!(sim.step(), Err(StepError { failure: Failure::NonFinite, .. })), "h = {h}: {:?}", sim.state());
        let mut row = Row { k: 1.25 }.integrator(PieceSplitting, h, State::new([0.3, -0.2, 0.4], [0.1, 0.5, -0.7]));
        assert!(matches!(row.step(), Err(StepError { failure: Failure::NonFinite, .. })), "h = {h}: {:?}", row.state());
    }
}

/// Particle masses in SI units, beside a trap and a field, with more than two coupled degrees of freedom. The result agrees with natural units.
#[test]
fn small_masses_are_no_long_steps() {
    #[hamiltonian]
    fn trap(q: [f64; 3], p: [f64; 3], m: f64, b: f64, k: f64, f: f64) -> f64 {
        ((p[0] + b * q[1]).powi(2) + (p[1] - b * q[0]).powi(2) + (p[2] - b * q[1]).powi(2)) / (2.0 * m)
            + k * (q[0] - q[2]).powi(2)
            + f * q[2]
    }
    let run = |mass: f64, length: f64| {
        let system = Trap { m: 1.5 * mass, b: 0.7 * mass, k: 0.3 * mass, f: 0.2 * mass * length };
        let start = State::new([0.3, -0.2, 0.4].map(|x| x * length), [0.1, 0.5, -0.7].map(|x| x * mass * length));
        let mut sim = system.integrator(PieceSplitting, 0.7, start);
        sim.advance(10).expect("steps");
        (sim.state().q.map(|x| x / length), sim.state().p.map(|x| x / (mass * length)))
    };
    let (here, there) = (run(1.0, 1.0), run(2.0_f64.powi(-100), 2.0_f64.powi(120)));
    for i in 0..3 {
        assert!(
            (here.0[i] - there.0[i]).abs() < 1e-13 && (here.1[i] - there.1[i]).abs() < 1e-13,
            "{here:?}, {there:?}"
        );
    }
}

/// A flow that ends refuses the step, names the piece, and keeps the state.
#[test]
fn a_flow_that_ends_is_refused() {
    #[hamiltonian(split = "q * q * p | p * p / 2.0")]
    fn blowing_up(q: f64, p: f64) -> f64 {
        q * q * p + p * p / 2.0
    }
    let start = State::new(2.0, 0.1);
    let mut sim = BlowingUp.integrator(PieceSplitting, 1.5, start);
    let error = sim.step().expect_err("q' = q² ends after 1/q");
    assert!(error.to_string().contains("q²·p"), "{error}");
    assert_eq!(sim.state(), start);
}

/// Steps are symplectic, forward and backward.
#[test]
fn steps_are_symplectic_and_symmetric() {
    let real = Dual::from;
    let columns: Vec<Vec<f64>> = (0..4)
        .map(|j| {
            let mut x: Vec<Dual> = [0.3, 0.1, 0.5, -0.4].map(Dual::from).to_vec();
            x[j] = Dual::variable(x[j].value());
            let system = Pulsating { m: real(1.5), b: real(1.25) };
            end(system, BlanesMoan6X.of(PieceSplitting), &x, 7).iter().map(|x| x.derivative()).collect()
        })
        .collect();
    for (i, a) in columns.iter().enumerate() {
        for (j, b) in columns.iter().enumerate() {
            let form: f64 = (0..2).map(|k| a[k] * b[2 + k] - a[2 + k] * b[k]).sum();
            let expected = if j == i + 2 {
                1.0
            } else if i == j + 2 {
                -1.0
            } else {
                0.0
            };
            assert!((form - expected).abs() < 1e-12);
        }
    }
}
