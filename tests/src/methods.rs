//! The list of all methods. Whatever is claimed of methods is tested by walking it.

use geoint_runtime::prelude::*;
use geoint_runtime::system::{Collocation, Conservative, DiscreteField, QuadraticField};
use geoint_runtime::{Autonomous, ForceGradient, Hamiltonian, Method, QuadraticKinetic, Real, Separable};

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
    S: Collocation<R> + Hamiltonian<R>,
{
    visit!(visitor: ExplicitEuler, RK4, DOP853);
    visit!(visitor: ImplicitMidpoint, Gauss::<1>, Gauss::<2>, Gauss::<3>, Gauss::<4>, Gauss::<5>, Gauss::<6>);
    compositions!(visitor: ImplicitMidpoint);
}

/// Methods for every H whose divided differences are known.
pub fn discrete_gradient<S, R: Real, V: Visitor<S, R>>(visitor: &mut V)
where
    S: DiscreteField<R> + Conservative<R>,
{
    visit!(visitor: DiscreteGradient, Gonzalez, MeanValue::<2>);
    visit!(visitor: FourthOrder(DiscreteGradient), FourthOrder(Gonzalez), FourthOrder(MeanValue::<3>));
    compositions!(visitor: DiscreteGradient);
    compositions!(visitor: Gonzalez; Suzuki4);
    visit!(visitor: Suzuki4.of(MeanValue::<2>));
}

/// Those that take one coordinate after the other, and many times as long.
pub fn itoh_abe<S, R: Real, V: Visitor<S, R>>(visitor: &mut V)
where
    S: DiscreteField<R> + Conservative<R>,
{
    visit!(visitor: SymmetrisedItohAbe, ItohAbePair, FourthOrder(SymmetrisedItohAbe));
    compositions!(visitor: SymmetrisedItohAbe; Suzuki4);
    compositions!(visitor: ItohAbePair; Suzuki4);
}

/// The same of order 1. Where H is a sum over single coordinates they have order 2 and are symmetric.
pub fn itoh_abe_one_way<S, R: Real, V: Visitor<S, R>>(visitor: &mut V)
where
    S: DiscreteField<R> + Conservative<R>,
{
    visit!(visitor: ItohAbe, ItohAbeAdjoint);
}

/// Those that have no step where an increment is orthogonal to its direction, which with one degree of freedom is nowhere.
pub fn coordinate_increment<S, R: Real, V: Visitor<S, R>>(visitor: &mut V)
where
    S: DiscreteField<R> + Conservative<R>,
{
    visit!(visitor: CoordinateIncrement::default());
    visit!(visitor: CoordinateIncrement { alpha: 0.2, beta: 0.9, gamma: 1.0, delta: 0.3 });
}

/// Methods for H of degree 3.
pub fn cubic<S, R: Real, V: Visitor<S, R>>(visitor: &mut V)
where
    S: QuadraticField<R> + Conservative<R>,
{
    visit!(visitor: Kahan);
    compositions!(visitor: Kahan; Suzuki4);
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
    S: Separable<R> + Hamiltonian<R>,
{
    visit!(visitor: SymplecticEuler, SymplecticEulerAdjoint, StormerVerlet, PositionVerlet);
    visit!(visitor: ForestRuth4, PEFRL, BlanesMoan4, BlanesMoan6);
    compositions!(visitor: StormerVerlet);
    compositions!(visitor: PositionVerlet);
}

/// Methods that need a T quadratic in p with a constant mass matrix.
pub fn nystrom<S, R: Real, V: Visitor<S, R>>(visitor: &mut V)
where
    S: QuadraticKinetic<R> + Hamiltonian<R>,
{
    visit!(visitor: BlanesMoanSrkn6b, BlanesMoanSrkn11b, BlanesMoanSrkn14a, BceRkn17_8);
}

/// Methods that need one, and kick with force gradients.
pub fn force_gradient<S, R: Real, V: Visitor<S, R>>(visitor: &mut V)
where
    S: ForceGradient<R> + Hamiltonian<R>,
{
    visit!(visitor: TakahashiImada2, Chin4A, Chin4B, Chin4C, Chin4D);
    visit!(visitor: Omelyan4_4F2GV, Omelyan4_5F2GP, Omelyan6_5F3GP, Omelyan8_11F11GP);
}
