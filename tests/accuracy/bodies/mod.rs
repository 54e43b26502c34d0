//! Rigid bodies with attitudes, against solutions of 20 digits.
//!
//! The references are Taylor series of order 40 in arithmetic of 220 bits; the free body agrees with Jacobi's elliptic functions.

mod centres;
mod symmetric;

use geoint_runtime::method::Visitor;
use geoint_runtime::method::catalogue;
use geoint_runtime::prelude::*;
use geoint_runtime::system::Separable;
use geoint_runtime::{Attitudes, PrincipalAxes};
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

/// The same without gravity, at t = 10.
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

/// Errors of the heavy body at t = 5 with n, 2n, … steps.
fn row<M: Method<HeavyBody, Proof = ()>>(method: M, n: u64, expected: &[f64], order: f64) {
    let name = method.name();
    let errors: Vec<f64> = (0..expected.len()).map(|i| error(&end(heavy(), method, 5.0, n << i), HEAVY)).collect();
    println!("{name:20} {errors:?}");
    for (error, expected) in errors.iter().zip(expected) {
        // The smallest errors are rounding for the most part.
        let tolerance = if *expected < 2e-12 { 0.2 } else { 0.02 };
        assert!((error / expected - 1.0).abs() < tolerance, "{name}: {errors:?}, expected {expected:.3e}");
    }
    let found = (errors[errors.len() - 2] / errors[errors.len() - 1]).log2();
    let tolerance = if errors[errors.len() - 1] < 2e-12 { 0.15 } else { 0.05 };
    assert!((found - order).abs() < tolerance, "{name}: order {found:.3}");
}

#[test]
fn every_kind_of_table_has_its_order() {
    row(StormerVerlet, 25, &[7.464e-3, 1.865e-3, 4.663e-4], 2.0);
    row(FiveRotations, 25, &[1.147e-2, 2.895e-3, 7.253e-4], 2.0);
    row(BlanesMoan4, 25, &[2.964e-7, 1.849e-8, 1.155e-9], 4.0);
    row(BlanesMoanSrkn6b, 25, &[3.162e-8, 2.249e-9, 1.449e-10], 3.96);
    row(Chin4A, 25, &[5.446e-6, 3.370e-7, 2.101e-8], 4.0);
    row(BlanesMoanSrkn11b, 20, &[8.625e-10, 1.343e-11], 6.01);
    row(BlanesMoanSrkn14a, 20, &[3.327e-11, 6.1e-13], 5.85);
    row(BceRkn17_8, 10, &[2.248e-9, 9.476e-12], 7.89);
    assert!(error(&end(heavy(), BlanesMoanSrkn14a, 5.0, 20), HEAVY) <= 4e-11);
}

/// All methods of the catalogue that need kicks and drifts alone: the order that they claim, from steps of which the error is no rounding.
///
/// The second part is the solution at t = 2.
struct Orders(Vec<String>, BodyState<UnitQuaternion<f64>>);

impl Visitor<HeavyBody> for Orders {
    fn visit<M: Method<HeavyBody> + 'static>(&mut self, method: M) {
        let claimed = method.claims().order;
        let errors = |n: u64| {
            let mut sim = Integrator::new(heavy(), method, 2.0 / n as f64, start());
            sim.advance(n).unwrap();
            let coarse = sim.state();
            (coarse.m - self.1.m).amax().max((coarse.r.coords - self.1.r.coords).amax())
        };
        let steps = [2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256];
        // The last pair above rounding: the order is that of short steps.
        let mut order = 0.0;
        for pair in steps.windows(2) {
            let (coarse, fine) = (errors(pair[0]), errors(pair[1]));
            if fine < 1e-12 {
                break;
            }
            order = (coarse / fine).ln() / (pair[1] as f64 / pair[0] as f64).ln();
        }
        println!("{:20} {claimed} {order:.2}", method.name());
        if order < f64::from(claimed) - 0.35 {
            self.0.push(format!("{}: order {order:.2}", method.name()));
        }
    }
}

#[test]
fn every_table_of_the_catalogue_has_its_order() {
    let mut orders = Orders(vec![], end(heavy(), BlanesMoanSrkn14a, 2.0, 200));
    catalogue::separable(&mut orders);
    catalogue::quadratic_kinetic(&mut orders);
    catalogue::force_gradient(&mut orders);
    catalogue::principal_axes(&mut orders);
    assert!(orders.0.is_empty(), "{:#?}", orders.0);
}

