//! What tests visit beside the catalogue of the runtime. Whatever is claimed of methods is tested by walking both.

pub use geoint_runtime::method::Visitor;
pub use geoint_runtime::method::catalogue::{
    constrained, coupled, cubic, force_gradient, general, itoh_abe_one_way, mechanical, perturbed, perturbed_gradient,
    pieces, projected, quadratic_kinetic as nystrom, relaxed, separable,
};

use geoint_runtime::Real;
use geoint_runtime::method::catalogue;
use geoint_runtime::prelude::*;
use geoint_runtime::system::{ByField, Collocated, Collocation, Conservative, DiscreteField};
use geoint_runtime::{ForceGradient, PerturbedGradient, PhaseSpace, Pieces, QuadraticKinetic, Separable};

/// Methods with a processor.
pub fn processed<S: PerturbedGradient<R> + ForceGradient<R> + PhaseSpace<R, Action = ()>, R: Real>(
    visitor: &mut impl Visitor<S, R>,
) {
    catalogue::processed(visitor);
    catalogue::processed_force_gradient(visitor);
}

/// Methods for every H whose divided differences are known, and others made of them.
pub fn discrete_gradient<S: DiscreteField<R> + Conservative<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    catalogue::discrete_gradient(visitor);
    catalogue::mean_gradients(visitor);
    visitor.visit(FourthOrder(MeanValue::<3>));
    visitor.visit(Suzuki4.of(Gonzalez));
    visitor.visit(Suzuki4.of(MeanValue::<2>));
}

/// Those that take one coordinate after the other, and many times as long.
pub fn itoh_abe<S: DiscreteField<R> + Conservative<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    catalogue::itoh_abe(visitor);
    visitor.visit(FourthOrder(SymmetrisedItohAbe));
    visitor.visit(Suzuki4.of(SymmetrisedItohAbe));
    visitor.visit(Suzuki4.of(ItohAbePair));
}

/// Those that need one degree of freedom, with another choice of their parameters.
pub fn coordinate_increment<S: DiscreteField<R> + Conservative<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    catalogue::coordinate_increment(visitor);
    visitor.visit(CoordinateIncrement { alpha: 0.2, beta: 0.9, gamma: 1.0, delta: 0.3 });
}

/// One method of each kind of step in [`general`], for a scene beside one on which the whole list is walked: tables go through the same
/// steps.
pub fn kinds_of_general<S: Collocation<R> + Collocated<R, Stages = ByField>, R: Real>(
    visitor: &mut impl Visitor<S, R>,
) {
    visitor.visit(ExplicitEuler);
    visitor.visit(RK4);
    visitor.visit(ImplicitMidpoint);
    visitor.visit(Gauss::<3>);
    visitor.visit(Suzuki4.of(ImplicitMidpoint));
}

/// The same of [`discrete_gradient`].
pub fn kinds_of_discrete_gradient<S: DiscreteField<R> + Conservative<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    visitor.visit(DiscreteGradient);
    visitor.visit(Gonzalez);
    visitor.visit(MeanValue::<2>);
    visitor.visit(FourthOrder(DiscreteGradient));
    visitor.visit(Suzuki4.of(DiscreteGradient));
}

/// The same of [`separable`].
pub fn kinds_of_separable<S: Separable<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    visitor.visit(SymplecticEuler);
    visitor.visit(StormerVerlet);
    visitor.visit(BlanesMoan6);
    visitor.visit(Suzuki4.of(PositionVerlet));
}

/// The same of [`nystrom`].
pub fn kinds_of_nystrom<S: QuadraticKinetic<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    visitor.visit(BlanesMoanSrkn11b);
    visitor.visit(BlanesMoanSrkn14a);
}

/// The same of [`force_gradient`].
pub fn kinds_of_force_gradient<S: ForceGradient<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    visitor.visit(TakahashiImada2);
    visitor.visit(Chin4C);
    visitor.visit(Omelyan6_5F3GP);
}

/// The same of contact systems in [`pieces`].
pub fn kinds_of_pieces<S: Pieces<ContactSplitting, R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    visitor.visit(ContactSplitting);
    visitor.visit(BlanesMoan4X);
    visitor.visit(Suzuki4.of(ContactSplitting));
}

/// A test for each kind of phase space: `$Visitor`, a step size and a scene, is shown every method for it.
#[macro_export]
macro_rules! every_method {
    ($Visitor:ident) => {
        $crate::every_method! { $Visitor:
            canonical on $crate::problems::HenonHeiles, 0.05: methods general, methods discrete_gradient, methods itoh_abe,
                methods itoh_abe_one_way, methods separable, methods nystrom, methods force_gradient, methods perturbed,
                methods perturbed_gradient, methods processed, methods projected, methods relaxed, methods cubic;
            in_coordinates_of_jacobi on $crate::problems::Planets, 0.05: methods perturbed, methods processed;
            one_degree_of_freedom on $crate::scenes::Shears, 0.05: methods coordinate_increment, catalogue coupled;
            constrained on $crate::scenes::Spheres, 0.02: methods constrained;
            contact on $crate::scenes::Charges, 0.05: catalogue pieces, catalogue contact;
            damped on $crate::scenes::Relativists, 0.05: methods separable, catalogue mechanical;
            flows on $crate::scenes::Spins, 0.05: catalogue poisson, catalogue planar;
            bodies on $crate::scenes::Heavies, 0.05: methods separable, catalogue principal_axes;
        }
    };
    ($Visitor:ident: $($test:ident on $Scene:ty, $h:literal: $($from:ident $list:ident),*;)*) => { $(
        #[test]
        fn $test() {
            #[allow(unused_imports)]
            use {geoint_runtime::method::catalogue, $crate::methods};
            let mut visitor = $Visitor::<$Scene> { h: $h, scene: std::marker::PhantomData };
            $( $from::$list(&mut visitor); )*
        }
    )* };
}
