//! Accuracy of the emitted derivatives and divided differences of each function of the language.
//!
//! Both are compared with differences in double-double arithmetic, which know nothing of the rules of differentiation.

use crate::page::{Page, short};
use geoint_runtime::private::{DiscreteField, Span};
use geoint_runtime::space::{Array, Square};
use geoint_runtime::{Hamiltonian, hamiltonian};
use geoint_tests::measure::Noise;
use geoint_tests::scalars::Double;

/// Worst errors, in units of the rounding error: ε times the value, plus the change under a rounding of the argument by ε.
struct Row {
    function: &'static str,
    derivative: f64,
    slope: f64,
}

/// Bounds on the errors.
const DERIVATIVE: f64 = 8.0;
const SLOPE: f64 = 16.0;

/// Declares one energy f(q) + p²/1.4 per line, over a range of q.
macro_rules! functions {
    ($q:ident: $($function:ident $System:ident in $low:literal, $high:literal => $body:expr;)*) => {
        $(
            #[hamiltonian(name = $System)]
            fn $function($q: f64, p: f64) -> f64 {
                p * p / 1.4 + $body
            }
        )*

        fn rows() -> Vec<Row> {
            vec![$(measure(stringify!($function), $System, $low, $high)),*]
        }
    };
}

functions! { q:
    sin Sin in -3.0, 3.0 => q.sin();
    cos Cos in -3.0, 3.0 => q.cos();
    tan Tan in -1.4, 1.4 => q.tan();
    asin Asin in -0.95, 0.95 => q.asin();
    acos Acos in -0.95, 0.95 => q.acos();
    atan Atan in -3.0, 3.0 => q.atan();
    atan2 Atan2 in 0.1, 3.0 => q.atan2(1.3 - q);
    sinh Sinh in -3.0, 3.0 => q.sinh();
    cosh Cosh in -3.0, 3.0 => q.cosh();
    tanh Tanh in -3.0, 3.0 => q.tanh();
    asinh Asinh in -3.0, 3.0 => q.asinh();
    acosh Acosh in 1.1, 4.0 => q.acosh();
    atanh Atanh in -0.9, 0.9 => q.atanh();
    exp Exp in -3.0, 3.0 => q.exp();
    exp2 Exp2 in -3.0, 3.0 => q.exp2();
    exp_m1 ExpM1 in -3.0, 3.0 => q.exp_m1();
    ln Ln in 0.1, 4.0 => q.ln();
    ln_1p Ln1p in -0.9, 4.0 => q.ln_1p();
    log2 Log2 in 0.1, 4.0 => q.log2();
    log10 Log10 in 0.1, 4.0 => q.log10();
    sqrt Sqrt in 0.1, 4.0 => q.sqrt();
    cbrt Cbrt in 0.1, 4.0 => q.cbrt();
    hypot Hypot in -3.0, 3.0 => q.hypot(0.8);
    powi Powi in 0.3, 2.0 => q.powi(5) + q.powi(-3);
    powf Powf in 0.1, 4.0 => q.powf(1.7);
    recip Recip in 0.1, 4.0 => q.recip();
    abs Abs in -2.0, 2.0 => q.abs();
    min Min in -2.0, 2.0 => (0.7 * q).min(q * q);
    max Max in -2.0, 2.0 => (0.7 * q).max(q * q);
    signum Signum in -2.0, 2.0 => q.signum() * q * q;
    quotient Quotient in -2.0, 2.0 => (1.0 - q) / (1.0 + q * q);
    branch Branch in -2.0, 2.0 => if q < 0.25 { q * q } else { 0.3 * (1.0 + q).ln() };
}

