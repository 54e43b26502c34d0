//! Names of generated structs.

use proc_macro2::Ident;
use quote::format_ident;
use syn::ext::IdentExt;

/// What emitted code imports, all of `private::imported` of the runtime: no struct can have such a name.
const IMPORTED: &[&str] = &[
    "Adaptive",
    "Array",
    "Autonomous",
    "ByCanonical",
    "ByConstraint",
    "ByField",
    "CanonicalForm",
    "ByPolarisation",
    "ByTree",
    "ByVelocities",
    "Collocated",
    "BodyState",
    "Collocation",
    "ConformalContact",
    "Conservative",
    "ConstrainedStep",
    "ConstrainedSystem",
    "ContactDiscreteGradient",
    "ContactMidpoint",
    "FlowPiece",
    "FlowPieces",
    "PieceSplitting",
    "Placed",
    "PlanarDiscreteGradient",
    "PlanarItohAbe",
    "PlanarSplitting",
    "PolarisedForm",
    "PoissonSplitting",
    "ContactSplitting",
    "ContactCollocated",
    "ContactGraded",
    "ContactPolarised",
    "ContactStage",
    "ContactStages",
    "ContactVelocities",
    "MassForm",
    "contact_gradient_of",
    "ContactState",
    "ContactSystem",
    "Coordinates",
    "CotangentSpace",
    "QuadraticField",
    "DifferentialEquation",
    "DiscreteField",
    "DiscreteGradient",
    "FirstIntegrals",
    "SteadyIntegrals",
    "FlowState",
    "ForceGradient",
    "FourthOrderField",
    "Graded",
    "Gradients",
    "Hamiltonian",
    "ImplicitStep",
    "CanonicalEnergy",
    "EnergyAndMomenta",
    "KeptMomenta",
    "Integral",
    "KeptIntegrals",
    "Integrator",
    "KeepsEnergy",
    "Inverted",
    "Jets",
    "LagrangianSystem",
    "Mean",
    "MechanicalContact",
    "Method",
    "ModifiedEnergy",
    "NystromPieces",
    "PerCoordinate",
    "PerturbedGradient",
    "PerturbedSystem",
    "PhaseSpace",
    "PieceClock",
    "PrincipalAxes",
    "ProofAnd",
    "QuadraticKinetic",
    "Rattle",
    "Real",
    "TaylorIntegrator",
    "TaylorMethod",
    "Separable",
    "Snapshot",
    "Span",
    "Square",
    "State",
    "VelocityEnergy",
    "StepError",
    "Unmet",
    "VelocityForm",
    "canonical_rate",
    "energy_of",
    "from_positions",
    "fourth_order",
    "is_positive_semidefinite",
    "modified_verlet",
    "gradient_kick",
    "planar_step",
    "rate_of",
    "recurrence",
    "slope",
    "state_on_constraint",
    "unmet",
    "velocity_of",
];

/// What emitted code declares for itself.
const DECLARED: &[&str] = &["NamedFunctions", "OfVelocities"];

/// Whether emitted code has a name for something else.
pub(super) fn is_taken(name: &Ident) -> bool {
    IMPORTED.iter().chain(DECLARED).any(|taken| name == taken)
}

/// `henon_heiles` → `HenonHeiles`.
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

#[cfg(test)]
mod tests {
    use super::IMPORTED;
    use std::collections::BTreeSet;
    use syn::UseTree;

    fn leaves(tree: &UseTree, names: &mut BTreeSet<String>) {
        match tree {
            UseTree::Path(path) => leaves(&path.tree, names),
            UseTree::Group(group) => group.items.iter().for_each(|tree| leaves(tree, names)),
            UseTree::Name(name) => drop(names.insert(name.ident.to_string())),
            UseTree::Rename(rename) => drop(names.insert(rename.rename.to_string())),
            UseTree::Glob(_) => panic!("a list of names"),
        }
    }

    /// A name that is missing here would be that of a struct, and of something else.
    #[test]
    fn all_that_is_imported_is_listed() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../geoint-runtime/src/private.rs");
        let file = syn::parse_file(&std::fs::read_to_string(path).expect("the file")).expect("items");
        let imported = file.items.into_iter().find_map(|item| match item {
            syn::Item::Mod(module) if module.ident == "imported" => module.content,
            _ => None,
        });
        let mut names = BTreeSet::new();
        for item in imported.expect("the module").1 {
            match item {
                syn::Item::Use(item) => leaves(&item.tree, &mut names),
                _ => panic!("imports alone"),
            }
        }
        assert_eq!(names, IMPORTED.iter().map(ToString::to_string).collect());
    }
}
