//! Reports the divergence of a field, its energy, and the structure that was found.

use super::{Report, measure, structure};
use crate::analyze::Identity;
use crate::analyze::crossings::Discontinuity;
use crate::analyze::liouville::{NoEnergy, Open};
use crate::check::wording::{at_witness, proven, undecided};
use crate::derive::{FieldFindings, Liouville, Multiplier, Parted, Recovered};

/// Reports the divergence, the energy, and S if it was searched for.
pub(super) fn report(
    report: &mut Report<'_>,
    FieldFindings { liouville, parted, measure: invariant, .. }: &FieldFindings,
) {
    divergence(report, liouville);
    match &liouville.energy {
        Some(Ok(recovered)) => energy(report, recovered),
        Some(Err(flaw)) => no_energy(report, flaw, liouville.divergence.1.is_zero()),
        None => {}
    }
    if let Some(Multiplier { value, energy }) = &liouville.multiplier {
        writeln!(report, "- Jacobi's multiplier: div(μf) = 0 with μ = {}", report.excerpt(*value));
        if let Some(energy) = energy {
            writeln!(report, "- f = J ∇H/μ with H = {}, on a simply connected domain", report.formula(*energy));
        }
    }
    if let Some(parted @ Parted { unique: Some(_), .. }) = parted {
        structure::found(report, parted);
    }
    if let Some(invariant) = invariant {
        measure::report(report, invariant);
    }
}

/// Writes the divergence, and whether it is zero.
fn divergence(report: &mut Report<'_>, found: &Liouville) {
    let (sum, verdict) = &found.divergence;
    let formula = report.excerpt(*sum);
    writeln!(report, "\nDivergence");
    match verdict {
        Identity::Zero(proof) => writeln!(report, "- div f = 0, {}", proven(*proof, "0")),
        Identity::Wrong(wrong) => {
            let value = at_witness(&report.printer, &wrong.witness);
            let shown = if formula == value { String::new() } else { format!(": it is {value}") };
            writeln!(report, "- div f = {formula}, not 0{shown}; no energy has this field");
        }
        Identity::Open(_) => {
            let rest = undecided(&report.printer, verdict);
            writeln!(report, "- div f = {formula}, which was not proven to be 0{rest}");
        }
    }
}

/// Writes the energy of a field, and whether methods keep it.
fn energy(report: &mut Report<'_>, Recovered { energy, proof, everywhere, jump }: &Recovered) {
    let (energy, proof) = (report.formula(*energy), proven(*proof, "canonical"));
    match jump {
        _ if !everywhere => writeln!(
            report,
            "- canonical, H = {energy} on a simply connected domain, {proof}; not kept, because the field is defined where H is not"
        ),
        Some(Discontinuity { equal, .. }) => {
            let [a, b] = equal.map(|id| report.excerpt(id));
            writeln!(
                report,
                "- canonical, H = {energy} on each side, {proof}; not kept, because it may jump where {a} = {b}"
            );
        }
        None => {
            writeln!(report, "- canonical, H = {energy}, {proof}: write it with `#[hamiltonian]` for kicks and drifts");
        }
    }
}

/// Writes why no energy of the field is known in closed form.
fn no_energy(report: &mut Report<'_>, flaw: &NoEnergy, divergence_free: bool) {
    match flaw {
        // The line about the divergence already rules out an energy, or leaves it open.
        NoEnergy::NotCanonical(..) if !divergence_free => {}
        NoEnergy::NotCanonical(pair, verdict) => {
            let [a, b] = pair.map(|symbol| report.named(symbol));
            let difference = format!("∂²H/∂{a}∂{b} − ∂²H/∂{b}∂{a}");
            match verdict {
                Identity::Wrong(wrong) => {
                    let value = at_witness(&report.printer, &wrong.witness);
                    writeln!(report, "- no energy has this field: {difference} would be {value}");
                }
                _ => {
                    let rest = undecided(&report.printer, verdict);
                    writeln!(
                        report,
                        "- not proven to be the field of an energy: {difference} was not proven to be 0{rest}"
                    )
                }
            }
        }
        NoEnergy::NotElementary(term, proof) => {
            let why = term.map_or_else(
                || "no antiderivative was found".into(),
                |term| format!("no antiderivative is known here of {}", report.excerpt(term)),
            );
            let proof = proven(*proof, "canonical");
            writeln!(report, "- canonical, with an energy on each simply connected domain, {proof}; {why}");
        }
        NoEnergy::Integrals(Open { elementary, integrals, proof }) => {
            let mut energy: Vec<String> = elementary.iter().map(|energy| report.formula(*energy)).collect();
            energy.extend(
                integrals.iter().map(|(term, over)| format!("∫ {} d{}", report.formula(*term), report.named(*over))),
            );
            let (energy, proof) = (energy.join(" + "), proven(*proof, "canonical"));
            writeln!(
                report,
                "- canonical, H = {energy}, {proof}; no antiderivative of that is known here: steps do not keep H, and Gauss methods are symplectic"
            );
        }
    }
}
