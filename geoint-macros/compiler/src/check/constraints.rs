//! Checks the user's constraints. A constraint of positions reads positions and time only, and a constraint of velocities is linear in them. All constraints
//! must be independent, and leave a degree of freedom unless they move.

use super::blame_written;
use super::damping::report_damping;
use crate::analyze::{self, Damping, claims};
use crate::compilation::Compilation;
use crate::diagnostics::Result;
use crate::diff::constraint::Action;
use crate::diff::constraint::Row;
use crate::ir::{Id, Symbol};
use crate::lower::{Place, Terms};
use crate::messages::NO_CONSTRAINT;
use crate::parse::{Form, Role};

/// Reports invalid constraints, friction that is not linear, and damping that feeds energy.
pub(crate) fn constraints(compilation: &mut Compilation<'_>, terms: &Terms, damping: Option<&Damping>) -> Result<()> {
    let options = &compilation.energy.options;
    for (given, found) in [(&options.constraint, &terms.constraints), (&options.rolling, &terms.rolling)] {
        if given.is_some() && found.is_empty() {
            compilation.diagnostics.at(given, NO_CONSTRAINT);
        }
    }
    for (constraint, place) in &terms.constraints {
        report(compilation, *constraint, *place, of_positions(compilation, *constraint));
    }
    for (constraint, place) in &terms.rolling {
        let why = of_velocities(compilation, *constraint);
        report(compilation, *constraint, *place, why);
    }
    if compilation.diagnostics.len() == 0 {
        freedom(compilation, terms);
    }
    if compilation.diagnostics.len() == 0 {
        independent(compilation, terms);
    }
    if let (Some(rayleigh), true) = (&options.rayleigh, terms.friction.is_some()) {
        compilation.diagnostics.at(rayleigh, LINEAR_FRICTION);
    }
    report_damping(compilation, damping);
    compilation.checked(())
}

/// Returns the friction of an energy with an action. Reports other friction.
pub(crate) fn friction_of_time(compilation: &mut Compilation<'_>, energy: Id) -> Result<Action> {
    if let Some(rayleigh) = &compilation.energy.options.rayleigh {
        compilation.diagnostics.at(rayleigh, FRICTION_BESIDE_ACTION);
    }
    let found = analyze::with_decay_of_time(&mut compilation.graph, energy);
    if let Err(term) = found {
        let place = compilation.energy.argument(Role::Action).map_or(&compilation.energy.item.sig.ident, |s| &s.name);
        blame_written(compilation, term, place.span(), FRICTION_OF_TIME);
    }
    match found {
        Ok(action) => compilation.checked(action),
        Err(_) => Err(std::mem::take(&mut compilation.diagnostics)),
    }
}

/// Reports what is wrong with a constraint, if anything is.
fn report(compilation: &mut Compilation<'_>, constraint: Id, place: Place, why: Option<String>) {
    if let Some(why) = why {
        let message = format!("{why}: {}", compilation.excerpt(constraint));
        compilation.diagnostics.at_place(place, message);
    }
}

/// Returns what is wrong with a constraint g(q, t) = 0.
fn of_positions(compilation: &Compilation<'_>, constraint: Id) -> Option<String> {
    let reads = compilation.graph.reads(constraint);
    match compilation.energy.form {
        form if form.has_action() && (reads.p || reads.v) => Some(BESIDE_ACTION.into()),
        Form::Lagrangian if reads.v => Some(nonholonomic("velocities")),
        _ if reads.p || reads.v => Some(nonholonomic("momenta")),
        _ if reads.s => Some("a constraint is a function of positions and time, and this one reads the action".into()),
        _ if !reads.q => Some("this constraint reads no position".into()),
        _ => None,
    }
}

