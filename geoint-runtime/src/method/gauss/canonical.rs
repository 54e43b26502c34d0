//! Stages of a flow in its canonical coordinates y(x), solved for the points xᵢ:
//!
//! y(xᵢ) = y(x₀) + h Σ aᵢⱼ y'(xⱼ), and y(x₁) = y(x₀) + h Σ bⱼ y'(xⱼ).

use super::prepared::Prepared;
use super::{Gauss, GaussTableau};
use crate::method::{Probe, Refusal, Step, StepsOf, check_end, check_way, start};
use crate::scalar::Real;
use crate::solving::equation::{Effort, Solution, StepEquation};
use crate::solving::newton::Newton;
use crate::solving::rounding::{Correction, Corrections, Stuck, correct};
use crate::solving::size::Sizes;
use crate::solving::{Inverse, Inverted, linear};
use crate::space::vector::{difference, scaled, sum};
use crate::space::{Array, Snapshot, Square, Summation};
use crate::system::{ByCanonical, CanonicalForm, row_scale};

impl<Y: CanonicalForm<R>, R: Real, const S: usize> StepsOf<Gauss<S>, Y, R> for ByCanonical
where
    Gauss<S>: GaussTableau<S>,
{
    type Prepared = Prepared<Y::CanonicalConstants, R, S>;
    type Memory = Newton<[Y::Phase; S]>;

    fn prepare(system: &Y, h: R) -> Self::Prepared {
        Prepared::new(system, system.canonical_constants(), h)
    }

    fn memory() -> Self::Memory {
        Newton::new(Y::State::ALIKE, Y::Phase::LEN / Y::State::ALIKE)
    }

    #[inline(always)]
    fn step<C: Summation<Y::Phase>, P: Probe<Y, R>>(
        prepared: &Self::Prepared,
        newton: &mut Self::Memory,
        Step { system, t, end, x, probe }: Step<'_, Y, R, C, P>,
    ) -> Result<(), Refusal> {
        probe.visit(t, &x.z, &());
        let begun = At::new(system, &prepared.constants, t, x.z);
        let (inverse, _) = inverse(&begun.derivatives[VALUE], &x.z).ok_or(Refusal::Singular)?;
        let equation = StagePoints { system, prepared, t, z: x.z, y: begun.value, rate: begun.rate, inverse: &inverse };
        let Solution { x: d, .. } = newton.solve(&equation, probe)?;

        let mut change = Y::Phase::zero();
        for i in 0..S {
            let (time, point) = (t + prepared.nodes[i], sum(&x.z, &d[i]));
            let way = ([t, time], [&equation.z, &point], [&(), &()]);
            check_way::<Y, R, P>(&prepared.poles, false, system, way, &mut x.doubtful)?;
            let stage = At::new(system, &prepared.constants, time, point);
            change.add_scaled(prepared.weights[i], &stage.rate);
        }
        let increment = equation.end(&change, d[S - 1])?;
        let before = start::<Y, R, C>(x);
        x.add(&increment);
        check_end(&prepared.poles, &before, Step { system, t, end, x, probe })
    }
}

/// y and y' at a point, and the derivatives of both.
#[derive(Clone, Copy)]
struct At<A: Array> {
    value: A,
    rate: A,
    derivatives: [Square<A>; 2],
}

/// The places of derivatives.
const VALUE: usize = 0;
const RATE: usize = 1;

impl<A: Array> At<A> {
    #[inline(always)]
    fn new<Y: CanonicalForm<R, Phase = A>, R: Real>(
        system: &Y,
        constants: &Y::CanonicalConstants,
        t: R,
        z: A,
    ) -> At<A> {
        let none = A::zero();
        let mut at = At { value: none, rate: none, derivatives: [A::fill(none); 2] };
        system.canonical(constants, t, &z, [&mut at.value, &mut at.rate], &mut at.derivatives);
        at
    }
}

/// The equations of all stages for their increments xᵢ − x₀, times (∂y/∂x)⁻¹ at the start: then they have the units of x, and their
/// matrix is near 1.
struct StagePoints<'a, Y: CanonicalForm<R>, R: Real, const S: usize> {
    system: &'a Y,
    prepared: &'a Prepared<Y::CanonicalConstants, R, S>,
    t: R,
    z: Y::Phase,
    y: Y::Phase,
    rate: Y::Phase,
    inverse: &'a Inverted<Y::Phase>,
}

impl<Y: CanonicalForm<R>, R: Real, const S: usize> Clone for StagePoints<'_, Y, R, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Y: CanonicalForm<R>, R: Real, const S: usize> Copy for StagePoints<'_, Y, R, S> {}

