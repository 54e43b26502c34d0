//! Steps that would jump over a pole, or out of the domain of the energy. They are refused with a reason, even if the method evaluates a denominator of the
//! other sign. If the motion can avoid the pole, a shorter step succeeds.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Failure, Hamiltonian, Method};
use geoint_tests::grid::pairs;

/// Calls a check with every method whose equation contains the energy.
macro_rules! implicit {
    ($check:ident($($arg:expr),*)) => { implicit!(@ $check, ($($arg),*),
        DiscreteGradient, MeanValue::<2>, Gonzalez, SymmetrisedItohAbe, ItohAbePair, CoordinateIncrement::default(),
        FourthOrder(DiscreteGradient), FourthOrder(MeanValue::<2>), ImplicitMidpoint, Gauss::<3>, Suzuki4.of(ImplicitMidpoint)) };
    (@ $check:ident, $args:tt, $($method:expr),*) => { $( implicit!(@@ $check, $args, $method); )* };
    (@@ $check:ident, ($($arg:expr),*), $method:expr) => { $check(stringify!($method), $method, $($arg),*) };
}

/// Energies whose domain ends at q = 0, in the direction of the force. The expected reason names the pole or the boundary in front of which a step ends.
macro_rules! ends {
    ($($name:ident($q:ident, $p:ident) $energy:expr => $System:ident, $what:literal;)*) => {
        $( #[hamiltonian]
        fn $name($q: f64, $p: f64, m: f64) -> f64 { $p * $p / (2.0 * m) + $energy } )*

        /// From every start, with every step size, an accepted step stays on its side of the pole. It keeps the energy if the method claims so. A refused
        /// step does not change the state.
        #[test]
        fn no_step_jumps() {
            $( implicit!(falls($System { m: 1.3 }, $what)); )*
        }

        /// Adaptive steps approach the pole, and end at the last good state.
        #[test]
        fn shorter_steps_approach() {
            $( implicit!(approaches($System { m: 1.3 }, $what)); )*
        }
    };
}

ends! {
    reciprocal(q, p) -0.3 / q => Reciprocal, "a pole between the ends of the step: q";
    even_power(q, p) -0.3 / (q * q) => EvenPower, "a pole between the ends of the step: q";
    mass_of_position(q, p) p * p / (4.0 * q) + q => MassOfPosition, "a pole between the ends of the step: q";
    absolute(q, p) -0.3 / q.abs() => Absolute, "a pole between the ends of the step: abs(q)";
    rooted_square(q, p) -0.3 / (q * q).sqrt() => RootedSquare, "a pole between the ends of the step: q²";
    logarithm_of_square(q, p) 0.3 * (q * q).ln() => LogarithmOfSquare, "a pole between the ends of the step: q²";
    tangent(q, p) 0.05 * (0.25 * q + std::f64::consts::FRAC_PI_2).tan() => Tangent, "a pole between the ends of the step: cos";
    logarithm(q, p) 0.3 * q.ln() => Logarithm, "`ln` of";
    root(q, p) q.sqrt() + q => Root, "`sqrt` of";
    power(q, p) q.powf(1.3) + q => Power, "`powf` of";
    arc(q, p) -(1.0 - q).acos() + q => Arc, "`acos` of";
}

const STARTS: [(f64, f64); 6] = [(1.0, -1.0), (1.0, -3.0), (0.6, -1.0), (0.6, -8.0), (0.2, -1.0), (0.2, -3.0)];
const STEPS: [f64; 6] = [0.03, 0.1, 0.2, 0.31, 0.5, 1.3];

