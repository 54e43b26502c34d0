//! Error estimate of a Gauss step from the defect of its collocation polynomial.
//!
//! Let x from 0 to 1 be the time in the step in units of h, and s the number of stages. Collocation finds a polynomial u of the time with u' = f(u) at the
//! nodes cᵢ, where a prime is d/dt. Between the nodes, u has the defect δ = f(u) − u'. The defect is the product of N(x) = Π (x − cᵢ) and a smooth function.
//! The error of the step is h ∫ R δ dx, where R(x) propagates a small change at x to the end of the step. N is orthogonal to all polynomials of lower degree.
//! The error therefore contains two terms of order h²ˢ⁺¹:
//!
//! - h δ[c₁, …, c_s, x₀, …, x_s] ∫N² dx, for R = 1. The bracket is the divided difference of δ at the nodes, where δ = 0, and at the points of [`Sample`].
//! - (hJ)ˢ D (s!)³/((2s)!(2s+1)!), for constant δ/N. J = ∂f/∂u at the start, and D is the mean of h δ/N at both ends of the step.
//!
//! The first term is the leading error if f depends on time alone. The second term is the leading error if f is linear. The estimate adds the magnitudes
//! of both terms, so that they do not cancel. Any other f has further terms of this order, which the estimate leaves out: [`Samples::margin`] covers them in
//! tests, without a proof. The estimate detects a vibration that is small beside a slow motion by the action of f on the vibration.
//!
//! If h is long beside the fastest motion, powers of hJ grow without bounds. The error of a Gauss method does not. The estimate therefore replaces hJ by
//! hJ(1 − γhJ)⁻¹, and multiplies defects by (1 − γhJ)⁻¹. Here γ = 1/2s is the mean eigenvalue of the coefficients A. E. Hairer & G. Wanner filter estimates
//! in this way: *Solving Ordinary Differential Equations II* (1996), section IV.8.

use super::{Gauss, GaussTableau};
use crate::method::explicit::tableau::Tableau;
use crate::scalar::Real;
use crate::solving::linear;
use crate::solving::size::Sizes;
use crate::space::vector::{difference, dot, scaled};
use crate::space::{Array, Square};
use crate::system::Collocation;

/// A point x of the step at which the defect is evaluated, and its coefficients. k are the values of f at the stages, and sums are over the stages.
#[derive(Clone, Copy)]
struct Sample<const S: usize> {
    /// x.
    position: f64,
    /// Coefficients in u' = Σ rates·k, or in p' for q'' = M⁻¹f.
    rates: [f64; S],
    /// First row: coefficients in u = y₀ + h Σ changes·k. Second row, for q'' = M⁻¹f: u = q₀ + hx q'₀ + h² Σ changes·M⁻¹k.
    changes: [[f64; S]; 2],
    /// Weights of hδ at this point in the first term of the error, and in D.
    weights: [f64; 2],
}

/// All points x₀, …, x_s of a step, and the coefficients of both terms of the error.
struct Samples<const S: usize> {
    start: Sample<S>,
    others: [Sample<S>; S],
    /// For q'' = M⁻¹f: weights of h·k in the highest coefficient of the polynomial of p. The defect of q' is N(x) M⁻¹ times this coefficient.
    highest: [f64; S],
    /// Factor of the estimate, 4ˢ. The estimate is then as cautious as step halving, which takes the difference of one step and two half steps for the error
    /// of the half steps. This error is smaller by 4ˢ. For orbits of Kepler, of Hénon and Heiles, and others, errors are a tenth of the result at most, while
    /// h is shorter than a vibration (`tests/benches/README.md`).
    margin: f64,
    /// (s!)³/((2s)!(2s+1)!)/γˢ: the factor of (γhJ)ˢ D in the second term.
    linear: f64,
}

impl<const S: usize> Samples<S> {
    /// γ, the mean eigenvalue of A. The trace of A is 1/2.
    const GAMMA: f64 = 0.5 / S as f64;

    const fn new(tableau: &Tableau<S>) -> Self {
        // s!, (2s)! and (2s+1)!.
        let (mut factorials, mut n) = ([1.0; 3], 1);
        while n <= 2 * S + 1 {
            let mut which = 0;
            while which < 3 {
                if n <= [S, 2 * S, 2 * S + 1][which] {
                    factorials[which] *= n as f64;
                }
                which += 1;
            }
            n += 1;
        }
        let [s, twice, next] = factorials;
        // ∫N² dx.
        let square = s * s / twice * (s * s / next);
        let start = Sample::new(tableau, 0, square);
        let (mut others, mut linear, mut margin, mut i) = ([start; S], s * s / twice * (s / next), 1.0, 0);
        let mut highest = [1.0 / S as f64; S];
        while i < S {
            others[i] = Sample::new(tableau, i + 1, square);
            let mut n = 0;
            while n < S {
                if n != i {
                    highest[i] /= tableau.c[i] - tableau.c[n];
                }
                n += 1;
            }
            linear /= Self::GAMMA;
            margin *= 4.0;
            i += 1;
        }
        Samples { start, others, highest, margin, linear }
    }
}