impl<Y: CanonicalForm<R>, R: Real, const S: usize> StagePoints<'_, Y, R, S> {
    /// The increment at whose end y has changed by this much, from a guess on.
    fn end(&self, change: &Y::Phase, guess: Y::Phase) -> Result<Y::Phase, Refusal> {
        let mut is_positive = true;
        let correction = |d: &Y::Phase| {
            let at = At::new(self.system, &self.prepared.constants, self.t + self.prepared.h, sum(&self.z, d));
            let mut delta = self.inverse.times(&difference(&difference(&at.value, &self.y), change));
            let mut matrix = scaled_rows(self.inverse, &at.derivatives[VALUE]);
            is_positive = linear::solve(&mut matrix, &mut delta, &Sizes::equal()).ok_or(Refusal::Singular)?;
            let relative = Sizes::new().relative(&delta, &self.z, &difference(d, &delta));
            Ok(Correction { delta, relative })
        };
        let d = correct(guess, Corrections::of_order(2), |Stuck { after, .. }| Some(*after), correction)?;
        // At the start the matrix is 1. If its determinant is negative, Ω has vanished on the way.
        if is_positive { Ok(d) } else { Err(Refusal::Singular) }
    }
}

impl<Y: CanonicalForm<R>, R: Real, P: Probe<Y, R>, const S: usize> StepEquation<[Y::Phase; S], P>
    for StagePoints<'_, Y, R, S>
{
    const EFFORT: Effort = P::EFFORT;

    #[inline(always)]
    fn origin(&self) -> [Y::Phase; S] {
        [self.z; S]
    }

    fn guess(&self) -> [Y::Phase; S] {
        let rate = self.inverse.times(&self.rate);
        self.prepared.nodes.map(|node| scaled(node, &rate))
    }

    #[inline(always)]
    fn residual(&self, probe: &mut P, d: &[Y::Phase; S], matrix: &mut Square<[Y::Phase; S]>) -> [Y::Phase; S] {
        let stages: [At<Y::Phase>; S] = core::array::from_fn(|i| {
            let (t, z) = (self.t + self.prepared.nodes[i], sum(&self.z, &d[i]));
            probe.visit(t, &z, &());
            At::new(self.system, &self.prepared.constants, t, z)
        });
        let rows = <[Y::Phase; S]>::entries::<[Y::Phase; S]>(matrix);
        let n = Y::Phase::LEN;
        core::array::from_fn(|i| {
            let mut residual = difference(&stages[i].value, &self.y);
            for (k, stage) in stages.iter().enumerate() {
                let a = self.prepared.coupling[i][k];
                residual.add_scaled(-a, &stage.rate);
                let mut block = Y::Phase::fill(Y::Phase::zero());
                let rates = Y::Phase::entries_of::<Y::Phase>(&stage.derivatives[RATE]).iter();
                let values = Y::Phase::entries_of::<Y::Phase>(&stages[i].derivatives[VALUE]).iter();
                for ((row, rate), value) in Y::Phase::entries::<Y::Phase>(&mut block).iter_mut().zip(rates).zip(values)
                {
                    if i == k {
                        *row = *value;
                    }
                    row.add_scaled(-a, rate);
                }
                let block = scaled_rows(self.inverse, &block);
                for (r, row) in Y::Phase::entries_of::<Y::Phase>(&block).iter().enumerate() {
                    rows[i * n + r][k] = *row;
                }
            }
            self.inverse.times(&residual)
        })
    }
}

/// The product of an inverse with a matrix.
#[inline(always)]
fn scaled_rows<A: Array>(inverse: &Inverted<A>, matrix: &Square<A>) -> Square<A> {
    let mut product = A::fill(A::zero());
    for j in 0..A::LEN {
        let mut column = A::zero();
        for (x, row) in column.as_mut_slice().iter_mut().zip(A::entries_of::<A>(matrix)) {
            *x = row.as_slice()[j];
        }
        let column = inverse.times(&column);
        for (row, x) in A::entries::<A>(&mut product).iter_mut().zip(column.as_slice()) {
            row.as_mut_slice()[j] = *x;
        }
    }
    product
}

/// (∂y/∂x)⁻¹. Rows of the matrix have the units of y: divided by their diagonals they have those of x, as entries for pivots need them.
#[inline(always)]
fn inverse<A: Array>(matrix: &Square<A>, z: &A) -> Option<(Inverted<A>, bool)> {
    let (mut scaled_matrix, mut scales, mut sizes) = (*matrix, A::zero(), Sizes::new());
    sizes.include(z, &A::zero());
    let rows = A::entries::<A>(&mut scaled_matrix).iter_mut().zip(scales.as_mut_slice());
    for (i, (row, scale)) in rows.enumerate() {
        *scale = A::Real::from_f64(1.0) / row_scale(row, i);
        *row = scaled(*scale, row);
    }
    let (inverse, positive) = Inverted::of(&scaled_matrix, &sizes)?;
    Some((inverse.of_rows_scaled(&scales), positive))
}
