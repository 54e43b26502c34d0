//! Whether constraints are some: functions of positions alone, independent, and fewer than coordinates.

use super::damping::report_damping;
use crate::analyze::{Damping, claims};
use crate::compilation::Compilation;
use crate::diagnostics::Result;
use crate::ir::{Id, Symbol, print::Printer};
use crate::lower::Terms;
use crate::messages::NO_CONSTRAINT;
use crate::parse::Form;

/// Reports constraints that are none, and damping that is none; `general_friction` is friction that no matrix gives.
pub(crate) fn constraints(compilation: &mut Compilation<'_>, terms: &Terms, damping: Option<&Damping>) -> Result<()> {
    let (energy, constraints) = (compilation.energy, &terms.constraints);
    let Compilation { graph, names, diagnostics: errors, .. } = compilation;
    let degrees = energy.degrees();
    if constraints.is_empty() {
        errors.at(&energy.options.constraint, NO_CONSTRAINT);
    }
    for (constraint, place) in constraints {
        let printer = Printer::new(graph, names);
        let reads = graph.reads(*constraint);
        let why = match energy.form {
            Form::Lagrangian if reads.v => NOT_OF_VELOCITIES,
            _ if reads.p || reads.v => NOT_OF_MOMENTA,
            _ if reads.t => OF_TIME,
            _ if !reads.q => OF_NO_POSITION,
            _ => continue,
        };
        errors.at_place(*place, format!("{why}: {}", printer.excerpt(*constraint)));
    }
    if errors.len() == 0 && constraints.len() >= degrees as usize {
        let message = format!(
            "{} constraints leave nothing that moves of {degrees} coordinate{}",
            constraints.len(),
            if degrees == 1 { "" } else { "s" }
        );
        errors.at(&energy.options.constraint, message);
    }
    if errors.len() == 0 {
        let positions: Vec<Symbol> = (0..degrees).map(Symbol::Position).collect();
        let functions: Vec<Id> = constraints.iter().map(|(constraint, _)| *constraint).collect();
        let dependent = claims::dependent(graph, &positions, &functions);
        for k in dependent.into_iter().flat_map(|found| found.integrals) {
            let others = if k == 0 { "does not depend on positions" } else { "depends on those before it" };
            let printer = Printer::new(graph, names);
            let message = format!("this constraint {others}: leave it out: {}", printer.excerpt(functions[k]));
            errors.at_place(constraints[k].1, message);
        }
    }
    if let (Some(rayleigh), true) = (&energy.options.rayleigh, terms.friction.is_some()) {
        errors.at(rayleigh, LINEAR_FRICTION);
    }
    report_damping(compilation, damping);
    compilation.checked(())
}

const LINEAR_FRICTION: &str = "beside constraints friction is linear: R a quadratic form of the velocities";

/// What is said of a constraint that reads something else than positions.
macro_rules! nonholonomic {
    ($read:literal) => {
        concat!(
            "a constraint is a function of positions; one that reads ",
            $read,
            " is nonholonomic, and not supported: if this is the rate of a function of positions, write that function; \
             else write the equations, with their multipliers, as `#[vector_field]`"
        )
    };
}

const NOT_OF_VELOCITIES: &str = nonholonomic!("velocities");

const NOT_OF_MOMENTA: &str = nonholonomic!("momenta");

const OF_TIME: &str =
    "a constraint that moves is not supported: put the motion into coordinates, as functions of `t` in the energy";

const OF_NO_POSITION: &str = "this constraint reads no position";
