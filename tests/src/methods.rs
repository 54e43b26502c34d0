//! What tests visit beside the catalogue of the runtime. Whatever is claimed of methods is tested by walking both.

pub use geoint_runtime::method::Visitor;
pub use geoint_runtime::method::catalogue::{
    constrained, coupled, cubic, force_gradient, general, itoh_abe_one_way, perturbed, perturbed_gradient, processed,
    projected, quadratic_kinetic as nystrom, relaxed, separable,
};

use geoint_runtime::Real;
use geoint_runtime::method::catalogue;
use geoint_runtime::prelude::*;
use geoint_runtime::system::{Conservative, DiscreteField};

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
