//! Constraints g(q, t) = 0 beside an action. H = H₀(q, p, t) + γ(t)·s moves q' = ∂H₀/∂p, p' = −∂H₀/∂q − γp + Aᵀμ with A = ∂g/∂q, and s' = p·∂H₀/∂p − H. The
//! multipliers μ are not in s'.
//!
//! A contact map of the states on the constraints is D₁ ∘ RATTLE ∘ D₀, where RATTLE solves H₀, and Dᵢ multiplies p and s by one factor; see [`Damping`]. A
//! constraint force changes the contact form ds − p·dq by μ·A dq, which is zero on the constraints. The projection of momenta comes last: D₁ may turn tangent
//! momenta away if constraints move.
//!
//! The discrete gradient lies between (q₀, P₀) and (q₁, P₁), where P₀ and P₁ are the momenta p₀ and p₁ with normal parts along ν; see [`Normal`].
//!
//! [`Normal`]: super::tangent::Normal

use super::Equation;
use super::vectors::{ends, moved};
use crate::ir::formula::call;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Number, Symbol};

/// The action in an energy H₀(q, p, t) + γ(t)·s.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Action {
    /// H₀.
    pub(crate) energy: Id,
    /// γ.
    pub(crate) decay: Id,
}

/// The numbers that determine the increment of the action over a step of the discrete gradient.
pub(super) struct GradientStep<'a> {
    /// q₁ − q₀.
    pub(super) dq: &'a [Id],
    /// P₁ + P₀ − 2p₀.
    pub(super) sum: &'a [Id],
    /// H₀ at (q₀, P₀).
    pub(super) energy: Id,
    /// The work of constraints that move. H = H₀ + γs is then e^(−hγ) H + φ₁(−hγ)·work after the step, with γ in its middle.
    pub(super) work: Id,
}

/// The factors of D₀ and D₁.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Damping {
    /// e^(−hγ/2) both, with γ in the middle of the step: flows of γs.
    Exponential,
    /// 1 − hγ₀/2 and 1/(1 + hγ₁/2), with γ at the start and at the end: the trapezoidal rule of Herglotz' variational integrator. NaN unless both are positive.
    Trapezoidal,
}

/// The factors of p and s before and after a step.
struct Factors {
    first: Id,
    last: Id,
    /// Their product less 1, without cancellation.
    change: Id,
}

impl Damping {
    fn factors(self, graph: &mut Graph, decay: Id) -> Factors {
        let h = graph.symbol(Symbol::StepLength);
        match self {
            _ if graph.is_zero(decay) => {
                let one = graph.integer(1);
                Factors { first: one, last: one, change: decay }
            }
            Damping::Exponential => {
                let half = graph.build(call(Function::Exp, [-(Number::HALF * h * decay)]));
                let change = graph.build(-(h * decay));
                Factors { first: half, last: half, change: graph.call(Function::ExpM1, &[change]) }
            }
            Damping::Trapezoidal => {
                let [start, end] = [Symbol::StepStart, Symbol::StepEnd].map(|time| {
                    let time = graph.symbol(time);
                    let mut at = Substitution::new(|_: &mut Graph, symbol| (symbol == Symbol::Time).then_some(time));
                    let decay = at.apply(graph, decay);
                    graph.build(Number::HALF * h * decay)
                });
                // `RecipPositive` is NaN unless its argument is positive. Applied twice, it is the number, or NaN.
                let reciprocal = graph.build(call(Function::RecipPositive, [1 - start]));
                let first = graph.call(Function::RecipPositive, &[reciprocal]);
                let last = graph.build(call(Function::RecipPositive, [1 + end]));
                Factors { first, last, change: graph.build(-((start + end) * last)) }
            }
        }
    }
}

