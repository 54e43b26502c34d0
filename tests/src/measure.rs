//! Measurements of a method: error against an independent solution, order, drift, symplecticity, symmetry.

use crate::bare::Bare;
use crate::problems::flat;
use crate::scalars::{Double, Dual, Scalar};
use crate::scene::Scene;
use geoint_runtime::method::Failure;
use geoint_runtime::space::Array;
use geoint_runtime::{Hamiltonian, Method, State};

/// The state of a system without damping after a time, by [`extrapolated`]: all that is used of the system is ∇H.
pub fn solution<S: Hamiltonian<R>, R: Scalar>(
    system: &S,
    state: &State<S::Coordinates>,
    duration: R,
    parts: usize,
) -> Vec<R> {
    let field = |t: R, y: &[R]| {
        let (q, p) = y.split_at(S::Array::LEN);
        let mut slopes = S::Phase::zero();
        system.gradient(t, &[array::<S, R>(q), array::<S, R>(p)], &mut slopes);
        let [dq, dp] = slopes;
        dp.as_slice().iter().copied().chain(dq.as_slice().iter().map(|force| -*force)).collect::<Vec<R>>()
    };
    extrapolated(field, state.t, flat(state), duration, parts)
}

/// The solution of y' = field(t, y) after a time, by Gragg's midpoint rule extrapolated to order 24 (W. B. Gragg 1965;
/// R. Bulirsch & J. Stoer 1966) in `parts` equal parts.
///
/// It shares no code with the methods. In double-double with a few parts a unit of time it is accurate to 10⁻²² or better.
pub fn extrapolated<R: Scalar>(
    field: impl Fn(R, &[R]) -> Vec<R>,
    start: R,
    mut y: Vec<R>,
    duration: R,
    parts: usize,
) -> Vec<R> {
    let real = |n: usize| R::from_f64(n as f64);
    let ahead = |y: &[R], h: R, slope: &[R]| -> Vec<R> { y.iter().zip(slope).map(|(y, f)| *y + h * *f).collect() };

    let whole = duration / real(parts);
    for part in 0..parts {
        let t = start + real(part) * whole;
        let mut table: Vec<Vec<R>> = vec![];
        for k in 0..12 {
            let n = 2 * (k + 1);
            let h = whole / real(n);
            let (mut before, mut now) = (y.clone(), ahead(&y, h, &field(t, &y)));
            for i in 1..n {
                let next = ahead(&before, h + h, &field(t + real(i) * h, &now));
                (before, now) = (now, next);
            }
            // Aitken–Neville in h²: row k from row k − 1.
            let mut row = now;
            let mut rows = vec![row.clone()];
            for j in 1..=k {
                let ratio = real(n) / real(2 * (k + 1 - j));
                let weight = R::from_f64(1.0) / (ratio * ratio - R::from_f64(1.0));
                row = row.iter().zip(&table[j - 1]).map(|(new, old)| *new + (*new - *old) * weight).collect();
                rows.push(row.clone());
            }
            table = rows;
        }
        y = table.pop().unwrap_or_default();
    }
    y
}

fn array<S: Hamiltonian<R>, R: Scalar>(x: &[R]) -> S::Array {
    let mut array = S::Array::zero();
    array.as_mut_slice().copy_from_slice(x);
    array
}

/// |a − b|.
pub fn distance<R: Scalar>(a: &[R], b: &[R]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (*a - *b).magnitude().powi(2)).sum::<f64>().sqrt()
}

/// Numbers of steps in which orders are observed.
pub const STEPS: [u64; 14] = [4, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512];
/// Number of times, evenly spread, at which errors are taken. At a single time the leading term may happen to vanish.
pub const LOOKS: u64 = 4;
/// Errors above this say nothing of h → 0.
const CEILING: f64 = 0.2;
/// An error that stagnates above this value has another cause than the rounding of coefficients to `f64`.
const ROUNDED: f64 = 1e-14;

/// The result of errors at many step sizes.
#[derive(Clone, Copy, Debug)]
pub struct Observed {
    /// log₂ e(h)/e(h/2) for the smallest h whose errors are beyond rounding; NaN without such an h.
    pub order: f64,
    /// The number of steps of length h/2.
    pub steps: u64,
    /// Their error.
    pub error: f64,
}

impl Observed {
    /// e/hᵖ, the constant in front of the leading term of an error of order p.
    pub fn constant(&self, duration: f64, order: u32) -> f64 {
        self.error * (self.steps as f64 / duration).powi(order as i32)
    }
}

/// Returns log₂ e(h)/e(h/2) for the smallest h whose errors are beyond rounding, or NaN without such an h.
pub fn observed_order(error: impl FnMut(u64) -> f64) -> f64 {
    observed(error).order
}

/// Returns the order from errors at many step sizes, and the step size that shows it.
///
/// `error` takes one of [`STEPS`]. Tables are rounded to `f64`, so an error does not fall to zero even in double-double. The error at which the fall
/// ends shows the size of this rounding.
pub fn observed(mut error: impl FnMut(u64) -> f64) -> Observed {
    let mut errors: Vec<f64> = vec![];
    let half = |n: u64| STEPS.iter().position(|m| 2 * m == n);
    for n in STEPS {
        let now = error(n);
        errors.push(now);
        if now < ROUNDED && half(n).is_some_and(|i| errors[i] < 2.5 * now) {
            break;
        }
    }
    let least = errors.iter().copied().fold(f64::INFINITY, f64::min);
    let floor = if least < ROUNDED { 25.0 * least } else { 0.0 };
    let mut observed = Observed { order: f64::NAN, steps: 0, error: f64::NAN };
    for (n, now) in STEPS.into_iter().zip(&errors) {
        if let Some(before) = half(n).map(|i| errors[i]).filter(|before| *now > floor && *before < CEILING) {
            observed = Observed { order: (before / now).log2(), steps: n, error: *now };
        }
    }
    observed
}

