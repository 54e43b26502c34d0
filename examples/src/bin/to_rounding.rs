//! How exactly does a motion forth and back return to its start?
//!
//! The motions are three bodies on a figure eight and a chaotic double pendulum. Errors of a method on the way forth do not cancel on the way
//! back. A Taylor series has rounding errors only. A regular motion carries them along; a chaotic motion multiplies them.

use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use geoint_examples::{claim, table};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use std::error::Error;

/// Three bodies of mass 1. A. Chenciner & R. Montgomery, Ann. Math. 152 (2000) 881.
#[hamiltonian]
fn three_bodies(q: [[f64; 2]; 3], p: [[f64; 2]; 3]) -> f64 {
    let mut energy = 0.0;
    for i in 0..3 {
        energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / 2.0;
        for j in 0..i {
            let (x, y) = (q[i][0] - q[j][0], q[i][1] - q[j][1]);
            energy -= 1.0 / (x * x + y * y).sqrt();
        }
    }
    energy
}

/// Two rods of length 1 m with masses of 1 kg at their ends, by angles.
#[hamiltonian]
fn double_pendulum(q: [f64; 2], p: [f64; 2]) -> f64 {
    let d = q[0] - q[1];
    (p[0] * p[0] + 2.0 * p[1] * p[1] - 2.0 * p[0] * p[1] * d.cos()) / (2.0 * (1.0 + d.sin() * d.sin()))
        - 9.81 * (2.0 * q[0].cos() + q[1].cos())
}

const PERIOD: f64 = 6.325_913_98;

fn eight() -> State<[[f64; 2]; 3]> {
    let ([x, y], [u, v]) = ([0.97000436, -0.24308753], [0.93240737, 0.86473146]);
    State::new([[x, y], [-x, -y], [0.0, 0.0]], [[u / 2.0, v / 2.0], [u / 2.0, v / 2.0], [-u, -v]])
}

fn pendulum() -> State<[f64; 2]> {
    State::new([2.0, 2.4], [0.0, 0.0])
}

/// Runs to the time `t` and back, and returns the distance from the start.
fn returned<T: Trajectory>(mut run: T, t: f64, distance: fn(T::State, T::State) -> f64) -> Result<f64, StepError>
where
    T::State: geoint_runtime::space::Snapshot<Real = f64>,
{
    let start = run.state();
    run.advance_to(t)?;
    run.advance_to(0.0)?;
    Ok(distance(run.state(), start))
}

fn of_eight(a: State<[[f64; 2]; 3]>, b: State<[[f64; 2]; 3]>) -> f64 {
    a.q.as_flattened().iter().zip(b.q.as_flattened()).map(|(a, b)| (a - b).abs()).fold(1e-17, f64::max)
}

fn of_pendulum(a: State<[f64; 2]>, b: State<[f64; 2]>) -> f64 {
    a.q.iter().zip(b.q).map(|(a, b)| (a - b).abs()).fold(1e-17, f64::max)
}

fn main() -> Result<(), Box<dyn Error>> {
    let periods = [1, 3, 10, 30, 100];
    let times = [1.0, 2.0, 5.0, 10.0, 20.0];
    let (mut eights, mut pendulums) = (vec![], vec![]);
    for n in periods {
        let t = PERIOD * f64::from(n);
        // A lower order has shorter steps. Their increments are smaller, and so are their rounding errors.
        let taylor = returned(ThreeBodies.taylor(TaylorOrder::<10>::default(), eight()), t, of_eight)?;
        let rival = returned(ThreeBodies.adaptive(DOP853, 1e-14, eight()), t, of_eight)?;
        eights.push([f64::from(n), taylor, rival]);
    }
    for t in times {
        let taylor = returned(DoublePendulum.taylor(Taylor::default(), pendulum()), t, of_pendulum)?;
        let rival = returned(DoublePendulum.adaptive(DOP853, 1e-14, pendulum()), t, of_pendulum)?;
        pendulums.push([t, taylor, rival]);
    }
    let rows = |unit: &str, runs: &[[f64; 3]]| -> Vec<[String; 3]> {
        runs.iter().map(|[t, a, b]| [format!("{t} {unit}"), format!("{a:.1e}"), format!("{b:.1e}")]).collect()
    };
    println!("{}", table(["figure eight", "Taylor", "DOP853, 10⁻¹⁴"], &rows("periods", &eights)));
    println!("{}", table(["double pendulum", "Taylor", "DOP853, 10⁻¹⁴"], &rows("s", &pendulums)));
    claim("after 100 periods forth and back the figure eight returns to 2·10⁻¹² at the least", eights[4][1] < 2e-12)?;
    claim("DOP853 returns with fewer digits there", eights[4][2] > 3.0 * eights[4][1])?;
    claim("after 5 s forth and back the double pendulum returns to 10⁻¹²", pendulums[2][1] < 1e-12)?;
    let curves = |runs: &[[f64; 3]]| {
        let curve =
            |name, colour, i: usize| Curve::line(name, colour, runs.iter().map(|run| (run[0], run[i])).collect());
        vec![curve("Taylor", palette::BLUE, 1), curve("DOP853", palette::VERMILION, 2)]
    };
    let panels = [
        Panel::new(
            "Three bodies on a figure eight",
            "forth and back; Taylor to rounding, DOP853 with tolerance 1e-14; dimensionless",
            [Axis::linear("periods", 0.0..100.0), Axis::decades("distance from the start", -16.0..-8.0)],
            curves(&eights),
        ),
        Panel::new(
            "A chaotic double pendulum",
            "forth and back; Taylor to rounding, DOP853 with tolerance 1e-14; angles in rad",
            [Axis::linear("time in s", 0.0..20.0), Axis::decades("distance from the start", -16.0..1.0)],
            curves(&pendulums),
        ),
    ];
    figure("to_rounding.svg", (3, 2), &panels)
}
