//! The Gauss step of a Lagrangian L(q, v, s, t), with or without an action s. Let p = ∂L/∂v be the momentum, f = ∂L/∂q less friction the force, and
//! σ = −∂L/∂s the decay rate. The unknowns are the velocities vᵢ of all stages, and sᵢ − s₀ if p, f or σ depends on s. With qᵢ = q₀ + h Σ aᵢⱼ vⱼ, the
//! equations are
//!
//! rᵢ ∂L/∂v(qᵢ, vᵢ, sᵢ) = p₀ + h Σ aᵢⱼ rⱼ fⱼ, sᵢ = s₀ + h Σ aᵢⱼ Lⱼ, rᵢ = 1 + h Σ aᵢⱼ rⱼ σⱼ.
//!
//! r is an integrating factor of p' = f − σ p: d(r p)/dt = r f. A step multiplies the contact form ds − p dq by 1/r₁, with r₁ at its end. Without an action,
//! r is 1. Friction exists only without an action.

use super::factors::Factors;
use super::prepared::Scaled;
use super::stages::{Form, Part, Rows, Slopes, Values, Weights, assemble, shifts};
use super::{Gauss, GaussTableau};
use crate::method::implicit::{Arrival, Departure, Equation, ImplicitStep, Increment, Policy, Stage, Units, Watch};
use crate::method::{Failure, Probe};
use crate::scalar::{Real, zero};
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::vector::{difference, dot, moved, opposite, resized, scaled, sum, sum_of_products};
use crate::space::{Action, Array, Square};
use crate::system::{Regular, VelocityForm, VelocityStage, rates_of_velocity, row_units, velocity_near};

/// The step with `S` stages that is solved for velocities of its stages, and for their increments of s if these act back on the motion.
#[derive(Clone, Copy, Debug)]
pub struct VelocityStages<const S: usize>;

/// Coefficients of a step.
#[derive(Clone, Copy, Debug)]
pub struct Coefficients<P, R, const S: usize> {
    /// Coefficients of the system.
    kernel: P,
    /// The table of the method times h.
    scaled: Scaled<R, S>,
    /// True if the mass matrix is proven to be positive definite everywhere.
    is_definite: bool,
}

/// Values that depend on the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<R, const S: usize> {
    /// The sign of the determinant of the mass matrix M.
    sign: R,
    /// The factors r, in the case [`Decay::OfTime`].
    known: Option<Factors<R, S>>,
}

impl<R: Real, const S: usize> Start<R, S> {
    /// Returns the factors of the step, where `solved` are the factors of the last evaluation. Returns `None` if all factors are 1.
    #[inline(always)]
    fn factors<'a, Y: VelocityForm<R>>(&'a self, solved: &'a Factors<R, S>) -> Option<&'a Factors<R, S>> {
        match const { decay::<Y, R>() } {
            Decay::None => None,
            Decay::OfTime => Some(self.known.as_ref().unwrap_or(solved)),
            Decay::OfState => Some(solved),
        }
    }
}

/// The last evaluation: its unknowns `d`, and the values at its stages.
#[derive(Clone, Copy, Debug)]
pub struct LastEvaluation<D: Array, const S: usize> {
    d: [D; S],
    stages: [Values<D>; S],
    /// L at the stages, with s = s₀ if s is no unknown.
    lagrangians: [D::Real; S],
    /// The factors r, in the case [`Decay::OfState`].
    factors: Factors<D::Real, S>,
}

/// Rates of the solution at all stages: the last evaluation, corrected by the last correction.
struct SolvedRates<D: Array, const S: usize> {
    /// f, with L in the row of s.
    rates: [D; S],
    /// σ.
    decays: [D::Real; S],
    /// L, with s = s₀ if s is no unknown.
    lagrangians: [D::Real; S],
}

impl<D: Array, const S: usize> LastEvaluation<D, S> {
    /// Returns the rates at the solution `d`, to first order in its distance from the last evaluation. The derivatives of L are p by v and f by q, because L
    /// is needed with an action only, where f has no friction.
    #[inline(always)]
    fn rates_at(
        &self,
        coupling: &[[D::Real; S]; S],
        d: &[D; S],
        form: Form,
        decay_slopes: Slopes<Part>,
    ) -> SolvedRates<D, S> {
        let mut solved = SolvedRates { rates: [D::zero(); S], decays: [zero(); S], lagrangians: self.lagrangians };
        let mut corrections = [D::zero(); S];
        for i in 0..S {
            corrections[i] = difference(&d[i], &self.d[i]);
        }
        let shifts = shifts(coupling, &corrections);
        for i in 0..S {
            let (stage, correction, shift) = (&self.stages[i], &corrections[i], &shifts[i]);
            solved.rates[i] = stage.rate_after(form, correction, shift);
            solved.decays[i] = stage.decay_after(decay_slopes, correction, shift);
            solved.lagrangians[i] += dot(&stage.whole, correction) + dot(&stage.rate, shift);
        }
        solved
    }
}

