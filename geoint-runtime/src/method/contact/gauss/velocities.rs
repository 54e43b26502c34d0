//! The step of a Lagrangian with an action. The unknowns are the velocities vᵢ of all stages, and sᵢ − s₀ if f, p or σ depend on s: with qᵢ = q₀ + h Σ aᵢⱼ vⱼ,
//!
//! rᵢ ∂L/∂v(qᵢ, vᵢ, sᵢ) = p₀ + h Σ aᵢⱼ rⱼ fⱼ, sᵢ = s₀ + h Σ aᵢⱼ Lⱼ, rᵢ = 1 + h Σ aᵢⱼ rⱼ σⱼ with f = ∂L/∂q and σ = −∂L/∂s.
//!
//! r is an integrating factor, d(r p)/dt = r f. A step multiplies the contact form ds − p dq by 1/r₁.

use crate::method::gauss::factors::Factors;
use crate::method::gauss::prepared::Scaled;
use crate::method::gauss::stages::{Form, Part, Rows, Slopes, Values, Weights, assemble};
use crate::method::gauss::velocities::Constants;
use crate::method::gauss::{Gauss, GaussTableau};
use crate::method::implicit::{Arrival, Departure, Equation, ImplicitStep, Increment, Policy, Stage, Units, Watch};
use crate::method::{Probe, Refusal};
use crate::scalar::{Real, zero};
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::vector::{difference, dot, moved, opposite, scaled, sum, sum_of_products};
use crate::space::{Array, Square};
use crate::system::{ContactStage, ContactVelocities, Regular, row_units, velocity_near};

/// The step that is solved for velocities of its stages, and perhaps for their increments of s.
#[derive(Clone, Copy, Debug)]
pub struct ContactVelocityStages<const S: usize>;

/// Values that depend on the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<R, const S: usize> {
    /// The sign of the determinant of the mass matrix.
    sign: R,
    /// The factors, if they do not depend on the unknowns.
    known: Option<Factors<R, S>>,
}

/// The last evaluation, and its unknowns.
#[derive(Clone, Copy, Debug)]
pub struct Last<D, A: Array, const S: usize> {
    d: [D; S],
    stages: [ContactStage<A>; S],
    factors: Factors<A::Real, S>,
}

impl<D: Array<Real = A::Real>, A: Array, const S: usize> Last<D, A, S> {
    fn none() -> Self {
        Last { d: [D::zero(); S], stages: [ContactStage::none(); S], factors: Factors::unknown() }
    }
}

/// Returns which derivatives are not zero. Second derivatives that L does not have are not multiplied.
const fn form<Y: ContactVelocities<R>, R: Real>() -> Form {
    let [by_q_and_v, _, by_q_and_s] = Y::MIXED;
    let is_given = by_q_and_v || by_q_and_s || solves_for_action::<Y, R>();
    Form {
        value: Slopes { by_unknown: Part::Given, by_shift: Part::given_if(by_q_and_v) },
        rate: Slopes { by_unknown: Part::given_if(is_given), by_shift: Part::Given },
        rows: Rows::Scaled,
    }
}

/// Returns which derivatives σ has.
const fn decay_slopes<Y: ContactVelocities<R>, R: Real>() -> Slopes<Part> {
    let [_, _, by_q_and_s] = Y::MIXED;
    let solved = solves_for_action::<Y, R>();
    Slopes { by_unknown: Part::given_if(solved), by_shift: Part::given_if(solved && by_q_and_s) }
}

/// Returns whether sᵢ are among the unknowns. If L = L₀(q, v, t) − g(t)·s they are not: the factors are known beforehand, and s follows from the solution.
const fn solves_for_action<Y: ContactVelocities<R>, R: Real>() -> bool {
    Y::Moved::LEN > Y::Array::LEN
}

