//! Error estimate of a Gauss step from the defect of its collocation polynomial.
//!
//! Collocation finds a polynomial u with u' = f(u) at the nodes cᵢ. At other times u has a defect δ = f(u) − u'. The defect is the product of M(x) = Π
//! (x − cᵢ) and another function. The error of the step is ∫ R δ, where R propagates a defect to the end of the step. M is orthogonal to all
//! polynomials of lower degree. The error therefore contains two terms of order h²ˢ⁺¹, the first for R = 1 and the second for δ/M = const:
//!
//! h δ[c₁, …, c_s, x₀, …, x_s] ∫M² and (hJ)ˢ D (s!)³/((2s)!(2s+1)!), with D = h δ/M at the ends.
//!
//! The first term is the whole error if f depends on time alone. The second term is the whole error if f is linear. The estimate adds the magnitudes of
//! both terms, so that they do not cancel. Any other f has intermediate terms of equal order. No order is extrapolated from others. The estimate
//! detects a vibration that is small beside a slow motion by the action of f on the vibration.
//!
//! If h is long beside the fastest motion, J = f' at the start would let a defect grow without bounds. The defect of a Gauss method does not grow in
//! this way. The estimate therefore replaces hJ by hJ(1 − γhJ)⁻¹, and multiplies defects by (1 − γhJ)⁻¹. Here γ = 1/2s is the mean eigenvalue of the
//! coefficients A. Estimates are filtered in this way by E. Hairer & G. Wanner, *Solving Ordinary Differential Equations II* (1996), section IV.8.

use super::{Gauss, GaussTableau};
use crate::method::explicit::tableau::Tableau;
use crate::scalar::Real;
use crate::solving::linear;
use crate::solving::size::Sizes;
use crate::space::vector::{difference, dot, scaled};
use crate::space::{Array, Square};
use crate::system::Collocation;

/// Point of a step at which the defect is evaluated.
#[derive(Clone, Copy)]
struct Look<const S: usize> {
    /// Position as a fraction of the step.
    at: f64,
    /// Coefficients in u' = Σ rates·k.
    rates: [f64; S],
    /// First row: coefficients in u = y₀ + h Σ changes·k. Second row, for f = y'' in place of y': q₀ + hx q'₀ + h² Σ changes·M⁻¹k.
    changes: [[f64; S]; 2],
    /// Weights of δ in hδ[…]∫M² and in D.
    weights: [f64; 2],
}

/// All points of a step, and the coefficients of both parts of the error.
struct Looks<const S: usize> {
    start: Look<S>,
    others: [Look<S>; S],
    /// Weights of k in the highest coefficient of the polynomial of p, if f is y''. The defect of q' is this coefficient times M(x).
    highest: [f64; S],
    /// Factor of an error, 4ˢ. The error of the two halves of a step is smaller by this factor than the estimate that judges them. For orbits of
    /// Kepler, of Hénon and Heiles, and others, errors are a tenth of the product at most, while h is shorter than a vibration
    /// (`tests/benches/README.md`).
    margin: f64,
    /// (s!)³/((2s)!(2s+1)!), for γhJ in place of hJ.
    linear: f64,
}

impl<const S: usize> Looks<S> {
    /// γ.
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
        let square = s * s / twice * (s * s / next);
        let start = Look::new(tableau, 0, square);
        let (mut others, mut linear, mut margin, mut i) = ([start; S], s * s / twice * (s / next), 1.0, 0);
        let mut highest = [1.0 / S as f64; S];
        while i < S {
            others[i] = Look::new(tableau, i + 1, square);
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
        Looks { start, others, highest, margin, linear }
    }
}

impl<const S: usize> Look<S> {
    /// Returns the `i`-th point: the start, the middle between two nodes, or the end.
    const fn place(c: &[f64; S], i: usize) -> f64 {
        match i {
            0 => 0.0,
            _ if i == S => 1.0,
            _ => 0.5 * (c[i - 1] + c[i]),
        }
    }

    const fn new(Tableau { a, b, c }: &Tableau<S>, i: usize, square: f64) -> Self {
        let at = Self::place(c, i);
        let (mut rates, mut changes, mut monic, mut j) = ([0.0; S], [[0.0; S]; 2], 1.0, 0);
        while j < S {
            rates[j] = lagrange(c, j, at);
            // Integral from 0 to x, by the weights of the method.
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
        let (mut others, mut n) = (1.0, 0);
        while n <= S {
            if n != i {
                others *= at - Self::place(c, n);
            }
            n += 1;
        }
        let end = if i == 0 || i == S { 0.5 / monic } else { 0.0 };
        Look { at, rates, changes, weights: [square / (monic * others), end] }
    }

    /// Adds the contribution of hδ to both parts of the error. Returns f', which is computed only where it is used.
    #[inline(always)]
    fn add<Y: Collocation<R>, R: Real>(
        &self,
        h: R,
        k: &[Y::Unknown; S],
        at: &mut impl FnMut(R, &[f64; S]) -> (Y::Unknown, Square<Y::Unknown>),
        sums: &mut [Y::Unknown; 2],
    ) -> Square<Y::Unknown> {
        let (mut defect, slope) = at(R::from_f64(self.at) * h, &self.changes[Y::DERIVATIVE - 1]);
        for (rate, k) in self.rates.iter().zip(k) {
            defect.add_scaled(R::from_f64(-rate), k);
        }
        for (sum, weight) in sums.iter_mut().zip(self.weights) {
            sum.add_scaled(R::from_f64(weight) * h, &defect);
        }
        slope
    }
}

/// Returns the value at `x` of the polynomial that is 1 at the node `j` and 0 at the other nodes.
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

/// Errors of y, and of the momenta if y holds positions alone.
type Errors<Y, R> = [<Y as Collocation<R>>::Unknown; 2];

/// (1 − γhJ)⁻¹.
struct Filter<'a, Y: Collocation<R>, R: Real> {
    system: &'a Y,
    constants: &'a Y::Constants,
    /// γh.
    length: R,
    slope: Square<Y::Unknown>,
    sizes: Sizes<Y::Unknown>,
}

