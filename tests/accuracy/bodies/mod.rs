//! Rigid bodies with attitudes, against solutions of 20 digits.
//!
//! The references are Taylor series of order 40 in arithmetic of 220 bits; the free body agrees with Jacobi's elliptic functions.

mod drifts;
mod orders;
mod centres;
mod symmetric;

use geoint_runtime::PrincipalAxes;
use geoint_runtime::method::Visitor;
use geoint_runtime::method::catalogue;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::Attitudes;
use geoint_runtime::system::Separable;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// A heavy body about a fixed point: `r` turns vectors of the body into those of space, `m` is the angular momentum in the body.
#[hamiltonian(attitude = r)]
fn heavy_body(r: UnitQuaternion<f64>, m: Vector3<f64>, inertia: [f64; 3], c: Vector3<f64>) -> f64 {
    (m.x * m.x / inertia[0] + m.y * m.y / inertia[1] + m.z * m.z / inertia[2]) / 2.0 + (r * c).z
}

/// The same, with all that the language of bodies has: V is c·(r⁻¹e₃), by the numbers of r, and T by a full matrix.
#[hamiltonian(attitude = r)]
fn heavy_body_in_another_frame(
    r: UnitQuaternion<f64>,
    m: Vector3<f64>,
    inverse: [[f64; 3]; 3],
    frame: UnitQuaternion<f64>,
    c: Vector3<f64>,
) -> f64 {
    let mut t = 0.0;
    for i in 0..3 {
        for j in 0..3 {
            t += m[i] * inverse[i][j] * m[j] / 2.0;
        }
    }
    let vertical = (r * frame).inverse() * Vector3::new(0.0, 0.0, 1.0);
    t + c.dot(&vertical)
}

/// Two bodies that pull on each other as dipoles fixed in them do, driven in time.
#[hamiltonian(attitude = r)]
fn dipoles(
    r: [UnitQuaternion<f64>; 2],
    m: [Vector3<f64>; 2],
    inertia: [[f64; 3]; 2],
    d: [Vector3<f64>; 2],
    t: f64,
) -> f64 {
    let mut energy = 0.0;
    for i in 0..2 {
        for k in 0..3 {
            energy += m[i][k] * m[i][k] / (2.0 * inertia[i][k]);
        }
    }
    let (a, b) = (r[0] * d[0], r[1].transform_vector(&d[1]));
    energy + (1.0 + 0.2 * t.sin()) * (a.dot(&b) - 3.0 * a.x * b.x)
}

const INERTIA: [f64; 3] = [1.0, 2.0, 3.0];
const C: Vector3<f64> = Vector3::new(0.3, -0.2, 0.7);
const M0: Vector3<f64> = Vector3::new(0.5, 1.6, -1.2);

/// w, i, j, k and m at t = 5.
const HEAVY: ([f64; 4], [f64; 3]) = (
    [-0.434_074_094_714_059_34, -0.774_783_365_534_560_4, -0.341_706_245_267_694_2, -0.307_452_856_116_452_36],
    [1.714_606_503_808_859, -1.620_069_755_883_852_4, 0.179_963_615_617_357_06],
);

/// Solution without gravity: w, i, j, k and m at t = 10.
const FREE: ([f64; 4], [f64; 3]) = (
    [-0.469_387_689_946_109_9, -0.035_263_815_816_103_994, -0.421_025_044_861_958_37, 0.775_351_256_799_219],
    [-0.855_612_532_917_130_2, 0.794_801_090_877_793_8, -1.698_887_406_349_991_7],
);

fn heavy() -> HeavyBody {
    HeavyBody { inertia: INERTIA, c: C }
}

fn free() -> HeavyBody {
    HeavyBody { inertia: INERTIA, c: Vector3::zeros() }
}

fn start() -> BodyState<UnitQuaternion<f64>> {
    BodyState::new(UnitQuaternion::identity(), M0)
}

