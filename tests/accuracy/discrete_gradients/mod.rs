//! Methods with discrete gradients: errors, conserved quantities, behaviour at rest, and the systems that each method accepts.
//!
//! Some expected figures come from an independent program. It is not in this repository, is written in another language, and computed the figures
//! once. It forms discrete gradients from quotients of H in multiple-precision arithmetic. Its reference solutions come from an explicit solver of
//! order 8 with the relative tolerance 10⁻¹³.

/// Schemes by increments of one coordinate after another: Itoh–Abe and `CoordinateIncrement`.
mod increments;
/// Approximate Newton matrix of `FourthOrder(DiscreteGradient)`.
mod fourth_matrix;

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Failure, Hamiltonian, Method};
use geoint_tests::measure::{Noise, distance, solution};
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::*;
use geoint_tests::scalars::Double;
use std::marker::PhantomData;

/// The system of the independent program: Hénon–Heiles with unit masses.
const SYSTEM: HenonHeiles = HenonHeiles { m: [1.0, 1.0], lambda: 1.0 };

/// Returns the error |x − x(time)| of a run from `start` for each step size. The solution x(time) is extrapolated in double-double arithmetic.
fn errors<M: Method<HenonHeiles>, const N: usize>(
    method: M,
    start: State<[f64; 2]>,
    time: f64,
    steps: [f64; N],
) -> [f64; N] {
    let lifted = HenonHeiles { m: [1.0, 1.0].map(Double::from), lambda: 1.0.into() };
    let from = State::new(start.q.map(Double::from), start.p.map(Double::from));
    let exact: Vec<f64> = solution(&lifted, &from, time.into(), 20).iter().map(|x| x.value()).collect();
    steps.map(|h| {
        let mut sim = SYSTEM.integrator(method, h, start);
        distance(&flat(&sim.until(time).last().unwrap().unwrap()), &exact)
    })
}

/// Asserts that errors agree with the expected figures to 5 %.
///
/// A wrong order or a wrong leading term of the error changes the figures by more. The tolerance is too wide to tell `Gonzalez` from `MeanValue`:
/// their errors differ by 0.3 %.
fn assert_near(name: &str, observed: &[f64], expected: &[f64]) {
    println!("{name:36} {observed:?} expected {expected:?}");
    for (o, e) in observed.iter().zip(expected) {
        assert!((o / e - 1.0).abs() < 0.05, "{name}: {observed:?}, expected {expected:?}");
    }
}

/// Compares the errors of each method with the expected errors, one for each step size.
macro_rules! rows {
    ($start:expr, $time:expr, $steps:expr; $($method:expr => $expected:expr;)*) => { $({
        let observed = errors($method, $start, $time, $steps);
        assert_near(stringify!($method), &observed, &$expected);
    })* };
}

/// Errors at t = 2 agree with the figures of the independent program.
#[test]
fn errors_of_an_independent_program_after_a_short_time() {
    rows! { State::new([0.1, -0.2], [0.3, 0.25]), 2.0, [0.2, 0.1, 0.05];
        ItohAbe => [2.836e-2, 1.334e-2, 6.457e-3];
        ItohAbePair => [1.206e-3, 3.018e-4, 7.546e-5];
        SymmetrisedItohAbe => [4.747e-3, 1.194e-3, 2.990e-4];
        Gonzalez => [4.793e-3, 1.207e-3, 3.022e-4];
        MeanValue::<2> => [4.778e-3, 1.203e-3, 3.012e-4];
        FourthOrder(MeanValue::<2>) => [3.501e-5, 2.208e-6, 1.383e-7];
        FourthOrder(SymmetrisedItohAbe) => [3.421e-5, 2.158e-6, 1.352e-7];
        FourthOrder(Gonzalez) => [3.463e-5, 2.184e-6, 1.368e-7];
        Yoshida4.of(Gonzalez) => [2.638e-4, 1.731e-5, 1.095e-6];
        Suzuki4.of(Gonzalez) => [3.582e-6, 2.253e-7, 1.410e-8];
    }
}

/// Errors at t = 10 agree with the figures of the independent program.
#[test]
fn errors_of_an_independent_program_after_a_longer_time() {
    rows! { State::new([0.1, 0.0], [0.0, 0.5]), 10.0, [0.1, 0.05];
        ItohAbe => [3.306e-3, 2.036e-3];
        ItohAbePair => [7.780e-4, 1.949e-4];
        SymmetrisedItohAbe => [2.650e-3, 6.676e-4];
        MeanValue::<2> => [2.670e-3, 6.727e-4];
        FourthOrder(MeanValue::<2>) => [5.534e-6, 3.468e-7];
    }
}

