//! Lists of the methods of this crate, sorted by the properties of a system that they need.
//!
//! Programs use them to try all methods, or to select a method by its name. Each function calls a visitor with its methods. A system has
//! the methods of the functions whose bounds it satisfies. The lists contain compositions of the most common maps only. Add others by a
//! line such as `visitor.visit(KahanLi8_17a.of(Gonzalez))`.
//!
//! ```
//! use geoint_runtime::method::{Name, Visitor, catalogue};
//! use geoint_runtime::prelude::*;
//!
//! #[hamiltonian]
//! fn oscillator(q: f64, p: f64, k: f64) -> f64 {
//!     p * p / 2.0 + k * q.powi(4) / 4.0
//! }
//!
//! /// Finds the method with the smallest energy error for h = 0.1.
//! struct Best(Option<(Name, f64)>);
//!
//! impl Visitor<Oscillator> for Best {
//!     fn visit<M: Method<Oscillator> + 'static>(&mut self, method: M) {
//!         let mut sim = Oscillator { k: 1.3 }.integrator(method, 0.1, State::new(1.0, 0.0));
//!         let energy = sim.energy();
//!         if sim.advance(100).is_ok() {
//!             let error = (sim.energy() - energy).abs();
//!             if self.0.is_none_or(|(_, least)| error < least) {
//!                 self.0 = Some((method.name(), error));
//!             }
//!         }
//!     }
//! }
//!
//! let mut best = Best(None);
//! catalogue::separable(&mut best);
//! catalogue::general(&mut best);
//! assert!(best.0.is_some_and(|(_, error)| error < 1e-12));
//! ```

use crate::method::constrained::{DampedRattle, Rattle};
use crate::method::contact::{
    ContactDiscreteGradient, ContactGauss, ContactLeapfrog, ContactMidpoint, SolvedByContactGauss,
};
use crate::method::corrected::{Energy, Projection, Relaxation};
use crate::method::discrete_gradient::{
    CoordinateIncrement, DiscreteGradient, FourthOrder, Gonzalez, ItohAbe, ItohAbeAdjoint, ItohAbePair, MeanValue,
    SymmetrisedItohAbe,
};
use crate::method::explicit::{DOP853, ExplicitEuler, RK4};
use crate::method::flows::perturbed::Perturbation;
use crate::method::flows::pieces::{
    ContactSplitting, PieceComposition, PieceSplitting, PlanarDiscreteGradient, PlanarItohAbe, PlanarItohAbeAdjoint,
    PlanarItohAbePair, PlanarSplitting, PoissonSplitting,
};
use crate::method::flows::{FiveRotations, PositionVerlet, StormerVerlet, SymplecticEuler, SymplecticEulerAdjoint};
use crate::method::gauss::{Gauss, ImplicitMidpoint, SolvedByGauss};
use crate::method::implicit::SolvedBy;
use crate::method::kahan::Kahan;
use crate::method::tables::*;
use crate::method::{Method, SteppedAs};
use crate::scalar::Real;
use crate::system::{
    Autonomous, Collocation, Conservative, DiscreteField, ForceGradient, NystromPieces, Perturbed, PerturbedGradient,
    PhaseSpace, Pieces, PrincipalAxes, QuadraticField, QuadraticKinetic, Separable,
};

/// Receives each method of a list. A visitor that prints `method.name()` lists the names that [`Named`](crate::running::Named) accepts.
pub trait Visitor<S: PhaseSpace<R>, R: Real = f64> {
    /// Called once for each method.
    fn visit<M: Method<S, R> + 'static>(&mut self, method: M);
}

macro_rules! show {
    ($visitor:ident: $($method:expr),* $(,)?) => { $( $visitor.visit($method); )* };
}

/// Calls the visitor with all compositions of symmetric maps.
macro_rules! compositions {
    ($visitor:ident: $($map:expr),*) => { $(
        show!($visitor: Yoshida4.of($map), Suzuki4.of($map), McLachlan4.of($map), Yoshida6a.of($map), McLachlan6_9.of($map),
            KahanLi8_17a.of($map), SofroniouSpaletta10_35.of($map));
    )* };
}

/// Methods for every H(q, p, t).
pub fn general<S: Collocation<R> + SolvedByGauss<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: ExplicitEuler, RK4, DOP853, ImplicitMidpoint);
    show!(visitor: Gauss::<1>, Gauss::<2>, Gauss::<3>, Gauss::<4>, Gauss::<5>, Gauss::<6>);
    compositions!(visitor: ImplicitMidpoint);
}

