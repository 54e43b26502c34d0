//! The step of [`ContactGauss`](super::ContactGauss) for a contact Hamiltonian. The unknowns are the increments d of q, p, and perhaps s, from the start to
//! all stages. `VelocityStages` is the step for Lagrangians that are solved for velocities.
//!
//! Stage i has the factor rᵢ = 1 + h Σ aᵢⱼ rⱼ σⱼ with the decay rate σ = ∂H/∂s; see [`factors`](crate::method::gauss::factors). The equations of the momenta
//! are those of r p: rᵢ pᵢ = p₀ − h Σ aᵢⱼ rⱼ ∂H/∂q. If H = g(t)·s + H₀(q, p, t), s is no unknown: the factors are known at the start, and s follows from the
//! solution.
//!
//! A step is refused if the matrix δᵢⱼ − h aᵢⱼσⱼ of the factors is singular, so that they do not exist. It is also refused if r₁, the value of r at the end of
//! the step, is not positive.

use crate::method::explicit::tableau::Tableau;
use crate::method::gauss::factors::Factors;
use crate::method::gauss::prepared::Scaled;
use crate::method::gauss::stages::{Form, Part, Rows, Slopes, Values, Weights, assemble};
use crate::method::gauss::{Gauss, GaussTableau};
use crate::method::implicit::{Departure, Equation, ImplicitStep, Increment, Policy, Stage, Units, Watch};
use crate::method::{Failure, Probe};
use crate::scalar::{Real, zero};
use crate::solving::equation::Solution;
use crate::solving::linear;
use crate::solving::newton::Newton;
use crate::solving::size::Sizes;
use crate::space::vector::{resized, scaled, sum, sum_of_products};
use crate::space::{Array, Square};
use crate::system::ContactStages;

/// The step with `S` stages that is solved for the increments of its stages.
#[derive(Clone, Copy, Debug)]
pub struct ContactFieldStages<const S: usize>;

/// The form of the equations wᵢPᵢ − P₀ − h Σ aᵢⱼwⱼFⱼ = 0 of [`assemble`]. The value P − P₀ is the unknown itself, and the rate F has a derivative by it.
/// Nothing reads the shift h Σ aᵢⱼdⱼ.
const FORM: Form = Form {
    value: Slopes { by_unknown: Part::One, by_shift: Part::Zero },
    rate: Slopes { by_unknown: Part::Given, by_shift: Part::Zero },
    rows: Rows::Plain,
};

/// Coefficients of a step.
#[derive(Clone, Copy, Debug)]
pub struct Coefficients<P, R, const S: usize> {
    /// Coefficients of the system.
    kernel: P,
    /// The tableau of the method times h.
    scaled: Scaled<R, S>,
    /// bᵀA⁻¹: weights of the increments of the stages in the increment of the step. For rates F, the former are h A F, and the latter is h bᵀF.
    shares: [R; S],
}

/// Values that depend on the start of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<A: Array, const S: usize> {
    /// The point (q, p), or (q, p, s) if s is an unknown: [`ContactStages::Moved`].
    x: A,
    /// The factors of all stages, if they do not depend on the unknowns.
    known: Option<Factors<A::Real, S>>,
}

/// Returns whether s is an unknown. The factors then depend on the unknowns. For H = g(t)·s + H₀(q, p, t), s is no unknown.
const fn solves_for_action<Y: ContactStages<R>, R: Real>() -> bool {
    Y::Moved::LEN > <Y::Phase as Array>::LEN
}

