//! What the divergence of a field says, and which structure was found, in words.

use super::super::kernel::Context;
use super::structure::brackets;
use crate::analyze::Identity;
use crate::analyze::crossings::Discontinuity;
use crate::analyze::liouville::{NoEnergy, Open};
use crate::check::wording::{at_witness, open, proven};
use crate::derive::proof::Integrals;
use crate::derive::{Liouville, Multiplier, Parted, Recovered};
use crate::ir::{Id, Symbol, print::Printer};
use std::fmt::{Result as Written, Write};

/// What is known of a field.
#[derive(Clone, Copy)]
pub(crate) struct OfField<'a> {
    pub(crate) proofs: &'a Integrals,
    pub(crate) liouville: &'a Liouville,
    /// S of the planes, if one is known.
    pub(crate) parted: Option<&'a Parted>,
}

/// The divergence, and S where one was found.
pub(super) fn of_field(
    text: &mut String,
    context: &Context<'_>,
    printer: &Printer<'_>,
    OfField { liouville, parted, .. }: OfField<'_>,
) -> Written {
    divergence(text, printer, liouville)?;
    match parted {
        Some(parted @ Parted { unique: Some(_), .. }) => structure(text, context, printer, parted),
        _ => Ok(()),
    }
}

fn divergence(text: &mut String, printer: &Printer<'_>, found: &Liouville) -> Written {
    writeln!(text, "\nDivergence")?;
    let (sum, verdict) = &found.divergence;
    match verdict {
        Identity::Zero(proof) => writeln!(text, "- div f = 0, {}", proven(*proof, "0"))?,
        Identity::Wrong(wrong) => {
            let value = at_witness(printer, &wrong.witness);
            let formula = printer.excerpt(*sum);
            let shown = if formula == value { String::new() } else { format!(": it is {value}") };
            writeln!(text, "- div f = {formula}, not 0{shown}; no energy has this field")?;
        }
        Identity::Open(_) => {
            writeln!(
                text,
                "- div f = {}, which was not proven to be 0{}",
                printer.excerpt(*sum),
                open(printer, verdict)
            )?;
        }
    }
    match &found.energy {
        // That the divergence is not zero says it already.
        Some(Err(NoEnergy::NotCanonical(..))) if !verdict.is_zero() => {}
        Some(Err(NoEnergy::NotCanonical([a, b], verdict))) => {
            let [a, b] = [a, b].map(|symbol| printer.named(*symbol));
            let difference = format!("∂²H/∂{a}∂{b} − ∂²H/∂{b}∂{a}");
            match verdict {
                Identity::Wrong(wrong) => {
                    let value = at_witness(printer, &wrong.witness);
                    writeln!(text, "- no energy has this field: {difference} would be {value}")?;
                }
                _ => writeln!(
                    text,
                    "- not proven to be the field of an energy: {difference} was not proven to be 0{}",
                    open(printer, verdict)
                )?,
            }
        }
        Some(Err(NoEnergy::NotElementary(term, proof))) => {
            let why = term.map_or_else(
                || "no antiderivative was found".into(),
                |term| format!("no antiderivative is known here of {}", printer.excerpt(term)),
            );
            let proof = proven(*proof, "canonical");
            writeln!(text, "- canonical, with an energy on each simply connected domain, {proof}; {why}")?;
        }
        Some(Err(NoEnergy::Integrals(Open { elementary, integrals, proof }))) => {
            let elementary = elementary.iter().map(|energy| printer.formula(*energy));
            let open = |(term, over): &(Id, Symbol)| format!("∫ {} d{}", printer.formula(*term), printer.named(*over));
            let energy: Vec<String> = elementary.chain(integrals.iter().map(open)).collect();
            let (energy, proof) = (energy.join(" + "), proven(*proof, "canonical"));
            writeln!(
                text,
                "- canonical, H = {energy}, {proof}; no antiderivative of that is known here: steps do not keep H, and Gauss methods are symplectic"
            )?;
        }
        Some(Ok(Recovered { energy, proof, everywhere, jump })) => {
            let energy = printer.formula(*energy);
            let proof = proven(*proof, "canonical");
            if let Some(Discontinuity { equal: [a, b], .. }) = jump.filter(|_| *everywhere) {
                writeln!(
                    text,
                    "- canonical, H = {energy} on each side, {proof}; not kept, because it may jump where {} = {}",
                    printer.excerpt(a),
                    printer.excerpt(b)
                )?;
            } else if *everywhere {
                writeln!(
                    text,
                    "- canonical, H = {energy}, {proof}: write it with `#[hamiltonian]` for kicks and drifts"
                )?;
            } else {
                writeln!(
                    text,
                    "- canonical, H = {energy} on a simply connected domain, {proof}; not kept, because the field is defined where H is not"
                )?;
            }
        }
        None => {}
    }
    if let Some(Multiplier { value, energy }) = &found.multiplier {
        writeln!(text, "- Jacobi's multiplier: div(μf) = 0 with μ = {}", printer.excerpt(*value))?;
        if let Some(energy) = energy {
            let energy = printer.formula(*energy);
            writeln!(text, "- f = J ∇H/μ with H = {energy}, on a simply connected domain")?;
        }
    }
    Ok(())
}

/// S that was searched for.
fn structure(
    text: &mut String,
    context: &Context<'_>,
    printer: &Printer<'_>,
    Parted { integral, matrix, poisson, unique }: &Parted,
) -> Written {
    let alone = if *unique == Some(true) { "" } else { ", one of many" };
    writeln!(text, "\nStructure")?;
    writeln!(text, "- x' = S ∇I with I = {} and skew S, found{alone}", printer.excerpt(*integral))?;
    brackets(text, context, printer, matrix)?;
    let word =
        if *poisson { "a Poisson structure: Jacobi's identity holds" } else { "not proven to be a Poisson structure" };
    writeln!(text, "- {word}")
}