impl<Y: Collocation<R>, R: Real> Filter<'_, Y, R> {
    /// Multiplies errors by (1 − γhJ)⁻¹. Returns `None` if the matrix is singular.
    #[inline(always)]
    fn times(&self, [y, p]: &Errors<Y, R>) -> Option<Errors<Y, R>> {
        let mut matrix = Y::Unknown::fill(Y::Unknown::zero());
        let w = if Y::DERIVATIVE == 1 { self.length } else { self.length * self.length };
        let mut x = if Y::DERIVATIVE == 1 { *y } else { *p };
        let rows = Y::Unknown::entries::<Y::Unknown>(&mut matrix).iter_mut();
        for (i, (row, slope)) in rows.zip(Y::Unknown::entries_of::<Y::Unknown>(&self.slope)).enumerate() {
            self.system.add(self.constants, -w, slope, row);
            row.as_mut_slice()[i] += R::from_f64(1.0);
            if Y::DERIVATIVE > 1 {
                x.as_mut_slice()[i] += self.length * dot(slope, y);
            }
        }
        linear::solve(&mut matrix, &mut x, &self.sizes)?;
        if Y::DERIVATIVE == 1 {
            return Some([x, *p]);
        }
        let mut position = *y;
        self.system.add(self.constants, self.length, &x, &mut position);
        Some([position, x])
    }

    /// Returns the errors of all coordinates that follow from an error of the quantity that f changes.
    #[inline(always)]
    fn spread(&self, x: Y::Unknown) -> Errors<Y, R> {
        let mut y = if Y::DERIVATIVE == 1 { x } else { Y::Unknown::zero() };
        if Y::DERIVATIVE > 1 {
            self.system.add(self.constants, self.length, &x, &mut y);
        }
        [y, x]
    }
}

/// A step of a system.
pub(super) struct Step<'a, Y: Collocation<R>, R: Real> {
    pub(super) system: &'a Y,
    pub(super) constants: &'a Y::Constants,
    pub(super) h: R,
    /// Quantity to which h·k is added.
    pub(super) changed: &'a Y::Unknown,
}

/// Estimates the error of a step from the values `k` of f at its stages. Returns `None` if a motion away from the solution is so fast that there is no
/// estimate.
///
/// `at` takes a time and coefficients of k. It returns f and f' on the polynomial of the step after this time.
#[inline]
pub(super) fn error<Y: Collocation<R>, R: Real, const S: usize>(
    Step { system, constants, h, changed }: Step<'_, Y, R>,
    k: &[Y::Unknown; S],
    mut at: impl FnMut(R, &[f64; S]) -> (Y::Unknown, Square<Y::Unknown>),
) -> Option<Y::Phase>
where
    Gauss<S>: GaussTableau<S>,
{
    let looks = const { &Looks::<S>::new(&Gauss::<S>::TABLEAU) };
    let (zero, number) = (Y::Unknown::zero(), R::from_f64);
    let mut sums = [zero; 2];
    let slope = looks.start.add::<Y, R>(h, k, &mut at, &mut sums);
    for other in &looks.others {
        other.add::<Y, R>(h, k, &mut at, &mut sums);
    }
    let [quadrature, ends] = sums;

    let mut sizes = Sizes::new();
    sizes.include(changed, &scaled(h, &k[0]));
    let filter = Filter { system, constants, length: number(Looks::<S>::GAMMA) * h, slope, sizes };
    let first = filter.times(&if Y::DERIVATIVE == 1 { [quadrature, zero] } else { [zero, quadrature] })?;
    let mut second = if Y::DERIVATIVE == 1 { [ends, zero] } else { [zero, ends] };
    if Y::DERIVATIVE > 1 {
        for (weight, k) in looks.highest.iter().zip(k) {
            system.add(constants, number(*weight) * h * h, k, &mut second[0]);
        }
    }
    for _ in 0..S {
        // γhJ(1 − γhJ)⁻¹.
        let filtered = filter.times(&second)?;
        second = [difference(&filtered[0], &second[0]), difference(&filtered[1], &second[1])];
    }
    // Each h·k is known up to its last digit.
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
        let found = first + number(looks.linear) * second - rounding;
        // NaN stays NaN.
        *error = if found.any_below(0.0) { number(0.0) } else { number(looks.margin) * found };
    }
    Some(error)
}