impl<Y: ContactStages<R>, R: Real, const S: usize> Equation<'_, ContactFieldStages<S>, Y, R>
where
    Gauss<S>: GaussTableau<S>,
{
    /// Splits a point into z = (q, p) and s. If s is no unknown, the result has the action at the start of the step. This is enough for a search for poles,
    /// because the poles of g(t)·s + H₀ do not depend on s.
    #[inline(always)]
    fn state(&self, x: &Y::Moved) -> (Y::Phase, R) {
        (resized(x, zero()), x.as_slice().get(<Y::Phase as Array>::LEN).copied().unwrap_or(self.from.s))
    }

    /// Computes the rates at a point, with their derivatives: q' = ∂H/∂p, −∂H/∂q, which is p' without its decay −σp, and s' if s is an unknown. Computes the
    /// decay rate σ, too.
    #[inline(always)]
    fn evaluate(&self, t: R, x: &Y::Moved, values: &mut Values<Y::Moved>) {
        let Values { rate, rate_slopes, decay, decay_slopes, .. } = values;
        let slopes = (&mut rate_slopes.by_unknown, &mut decay_slopes.by_unknown);
        self.from.system.stage(&self.coefficients.kernel, t, x, (rate, decay), slopes);
    }

    /// Returns the increment of the step that belongs to the increments `d` of the stages. Returns `None` if the factors do not exist, if r₁ is not positive,
    /// or if the equation for s' is singular.
    #[inline(always)]
    fn end(&self, d: &[Y::Moved; S]) -> Option<Increment<Y::Phase, R>> {
        let Coefficients { kernel, scaled: Scaled { coupling, nodes, weights }, shares } = self.coefficients;
        let (n, one, origin) = (Y::Array::LEN, R::from_f64(1.0), self.start.x.as_slice());
        let decay = |i: usize| self.from.system.decay(kernel, self.from.t + nodes[i], &sum(&self.start.x, &d[i]));
        let factors = match self.start.known {
            Some(known) => known,
            None => Factors::new::<false>(coupling, &core::array::from_fn(decay))?,
        };
        // r₁ − 1 and r₁.
        let growth = factors.growth(weights)?;
        let end_factor = one + growth;
        let mut end = Increment::of(Y::Phase::zero(), zero());
        let z = Array::as_mut_slice(&mut end.z);
        for k in 0..n {
            z[k] = sum_of_products(shares, &d.map(|d| d.as_slice()[k]));
            // rᵢpᵢ − p₀, the increment of r p from the start to stage i.
            let stage_impulse = |i: usize| {
                let p = d[i].as_slice()[n + k];
                (factors.r[i] - one).multiply_add(origin[n + k] + p, p)
            };
            // With impulse = r₁p₁ − p₀, the increment is p₁ − p₀ = (impulse − (r₁ − 1) p₀)/r₁.
            let impulse = sum_of_products(shares, &core::array::from_fn::<_, S, _>(stage_impulse));
            z[n + k] = (impulse - growth * origin[n + k]) / end_factor;
        }
        end.s = match solves_for_action::<Y, R>() {
            true => sum_of_products(shares, &d.map(|d| d.as_slice()[2 * n])),
            false => sum_of_products(weights, &self.action_rates(&factors, d)?),
        };
        Some(end)
    }

    /// Returns s' at the stages. Precondition: s is no unknown. s' is then affine in s with the slope −σ, so the s' of all stages solve a linear equation.
    /// Returns `None` if this equation is singular.
    #[inline(always)]
    fn action_rates(&self, factors: &Factors<R, S>, d: &[Y::Moved; S]) -> Option<[R; S]> {
        let Coefficients { kernel, scaled: Scaled { coupling, nodes, .. }, .. } = self.coefficients;
        // s' at the stages, with the action of the start of the step.
        let for_initial_action: [R; S] = core::array::from_fn(|i| {
            let (z, s) = self.state(&sum(&self.start.x, &d[i]));
            self.from.system.action(kernel, self.from.t + nodes[i], &z, &s)
        });
        factors.rates_of_action(coupling, for_initial_action)
    }
}

