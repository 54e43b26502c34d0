//! Items that emitted code uses. Not part of the public interface.

pub use crate::method::constrained::step::MultiplierStep;
pub use crate::method::constrained::{DampedRattle, Rattle};
pub use crate::method::contact::gauss::{ContactFieldStages, SolvedByContactGauss};
pub use crate::method::contact::implicit::ContactStep;
pub use crate::method::contact::{
    ContactDiscreteGradient, ContactGauss as ContactGaussCollocation, ContactLeapfrog, ContactMidpoint,
    ExplicitLeapfrog,
};
pub use crate::method::corrected::invariants::{
    CanonicalEnergy, EnergyAndMomenta, Integral, Integrals as KeptIntegrals, VelocityEnergy,
};
pub use crate::method::discrete_gradient::DiscreteGradient;
pub use crate::method::discrete_gradient::polarised::PolarisedStep;
pub use crate::method::discrete_gradient::tree::TreeStep;
pub use crate::method::flows::pieces::{
    ContactSplitting, PieceComposition, PieceSplitting, PlanarDiscreteGradient, PlanarItohAbe, PlanarSplitting,
    PoissonSplitting, planar_step,
};
pub use crate::method::gauss::Gauss as GaussCollocation;
pub use crate::method::gauss::canonical::CanonicalStages;
pub use crate::method::gauss::fields::FieldStages;
pub use crate::method::gauss::solved::SolvedByGauss;
pub use crate::method::gauss::tableau::GaussTableau;
pub use crate::method::gauss::velocities::VelocityStages;
pub use crate::method::implicit::ImplicitMethod;
pub use crate::method::proof::{ForwardInTime, Given};
pub use crate::method::{Method, SteppedAs};
pub use crate::method::{gradient_kick, modified_verlet};
pub use crate::running::{Adaptive, Integrator, StepError, TaylorIntegrator, state_on_constraint};
pub use crate::scalar::Real;
pub use crate::solving::newton::MOST_UNKNOWNS;
pub use crate::solving::{Inverse, Inverted};
pub use crate::space::body::{Attitudes, Centres};
pub use crate::space::state::Action;
pub use crate::space::{
    Array, BodyState, ContactState, Coordinates, FlowState, PerCoordinate, Placed, Snapshot, Square, State,
};
pub use crate::system::contact::ContactEquation;
pub use crate::system::implicit::{
    CanonicalForm, Collocation, ConstrainedStep, ContactStages, DiscreteField, EquationOrder, FourthOrderField,
    Keeping, MassForm, Mean, MixedDerivatives, PolarisedForm, QuadraticField, Span, VelocityForm, VelocityStage,
    contact_gradient_of, energy_of, own_momentum, rate_of, singular_mass, unmet, velocity_of,
};
pub use crate::system::integrals::KeptMomenta;
pub use crate::system::jets::Jets;
pub use crate::system::modified::ModifiedEnergy;
pub use crate::system::pieces::NystromPieces;
pub use crate::system::{
    Autonomous, Clock as PieceClock, Conformal as ConformalContact, Conservative, Constrained as ConstrainedSystem,
    Contact as ContactSystem, Cotangent as CotangentSpace, FirstIntegrals, FlowKind, FlowPart, ForceGradient,
    Gradients, Hamiltonian, KeepsEnergy, Lagrangian as LagrangianSystem, Mechanical as MechanicalContact,
    Perturbed as PerturbedSystem, PerturbedGradient, PhaseSpace, Piece as FlowPiece, Pieces as FlowPieces, Pole,
    PrincipalAxes, QuadraticKinetic, Separable, SteadyIntegrals, Unmet, VectorField as DifferentialEquation,
    canonical_rate, constrained_lagrangian_of, from_positions, is_positive_semidefinite, lagrangian_of, unsuitable,
};
pub use crate::taylor::method::TaylorMethod;
pub use geoint_macros::{put_energy_function_above_it, resume};

/// Divided differences and exact flows.
pub mod slope {
    pub use crate::slope::*;
}

/// Recurrences of Taylor coefficients.
pub mod recurrence {
    pub use crate::taylor::recurrence::*;
}

/// The fourth order of discrete gradients in canonical coordinates.
pub mod fourth_order {
    pub use crate::method::discrete_gradient::canonical::*;
}

/// Returns the addresses of rarely called generic functions, so that they are compiled with this crate and not in each program.
///
/// The functions do not depend on the shape of the unknowns, or have common shapes. A generic function is compiled only if it is used.
#[inline(never)]
pub fn compiled() -> [[*const (); 2]; 11] {
    use crate::method::discrete_gradient::gonzalez::compiled as metric;
    use crate::solving::noise::compiled as noise;
    use crate::solving::rescue::compiled as search;
    use crate::system::compiled as poles;
    let [one, two, three, four] =
        [search::<[f64; 1]>(), search::<[f64; 2]>(), search::<[f64; 3]>(), search::<[f64; 4]>()];
    // Positions and momenta of systems with one and two degrees of freedom.
    let [pair, pairs] = [search::<[[f64; 1]; 2]>(), search::<[[f64; 2]; 2]>()];
    let metrics = [metric::<[f64; 1]>(), metric::<[f64; 2]>()];
    [poles::<f64>(), poles::<f32>(), noise::<f64>(), noise::<f32>(), metrics, one, two, three, four, pair, pairs]
}