/// The control: rotations in place of the exact drift have order 2 in a table of order 4.
#[test]
fn five_rotations_would_cost_a_table_its_order() {
    let system = heavy();
    let error_with = |n: u64, rotations: bool| {
        let (table, h) = (&BlanesMoan4, 5.0 / n as f64);
        let (outer, last, inner) = table.coefficients();
        let (_, [mut r, mut m], ()) = geoint_runtime::space::Snapshot::parts(start());
        let kick = |w: f64, r: &mut [[f64; 4]; 1], m: &mut [[f64; 4]; 1]| {
            system.kick(&Separable::prepare_kick(&system, w * h), 0.0, r, m, &mut ());
        };
        for _ in 0..n {
            for (outer, inner) in outer.iter().zip(inner) {
                kick(*outer, &mut r, &mut m);
                let drift = Separable::prepare_drift(&system, inner * h);
                if rotations {
                    system.rotate(&drift, &mut r, &mut m);
                } else {
                    system.drift(&drift, 0.0, &mut r, &mut m, &mut ());
                }
            }
            kick(last, &mut r, &mut m);
        }
        error(&geoint_runtime::space::Snapshot::of(5.0, [r, m], ()), HEAVY)
    };
    for (rotations, expected) in [(false, [2.964e-7, 1.849e-8, 1.155e-9]), (true, [7.3e-4, 1.8e-4, 4.6e-5])] {
        let errors = [25, 50, 100].map(|n| error_with(n, rotations));
        println!("{rotations} {errors:?}");
        for (error, expected) in errors.iter().zip(expected) {
            assert!((error / expected - 1.0).abs() < 0.03, "{errors:?}");
        }
        let order = (errors[1] / errors[2]).log2();
        assert!((order - if rotations { 2.0 } else { 4.0 }).abs() < 0.05, "order {order:.3}");
    }
}

#[test]
fn a_drift_is_the_flow_of_a_free_body() {
    // In steps of every length: series of 12, 14, 18 terms, and parts.
    for n in [1000, 200, 100, 50, 25, 10, 1] {
        let error = error(&end(free(), StormerVerlet, 10.0, n), FREE);
        println!("{n:5} {error:.1e}");
        assert!(error < 2e-14, "{n} steps: {error:.1e}");
    }
}

#[test]
fn a_free_body_keeps_its_energy_and_its_momentum() {
    for h in [0.1, 0.2] {
        let mut sim = free().integrator(StormerVerlet, h, start());
        let (energy, momentum) = (sim.energy(), sim.state().r * sim.state().m);
        let mut largest = [0.0_f64; 4];
        for _ in 0..100 {
            sim.advance(1000).unwrap();
            let state = sim.state();
            let squared = state.m.norm_squared() / M0.norm_squared() - 1.0;
            let found = [
                sim.energy() / energy - 1.0,
                squared,
                (state.r * state.m - momentum).amax(),
                state.r.into_inner().norm() - 1.0,
            ];
            largest = std::array::from_fn(|i| largest[i].max(found[i].abs()));
        }
        println!("{h} {largest:?}");
        assert!(largest[0] < 1e-13 && largest[1] < 1e-13 && largest[2] < 2e-13 && largest[3] < 1e-14, "{largest:?}");
    }
}