impl<Y: ContactVelocities<R>, R: Real, const S: usize> Equation<'_, ContactVelocityStages<S>, Y, R>
where
    Gauss<S>: GaussTableau<S>,
{
    /// Returns the velocity of a stage, and the increment of s.
    #[inline(always)]
    fn split(&self, d: &Y::Moved) -> (Y::Array, R) {
        let mut v = Y::Array::zero();
        for (v, d) in v.as_mut_slice().iter_mut().zip(d.as_slice()) {
            *v = *d;
        }
        (v, d.as_slice().get(Y::Array::LEN).copied().unwrap_or_else(zero))
    }

    /// Returns a row with these entries for v, and for s if s is an unknown.
    #[inline(always)]
    fn join(&self, v: &Y::Array, s: R) -> Y::Moved {
        let mut row = Y::Moved::zero();
        for (x, v) in row.as_mut_slice().iter_mut().zip(v.as_slice()) {
            *x = *v;
        }
        if let Some(last) = row.as_mut_slice().get_mut(Y::Array::LEN) {
            *last = s;
        }
        row
    }

    /// Returns h Σ aᵢⱼ vⱼ.
    #[inline(always)]
    fn shift(&self, i: usize, d: &[Y::Moved; S]) -> Y::Array {
        let mut change = Y::Array::zero();
        for (a, d) in self.constants.scaled.coupling[i].iter().zip(d) {
            change.add_scaled(*a, &self.split(d).0);
        }
        change
    }

    /// Returns the point of a stage: positions and s, with the momenta before the step.
    #[inline(always)]
    fn place(&self, i: usize, d: &[Y::Moved; S]) -> (Y::Phase, R) {
        ([sum(&self.from.z[0], &self.shift(i, d)), self.from.z[1]], self.from.s + self.split(&d[i]).1)
    }

    /// Writes the values of a stage: rows of v with P = ∂L/∂v and F = f, and a row of s with P = sᵢ and F = L if s is an unknown.
    #[inline(always)]
    fn fill(&self, values: &mut Values<Y::Moved>, stage: &ContactStage<Y::Array>, d: &Y::Moved) {
        let (n, one) = (Y::Array::LEN, R::from_f64(1.0));
        let [momentum_by_q, mass, force_by_q, force_by_v] = &stage.derivatives;
        let [momentum_by_s, force_by_s] = &stage.by_action;
        values.value = self.join(&difference(&stage.momentum, &self.from.z[1]), self.split(d).1);
        values.whole = self.join(&stage.momentum, zero());
        values.rate = self.join(&stage.force, stage.lagrangian);
        values.scales = self.join(&row_units(mass), one);
        values.decay = stage.decay;
        values.decay_slopes.by_unknown = self.join(&opposite(momentum_by_s), stage.decay_by_action);
        values.decay_slopes.by_shift = self.join(&opposite(force_by_s), zero());
        let rows = |slopes: &mut Square<Y::Moved>, by: &Square<Y::Array>, by_s: &Y::Array| {
            let rows = Y::Moved::entries::<Y::Moved>(slopes).iter_mut().zip(Y::Array::entries_of::<Y::Array>(by));
            for ((row, by), by_s) in rows.zip(by_s.as_slice()) {
                *row = self.join(by, *by_s);
            }
        };
        let none = Y::Array::zero();
        rows(&mut values.value_slopes.by_unknown, mass, momentum_by_s);
        rows(&mut values.value_slopes.by_shift, momentum_by_q, &none);
        rows(&mut values.rate_slopes.by_unknown, force_by_v, force_by_s);
        rows(&mut values.rate_slopes.by_shift, force_by_q, &none);
        // The row of the action: its increment, and L.
        if solves_for_action::<Y, R>() {
            let last = |slopes: &mut Square<Y::Moved>, v: &Y::Array, s: R| {
                Y::Moved::entries::<Y::Moved>(slopes)[n] = self.join(v, s);
            };
            last(&mut values.value_slopes.by_unknown, &none, one);
            last(&mut values.rate_slopes.by_unknown, &stage.momentum, -stage.decay);
            last(&mut values.rate_slopes.by_shift, &stage.force, zero());
        }
    }

    /// Returns the increments of the step, from the stages at `last`, corrected to first order: the square of the last correction is rounding. `None` if the contact
    /// form would not be multiplied by a positive number.
    #[inline(always)]
    fn end(&self, d: &[Y::Moved; S], last: &Last<Y::Moved, Y::Array, S>) -> Option<Increment<Y::Phase, R>> {
        let Scaled { coupling, weights, .. } = &self.constants.scaled;
        let mut corrections = [Y::Moved::zero(); S];
        for i in 0..S {
            corrections[i] = difference(&d[i], &last.d[i]);
        }
        let (mut forces, mut decay, mut rates) = ([Y::Array::zero(); S], [zero(); S], [zero(); S]);
        for i in 0..S {
            let moved = (self.shift(i, &corrections), self.split(&corrections[i]));
            (forces[i], decay[i], rates[i]) = after::<Y, R>(&last.stages[i], &moved.0, moved.1);
        }
        let factors = self.start.known.unwrap_or_else(|| last.factors.after(&decay));
        let grown = factors.growth(weights)?;
        let (mut change, mut impulse) = (Y::Array::zero(), scaled(-grown, &self.from.z[1]));
        for i in 0..S {
            change.add_scaled(weights[i], &self.split(&d[i]).0);
            impulse.add_scaled(weights[i] * factors.r[i], &forces[i]);
        }
        let impulse = scaled(R::from_f64(1.0) / (R::from_f64(1.0) + grown), &impulse);
        if !solves_for_action::<Y, R>() {
            rates = factors.rates_of_action(coupling, rates)?;
        }
        Some(Increment { z: [change, impulse], s: sum_of_products(weights, &rates), lost: Y::Phase::zero() })
    }
}

