//! Bodies with an axis of symmetry: their free motion is two rotations.

use super::*;

/// Symmetric about the third axis.
#[hamiltonian(attitude = r)]
fn spinning_top(r: UnitQuaternion<f64>, m: Vector3<f64>, across: f64, along: f64, c: Vector3<f64>) -> f64 {
    (m.x * m.x + m.y * m.y) / (2.0 * across) + m.z * m.z / (2.0 * along) + (r * c).z
}

/// Symmetric about the first axis, and about all.
#[hamiltonian(attitude = r)]
fn wheel_and_ball(r: [UnitQuaternion<f64>; 2], m: [Vector3<f64>; 2], across: f64, along: f64, ball: f64) -> f64 {
    (m[0].y * m[0].y + m[0].z * m[0].z) / (2.0 * across)
        + m[0].x * m[0].x / (2.0 * along)
        + m[1].norm_squared() / (2.0 * ball)
        + 0.0 * r[0].w
}

fn distance(a: &BodyState<UnitQuaternion<f64>>, b: &BodyState<UnitQuaternion<f64>>) -> f64 {
    (a.r.coords - b.r.coords).amax().max((a.m - b.m).amax())
}

/// Two rotations are the exact flow of a free symmetric body. The reference is the flow by series; both agree to rounding.
#[test]
fn two_rotations_are_the_flow() {
    assert!(SpinningTop::<f64>::REPORT.contains("two moments of inertia are equal: the drift is two rotations"));
    assert!(!HeavyBody::<f64>::REPORT.contains("two rotations"));
    for (across, along) in [(2.0, 1.0), (1.0, 2.0), (1.3, 1.3), (0.7, 0.01)] {
        let closed = SpinningTop { across, along, c: Vector3::zeros() };
        let series = HeavyBody { inertia: [across, across, along], c: Vector3::zeros() };
        for h in [1e-3, 0.1, 1.0, -3.0] {
            for m in [M0, Vector3::new(0.0, 0.0, 1.7), Vector3::new(0.6, 0.0, 1e-9), Vector3::zeros(), 1e-170 * M0] {
                let state = BodyState::new(UnitQuaternion::from_euler_angles(0.3, -0.8, 1.1), m);
                let end = |sim: &mut dyn FnMut() -> BodyState<UnitQuaternion<f64>>| sim();
                let a = end(&mut || {
                    let mut sim = closed.integrator(StormerVerlet, h, state);
                    sim.advance(2).unwrap();
                    sim.state()
                });
                let b = end(&mut || {
                    let mut sim = series.integrator(StormerVerlet, h, state);
                    sim.advance(2).unwrap();
                    sim.state()
                });
                let turn = 1.0 + m.norm() * h.abs() / along.min(across);
                assert!(distance(&a, &b) < 1e-15 * (4.0 + turn), "{across} {along} {h} {m:?}: {:e}", distance(&a, &b));
            }
        }
    }
}

/// In units of 2^±600 and 2^±1000 squares of momenta overflow or vanish. The body still turns as in other units, bit for bit.
#[test]
fn two_rotations_in_all_units() {
    let end = |unit: f64| {
        let system = SpinningTop { across: 0.7 * unit, along: 0.3 * unit, c: Vector3::zeros() };
        let mut sim = system.integrator(StormerVerlet, 0.5, BodyState::new(UnitQuaternion::identity(), unit * M0));
        sim.advance(5).unwrap();
        BodyState { m: sim.state().m / unit, ..sim.state() }
    };
    for power in [-600, -1000, 600, 1000] {
        assert_eq!(end(2.0_f64.powi(power)), end(1.0), "2^{power}");
    }
}

#[test]
fn every_axis_may_be_that_of_symmetry() {
    let system = WheelAndBall { across: 1.4, along: 0.6, ball: 0.9 };
    let r = UnitQuaternion::from_euler_angles(0.3, -0.8, 1.1);
    let mut sim = system.integrator(StormerVerlet, 0.7, BodyState::new([r; 2], [M0; 2]));
    sim.advance(3).unwrap();
    for (i, inertia) in [[0.6, 1.4, 1.4], [0.9; 3]].into_iter().enumerate() {
        let mut one = HeavyBody { inertia, c: Vector3::zeros() }.integrator(StormerVerlet, 0.7, BodyState::new(r, M0));
        one.advance(3).unwrap();
        let state = sim.state();
        assert!(distance(&BodyState::at(2.1, state.r[i], state.m[i]), &one.state()) < 2e-14);
    }
}

/// A thousand steps with gravity. Two rotations agree with the flow by series to 2·10⁻¹¹. The symmetry keeps m.z to 2·10⁻¹⁵ and the vertical momentum
/// to 2·10⁻¹³.
#[test]
fn a_heavy_symmetric_body() {
    let (across, along, c) = (1.5, 0.8, Vector3::new(0.0, 0.0, 0.7));
    let mut closed = SpinningTop { across, along, c }.integrator(BlanesMoanSrkn14a, 0.05, start());
    let mut series = HeavyBody { inertia: [across, across, along], c }.integrator(BlanesMoanSrkn14a, 0.05, start());
    closed.advance(1000).unwrap();
    series.advance(1000).unwrap();
    assert!(distance(&closed.state(), &series.state()) < 2e-11);
    assert!((closed.state().m.z - M0.z).abs() < 2e-15, "{:e}", closed.state().m.z - M0.z);
    let upright = |s: &BodyState<UnitQuaternion<f64>>| (s.r * s.m).z;
    assert!((upright(&closed.state()) - upright(&start())).abs() < 2e-13);
    let mut single = closed.system().integrator(BlanesMoanSrkn14a, 0.05, start()).compensated();
    single.advance(1000).unwrap();
    assert!(distance(&closed.state(), &single.state()) < 2e-11);
}
