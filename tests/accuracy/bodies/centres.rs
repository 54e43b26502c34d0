//! Bodies with attitudes and centres of mass. Methods have their order, and conserve the total angular and linear momentum.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use nalgebra::{UnitQuaternion, Vector3};

/// A satellite, whose attraction is that of its moments of inertia (MacCullagh): orbit and attitude act on each other.
#[hamiltonian(attitude = r)]
fn satellite(
    r: UnitQuaternion<f64>,
    m: Vector3<f64>,
    q: Vector3<f64>,
    p: Vector3<f64>,
    mass: f64,
    inertia: [f64; 3],
    mu: f64,
) -> f64 {
    let (u, square) = (r.inverse() * q, q.norm_squared());
    let trace = inertia[0] + inertia[1] + inertia[2];
    let along = (inertia[0] * u.x * u.x + inertia[1] * u.y * u.y + inertia[2] * u.z * u.z) / square;
    let turning = m.x * m.x / inertia[0] + m.y * m.y / inertia[1] + m.z * m.z / inertia[2];
    p.norm_squared() / (2.0 * mass) + turning / 2.0
        - mu * mass / square.sqrt()
        - mu * (trace - 3.0 * along) / (2.0 * square * square.sqrt())
}

/// Two symmetric bodies, held together by a spring between a point of each, and by a force between their centres. What turns and what
/// moves have mass matrices of their own: p₀·p₁ couples the centres, as a third body that is thrown off would.
#[hamiltonian(attitude = a, m = l)]
fn pair(
    a: [UnitQuaternion<f64>; 2],
    l: [Vector3<f64>; 2],
    q: [Vector3<f64>; 2],
    p: [Vector3<f64>; 2],
    mass: [f64; 3],
    across: [f64; 2],
    along: f64,
    d: [Vector3<f64>; 2],
    k: f64,
) -> f64 {
    let mut energy = (p[0] + p[1]).norm_squared() / (2.0 * mass[2]);
    for i in 0..2 {
        energy += p[i].norm_squared() / (2.0 * mass[i]);
        energy += (l[i].x * l[i].x + l[i].y * l[i].y) / (2.0 * across[i]) + l[i].z * l[i].z / (2.0 * along);
    }
    let ends = q[0] + a[0] * d[0] - q[1] - a[1] * d[1];
    energy + k * ends.norm_squared() / 2.0 + 0.3 * (q[0] - q[1]).norm()
}

type Alone = BodyState<UnitQuaternion<f64>, Vector3<f64>>;
type Two = BodyState<[UnitQuaternion<f64>; 2], [Vector3<f64>; 2]>;

fn orbiting() -> (Satellite, Alone) {
    let start = BodyState::new(UnitQuaternion::from_euler_angles(0.3, -0.5, 0.2), Vector3::new(0.006, 0.01, -0.012))
        .with_centres(Vector3::new(1.0, 0.2, -0.1), Vector3::new(-0.3, 1.6, 0.5));
    (Satellite { mass: 1.3, inertia: [0.01, 0.016, 0.022], mu: 1.7 }, start)
}

fn held_together() -> (Pair, Two) {
    let a = [UnitQuaternion::from_euler_angles(0.3, -0.5, 0.2), UnitQuaternion::from_euler_angles(-0.3, 0.5, 1.2)];
    let start = BodyState::new(a, [Vector3::new(0.3, 0.5, -0.2), Vector3::new(0.1, -0.5, 0.4)]).with_centres(
        [Vector3::new(1.0, 0.2, -0.1), Vector3::new(-0.4, 0.3, 0.2)],
        [Vector3::new(-0.2, 0.4, 0.5), Vector3::new(0.1, -0.7, 0.3)],
    );
    let d = [Vector3::new(0.1, 0.3, 0.2), Vector3::new(-0.2, 0.1, 0.4)];
    (Pair { mass: [1.3, 0.8, 2.7], across: [0.4, 0.3], along: 0.2, d, k: 2.1 }, start)
}

fn gap(a: &Alone, b: &Alone) -> f64 {
    let turned = (a.r.coords - b.r.coords).amax().max((a.m - b.m).amax());
    turned.max((a.q - b.q).amax()).max((a.p - b.p).amax())
}

fn gap_of_two(a: &Two, b: &Two) -> f64 {
    let one = |s: &Two, i: usize| BodyState::at(s.t, s.r[i], s.m[i]).with_centres(s.q[i], s.p[i]);
    gap(&one(a, 0), &one(b, 0)).max(gap(&one(a, 1), &one(b, 1)))
}

/// Momentum of all, in space, about the origin.
fn around(s: &Alone) -> Vector3<f64> {
    s.q.cross(&s.p) + s.r * s.m
}

