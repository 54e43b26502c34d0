//! The divergence of a field, and the structure that was found, in words.

use super::Report;
use super::structure::brackets;
use crate::analyze::Identity;
use crate::analyze::crossings::Discontinuity;
use crate::analyze::liouville::{NoEnergy, Open};
use crate::check::wording::{at_witness, open, proven};
use crate::derive::{FieldFindings, Liouville, Multiplier, Parted, Recovered};
use crate::ir::{Id, Symbol};

/// The divergence, and S if it was searched for.
pub(super) fn of_field(report: &mut Report<'_>, FieldFindings { liouville, parted, .. }: &FieldFindings) {
    divergence(report, liouville);
    if let Some(parted @ Parted { unique: Some(_), .. }) = parted {
        structure(report, parted);
    }
}

fn divergence(report: &mut Report<'_>, found: &Liouville) {
    writeln!(report, "\nDivergence");
    let (sum, verdict) = &found.divergence;
    match verdict {
        Identity::Zero(proof) => writeln!(report, "- div f = 0, {}", proven(*proof, "0")),
        Identity::Wrong(wrong) => {
            let value = at_witness(&report.printer, &wrong.witness);
            let formula = report.excerpt(*sum);
            let shown = if formula == value { String::new() } else { format!(": it is {value}") };
            writeln!(report, "- div f = {formula}, not 0{shown}; no energy has this field");
        }
        Identity::Open(_) => {
            writeln!(
                report,
                "- div f = {}, which was not proven to be 0{}",
                report.excerpt(*sum),
                open(&report.printer, verdict)
            );
        }
    }
    match &found.energy {
        // That the divergence is not zero says it already.
        Some(Err(NoEnergy::NotCanonical(..))) if !verdict.is_zero() => {}
        Some(Err(NoEnergy::NotCanonical([a, b], verdict))) => {
            let [a, b] = [a, b].map(|symbol| report.named(*symbol));
            let difference = format!("∂²H/∂{a}∂{b} − ∂²H/∂{b}∂{a}");
            match verdict {
                Identity::Wrong(wrong) => {
                    let value = at_witness(&report.printer, &wrong.witness);
                    writeln!(report, "- no energy has this field: {difference} would be {value}");
                }
                _ => writeln!(
                    report,
                    "- not proven to be the field of an energy: {difference} was not proven to be 0{}",
                    open(&report.printer, verdict)
                ),
            }
        }
        Some(Err(NoEnergy::NotElementary(term, proof))) => {
            let why = term.map_or_else(
                || "no antiderivative was found".into(),
                |term| format!("no antiderivative is known here of {}", report.excerpt(term)),
            );
            let proof = proven(*proof, "canonical");
            writeln!(report, "- canonical, with an energy on each simply connected domain, {proof}; {why}");
        }
        Some(Err(NoEnergy::Integrals(Open { elementary, integrals, proof }))) => {
            let elementary = elementary.iter().map(|energy| report.formula(*energy));
            let open = |(term, over): &(Id, Symbol)| format!("∫ {} d{}", report.formula(*term), report.named(*over));
            let energy: Vec<String> = elementary.chain(integrals.iter().map(open)).collect();
            let (energy, proof) = (energy.join(" + "), proven(*proof, "canonical"));
            writeln!(
                report,
                "- canonical, H = {energy}, {proof}; no antiderivative of that is known here: steps do not keep H, and Gauss methods are symplectic"
            );
        }
        Some(Ok(Recovered { energy, proof, everywhere, jump })) => {
            let energy = report.formula(*energy);
            let proof = proven(*proof, "canonical");
            if let Some(Discontinuity { equal: [a, b], .. }) = jump.filter(|_| *everywhere) {
                writeln!(
                    report,
                    "- canonical, H = {energy} on each side, {proof}; not kept, because it may jump where {} = {}",
                    report.excerpt(a),
                    report.excerpt(b)
                );
            } else if *everywhere {
                writeln!(
                    report,
                    "- canonical, H = {energy}, {proof}: write it with `#[hamiltonian]` for kicks and drifts"
                );
            } else {
                writeln!(
                    report,
                    "- canonical, H = {energy} on a simply connected domain, {proof}; not kept, because the field is defined where H is not"
                );
            }
        }
        None => {}
    }
    if let Some(Multiplier { value, energy }) = &found.multiplier {
        writeln!(report, "- Jacobi's multiplier: div(μf) = 0 with μ = {}", report.excerpt(*value));
        if let Some(energy) = energy {
            let energy = report.formula(*energy);
            writeln!(report, "- f = J ∇H/μ with H = {energy}, on a simply connected domain");
        }
    }
}

/// S that was searched for.
fn structure(report: &mut Report<'_>, Parted { integral, matrix, poisson, unique }: &Parted) {
    let alone = if *unique == Some(true) { "" } else { ", one of many" };
    writeln!(report, "\nStructure");
    writeln!(report, "- x' = S ∇I with I = {} and skew S, found{alone}", report.excerpt(*integral));
    brackets(report, matrix);
    let word =
        if *poisson { "a Poisson structure: Jacobi's identity holds" } else { "not proven to be a Poisson structure" };
    writeln!(report, "- {word}")
}