impl<const S: usize> Sample<S> {
    /// Returns the point xᵢ: the start, the middle between two nodes, or the end.
    const fn place(c: &[f64; S], i: usize) -> f64 {
        match i {
            0 => 0.0,
            _ if i == S => 1.0,
            _ => 0.5 * (c[i - 1] + c[i]),
        }
    }

    /// Returns the point xᵢ with its coefficients. `square` is ∫N² dx.
    const fn new(Tableau { a, b, c }: &Tableau<S>, i: usize, square: f64) -> Self {
        let at = Self::place(c, i);
        // `monic` becomes N(x), which has the leading coefficient 1.
        let (mut rates, mut changes, mut monic, mut j) = ([0.0; S], [[0.0; S]; 2], 1.0, 0);
        while j < S {
            rates[j] = lagrange(c, j, at);
            // The integral of the polynomial from 0 to x, by the quadrature of the method, which is exact.
            let mut n = 0;
            while n < S {
                changes[0][j] += at * b[n] * lagrange(c, j, at * c[n]);
                n += 1;
            }
            monic *= at - c[j];
            j += 1;
        }
        j = 0;
        while j < S {
            let mut n = 0;
            while n < S {
                changes[1][j] += changes[0][n] * a[n][j];
                n += 1;
            }
            j += 1;
        }
        // Π (xᵢ − xₙ) over the other points: the denominator of a divided difference.
        let (mut others, mut n) = (1.0, 0);
        while n <= S {
            if n != i {
                others *= at - Self::place(c, n);
            }
            n += 1;
        }
        let end = if i == 0 || i == S { 0.5 / monic } else { 0.0 };
        Sample { position: at, rates, changes, weights: [square / (monic * others), end] }
    }

    /// Adds the contribution of hδ at this point to `sums`: the first term of the error, and D. Returns f' = ∂f/∂y. The compiler drops its computation if
    /// the caller ignores it. `at` is that of [`error`].
    #[inline(always)]
    fn add<Y: Collocation<R>, R: Real>(
        &self,
        h: R,
        k: &[Y::Unknown; S],
        at: &mut impl FnMut(R, &[f64; S]) -> (Y::Unknown, Square<Y::Unknown>),
        sums: &mut [Y::Unknown; 2],
    ) -> Square<Y::Unknown> {
        let (mut defect, slope) =
            at(R::from_f64(self.position) * h, &self.changes[if Y::EQUATION_ORDER.is_first() { 0 } else { 1 }]);
        for (rate, k) in self.rates.iter().zip(k) {
            defect.add_scaled(R::from_f64(-rate), k);
        }
        for (sum, weight) in sums.iter_mut().zip(self.weights) {
            sum.add_scaled(R::from_f64(weight) * h, &defect);
        }
        slope
    }
}

/// Returns the value at `x` of the Lagrange polynomial that is 1 at the node `j` and 0 at the other nodes.
const fn lagrange<const S: usize>(c: &[f64; S], j: usize, x: f64) -> f64 {
    let (mut value, mut n) = (1.0, 0);
    while n < S {
        if n != j {
            value *= (x - c[n]) / (c[j] - c[n]);
        }
        n += 1;
    }
    value
}

/// Errors of y, and of the momenta if y holds positions alone. The second entry is not used if y holds all coordinates.
type Errors<Y, R> = [<Y as Collocation<R>>::Unknown; 2];

/// The filter (1 − γhJ)⁻¹, with the Jacobian J of the equation of first order. For q'' = M⁻¹f, positions are eliminated: the matrix for p is
/// 1 − (γh)² ∂f/∂q M⁻¹.
struct Filter<'a, Y: Collocation<R>, R: Real> {
    system: &'a Y,
    coefficients: &'a Y::Constants,
    /// γh.
    length: R,
    /// ∂f/∂y at the start of the step.
    slope: Square<Y::Unknown>,
    /// The sizes of the coordinates that f changes, for the choice of pivots.
    sizes: Sizes<Y::Unknown>,
}

