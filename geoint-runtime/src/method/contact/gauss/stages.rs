//! The equations of the stages, for positions, momenta and perhaps the action.

use super::ContactGauss;
use super::factors::Factors;
use crate::method::explicit::tableau::Tableau;
use crate::method::gauss::prepared::Prepared;
use crate::method::gauss::{Gauss, GaussTableau};
use crate::method::{Probe, Refusal, Step, StepsOf, check_end, check_way, start};
use crate::scalar::{Real, zero};
use crate::solving::equation::{Effort, Solution, StepEquation};
use crate::solving::linear;
use crate::solving::newton::Newton;
use crate::solving::size::Sizes;
use crate::space::vector::{scaled, sum, sum_of_products};
use crate::space::{Array, PerCoordinate, Square, Summation};
use crate::system::{ByField, ContactStages};

/// The coefficients of one step.
#[derive(Clone, Copy, Debug)]
pub struct PreparedContact<P, R, const S: usize> {
    stages: Prepared<P, R, S>,
    /// bᵀA⁻¹: what increments of the stages add up to in the end.
    shares: [R; S],
}

/// f = (∂H/∂p, −∂H/∂q, s') and ∂H/∂s at a stage, and the derivatives of both.
#[derive(Clone, Copy)]
struct At<A: Array> {
    f: A,
    decay: A::Real,
    f_by: Square<A>,
    decay_by: A,
}

/// The equations of all stages for their increments.
struct StagePoints<'a, Y: ContactStages<R>, R: Real, const S: usize> {
    system: &'a Y,
    prepared: &'a PreparedContact<Y::StageConstants, R, S>,
    t: R,
    origin: Y::Moved,
    /// The factors, where they do not depend on what is solved for.
    known: Option<Factors<R, S>>,
}

impl<Y: ContactStages<R>, R: Real, const S: usize> Clone for StagePoints<'_, Y, R, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Y: ContactStages<R>, R: Real, const S: usize> Copy for StagePoints<'_, Y, R, S> {}

impl<Y: ContactStages<R>, R: Real, const S: usize> StagePoints<'_, Y, R, S> {
    /// The state at a point, without s if it is not solved for.
    #[inline(always)]
    fn state(x: &Y::Moved) -> (Y::Phase, R) {
        let (mut z, phase) = (Y::Phase::zero(), Y::Phase::LEN);
        Array::as_mut_slice(&mut z).copy_from_slice(&x.as_slice()[..phase]);
        (z, x.as_slice().get(phase).copied().unwrap_or_else(zero))
    }

    #[inline(always)]
    fn evaluated(&self, t: R, x: &Y::Moved) -> At<Y::Moved> {
        let none = Y::Moved::zero();
        let mut at = At { f: none, decay: zero(), f_by: Y::Moved::fill(none), decay_by: none };
        let values = (&mut at.f, &mut at.decay);
        self.system.stage(&self.prepared.stages.constants, t, x, values, (&mut at.f_by, &mut at.decay_by));
        at
    }

    /// What the step adds; `None` where the form would not be multiplied by a positive number.
    #[inline(always)]
    fn end(&self, (d, s): (&[Y::Moved; S], R)) -> Option<PerCoordinate<Y::Phase, R>> {
        let PreparedContact { stages: Prepared { constants, coupling, nodes, weights, .. }, shares } = self.prepared;
        let (n, one, origin) = (Y::Array::LEN, R::from_f64(1.0), self.origin.as_slice());
        let decay = |i: usize| self.system.decay(constants, self.t + nodes[i], &sum(&self.origin, &d[i]));
        let factors = match self.known {
            Some(known) => known,
            None => Factors::new::<false>(coupling, &core::array::from_fn(decay))?,
        };
        let grown = factors.growth(weights)?;
        let factor = one + grown;
        let mut end = PerCoordinate { z: Y::Phase::zero(), s: zero() };
        let z = Array::as_mut_slice(&mut end.z);
        for k in 0..n {
            z[k] = sum_of_products(shares, &d.map(|d| d.as_slice()[k]));
            // What h Σ aᵢⱼ rⱼ ∂H/∂q has taken of p₀ at each stage.
            let impulse = |i: usize| {
                let p = d[i].as_slice()[n + k];
                (factors.r[i] - one).multiply_add(origin[n + k] + p, p)
            };
            let impulse = sum_of_products(shares, &core::array::from_fn::<_, S, _>(impulse));
            z[n + k] = (impulse - grown * origin[n + k]) / factor;
        }
        end.s = match varying::<Y, R>() {
            true => sum_of_products(shares, &d.map(|d| d.as_slice()[2 * n])),
            false => sum_of_products(weights, &self.actions(&factors, d, s)?),
        };
        Some(end)
    }

    /// s' at the stages where it is not solved for.
    #[inline(always)]
    fn actions(&self, factors: &Factors<R, S>, d: &[Y::Moved; S], s: R) -> Option<[R; S]> {
        let Prepared { coupling, constants, nodes, .. } = &self.prepared.stages;
        let at_start: [R; S] = core::array::from_fn(|i| {
            let x = sum(&self.origin, &d[i]);
            let mut z = Y::Phase::zero();
            Array::as_mut_slice(&mut z).copy_from_slice(x.as_slice());
            self.system.action(constants, self.t + nodes[i], &z, &s)
        });
        factors.rates_of_action(coupling, at_start)
    }
}

