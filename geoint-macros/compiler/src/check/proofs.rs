//! Identities that have to hold: skewness, and what a field keeps.

use super::damping::report_damping;
use super::wording::{discontinuity, left, open, remains};
use crate::analyze::{Damping, Identity, Why};
use crate::compilation::Compilation;
use crate::derive::proof;
use crate::diagnostics::Result;
use crate::ir::print::Printer;
use crate::lower::Integral;
use crate::parse::StructureKind;
use syn::Expr;

/// Reports S that is not skew, a function of indices that gives none of it, and damping that is none.
pub(crate) fn structure(
    compilation: &mut Compilation<'_>,
    structure: &proof::Structure,
    damping: Option<&Damping>,
) -> Result<()> {
    let energy = compilation.energy;
    let printer = compilation.printer();
    if let (Err(([i, j], verdict)), Some(form)) = (&structure.skew, &energy.options.structure) {
        let (sum, equal) = match verdict {
            Identity::Wrong(wrong) => (remains(&printer, wrong.rest.as_ref(), &wrong.witness), ""),
            _ => (open(&printer, verdict), " was not proven to be 0"),
        };
        let what = if i == j { format!("twice S[{i}][{i}]") } else { format!("S[{i}][{j}] + S[{j}][{i}]") };
        let advice = if i == j { "" } else { "; `|i, j| …` is asked for i < j alone" };
        let message = format!("S is skew, but {what}{equal}{sum}{advice}");
        match compilation.written(structure.matrix[*j][*i]) {
            Some(place) => compilation.diagnostics.at_place(place, message),
            None => compilation.diagnostics.at(&form.expr, message),
        }
    }
    match (damping, &energy.options.structure) {
        (Some(_), _) => report_damping(compilation, damping),
        (None, Some(form)) if structure.matrix.iter().flatten().all(|entry| compilation.graph.is_zero(*entry)) => {
            let advice = match (form.kind, &form.expr) {
                // Entries for j < i would go unheard.
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

/// Reports functions that are not kept, and those that are functions of others.
pub(crate) fn integrals(
    compilation: &mut Compilation<'_>,
    integrals: &[Integral],
    found: &proof::Integrals,
) -> Result<()> {
    let energy = compilation.energy;
    let Compilation { graph, places, names, diagnostics: errors, .. } = compilation;
    let graph = &*graph;
    let printer = Printer::new(graph, names);
    for (i, (kept, (verdict, jump))) in energy.options.keeps.iter().zip(found.kept.iter().zip(&found.jumps)).enumerate()
    {
        let (name, but) = (&kept.name, if kept.but.is_some() { " but for b·∇I" } else { "" });
        let message = match verdict {
            Identity::Zero(_) => match jump.filter(|_| !kept.assumed) {
                None => continue,
                Some(jump) => {
                    let place = places.get(&jump.node).copied().unwrap_or(integrals[i].place);
                    errors.at_place(place, discontinuity(&printer, name, but, jump));
                    continue;
                }
            },
            // What may hold in a part of phase space is up to the user.
            Identity::Open(_) if kept.assumed => continue,
            Identity::Wrong(wrong) if kept.assumed && !wrong.almost_everywhere => continue,
            Identity::Wrong(wrong) => {
                let rest = remains(&printer, wrong.rest.as_ref(), &wrong.witness);
                format!("`{name}` is not constant along the field{but}: what remains of its derivative{rest}")
            }
            Identity::Open(found) => {
                let why = match (found.why, &found.rest) {
                    // Without functions there is no relation between them.
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
                // Of rounded numbers nothing may remain once they are added up.
                let rest = found.rest.as_ref().filter(|rest| !graph.is_zero(rest.rest));
                let rest = rest.map_or_else(String::new, |rest| {
                    format!("; what remains of its derivative{}", left(&printer, rest))
                });
                format!(
                    "`{name}` was not proven to be constant along the field{but}: {why}; if you know that it is, say \
                     `keeps(assume({name} = …))`{rest}"
                )
            }
        };
        errors.at_place(integrals[i].place, message);
    }
    if let Some(i) = found.dependent.filter(|_| errors.len() == 0) {
        let others = if i == 0 { "is constant everywhere" } else { "is a function of the others" };
        errors.at_place(integrals[i].place, format!("`{}` {others}: leave it out", energy.options.keeps[i].name));
    }
    compilation.checked(())
}
