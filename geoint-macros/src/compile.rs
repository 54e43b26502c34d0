//! The compiler on one screen: from an annotated function to what is emitted beside it. A form is a column of stages.

use crate::derive::{Flow, System, proof};
use crate::diagnostics::Result;
use crate::emit::report::Source;
use crate::parse::{Energy, Form};
use crate::{analyze, check, derive, emit, lower, split};
use proc_macro2::TokenStream;

/// What is emitted beside the function.
pub(crate) fn system(energy: &Energy) -> Result<TokenStream> {
    match energy.form {
        Form::Hamiltonian => hamiltonian(energy),
        Form::Contact => contact_hamiltonian(energy),
        Form::Bodies => bodies(energy),
        Form::Structured => structured_hamiltonian(energy),
        Form::Field => vector_field(energy),
    }
}

/// H(q, p, t).
fn hamiltonian(energy: &Energy) -> Result<TokenStream> {
    let mut lowered = lower::body(energy)?; // Rust to graph
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
    let system = derived.scheduled(graph); // what is computed when
    let graph = &*graph; // which nobody changes any more
    let report = emit::report::canonical(&context, graph, &structure, (&system, &gradient));
    Ok(emit::items(&context, graph, &system, &report))
}

/// H(q, p, s, t).
fn contact_hamiltonian(energy: &Energy) -> Result<TokenStream> {
    let mut lowered = lower::body(energy)?;
    let context = emit::Context::new(energy, &lowered.constants);
    let (graph, root, degrees) = (&mut lowered.graph, lowered.energy, energy.degrees());
    let groups = lowered.groups.as_deref();
    let pieces = split::pieces(graph, root, degrees, groups); // flows in closed form
    let mechanics = split::mechanics(graph, root, degrees);
    let (derived, gradient) =
        derive::contact(graph, root, (&pieces, &mechanics), &lowered.partial, (degrees, energy.lift.is_some()));
    check::pieces(energy, (root, groups), &pieces, graph, &lowered.places, |symbol| context.user_name(symbol))?;
    let system = derived.scheduled(graph);
    let graph = &*graph;
    let report = emit::report::contact(&context, graph, (root, &gradient), &system);
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
    let poisson = (&structure.matrix[..], structure.poisson.is_ok());
    let pieces = derive::parts(graph, &flow, Some(poisson), damping.is_some()); // by terms of H, and by planes
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
    flow.search(graph, None, |symbol| context.user_name(symbol));
    let pieces = derive::parts(graph, &flow, None, false);
    let system = System { pieces, ..derive::flow(graph, &flow, &lowered.partial, None) }.scheduled(graph);
    let graph = &*graph;
    let report = emit::report::flow(&context, graph, (&flow, Source::Field(&found)), &system);
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
