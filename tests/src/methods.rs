//! Lists of methods for tests.
//!
//! A list is a function that shows each of its methods to a [`Visitor`]. The type of the system must satisfy the bounds of the list. This
//! file re-exports lists of the runtime's catalogue, adds compositions and parameters, and defines short lists with one method for each kind
//! of step. The macros `every_kind!` and `every_method!` write a test for each kind of phase space.

pub use geoint_runtime::method::Visitor;
pub use geoint_runtime::method::catalogue::{
    constrained, coupled, cubic, force_gradient, general, itoh_abe_one_way, mechanical, perturbed, perturbed_gradient,
    pieces, projected, quadratic_kinetic as nystrom, relaxed, separable,
};

use geoint_runtime::Real;
use geoint_runtime::method::SteppedAs;
use geoint_runtime::method::catalogue;
use geoint_runtime::method::constrained::DampedRattle;
use geoint_runtime::method::implicit::SolvedBy;
use geoint_runtime::methods::*;
use geoint_runtime::private::{Collocation, DiscreteField, QuadraticField, SolvedByContactGauss, SolvedByGauss};
use geoint_runtime::system::Conservative;
use geoint_runtime::system::Pieces;
use geoint_runtime::{
    ForceGradient, Perturbation, Perturbed, PerturbedGradient, PhaseSpace, PlanarSplitting, PoissonSplitting,
    QuadraticKinetic, Rattle, Separable,
};

/// Perturbation and force-gradient methods with a processor.
pub fn processed<S: PerturbedGradient<R> + ForceGradient<R> + PhaseSpace<R, Action = ()>, R: Real>(
    visitor: &mut impl Visitor<S, R>,
) {
    catalogue::processed(visitor);
    catalogue::processed_force_gradient(visitor);
}

/// Methods by discrete gradients that treat all coordinates alike, for every H with known divided differences. Compositions of such methods
/// are included.
pub fn discrete_gradient<S, R: Real>(visitor: &mut impl Visitor<S, R>)
where
    S: DiscreteField<R> + Conservative<R> + SolvedBy<DiscreteGradient, R>,
{
    catalogue::discrete_gradient(visitor);
    catalogue::mean_gradients(visitor);
    visitor.visit(FourthOrder(MeanValue::<3>));
    visitor.visit(Suzuki4.of(Gonzalez));
    visitor.visit(Suzuki4.of(MeanValue::<2>));
}

/// Symmetric discrete gradients that change one coordinate after the other, and methods made of them.
///
/// The list is separate, because these steps take many times as long as steps of [`discrete_gradient`].
pub fn itoh_abe<S: DiscreteField<R> + Conservative<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    catalogue::itoh_abe(visitor);
    visitor.visit(FourthOrder(SymmetrisedItohAbe));
    visitor.visit(Suzuki4.of(SymmetrisedItohAbe));
    visitor.visit(Suzuki4.of(ItohAbePair));
}

/// The discrete gradient of coordinate increments, with the default parameters and with others.
///
/// The scene should have one degree of freedom. With more, some steps do not exist.
pub fn coordinate_increment<S: DiscreteField<R> + Conservative<R>, R: Real>(visitor: &mut impl Visitor<S, R>) {
    catalogue::coordinate_increment(visitor);
    visitor.visit(CoordinateIncrement { alpha: 0.2, beta: 0.9, gamma: 1.0, delta: 0.3 });
}

