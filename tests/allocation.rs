//! Steps allocate nothing, with any method. This test is a program of its own, because it owns the allocator.

use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::counting::{Counting, allocations_during};
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::*;
use std::hint::black_box;
use std::marker::PhantomData;

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Uses every operation of an integrator, including an error.
struct Steps<P>(usize, PhantomData<P>);

impl<P: Problem> Visitor<P::Over<f64>, f64> for Steps<P> {
    fn visit<M: Method<P::Over<f64>, f64> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        self.0 += 1;
        let count = allocations_during(|| {
            let mut sim = P::system::<f64>().integrator(method, 0.01, P::initial(0.0));
            sim.step().unwrap();
            sim.advance(20).unwrap();
            sim.set_step_size(0.02);
            black_box(sim.until(1.0).filter(Result::is_ok).count());
            black_box(sim.sampled(2).take(3).filter(Result::is_ok).count());
            black_box((sim.energy(), sim.state()));
            sim.set_step_size(f64::NAN);
            assert!(sim.step().is_err());
            sim.set_step_size(1e200);
            black_box(sim.step().is_err());

            let mut sim = P::system::<f64>().adaptive(method, 1e-3, P::initial(0.0)).first_step(30.0);
            sim.step().unwrap();
            assert!(sim.rejections() > 0, "{name}");
            black_box(sim.until(0.3).filter(Result::is_ok).count());
            assert!(sim.steps_between(10.0, 10.0).step().is_err());
        });
        assert_eq!(count, 0, "{} with {name}", P::NAME);
    }
}

/// Two masses under damping that depends on time; two pieces.
#[contact_hamiltonian]
fn damped(q: [f64; 2], p: [f64; 2], s: f64, t: f64, m: [f64; 2], g: f64) -> f64 {
    let kinetic = p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]);
    kinetic - (q[0] - q[1]).cos() + q[1].powi(4) + g * (1.0 + t.sin()) * s
}

fn contact_steps<M: Method<Damped>>(name: &str, method: M) {
    let count = allocations_during(|| {
        let start = ContactState::new([0.3, -0.2], [0.5, 0.1], 0.4);
        let mut sim = Damped { m: [1.3, 0.7], g: 0.1 }.integrator(method, 0.01, start);
        sim.step().unwrap();
        sim.advance(20).unwrap();
        sim.set_step_size(0.02);
        black_box(sim.until(1.0).filter(Result::is_ok).count());
        black_box((sim.energy(), sim.state()));
        sim.set_step_size(1e200);
        assert!(sim.advance(3).is_err(), "{name}");
    });
    assert_eq!(count, 0, "damped with {name}");
}

/// Three angles of an arm, solved for their velocities.
#[lagrangian]
fn arm(q: [f64; 3], v: [f64; 3], m: f64) -> f64 {
    let coupled = v[0] * v[1] * (q[0] - q[1]).cos() + v[1] * v[2] * (q[1] - q[2]).cos();
    m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + coupled) + q[0].cos() + q[2].cos()
}

#[test]
fn steps_of_velocities_allocate_nothing() {
    let system = Arm { m: 0.7 };
    macro_rules! none {
        ($($method:expr),*) => { $(
            let mut sim = system.integrator($method, 0.05, system.at([0.3, -0.2, 0.5], [0.1, 0.0, -0.4]));
            let count = allocations_during(|| {
                sim.advance(100).expect("steps");
                sim.step().expect("a step");
                assert!(sim.velocity()[0].is_finite() && sim.energy().is_finite());
            });
            assert_eq!(count, 0);
        )* };
    }
    none!(
        ImplicitMidpoint,
        Gauss::<2>,
        Gauss::<3>,
        DiscreteGradient,
        RK4,
        Suzuki4.of(DiscreteGradient),
        Projection(RK4, Energy)
    );
}

/// The same with friction by an action that acts back, and of an energy that is made of L.
#[lagrangian]
fn fading_arm(q: [f64; 3], v: [f64; 3], s: f64, m: f64) -> f64 {
    let coupled = v[0] * v[1] * (q[0] - q[1]).cos() + v[1] * v[2] * (q[1] - q[2]).cos();
    m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + coupled) + q[0].cos() + q[2].cos() - 0.2 * s - s * s / 30.0
}