/// Methods for H = T(p, t) + V(q, t), and for T(p) + g(t)s + V(q) of contact systems.
pub fn separable<S: Separable<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: SymplecticEuler, SymplecticEulerAdjoint, StormerVerlet, PositionVerlet);
    show!(visitor: ForestRuth4, PEFRL, BlanesMoan4, BlanesMoan6);
    compositions!(visitor: StormerVerlet, PositionVerlet);
}

/// Methods that need a quadratic T with a constant mass matrix.
pub fn quadratic_kinetic<S: QuadraticKinetic<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: BlanesMoanSrkn6b, BlanesMoanSrkn11b, BlanesMoanSrkn14a, BceRkn17_8, BceRkn19_8);
}

/// Methods that kick with force gradients.
pub fn force_gradient<S: ForceGradient<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: TakahashiImada2, Chin4A, Chin4B, Chin4C, Chin4D);
    show!(visitor: Omelyan4_4F2GV, Omelyan4_5F2GP, Omelyan6_5F3GP, Omelyan6_5F4GV, Omelyan8_11F11GP);
}

/// The force-gradient method with a processor, for systems without an action.
pub fn processed_force_gradient<S: ForceGradient<R> + PhaseSpace<R, Action = ()>, R: Real>(
    visitor: &mut impl Visitor<S, R>,
) {
    show!(visitor: BlanesCasasRos6);
}

/// Methods for H = A + B with an exact flow of A and a kick by B.
pub fn perturbed<S: Perturbed<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: WisdomHolman, Saba4, Aba8_4, Aba8_6_4, Aba10_6_4);
    show!(visitor: Perturbation(StormerVerlet), Perturbation(BlanesMoan4), Perturbation(BlanesMoan6));
}

/// Methods for H = A + B that need \[B, \[A, B\]\] to be a kick, or \[B, \[B, \[B, A\]\]\] = 0.
pub fn perturbed_gradient<S: PerturbedGradient<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: Saba2Gradient, Saba3Gradient, Saba4Gradient, Saba5Gradient, Rnia10_8_6);
    show!(visitor: Perturbation(BlanesMoanSrkn6b), Perturbation(BlanesMoanSrkn14a), Perturbation(Chin4A));
}

/// Methods for H = A + B with a processor.
pub fn processed<S: PerturbedGradient<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: WisdomHolmanProcessed, WisdomHolmanGradient);
}

/// The method for rigid bodies in their principal axes. Such systems also have the methods of [`separable`], [`quadratic_kinetic`] and [`force_gradient`].
pub fn principal_axes<S: PrincipalAxes<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: FiveRotations);
}

/// The discrete gradient that keeps the energy, or satisfies the energy balance of damping, and its compositions.
pub fn discrete_gradient<S: SolvedBy<DiscreteGradient, R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: DiscreteGradient);
    compositions!(visitor: DiscreteGradient);
}

/// Methods that keep the energy of systems without damping: [`mean_gradients`], [`itoh_abe`], [`itoh_abe_one_way`] and [`coordinate_increment`].
pub fn conservative<S: DiscreteField<R> + Conservative<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    mean_gradients(visitor);
    itoh_abe(visitor);
    itoh_abe_one_way(visitor);
    coordinate_increment(visitor);
}

/// Discrete gradients that treat all coordinates alike, such as means of gradients.
pub fn mean_gradients<S: DiscreteField<R> + Conservative<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: Gonzalez, FourthOrder(DiscreteGradient), FourthOrder(Gonzalez));
    show!(visitor: MeanValue::<1>, MeanValue::<2>, MeanValue::<3>, MeanValue::<4>, MeanValue::<5>, MeanValue::<6>);
}

/// Symmetric Itoh–Abe methods, which change one coordinate after the other, in both orders.
pub fn itoh_abe<S: DiscreteField<R> + Conservative<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: SymmetrisedItohAbe, ItohAbePair);
}

/// Itoh–Abe methods of order 1, which change one coordinate after the other in one order.
pub fn itoh_abe_one_way<S: DiscreteField<R> + Conservative<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: ItohAbe, ItohAbeAdjoint);
}

/// The coordinate increment method. No step exists if an increment is orthogonal to its direction. For one degree of freedom this never happens.
pub fn coordinate_increment<S: DiscreteField<R> + Conservative<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: CoordinateIncrement::default());
}

/// Methods that correct each step to keep the energy: [`projected`] and [`relaxed`].
pub fn autonomous<S: DiscreteField<R> + Autonomous<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    projected(visitor);
    relaxed(visitor);
}

