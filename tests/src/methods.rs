//! The list of all methods. Whatever is claimed of methods is tested by walking it.

use geoint_runtime::prelude::*;
use geoint_runtime::system::{Collocation, DiscreteField};
use geoint_runtime::{Autonomous, Hamiltonian, Method, QuadraticKinetic, Real, Separable};

/// What is done with every method.
pub trait Visitor<S: Hamiltonian<R>, R: Real> {
    /// Called once for a method, with its name as written.
    fn visit<M: Method<S, R>>(&mut self, name: &'static str, method: M);
}

macro_rules! visit {
    ($visitor:ident: $($method:expr),* $(,)?) => { $( $visitor.visit(stringify!($method), $method); )* };
}

/// Every composition of a symmetric map.
macro_rules! compositions {
    ($visitor:ident: $map:ident) => {
        compositions!($visitor: $map; Yoshida4 Suzuki4 McLachlan4 Yoshida6a McLachlan6_9 KahanLi8_17a SofroniouSpaletta10_35)
    };
    ($visitor:ident: $map:ident; $($composition:ident)*) => {
        $( $visitor.visit(concat!(stringify!($composition), ".of(", stringify!($map), ")"), $composition.of($map)); )*
    };
}

/// Methods for every H.
pub fn general<S, R: Real, V: Visitor<S, R>>(visitor: &mut V)
where
    S: Collocation<R>,
{
    visit!(visitor: ExplicitEuler, RK4, DOP853);
    visit!(visitor: ImplicitMidpoint, Gauss::<1>, Gauss::<2>, Gauss::<3>, Gauss::<4>, Gauss::<5>, Gauss::<6>);
    compositions!(visitor: ImplicitMidpoint);
}

/// Methods for every H whose divided differences are known.
pub fn discrete_gradient<S, R: Real, V: Visitor<S, R>>(visitor: &mut V)
where
    S: DiscreteField<R>,
{
    visit!(visitor: DiscreteGradient);
    compositions!(visitor: DiscreteGradient);
}

/// Methods that keep the energy because each step is projected.
pub fn projected<S, R: Real, V: Visitor<S, R>>(visitor: &mut V)
where
    S: DiscreteField<R> + Autonomous<R>,
{
    visit!(visitor: Projection(RK4, Energy), Projection(DOP853, Energy));
}

/// Methods that keep the energy because each step is scaled. They need an energy that is nowhere straight along the flow: some
/// are refused steps elsewhere, and have no order there.
pub fn relaxed<S, R: Real, V: Visitor<S, R>>(visitor: &mut V)
where
    S: DiscreteField<R> + Autonomous<R>,
{
    visit!(visitor: Relaxation(RK4), Relaxation(DOP853));
}

/// Methods for H = T(p, t) + V(q, t).
pub fn separable<S, R: Real, V: Visitor<S, R>>(visitor: &mut V)
where
    S: Separable<R>,
{
    visit!(visitor: SymplecticEuler, SymplecticEulerAdjoint, StormerVerlet, PositionVerlet);
    visit!(visitor: ForestRuth4, PEFRL, BlanesMoan4, BlanesMoan6);
    compositions!(visitor: StormerVerlet);
    compositions!(visitor: PositionVerlet);
}

/// Methods that need a T quadratic in p with a constant mass matrix.
pub fn nystrom<S, R: Real, V: Visitor<S, R>>(visitor: &mut V)
where
    S: QuadraticKinetic<R>,
{
    visit!(visitor: BlanesMoanSrkn6b, BlanesMoanSrkn11b, BlanesMoanSrkn14a, BceRkn17_8);
}
