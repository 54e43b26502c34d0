//! Compares the user's pieces of an energy with the pieces that have a known flow.

use super::blame_written;
use super::wording::in_case;
use crate::analyze::{self, Identity, Remainder};
use crate::compilation::Compilation;
use crate::diagnostics::Result;
use crate::ir::{Graph, Id, Node, print::Printer};
use crate::lower::Place;
use crate::split::{self, Division, NoExactPart, Pieces, Space};
use proc_macro2::Span;

/// Reports the user's pieces if one has no known flow or their sum is not H. Reports a `lift` whose positions depend on momenta.
pub(crate) fn pieces(
    compilation: &mut Compilation<'_>,
    root: Id,
    groups: Option<&[(Id, Place)]>,
    found: &Pieces,
) -> Result<()> {
    if let Some(groups) = groups {
        if let Err(group) = found
            && let Some((_, place)) = groups.iter().find(|(other, _)| other == group)
        {
            let space = Space { degrees: compilation.degrees(), action: compilation.form.has_action() };
            let family = split::nearest(&mut compilation.graph, *group, space);
            let nearest = family.map_or_else(String::new, |family| {
                format!("; the nearest family is `{}`, {}", family.name, family.energies)
            });
            let term = compilation.excerpt(*group);
            compilation.diagnostics.at_place(*place, format!("{NO_FLOW}{nearest}; the piece is: {term}"));
        }
        adds_up(compilation, root, groups);
    }
    if let Some(span) = compilation.energy.options.lift
        && let Some(term) = analyze::not_affine(&mut compilation.graph, root)
    {
        compilation.blame(term, span, NO_LIFT);
    }
    compilation.checked(())
}

/// Reports the user's `coordinates` if no part has an exact flow in them.
pub(crate) fn division(compilation: &mut Compilation<'_>, found: &Division) -> Result<()> {
    if let (Some((_, asked)), Err(NoExactPart { term, why })) = (compilation.energy.options.coordinates, found) {
        blame_written(compilation, *term, asked, why);
    }
    compilation.checked(())
}

/// Reports the difference between the energy and the sum of the user's pieces.
fn adds_up(compilation: &mut Compilation<'_>, root: Id, groups: &[(Id, Place)]) {
    let graph = &mut compilation.graph;
    let sum = graph.sum(&groups.iter().map(|(group, _)| *group).collect::<Vec<_>>());
    let missing = difference(graph, root, sum);
    let verdict = analyze::identity(graph, missing);
    let printer = compilation.printer();
    let graph = &compilation.graph;
    let wrong = matches!(verdict, Identity::Wrong(_));
    let message = match verdict.rest() {
        _ if verdict.is_zero() => None,
        Some(Remainder { rest, certain, case }) => {
            let (condition, rest) = (in_case(&printer, case), shorter(&printer, missing, *rest, case));
            let advice = if wrong || *certain || is_term(graph, missing) { "" } else { SAME_SPELLING };
            Some(format!("{NOT_THE_SUM}{condition} is: {rest}{advice}"))
        }
        None if wrong => Some(format!("{NOT_THE_SUM} is: {}", printer.excerpt(missing))),
        None => Some(format!("{NOT_COMPARED}: {}", printer.excerpt(missing))),
    };
    if let Some(message) = message {
        compilation.diagnostics.at_place(whole(groups), message);
    }
}

/// Returns the source position of all pieces.
fn whole(groups: &[(Id, Place)]) -> Place {
    let [first, last] =
        [groups.first(), groups.last()].map(|group| group.map_or_else(Span::call_site, |(_, place)| place.0));
    (first, last)
}

/// Returns a − b. Equal terms cancel.
fn difference(graph: &mut Graph, a: Id, b: Id) -> Id {
    let [mut terms, other] = [a, b].map(|root| analyze::terms(graph, root));
    terms.extend(other.into_iter().map(|term| graph.neg(term)));
    graph.sum(&terms)
}

/// Returns whether a node is a single term.
fn is_term(graph: &Graph, id: Id) -> bool {
    !matches!(graph.node(graph.coefficient(id).1), Node::Linear(..))
}

/// Returns the shorter text of the difference: as written, or multiplied out. Only the latter belongs to a case.
fn shorter(printer: &Printer<'_>, missing: Id, rest: Id, case: &[(Id, bool)]) -> String {
    let [written, rest] = [missing, rest].map(|id| printer.excerpt(id));
    if case.is_empty() && written.chars().count() <= rest.chars().count() { written } else { rest }
}

const NO_FLOW: &str = "no flow in closed form is known for this piece: take it apart, or leave out `split` to see in `REPORT` what is \
                       found";

const NOT_THE_SUM: &str = "the pieces do not add up to the energy; what is missing";

const SAME_SPELLING: &str =
    "; if that is zero by a relation between functions, write them in the pieces as they are in the energy";

const NOT_COMPARED: &str = "it cannot be decided whether the pieces add up to the energy, because their difference is too long: write \
                            their terms as they are in the energy; what remains is";

const NO_LIFT: &str =
    "`lift` does not follow the momenta, but positions move by them in this term: write q' = X(q) as p·X(q)";