/// Methods that project each step onto the level set of the energy.
pub fn projected<S: DiscreteField<R> + Autonomous<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: Projection(RK4, Energy), Projection(DOP853, Energy));
}

/// Methods that scale each step. They need an energy that is nowhere linear along the flow.
pub fn relaxed<S: DiscreteField<R> + Autonomous<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: Relaxation(RK4), Relaxation(DOP853));
}

/// Kahan's method for H of degree 3, and its compositions.
pub fn cubic<S: QuadraticField<R> + Conservative<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: Kahan);
    compositions!(visitor: Kahan);
}

/// Methods for H(q, p, t) whose pieces have flows in closed form, except T(p) + V(q).
pub fn coupled<S: Pieces<PieceSplitting, R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: PieceSplitting, BlanesMoan4X.of(PieceSplitting), BlanesMoan6X.of(PieceSplitting));
    compositions!(visitor: PieceSplitting);
}

/// Methods for two pieces A and B with {B, {B, {B, A}}} = 0.
pub fn nystrom_pieces<S: NystromPieces<R> + Pieces<PieceSplitting, R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: BlanesMoanSrkn14a.of(PieceSplitting), BceRkn17_8.of(PieceSplitting));
}

/// Methods for systems with constraints.
pub fn constrained<S, R: Real>(visitor: &mut impl Visitor<S, R>)
where
    S: SolvedBy<Rattle, R> + SolvedBy<DiscreteGradient, R>,
{
    show!(visitor: Rattle, DiscreteGradient);
    compositions!(visitor: Rattle, DiscreteGradient);
}

/// Methods for contact systems with constraints.
pub fn constrained_contact<S, R: Real>(visitor: &mut impl Visitor<S, R>)
where
    S: SteppedAs<ContactSplitting, R, Steps = DampedRattle<ContactSplitting>>
        + SolvedBy<DampedRattle<ContactSplitting>, R>
        + SteppedAs<ContactLeapfrog, R>
        + SolvedBy<ContactDiscreteGradient, R>,
{
    show!(visitor: ContactSplitting, ContactLeapfrog, ContactDiscreteGradient);
    compositions!(visitor: ContactSplitting, ContactLeapfrog, ContactDiscreteGradient);
}

/// Methods for contact systems whose pieces have flows in closed form.
pub fn pieces<S, R: Real>(visitor: &mut impl Visitor<S, R>)
where
    S: Pieces<ContactSplitting, R> + SteppedAs<ContactSplitting, R, Steps = PieceComposition<1>>,
{
    show!(visitor: ContactSplitting, BlanesMoan4X, BlanesMoan6X);
    compositions!(visitor: ContactSplitting);
}

/// Methods for x' = S(x) ∇H whose terms have flows in closed form.
pub fn poisson<S: Pieces<PoissonSplitting, R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: PoissonSplitting, BlanesMoan4X.of(PoissonSplitting), BlanesMoan6X.of(PoissonSplitting));
    compositions!(visitor: PoissonSplitting);
}

/// Methods for fields x' = S(x) ∇I that are split into planar parts.
pub fn planar<S: Pieces<PlanarSplitting, R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: PlanarSplitting);
    compositions!(visitor: PlanarSplitting);
}

/// Methods for fields x' = S(x) ∇I that solve an equation in every plane.
pub fn solved_planes<S, R: Real>(visitor: &mut impl Visitor<S, R>)
where
    S: Pieces<PlanarDiscreteGradient, R> + Pieces<PlanarItohAbe, R>,
{
    show!(visitor: PlanarDiscreteGradient, PlanarItohAbe, PlanarItohAbeAdjoint, PlanarItohAbePair);
    compositions!(visitor: PlanarDiscreteGradient, PlanarItohAbePair);
}

/// The methods for contact systems T(p) + g(t)s + V(q), in addition to those of [`separable`].
pub fn mechanical<S: SteppedAs<ContactLeapfrog, R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    show!(visitor: ContactLeapfrog);
    compositions!(visitor: ContactLeapfrog);
}

/// Methods for every contact system.
pub fn contact<S, R: Real>(visitor: &mut impl Visitor<S, R>)
where
    S: SolvedByContactGauss<R> + SolvedBy<ContactMidpoint, R> + SolvedBy<ContactDiscreteGradient, R>,
{
    show!(visitor: ContactGauss::<1>, ContactGauss::<2>, ContactGauss::<3>, ContactGauss::<4>, ContactGauss::<5>, ContactGauss::<6>);
    show!(visitor: ContactMidpoint, ContactDiscreteGradient);
    compositions!(visitor: ContactMidpoint, ContactDiscreteGradient);
}