impl<Y: ContactStages<R>, R: Real, const S: usize> ImplicitStep<Y, R> for ContactFieldStages<S>
where
    Gauss<S>: GaussTableau<S>,
{
    type Unknown = [Y::Moved; S];
    type Coefficients = Coefficients<Y::StageConstants, R, S>;
    type Start = Start<Y::Moved, S>;
    type History = ();
    type LastEvaluation = ();
    type Kept = ();
    type Solver = Newton<[Y::Moved; S]>;

    const POLICY: Policy = Policy::of(if solves_for_action::<Y, R>() {
        // Rows of 2n + 1 entries do not split into groups of n.
        Units { alike: 1, kinds: Y::Moved::LEN }
    } else {
        Units { alike: Y::Array::LEN, kinds: 2 }
    });
    const STAGES: usize = S;

    fn coefficients(self, system: &Y, h: R) -> Self::Coefficients {
        let shares = shares(&Gauss::<S>::TABLEAU).map(R::from_f64);
        Coefficients { kernel: system.stage_constants(), scaled: Scaled::by(h), shares }
    }

    fn history() {}

    fn no_evaluation() {}

    #[inline(always)]
    fn begin(
        from: &Departure<'_, Y, R>,
        coefficients: &Self::Coefficients,
        (): &mut (),
    ) -> Result<Self::Start, Failure> {
        let Coefficients { kernel, scaled: Scaled { coupling, nodes, .. }, .. } = coefficients;
        let known = if solves_for_action::<Y, R>() {
            None
        } else {
            // σ = g(t) is the same at all points, so zero serves.
            let decay = nodes.map(|node| from.system.decay(kernel, from.t + node, &Y::Moved::zero()));
            Some(Factors::new::<false>(coupling, &decay).ok_or(Failure::Singular)?)
        };
        Ok(Start { x: resized(&from.z, from.s), known })
    }

    #[inline(always)]
    fn origin(equation: &Equation<'_, Self, Y, R>) -> [Y::Moved; S] {
        [equation.start.x; S]
    }

    /// Returns the increments of a motion with the constant rates of the start of the step.
    fn guess(equation: &Equation<'_, Self, Y, R>) -> [Y::Moved; S] {
        let (mut values, x) = (Values::none(), &equation.start.x);
        equation.evaluate(equation.from.t, x, &mut values);
        let Values { rate: mut f, decay, .. } = values;
        let n = Y::Array::LEN;
        // p' = −∂H/∂q − σp.
        for (f, p) in f.as_mut_slice()[n..2 * n].iter_mut().zip(&x.as_slice()[n..2 * n]) {
            *f = (-decay).multiply_add(*p, *f);
        }
        equation.coefficients.scaled.nodes.map(|node| scaled(node, &f))
    }

    #[inline(always)]
    fn residual<P: Probe<Y, R>>(
        equation: &Equation<'_, Self, Y, R>,
        watch: &mut Watch<'_, Y, R, P, ()>,
        d: &[Y::Moved; S],
        matrix: &mut Square<[Y::Moved; S]>,
    ) -> [Y::Moved; S] {
        let (Scaled { coupling, nodes, .. }, origin) = (&equation.coefficients.scaled, &equation.start.x);
        let (n, mut stages) = (Y::Array::LEN, [Values::none(); S]);
        for i in 0..S {
            let (x, t) = (sum(origin, &d[i]), equation.from.t + nodes[i]);
            let (z, s) = equation.state(&x);
            watch.visit(t, &z, &s);
            equation.evaluate(t, &x, &mut stages[i]);
            (stages[i].value, stages[i].whole) = (d[i], x);
        }
        // If the factors do not exist, NaN replaces them, and the solver refuses the step.
        let factors = match equation.start.known {
            Some(known) => known,
            None => Factors::new::<true>(coupling, &stages.map(|stage| stage.decay)).unwrap_or_else(Factors::unknown),
        };
        let by_unknown = if solves_for_action::<Y, R>() { Part::Given } else { Part::Zero };
        let decay = Slopes { by_unknown, by_shift: Part::Zero };
        assemble(FORM, coupling, &stages, Some(Weights { factors: &factors, rows: n..2 * n, decay }), matrix)
    }

    #[inline(always)]
    fn stage(equation: &Equation<'_, Self, Y, R>, i: usize, d: &[Y::Moved; S]) -> Stage<Y, R> {
        let (z, s) = equation.state(&sum(&equation.start.x, &d[i]));
        Stage { t: equation.from.t + equation.coefficients.scaled.nodes[i], z, s }
    }

    #[inline(always)]
    fn update(
        equation: &Equation<'_, Self, Y, R>,
        solution: &Solution<[Y::Moved; S]>,
        (): &(),
    ) -> Result<Increment<Y::Phase, R>, Failure> {
        equation.end(&solution.x).ok_or(Failure::Singular)
    }
}

/// Returns bᵀA⁻¹ of a tableau.
fn shares<const S: usize>(Tableau { a, b, .. }: &Tableau<S>) -> [f64; S] {
    let mut transposed: [[f64; S]; S] = core::array::from_fn(|i| core::array::from_fn(|j| a[j][i]));
    let mut shares = *b;
    // The matrix A of a Gauss method is invertible.
    linear::solve::<[f64; S]>(&mut transposed, &mut shares, &Sizes::equal());
    shares
}