fn falls<S, M>(name: &str, method: M, system: S, expected: &str)
where
    S: Hamiltonian<f64, Coordinates = f64>,
    M: Method<S, f64>,
{
    let mut seen = false;
    for ((q, p), h) in pairs(&STARTS, &STEPS, 4, &format!("{expected}, {name}")) {
        let start = State::new(q, p);
        let context = || format!("{expected}, {name}: h = {h} from {start:?}");
        let mut sim = system.integrator(method, h, start);
        let energy = sim.energy();
        let (mut good, mut nearest) = (start, start.q);
        let error = loop {
            if let Err(error) = sim.step() {
                break Some(error);
            }
            good = sim.state();
            assert!(good.q > 0.0, "{}: {good:?}", context());
            let error = (sim.energy() - energy).abs() / (1.0 + energy.abs());
            // Near the pole, half a digit of q changes the energy much, and later steps keep this change.
            nearest = nearest.min(good.q);
            let rounding = 1e-10 * (1.0 + (0.1 / nearest).powi(2));
            assert!(error <= rounding || !method.claims().conserves_energy, "{}: {good:?} {error:.1e}", context());
            if sim.steps() == 40 {
                break None;
            }
        };
        assert_eq!(sim.state(), good, "{}", context());
        match error {
            Some(StepError { failure: Failure::OutsideDomain { what }, .. }) => {
                // The cause may also be the boundary itself.
                let named = expected.rsplit(": ").next().is_some_and(|term| what.ends_with(term));
                assert!(what.contains(expected) || named, "{}: {what}", context());
                seen |= what.contains(expected);
                let mut bulk = system.integrator(method, h, start);
                assert_eq!((bulk.advance(40).err(), bulk.state()), (error, good), "{}", context());
            }
            None | Some(StepError { failure: Failure::Singular | Failure::NotConverged { .. }, .. }) => {}
            Some(error) => panic!("{}: {error}", context()),
        }
    }
    assert!(seen, "{expected}, {name}: never refused for that reason");
}

fn approaches<S, M>(name: &str, method: M, system: S, expected: &str)
where
    S: Hamiltonian<f64, Coordinates = f64>,
    M: Method<S, f64>,
{
    let mut sim = system.adaptive(method, 1e-5, State::new(1.0, -3.0)).first_step(1.0).steps_between(1e-4, 1.0);
    let (energy, mut good) = (sim.energy(), sim.state());
    let failure = loop {
        match sim.step() {
            Ok(()) => good = sim.state(),
            Err(error) => {
                assert!(error.is_shortest() && error.h <= 1e-4, "{expected}, {name}: {error}");
                break error.failure;
            }
        }
        let error = (sim.energy() - energy).abs() / (1.0 + energy.abs());
        assert!(good.q > 0.0 && error < 2e-2, "{expected}, {name}: {good:?} {error:.1e}");
        assert!(sim.time() < 3.0, "{expected}, {name}: still there, {good:?}");
    };
    assert!(sim.rejections() > 0 && sim.state() == good, "{expected}, {name}");
    match failure {
        Failure::OutsideDomain { what } => assert!(what.contains(expected), "{expected}, {name}: {what}"),
        Failure::Inaccurate { .. } | Failure::Singular | Failure::NotConverged { .. } => {}
        failure => panic!("{expected}, {name}: {failure}"),
    }
}

/// Two sides of a line q·p = −1.
#[hamiltonian]
fn joint(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + 0.2 / (1.0 + q * p) + q * q
}

/// The sign of a denominator depends on both coordinates. Steps across q = 0 are regular.
#[test]
fn poles_of_both_coordinates() {
    fn check<M: Method<Joint>>(name: &str, method: M, crossed: &mut u32) {
        let side = |state: &State<f64>| 1.0 + state.q * state.p > 0.0;
        for ((q, p), h) in pairs(&STARTS, &STEPS, 3, name) {
            let start = State::new(q, p);
            let mut sim = Joint { m: 1.3 }.integrator(method, h, start);
            while sim.steps() < 20 && sim.step().is_ok() {
                *crossed += u32::from(sim.state().q < 0.0);
                assert_eq!(side(&sim.state()), side(&start), "{name}: h = {h} from {start:?}");
            }
        }
    }
    let mut crossed = 0;
    let crossed = &mut crossed;
    implicit!(check(crossed));
    assert!(*crossed > 30);
}