/// Runs each method with random step sizes from 0.02 to 0.3. About one step in ten goes backwards. Asserts that the energy is constant to rounding
/// if the method claims to conserve the energy, and that the energy changes by more than 10⁻⁵ otherwise.
struct RandomSteps;

impl Visitor<HenonHeiles, f64> for RandomSteps {
    fn visit<M: Method<HenonHeiles> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let (system, start) = (HenonHeiles::system::<f64>(), HenonHeiles::initial::<f64>(0.0));
        let mut sim = system.integrator(method, 0.1, start);
        // Uniform in [−1, 1).
        let mut noise = Noise::new(7);
        let largest = (0..2000).fold(0.0, |largest: f64, _| {
            let h = 0.16 + 0.14 * noise.next().unwrap_or_default();
            sim.set_step_size(if noise.next() > Some(0.8) { -h } else { h });
            sim.step().unwrap();
            largest.max((sim.energy() - system.energy(&start)).abs())
        });
        println!("{name:36} {largest:.1e}");
        // Claims depend on the system. `MeanValue::<2>` claims conservation here: two Gauss points integrate polynomials of degree 3 exactly, and ∇H has
        // degree 2.
        let conserves_energy = method.claims().conserves_energy;
        assert!(if conserves_energy { largest <= 1e-14 } else { largest > 1e-5 }, "{name}: {largest:.1e}");
    }
}

/// Discrete gradients conserve the energy in a random sequence of step sizes, also negative ones.
#[test]
fn energy_is_kept_in_random_steps() {
    methods::kinds_of_discrete_gradient(&mut RandomSteps);
    methods::kinds_of_itoh_abe(&mut RandomSteps);
    methods::itoh_abe_one_way(&mut RandomSteps);
    // Controls: methods that do not conserve this energy.
    RandomSteps.visit(Kahan);
    RandomSteps.visit(ImplicitMidpoint);
}

/// Kahan's method does not conserve H of degree 3. It conserves the modified energy H(x₀) + ⅓ ∇H(x₀)·(x₁ − x₀), where x₁ is the end of the step
/// from x₀ (E. Celledoni, R. I. McLachlan, B. Owren & G. R. W. Quispel, J. Phys. A 46 (2013) 025201).
#[test]
fn kahan_keeps_a_modified_energy() {
    let (system, start) = (HenonHeiles::system::<f64>(), HenonHeiles::initial::<f64>(0.0));
    let mut sim = system.integrator(Kahan, 0.1, start);
    // Smallest and largest value of H and of the modified energy.
    let mut ranges = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for _ in 0..2000 {
        let State { q, p, .. } = sim.state();
        let mut gradient = [[0.0; 2]; 2];
        system.gradient(0.0, &[q, p], &mut gradient);
        let [dq, dp] = gradient;
        let energy = sim.energy();
        sim.step().unwrap();
        let end = sim.state();
        let change: f64 = (0..2).map(|i| dq[i] * (end.q[i] - q[i]) + dp[i] * (end.p[i] - p[i])).sum();
        for (range, value) in ranges.iter_mut().zip([energy, energy + change / 3.0]) {
            *range = [range[0].min(value), range[1].max(value)];
        }
    }
    let [energy, modified] = ranges.map(|[least, most]| most - least);
    println!("Kahan: H {energy:.1e}, modified {modified:.1e}");
    assert!(modified <= 1e-14 && energy > 1e-4, "{modified:.1e} {energy:.1e}");
}

/// A system at rest stays at rest. All increments are 0 there, so quotients of increments would be 0/0.
#[test]
fn at_rest_nothing_moves() {
    struct Rest;
    impl Visitor<HenonHeiles, f64> for Rest {
        fn visit<M: Method<HenonHeiles> + 'static>(&mut self, method: M) {
            let name = method.name().to_string();
            let rest = State::new([0.0; 2], [0.0; 2]);
            let mut sim = HenonHeiles::system::<f64>().integrator(method, 0.1, rest);
            assert_eq!(sim.advance(3), Ok(()), "{name}");
            assert_eq!((sim.state().q, sim.state().p), (rest.q, rest.p), "{name}");
        }
    }
    methods::kinds_of_discrete_gradient(&mut Rest);
    methods::kinds_of_itoh_abe(&mut Rest);
    methods::itoh_abe_one_way(&mut Rest);
    methods::coordinate_increment(&mut Rest);
}