/// Whether the factors depend on what is solved for: those of H = g(t)·s + H₀ do not.
const fn varying<Y: ContactStages<R>, R: Real>() -> bool {
    Y::Moved::LEN > <Y::Phase as Array>::LEN
}

impl<Y: ContactStages<R>, R: Real, const S: usize> StepsOf<ContactGauss<S>, Y, R> for ByField
where
    Gauss<S>: GaussTableau<S>,
{
    type Prepared = PreparedContact<Y::StageConstants, R, S>;
    type Memory = Newton<[Y::Moved; S]>;

    fn prepare(system: &Y, h: R) -> Self::Prepared {
        PreparedContact {
            stages: Prepared::new(system, system.stage_constants(), h),
            shares: shares(&Gauss::<S>::TABLEAU).map(R::from_f64),
        }
    }

    fn memory() -> Self::Memory {
        Newton::new(Y::Array::LEN, 2 + (Y::Moved::LEN - Y::Phase::LEN))
    }

    #[inline(always)]
    fn step<C: Summation<Y::Phase>, P: Probe<Y, R>>(
        prepared: &Self::Prepared,
        newton: &mut Self::Memory,
        Step { system, t, end, x, probe }: Step<'_, Y, R, C, P>,
    ) -> Result<(), Refusal> {
        let mut origin = Y::Moved::zero();
        let entries = origin.as_mut_slice();
        entries[..Y::Phase::LEN].copy_from_slice(Array::as_slice(&x.z));
        if let Some(s) = entries.get_mut(Y::Phase::LEN) {
            *s = x.s;
        }
        probe.visit(t, &x.z, &x.s);
        let Prepared { poles, constants, nodes, coupling, .. } = &prepared.stages;
        let known = if varying::<Y, R>() {
            None
        } else {
            let decay = nodes.map(|node| system.decay(constants, t + node, &Y::Moved::zero()));
            Some(Factors::new::<false>(coupling, &decay).ok_or(Refusal::Singular)?)
        };
        let equation = StagePoints { system, prepared, t, origin, known };
        let Solution { x: d, .. } = newton.solve(&equation, probe)?;
        let before = start::<Y, R, C>(x);
        for i in 0..if varying::<Y, R>() { S } else { 0 } {
            let (z, s) = StagePoints::<Y, R, S>::state(&sum(&origin, &d[i]));
            let way = ([t, t + nodes[i]], [&before.0, &z], [&before.1, &s]);
            check_way::<Y, R, P>(poles, false, system, way, &mut x.doubtful)?;
        }
        let increments = equation.end((&d, x.s)).ok_or(Refusal::Singular)?;
        x.add_everywhere(&increments);
        check_end(poles, &before, Step { system, t, end, x, probe })
    }
}