#[lagrangian]
fn fading_pendulum(q: [f64; 2], v: [f64; 2], s: f64, m: f64) -> f64 {
    m * (v[0] * v[0] + v[1] * v[1] + v[0] * v[1] * (q[0] - q[1]).cos()) + q[0].cos() - 0.2 * s
}

/// ϑ(q)·v − H.
#[lagrangian]
fn prey(q: [f64; 2], v: [f64; 2], a: f64) -> f64 {
    q[1].ln() / q[0] * v[0] + a * (q[0] + q[1]) - q[0].ln() - q[1].ln()
}

#[test]
fn steps_of_lagrangians_allocate_nothing() {
    macro_rules! none {
        ($system:expr, $start:expr; $($method:expr),*) => { $(
            let mut sim = $system.integrator($method, 0.05, $start);
            let count = allocations_during(|| {
                sim.advance(100).expect("steps");
                sim.step().expect("a step");
                black_box((sim.energy(), sim.state()));
                sim.set_step_size(1e200);
                black_box(sim.advance(3).is_err());
            });
            assert_eq!(count, 0);
        )* };
    }
    let arm = FadingArm { m: 0.7 };
    none!(arm, arm.at([0.3, -0.2, 0.5], [0.1, 0.0, -0.4], 0.1);
        ContactMidpoint, ContactGauss::<2>, ContactGauss::<3>, ContactDiscreteGradient, Suzuki4.of(ContactMidpoint));
    let pendulum = FadingPendulum { m: 0.7 };
    none!(pendulum, pendulum.at([0.3, -0.2], [0.1, 0.0], 0.1);
        ContactMidpoint, ContactGauss::<2>, ContactDiscreteGradient);
    let prey = Prey { a: 0.7 };
    none!(prey, prey.at([1.0, 1.5]); ImplicitMidpoint, Gauss::<2>, DiscreteGradient);
}

/// A rod with a mass at each end that slides along two walls.
#[hamiltonian(constraint = [((q[0] - q[2]).powi(2) + (q[1] - q[3]).powi(2) - l * l) / 2.0, q[0], q[3]])]
fn ladder(q: [f64; 4], p: [f64; 4], m: [f64; 2], l: f64, g: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m[0])
        + (p[2] * p[2] + p[3] * p[3]) / (2.0 * m[1])
        + g * (m[0] * q[1] + m[1] * q[3])
}

#[test]
fn steps_with_constraints_allocate_nothing() {
    struct Steps(usize);
    impl Visitor<Ladder> for Steps {
        fn visit<M: Method<Ladder> + 'static>(&mut self, method: M) {
            self.0 += 1;
            let name = method.name().to_string();
            let system = Ladder { m: [1.3, 0.7], l: 1.0, g: 9.81 };
            let count = allocations_during(|| {
                let start = State::new([0.0, 0.8, 0.6, 0.0], [0.0; 4]);
                let mut sim = Integrator::new(system, method, 0.001, start);
                sim.advance(100).unwrap();
                sim.step().unwrap();
                black_box((sim.energy(), sim.state_on_constraint().is_ok()));
                sim.set_step_size(1e200);
                assert!(sim.advance(3).is_err(), "{name}");
                assert!(Integrator::new(system, method, 0.001, State::new([0.0; 4], [0.0; 4])).step().is_err());
            });
            assert_eq!(count, 0, "ladder with {name}");
        }
    }
    let mut steps = Steps(0);
    methods::kinds_of_constrained(&mut steps);
    assert_eq!(steps.0, 4);
}

/// A charge in a field that grows, pulled by a spring: pieces that are drifts of a kind and a kick, one at frozen time.
#[hamiltonian]
fn charge(q: [f64; 2], p: [f64; 2], t: f64, m: f64, b: f64) -> f64 {
    let [x, y] = q;
    (p[0] * p[0] + (p[1] - b * (1.0 + t * t).sin() * x * x).powi(2)) / (2.0 * m) + (x * y).cos()
}

/// Three masses on springs that couple them all.
#[hamiltonian]
fn springs(q: [f64; 3], p: [f64; 3], k: f64) -> f64 {
    let [a, b] = [q[1] - q[0], q[2] - q[1]];
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 2.0 + k * (a * a + b * b) / 2.0 + 0.1 * (a.powi(4) + b.powi(4))
}