impl<Y: Collocation<R>, R: Real> Filter<'_, Y, R> {
    /// Returns the product of (1 − γhJ)⁻¹ and errors, or `None` if 1 − γhJ is singular.
    #[inline(always)]
    fn times(&self, [y, p]: &Errors<Y, R>) -> Option<Errors<Y, R>> {
        let mut matrix = Y::Unknown::fill(Y::Unknown::zero());
        let w = if Y::EQUATION_ORDER.is_first() { self.length } else { self.length * self.length };
        let mut x = if Y::EQUATION_ORDER.is_first() { *y } else { *p };
        let rows = Y::Unknown::entries::<Y::Unknown>(&mut matrix).iter_mut();
        for (i, (row, slope)) in rows.zip(Y::Unknown::entries_of::<Y::Unknown>(&self.slope)).enumerate() {
            self.system.add(self.coefficients, -w, slope, row);
            row.as_mut_slice()[i] += R::from_f64(1.0);
            if !Y::EQUATION_ORDER.is_first() {
                x.as_mut_slice()[i] += self.length * dot(slope, y);
            }
        }
        linear::solve(&mut matrix, &mut x, &self.sizes)?;
        if Y::EQUATION_ORDER.is_first() {
            return Some([x, *p]);
        }
        let mut position = *y;
        self.system.add(self.coefficients, self.length, &x, &mut position);
        Some([position, x])
    }

    /// Returns the errors of all coordinates that follow from the error `x` of the quantity that f changes. An error of p shifts q by γh M⁻¹x.
    #[inline(always)]
    fn spread(&self, x: Y::Unknown) -> Errors<Y, R> {
        let mut y = if Y::EQUATION_ORDER.is_first() { x } else { Y::Unknown::zero() };
        if !Y::EQUATION_ORDER.is_first() {
            self.system.add(self.coefficients, self.length, &x, &mut y);
        }
        [y, x]
    }
}

/// The step whose error is estimated.
pub(super) struct Step<'a, Y: Collocation<R>, R: Real> {
    pub(super) system: &'a Y,
    pub(super) coefficients: &'a Y::Constants,
    pub(super) h: R,
    /// The coordinates that f changes, at the start: y, or the momenta.
    pub(super) changed: &'a Y::Unknown,
}

/// Returns a magnitude for the error of each coordinate after a step, from the values `k` of f at its stages. Returns `None` if 1 − γhJ is singular. A
/// solution then grows by more than a step resolves.
///
/// `at` takes the time after the start of the step, and the row of [`Sample::changes`] for the form of the equation. It returns f and ∂f/∂y on the
/// polynomial u.
#[inline]
pub(super) fn error<Y: Collocation<R>, R: Real, const S: usize>(
    Step { system, coefficients, h, changed }: Step<'_, Y, R>,
    k: &[Y::Unknown; S],
    mut at: impl FnMut(R, &[f64; S]) -> (Y::Unknown, Square<Y::Unknown>),
) -> Option<Y::Phase>
where
    Gauss<S>: GaussTableau<S>,
{
    let samples = const { &Samples::<S>::new(&Gauss::<S>::TABLEAU) };
    let (zero, number) = (Y::Unknown::zero(), R::from_f64);
    let mut sums = [zero; 2];
    let slope = samples.start.add::<Y, R>(h, k, &mut at, &mut sums);
    for other in &samples.others {
        other.add::<Y, R>(h, k, &mut at, &mut sums);
    }
    let [quadrature, ends] = sums;

    let sizes = Sizes::along([changed, &scaled(h, &k[0])]);
    let filter = Filter { system, coefficients, length: number(Samples::<S>::GAMMA) * h, slope, sizes };
    let first = filter.times(&if Y::EQUATION_ORDER.is_first() { [quadrature, zero] } else { [zero, quadrature] })?;
    let mut second = if Y::EQUATION_ORDER.is_first() { [ends, zero] } else { [zero, ends] };
    if !Y::EQUATION_ORDER.is_first() {
        for (weight, k) in samples.highest.iter().zip(k) {
            system.add(coefficients, number(*weight) * h * h, k, &mut second[0]);
        }
    }
    for _ in 0..S {
        // γhJ(1 − γhJ)⁻¹ = (1 − γhJ)⁻¹ − 1.
        let filtered = filter.times(&second)?;
        second = [difference(&filtered[0], &second[0]), difference(&filtered[1], &second[1])];
    }
    // The last digit of each h·k is rounding, which is no error of the method.
    let mut digits = zero;
    for k in k {
        for (digit, k) in digits.as_mut_slice().iter_mut().zip(k.as_slice()) {
            *digit = digit.max((*k * h).abs() * number(R::epsilon()));
        }
    }
    let rounding = filter.spread(digits);
    let [first, second, rounding] = [first, second, rounding].map(|[y, p]| Y::increments(&y, &p));
    let mut error = Y::Phase::zero();
    for (i, error) in error.as_mut_slice().iter_mut().enumerate() {
        let [first, second, rounding] = [&first, &second, &rounding].map(|part| part.as_slice()[i].abs());
        let found = first + number(samples.linear) * second - rounding;
        // NaN stays NaN.
        *error = if found.any_below(0.0) { number(0.0) } else { number(samples.margin) * found };
    }
    Some(error)
}
