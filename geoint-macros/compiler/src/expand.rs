//! The compiler on one screen: from an annotated function to what is emitted beside it. A form is a column of stages.

use crate::analyze::Forces;
use crate::derive::{Flow, Parted, System, proof};
use crate::diagnostics::Result;
use crate::emit::report::{OfField, Source};
use crate::ir::Id;
use crate::legendre::{self, Friction, Legendre, Route};
use crate::lower::{self, Lowered};
use crate::parse::{Energy, Form};
use crate::{analyze, check, derive, emit, split};
use proc_macro2::TokenStream;

/// What is emitted beside the function.
pub(crate) fn system(energy: &Energy) -> Result<TokenStream> {
    match energy.form {
        Form::Hamiltonian => hamiltonian(energy, lowered(energy)?, None),
        Form::Contact => contact_hamiltonian(energy, lowered(energy)?, None),
        Form::Lagrangian | Form::Herglotz | Form::FirstOrder => lagrangian(energy),
        Form::Bodies => bodies(energy),
        Form::Structured => structured_hamiltonian(energy),
        Form::Field => vector_field(energy),
    }
}

/// Rust to graph.
fn lowered(energy: &Energy) -> Result<Lowered> {
    let lowered = lower::body(energy)?;
    let context = emit::Context::new(energy, &lowered.constants);
    check::angles(energy, &lowered, &context)?;
    Ok(lowered)
}

/// L(q, v, s, t): the energy that belongs to it.
fn lagrangian(energy: &Energy) -> Result<TokenStream> {
    let mut lowered = lowered(energy)?;
    let context = emit::Context::new(energy, &lowered.constants);
    // Steps with constraints are derived from H, and so are rates with an action and forces beside it.
    let forced = energy.form == Form::Herglotz && (lowered.force.is_some() || lowered.rayleigh.is_some());
    let needs_energy = energy.options.constraint.is_some() || forced;
    let graph = &mut lowered.graph;
    let found = legendre::transform(graph, lowered.energy, energy.degrees(), needs_energy, &lowered.partial); // H, or why not
    if let (Form::Lagrangian, Err(legendre::Flaw::Linear(momenta))) = (energy.form, &found) {
        return first_order(energy, lowered, momenta);
    }
    let friction = legendre::friction(graph, lowered.rayleigh.map(|(root, _)| root), energy.degrees());
    let (mut legendre, friction) = check::lagrangian(energy, (found, friction), graph, &lowered.places, &context)?;
    match friction {
        Some(Friction::Damping(matrix)) => {
            legendre.friction = legendre::rate(graph, &matrix, &legendre);
            lowered.damping = Some(matrix);
        }
        Some(Friction::Slopes(slopes)) => lowered.friction = Some(slopes),
        None => {}
    }
    let root = match legendre.route {
        Route::Energy { energy, .. } => energy,
        Route::Velocities { obstacle } if energy.form == Form::Herglotz => {
            return herglotz(energy, lowered, (&legendre, obstacle));
        }
        Route::Velocities { obstacle } => return velocities(energy, lowered, (&legendre, obstacle)),
    };
    lowered.energy = root;
    lowered.partial.clone_from(&legendre.partial);
    match energy.form {
        Form::Herglotz if forced => forced_herglotz(energy, lowered, &legendre),
        Form::Herglotz => contact_hamiltonian(energy, lowered, Some(&legendre)),
        _ => hamiltonian(energy, lowered, Some(&legendre)),
    }
}

/// L(q, v, t) with velocities as unknowns; `obstacle` is the reason why there is no H.
fn velocities(energy: &Energy, mut lowered: Lowered, (legendre, obstacle): (&Legendre, Id)) -> Result<TokenStream> {
    let context = emit::Context::new(energy, &lowered.constants);
    let graph = &mut lowered.graph;
    let damping = analyze::damping(graph, lowered.damping);
    let forces = Forces::of(graph, lowered.force, lowered.friction);
    let friction = (damping.as_ref(), forces.as_ref());
    check::velocities(energy, (obstacle, friction), graph, &lowered.places, &context)?;
    let system = derive::velocities(graph, legendre, (obstacle, &energy.coordinates.shape), friction)
        .of_lagrangian(legendre)
        .scheduled(graph);
    let graph = &*graph;
    let report = emit::report::lagrangian(&context, graph, Some(legendre))
        + &emit::report::velocities(&context, graph, (legendre, obstacle), (&system, friction));
    Ok(emit::items(&context, graph, &system, &report))
}