/// A wall that repels, as steep as a pole.
#[hamiltonian]
fn wall(q: f64, p: f64, m: f64, k: f64) -> f64 {
    p * p / (2.0 * m) + k / q
}

/// Repelling poles reflect the motion, for any length of the first step.
#[test]
fn a_pole_that_repels_is_bounced_off() {
    fn check<M: Method<Wall>>(name: &str, method: M) {
        for h in [0.1, 1.0, 10.0] {
            let mut sim = Wall { m: 1.3, k: 0.1 }.adaptive(method, 1e-6, State::new(2.0, -3.0)).first_step(h);
            let energy = sim.energy();
            let nearest = sim.until(3.0).map(|state| state.unwrap().q).fold(f64::INFINITY, f64::min);
            assert!(nearest > 0.0 && nearest < 0.1 && sim.state().p > 2.9, "{name}: {nearest}");
            assert!((sim.energy() - energy).abs() < 1e-3, "{name}");
        }
    }
    implicit!(check());
}

/// Two walls.
#[hamiltonian]
fn between_walls(q: f64, p: f64, m: f64, k: f64) -> f64 {
    p * p / (2.0 * m) - k * (1.0 - q * q).ln()
}

/// Beside a wall, the correction of Newton's iteration is small for any residual. From the state that moves away, the equation has no solution in the
/// domain. The solution that reverses p does not count.
#[test]
fn a_small_correction_at_a_wall_is_no_solution() {
    let away = State::new(0.999_999_999_980_199, -6.266_666_666_723_87);
    let system = BetweenWalls { m: 1.3, k: 0.4 };
    let refused = system.integrator(DiscreteGradient, 0.9, away).step();
    assert!(
        matches!(refused, Err(StepError { failure: Failure::OutsideDomain { .. } | Failure::NotConverged { .. }, .. })),
        "{refused:?}"
    );
    // The run in which the fault occurred.
    let mut sim = system.integrator(DiscreteGradient, 0.9, State::new(0.4, 8.0));
    sim.step().unwrap();
    let energy = sim.energy();
    while sim.steps() < 10 && sim.step().is_ok() {
        assert!((sim.energy() - energy).abs() < 1e-4, "{:?}", sim.state());
    }
}

/// An attraction with a barrier.
#[hamiltonian]
fn barrier(q: f64, p: f64, m: f64, k: f64) -> f64 {
    p * p / (2.0 * m) + k / (q * q) - 1.0 / q
}

/// If an explicit step ends near a pole, the slopes of the energy there are many times the slopes at the solution. A projection that stalls is refused,
/// even if its residual is small relative to these slopes.
#[test]
fn a_projection_that_is_stuck_is_refused() {
    fn check<M: Method<Barrier>>(method: M) {
        let (mut taken, mut refused) = (0, 0);
        for k in [0.1, -0.1] {
            for (q, p) in [(1.0, -1.0), (0.655, -1.337), (1.0, -3.0), (0.2, -8.0), (0.01, 3.0)] {
                for h in [1e-3, 0.01, 0.1, 0.3, 1.0] {
                    let system = Barrier { m: 1.3, k };
                    let terms = |x: State<f64>| x.p * x.p + (k / (x.q * x.q)).abs() + (1.0 / x.q).abs();
                    let mut sim = system.integrator(method, h, State::new(q, p));
                    while sim.steps() < 60 {
                        let (before, energy) = (sim.state(), sim.energy());
                        if sim.step().is_err() {
                            refused += 1;
                            break;
                        }
                        let error = (sim.energy() - energy).abs() / (terms(before) + terms(sim.state()));
                        assert!(error < 1e-12, "{}: {error:.1e} from {before:?} by {h}", method.name());
                        taken += 1;
                    }
                }
            }
        }
        assert!(taken > 500 && refused > 10, "{}: {taken}, {refused}", method.name());
    }
    check(Projection(RK4, Energy));
    check(Projection(StormerVerlet, Energy));
}