/// On Kepler's ellipse with e = 0.6, every discrete gradient conserves the energy. Most of them change the angular momentum.
///
/// The last column of the table is the range of the largest error of the angular momentum. The narrow ranges of `ItohAbe` and `SymmetrisedItohAbe`
/// contain the figures of the independent program. The wide ranges only separate a visible change from rounding. `FourthOrder(DiscreteGradient)` conserves the angular
/// momentum to rounding.
#[test]
fn most_discrete_gradients_change_the_angular_momentum() {
    /// Largest errors of the energy and of the angular momentum in 2000 steps.
    struct Errors {
        energy: f64,
        angular_momentum: f64,
    }
    fn errors<M: Method<Kepler>>(method: M) -> Errors {
        let system = Kepler { mass: 1.0, mu: 1.0 };
        let angular_momentum = |state: &State<[f64; 2]>| state.q[0] * state.p[1] - state.q[1] * state.p[0];
        let start = State::new([0.4, 0.0], [0.0, 2.0]);
        let mut sim = system.integrator(method, 0.05, start);
        let mut largest = Errors { energy: 0.0, angular_momentum: 0.0 };
        for state in sim.sampled(1).take(2000).map(Result::unwrap) {
            largest.energy = largest.energy.max((system.energy(&state) - system.energy(&start)).abs());
            let change = angular_momentum(&state) - angular_momentum(&start);
            largest.angular_momentum = largest.angular_momentum.max(change.abs());
        }
        largest
    }
    let table = [
        ("Gonzalez", errors(Gonzalez), 1e-3..1e-2),
        ("ItohAbe", errors(ItohAbe), 2.25e-2..2.35e-2),
        ("SymmetrisedItohAbe", errors(SymmetrisedItohAbe), 3.65e-3..3.75e-3),
        ("FourthOrder(Gonzalez)", errors(FourthOrder(Gonzalez)), 1e-6..1e-3),
        ("FourthOrder(DiscreteGradient)", errors(FourthOrder(DiscreteGradient)), 0.0..1e-14),
    ];
    for (name, Errors { energy, angular_momentum }, expected) in table {
        println!("{name:32} energy {energy:.1e}, angular momentum {angular_momentum:.2e}");
        assert!(energy <= 2e-14 && expected.contains(&angular_momentum), "{name}: {energy:.1e} {angular_momentum:.2e}");
    }
}

/// A pendulum with linear damping: p' = −∂H/∂q − c ∂H/∂p.
#[hamiltonian(damping = c)]
fn honey(q: f64, p: f64, m: f64, c: f64) -> f64 {
    p * p / (2.0 * m) - m * q.cos()
}

/// `Pair::<M, S>::IS_METHOD` is true if `M: Method<S>`. The compiler decides: an inherent constant hides the constant of the trait `Otherwise`.
struct Pair<M, S>(PhantomData<(M, S)>);

/// The constant of pairs that have no inherent constant.
trait Otherwise {
    const IS_METHOD: bool = false;
}

impl<M, S> Otherwise for Pair<M, S> {}

impl<M: Method<S>, S: Hamiltonian> Pair<M, S> {
    const IS_METHOD: bool = true;
}

/// A method accepts a system only if the macro has proven the property that the method needs. A method made from another one accepts only methods
/// that it can improve.
#[test]
fn methods_are_refused_without_proof() {
    macro_rules! assert_methods {
        ($($Method:ty, $System:ty: $expected:literal;)*) => { $(
            assert_eq!(Pair::<$Method, $System>::IS_METHOD, $expected, stringify!($Method, $System));
        )* };
    }
    assert_methods! {
        // `DiscreteGradient` accepts damping: the energy falls by the dissipated energy. The other methods with discrete gradients accept only
        // systems without damping.
        DiscreteGradient, Honey: true;
        Gonzalez, Honey: false;
        ItohAbePair, Honey: false;
        FourthOrder<DiscreteGradient>, Honey: false;
        Gonzalez, Pendulum: true;
        // `FourthOrder` takes a symmetric discrete gradient of order 2. `ItohAbe` is not symmetric, `FourthOrder<Gonzalez>` has order 4 already, and
        // `ImplicitMidpoint` has no discrete gradient.
        FourthOrder<DiscreteGradient>, Pendulum: true;
        FourthOrder<MeanValue<6>>, Pendulum: true;
        FourthOrder<ItohAbe>, Pendulum: false;
        FourthOrder<FourthOrder<Gonzalez>>, Pendulum: false;
        FourthOrder<ImplicitMidpoint>, Pendulum: false;
        // `MeanValue` has tables of at most 6 Gauss points.
        MeanValue<7>, Pendulum: false;
        // Kahan's method needs a quadratic vector field, so H of degree 3.
        Kahan, HenonHeiles: true;
        Kahan, Pendulum: false;
    }
}