#[test]
fn flows_of_pieces_allocate_nothing() {
    struct Steps(usize);
    impl Visitor<Charge> for Steps {
        fn visit<M: Method<Charge> + 'static>(&mut self, method: M) {
            self.0 += 1;
            let name = method.name().to_string();
            let count = allocations_during(|| {
                let start = State::new([0.3, 0.1], [0.5, -0.4]);
                let mut sim = Integrator::new(Charge { m: 1.5, b: 1.25 }, method, 0.01, start);
                sim.advance(20).unwrap();
                sim.step().unwrap();
                black_box((sim.energy(), sim.state()));
                sim.set_step_size(f64::NAN);
                assert!(sim.step().is_err());
            });
            assert_eq!(count, 0, "charge with {name}");
        }
    }
    let mut steps = Steps(0);
    methods::kinds_of_coupled(&mut steps);
    assert_eq!(steps.0, 3);
    let count = allocations_during(|| {
        let start = State::new([0.3, 0.1, -0.2], [0.5, -0.4, 0.1]);
        let mut sim = Springs { k: 2.0 }.integrator(Aba8_6_4, 0.1, start).compensated();
        sim.advance(20).unwrap();
        sim.set_step_size(f64::NAN);
        assert!(sim.step().is_err());
    });
    assert_eq!(count, 0);
}

#[test]
fn taylor_series_allocate_nothing() {
    macro_rules! none {
        ($($method:expr),*) => { $(
            let count = allocations_during(|| {
                let start = State::new([0.3, 0.1, -0.2], [0.5, -0.4, 0.1]);
                let mut sim = Springs { k: 2.0 }.taylor($method, start);
                sim.step().unwrap();
                assert!(sim.at(sim.state().t).is_ok());
                black_box(sim.sampled_every(0.1).take(5).filter(Result::is_ok).count());
                black_box(sim.crossings(Direction::Any, |state| state.q[0]).take(2).filter(Result::is_ok).count());
                sim.advance_to(20.0).unwrap();
                black_box((sim.energy(), sim.state()));
            });
            assert_eq!(count, 0);
        )* };
    }
    none!(Taylor { tolerance: 1e-12 }, TaylorOrder::<12> { tolerance: 1e-9 }, TaylorFixed::<16> { h: 0.05 });
    // A pole ends the run.
    let count = allocations_during(|| {
        let mut sim = Pole.taylor(Taylor { tolerance: 1e-12 }, FlowState::new([1.0]));
        assert!(sim.advance_to(2.0).is_err());
        assert!((sim.state().t - 1.0).abs() < 1e-12);
    });
    assert_eq!(count, 0);
}

/// x' = x².
#[vector_field]
fn pole(x: [f64; 1]) -> [f64; 1] {
    [x[0] * x[0]]
}

#[test]
fn stepping_of_contact_systems_allocates_nothing() {
    contact_steps("splitting", ContactSplitting);
    contact_steps("midpoint", ContactMidpoint);
    contact_steps("Gauss", ContactGauss::<3>);
    contact_steps("discrete gradient", ContactDiscreteGradient);
    contact_steps("composition", Suzuki4.of(ContactMidpoint));
}

#[test]
fn stepping_allocates_nothing() {
    assert!(allocations_during(|| drop(black_box(vec![1.0]))) > 0, "the counter counts");

    let mut steps = Steps::<HenonHeiles>(0, PhantomData);
    methods::kinds_of_general(&mut steps);
    methods::kinds_of_discrete_gradient(&mut steps);
    methods::projected(&mut steps);
    methods::relaxed(&mut steps);
    methods::kinds_of_separable(&mut steps);
    methods::kinds_of_nystrom(&mut steps);
    methods::kinds_of_force_gradient(&mut steps);
    methods::kinds_of_perturbed(&mut steps);
    methods::kinds_of_perturbed_gradient(&mut steps);
    methods::processed(&mut steps);
    methods::kinds_of_itoh_abe(&mut steps);
    methods::itoh_abe_one_way(&mut steps);
    methods::kinds_of_cubic(&mut steps);
    assert_eq!(steps.0, 39);

    let mut steps = Steps::<DoublePendulum>(0, PhantomData);
    methods::kinds_of_general(&mut steps);
    methods::kinds_of_discrete_gradient(&mut steps);
    methods::projected(&mut steps);
    methods::relaxed(&mut steps);
    assert_eq!(steps.0, 14);

    let mut steps = Steps::<SwingingMass>(0, PhantomData);
    methods::coordinate_increment(&mut steps);
    assert_eq!(steps.0, 2);
}
