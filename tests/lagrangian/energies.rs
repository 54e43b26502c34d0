//! One system as a Lagrangian and as an energy. Both forms give the same steps.

use crate::references::DOUBLE_PENDULUM;
use crate::systems::*;
use geoint_runtime::method::implicit::SolvedBy;
use geoint_runtime::method::{Visitor, catalogue};
use geoint_runtime::prelude::*;
use geoint_runtime::private::{DiscreteField, SolvedByGauss};
use geoint_tests::problems;

/// Three masses on springs that are not linear.
#[lagrangian]
fn springs(q: [f64; 3], v: [f64; 3], m: [f64; 3], k: f64) -> f64 {
    let spring = |x: f64| k * (0.5 * x * x + 0.25 * x.powi(4));
    let kinetic = 0.5 * (m[0] * v[0] * v[0] + m[1] * v[1] * v[1] + m[2] * v[2] * v[2]);
    kinetic - (spring(q[0]) + spring(q[1] - q[0]) + spring(q[2] - q[1]))
}

/// The same by hand.
#[hamiltonian]
fn springs_by_hand(q: [f64; 3], p: [f64; 3], m: [f64; 3], k: f64) -> f64 {
    let spring = |x: f64| k * (0.5 * x * x + 0.25 * x.powi(4));
    let kinetic = p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]) + p[2] * p[2] / (2.0 * m[2]);
    kinetic + spring(q[0]) + spring(q[1] - q[0]) + spring(q[2] - q[1])
}

const SPRINGS: Springs = Springs { m: [0.7, 1.3, 2.1], k: 1.9 };
const START: State<[f64; 3]> = State { t: 0.0, q: [0.5, -0.2, 0.4], p: [0.1, 0.3, -0.6] };

/// Runs both under each method.
struct SameBits(usize);

impl Visitor<Springs> for SameBits {
    fn visit<M: Method<Springs> + 'static>(&mut self, method: M) {
        let mut sim = SPRINGS.integrator(method, 0.1, START);
        // Explicit methods may leave the springs: then both do.
        let _ = sim.advance(50);
        self.0 += 1;
        ENDS.with_borrow_mut(|ends| ends.push((method.name().to_string(), sim.state())));
    }
}

impl Visitor<SpringsByHand> for SameBits {
    fn visit<M: Method<SpringsByHand> + 'static>(&mut self, method: M) {
        let mut sim = SpringsByHand { m: SPRINGS.m, k: SPRINGS.k }.integrator(method, 0.1, START);
        // Explicit methods may leave the springs: then both do.
        let _ = sim.advance(50);
        ENDS.with_borrow_mut(|ends| ends.push((method.name().to_string(), sim.state())));
    }
}

thread_local! {
    static ENDS: std::cell::RefCell<Vec<(String, State<[f64; 3]>)>> = const { std::cell::RefCell::new(vec![]) };
}

/// With a constant diagonal mass matrix both forms agree bit for bit, under every method.
#[test]
fn constant_masses_give_the_same_bits() {
    fn all<S>(visitor: &mut SameBits)
    where
        S: geoint_runtime::ForceGradient
            + geoint_runtime::Autonomous
            + DiscreteField
            + SolvedByGauss
            + SolvedBy<DiscreteGradient>,
        SameBits: Visitor<S>,
    {
        catalogue::separable::<S, f64>(visitor);
        catalogue::quadratic_kinetic::<S, f64>(visitor);
        catalogue::force_gradient::<S, f64>(visitor);
        catalogue::general::<S, f64>(visitor);
        catalogue::discrete_gradient::<S, f64>(visitor);
        catalogue::mean_gradients::<S, f64>(visitor);
        catalogue::itoh_abe::<S, f64>(visitor);
    }
    let mut visitor = SameBits(0);
    all::<Springs>(&mut visitor);
    let from_lagrangian = ENDS.take();
    all::<SpringsByHand>(&mut visitor);
    let by_hand = ENDS.take();
    assert!(from_lagrangian.len() > 60);
    assert_eq!(from_lagrangian, by_hand);
}

/// With a full mass matrix the steps agree, to rounding, with steps of the energy derived by hand.
#[test]
fn the_double_pendulum_moves_as_that_of_its_energy() -> Result<(), StepError> {
    let DoublePendulum { m, l, g } = DOUBLE_PENDULUM;
    let by_hand = problems::DoublePendulum { m1: m[0], m2: m[1], l1: l[0], l2: l[1], g };
    let start = DOUBLE_PENDULUM.at([0.0, 1.4], [0.0, 0.0]);
    macro_rules! same {
        ($($method:expr),*) => { $(
            let mut one = DOUBLE_PENDULUM.integrator($method, 0.002, start);
            let mut other = by_hand.integrator($method, 0.002, start);
            one.advance(1000)?;
            other.advance(1000)?;
            for i in 0..2 {
                assert!((one.state().q[i] - other.state().q[i]).abs() < 1e-13);
                assert!((one.state().p[i] - other.state().p[i]).abs() < 1e-13);
            }
        )* };
    }
    same!(ImplicitMidpoint, Gauss::<2>, Gauss::<3>);
    Ok(())
}

/// v → p → v, and L → H → L.
#[test]
fn velocities_and_momenta_belong_together() {
    let system = DOUBLE_PENDULUM;
    let (q, v) = ([0.3, -1.1], [0.7, 2.3]);
    let state = system.at_time(0.4, q, v);
    assert_eq!(state.t, 0.4);
    assert_eq!(state.p, system.momentum(0.4, q, v));
    let back = system.velocity(&state);
    assert!((0..2).all(|i| (back[i] - v[i]).abs() < 1e-15 * 10.0), "{back:?}");
    let action = state.p[0] * v[0] + state.p[1] * v[1];
    assert!((system.energy(&state) - (action - system.lagrangian(0.4, q, v))).abs() < 1e-14);
}
