//! Checks the user's constraints. They must depend on positions only, be independent, and be fewer than the coordinates.

use super::damping::report_damping;
use crate::analyze::{Damping, claims};
use crate::compilation::Compilation;
use crate::diagnostics::Result;
use crate::ir::{Id, Symbol};
use crate::lower::Terms;
use crate::messages::NO_CONSTRAINT;
use crate::parse::Form;

/// Reports invalid constraints, friction that is not linear, and damping that feeds energy.
pub(crate) fn constraints(compilation: &mut Compilation<'_>, terms: &Terms, damping: Option<&Damping>) -> Result<()> {
    let (options, constraints, degrees) = (&compilation.energy.options, &terms.constraints, compilation.degrees());
    if constraints.is_empty() {
        compilation.diagnostics.at(&options.constraint, NO_CONSTRAINT);
    }
    for (constraint, place) in constraints {
        let reads = compilation.graph.reads(*constraint);
        let why = match compilation.energy.form {
            Form::Lagrangian if reads.v => nonholonomic("velocities"),
            _ if reads.p || reads.v => nonholonomic("momenta"),
            _ if reads.t => OF_TIME.into(),
            _ if !reads.q => "this constraint reads no position".into(),
            _ => continue,
        };
        let message = format!("{why}: {}", compilation.excerpt(*constraint));
        compilation.diagnostics.at_place(*place, message);
    }
    if compilation.diagnostics.len() == 0 && constraints.len() >= degrees as usize {
        let (count, plural) = (constraints.len(), if degrees == 1 { "" } else { "s" });
        let message = format!("{count} constraints leave nothing that moves of {degrees} coordinate{plural}");
        compilation.diagnostics.at(&options.constraint, message);
    }
    if compilation.diagnostics.len() == 0 {
        let positions: Vec<Symbol> = (0..degrees).map(Symbol::Position).collect();
        let functions: Vec<Id> = constraints.iter().map(|(constraint, _)| *constraint).collect();
        let dependent = claims::dependent(&mut compilation.graph, &positions, &functions);
        for k in dependent.into_iter().flat_map(|found| found.integrals) {
            let others = if k == 0 { "does not depend on positions" } else { "depends on those before it" };
            let constraint = compilation.excerpt(functions[k]);
            let message = format!("this constraint {others}: leave it out: {constraint}");
            compilation.diagnostics.at_place(constraints[k].1, message);
        }
    }
    if let (Some(rayleigh), true) = (&options.rayleigh, terms.friction.is_some()) {
        compilation.diagnostics.at(rayleigh, LINEAR_FRICTION);
    }
    report_damping(compilation, damping);
    compilation.checked(())
}

const LINEAR_FRICTION: &str = "beside constraints friction is linear: R a quadratic form of the velocities";

/// Returns the message for a constraint that reads velocities or momenta.
fn nonholonomic(read: &str) -> String {
    format!(
        "a constraint is a function of positions; one that reads {read} is nonholonomic, and not supported: if this is the rate of a function of \
         positions, write that function; else write the equations, with their multipliers, as `#[vector_field]`"
    )
}

const OF_TIME: &str =
    "a constraint that moves is not supported: put the motion into coordinates, as functions of `t` in the energy";
