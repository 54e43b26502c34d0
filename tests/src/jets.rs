//! Taylor coefficients in two ways: by a kernel, and by truncated series as a scalar.

use crate::scalars::Double;
use geoint_runtime::private::{Action as _, Jets};
use geoint_runtime::scalar::{Real, Series};
use geoint_runtime::space::{Array, PerCoordinate};
use geoint_runtime::system::{Contact, PhaseSpace, VectorField};

/// Number of coefficients, including order 0.
pub const N: usize = 25;

/// How far a kernel may be off, in units of the largest coefficient of an order, as far as their growth allows.
pub const BAR: f64 = 1e-13;

/// Returns the Taylor coefficients of a solution, by the field over series. Each evaluation determines one more coefficient.
pub fn by_series<R: Real, const N: usize>(
    x: &[R],
    mut field: impl FnMut(&[Series<R, N>], Series<R, N>) -> Vec<Series<R, N>>,
    t: R,
) -> Vec<[R; N]> {
    let mut solution: Vec<Series<R, N>> = x.iter().map(|x| Series::constant(*x)).collect();
    let mut time = Series::constant(t);
    time.0[1] = R::from_f64(1.0);
    for n in 1..N {
        let rates = field(&solution, time);
        for (x, rate) in solution.iter_mut().zip(rates) {
            x.0[n] = rate.0[n - 1] / R::from_f64(n as f64);
        }
    }
    solution.into_iter().map(|x| x.0).collect()
}

/// The coefficients of a kernel, from order 1 on.
fn by_kernel<S: Jets>(system: &S, t: f64, z: S::Phase, s: S::Action) -> Vec<Vec<f64>> {
    let mut jet = [PerCoordinate { z, s }; N - 1];
    let mut switches = [S::Switches::zero(); N - 1];
    system.jet(1.0, t, &z, &s, &mut jet, &mut switches);
    let numbers = |i: usize| {
        let of = |x: &PerCoordinate<S::Phase, S::Action>| {
            *x.z.as_slice().iter().chain(x.s.numbers()).nth(i).expect("a coordinate")
        };
        jet.iter().map(of).collect()
    };
    (0..S::Phase::LEN + s.numbers().len()).map(numbers).collect()
}

/// Taylor coefficients computed in both ways.
pub struct Both {
    /// By the kernel, from order 1 on.
    pub kernel: Vec<Vec<f64>>,
    /// By series.
    pub series: Vec<[f64; N]>,
}

impl Both {
    /// Returns the error of the kernel, relative to the largest coefficient of its order.
    pub fn error(&self) -> f64 {
        error(&self.kernel, &self.series)
    }

    /// Returns whether all coefficients are finite.
    pub fn is_finite(&self) -> bool {
        let kernel = self.kernel.iter().flatten();
        kernel.chain(self.series.iter().flatten()).all(|x| f64::is_finite(*x))
    }
}

/// Returns the largest difference of `some` from `others`, relative to the largest coefficient of its order. This scale is at least the extrapolation
/// of the lower orders, which grow like powers of one number.
pub fn error(some: &[Vec<f64>], others: &[[f64; N]]) -> f64 {
    let largest = |n: usize| others.iter().map(|x| x[n].abs()).fold(0.0, f64::max);
    let radius = (N - 8..N).map(|n| largest(n).powf(-1.0 / n as f64)).fold(f64::INFINITY, f64::min);
    let mut error = 0.0_f64;
    for n in 1..N {
        let grown = |j: usize| if radius.is_finite() { radius.powi(j as i32 - n as i32) } else { 1.0 };
        let scale = (0..=n).map(|j| largest(j) * grown(j)).fold(0.0, f64::max);
        for (a, b) in some.iter().zip(others) {
            let off = (a[n - 1] - b[n]).abs();
            error = error.max(if off == 0.0 { 0.0 } else { off / scale });
        }
    }
    error
}

/// Rates of a field, or of an energy without action, over series.
pub fn rates<R: Real, S>(system: &S, x: &[R], t: R) -> Vec<[R; N]>
where
    S: VectorField<Series<R, N>>,
    <S as PhaseSpace<Series<R, N>>>::Phase: Array<Real = Series<R, N>>,
{
    let field = |x: &[Series<R, N>], t: Series<R, N>| {
        let mut z = <S as PhaseSpace<Series<R, N>>>::Phase::zero();
        z.as_mut_slice().copy_from_slice(x);
        let mut dz = z;
        system.rate(t, &z, &mut dz);
        dz.as_slice().to_vec()
    };
    by_series(x, field, t)
}

/// Rates of a contact system over series; the action comes last.
pub fn contact_rates<R: Real, S>(system: &S, x: &[R], t: R) -> Vec<[R; N]>
where
    S: Contact<Series<R, N>>,
    <S as PhaseSpace<Series<R, N>>>::Phase: Array<Real = Series<R, N>>,
{
    let field = |x: &[Series<R, N>], t: Series<R, N>| {
        let (coordinates, action) = x.split_at(x.len() - 1);
        let mut z = <S as PhaseSpace<Series<R, N>>>::Phase::zero();
        Array::as_mut_slice(&mut z).copy_from_slice(coordinates);
        let (mut dz, mut ds) = (z, action[0]);
        system.rate(t, &z, &action[0], &mut dz, &mut ds);
        [Array::as_slice(&dz), &[ds]].concat()
    };
    by_series(x, field, t)
}

/// Computes the coefficients of a field, or of an energy without action, in both ways. Both systems are the same, over two scalars.
pub fn of_field<S, T>(system: &S, over: &T, t: f64, x: &[f64]) -> Both
where
    S: Jets<f64, Action = ()>,
    T: VectorField<Series<f64, N>>,
    <S as PhaseSpace<f64>>::Phase: Array<Real = f64>,
    <T as PhaseSpace<Series<f64, N>>>::Phase: Array<Real = Series<f64, N>>,
{
    let mut z = <S as PhaseSpace<f64>>::Phase::zero();
    z.as_mut_slice().copy_from_slice(x);
    Both { kernel: by_kernel(system, t, z, ()), series: rates(over, x, t) }
}

/// Computes the coefficients of a contact system in both ways.
pub fn of_contact<S, T>(system: &S, over: &T, t: f64, x: &[f64]) -> Both
where
    S: Jets<f64, Action = f64>,
    T: Contact<Series<f64, N>>,
    <S as PhaseSpace<f64>>::Phase: Array<Real = f64>,
    <T as PhaseSpace<Series<f64, N>>>::Phase: Array<Real = Series<f64, N>>,
{
    let (coordinates, action) = x.split_at(x.len() - 1);
    let mut z = <S as PhaseSpace<f64>>::Phase::zero();
    z.as_mut_slice().copy_from_slice(coordinates);
    Both { kernel: by_kernel(system, t, z, action[0]), series: contact_rates(over, x, t) }
}

/// Returns exact coefficients, and the error of series in f64. The error shows the growth of rounding along the way.
pub fn exact(series: &[[f64; N]], exact: &[[Double; N]]) -> (Vec<[f64; N]>, f64) {
    let exact: Vec<[f64; N]> = exact.iter().map(|x| x.map(Double::value)).collect();
    let rounded: Vec<Vec<f64>> = series.iter().map(|x| x[1..].to_vec()).collect();
    let noise = error(&rounded, &exact);
    (exact, noise)
}