impl Equation {
    /// The step D₁ ∘ RATTLE ∘ D₀ of a step of RATTLE.
    pub(crate) fn damped(self, graph: &mut Graph, damping: Damping, decay: Id) -> Equation {
        let Factors { first, last, change } = damping.factors(graph, decay);
        let mut after_first = Substitution::new(|graph: &mut Graph, symbol| match symbol {
            Symbol::Momentum(_) => {
                let p = graph.symbol(symbol);
                Some(graph.mul(first, p))
            }
            _ => None,
        });
        let mut after = |graph: &mut Graph, nodes: Vec<Id>| -> Vec<Id> {
            nodes.into_iter().map(|node| after_first.apply(graph, node)).collect()
        };
        let [residual, end, origin] = [self.residual, self.end, self.origin].map(|nodes| after(graph, nodes));
        let action = self.action.map(|action| after(graph, vec![action])[0]);
        // The increment of x = p or s is last·(first·x + d) − x.
        let grown = |graph: &mut Graph, symbol, d: Id| {
            let x = graph.symbol(symbol);
            graph.build(change * x + last * d)
        };
        let (dq, dp) = end.split_at(end.len() / 2);
        let dp = (0..).zip(dp).map(|(i, d)| grown(graph, Symbol::Momentum(i), *d)).collect();
        Equation {
            unknowns: self.unknowns,
            residual,
            end: [dq.to_vec(), dp].concat(),
            action: action.map(|d| grown(graph, Symbol::Action, d)),
            origin,
        }
    }
}

impl Action {
    /// h L_d = p̄·(q₁ − q₀) − h/2 (H₀(q₀, p̄, t₀) + H₀(q₁, p̄, t₁)) of a step of RATTLE with the momenta p̄ in the middle and q₁ = q₀ + `dq`.
    pub(super) fn of_rattle(self, graph: &mut Graph, momenta: &[Id], dq: &[Id]) -> Id {
        let h = graph.symbol(Symbol::StepLength);
        let start: Vec<Id> = (0..dq.len() as u32).map(|i| graph.symbol(Symbol::Position(i))).collect();
        let end = ends(graph, Symbol::Position, dq);
        let [first, last] = [(start, Symbol::StepStart), (end, Symbol::StepEnd)].map(|(positions, time)| {
            let time = graph.symbol(time);
            moved(graph, &[self.energy], &positions, Some(momenta), time)[0]
        });
        let power = graph.dot(momenta, dq);
        graph.build(power - Number::HALF * h * (first + last))
    }

    /// The sum Σ = P₁ + P₀ − 2p₀ of the discrete gradient, from its value without friction, `impulse`. The friction is that of the mean momentum:
    /// Σ = impulse − hγ(p₀ + Σ/2). NaN for hγ ≤ −2: no solution there is continuous in h.
    pub(super) fn damped_sum(self, graph: &mut Graph, impulse: &[Id]) -> Vec<Id> {
        if graph.is_zero(self.decay) {
            return impulse.to_vec();
        }
        let h = graph.symbol(Symbol::StepLength);
        let drag = graph.mul(h, self.decay);
        let inertia = graph.build(call(Function::RecipPositive, [1 + Number::HALF * drag]));
        let momenta: Vec<Id> = (0..impulse.len() as u32).map(|i| graph.symbol(Symbol::Momentum(i))).collect();
        let mut damped = |(impulse, p): (&Id, Id)| graph.build((*impulse - drag * p) * inertia);
        impulse.iter().zip(momenta).map(&mut damped).collect()
    }

    /// The factor e^(−hγ/2) of the normal momenta ν over a step of the discrete gradient.
    pub(super) fn factor_of_normal(self, graph: &mut Graph) -> Id {
        let h = graph.symbol(Symbol::StepLength);
        graph.build(call(Function::Exp, [-(Number::HALF * h * self.decay)]))
    }

    /// The increment of s over a step of the discrete gradient: p̄·(q₁ − q₀) − h H̄, with the mean momentum p̄ = p₀ + Σ/2, and the mean H̄ of an energy that
    /// constraints change at a constant rate.
    pub(super) fn of_gradient(self, graph: &mut Graph, step: &GradientStep<'_>) -> Id {
        let GradientStep { dq, sum, energy, work } = *step;
        let [h, s] = [Symbol::StepLength, Symbol::Action].map(|symbol| graph.symbol(symbol));
        let mut terms = vec![];
        for (i, (dq, sum)) in (0..).zip(dq.iter().zip(sum)) {
            let p = graph.symbol(Symbol::Momentum(i));
            terms.push(graph.build((p + Number::HALF * *sum) * *dq));
        }
        let power = graph.sum(&terms);
        let drag = graph.mul(h, self.decay);
        let mean = match graph.is_zero(drag) {
            true => graph.build(energy + Number::HALF * work),
            // φ₂(−x) = e^(−x) φ₁'(x).
            false => graph.build(
                (energy + self.decay * s) * call(Function::Phi1, [-drag])
                    + work * call(Function::Exp, [-drag]) * call(Function::Phi1Derivative, [drag]),
            ),
        };
        graph.build(power - h * mean)
    }
}