/// The largest error; r and −r are one attitude.
fn error(state: &BodyState<UnitQuaternion<f64>>, (r, m): ([f64; 4], [f64; 3])) -> f64 {
    let exact = Quaternion::new(r[0], r[1], r[2], r[3]);
    let sign = state.r.dot(&exact).signum();
    let attitude = (state.r.into_inner() * sign - exact).coords.amax();
    attitude.max((state.m - Vector3::from(m)).amax())
}

fn end<M: Method<HeavyBody, Proof = ()>>(
    system: HeavyBody,
    method: M,
    t: f64,
    n: u64,
) -> BodyState<UnitQuaternion<f64>> {
    let mut sim = Integrator::new(system, method, t / n as f64, start());
    sim.advance(n).unwrap();
    sim.state()
}

#[test]
fn the_frame_of_a_body_is_free() {
    // Turned by `frame`, with m and c turned back: the same body.
    let frame = UnitQuaternion::from_euler_angles(0.3, -0.8, 1.1);
    let turned = frame.to_rotation_matrix();
    let inverse =
        turned * nalgebra::Matrix3::from_diagonal(&Vector3::from(INERTIA.map(f64::recip))) * turned.transpose();
    let system = HeavyBodyInAnotherFrame {
        inverse: std::array::from_fn(|i| std::array::from_fn(|j| inverse[(i, j)])),
        frame,
        c: C,
    };
    let state = BodyState::new(frame.inverse(), frame * M0);
    let mut sim = system.integrator(BlanesMoan6, 0.05, state);
    sim.advance(100).unwrap();
    let plain = BodyState::at(5.0, sim.state().r * frame, frame.inverse() * sim.state().m);
    let error = error(&plain, HEAVY);
    assert!(error < 1e-8, "{error:.1e}");
    assert!(HeavyBodyInAnotherFrame::REPORT.contains("a full tensor of inertia"));
    assert!(HeavyBody::REPORT.contains("principal axes"));
}

fn two_dipoles() -> (Dipoles, BodyState<[UnitQuaternion<f64>; 2]>) {
    let system = Dipoles { inertia: [INERTIA, [0.7, 1.1, 0.9]], d: [C, Vector3::new(-0.5, 0.4, 0.2)] };
    let r = [UnitQuaternion::from_euler_angles(0.4, 0.2, -0.3), UnitQuaternion::from_euler_angles(-1.0, 0.7, 0.1)];
    (system, BodyState::at(0.3, r, [M0, Vector3::new(-0.3, 0.8, 0.4)]))
}

#[test]
fn several_bodies_in_time() {
    let (system, state) = two_dipoles();
    let end = |n: u64| {
        let mut sim = system.integrator(BlanesMoan6, 2.0 / n as f64, state);
        sim.advance(n).unwrap();
        sim.state()
    };
    let mut reference = system.adaptive(DOP853, 1e-14, state);
    reference.advance_to(2.3).unwrap();
    let gap = |a: &BodyState<[UnitQuaternion<f64>; 2]>, b: &BodyState<[UnitQuaternion<f64>; 2]>| {
        let one = |i: usize| (a.m[i] - b.m[i]).amax().max((a.r[i].coords - b.r[i].coords).amax());
        one(0).max(one(1))
    };
    let errors = [20, 40].map(|n| gap(&end(n), &reference.state()));
    println!("{errors:?}");
    let order = (errors[0] / errors[1]).log2();
    assert!((order - 6.0).abs() < 0.3 && errors[1] < 1e-8, "{errors:?}, order {order:.2}");
}

#[test]
fn kicks_are_the_torques_of_the_field() {
    // RK4 has the equations of motion alone, the tables have kicks and drifts alone.
    let (system, state) = two_dipoles();
    let mut sim = system.integrator(RK4, 1e-3, state);
    sim.advance(1000).unwrap();
    let mut other = system.integrator(Chin4C, 1e-2, state);
    other.advance(100).unwrap();
    let (a, b) = (sim.state(), other.state());
    for i in 0..2 {
        assert!((a.m[i] - b.m[i]).amax() < 1e-8 && (a.r[i].coords - b.r[i].coords).amax() < 1e-8);
    }
}

