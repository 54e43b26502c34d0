//! Gauss collocation for every H.

use crate::array::Array;
use crate::method::{Claims, Method, NotConverged, Probe};
use crate::newton;
use crate::real::Real;
use crate::system::Collocation;
use crate::tableau::GaussTableau;

/// Gauss collocation with `S` stages, 1 to 6. Order 2S, symmetric, symplectic, for every H; keeps quadratic invariants.
///
/// One Newton solve a step for all stages together: of the positions alone if T is quadratic (Yᵢ = q₀ + cᵢh q'₀ +
/// h² Σ (A²)ᵢⱼ q''(Yⱼ)), else of positions and momenta (Yᵢ = y₀ + h Σ aᵢⱼ f(Yⱼ)). The reference for energies that are
/// not separable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gauss<const S: usize>;

/// Coefficients of one step.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, R, const S: usize> {
    system: P,
    h: R,
    /// hᵏAᵏ for y⁽ᵏ⁾ = f.
    coupling: [[R; S]; S],
    /// h·c.
    nodes: [R; S],
    /// h·b.
    weights: [R; S],
    /// Weights of f in the increment of y: h·b, or h²·b(1 − c).
    increments: [R; S],
}

impl<Y: Collocation<R>, R: Real, const S: usize> Method<Y, R> for Gauss<S>
where
    Gauss<S>: GaussTableau<S>,
{
    type Prepared = Prepared<Y::Prepared, R, S>;

    fn claims(&self) -> Claims {
        Claims { order: 2 * S as u32, symmetric: true, symplectic: true, conserves_energy: false }
    }

    fn prepare(&self, system: &Y, h: R) -> Self::Prepared {
        let tableau = Self::TABLEAU;
        let square = |i: usize, j: usize| (0..S).map(|k| tableau.a[i][k] * tableau.a[k][j]).sum::<f64>();
        let first_order = Y::DERIVATIVE == 1;
        let real = R::from_f64;
        Prepared {
            system: system.prepare(),
            h,
            coupling: core::array::from_fn(|i| {
                core::array::from_fn(|j| {
                    if first_order { real(tableau.a[i][j]) * h } else { real(square(i, j)) * h * h }
                })
            }),
            nodes: tableau.c.map(|c| real(c) * h),
            weights: tableau.b.map(|b| real(b) * h),
            increments: core::array::from_fn(|i| {
                let (b, c) = (tableau.b[i], tableau.c[i]);
                if first_order { real(b) * h } else { real(b * (1.0 - c)) * h * h }
            }),
        }
    }

    #[inline]
    fn step<P: Probe<Y, R>>(
        prepared: &Self::Prepared,
        t: R,
        q: &mut Y::Array,
        p: &mut Y::Array,
        probe: &mut P,
    ) -> Result<(), NotConverged> {
        let Prepared { system, h, coupling, nodes, weights, increments } = prepared;
        let n = Y::Unknown::LEN;
        let (y0, velocity) = Y::unknown(system, q, p);
        let (mut f, mut slope) = (Y::Unknown::zero(), Y::Unknown::fill(Y::Unknown::zero()));

        // The stage as an increment of y₀, from its derivatives at the start.
        probe.visit(t, q, p);
        Y::field(system, t, &y0, &mut f, &mut slope);
        let guess: [Y::Unknown; S] = core::array::from_fn(|i| {
            let quadratic = R::from_f64(0.5) * nodes[i] * nodes[i];
            let mut z = scaled(nodes[i], &velocity);
            add_scaled(&mut z, if Y::DERIVATIVE == 1 { nodes[i] } else { quadratic }, &f);
            z
        });

        let z = newton::solve(guess, [y0; S], |z, residual, jacobian| {
            *residual = *z;
            let rows = <[Y::Unknown; S]>::entries::<[Y::Unknown; S]>(jacobian);
            for j in 0..S {
                let mut y = y0;
                add_scaled(&mut y, R::from_f64(1.0), &z[j]);
                let (mut x, mut momenta) = (*q, *p);
                Y::advance(&z[j], &mut x, &mut momenta);
                probe.visit(t + nodes[j], &x, &momenta);
                Y::field(system, t + nodes[j], &y, &mut f, &mut slope);
                add_scaled(&mut residual[j], -nodes[j], &velocity);
                let slope_rows = Y::Unknown::entries::<Y::Unknown>(&mut slope);
                for i in 0..S {
                    add_scaled(&mut residual[i], -coupling[i][j], &f);
                    for r in 0..n {
                        let block = &mut rows[i * n + r][j];
                        *block = scaled(-coupling[i][j], &slope_rows[r]);
                        if i == j {
                            block.as_mut_slice()[r] += R::from_f64(1.0);
                        }
                    }
                }
            }
        })?;

        let mut increment = scaled(*h, &velocity);
        for j in 0..S {
            let mut y = y0;
            add_scaled(&mut y, R::from_f64(1.0), &z[j]);
            Y::field(system, t + nodes[j], &y, &mut f, &mut slope);
            add_scaled(&mut increment, increments[j], &f);
            Y::impulse(system, t + nodes[j], weights[j], &y, p);
        }
        Y::advance(&increment, q, p);
        Ok(())
    }
}

#[inline(always)]
fn scaled<A: Array>(w: A::Real, x: &A) -> A {
    let mut y = A::zero();
    add_scaled(&mut y, w, x);
    y
}

/// y ← y + w·x.
#[inline(always)]
fn add_scaled<A: Array>(y: &mut A, w: A::Real, x: &A) {
    for (y, x) in y.as_mut_slice().iter_mut().zip(x.as_slice()) {
        *y = w.multiply_add(*x, *y);
    }
}

