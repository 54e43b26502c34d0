//! Every kind of system against truncated series as a scalar.

use super::*;

type OverSeries = Series<f64, N>;

/// The coefficients of a solution by the field over series: each evaluation makes one more of them known.
fn by_series<const N: usize>(
    x: &[f64],
    mut field: impl FnMut(&[Series<f64, N>], Series<f64, N>) -> Vec<Series<f64, N>>,
    t: f64,
) -> Vec<[f64; N]> {
    let mut solution: Vec<Series<f64, N>> = x.iter().map(|x| Series::constant(*x)).collect();
    let mut time = Series::constant(t);
    time.0[1] = 1.0;
    for n in 1..N {
        let rates = field(&solution, time);
        for (x, rate) in solution.iter_mut().zip(rates) {
            x.0[n] = rate.0[n - 1] / n as f64;
        }
    }
    solution.into_iter().map(|x| x.0).collect()
}

const N: usize = 25;

/// Errors of a kernel's coefficients in units of the largest of their order, as far as their growth allows.
fn compare(name: &str, of_kernel: &[Vec<f64>], of_series: &[[f64; N]]) {
    let largest = |n: usize| of_series.iter().map(|x| x[n].abs()).fold(0.0, f64::max);
    let radius = (N - 8..N).map(|n| largest(n).powf(-1.0 / n as f64)).fold(f64::INFINITY, f64::min);
    for n in 1..N {
        let scale = (0..=n).map(|j| largest(j) * radius.powi(j as i32 - n as i32)).fold(0.0, f64::max);
        for (kernel, series) in of_kernel.iter().zip(of_series) {
            let error = (kernel[n - 1] - series[n]).abs() / scale;
            assert!(error <= 1e-13, "{name}, order {n}: {} is not {}, {error:.1e}", kernel[n - 1], series[n]);
        }
    }
}

/// The kernel of a system without parameters.
fn kernel<S: Jets>(system: &S, t: f64, z: S::Phase, s: S::Action) -> Vec<Vec<f64>> {
    let mut jet = [geoint_runtime::space::PerCoordinate { z, s }; N - 1];
    let mut switches = [S::Switches::zero(); N - 1];
    system.jet(1.0, t, &z, &s, &mut jet, &mut switches);
    use geoint_runtime::space::Action;
    let numbers = |i: usize| {
        let of = |x: &geoint_runtime::space::PerCoordinate<S::Phase, S::Action>| {
            *x.z.as_slice().iter().chain(x.s.numbers()).nth(i).unwrap()
        };
        jet.iter().map(of).collect()
    };
    (0..S::Phase::LEN + s.numbers().len()).map(numbers).collect()
}

/// A field, or an energy without action.
fn check_field<S>(name: &str, system: S, t: f64, x: &[f64])
where
    S: Jets<f64, Action = ()> + VectorField<OverSeries>,
    <S as PhaseSpace<f64>>::Phase: Array<Real = f64>,
    <S as PhaseSpace<OverSeries>>::Phase: Array<Real = OverSeries>,
{
    let mut z = <S as PhaseSpace<f64>>::Phase::zero();
    z.as_mut_slice().copy_from_slice(x);
    let field = |x: &[Series<f64, N>], t: Series<f64, N>| {
        let mut z = <S as PhaseSpace<Series<f64, N>>>::Phase::zero();
        z.as_mut_slice().copy_from_slice(x);
        let mut dz = z;
        system.rate(t, &z, &mut dz);
        dz.as_slice().to_vec()
    };
    compare(name, &kernel(&system, t, z, ()), &by_series(x, field, t));
}

fn check_contact<S>(name: &str, system: S, t: f64, x: &[f64])
where
    S: Jets<f64, Action = f64> + Contact<OverSeries>,
    <S as PhaseSpace<f64>>::Phase: Array<Real = f64>,
    <S as PhaseSpace<OverSeries>>::Phase: Array<Real = OverSeries>,
{
    let (coordinates, action) = x.split_at(x.len() - 1);
    let mut z = <S as PhaseSpace<f64>>::Phase::zero();
    z.as_mut_slice().copy_from_slice(coordinates);
    let field = |x: &[Series<f64, N>], t: Series<f64, N>| {
        let (coordinates, action) = x.split_at(x.len() - 1);
        let mut z = <S as PhaseSpace<Series<f64, N>>>::Phase::zero();
        Array::as_mut_slice(&mut z).copy_from_slice(coordinates);
        let (mut dz, mut ds) = (z, action[0]);
        system.rate(t, &z, &action[0], &mut dz, &mut ds);
        [Array::as_slice(&dz), &[ds]].concat()
    };
    compare(name, &kernel(&system, t, z, action[0]), &by_series(x, field, t));
}