impl<Y: ContactVelocities<R>, R: Real, const S: usize> ImplicitStep<Y, R> for ContactVelocityStages<S>
where
    Gauss<S>: GaussTableau<S>,
{
    type Unknown = [Y::Moved; S];
    type Constants = Constants<Y::StageConstants, R, S>;
    type Start = Start<R, S>;
    type History = Regular<Y::Array>;
    type Seen = Last<Y::Moved, Y::Array, S>;
    type Kept = ();
    type Solver = Newton<[Y::Moved; S]>;

    /// Each unknown of a stage may have a unit of its own.
    const POLICY: Policy = Policy::of(Units { alike: 1, kinds: Y::Moved::LEN });
    const STAGES: usize = if solves_for_action::<Y, R>() { S } else { 0 };

    fn constants(self, system: &Y, h: R) -> Self::Constants {
        Constants { kernel: system.stage_constants(), scaled: Scaled::by(h), is_definite: system.is_definite() }
    }

    fn history() -> Self::History {
        Regular::unknown()
    }

    fn unseen() -> Self::Seen {
        Last::none()
    }

    #[inline(always)]
    fn begin(
        from: &Departure<'_, Y, R>,
        Constants { kernel, scaled: Scaled { coupling, nodes, .. }, is_definite }: &Self::Constants,
        regular: &mut Self::History,
    ) -> Result<Self::Start, Refusal> {
        let Departure { system, t, z, s, .. } = from;
        let sign = regular.begin(*system, *is_definite, (*t, z, s))?;
        let known = if solves_for_action::<Y, R>() {
            None
        } else {
            let none = Y::Array::zero();
            let decay = nodes.map(|node| ContactVelocities::force(*system, kernel, *t + node, &none, &none, s).1);
            Some(Factors::new::<false>(coupling, &decay).ok_or(Refusal::Singular)?)
        };
        Ok(Start { sign, known })
    }

    /// (q₀/h, s₀): rounding of a velocity is relative to q₀/h, that of an increment of s to s₀.
    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, Y, R>) -> [Y::Moved; S] {
        let Departure { h, z, s, .. } = &equation.from;
        [equation.join(&scaled(R::from_f64(1.0) / *h, &z[0]), *s); S]
    }

    /// The velocities as if v' and s' were constant.
    fn guess(equation: &Equation<'_, Self, Y, R>) -> [Y::Moved; S] {
        let Equation { from: Departure { system, t, z, s, .. }, constants, .. } = equation;
        let v = velocity_near(*system, *t, z, s, Y::Array::zero()).unwrap_or_else(Y::Array::zero);
        let mut at = ContactStage::none();
        system.stage(&constants.kernel, *t, &z[0], &v, s, &mut at);
        let rate = at.acceleration(&v);
        constants.scaled.nodes.map(|node| equation.join(&moved(&v, node, &rate), node * at.lagrangian))
    }

    /// (rᵢ ∂L/∂v − p₀ − h Σ aᵢⱼ rⱼ fⱼ)/|Mᵢᵢ|, and sᵢ − s₀ − h Σ aᵢⱼ Lⱼ.
    #[inline(always)]
    fn residual<P: Probe<Y, R>>(
        equation: &Equation<'_, Self, Y, R>,
        watch: &mut Watch<'_, Y, R, P, Self::Seen>,
        d: &[Y::Moved; S],
        matrix: &mut Square<[Y::Moved; S]>,
    ) -> [Y::Moved; S] {
        let Equation { from, constants: Constants { kernel, scaled: Scaled { coupling, nodes, .. }, .. }, start } =
            equation;
        watch.seen.d = *d;
        let mut stages = [Values::none(); S];
        for (i, values) in stages.iter_mut().enumerate() {
            let (t, (z, s)) = (from.t + nodes[i], equation.place(i, d));
            watch.visit(t, &z, &s);
            let stage = &mut watch.seen.stages[i];
            from.system.stage(kernel, t, &z[0], &equation.split(&d[i]).0, &s, stage);
            equation.fill(values, stage, &d[i]);
        }
        // The determinant has the sign of (det M)ˢ.
        if S % 2 == 1 {
            stages[0].scales.as_mut_slice()[0] *= start.sign;
        }
        let factors = &mut watch.seen.factors;
        *factors = match start.known {
            Some(known) => known,
            None => Factors::new::<true>(coupling, &stages.map(|stage| stage.decay)).unwrap_or_else(Factors::unknown),
        };
        let weights = Weights { factors, rows: 0..Y::Array::LEN, decay: decay_slopes::<Y, R>() };
        assemble(form::<Y, R>(), coupling, &stages, Some(weights), matrix)
    }

    #[inline(always)]
    fn stage(equation: &Equation<'_, Self, Y, R>, i: usize, d: &[Y::Moved; S]) -> Stage<Y, R> {
        let (z, s) = equation.place(i, d);
        Stage { t: equation.from.t + equation.constants.scaled.nodes[i], z, s }
    }

    #[inline(always)]
    fn update(
        equation: &Equation<'_, Self, Y, R>,
        solution: &Solution<[Y::Moved; S]>,
        last: &Self::Seen,
    ) -> Result<Increment<Y::Phase, R>, Refusal> {
        equation.end(&solution.x, last).ok_or(Refusal::Singular)
    }

    #[inline(always)]
    fn finish<P: Probe<Y, R>>(
        equation: &Equation<'_, Self, Y, R>,
        solution: &Solution<[Y::Moved; S]>,
        regular: &mut Self::History,
        Arrival { z, s, .. }: Arrival<'_, Y, R>,
    ) -> Result<(), Refusal> {
        let Equation { from, constants, .. } = equation;
        let ends = [(from.t, &from.z, &from.s), (from.end, z, s)];
        regular.follow(from.system, constants.is_definite, ends, equation.split(&solution.x[S - 1]).0)
    }
}

