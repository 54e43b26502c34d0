//! Checks identities that the user's system must satisfy: S is skew, and a field keeps the listed functions.

use super::damping::report_damping;
use super::wording::{refutation, remainder, undecided};
use crate::analyze::crossings::{Discontinuity, Kind};
use crate::analyze::{Damping, Identity, Why};
use crate::compilation::Compilation;
use crate::derive::proof;
use crate::diagnostics::Result;
use crate::lower::Integral;
use crate::parse::{Kept, StructureKind};
use syn::Expr;

/// Reports a matrix S that is zero or not skew, and damping that feeds energy.
pub(crate) fn structure(
    compilation: &mut Compilation<'_>,
    structure: &proof::Structure,
    damping: Option<&Damping>,
) -> Result<()> {
    let energy = compilation.energy;
    let printer = compilation.printer();
    if let (Err(([i, j], verdict)), Some(form)) = (&structure.skew, &energy.options.structure) {
        let (relation, value) = match verdict {
            Identity::Wrong(wrong) => ("", refutation(&printer, wrong)),
            _ => (" was not proven to be 0", undecided(&printer, verdict)),
        };
        let (sum, advice) = match i == j {
            true => (format!("twice S[{i}][{i}]"), ""),
            false => (format!("S[{i}][{j}] + S[{j}][{i}]"), "; `|i, j| …` is asked for i < j alone"),
        };
        let message = format!("S is skew, but {sum}{relation}{value}{advice}");
        match compilation.written(structure.matrix[*j][*i]) {
            Some(place) => compilation.diagnostics.at_place(place, message),
            None => compilation.diagnostics.at(&form.expr, message),
        }
    }
    match (damping, &energy.options.structure) {
        (Some(_), _) => report_damping(compilation, damping),
        (None, Some(form)) if structure.matrix.iter().flatten().all(|entry| compilation.graph.is_zero(*entry)) => {
            let advice = match (form.kind, &form.expr) {
                // The compiler ignores entries for j < i.
                (_, Expr::Closure(_)) => "`|i, j| …` is asked for i < j alone",
                _ if structure.matrix.len() == 1 => {
                    "one coordinate has no other structure: x' = f(x) is a `#[vector_field]`"
                }
                (StructureKind::Nambu, _) => "the function in `nambu(…)` has to read `x`",
                _ => "write its entries S[i][j] = −S[j][i], or x' = −C ∇H by `damping = C`",
            };
            compilation.diagnostics.at(&form.expr, format!("S is zero, so that nothing moves; {advice}"));
        }
        (None, _) => {}
    }
    compilation.checked(())
}

/// Reports listed functions that are not constant along the field, or depend on the other functions.
pub(crate) fn integrals(
    compilation: &mut Compilation<'_>,
    integrals: &[Integral],
    found: &proof::Integrals,
) -> Result<()> {
    let keeps = &compilation.energy.options.keeps;
    let claims = keeps.iter().zip(integrals).zip(found.kept.iter().zip(&found.jumps));
    for ((kept, integral), (verdict, jump)) in claims {
        let (message, place) = match jump {
            Some(jump) if verdict.is_zero() && !kept.assumed => {
                let place = compilation.places.get(&jump.node).copied();
                (Some(discontinuity(compilation, kept, *jump)), place.unwrap_or(integral.place))
            }
            _ => (change(compilation, kept, verdict), integral.place),
        };
        if let Some(message) = message {
            compilation.diagnostics.at_place(place, message);
        }
    }
    if let Some(i) = found.dependent.filter(|_| compilation.diagnostics.len() == 0) {
        let others = if i == 0 { "is constant everywhere" } else { "is a function of the others" };
        compilation.diagnostics.at_place(integrals[i].place, format!("`{}` {others}: leave it out", keeps[i].name));
    }
    compilation.checked(())
}

/// Starts a message about a listed function: "`f` is not constant along the field".
fn along_field(Kept { name, but, .. }: &Kept, constancy: &str) -> String {
    format!("`{name}` {constancy} constant along the field{}", if but.is_some() { " but for b·∇I" } else { "" })
}

const UNPROVEN: &str = "was not proven to be";

/// Explains why a listed function may change along the field. `None` if it is constant, or if the user answers for it.
fn change(compilation: &Compilation<'_>, kept: &Kept, verdict: &Identity) -> Option<String> {
    let (graph, printer) = (&compilation.graph, compilation.printer());
    let Kept { name, assumed, .. } = kept;
    match verdict {
        Identity::Zero(_) => None,
        // An assumed function may be constant in a part of phase space only.
        Identity::Open(_) if *assumed => None,
        Identity::Wrong(wrong) if *assumed && !wrong.almost_everywhere => None,
        Identity::Wrong(wrong) => {
            let rest = refutation(&printer, wrong);
            Some(format!("{}: what remains of its derivative{rest}", along_field(kept, "is not")))
        }
        Identity::Open(found) => {
            let why = match (found.why, &found.rest) {
                // A rational remainder contains no functions, so it needs no relation between functions.
                (Why::Relation, Some(rest)) if rest.is_rational(graph) && !rest.case.is_empty() => {
                    "no state was met at which what remains is not zero"
                }
                (Why::Relation, Some(rest)) if rest.is_rational(graph) => {
                    "it holds to rounding, and numbers in it are rounded"
                }
                (Why::Relation, _) => {
                    "it holds to rounding, and rests on a relation between functions that is not known here"
                }
                (Why::Branch, _) => "it holds to rounding, for one choice of the signs of roots",
                (Why::TooLong, _) => "it holds to rounding, and is too long to be decided",
                (Why::Nowhere, _) => "no state was met at which it is defined",
            };
            // The sum of rounded numbers may be zero.
            let rest = found.rest.as_ref().filter(|rest| !graph.is_zero(rest.rest));
            let rest = rest.map_or_else(String::new, |rest| {
                format!("; what remains of its derivative{}", remainder(&printer, rest))
            });
            let unproven = along_field(kept, UNPROVEN);
            Some(format!("{unproven}: {why}; if you know that it is, say `keeps(assume({name} = …))`{rest}"))
        }
    }
}

/// Reports the surface on which a function with a derivative of zero may jump.
fn discontinuity(
    compilation: &Compilation<'_>,
    kept: &Kept,
    Discontinuity { equal, kind, .. }: Discontinuity,
) -> String {
    let [a, b] = equal.map(|id| compilation.excerpt(id));
    let (name, unproven) = (&kept.name, along_field(kept, UNPROVEN));
    match kind {
        Kind::Crossed => format!(
            "{unproven}: its derivative is zero, but it may jump where {a} = {b}; if you know that it does not, say \
             `keeps(assume({name} = …))`"
        ),
        Kind::Followed => format!(
            "`{name}` jumps where {a} = {b}, and solutions stay there, so that rounding decides its value: make both sides equal \
             there, or keep what this condition compares"
        ),
        Kind::Turn => format!(
            "`{name}` jumps where this angle by `atan2` comes round: keep the angle times a constant, or a function of its sine and cosine"
        ),
        Kind::Angle => format!(
            "{unproven}: both arguments of this `atan2` vanish where {a} = {b}, and the angle jumps there by less than a turn; take \
             the common factor out of both"
        ),
    }
}
