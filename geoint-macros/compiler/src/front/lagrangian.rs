//! L(q, v, s, t). If the energy H(q, p, s, t) has a short formula, methods are derived from H, otherwise with velocities as unknowns.

use super::{canonical, contact, first_order, velocities};
use crate::check;
use crate::compilation::Compilation;
use crate::derive::Derived;
use crate::diagnostics::Result;
use crate::legendre::{self, Friction, Route};
use crate::lower::Terms;
use crate::parse::Form;

pub(super) fn derived(compilation: &mut Compilation<'_>, mut terms: Terms) -> Result<Derived> {
    // Methods with constraints need H. Rates with both an action and forces need H, too.
    let forced = compilation.form == Form::Herglotz && (terms.force.is_some() || terms.rayleigh.is_some());
    let needs_energy = compilation.energy.options.is_constrained() || forced;
    let degrees = compilation.degrees();
    let graph = &mut compilation.graph;
    let found = legendre::transform(graph, terms.energy, degrees, needs_energy, &terms.partial);
    if let (Form::Lagrangian, Err(legendre::Flaw::Linear(momenta))) = (compilation.form, &found) {
        return first_order::derived(compilation, &terms, momenta);
    }
    let friction = legendre::friction(graph, terms.rayleigh.map(|(root, _)| root), degrees);
    let (mut legendre, friction) = check::lagrangian(compilation, found, friction)?;
    match friction {
        Some(Friction::Damping(matrix)) => {
            legendre.friction = legendre::rate(&mut compilation.graph, &matrix, &legendre);
            terms.damping = Some(matrix);
        }
        Some(Friction::Slopes(slopes)) => terms.friction = Some(slopes),
        None => {}
    }
    let energy = match legendre.route {
        Route::Energy { energy, .. } => energy,
        Route::Velocities { obstacle } => return velocities::derived(compilation, terms, legendre, obstacle),
    };
    let terms = Terms { energy, partial: legendre.partial.clone(), ..terms };
    match compilation.form {
        Form::Herglotz if forced && !compilation.energy.options.is_constrained() => {
            contact::forced(compilation, terms, legendre)
        }
        Form::Herglotz => contact::derived(compilation, terms, Some(legendre)),
        _ => canonical::derived(compilation, terms, Some(legendre)),
    }
}
