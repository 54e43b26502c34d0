//! What is measured of a method: error against an independent solution, order, drift, symplecticity, symmetry.

use crate::problems::{Problem, flat};
use crate::scalars::{Double, Dual, Scalar};
use geoint_runtime::space::Array;
use geoint_runtime::{Coordinates, Hamiltonian, Method, Run, State, StepError};

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
/// Times, evenly spread, at which errors are taken: at a single one the leading term may happen to vanish.
pub const LOOKS: u64 = 4;
/// Errors above this say nothing of h → 0.
const CEILING: f64 = 0.2;
/// An error that does not fall below this has nothing to do with the rounding of coefficients to `f64`.
const ROUNDED: f64 = 1e-14;

/// log₂ e(h)/e(h/2) for the smallest h whose errors are beyond rounding; NaN if there is none.
///
/// `error` takes one of [`STEPS`]. Even in double-double an error does not fall to zero, because tables are rounded to
/// `f64`: where it no longer falls as any order would have it shows how far that reaches.
pub fn observed_order(mut error: impl FnMut(u64) -> f64) -> f64 {
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
    let mut order = f64::NAN;
    for (n, now) in STEPS.into_iter().zip(&errors) {
        if let Some(before) = half(n).map(|i| errors[i]).filter(|before| *now > floor && *before < CEILING) {
            order = (before / now).log2();
        }
    }
    order
}

/// The solution of a problem at all looks.
pub fn solutions<P: Problem>(start: f64, duration: f64, parts: usize) -> Vec<Vec<Double>> {
    let solve = |look: u64| {
        let part = Double::from(duration) * look as f64 / LOOKS as f64;
        solution(&P::system::<Double>(), &P::initial(start), part, parts * look as usize)
    };
    (1..=LOOKS).map(solve).collect()
}

/// The error of a method in double-double, in the root-mean-square of all looks, for `n` steps.
///
/// A method that scales its steps is measured at the time that it says it has reached.
pub fn error<P: Problem, M: Method<P::Over<Double>, Double>>(
    method: M,
    start: f64,
    duration: f64,
    n: u64,
    solutions: &[Vec<Double>],
) -> Result<f64, StepError> {
    let h = Double::from(duration) / n as f64;
    let mut sim = P::system::<Double>().integrator(method, h, P::initial(start));
    let mut sum = 0.0;
    for (look, expected) in (1..=LOOKS).zip(solutions) {
        sim.advance(n / LOOKS)?;
        let t = Double::from(start) + Double::from(duration) * look as f64 / LOOKS as f64;
        let late = sim.time() - t;
        let gap = if late.value().abs() < 1e-25 {
            distance(&flat(&sim.state()), expected)
        } else {
            let (q, p) = expected.split_at(expected.len() / 2);
            let (q, p) = (array::<P::Over<Double>, _>(q), array::<P::Over<Double>, _>(p));
            let there = State::at(t, Coordinates::from_array(q), Coordinates::from_array(p));
            distance(&flat(&sim.state()), &solution(&P::system::<Double>(), &there, late, 4))
        };
        sum += gap.powi(2);
    }
    Ok((sum / LOOKS as f64).sqrt())
}

/// max |MᵀJM − J| for the derivative M of `steps` steps, from one run in dual numbers a coordinate.
pub fn symplecticity_defect<P: Problem, M: Method<P::Over<Dual>, Dual>>(
    method: M,
    start: f64,
    h: f64,
    steps: u64,
) -> Result<f64, StepError> {
    let (q, p) = P::START;
    let n = q.len();
    let mut columns = vec![];
    for seed in 0..2 * n {
        let mut state = P::initial::<Dual>(start);
        let (mut q, mut p) = (state.q.into_array(), state.p.into_array());
        let entry = if seed < n { &mut q.as_mut_slice()[seed] } else { &mut p.as_mut_slice()[seed - n] };
        *entry = Dual::variable(entry.value());
        (state.q, state.p) = (Coordinates::from_array(q), Coordinates::from_array(p));
        let mut sim = P::system::<Dual>().integrator(method, h.into(), state);
        sim.advance(steps)?;
        columns.push(flat(&sim.state()).iter().map(|x| x.derivative()).collect::<Vec<f64>>());
    }
    assert_eq!(p.len(), n);
    let mut defect = 0.0_f64;
    for i in 0..2 * n {
        for j in 0..2 * n {
            let form: f64 = (0..n).map(|k| columns[i][k] * columns[j][n + k] - columns[i][n + k] * columns[j][k]).sum();
            let expected = f64::from(i8::from(j == i + n)) - f64::from(i8::from(i == j + n));
            defect = defect.max((form - expected).abs());
        }
    }
    Ok(defect)
}

/// |Φ(−h)ⁿ ∘ Φ(h)ⁿ − id| at the start, in `f64`, relative to the largest coordinate if that is above 1.
pub fn symmetry_defect<P: Problem, M: Method<P::Over<f64>, f64>>(
    method: M,
    start: f64,
    h: f64,
    steps: u64,
) -> Result<f64, StepError> {
    let state = P::initial::<f64>(start);
    let mut sim = P::system::<f64>().integrator(method, h, state);
    sim.advance(steps)?;
    sim.set_step_size(-h);
    sim.advance(steps)?;
    let x = flat(&state);
    Ok(distance(&flat(&sim.state()), &x) / x.iter().fold(1.0, |max: f64, x| max.max(x.abs())))
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
