//! Names of generated structs, and the names that generated code takes.

use proc_macro2::Ident;
use quote::format_ident;
use syn::ext::IdentExt;

/// Items of the runtime that generated code imports, in the order of the import.
const IMPORTED: &str = "\
    ContactLeapfrog DampedRattle ExplicitLeapfrog PieceComposition SteppedAs MultiplierStep CanonicalStages ContactEquation ContactFieldStages ContactGaussCollocation \
    ContactStep FieldStages GaussCollocation GaussTableau ImplicitMethod Keeping PolarisedStep \
    TreeStep VelocityStages Adaptive Array Autonomous CanonicalForm BodyState Collocation ConformalContact \
    Conservative ConstrainedStep ConstrainedSystem ContactDiscreteGradient ContactMidpoint FlowPiece FlowPieces \
    PieceSplitting Placed PlanarDiscreteGradient PlanarItohAbe PlanarSplitting PolarisedForm PoissonSplitting \
    ContactSplitting VelocityStage ContactStages MassForm MixedDerivatives contact_gradient_of \
    ContactState ContactSystem Coordinates CotangentSpace QuadraticField DifferentialEquation DiscreteField EquationOrder \
    DiscreteGradient FirstIntegrals SteadyIntegrals FlowState ForceGradient FourthOrderField Gradients Hamiltonian \
    CanonicalEnergy EnergyAndMomenta KeptMomenta Integral KeptIntegrals Integrator KeepsEnergy Inverted Jets \
    LagrangianSystem Mean MechanicalContact Method ModifiedEnergy NystromPieces PerCoordinate PerturbedGradient \
    PerturbedSystem PhaseSpace PieceClock PrincipalAxes Given QuadraticKinetic Rattle Real TaylorIntegrator \
    TaylorMethod Separable Snapshot Span Square State VelocityEnergy StepError Unmet VelocityForm canonical_rate \
    energy_of from_positions fourth_order is_positive_semidefinite modified_verlet gradient_kick planar_step rate_of \
    recurrence lagrangian_of constrained_lagrangian_of slope state_on_constraint unmet velocity_of";

/// Returns the items of the runtime that generated code imports.
pub(crate) fn imported() -> impl Iterator<Item = &'static str> {
    IMPORTED.split_whitespace()
}

/// Items that generated code declares beside its implementations.
pub(crate) const DECLARED: &[&str] = &["NamedFunctions", "OfVelocities"];

/// Returns whether generated code uses a name for another item. A generated struct can not have this name.
pub(super) fn is_taken(name: &Ident) -> bool {
    imported().chain(DECLARED.iter().copied()).any(|taken| name == taken)
}

/// Returns a name in camel case: `henon_heiles` becomes `HenonHeiles`.
pub(super) fn camel_case(name: &Ident) -> Ident {
    let text = name.unraw().to_string();
    let camel: String = text
        .split('_')
        .flat_map(|word| {
            let mut letters = word.chars();
            letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect::<Vec<_>>()
        })
        .collect();
    match camel.chars().next() {
        Some(first) if first.is_alphabetic() && camel != "Self" => Ident::new(&camel, name.span()),
        _ => format_ident!("Energy{camel}", span = name.span()),
    }
}