/// Returns f, σ and L after small changes of q, v and s.
#[inline(always)]
fn after<Y: ContactVelocities<R>, R: Real>(
    stage: &ContactStage<Y::Array>,
    dq: &Y::Array,
    (dv, ds): (Y::Array, R),
) -> (Y::Array, R, R) {
    let [by_q_and_v, by_v_and_s, by_q_and_s] = Y::MIXED;
    let [.., by_q, by_v] = &stage.derivatives;
    let [momentum_by_s, force_by_s] = &stage.by_action;
    let mut force = if by_q_and_s { moved(&stage.force, ds, force_by_s) } else { stage.force };
    let rows = Y::Array::entries_of::<Y::Array>(by_q).iter().zip(Y::Array::entries_of::<Y::Array>(by_v));
    for (f, (by_q, by_v)) in force.as_mut_slice().iter_mut().zip(rows) {
        *f += dot(by_q, dq);
        if by_q_and_v {
            *f += dot(by_v, &dv);
        }
    }
    let mut decay = stage.decay_by_action.multiply_add(ds, stage.decay);
    if by_v_and_s {
        decay -= dot(momentum_by_s, &dv);
    }
    if by_q_and_s {
        decay -= dot(force_by_s, dq);
    }
    let lagrangian = stage.lagrangian + dot(&stage.momentum, &dv) + dot(&stage.force, dq) - stage.decay * ds;
    (force, decay, lagrangian)
}
