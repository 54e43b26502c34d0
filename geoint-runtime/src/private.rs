//! Items that emitted code uses. Not part of the public interface.

pub use crate::method::constrained::{MultiplierStep, Rattle};
pub use crate::method::contact::{
    ContactDiscreteGradient, ContactFieldStages, ContactGauss as ContactGaussCollocation, ContactMidpoint, ContactStep,
};
pub use crate::method::corrected::invariants::{
    CanonicalEnergy, EnergyAndMomenta, Integral, Integrals as KeptIntegrals, VelocityEnergy,
};
pub use crate::method::discrete_gradient::canonical as fourth_order;
pub use crate::method::discrete_gradient::{DiscreteGradient, PolarisedStep, TreeStep};
pub use crate::method::flows::pieces::{
    ContactSplitting, PieceSplitting, PlanarDiscreteGradient, PlanarItohAbe, PlanarSplitting, PoissonSplitting,
    planar_step,
};
pub use crate::method::gauss::{CanonicalStages, FieldStages, Gauss as GaussCollocation, GaussTableau, VelocityStages};
pub use crate::method::implicit::ImplicitMethod;
pub use crate::method::{And as ProofAnd, Method};
pub use crate::method::{gradient_kick, modified_verlet};
pub use crate::running::{Adaptive, Integrator, StepError, TaylorIntegrator, state_on_constraint};
pub use crate::scalar::Real;
pub use crate::slope;
pub use crate::solving::Inverted;
pub use crate::solving::newton::MOST_UNKNOWNS;
pub use crate::space::{
    Array, BodyState, ContactState, Coordinates, FlowState, PerCoordinate, Placed, Snapshot, Square, State,
};
pub use crate::system::{
    Autonomous, CanonicalForm, Clock as PieceClock, Collocation, Conformal as ConformalContact, Conservative,
    Constrained as ConstrainedSystem, ConstrainedStep, Contact as ContactSystem, ContactEquation, ContactStages,
    Cotangent as CotangentSpace, DiscreteField, EquationOrder, FirstIntegrals, FlowKind, FlowPart, ForceGradient,
    FourthOrderField, Gradients, Hamiltonian, Jets, Keeping, KeepsEnergy, KeptMomenta, Lagrangian as LagrangianSystem,
    MassForm, Mean, Mechanical as MechanicalContact, MixedDerivatives, ModifiedEnergy, NystromPieces,
    Perturbed as PerturbedSystem, PerturbedGradient, PhaseSpace, Piece as FlowPiece, Pieces as FlowPieces,
    PolarisedForm, Pole, PrincipalAxes, QuadraticField, QuadraticKinetic, Separable, Span, SteadyIntegrals, Unmet,
    VectorField as DifferentialEquation, VelocityForm, VelocityStage, canonical_rate, contact_gradient_of, energy_of,
    from_positions, is_positive_semidefinite, own_momentum, rate_of, singular_mass, unmet, unsuitable, velocity_of,
};
pub use crate::taylor::{TaylorMethod, recurrence};
pub use geoint_macros::{put_energy_function_above_it, resume};

/// Returns the addresses of rarely called generic functions, so that they are compiled with this crate and not in each program.
///
/// The functions do not depend on the shape of the unknowns, or have common shapes. A generic function is compiled only if it is used.
#[inline(never)]
pub fn compiled() -> [[*const (); 2]; 12] {
    use crate::method::corrected::kept::compiled as kept;
    use crate::method::discrete_gradient::gonzalez::compiled as metric;
    use crate::solving::noise::compiled as noise;
    use crate::solving::rescue::compiled as search;
    use crate::system::compiled as poles;
    let [one, two, three, four] =
        [search::<[f64; 1]>(), search::<[f64; 2]>(), search::<[f64; 3]>(), search::<[f64; 4]>()];
    // Positions and momenta of systems with one and two degrees of freedom.
    let [pair, pairs] = [search::<[[f64; 1]; 2]>(), search::<[[f64; 2]; 2]>()];
    let kept = [kept::<f64>(), kept::<f32>()];
    let metrics = [metric::<[f64; 1]>(), metric::<[f64; 2]>()];
    [poles::<f64>(), poles::<f32>(), noise::<f64>(), noise::<f32>(), kept, metrics, one, two, three, four, pair, pairs]
}