#[test]
fn steps_backwards_lead_back() {
    let mut sim = heavy().integrator(BlanesMoan4, 0.07, start());
    sim.advance(300).unwrap();
    sim.set_step_size(-0.07);
    sim.advance(300).unwrap();
    let state = sim.state();
    let gap = (state.m - M0).amax().max((state.r.coords - start().r.coords).amax());
    assert!(gap < 2e-12, "{gap:.1e}");
}

#[test]
fn compensated_sums_have_less_rounding() {
    let drift = |compensated: bool| {
        let sim = heavy().integrator(BlanesMoanSrkn14a, 0.02, start());
        let energy = sim.energy();
        let end = if compensated {
            let mut sim = sim.compensated();
            sim.advance(10_000).unwrap();
            sim.energy()
        } else {
            let mut sim = sim;
            sim.advance(10_000).unwrap();
            sim.energy()
        };
        (end - energy).abs()
    };
    let (plain, compensated) = (drift(false), drift(true));
    println!("{plain:.1e} {compensated:.1e}");
    assert!(compensated < 5e-15 && compensated < plain, "{plain:.1e} {compensated:.1e}");
}

/// Every end of a run is a valid start of another run, for every method. Some methods add increments to quaternions as if these were no attitudes.
#[test]
fn ends_of_runs_are_starts() {
    fn check<M: Method<HeavyBody<f64>>>(method: M, h: f64)
    where
        HeavyBody<f64>: IntoIntegrator<f64, State = BodyState<UnitQuaternion<f64>>>,
    {
        let name = method.name();
        let mut sim = Integrator::new(heavy(), method, h, start());
        let mut longest = 0.0_f64;
        for _ in 0..1500 {
            sim.step().unwrap();
            let state = sim.state();
            longest = longest.max((state.r.coords.norm() - 1.0).abs());
            Integrator::new(heavy(), method, h, state).step().unwrap_or_else(|error| panic!("{name}: {error}"));
        }
        assert!(longest < 1e-13, "{name}: {longest:.1e}");
        let mut adaptive = Adaptive::new(heavy(), method, 1e-6, start());
        for _ in 0..100 {
            adaptive.step().unwrap();
            let state = adaptive.state();
            Adaptive::new(heavy(), method, 1e-6, state).step().unwrap_or_else(|error| panic!("{name}: {error}"));
        }
    }
    check(ExplicitEuler, 0.01);
    check(RK4, 0.1);
    check(DOP853, 0.2);
    check(StormerVerlet, 0.1);
    check(FiveRotations, 0.1);
    check(BlanesMoanSrkn14a, 0.1);
}

#[test]
fn a_quaternion_of_another_length_is_refused() {
    let state = BodyState { r: UnitQuaternion::new_unchecked(Quaternion::new(1.0, 0.0, 0.5, 0.0)), ..start() };
    let refused = |error: StepError| match error {
        StepError { failure: Failure::NotNormalised { length }, .. } => (length - 1.25_f64.sqrt()).abs() < 1e-15,
        _ => false,
    };
    let mut sim = heavy().integrator(StormerVerlet, 0.1, state);
    assert!(refused(sim.step().unwrap_err()) && refused(sim.advance(10).unwrap_err()));
    assert_eq!(sim.state(), state);
    let mut sim = heavy().adaptive(DOP853, 1e-8, state);
    assert!(refused(sim.step().unwrap_err()));
    assert_eq!(sim.state(), state);
    let text = sim.step().unwrap_err().to_string();
    assert!(text.contains("length 1.118") && text.contains("`r.renormalize()`"), "{text}");
    // A length that is off by rounding (10⁻¹⁴) is accepted, and the state keeps its quaternion.
    let rounded =
        BodyState { r: UnitQuaternion::new_unchecked(Quaternion::new(1.0 + 1e-14, 0.0, 0.0, 0.0)), ..start() };
    let mut sim = heavy().integrator(StormerVerlet, 0.1, rounded);
    assert_eq!(sim.state().r, rounded.r);
    assert!(sim.step().is_ok());
}

