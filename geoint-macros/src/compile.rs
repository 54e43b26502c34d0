//! The compiler on one screen: from an annotated function to what is emitted beside it. A form is a column of stages.

use crate::derive::{Flow, Parted, System, proof};
use crate::diagnostics::Result;
use crate::emit::report::{OfField, Source};
use crate::ir::Id;
use crate::legendre::{self, Legendre, Route};
use crate::lower::{self, Lowered};
use crate::parse::{Energy, Form};
use crate::{analyze, check, derive, emit, split};
use proc_macro2::TokenStream;

/// What is emitted beside the function.
pub(crate) fn system(energy: &Energy) -> Result<TokenStream> {
    match energy.form {
        Form::Hamiltonian => hamiltonian(energy, lower::body(energy)?, None),
        Form::Contact => contact_hamiltonian(energy, lower::body(energy)?, None),
        Form::Lagrangian | Form::Herglotz => lagrangian(energy),
        Form::Bodies => bodies(energy),
        Form::Structured => structured_hamiltonian(energy),
        Form::Field => vector_field(energy),
    }
}

/// L(q, v, s, t): the energy that belongs to it.
fn lagrangian(energy: &Energy) -> Result<TokenStream> {
    let mut lowered = lower::body(energy)?; // Rust to graph
    let context = emit::Context::new(energy, &lowered.constants);
    // Steps with constraints are derived from H.
    let closed = energy.form.has_action() || energy.constraint.is_some();
    let graph = &mut lowered.graph;
    let found = legendre::transform(graph, lowered.energy, (energy.degrees(), closed), &lowered.partial); // H, or why not
    let friction = legendre::friction(graph, lowered.rayleigh.map(|(root, _)| root), energy.degrees());
    let (legendre, damping) =
        check::lagrangian(energy, (found, friction), graph, &lowered.places, |symbol| context.user_name(symbol))?;
    let root = match legendre.route {
        Route::Energy(root, _) => root,
        Route::Velocities(long) => return velocities(energy, lowered, (&legendre, long), damping),
    };
    lowered.energy = root;
    lowered.partial.clone_from(&legendre.partial);
    lowered.damping = damping;
    match energy.form {
        Form::Herglotz => contact_hamiltonian(energy, lowered, Some(&legendre)),
        _ => hamiltonian(energy, lowered, Some(&legendre)),
    }
}

/// L(q, v, t) with velocities as unknowns; `long` is why there is no H.
fn velocities(
    energy: &Energy,
    mut lowered: Lowered,
    (legendre, long): (&Legendre, Id),
    damping: Option<Vec<Vec<Id>>>,
) -> Result<TokenStream> {
    let context = emit::Context::new(energy, &lowered.constants);
    let graph = &mut lowered.graph;
    let damping = analyze::damping(graph, damping);
    check::velocities(energy, (long, damping.as_ref()), graph, &lowered.places, |symbol| context.user_name(symbol))?;
    let system = derive::velocities(graph, legendre, long, damping.as_ref()).of_lagrangian(legendre).scheduled(graph);
    let graph = &*graph;
    let report = emit::report::lagrangian(&context, graph, Some(legendre))
        + &emit::report::velocities(&context, graph, (legendre, long), (&system, damping.as_ref()));
    Ok(emit::items(&context, graph, &system, &report))
}

/// H(q, p, t), of a Lagrangian if there is one.
fn hamiltonian(energy: &Energy, mut lowered: Lowered, legendre: Option<&Legendre>) -> Result<TokenStream> {
    if energy.constraint.is_some() {
        return constrained(energy, lowered, legendre);
    }
    let context = emit::Context::new(energy, &lowered.constants);
    let graph = &mut lowered.graph;
    let structure = analyze::structure(graph, lowered.energy, &energy.coordinates.shape); // facts, with witnesses
    let structure = structure.damped(graph, lowered.damping);
    let groups = lowered.groups.as_deref();
    let division = split::divided(graph, &structure, energy, groups); // a part with an exact flow, and a rest
    let (derived, gradient) = derive::canonical(graph, &structure, &division, &lowered.partial, energy.degrees()); // nodes for every method
    check::requests(energy, &structure, graph, &lowered.places, |symbol| context.user_name(symbol))?; // asked for = proven?
    check::division(energy, (structure.energy, groups), &division, graph, &lowered.places, |symbol| {
        context.user_name(symbol)
    })?;
    let derived = legendre.into_iter().fold(derived, System::of_lagrangian);
    let system = derived.scheduled(graph); // what is computed when
    let graph = &*graph; // which nobody changes any more
    let report = emit::report::canonical(&context, graph, &structure, (&system, &gradient));
    let report = emit::report::lagrangian(&context, graph, legendre) + &report;
    Ok(emit::items(&context, graph, &system, &report))
}

