//! Gauss collocation, the implicit midpoint rule among it, for every H.

use crate::array::Array;
use crate::composition::{Composed, Composition, SymmetricMap};
use crate::method::{Claims, Method, NotConverged, Probe};
use crate::newton;
use crate::real::Real;
use crate::system::Collocation;
use crate::tableau::GaussTableau;

/// Gauss collocation with `S` stages, 1 to 6. Order 2S, symmetric, symplectic, for every H; keeps quadratic invariants.
///
/// Solved for the stage derivatives kᵢ = f(Yᵢ), all together: Yᵢ = y₀ + h Σ aᵢⱼ kⱼ; or, if T is quadratic, for the stage
/// forces alone: Yᵢ = q₀ + cᵢh q'₀ + h² Σ (A²)ᵢⱼ M⁻¹kⱼ. The reference for energies that are not separable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gauss<const S: usize>;

/// x₁ = x₀ + h J∇H((x₀ + x₁)/2), the Gauss method with one stage. Order 2, symmetric, symplectic, for every H; keeps
/// quadratic invariants.
///
/// For a higher order prefer [`Gauss`] to a composition of this.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ImplicitMidpoint;

/// Coefficients of one step.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, R, const S: usize> {
    system: P,
    h: R,
    /// What stage j adds to stage i: h·A, or h²·A².
    coupling: [[R; S]; S],
    /// h·c.
    nodes: [R; S],
    /// h·b.
    weights: [R; S],
    /// What a stage adds to the end: h·b, or h²·b(1 − c).
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
        let first_order = Y::DERIVATIVE == 1;
        let coupling = |i: usize, j: usize| {
            let square = (0..S).map(|k| tableau.a[i][k] * tableau.a[k][j]).sum();
            if first_order { R::from_f64(tableau.a[i][j]) * h } else { R::from_f64(square) * h * h }
        };
        let increment = |i: usize| {
            let (b, c) = (tableau.b[i], tableau.c[i]);
            if first_order { R::from_f64(b) * h } else { R::from_f64(b * (1.0 - c)) * h * h }
        };
        Prepared {
            system: system.prepare(),
            h,
            coupling: core::array::from_fn(|i| core::array::from_fn(|j| coupling(i, j))),
            nodes: tableau.c.map(|c| R::from_f64(c) * h),
            weights: tableau.b.map(|b| R::from_f64(b) * h),
            increments: core::array::from_fn(increment),
        }
    }

    #[inline(always)]
    fn step<P: Probe<Y, R>>(
        prepared: &Self::Prepared,
        t: R,
        q: &mut Y::Array,
        p: &mut Y::Array,
        probe: &mut P,
    ) -> Result<(), NotConverged> {
        let Prepared { system, h, coupling, nodes, weights, increments } = prepared;
        let zero = Y::Unknown::zero();
        let (mut f, mut slope) = (zero, Y::Unknown::fill(zero));
        let (y0, velocity, changed) = Y::start(system, q, p);
        probe.visit(t, q, p);

        // A guess: the stages as if y' were constant.
        let mut rate = velocity;
        if Y::DERIVATIVE == 1 {
            Y::field(system, t, &y0, &mut rate, &mut slope);
        }
        let mut guess = [zero; S];
        for i in 0..S {
            let mut y = y0;
            add_scaled(&mut y, nodes[i], &rate);
            Y::field(system, t + nodes[i], &y, &mut guess[i], &mut slope);
        }

        // The accuracy of kᵢ that can be seen in what h·kᵢ is added to.
        let mut visible = zero;
        add_scaled(&mut visible, R::from_f64(1.0) / *h, &changed);
        let k = newton::solve(guess, [visible; S], |k, residual, jacobian| {
            let rows = <[Y::Unknown; S]>::entries::<[Y::Unknown; S]>(jacobian);
            for i in 0..S {
                let mut y = y0;
                add_scaled(&mut y, nodes[i], &velocity);
                for j in 0..S {
                    Y::add(system, coupling[i][j], &k[j], &mut y);
                }
                let (mut x, mut momenta) = (*q, *p);
                Y::finish(&y, &zero, &mut x, &mut momenta);
                probe.visit(t + nodes[i], &x, &momenta);

                // kᵢ − f(Yᵢ) and its derivative δᵢⱼ − f'(Yᵢ)·∂Yᵢ/∂kⱼ.
                Y::field(system, t + nodes[i], &y, &mut f, &mut slope);
                residual[i] = k[i];
                add_scaled(&mut residual[i], R::from_f64(-1.0), &f);
                for (r, slope_row) in Y::Unknown::entries::<Y::Unknown>(&mut slope).iter().enumerate() {
                    let row = &mut rows[i * Y::Unknown::LEN + r];
                    for j in 0..S {
                        row[j] = zero;
                        add_scaled(&mut row[j], -coupling[i][j], slope_row);
                    }
                    row[i].as_mut_slice()[r] += R::from_f64(1.0);
                }
            }
        })?;

        let (mut y, mut impulse) = (y0, zero);
        add_scaled(&mut y, *h, &velocity);
        for i in 0..S {
            Y::add(system, increments[i], &k[i], &mut y);
            add_scaled(&mut impulse, weights[i], &k[i]);
        }
        Y::finish(&y, &impulse, q, p);
        Ok(())
    }
}

/// y ← y + w·x.
#[inline(always)]
fn add_scaled<A: Array>(y: &mut A, w: A::Real, x: &A) {
    for (y, x) in y.as_mut_slice().iter_mut().zip(x.as_slice()) {
        *y = w.multiply_add(*x, *y);
    }
}

impl<Y: Collocation<R>, R: Real> Method<Y, R> for ImplicitMidpoint {
    type Prepared = <Gauss<1> as Method<Y, R>>::Prepared;

    fn claims(&self) -> Claims {
        Method::<Y, R>::claims(&Gauss::<1>)
    }

    fn prepare(&self, system: &Y, h: R) -> Self::Prepared {
        Gauss::<1>.prepare(system, h)
    }

    #[inline(always)]
    fn step<P: Probe<Y, R>>(
        prepared: &Self::Prepared,
        t: R,
        q: &mut Y::Array,
        p: &mut Y::Array,
        probe: &mut P,
    ) -> Result<(), NotConverged> {
        Gauss::<1>::step(prepared, t, q, p, probe)
    }
}

impl SymmetricMap for ImplicitMidpoint {
    type Composed<const K: usize> = Composed<ImplicitMidpoint, K>;
    fn compose<const K: usize>(self, composition: Composition<K>) -> Self::Composed<K> {
        Composed { map: self, composition }
    }
}