/// The decay rate σ of a system.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Decay {
    /// L does not read s: σ is 0, and there is no action.
    None,
    /// L = L₀(q, v, t) − g(t)·s: σ is g. The factors are known at the start of the step, and s follows from the solution.
    OfTime,
    /// L has any other form. The sᵢ are among the unknowns, and the factors depend on the unknowns.
    OfState,
}

/// Returns the case of a system, from the numbers of its unknowns.
const fn decay<Y: VelocityForm<R>, R: Real>() -> Decay {
    if <Y::Action as Action<R>>::LEN == 0 {
        Decay::None
    } else if Y::Unknown::LEN == Y::Array::LEN {
        Decay::OfTime
    } else {
        Decay::OfState
    }
}

/// Returns whether s is an unknown.
const fn solves_for_action<Y: VelocityForm<R>, R: Real>() -> bool {
    matches!(decay::<Y, R>(), Decay::OfState)
}

/// Returns the derivatives that L has. Products with the others are not compiled.
const fn form<Y: VelocityForm<R>, R: Real>() -> Form {
    // With s as an unknown, L is a rate, and has the derivatives p and −σ.
    let rate_by_unknown = Y::MIXED.force_by_v || solves_for_action::<Y, R>();
    Form {
        value: Slopes { by_unknown: Part::Given, by_shift: Part::given_if(Y::MIXED.momentum_by_q) },
        rate: Slopes { by_unknown: Part::given_if(rate_by_unknown), by_shift: Part::Given },
        rows: Rows::Scaled,
    }
}

/// Returns the derivatives that σ has. By the shift, which moves q, it has one if ∂f/∂s = −∂σ/∂q is not zero.
const fn decay_slopes<Y: VelocityForm<R>, R: Real>() -> Slopes<Part> {
    let solved = solves_for_action::<Y, R>();
    Slopes { by_unknown: Part::given_if(solved), by_shift: Part::given_if(solved && Y::MIXED.force_by_s) }
}

impl<Y: VelocityForm<R>, R: Real, const S: usize> Equation<'_, VelocityStages<S>, Y, R>
where
    Gauss<S>: GaussTableau<S>,
{
    /// Returns s₀, or zero without an action.
    #[inline(always)]
    fn action(&self) -> R {
        self.from.s.scalar().unwrap_or_else(zero)
    }

    /// Returns the point of a stage, with the momenta at the start of the step.
    #[inline(always)]
    fn place(&self, i: usize, d: &[Y::Unknown; S]) -> Stage<Y, R> {
        let Scaled { coupling, nodes, .. } = &self.coefficients.scaled;
        let mut change = Y::Array::zero();
        for (a, d) in coupling[i].iter().zip(d) {
            change.add_scaled(*a, &resized(d, zero()));
        }
        let z = [sum(&self.from.z[0], &change), self.from.z[1]];
        Stage { t: self.from.t + nodes[i], z, s: Y::Action::of(self.action() + of_action::<Y, R>(&d[i])) }
    }

    /// Writes the values of a stage for [`assemble`]. Rows of v have P = ∂L/∂v and F = f. If s is an unknown, its row has P = sᵢ and F = L.
    #[inline(always)]
    fn fill(&self, values: &mut Values<Y::Unknown>, stage: &VelocityStage<Y::Array>, d: &Y::Unknown) {
        let (n, one, none) = (Y::Array::LEN, R::from_f64(1.0), Y::Array::zero());
        let [momentum_by_q, mass, force_by_q, force_by_v] = &stage.derivatives;
        let [momentum_by_s, force_by_s] = &stage.by_action;
        values.value = resized(&difference(&stage.momentum, &self.from.z[1]), of_action::<Y, R>(d));
        values.rate = resized(&stage.force, stage.lagrangian);
        values.scales = resized::<Y::Array, _>(&row_units(mass), one);
        if const { !matches!(decay::<Y, R>(), Decay::None) } {
            values.whole = resized(&stage.momentum, zero());
            values.decay = stage.decay;
            values.decay_slopes.by_unknown = resized(&opposite(momentum_by_s), stage.decay_by_action);
            values.decay_slopes.by_shift = resized(&opposite(force_by_s), zero());
        }
        let rows = |slopes: &mut Square<Y::Unknown>, by: &Square<Y::Array>, by_s: &Y::Array| {
            let rows = Y::Unknown::entries::<Y::Unknown>(slopes).iter_mut().zip(Y::Array::entries_of::<Y::Array>(by));
            for ((row, by), by_s) in rows.zip(by_s.as_slice()) {
                *row = resized(by, *by_s);
            }
        };
        rows(&mut values.value_slopes.by_unknown, mass, momentum_by_s);
        rows(&mut values.value_slopes.by_shift, momentum_by_q, &none);
        rows(&mut values.rate_slopes.by_unknown, force_by_v, force_by_s);
        rows(&mut values.rate_slopes.by_shift, force_by_q, &none);
        // The row of the action: its increment, and L.
        if const { solves_for_action::<Y, R>() } {
            let last = |slopes: &mut Square<Y::Unknown>, v: &Y::Array, s: R| {
                Y::Unknown::entries::<Y::Unknown>(slopes)[n] = resized(v, s);
            };
            last(&mut values.value_slopes.by_unknown, &none, one);
            last(&mut values.rate_slopes.by_unknown, &stage.momentum, -stage.decay);
            last(&mut values.rate_slopes.by_shift, &stage.force, zero());
        }
    }
}