/// H(q, p, t) with constraints g(q) = 0.
fn constrained(energy: &Energy, mut lowered: Lowered, legendre: Option<&Legendre>) -> Result<TokenStream> {
    let context = emit::Context::new(energy, &lowered.constants);
    let graph = &mut lowered.graph;
    let structure = analyze::structure(graph, lowered.energy, &energy.coordinates.shape);
    let structure = structure.damped(graph, lowered.damping.clone());
    let found = (&lowered.constraints[..], structure.damping.as_ref());
    check::constraints(energy, found, graph, |symbol| context.user_name(symbol))?;
    check::requests(energy, &structure, graph, &lowered.places, |symbol| context.user_name(symbol))?;
    let constraints: Vec<Id> = lowered.constraints.iter().map(|(constraint, _)| *constraint).collect();
    let kept = analyze::bound(graph, lowered.energy, &constraints, &energy.coordinates.shape);
    let kept = kept.damped(graph, lowered.damping);
    let (derived, gradient) = derive::constrained(graph, &structure, &constraints, &lowered.partial, energy.degrees());
    let derived = legendre.into_iter().fold(derived, System::of_lagrangian);
    let system = derived.scheduled(graph);
    let graph = &*graph;
    let report = emit::report::constraints(&context, graph, (&structure, &kept), &constraints, (&system, &gradient));
    let report = emit::report::lagrangian(&context, graph, legendre) + &report;
    Ok(emit::items(&context, graph, &system, &report))
}

/// H(q, p, s, t), of a Lagrangian if there is one.
fn contact_hamiltonian(energy: &Energy, mut lowered: Lowered, legendre: Option<&Legendre>) -> Result<TokenStream> {
    let context = emit::Context::new(energy, &lowered.constants);
    let (graph, root, degrees) = (&mut lowered.graph, lowered.energy, energy.degrees());
    let groups = lowered.groups.as_deref();
    let pieces = split::pieces(graph, root, degrees, groups); // flows in closed form
    let mechanics = split::mechanics(graph, root, degrees);
    let (derived, gradient) =
        derive::contact(graph, root, (&pieces, &mechanics), &lowered.partial, (degrees, energy.lift.is_some()));
    check::pieces(energy, (root, groups), &pieces, graph, &lowered.places, |symbol| context.user_name(symbol))?;
    let derived = legendre.into_iter().fold(derived, System::of_lagrangian);
    let system = derived.scheduled(graph);
    let graph = &*graph;
    let report = emit::report::contact(&context, graph, (root, &gradient), &system);
    let report = emit::report::lagrangian(&context, graph, legendre) + &report;
    Ok(emit::items(&context, graph, &system, &report))
}

/// H(x, t) with x' = S(x) ∇H.
fn structured_hamiltonian(energy: &Energy) -> Result<TokenStream> {
    let mut lowered = lower::body(energy)?;
    let context = emit::Context::new(energy, &lowered.constants);
    let graph = &mut lowered.graph;
    let structure = proof::structure(graph, &lowered.structure);
    let damping = analyze::damping(graph, lowered.damping);
    check::structure(energy, (&structure, damping.as_ref()), graph, &lowered.places, |symbol| {
        context.user_name(symbol)
    })?;
    let mut flow = Flow::structured(graph, lowered.energy, &structure.matrix, damping.as_ref());
    flow.search(graph, Some(&structure.matrix), |symbol| context.user_name(symbol)); // Casimirs
    let parted = Parted {
        integral: lowered.energy,
        matrix: structure.matrix.clone(),
        poisson: structure.poisson.is_ok(),
        unique: None,
    };
    let pieces = derive::parts(graph, &flow, Some(&parted), damping.is_some()); // by terms of H, and by planes
    let system = derive::flow(graph, &flow, &lowered.partial, damping.as_ref());
    let system = System { pieces, ..system }.scheduled(graph);
    let graph = &*graph;
    let report = emit::report::flow(&context, graph, (&flow, Source::Structure(&structure)), &system);
    Ok(emit::items(&context, graph, &system, &report))
}

/// f(x, t), and what it keeps.
fn vector_field(energy: &Energy) -> Result<TokenStream> {
    let mut lowered = lower::body(energy)?;
    let context = emit::Context::new(energy, &lowered.constants);
    let graph = &mut lowered.graph;
    let mut flow = Flow::of_field(&lowered.field, energy.keeps.iter().zip(&lowered.keeps));
    let found = proof::integrals(graph, &flow);
    check::integrals(energy, &lowered.keeps, &found, graph, |symbol| context.user_name(symbol))?;
    let liouville = derive::liouville(graph, &lowered.field, &lowered.partial); // is it that of an energy?
    match liouville.kept() {
        Some(energy) => flow.recovered(graph, energy, |symbol| context.user_name(symbol)),
        None => flow.divergent = liouville.divergent(),
    }
    flow.search(graph, None, |symbol| context.user_name(symbol));
    let parted = Parted::of_field(graph, &flow); // S, known or searched for
    let pieces = derive::parts(graph, &flow, parted.as_ref(), false);
    let system = System { pieces, ..derive::flow(graph, &flow, &lowered.partial, None) }.scheduled(graph);
    let graph = &*graph;
    let report = emit::report::flow(
        &context,
        graph,
        (&flow, Source::Field(OfField { proofs: &found, liouville: &liouville, parted: parted.as_ref() })),
        &system,
    );
    Ok(emit::items(&context, graph, &system, &report))
}

/// H(r, m, t) of rigid bodies.
fn bodies(energy: &Energy) -> Result<TokenStream> {
    let mut lowered = lower::body(energy)?;
    let context = emit::Context::new(energy, &lowered.constants);
    let graph = &mut lowered.graph;
    let found = analyze::bodies(graph, lowered.energy, energy.degrees() / 4); // T and V, or the term in the way
    let found = check::bodies(energy, found, graph, &lowered.places, |symbol| context.user_name(symbol))?;
    let system = derive::bodies(graph, &found, &lowered.partial).scheduled(graph);
    let graph = &*graph;
    let report = emit::report::bodies(&context, graph, &found, &system);
    Ok(emit::items_of_bodies(&context, graph, &system, &report))
}