/// The solution from a point on.
fn followed<P: Scene>(t: Double, x: Vec<Double>, duration: Double, parts: usize) -> Vec<Double> {
    let system = P::over::<Double>();
    extrapolated(|t, x: &[Double]| P::rate(&system, t, x), t, x, duration, parts)
}

/// The solution of a scene at all looks.
pub fn solutions<P: Scene>(duration: f64, parts: usize) -> Vec<Vec<Double>> {
    let (start, x) = P::start();
    let x: Vec<Double> = x.into_iter().map(Double::from).collect();
    let solve = |look: u64| {
        let part = Double::from(duration) * look as f64 / LOOKS as f64;
        followed::<P>(start.into(), x.clone(), part, parts * look as usize)
    };
    (1..=LOOKS).map(solve).collect()
}

/// The error of a method in double-double, in the root-mean-square of all looks, for `n` steps.
///
/// A method that scales its steps is measured at the time that the method has reached.
pub fn error<P: Scene, M: Method<P::Over<Double>, Double>>(
    method: M,
    duration: f64,
    n: u64,
    solutions: &[Vec<Double>],
) -> Result<f64, Failure> {
    let h = Double::from(duration) / n as f64;
    let (start, x) = P::start();
    let x: Vec<Double> = x.into_iter().map(Double::from).collect();
    let mut sim = Bare::<P, M, Double>::new(method, h, start.into(), &x);
    let mut sum = 0.0;
    for (look, expected) in (1..=LOOKS).zip(solutions) {
        sim.advance(n / LOOKS)?;
        let t = Double::from(start) + Double::from(duration) * look as f64 / LOOKS as f64;
        let late = sim.time() - t;
        let gap = if late.value().abs() < 1e-25 {
            distance(&P::compared(sim.state()), expected)
        } else {
            distance(&P::compared(sim.state()), &followed::<P>(t, expected.clone(), late, 4))
        };
        sum += gap.powi(2);
    }
    Ok((sum / LOOKS as f64).sqrt())
}

/// Returns the defect of the form of a scene after `steps` steps. Each direction in which the start may move takes one run in dual numbers.
pub fn form_defect<P: Scene, M: Method<P::Over<Dual>, Dual>>(method: M, h: f64, steps: u64) -> Result<f64, Failure> {
    let (start, before) = P::start();
    let directions = P::directions();
    let (mut after, mut images) = (vec![], vec![]);
    for direction in &directions {
        let seeded: Vec<Dual> =
            before.iter().zip(direction).map(|(x, d)| Dual::from(*x) + Dual::variable(0.0) * *d).collect();
        let mut sim = Bare::<P, M, Dual>::new(method, h.into(), start.into(), &seeded);
        sim.advance(steps)?;
        let end = sim.state();
        after = end.iter().map(|x| x.value()).collect();
        images.push(end.iter().map(|x| x.derivative()).collect::<Vec<f64>>());
    }
    Ok(P::form_defect(&directions, &images, &before, &after))
}

/// |Φ(−h)ⁿ ∘ Φ(h)ⁿ − id|, relative to the largest coordinate if that is above 1.
///
/// After a first step: the scene starts at numbers of `f64`, which a method for constraints or bodies leads to where states of its scalar are.
pub fn symmetry_defect<P, M, R>(method: M, h: f64, steps: u64) -> Result<f64, Failure>
where
    P: Scene,
    M: Method<P::Over<R>, R>,
    R: Scalar,
{
    let (start, x) = P::start();
    let x: Vec<R> = x.into_iter().map(R::from_f64).collect();
    let mut sim = Bare::<P, M, R>::new(method, R::from_f64(h), R::from_f64(start), &x);
    sim.advance(1)?;
    let x = sim.state();
    sim.advance(steps)?;
    let mut sim = sim.back();
    sim.advance(steps)?;
    Ok(distance(&sim.state(), &x) / x.iter().fold(1.0, |max: f64, x| max.max(x.magnitude())))
}

/// A straight line y = offset + slope·x by least squares.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// The slope.
    pub slope: f64,
    /// The standard error of the slope, for independent deviations from the line.
    pub uncertainty: f64,
}

/// The line through points (x, y).
pub fn regression(points: &[(f64, f64)]) -> Line {
    let n = points.len() as f64;
    let (mx, my) = points.iter().fold((0.0, 0.0), |(x, y), p| (x + p.0 / n, y + p.1 / n));
    let xx: f64 = points.iter().map(|p| (p.0 - mx).powi(2)).sum();
    let slope = points.iter().map(|p| (p.0 - mx) * (p.1 - my)).sum::<f64>() / xx;
    let rest: f64 = points.iter().map(|p| (p.1 - my - slope * (p.0 - mx)).powi(2)).sum();
    Line { slope, uncertainty: (rest / ((n - 2.0) * xx)).sqrt() }
}

/// Numbers in [−1, 1) that look random: the same in every run (D. H. Lehmer 1951, with Knuth's multiplier).
#[derive(Clone, Copy, Debug)]
pub struct Noise(u64);

impl Noise {
    /// A sequence of its own for each seed.
    pub const fn new(seed: u64) -> Self {
        Noise(seed)
    }
}

impl Iterator for Noise {
    type Item = f64;
    fn next(&mut self) -> Option<f64> {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        Some((self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0)
    }
}
