//! Values, gradients and Jacobians of every problem by second routes.
//!
//! Values are compared with the function as the user wrote it. Gradients are compared with dual numbers in the value kernel and with differences of
//! the user's function. Second derivatives are compared with dual numbers in the kernel of first derivatives.

use geoint_runtime::private::{Collocation, DiscreteField, Span};
use geoint_runtime::space::Array;
use geoint_runtime::{Hamiltonian, Real};
use geoint_tests::for_each_problem;
use geoint_tests::measure::Noise;
use geoint_tests::problems::*;
use geoint_tests::scalars::Dual;

/// The bound on a difference of two numbers that are the same up to rounding, in units of the larger and of 1.
pub(crate) fn assert_near(what: &str, a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance * a.abs().max(1.0), "{what}: {a:e} and {b:e} differ by {:.1e}", (a - b).abs());
}

fn array<A: Array>(x: &[A::Real]) -> A {
    let mut array = A::zero();
    array.as_mut_slice().copy_from_slice(x);
    array
}

/// Dual numbers: the entry `seed` is the variable, all others are constants.
fn seeded(x: &[f64], seed: usize) -> Vec<Dual> {
    x.iter().enumerate().map(|(i, x)| if i == seed { Dual::variable(*x) } else { Dual::from(*x) }).collect()
}

/// A kernel of first derivatives: ∂H/∂q, ∂H/∂p.
pub(crate) fn gradient<S: Hamiltonian<R>, R: Real>(system: &S, t: f64, q: &[R], p: &[R]) -> Vec<R> {
    let mut slopes = S::Phase::zero();
    system.gradient(R::from_f64(t), &[array(q), array(p)], &mut slopes);
    Array::as_slice(&slopes).to_vec()
}

/// H and ∇H at a point.
pub(crate) fn check_gradient<S, D>(
    plain: &S,
    dual: &D,
    written: &dyn Fn(&[f64], &[f64]) -> f64,
    t: f64,
    q: &[f64],
    p: &[f64],
) where
    S: Hamiltonian<f64>,
    D: Hamiltonian<Dual>,
{
    let n = q.len();
    let value = plain.hamiltonian(t, &[array(q), array(p)], &());
    assert_near("H", value, written(q, p), 16.0 * f64::EPSILON);
    let x = [q, p].concat();
    for (i, slope) in gradient(plain, t, q, p).into_iter().enumerate() {
        let y = seeded(&x, i);
        let kernel = dual.hamiltonian(t.into(), &[array(&y[..n]), array(&y[n..])], &());
        assert_near("∇H and dual numbers", slope, kernel.derivative(), 1e-13);
        // Differences of order 8.
        let h = 1e-3;
        let at = |k: f64| {
            let mut y = x.clone();
            y[i] += k * h;
            written(&y[..n], &y[n..])
        };
        let difference: f64 = [(1.0, 4.0 / 5.0), (2.0, -1.0 / 5.0), (3.0, 4.0 / 105.0), (4.0, -1.0 / 280.0)]
            .iter()
            .map(|(k, weight)| weight * (at(*k) - at(-k)) / h)
            .sum();
        assert_near("∇H and differences", slope, difference, 1e-10);
    }
}