/// L(q, v, s, t) with velocities as unknowns; `obstacle` is the reason why there is no H.
fn herglotz(energy: &Energy, mut lowered: Lowered, (legendre, obstacle): (&Legendre, Id)) -> Result<TokenStream> {
    let context = emit::Context::new(energy, &lowered.constants);
    let graph = &mut lowered.graph;
    check::velocities(energy, (obstacle, (None, None)), graph, &lowered.places, &context)?;
    let dissipated = analyze::dissipated_by_velocities(graph, legendre.lagrangian, &energy.coordinates.shape);
    let decay = analyze::decay(graph, legendre.lagrangian);
    let system = derive::herglotz(graph, legendre, obstacle).of_lagrangian(legendre).scheduled(graph);
    let graph = &*graph;
    let report = emit::report::lagrangian(&context, graph, Some(legendre))
        + &emit::report::herglotz(&context, graph, (obstacle, decay, dissipated.as_ref()), &system);
    Ok(emit::items(&context, graph, &system, &report))
}

/// H(q, p, s, t) of a Lagrangian, with forces beside it: rates, and no contact map.
fn forced_herglotz(energy: &Energy, mut lowered: Lowered, legendre: &Legendre) -> Result<TokenStream> {
    let context = emit::Context::new(energy, &lowered.constants);
    let graph = &mut lowered.graph;
    let damping = analyze::damping(graph, lowered.damping.take());
    let forces = Forces::of(graph, lowered.force.take(), lowered.friction.take());
    if damping.is_none() && forces.is_none() {
        return contact_hamiltonian(energy, lowered, Some(legendre)); // all are zero
    }
    check::forced_action(energy, damping.as_ref(), graph, &context)?;
    let given = (damping.as_ref(), forces.as_ref());
    let (derived, drag) = derive::forced(graph, lowered.energy, given, &lowered.partial, energy.degrees());
    let system = derived.of_lagrangian(legendre).scheduled(graph);
    let graph = &*graph;
    let report = emit::report::lagrangian(&context, graph, Some(legendre))
        + &emit::report::forced(&context, graph, (lowered.energy, forces.as_ref(), drag.as_deref()));
    Ok(emit::items(&context, graph, &system, &report))
}

/// L(q, v, t) = ϑ(q)·v − H(q, t): x' = S ∇H for x = q, with the S that follows from the momenta ϑ.
fn first_order(energy: &Energy, mut lowered: Lowered, momenta: &[Id]) -> Result<TokenStream> {
    let energy = &Energy { form: Form::FirstOrder, ..energy.clone() };
    let context = emit::Context::new(energy, &lowered.constants);
    let graph = &mut lowered.graph;
    let found = legendre::first_order(graph, lowered.energy, momenta, &lowered.partial);
    let found = check::first_order(energy, found, graph, &context)?;
    let flow = Flow::structured(graph, found.energy, &found.structure, None);
    let parted = Parted::of_structure(found.energy, &found.structure, true);
    let pieces = derive::parts(graph, &flow, Some(&parted), false); // by terms of H, and by planes
    let system = derive::flow(graph, &flow, &found.partial, None).of_first_order(graph, &found);
    let system = System { pieces, ..system }.scheduled(graph);
    let graph = &*graph;
    let report = emit::report::flow(&context, graph, (&flow, Source::Lagrangian(&found)), &system);
    Ok(emit::items(&context, graph, &system, &report))
}