#[hamiltonian]
fn coupled(q: [f64; 2], p: [f64; 2]) -> f64 {
    let mass = 1.7 + q[0].cos() * q[1].sin();
    (p[0] * p[0] + 0.6 * p[1] * p[1] + 0.3 * p[0] * p[1]) / (2.0 * mass) + (q[0] * q[1]).exp() + q[1].atan2(q[0])
}

#[hamiltonian]
fn driven(q: f64, p: f64, t: f64) -> f64 {
    p * p / (1.4 + t * t) + q.powi(4) / 4.0 - 0.3 * q * (1.3 * t + 0.2).cos() + (-0.4 * t).exp() * q.tanh()
}

#[hamiltonian(damping = 0.2 + q * q)]
fn damped(q: f64, p: f64) -> f64 {
    p * p / 2.6 - 1.7 * q.cos()
}

#[contact_hamiltonian]
fn twice_damped(q: [f64; 2], p: [f64; 2], s: f64, t: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.4 - (q[0] - q[1]).cos() + (0.2 + 0.1 * s.sin()) * s + 0.1 * t * q[0]
}

#[hamiltonian(structure = so3)]
fn top(x: [f64; 3]) -> f64 {
    x[0] * x[0] / 1.4 + x[1] * x[1] / 2.3 + x[2] * x[2] / 3.9 + 0.2 * x[0].powi(3)
}

#[vector_field]
fn van_der_pol(x: [f64; 2]) -> [f64; 2] {
    [x[1], 5.0 * (1.0 - x[0] * x[0]) * x[1] - x[0]]
}

#[lagrangian]
fn double_pendulum(q: [f64; 2], v: [f64; 2]) -> f64 {
    v[0] * v[0] + v[1] * v[1] / 2.0 + v[0] * v[1] * (q[0] - q[1]).cos() + 9.81 * (2.0 * q[0].cos() + q[1].cos())
}

#[hamiltonian]
fn branches(q: f64, p: f64) -> f64 {
    let wall = if q > 1.0 { (q - 1.0).powi(2) } else { 0.3 * (q - 1.0).powi(3) };
    p * p / 2.6 + wall + (q - 0.3).abs() * p.max(q) + (p * q).min(0.1)
}

#[hamiltonian]
fn powers(q: f64, p: f64) -> f64 {
    let r = 1.0 + q * q;
    p.powi(3) / 3.0
        + r.powf(-1.5)
        + r.powf(-2.5)
        + r.sqrt()
        + 1.0 / r
        + q.powi(7)
        + (2.0 + q).powf(p)
        + (3.0 + p).cbrt()
        + 2.0_f64.powf(q)
        + (q / 9.0).asin()
        + (q / 7.0).acos()
        + (q / 8.0).atanh()
        + q.asinh()
        + (2.0 + r).acosh()
        + r.ln()
        + r.log10()
        + q.ln_1p() * p.exp_m1()
        + q.tan()
        + p.sinh()
        + q.cosh()
        + q.hypot(p)
        + r.log2()
}

#[test]
fn every_kind_of_system() {
    check_field("coupled", Coupled, 0.0, &[0.7, -0.4, 0.3, 1.1]);
    check_field("driven", Driven, 0.3, &[0.7, -0.4]);
    check_field("damped", Damped, 0.0, &[0.7, -0.4]);
    check_field("top", Top, 0.0, &[0.7, -0.4, 0.9]);
    check_field("van der pol", VanDerPol, 0.0, &[1.9, -0.4]);
    check_field("double pendulum", DoublePendulum, 0.0, &[1.0, 1.2, 0.3, -0.8]);
    check_field("branches", Branches, 0.0, &[0.7, -0.4]);
    check_field("branches", Branches, 0.0, &[1.3, 0.4]);
    check_field("powers", Powers, 0.0, &[0.4, 0.3]);
    check_contact("contact", TwiceDamped, 0.2, &[0.7, -0.4, 0.3, 1.1, 0.6]);
}

#[test]
fn a_recurrence_that_is_wrong_is_seen() {
    let right = by_series::<N>(&[0.7, -0.4], |x, _| vec![x[1], -Real::sin(x[0])], 0.0);
    let mut wrong: Vec<Vec<f64>> = right.iter().map(|x| x[1..].to_vec()).collect();
    compare("pendulum", &wrong, &right);
    wrong[1][12] *= 1.0 + 1e-11;
    assert!(std::panic::catch_unwind(|| compare("pendulum", &wrong, &right)).is_err());
}
