//! Bodies with forces between all pairs. Their sums are computed together, four pairs at a time.

use geoint_runtime::prelude::*;
use geoint_runtime::scalar::Series;
use geoint_tests::jets::{BAR, Both, N, of_field};

/// Ten pairs: two that are left over have other sums beside them.
#[hamiltonian]
fn softened(q: [[f64; 3]; 5], p: [[f64; 3]; 5], m: [f64; 5], soft: f64) -> f64 {
    let mut energy = 0.0;
    for i in 0..5 {
        energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1] + p[i][2] * p[i][2]) / (2.0 * m[i]);
        for j in 0..i {
            let d = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
            energy -= m[i] * m[j] / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + soft).sqrt();
        }
    }
    energy
}

/// Three pairs in the plane, with a power that only a run knows.
#[hamiltonian]
fn repelling(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3], power: f64) -> f64 {
    let mut energy = 0.0;
    for i in 0..3 {
        energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]);
        for j in 0..i {
            let (x, y) = (q[i][0] - q[j][0], q[i][1] - q[j][1]);
            energy += 2.0 * m[i] * m[j] * (x * x + y * y).powf(power);
        }
    }
    energy
}

fn check(name: &str, both: &Both) {
    assert!(both.is_finite(), "{name}");
    assert!(both.error() <= BAR, "{name}: {:.1e}", both.error());
}

#[test]
fn forces_between_bodies() {
    let constants = |x: &[f64]| -> Vec<Series<f64, N>> { x.iter().map(|x| Series::constant(*x)).collect() };
    let state: Vec<f64> = (0..30).map(|k| (1.7 * f64::from(k) + 0.3).sin() * (1.0 + f64::from(k % 7))).collect();
    // One body has no effect on the others.
    let (m, soft) = ([1.3, 0.7, 2.1, 0.0625, 1e-300], 0.25);
    let over = Softened { m: constants(&m).try_into().expect("five"), soft: Series::constant(soft) };
    let heavy = [1.3, 0.7, 2.1, 0.0625, 0.4];
    let all = Softened { m: constants(&heavy).try_into().expect("five"), soft: Series::constant(soft) };
    check("softened", &of_field(&Softened { m: heavy, soft }, &all, 0.0, &state));
    let mut resting = state.clone();
    resting[27..].fill(0.0);
    check("with a body without mass", &of_field(&Softened { m, soft }, &over, 0.0, &resting));
    let (m, power) = ([1.3, 0.7, 2.1], -0.35);
    let over = Repelling { m: constants(&m).try_into().expect("three"), power: Series::constant(power) };
    check("repelling", &of_field(&Repelling { m, power }, &over, 0.0, &state[..12]));
}