/// On the separatrix of Euler's equations, with two equal moments, and with J far from that of any body made of masses.
#[test]
fn a_drift_serves_every_inertia_and_every_motion() {
    let separatrix = Vector3::new((1.0_f64 / 3.0).sqrt(), 0.0, 1.0);
    let cases = [
        ([1.0, 2.0, 3.0], separatrix),
        ([2.0, 2.0, 1.0], M0),
        ([1.5; 3], M0),
        ([1.0, 2.0, 0.01], Vector3::new(0.7, 0.4, 0.01)),
        ([1.0, 2.0, 3.0], Vector3::new(0.0, 1.7, 1e-9)),
        ([1.0, 2.0, 3.0], Vector3::zeros()),
    ];
    for (inertia, m) in cases {
        let state = BodyState::new(UnitQuaternion::identity(), m);
        let system = HeavyBody { inertia, c: Vector3::zeros() };
        let end = |h: f64, n: u64| {
            let mut sim = system.integrator(StormerVerlet, h, state);
            sim.advance(n).unwrap();
            sim.state()
        };
        let (whole, parts) = (end(3.0, 1), end(3.0 / 512.0, 512));
        let gap = (whole.m - parts.m).amax().max((whole.r.coords - parts.r.coords).amax());
        println!("{inertia:?} {gap:.1e}");
        assert!(gap < 3e-14, "{inertia:?}: {gap:.1e}");
        let energy = |state| system.energy(&state);
        assert!((energy(whole) - energy(state)).abs() <= 1e-14 * energy(state), "{inertia:?}");
    }
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

/// Two bodies with a wheel in each that spins: T has terms linear in the momentum, and what both bodies have in common is written once.
#[hamiltonian(attitude = attitude, m = l)]
fn gyrostats(attitude: [UnitQuaternion<f64>; 2], l: [Vector3<f64>; 2], i: f64, spin: Vector3<f64>) -> f64 {
    let wheels = (l[0] - spin).norm_squared() + (l[1] + spin * 0.5).norm_squared() + 0.3 * l[1].x * l[1].x;
    wheels / (2.0 * i) + (attitude[0] / attitude[1]).w.powi(2)
}

#[test]
fn gyrostats_drift_exactly() {
    let system = Gyrostats { i: 1.3, spin: Vector3::new(0.4, -0.7, 0.9) };
    let (_, BodyState { r, m, .. }) = two_dipoles();
    let state = BodyState::new(r, m);
    let mut reference = system.adaptive(DOP853, 1e-13, state);
    reference.advance_to(1.0).unwrap();
    let end = |n: u64| {
        let mut sim = system.integrator(BlanesMoanSrkn11b, 1.0 / n as f64, state);
        sim.advance(n).unwrap();
        let (a, b) = (sim.state(), reference.state());
        (0..2).map(|i| (a.m[i] - b.m[i]).amax().max((a.r[i].coords - b.r[i].coords).amax())).fold(0.0, f64::max)
    };
    let errors = [2, 4, 40].map(end);
    println!("{errors:?}");
    let order = (errors[0] / errors[1]).log2();
    assert!((order - 6.0).abs() < 0.5 && errors[2] < 1e-12, "{errors:?}, order {order:.2}");
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
    // Against the same steps; what is left of the difference is rounding.
    let mut exact = heavy().integrator(BlanesMoanSrkn14a, 0.02, start()).compensated();
    exact.advance(20_000).unwrap();
    let drift = |compensated: bool| {
        let sim = heavy().integrator(BlanesMoanSrkn14a, 0.02, start());
        let energy = sim.energy();
        let end = if compensated {
            let mut sim = sim.compensated();
            sim.advance(20_000).unwrap();
            sim.energy()
        } else {
            let mut sim = sim;
            sim.advance(20_000).unwrap();
            sim.energy()
        };
        (end - energy).abs()
    };
    let (plain, compensated) = (drift(false), drift(true));
    println!("{plain:.1e} {compensated:.1e}");
    assert!(compensated < 5e-15 && compensated < plain, "{plain:.1e} {compensated:.1e}");
}

#[test]
fn a_quaternion_of_another_length_is_refused() {
    let state = BodyState { r: UnitQuaternion::new_unchecked(Quaternion::new(1.0, 0.0, 0.5, 0.0)), ..start() };
    let refused = |error: StepError| match error {
        StepError::NotNormalised { length, .. } => (length - 1.25_f64.sqrt()).abs() < 1e-15,
        _ => false,
    };
    let mut sim = heavy().integrator(StormerVerlet, 0.1, state);
    assert!(refused(sim.step().unwrap_err()) && refused(sim.advance(10).unwrap_err()));
    assert_eq!(sim.state(), state);
    let mut sim = heavy().adaptive(DOP853, 1e-8, state);
    assert!(refused(sim.step().unwrap_err()));
    assert_eq!(sim.state(), state);
    let text = sim.step().unwrap_err().to_string();
    assert!(text.contains("length 1.118"), "{text}");
    // Rounding is no mistake, and stays what it is.
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
    assert!(matches!(sim.step(), Err(StepError::NonFinite { .. })), "no such step is taken");
    assert_eq!(sim.state(), start());
    let mut sim = heavy().integrator(StormerVerlet, 0.1, BodyState { m: Vector3::new(f64::NAN, 0.0, 0.0), ..start() });
    assert!(matches!(sim.step(), Err(StepError::NonFiniteState { .. })));
}

/// States of attitudes may be named.
fn _attitudes<A: Attitudes<Real = f64>>(state: BodyState<A>) -> A {
    state.r
}