/// H(q, p, t), of a Lagrangian if there is one.
fn hamiltonian(energy: &Energy, mut lowered: Lowered, legendre: Option<&Legendre>) -> Result<TokenStream> {
    if energy.options.constraint.is_some() {
        return constrained(energy, lowered, legendre);
    }
    let context = emit::Context::new(energy, &lowered.constants);
    let graph = &mut lowered.graph;
    let structure = analyze::structure(graph, lowered.energy, &energy.coordinates.shape); // facts, with witnesses
    let forces = Forces::of(graph, lowered.force, lowered.friction);
    let structure = structure.damped(graph, lowered.damping).forced(graph, forces);
    let partial = legendre::without_velocities(graph, &lowered.partial);
    let groups = lowered.groups.as_deref();
    let division = split::divided(graph, &structure, energy, groups); // a part with an exact flow, and a rest
    let pieces = split::coupled_pieces(graph, &structure, energy.degrees(), groups); // flows in closed form, beside kick and drift
    let (derived, gradient) =
        derive::canonical(graph, &structure, (&division, pieces.as_ref()), &partial, energy.degrees(), legendre); // nodes for every method
    check::requests(energy, &structure, graph, &lowered.places, &context)?; // asked for = proven?
    check::division(energy, &division, graph, &lowered.places, &context)?;
    if let Some(pieces) = &pieces {
        check::pieces(energy, (structure.energy, groups), pieces, graph, &lowered.places, &context)?;
    }
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
    let found = (&lowered.constraints[..], structure.damping.as_ref(), lowered.friction.is_some());
    check::constraints(energy, found, graph, &context)?;
    check::requests(energy, &structure, graph, &lowered.places, &context)?;
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
    let dissipated =
        analyze::dissipated(graph, root, &energy.coordinates.shape).filter(|_| energy.options.lift.is_none());
    let pieces = split::pieces(graph, root, split::Space { degrees, action: true }, groups); // flows in closed form
    let mechanics = split::mechanics(graph, root, degrees);
    let (derived, gradient) = derive::contact(
        graph,
        root,
        (&pieces, &mechanics),
        &lowered.partial,
        (degrees, energy.options.lift.is_some()),
        legendre,
    );
    check::of_action(energy, (root, &mechanics), graph, &lowered.places, &context)?;
    check::pieces(energy, (root, groups), &pieces, graph, &lowered.places, &context)?;
    let derived = legendre.into_iter().fold(derived, System::of_lagrangian);
    let system = derived.scheduled(graph);
    let graph = &*graph;
    let report = emit::report::contact(&context, graph, (root, &gradient, dissipated.as_ref()), &system);
    let report = emit::report::lagrangian(&context, graph, legendre) + &report;
    Ok(emit::items(&context, graph, &system, &report))
}

/// H(x, t) with x' = S(x) ∇H.
fn structured_hamiltonian(energy: &Energy) -> Result<TokenStream> {
    let mut lowered = lowered(energy)?;
    let context = emit::Context::new(energy, &lowered.constants);
    let graph = &mut lowered.graph;
    let structure = proof::structure(graph, lowered.energy, &lowered.structure);
    let damping = analyze::damping(graph, lowered.damping);
    check::structure(energy, (&structure, damping.as_ref()), graph, &lowered.places, &context)?;
    let mut flow = Flow::structured(graph, lowered.energy, &structure.matrix, damping.as_ref());
    flow.search_casimirs(graph, (&structure.matrix, structure.casimir), &context);
    flow.search(graph, &context); // what else is constant
    let parted = Parted::of_structure(lowered.energy, &structure.matrix, structure.poisson.is_ok());
    let pieces = derive::parts(graph, &flow, Some(&parted), damping.is_some()); // by terms of H, and by planes
    let system = derive::flow(graph, &flow, &lowered.partial, damping.as_ref());
    let system = System { pieces, ..system }.scheduled(graph);
    let graph = &*graph;
    let report = emit::report::flow(&context, graph, (&flow, Source::Structure(&structure)), &system);
    Ok(emit::items(&context, graph, &system, &report))
}

/// f(x, t), and what it keeps.
fn vector_field(energy: &Energy) -> Result<TokenStream> {
    let mut lowered = lowered(energy)?;
    let context = emit::Context::new(energy, &lowered.constants);
    let graph = &mut lowered.graph;
    let mut flow = Flow::of_field(&lowered.field, energy.options.keeps.iter().zip(&lowered.keeps));
    let found = proof::integrals(graph, &flow);
    check::integrals(energy, &lowered.keeps, &found, graph, &lowered.places, &context)?;
    let liouville = derive::liouville(graph, &lowered.field, &lowered.partial); // is it that of an energy?
    match liouville.kept() {
        Some(energy) => flow.recovered(graph, energy, &context),
        None => flow.divergent = liouville.divergent(),
    }
    flow.search(graph, &context);
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
    let mut lowered = lowered(energy)?;
    let context = emit::Context::new(energy, &lowered.constants);
    let graph = &mut lowered.graph;
    let found = analyze::bodies(graph, lowered.energy, energy.bodies(), energy.degrees() / 4); // T and V, or the term in the way
    let found = check::bodies(energy, found, graph, &lowered.places, &context)?;
    let system = derive::bodies(graph, &found, &lowered.partial).scheduled(graph);
    let graph = &*graph;
    let report = emit::report::bodies(&context, graph, &found, &system);
    Ok(emit::items_of_bodies(&context, graph, &system, &report))
}
