//! Drifts are the flows of free bodies.

use super::*;

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

/// Drifts are exact for every inertia and every motion: on the separatrix of Euler's equations, with two equal moments, and with J far from any body
/// made of masses.
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
    assert!(Gyrostats::<f64>::REPORT.contains("- `FiveRotations`: T is not Σ mᵢ²/(2Iᵢ) of every body"));
    println!("{errors:?}");
    let order = (errors[0] / errors[1]).log2();
    assert!((order - 6.0).abs() < 0.5 && errors[2] < 1e-12, "{errors:?}, order {order:.2}");
}

#[hamiltonian(attitude = r)]
fn small_body(r: UnitQuaternion<f32>, m: Vector3<f32>, inertia: [f32; 3]) -> f32 {
    m.x * m.x / (2.0 * inertia[0]) + m.y * m.y / (2.0 * inertia[1]) + m.z * m.z / (2.0 * inertia[2]) + 0.0 * r.w
}

/// Many rotations by nearly the same small angle: a rounded cosine would let lengths shrink or grow by the same number in each.
#[test]
fn five_rotations_have_no_trend() {
    let (r, m) = (UnitQuaternion::from_euler_angles(0.3, -0.8, 1.1), Vector3::new(0.5, 1.6, -1.2));
    for h in [1e-2, 1e-3] {
        let mut sim = SmallBody { inertia: [1.0, 2.0, 3.0] }.integrator(FiveRotations, h, BodyState::new(r, m));
        sim.advance(100_000).unwrap();
        let state = sim.state();
        let [length, direction] = [state.m.norm() / m.norm() - 1.0, (state.r * state.m - r * m).norm()];
        assert!(length.abs() < 5e-5 && direction < 2e-4, "{h}: {length:e} {direction:e}");
    }
}