/// The field of collocation and its Jacobian at a point.
pub(crate) fn check_field<S: Collocation<f64> + Hamiltonian<f64>, D: Collocation<Dual> + Hamiltonian<Dual>>(
    plain: &S,
    dual: &D,
    t: f64,
    q: &[f64],
    p: &[f64],
) {
    let n = q.len();
    let constants = plain.constants();
    let (y, changed) = S::start(&[array(q), array(p)]);
    let velocity = plain.velocity(&constants, &changed);
    let (mut f, mut jacobian) = (S::Unknown::zero(), S::Unknown::fill(S::Unknown::zero()));
    plain.field(&constants, t, &y, &mut f, &mut jacobian);

    // The field is (∂H/∂p, −∂H/∂q), or the force alone and then q' is known.
    let slopes = gradient(plain, t, q, p);
    let force = slopes[..n].iter().map(|x| -x);
    let expected: Vec<f64> =
        if S::EQUATION_ORDER.is_first() { slopes[n..].iter().copied().chain(force).collect() } else { force.collect() };
    for (f, expected) in f.as_slice().iter().zip(&expected) {
        assert_near("the field", *f, *expected, 1e-13);
    }

    let constants = dual.constants();
    let rows = S::Unknown::entries::<S::Unknown>(&mut jacobian);
    for column in 0..S::Unknown::LEN {
        let along: D::Unknown = array(&seeded(y.as_slice(), column));
        let (mut f, mut unused) = (D::Unknown::zero(), D::Unknown::fill(D::Unknown::zero()));
        dual.field(&constants, t.into(), &along, &mut f, &mut unused);
        for (row, f) in rows.iter().zip(f.as_slice()) {
            assert_near("the Jacobian of the field", row.as_slice()[column], f.derivative(), 1e-12);
        }
        if !S::EQUATION_ORDER.is_first() {
            assert_near("q'", velocity.as_slice()[column], slopes[n + column], 1e-14);
            let mut along: D::Unknown = array(&seeded(y.as_slice(), usize::MAX));
            let mut unit = D::Unknown::zero();
            unit.as_mut_slice()[column] = 1.0.into();
            dual.add(&constants, Dual::variable(0.0), &unit, &mut along);
            let x = seeded(&[q, p].concat(), n + column);
            let rates = gradient(dual, t, &x[..n], &x[n..]);
            for (along, rate) in along.as_slice().iter().zip(&rates[n..]) {
                assert_near("M⁻¹", along.derivative(), rate.derivative(), 1e-13);
            }
        }
    }
}

/// The Jacobian of the field with divided differences.
fn check_discrete_field<S, D>(plain: &S, dual: &D, t: f64, q: &[f64], p: &[f64], noise: &mut Noise)
where
    S: DiscreteField<f64>,
    D: DiscreteField<Dual>,
{
    let y = &[q, p].concat()[..S::Unknown::LEN];
    let h = 0.3;
    let parameters = plain.parameters(h);
    let start = plain.begin(&parameters, Span::of([t, t + h], h), &array(y));
    let at = |size: f64, noise: &mut Noise| {
        let increment: Vec<f64> = noise.take(y.len()).map(|x| size * x).collect();
        let (mut f, mut jacobian) = (S::Unknown::zero(), S::Unknown::fill(S::Unknown::zero()));
        plain.slope(&parameters, &start, &array(&increment), &mut f, &mut jacobian);
        let rows = S::Unknown::entries::<S::Unknown>(&mut jacobian).iter();
        (increment, rows.flat_map(|row| row.as_slice().to_vec()).collect::<Vec<f64>>())
    };
    let (increment, rows) = at(0.1, noise);
    let parameters = dual.parameters(h.into());
    let start = dual.begin(&parameters, Span::of([t, t + h].map(Dual::from), h.into()), &array(&seeded(y, usize::MAX)));
    for column in 0..y.len() {
        let (mut f, mut unused) = (D::Unknown::zero(), D::Unknown::fill(D::Unknown::zero()));
        dual.slope(&parameters, &start, &array(&seeded(&increment, column)), &mut f, &mut unused);
        for (row, f) in f.as_slice().iter().enumerate() {
            assert_near("the Jacobian between two points", rows[row * y.len() + column], f.derivative(), 1e-12);
        }
    }
    check_equation::<S, D>((plain, dual), h, (t, q, p), &increment);
    // At equal ends there is no 0/0 and no jump.
    let (_, met) = at(0.0, noise);
    let (_, near) = at(1e-9, noise);
    for (met, near) in met.iter().zip(&near) {
        assert_near("the Jacobian where both ends meet", *met, *near, 1e-7);
    }
}