/// Errors after three units of time against a run by Runge and Kutta, whose rates are the equations of motion themselves.
#[test]
fn tables_have_their_order() {
    let (system, start) = orbiting();
    let mut reference = system.adaptive(DOP853, 1e-14, start);
    reference.advance_to(3.0).unwrap();
    let end = reference.state();
    macro_rules! row {
        ($($method:expr => $order:expr, $n:expr;)*) => {$({
            let errors = [$n, 2 * $n].map(|n| {
                let mut sim = system.integrator($method, 3.0 / n as f64, start);
                sim.advance(n).unwrap();
                let turned = (around(&sim.state()) - around(&start)).amax();
                assert!(turned < 2e-14, "{}: {turned:e}", stringify!($method));
                gap(&sim.state(), &end)
            });
            let order = (errors[0] / errors[1]).log2();
            assert!((order - $order).abs() < 0.1 && errors[1] > 1e-13, "{}: {errors:?}", stringify!($method));
        })*};
    }
    row! {
        StormerVerlet => 2.0, 60;
        FiveRotations => 2.0, 60;
        BlanesMoan4 => 4.0, 60;
        Chin4A => 4.0, 60;
        BlanesMoanSrkn11b => 5.95, 60;
    }
    let mut control = system.integrator(RK4, 0.05, start);
    control.advance(60).unwrap();
    assert!((around(&control.state()) - around(&start)).amax() > 1e-9);
}

#[test]
fn arrays_of_bodies_with_centres() {
    let (system, start) = held_together();
    let mut reference = system.adaptive(DOP853, 1e-14, start);
    reference.advance_to(3.0).unwrap();
    let error = |method: &dyn Fn(u64) -> Two, n: u64| {
        let end = method(n);
        let all = |s: &Two| (0..2).map(|i| s.q[i].cross(&s.p[i]) + s.r[i] * s.m[i]).sum::<Vector3<f64>>();
        assert!((all(&end) - all(&start)).amax() < 2e-14);
        assert!((end.p[0] + end.p[1] - start.p[0] - start.p[1]).amax() < 1e-14);
        gap_of_two(&end, &reference.state())
    };
    macro_rules! end {
        ($method:expr) => {
            |n: u64| {
                let mut sim = system.integrator($method, 3.0 / n as f64, start);
                sim.advance(n).unwrap();
                sim.state()
            }
        };
    }
    let order = |method: &dyn Fn(u64) -> Two, n: u64| (error(method, n) / error(method, 2 * n)).log2();
    assert!((order(&end!(FiveRotations), 60) - 2.0).abs() < 0.05);
    assert!((order(&end!(Chin4A), 60) - 4.0).abs() < 0.1);
    // Longer steps have more.
    assert!(order(&end!(BlanesMoanSrkn14a), 30) > 5.9);
    assert!(error(&end!(BlanesMoanSrkn14a), 120) < 2e-13);
    assert!(Pair::<f64>::REPORT.contains("T is quadratic in p with constant coefficients"));
    assert!(Pair::<f64>::REPORT.contains("q' = ∂H/∂p, p' = −∂H/∂q"));
}

/// Rates against difference quotients of the energy.
#[test]
fn forces_are_slopes_of_the_energy() {
    let (system, start) = orbiting();
    let h = 1e-5;
    let rate = {
        let mut sim = system.integrator(RK4, 1e-7, start);
        sim.advance(1).unwrap();
        [(sim.state().q - start.q) / 1e-7, (sim.state().p - start.p) / 1e-7]
    };
    for i in 0..3 {
        let slope = |change: &dyn Fn(&mut Alone, f64)| {
            let energy = [h, -h].map(|h| {
                let mut state = start;
                change(&mut state, h);
                system.energy(&state)
            });
            (energy[0] - energy[1]) / (2.0 * h)
        };
        assert!((rate[0][i] - slope(&|s, h| s.p[i] += h)).abs() < 1e-6);
        assert!((rate[1][i] + slope(&|s, h| s.q[i] += h)).abs() < 1e-6);
    }
}

#[test]
fn refused_where_bodies_meet() {
    let (system, start) = orbiting();
    let start = BodyState { q: Vector3::zeros(), ..start };
    let mut sim = system.integrator(StormerVerlet, 0.1, start);
    assert!(sim.step().is_err());
    assert_eq!(sim.state(), start);
    let (system, start) = held_together();
    let mut there = system.integrator(BlanesMoan4, 0.05, start).compensated();
    there.advance(60).unwrap();
    there.set_step_size(-0.05);
    there.advance(60).unwrap();
    assert!(gap_of_two(&there.state(), &start) < 1e-13);
}