/// Returns what is wrong with a constraint A(q, t) v + b(q, t) = 0.
fn of_velocities(compilation: &mut Compilation<'_>, constraint: Id) -> Option<String> {
    let (degrees, graph) = (compilation.degrees(), &mut compilation.graph);
    let reads = graph.reads(constraint);
    let is_velocity = |symbol| matches!(symbol, Symbol::Velocity(_));
    if reads.p {
        return Some("a velocity constraint reads velocities `v`, not momenta".into());
    }
    if !reads.v {
        return Some("this constraint reads no velocity: put it under `constraint = [...]`".into());
    }
    if !analyze::is_polynomial_in(graph, &[constraint], 1, is_velocity) {
        return Some("a velocity constraint is linear in velocities, and conditions belong into their factors".into());
    }
    let row = Row::of_velocities(graph, constraint, degrees);
    if !analyze::is_rate(graph, &row) {
        return None;
    }
    let function = analyze::integral(graph, &row.gradient, row.drift);
    let function =
        function.map_or_else(|| "[...]".into(), |function| format!("[{} - c]", compilation.excerpt(function)));
    Some(format!("this is the rate of a function of positions: write that function, `constraint = {function}`"))
}

/// Reports constraints that leave no motion. A mechanism that is driven may have no freedom.
fn freedom(compilation: &mut Compilation<'_>, terms: &Terms) {
    let degrees = compilation.degrees() as usize;
    let all = || terms.constraints.iter().chain(&terms.rolling);
    let count = all().count();
    let moves = all().any(|(constraint, _)| compilation.graph.reads(*constraint).t);
    if count < degrees || moves && count == degrees {
        return;
    }
    let options = &compilation.energy.options;
    let plural = if degrees == 1 { "" } else { "s" };
    let message = format!("{count} constraints leave nothing that moves of {degrees} coordinate{plural}");
    compilation.diagnostics.at(&options.constraint.as_ref().or(options.rolling.as_ref()), message);
}

/// Reports constraints whose rows depend on earlier ones at every state.
fn independent(compilation: &mut Compilation<'_>, terms: &Terms) {
    let (degrees, graph) = (compilation.degrees(), &mut compilation.graph);
    let velocities: Vec<Symbol> = (0..degrees).map(Symbol::Velocity).collect();
    let symbols: Vec<Id> = velocities.iter().map(|velocity| graph.symbol(*velocity)).collect();
    let mut rates = vec![];
    for (constraint, _) in &terms.constraints {
        let row = Row::of_positions(graph, *constraint, degrees);
        rates.push(graph.dot(&row.gradient, &symbols));
    }
    rates.extend(terms.rolling.iter().map(|(constraint, _)| *constraint));
    let dependent = claims::dependent(graph, &velocities, &rates);
    let all: Vec<(Id, Place)> = terms.constraints.iter().chain(&terms.rolling).copied().collect();
    for k in dependent.into_iter().flat_map(|found| found.integrals) {
        let (constraint, place) = all[k];
        let others = if k == 0 { "does not depend on positions" } else { "depends on those before it" };
        let message = format!("this constraint {others}: leave it out: {}", compilation.excerpt(constraint));
        compilation.diagnostics.at_place(place, message);
    }
}

const BESIDE_ACTION: &str = "beside an action, a constraint is a function of positions and time: if this is the rate of such a function, write that";

const FRICTION_OF_TIME: &str =
    "beside constraints the action is read by one term, γ(t)·s, and this term has another form";

const FRICTION_BESIDE_ACTION: &str =
    "beside constraints and an action there is no other friction than γ(t)·s: leave out this, or the argument `s`";

const LINEAR_FRICTION: &str = "beside constraints friction is linear: R a quadratic form of the velocities";

/// Returns the message for a constraint of positions that reads velocities or momenta.
fn nonholonomic(read: &str) -> String {
    format!(
        "a constraint is a function of positions, and this one reads {read}: if it is the rate of a function of positions, write that function; else put \
         it in terms of velocities under `rolling = [...]`"
    )
}