fn measure<S>(function: &'static str, system: S, low: f64, high: f64) -> Row
where
    S: DiscreteField + Hamiltonian<Coordinates = f64> + Hamiltonian<Double, Coordinates = Double>,
{
    assert!(!<S as geoint_runtime::private::Collocation>::EQUATION_ORDER.is_first(), "{function}: T is quadratic");
    let value = |q: Double| -> Double {
        let (q, p) = (phase::<S, Double>(q), phase::<S, Double>(Double::from(0.0)));
        system.hamiltonian(0.0.into(), &[q, p], &())
    };
    let (mut derivative, mut slope) = (0.0_f64, 0.0_f64);
    let mut noise = Noise::new(5);
    let mut next = move || noise.next().unwrap_or_default();
    for _ in 0..400 {
        let q = 0.5 * (low + high) + 0.49 * (high - low) * next();
        let exact = first(&value, q);
        // At a kink both one-sided derivatives are wrong.
        if !is_smooth(&value, q) {
            continue;
        }
        let size = exact.magnitude_of() + q.abs() * second(&value, q);
        derivative = derivative.max(error(force(&system, q), exact, size));
        for part in [0.0, 1e-14, 1e-10, 1e-6, 1e-3, 0.1, 0.5, 1.0] {
            let other = 0.5 * (low + high) + 0.49 * (high - low) * next();
            let d = part * (other - q);
            let end = Double::from(q) + Double::from(d);
            let exact = if d == 0.0 { exact } else { (value(end) - value(Double::from(q))) / Double::from(d) };
            let far = [q, q + 0.5 * d, q + d].map(|x| x.abs() * second(&value, x)).into_iter().fold(0.0, f64::max);
            let ends = [q, q + d].map(|x| first(&value, x).magnitude_of()).into_iter().fold(0.0, f64::max);
            slope = slope.max(error(divided(&system, q, d), exact, exact.magnitude_of().max(ends) + far));
        }
    }
    Row { function, derivative, slope }
}

/// The size of a double-double number.
trait Magnitude {
    fn magnitude_of(self) -> f64;
}

impl Magnitude for Double {
    fn magnitude_of(self) -> f64 {
        self.value().abs()
    }
}

fn phase<S: Hamiltonian<R>, R: geoint_runtime::Real>(x: R) -> S::Array {
    let mut array = S::Array::zero();
    array.as_mut_slice()[0] = x;
    array
}

fn error(found: f64, exact: Double, size: f64) -> f64 {
    (Double::from(found) - exact).magnitude_of() / (size * f64::EPSILON)
}

/// Step size of the differences. Their error is of order 10⁻²⁵.
const STEP: f64 = 1e-4;

/// Returns f' by differences of order 8.
fn first(value: &impl Fn(Double) -> Double, q: f64) -> Double {
    let at = |k: f64| value(Double::from(q) + Double::from(k * STEP));
    let weights = [(1.0, (4.0, 5.0)), (2.0, (-1.0, 5.0)), (3.0, (4.0, 105.0)), (4.0, (-1.0, 280.0))];
    let sum = weights.into_iter().fold(Double::from(0.0), |sum, (k, (above, below))| {
        sum + Double::from(above) / Double::from(below) * (at(k) - at(-k))
    });
    sum / Double::from(STEP)
}

/// Returns |f''| to a few digits.
fn second(value: &impl Fn(Double) -> Double, q: f64) -> f64 {
    let at = |k: f64| value(Double::from(q) + Double::from(k * STEP));
    ((at(1.0) - at(0.0) - (at(0.0) - at(-1.0))) / Double::from(STEP * STEP)).magnitude_of()
}

/// Returns whether no condition changes within the differences. Otherwise the derivatives on both sides of the point differ.
fn is_smooth(value: &impl Fn(Double) -> Double, q: f64) -> bool {
    let near = [-4.0, 4.0].map(|k| first(value, q + k * STEP).value());
    (near[0] - near[1]).abs() <= 0.1 * (near[0].abs() + near[1].abs() + 1e-2)
}

/// Returns the emitted ∂H/∂q.
fn force<S: Hamiltonian<Coordinates = f64>>(system: &S, q: f64) -> f64 {
    let mut slopes = S::Phase::zero();
    system.gradient(0.0, &[phase::<S, f64>(q), phase::<S, f64>(0.0)], &mut slopes);
    Array::as_slice(&slopes)[0]
}

/// Returns the emitted divided difference of H between q and q + d.
fn divided<S: DiscreteField>(system: &S, q: f64, d: f64) -> f64 {
    let array = |x: f64| {
        let mut array = S::Unknown::zero();
        array.as_mut_slice()[0] = x;
        array
    };
    let parameters = system.parameters(0.1);
    let start = system.begin(&parameters, Span::at(0.0), &array(q));
    let (mut f, mut jacobian) = (S::Unknown::zero(), S::Unknown::fill(S::Unknown::zero()));
    let rows: &mut Square<S::Unknown> = &mut jacobian;
    system.slope(&parameters, &start, &array(d), &mut f, rows);
    -f.as_slice()[0]
}

/// Writes the table of functions.
pub(crate) fn section(page: &mut Page) {
    page.section(
        2,
        "Functions of the language",
        "The energy is f(q) + p²/1.4. The derivative f'(q) and the divided difference f[q, q + d] are compared with differences in double-double \
         arithmetic, at 400 points. Increments d range from 0 over 10⁻¹⁴ to the whole range of q. Errors are in units of ε = 2.2·10⁻¹⁶, \
         relative to the value and to its change by a rounding of q.",
    );
    let rows = rows();
    for Row { function, derivative, slope } in &rows {
        page.claim(*derivative <= DERIVATIVE, format_args!("{function}: the derivative is off by {derivative:.1} ε"));
        page.claim(*slope <= SLOPE, format_args!("{function}: the divided difference is off by {slope:.1} ε"));
    }
    page.table(
        ["function", "derivative, ε", "divided difference, ε"],
        rows.iter().map(|row| [format!("`{}`", row.function), short(row.derivative), short(row.slope)]),
    );
}