/// The equation of a step: h·f̄ from f̄, and Newton's matrix by derivatives with respect to the impulse.
fn check_equation<S, D>((plain, dual): (&S, &D), h: f64, (t, q, p): (f64, &[f64], &[f64]), impulse: &[f64])
where
    S: DiscreteField<f64>,
    D: DiscreteField<Dual>,
{
    let y = &[q, p].concat()[..S::Unknown::LEN];
    let (parameters, exact) = (plain.parameters(h), dual.parameters(h.into()));
    let sum: Vec<f64> = p.iter().zip(impulse).map(|(p, impulse)| 2.0 * p + impulse).collect();
    let first_order = S::EQUATION_ORDER.is_first();
    let d: S::Unknown = if first_order { array(impulse) } else { plain.drift(&parameters, &array(&sum)) };
    let (mut f, mut image) = (S::Unknown::zero(), S::Unknown::zero());
    let mut matrix = S::Unknown::fill(S::Unknown::zero());
    let start = plain.begin(&parameters, Span::of([t, t + h], h), &array(y));
    plain.slope(&parameters, &start, &d, &mut f, &mut matrix);
    plain.equation((&plain.constants(), h), &parameters, &start, &d, &mut image, &mut matrix);
    for (f, image) in f.as_slice().iter().zip(image.as_slice()) {
        assert_near("h times the field between two points", *image, h * f, 1e-14);
    }
    let rows: Vec<f64> =
        S::Unknown::entries::<S::Unknown>(&mut matrix).iter().flat_map(|row| row.as_slice().to_vec()).collect();
    let start = dual.begin(&exact, Span::of([t, t + h].map(Dual::from), h.into()), &array(&seeded(y, usize::MAX)));
    for column in 0..y.len() {
        let seeds: Vec<Dual> = seeded(impulse, column);
        let sum: Vec<Dual> = seeded(p, usize::MAX).into_iter().zip(&seeds).map(|(p, x)| p + p + *x).collect();
        let d: D::Unknown = if first_order { array(&seeds) } else { dual.drift(&exact, &array(&sum)) };
        let (mut f, mut unused) = (D::Unknown::zero(), D::Unknown::fill(D::Unknown::zero()));
        dual.slope(&exact, &start, &d, &mut f, &mut unused);
        for (row, f) in f.as_slice().iter().enumerate() {
            let expected = f64::from(u8::from(row == column)) - h * f.derivative();
            assert_near("Newton's matrix", rows[row * y.len() + column], expected, 1e-12);
        }
    }
}

/// Points around the start of a problem, at times that are no multiples of anything.
fn points<P: Problem>(mut check: impl FnMut(f64, &[f64], &[f64], &mut Noise)) {
    let mut noise = Noise::new(7);
    for i in 0..25 {
        let mut near = |x: &[f64]| x.iter().zip(&mut noise).map(|(x, r)| x + 0.15 * r).collect::<Vec<f64>>();
        let (q, p) = (near(P::START.0), near(P::START.1));
        check(0.37 * f64::from(i), &q, &p, &mut noise);
    }
}

fn check<P: Problem>() {
    let (plain, dual) = (P::system::<f64>(), P::system::<Dual>());
    points::<P>(|t, q, p, _| {
        check_gradient(&plain, &dual, &|q, p| P::written(t, q, p), t, q, p);
        check_field(&plain, &dual, t, q, p);
    });
}

fn check_discrete_gradient<P: Problem>()
where
    P::Over<f64>: DiscreteField<f64>,
    P::Over<Dual>: DiscreteField<Dual>,
{
    let (plain, dual) = (P::system::<f64>(), P::system::<Dual>());
    points::<P>(|t, q, p, noise| check_discrete_field(&plain, &dual, t, q, p, noise));
}

#[test]
fn every_problem() {
    macro_rules! call {
        ($System:ident) => {
            check::<$System>();
        };
    }
    for_each_problem!(call);
}

#[test]
fn every_discrete_gradient() {
    macro_rules! call {
        ($System:ident) => {
            check_discrete_gradient::<$System>();
        };
    }
    for_each_problem!(call);
}

/// The checks see a derivative that is wrong in the seventh digit.
#[test]
#[should_panic(expected = "∇H")]
fn a_wrong_derivative_is_seen() {
    let (plain, dual) =
        (Pendulum::system::<f64>(), Pendulum { m: 1.3.into(), l: 0.7.into(), g: Dual::from(9.81 * (1.0 + 1e-7)) });
    check_gradient(&plain, &dual, &|q, p| Pendulum::written(0.0, q, p), 0.0, &[1.0], &[0.3]);
}