/// bᵀA⁻¹.
fn shares<const S: usize>(Tableau { a, b, .. }: &Tableau<S>) -> [f64; S] {
    let mut transposed: [[f64; S]; S] = core::array::from_fn(|i| core::array::from_fn(|j| a[j][i]));
    let mut shares = *b;
    // The matrix of a Gauss method is regular.
    linear::solve::<[f64; S]>(&mut transposed, &mut shares, &Sizes::equal());
    shares
}

impl<Y: ContactStages<R>, R: Real, P: Probe<Y, R>, const S: usize> StepEquation<[Y::Moved; S], P>
    for StagePoints<'_, Y, R, S>
{
    const EFFORT: Effort = P::EFFORT;

    #[inline(always)]
    fn origin(&self) -> [Y::Moved; S] {
        [self.origin; S]
    }

    /// As if the rates were constant.
    fn guess(&self) -> [Y::Moved; S] {
        let At { mut f, decay, .. } = self.evaluated(self.t, &self.origin);
        let n = Y::Array::LEN;
        for (f, p) in f.as_mut_slice()[n..2 * n].iter_mut().zip(&self.origin.as_slice()[n..2 * n]) {
            *f = (-decay).multiply_add(*p, *f);
        }
        self.prepared.stages.nodes.map(|node| scaled(node, &f))
    }

    #[inline(always)]
    fn residual(&self, probe: &mut P, d: &[Y::Moved; S], matrix: &mut Square<[Y::Moved; S]>) -> [Y::Moved; S] {
        let coupling = &self.prepared.stages.coupling;
        let (n, length) = (Y::Array::LEN, Y::Moved::LEN);
        let stages: [At<Y::Moved>; S] = core::array::from_fn(|i| {
            let (x, t) = (sum(&self.origin, &d[i]), self.t + self.prepared.stages.nodes[i]);
            let (z, s) = Self::state(&x);
            probe.visit(t, &z, &s);
            self.evaluated(t, &x)
        });
        let Factors { r, by_decay, .. } = match self.known {
            Some(known) => known,
            None => Factors::new::<true>(coupling, &stages.map(|stage| stage.decay)).unwrap_or_else(Factors::unknown),
        };
        let one = R::from_f64(1.0);
        let rows = <[Y::Moved; S]>::entries::<[Y::Moved; S]>(matrix);
        let varying = varying::<Y, R>();
        core::array::from_fn(|i| {
            let mut residual = d[i];
            for row in 0..length {
                let momentum = (n..2 * n).contains(&row);
                let weight = |j: usize| if momentum { r[j] } else { one };
                let value = &mut residual.as_mut_slice()[row];
                if momentum {
                    // rᵢ pᵢ − p₀.
                    let p = self.origin.as_slice()[row];
                    *value = (r[i] - one).multiply_add(p + *value, *value);
                }
                for j in 0..S {
                    *value = (-(coupling[i][j] * weight(j))).multiply_add(stages[j].f.as_slice()[row], *value);
                }
                for k in 0..S {
                    let target = &mut rows[i * length + row][k];
                    let by = &Y::Moved::entries_of::<Y::Moved>(&stages[k].f_by)[row];
                    *target = scaled(-(coupling[i][k] * weight(k)), by);
                    if i == k {
                        target.as_mut_slice()[row] += if momentum { r[i] } else { one };
                    }
                    if momentum && varying {
                        let mut by_factor = (self.origin.as_slice()[row] + d[i].as_slice()[row]) * by_decay[i][k];
                        for j in 0..S {
                            by_factor = (-(coupling[i][j] * by_decay[j][k]))
                                .multiply_add(stages[j].f.as_slice()[row], by_factor);
                        }
                        target.add_scaled(by_factor, &stages[k].decay_by);
                    }
                }
            }
            residual
        })
    }
}