/// Returns the entry of s in a row, or zero if s is no unknown.
#[inline(always)]
fn of_action<Y: VelocityForm<R>, R: Real>(d: &Y::Unknown) -> R {
    d.as_slice().get(Y::Array::LEN).copied().unwrap_or_else(zero)
}

impl<Y: VelocityForm<R>, R: Real, const S: usize> ImplicitStep<Y, R> for VelocityStages<S>
where
    Gauss<S>: GaussTableau<S>,
{
    type Unknown = [Y::Unknown; S];
    type Coefficients = Coefficients<Y::StageConstants, R, S>;
    type Start = Start<R, S>;
    type History = Regular<Y::Array>;
    type LastEvaluation = LastEvaluation<Y::Unknown, S>;
    type Kept = ();
    type Solver = Newton<[Y::Unknown; S]>;

    const POLICY: Policy = Policy::of(match decay::<Y, R>() {
        // s has a unit of its own. `Units` cannot group n velocities in rows of n + 1 entries, so each velocity is a kind, too.
        Decay::OfState => Units { alike: 1, kinds: Y::Unknown::LEN },
        _ => Units { alike: Y::Array::LEN, kinds: 1 },
    });
    const STAGES: usize = S;

    fn coefficients(self, system: &Y, h: R) -> Self::Coefficients {
        Coefficients { kernel: system.stage_constants(), scaled: Scaled::by(h), is_definite: system.is_definite() }
    }

    fn history() -> Self::History {
        Regular::unknown()
    }

    fn no_evaluation() -> Self::LastEvaluation {
        let none = Y::Unknown::zero();
        LastEvaluation {
            d: [none; S],
            stages: [Values::none(); S],
            lagrangians: [zero(); S],
            factors: Factors::unknown(),
        }
    }

    #[inline(always)]
    fn begin(
        from: &Departure<'_, Y, R>,
        Coefficients { kernel, scaled: Scaled { coupling, nodes, .. }, is_definite }: &Self::Coefficients,
        regular: &mut Self::History,
    ) -> Result<Self::Start, Failure> {
        let Departure { system, t, z, s, .. } = from;
        let sign = regular.begin(*system, *is_definite, (*t, z, s))?;
        let mut known = None;
        if const { matches!(decay::<Y, R>(), Decay::OfTime) } {
            let none = Y::Array::zero();
            let decay = nodes.map(|node| system.force(kernel, *t + node, &none, &none, s).1);
            known = Some(Factors::new::<false>(coupling, &decay).ok_or(Failure::Singular)?);
        }
        Ok(Start { sign, known })
    }

    /// Returns (q₀/h, s₀). Rounding of a velocity is relative to q₀/h, because h times the velocity is added to q₀. Rounding of an increment of s is relative
    /// to s₀.
    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, Y, R>) -> [Y::Unknown; S] {
        let Departure { h, z, .. } = &equation.from;
        [resized(&scaled(R::from_f64(1.0) / *h, &z[0]), equation.action()); S]
    }

    /// Returns the velocities, and the increments of s, for constant rates v' and s'.
    fn guess(equation: &Equation<'_, Self, Y, R>) -> [Y::Unknown; S] {
        let Equation { from: Departure { system, t, z, s, .. }, coefficients, .. } = equation;
        let v = velocity_near(*system, *t, z, s, Y::Array::zero()).unwrap_or_else(Y::Array::zero);
        let (acceleration, lagrangian) = rates_of_velocity(*system, *t, &z[0], &v, s);
        coefficients.scaled.nodes.map(|node| resized(&moved(&v, node, &acceleration), node * lagrangian))
    }

    /// Returns rᵢ ∂L/∂v − p₀ − h Σ aᵢⱼ rⱼ fⱼ, with each row over its |Mₖₖ|, and sᵢ − s₀ − h Σ aᵢⱼ Lⱼ.
    #[inline(always)]
    fn residual<P: Probe<Y, R>>(
        equation: &Equation<'_, Self, Y, R>,
        watch: &mut Watch<'_, Y, R, P, Self::LastEvaluation>,
        d: &[Y::Unknown; S],
        matrix: &mut Square<[Y::Unknown; S]>,
    ) -> [Y::Unknown; S] {
        let Equation { from, coefficients, start } = equation;
        let coupling = &coefficients.scaled.coupling;
        watch.last.d = *d;
        for i in 0..S {
            let (Stage { t, z, s }, mut stage) = (equation.place(i, d), VelocityStage::none());
            watch.visit(t, &z, &s);
            from.system.stage(&coefficients.kernel, t, &z[0], &resized(&d[i], zero()), &s, &mut stage);
            equation.fill(&mut watch.last.stages[i], &stage, &d[i]);
            watch.last.lagrangians[i] = stage.lagrangian;
        }
        let LastEvaluation { stages, factors, .. } = &mut watch.last;
        // For short steps the determinant has the sign of (det M)ˢ. The solver requires a positive one.
        if S % 2 == 1 {
            stages[0].scales.as_mut_slice()[0] *= start.sign;
        }
        if const { solves_for_action::<Y, R>() } {
            let decay = core::array::from_fn(|i| stages[i].decay);
            *factors = Factors::new::<true>(coupling, &decay).unwrap_or_else(Factors::unknown);
        }
        let weights = start.factors::<Y>(factors).map(|factors| Weights {
            factors,
            rows: 0..Y::Array::LEN,
            decay: decay_slopes::<Y, R>(),
        });
        assemble(form::<Y, R>(), coupling, stages, weights, matrix)
    }

    #[inline(always)]
    fn stage(equation: &Equation<'_, Self, Y, R>, i: usize, d: &[Y::Unknown; S]) -> Stage<Y, R> {
        equation.place(i, d)
    }

    /// Returns the increments from the rates of the last evaluation, corrected to first order: the square of the last correction is below rounding.
    ///
    /// # Errors
    /// If r₁ is not positive, so that the contact form would not be multiplied by a positive number.
    #[inline(always)]
    fn update(
        equation: &Equation<'_, Self, Y, R>,
        Solution { x: d, .. }: &Solution<[Y::Unknown; S]>,
        last: &Self::LastEvaluation,
    ) -> Result<Increment<Y::Phase, Y::Action>, Failure> {
        let Scaled { coupling, weights, .. } = &equation.coefficients.scaled;
        let SolvedRates { rates, decays, lagrangians } =
            last.rates_at(coupling, d, form::<Y, R>(), decay_slopes::<Y, R>());
        let solved =
            if const { solves_for_action::<Y, R>() } { last.factors.with_decay(&decays) } else { last.factors };
        let factors = equation.start.factors::<Y>(&solved);
        let (mut change, mut impulse, mut s) = (Y::Unknown::zero(), Y::Unknown::zero(), zero());
        for i in 0..S {
            change.add_scaled(weights[i], &d[i]);
            impulse.add_scaled(factors.map_or(weights[i], |factors| weights[i] * factors.r[i]), &rates[i]);
        }
        let mut impulse: Y::Array = resized(&impulse, zero());
        if let Some(factors) = factors {
            // r₁ p₁ = p₀ + impulse with r₁ = 1 + grown.
            let grown = factors.growth(weights).ok_or(Failure::Singular)?;
            impulse.add_scaled(-grown, &equation.from.z[1]);
            impulse = scaled(R::from_f64(1.0) / (R::from_f64(1.0) + grown), &impulse);
            let rates_of_action = match const { decay::<Y, R>() } {
                Decay::OfTime => factors.rates_of_action(coupling, lagrangians).ok_or(Failure::Singular)?,
                _ => rates.map(|rate| of_action::<Y, R>(&rate)),
            };
            s = sum_of_products(weights, &rates_of_action);
        }
        Ok(Increment::of([resized(&change, zero()), impulse], Y::Action::of(s)))
    }

    #[inline(always)]
    fn finish<P: Probe<Y, R>>(
        Equation { from, coefficients, .. }: &Equation<'_, Self, Y, R>,
        Solution { x: d, .. }: &Solution<[Y::Unknown; S]>,
        regular: &mut Self::History,
        Arrival { z, s, .. }: Arrival<'_, Y, R>,
    ) -> Result<(), Failure> {
        let ends = [(from.t, &from.z, &from.s), (from.end, z, s)];
        regular.follow(from.system, coefficients.is_definite, ends, resized(&d[S - 1], zero()))
    }
}