#[test]
fn attitudes_are_normalised_after_the_same_steps() {
    let run = |chunks: &[u64]| {
        let mut sim = heavy().integrator(StormerVerlet, 0.01, start());
        for chunk in chunks {
            sim.advance(*chunk).unwrap();
        }
        sim.state()
    };
    let length = |state: BodyState<UnitQuaternion<f64>>| (state.r.into_inner().norm() - 1.0).abs();
    assert!(length(run(&[1024])) < 3e-16);
    assert!(length(run(&[1000, 24])) < 3e-16);
    assert!(length(run(&[1; 1024])) < 3e-16);
    // Chunks end with a kick of their own: the same to rounding.
    let (whole, parts) = (run(&[1500]), run(&[1000, 500]));
    assert!((parts.r.coords - whole.r.coords).amax() < 1e-11);
}

#[test]
fn in_single_precision() {
    #[hamiltonian(attitude = r)]
    fn short(r: UnitQuaternion<f32>, m: Vector3<f32>, inertia: [f32; 3], c: Vector3<f32>) -> f32 {
        (m.x * m.x / inertia[0] + m.y * m.y / inertia[1] + m.z * m.z / inertia[2]) / 2.0 + (r * c).z
    }
    let system = Short { inertia: [1.0, 2.0, 3.0], c: Vector3::new(0.3, -0.2, 0.7) };
    let state = BodyState::new(UnitQuaternion::identity(), Vector3::new(0.5, 1.6, -1.2));
    let mut sim = system.integrator(BlanesMoan4, 0.1, state);
    sim.advance(50).unwrap();
    let found = sim.state();
    let double = BodyState::new(UnitQuaternion::new_unchecked(found.r.into_inner().cast()), found.m.cast());
    let error = error(&double, HEAVY);
    assert!(error < 1e-5, "{error:.1e}");
}

#[test]
fn hopeless_steps_are_errors() {
    let mut sim = heavy().integrator(StormerVerlet, 1e9, start());
    assert!(matches!(sim.step(), Err(StepError { failure: Failure::NonFinite, .. })), "no such step is taken");
    assert_eq!(sim.state(), start());
    let mut sim = heavy().integrator(StormerVerlet, 0.1, BodyState { m: Vector3::new(f64::NAN, 0.0, 0.0), ..start() });
    assert!(matches!(sim.step(), Err(StepError { failure: Failure::NonFiniteState, .. })));
}

/// No digit of a turn by 10¹⁷ rad is known, so the step is refused. A quaternion of length 10¹⁶ after a step has no digit left when normalised.
#[test]
fn turns_of_which_nothing_is_known_are_errors() {
    fn refused<M: Method<HeavyBody, Proof = ()>>(method: M, spin: f64, h: f64) {
        let start = BodyState::new(UnitQuaternion::identity(), Vector3::new(0.3 * spin, spin, -0.2 * spin));
        let mut sim = free().integrator(method, h, start);
        assert!(sim.step().is_err());
        assert_eq!((sim.state().r, sim.state().m), (start.r, start.m));
    }
    refused(FiveRotations, 1e9, 1e9);
    refused(RK4, 1e7, 100.0);
    // Far too long, but not without digits.
    let start = BodyState::new(UnitQuaternion::identity(), Vector3::new(30.0, 100.0, -20.0));
    for h in [0.1, 1e3] {
        let mut sim = free().integrator(FiveRotations, h, start);
        sim.step().unwrap();
        assert!((sim.state().r.norm() - 1.0).abs() < 1e-14);
    }
}

/// States of attitudes may be named.
fn _attitudes<A: Attitudes<Real = f64>>(state: BodyState<A>) -> A {
    state.r
}
