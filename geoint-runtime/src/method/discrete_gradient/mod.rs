//! x₁ = x₀ + h (J − R) ∇̄H(x₀, x₁): steps that keep the energy to rounding, or lose what damping R takes.

mod coordinate_increment;
mod energy;
mod fourth_order;
mod gonzalez;
mod itoh_abe;
mod matrix;
mod mean;
mod mean_value;
mod tree;

pub use coordinate_increment::CoordinateIncrement;
pub use energy::{Energy, Slope, Staircase};
pub use fourth_order::FourthOrder;
pub use gonzalez::Gonzalez;
pub use itoh_abe::{ItohAbe, ItohAbeAdjoint, ItohAbePair, SymmetrisedItohAbe};
pub use matrix::Matrix;
pub use mean::MeanGradient;
pub use mean_value::MeanValue;
pub use tree::DiscreteGradient;