/// Defines lists with one method for each kind of step.
///
/// Methods of one kind run through the same code and differ in their coefficients only. A test visits the kinds if its claim does not depend on
/// coefficients, because each method costs about as much time to compile as to run. `geoint-verification` measures every method of every list.
///
/// Syntax: `name [bounds of the system]: method, method, …;`.
macro_rules! kinds {
    ($($(#[$doc:meta])* $list:ident [$($bounds:tt)*]: $($method:expr),*;)*) => { $(
        $(#[$doc])*
        pub fn $list<S, R: Real>(visitor: &mut impl Visitor<S, R>)
        where
            S: $($bounds)*
        {
            $( visitor.visit($method); )*
        }
    )* };
}

kinds! {
    /// Kinds of [`general`].
    kinds_of_general [Collocation<R> + SolvedByGauss<R>]:
        ExplicitEuler, RK4, ImplicitMidpoint, Gauss::<3>, Suzuki4.of(ImplicitMidpoint);
    /// Kinds of [`discrete_gradient`].
    kinds_of_discrete_gradient [DiscreteField<R> + Conservative<R> + SolvedBy<DiscreteGradient, R>]:
        DiscreteGradient, Gonzalez, MeanValue::<2>, FourthOrder(DiscreteGradient), Suzuki4.of(DiscreteGradient);
    /// Kinds of [`itoh_abe`].
    kinds_of_itoh_abe [DiscreteField<R> + Conservative<R>]: SymmetrisedItohAbe, ItohAbePair, FourthOrder(SymmetrisedItohAbe);
    /// Kinds of [`cubic`].
    kinds_of_cubic [QuadraticField<R> + Conservative<R>]: Kahan, Suzuki4.of(Kahan);
    /// Kinds of [`separable`].
    kinds_of_separable [Separable<R>]: SymplecticEuler, StormerVerlet, BlanesMoan6, Suzuki4.of(PositionVerlet);
    /// Kinds of [`nystrom`].
    kinds_of_nystrom [QuadraticKinetic<R>]: BlanesMoanSrkn11b, BlanesMoanSrkn14a;
    /// Kinds of [`force_gradient`].
    kinds_of_force_gradient [ForceGradient<R>]: TakahashiImada2, Chin4C, Omelyan6_5F3GP;
    /// Kinds of [`perturbed`].
    kinds_of_perturbed [Perturbed<R>]: WisdomHolman, Aba8_6_4, Perturbation(BlanesMoan4);
    /// Kinds of [`perturbed_gradient`].
    kinds_of_perturbed_gradient [PerturbedGradient<R>]: Saba4Gradient, Rnia10_8_6, Perturbation(Chin4A);
    /// Kinds of [`coupled`].
    kinds_of_coupled [Pieces<PieceSplitting, R>]: PieceSplitting, BlanesMoan4X.of(PieceSplitting), Suzuki4.of(PieceSplitting);
    /// Kinds of [`constrained`].
    kinds_of_constrained [SolvedBy<Rattle, R> + SolvedBy<DiscreteGradient, R>]:
        Rattle, DiscreteGradient, Suzuki4.of(Rattle), Suzuki4.of(DiscreteGradient);
    /// Kinds of [`pieces`], for contact systems.
    kinds_of_pieces [Pieces<ContactSplitting, R> + SteppedAs<ContactSplitting, R, Steps = PieceComposition<1>>]:
        ContactSplitting, BlanesMoan4X, Suzuki4.of(ContactSplitting);
    /// Kinds of [`catalogue::constrained_contact`].
    kinds_of_constrained_contact [
        SteppedAs<ContactSplitting, R, Steps = DampedRattle<ContactSplitting>>
            + SolvedBy<DampedRattle<ContactSplitting>, R>
            + SteppedAs<ContactLeapfrog, R>
            + SolvedBy<ContactDiscreteGradient, R>
    ]: ContactSplitting, ContactLeapfrog, ContactDiscreteGradient, Suzuki4.of(ContactSplitting),
        Suzuki4.of(ContactDiscreteGradient);
    /// Kinds of [`catalogue::mechanical`].
    kinds_of_mechanical [SteppedAs<ContactLeapfrog, R>]: ContactLeapfrog, Suzuki4.of(ContactLeapfrog);
    /// Kinds of [`catalogue::contact`].
    kinds_of_contact [
        SolvedByContactGauss<R> + SolvedBy<ContactMidpoint, R> + SolvedBy<ContactDiscreteGradient, R>
    ]: ContactGauss::<1>, ContactGauss::<3>, ContactMidpoint, ContactDiscreteGradient, Suzuki4.of(ContactMidpoint),
        Suzuki4.of(ContactDiscreteGradient);
    /// Kinds of [`catalogue::poisson`].
    kinds_of_poisson [Pieces<PoissonSplitting, R>]:
        PoissonSplitting, BlanesMoan4X.of(PoissonSplitting), Suzuki4.of(PoissonSplitting);
    /// Kinds of [`catalogue::planar`].
    kinds_of_planar [Pieces<PlanarSplitting, R>]: PlanarSplitting, Suzuki4.of(PlanarSplitting);
}

/// Writes a test for each kind of phase space. The test shows one method for each kind of step to `$Visitor`.
///
/// `$Visitor` is a struct with one type parameter, the scene, and with the fields `h`, the step size, and `scene`, a `PhantomData`.
#[macro_export]
macro_rules! every_kind {
    ($Visitor:ident) => {
        $crate::every_method! { $Visitor:
            canonical on $crate::problems::HenonHeiles, 0.05: methods kinds_of_general, methods kinds_of_discrete_gradient,
                methods kinds_of_itoh_abe, methods itoh_abe_one_way, methods kinds_of_separable, methods kinds_of_nystrom,
                methods kinds_of_force_gradient, methods kinds_of_perturbed, methods kinds_of_perturbed_gradient,
                methods processed, methods projected, methods relaxed, methods kinds_of_cubic;
            in_coordinates_of_jacobi on $crate::problems::Planets, 0.05: methods kinds_of_perturbed, methods processed;
            one_degree_of_freedom on $crate::scenes::Shears, 0.05: methods coordinate_increment, methods kinds_of_coupled;
            constrained on $crate::scenes::Spheres, 0.02: methods kinds_of_constrained;
            constrained_contact on $crate::scenes::DampedSpheres, 0.02: methods kinds_of_constrained_contact;
            contact on $crate::scenes::Charges, 0.05: methods kinds_of_pieces, methods kinds_of_contact;
            damped on $crate::scenes::Relativists, 0.05: methods kinds_of_separable, methods kinds_of_mechanical;
            flows on $crate::scenes::Spins, 0.05: methods kinds_of_poisson, methods kinds_of_planar;
            bodies on $crate::scenes::Heavies, 0.05: methods kinds_of_separable, catalogue principal_axes;
        }
    };
}

/// Writes a test for each kind of phase space. The test shows every method of its lists to `$Visitor`.
///
/// `$Visitor` is a struct as in `every_kind!`. The second rule writes the tests for given scenes and lists:
/// `name of the test on scene, step size: module list, module list, …;`, where the module is `methods` or `catalogue`.
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
            constrained_contact on $crate::scenes::DampedSpheres, 0.02: catalogue constrained_contact;
            contact on $crate::scenes::Charges, 0.05: catalogue pieces, catalogue contact;
            damped on $crate::scenes::Relativists, 0.05: methods separable, catalogue mechanical;
            flows on $crate::scenes::Spins, 0.05: catalogue poisson, catalogue planar;
            bodies on $crate::scenes::Heavies, 0.05: methods separable, catalogue principal_axes;
        }
    };
    ($Visitor:ident: $($test:ident on $Scene:ty, $h:literal: $($from:ident $list:ident),*;)*) => { $(
        #[test]
        fn $test() {
            // Some tests take all their lists from one of the two modules.
            #[allow(unused_imports)]
            use {geoint_runtime::method::catalogue, $crate::methods};
            let mut visitor = $Visitor::<$Scene> { h: $h, scene: std::marker::PhantomData };
            $( $from::$list(&mut visitor); )*
        }
    )* };
}
