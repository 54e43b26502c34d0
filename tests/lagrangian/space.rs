//! An arm in space with six joints, written by recursion along its links: angular velocity, velocity and the vertical in the frame of each.

use geoint_runtime::prelude::*;

/// Joints turn about the z-axes of frames by Denavit and Hartenberg, twisted by right angles; c are centres of mass, in the frame of their
/// link, and inertia is about them.
#[lagrangian]
pub(crate) fn arm_in_space(
    q: [f64; 6],
    v: [f64; 6],
    m: [f64; 6],
    c: [[f64; 3]; 6],
    inertia: [[f64; 3]; 6],
    a: [f64; 2],
    d: [f64; 4],
    g: f64,
) -> f64 {
    let cross =
        |x: [f64; 3], y: [f64; 3]| [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
    let dot = |x: [f64; 3], y: [f64; 3]| x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    let sum = |x: [f64; 3], y: [f64; 3]| [x[0] + y[0], x[1] + y[1], x[2] + y[2]];
    let twists = [[1.0, 0.0], [0.0, 1.0], [0.0, 1.0], [1.0, 0.0], [-1.0, 0.0], [0.0, 1.0]];
    let links = [[0.0, d[0]], [a[0], 0.0], [a[1], 0.0], [0.0, d[1]], [0.0, d[2]], [0.0, d[3]]];
    let (mut spin, mut velocity, mut up) = ([0.0; 3], [0.0; 3], [0.0, 0.0, 1.0]);
    let (mut height, mut energy) = (0.0, 0.0);
    for i in 0..6 {
        let (sin, cos) = q[i].sin_cos();
        let turned = |x: [f64; 3]| [cos * x[0] + sin * x[1], cos * x[1] - sin * x[0], x[2]];
        let [s, t] = twists[i];
        let twisted = |x: [f64; 3]| [x[0], t * x[1] + s * x[2], t * x[2] - s * x[1]];
        let link = [links[i][0], 0.0, links[i][1]];
        let turning = turned([spin[0], spin[1], spin[2] + v[i]]);
        height += dot(link, turned(up));
        velocity = twisted(sum(turned(velocity), cross(turning, link)));
        spin = twisted(turning);
        up = twisted(turned(up));
        let centre = sum(velocity, cross(spin, c[i]));
        let squares = [spin[0] * spin[0], spin[1] * spin[1], spin[2] * spin[2]];
        energy += 0.5 * m[i] * dot(centre, centre) + 0.5 * dot(inertia[i], squares);
        energy -= m[i] * g * (height + dot(c[i], up));
    }
    energy
}

const ARM: ArmInSpace = ArmInSpace {
    m: [3.7, 8.4, 2.3, 1.2, 1.2, 0.25],
    c: [
        [0.0, -0.02, 0.0],
        [-0.2, 0.0, 0.11],
        [-0.18, 0.0, 0.03],
        [0.0, 0.01, 0.0],
        [0.0, -0.01, 0.0],
        [0.0, 0.0, -0.03],
    ],
    inertia: [
        [0.010, 0.010, 0.007],
        [0.015, 0.134, 0.133],
        [0.004, 0.031, 0.031],
        [0.003, 0.002, 0.003],
        [0.003, 0.002, 0.003],
        [0.0001, 0.0001, 0.0002],
    ],
    a: [-0.425, -0.392],
    d: [0.089, 0.109, 0.095, 0.082],
    g: 9.81,
};

fn released() -> State<[f64; 6]> {
    ARM.at([0.3, -1.2, 0.8, -0.5, 0.4, 0.2], [0.5, 0.1, -0.2, 0.3, 0.6, -0.4])
}

#[test]
fn the_first_angle_is_not_read() {
    let report = ArmInSpace::<f64>::REPORT;
    assert!(report.contains("p[0]: L does not read q[0]"), "{report}");
    assert!(report.contains("with 6 unknowns a stage"), "{report}");
}

#[test]
fn energy_and_momentum_stay() -> Result<(), StepError> {
    let mut sim = ARM.integrator(DiscreteGradient, 0.002, released());
    let energy = sim.energy();
    sim.advance(1000)?;
    assert!((sim.energy() - energy).abs() < 1e-11, "{:e}", sim.energy() - energy);
    assert_eq!(sim.state().p[0], released().p[0]);
    let mut sim = ARM.integrator(ImplicitMidpoint, 0.002, released());
    sim.advance(1000)?;
    assert!((sim.state().p[0] - released().p[0]).abs() < 1e-14);
    Ok(())
}

#[test]
fn orders() -> Result<(), StepError> {
    let end = |steps: u64, order: u32| -> Result<[f64; 6], StepError> {
        let h = 0.1 / steps as f64;
        match order {
            2 => {
                let mut sim = ARM.integrator(ImplicitMidpoint, h, released());
                sim.advance(steps)?;
                Ok(sim.state().q)
            }
            4 => {
                let mut sim = ARM.integrator(Gauss::<2>, h, released());
                sim.advance(steps)?;
                Ok(sim.state().q)
            }
            _ => {
                let mut sim = ARM.integrator(DiscreteGradient, h, released());
                sim.advance(steps)?;
                Ok(sim.state().q)
            }
        }
    };
    let exact = end(400, 4)?;
    let far = |q: [f64; 6]| (0..6).fold(0.0, |far, i| f64::max(far, (q[i] - exact[i]).abs()));
    for (kind, expected) in [(2, 2.0), (3, 2.0), (4, 4.0)] {
        let errors = [far(end(50, kind)?), far(end(100, kind)?)];
        assert!(((errors[0] / errors[1]).log2() - expected).abs() < 0.2, "{kind}: {errors:?}");
    }
    Ok(())
}
