//! Phrases about identities, proofs and coordinates for messages and reports.

use crate::analyze::{Identity, Proof, Remainder, Value, Witness, Wrong};
use crate::ir::{Id, Ratio, Symbol, print::Printer};

/// Joins texts with commas.
pub(crate) fn commas(texts: impl IntoIterator<Item = String>) -> String {
    texts.into_iter().collect::<Vec<_>>().join(", ")
}

/// Lists coordinates of one kind for a message: "`x`, `y`".
pub(super) fn quoted(printer: &Printer<'_>, kind: fn(u32) -> Symbol, coordinates: &[u32]) -> String {
    commas(coordinates.iter().map(|i| format!("`{}`", printer.named(kind(*i)))))
}

/// States the proof of a property. A proof at points bounds the probability that it misses a failure of the property.
pub(crate) fn proven(proof: Proof, property: &str) -> String {
    match proof {
        Proof::Multiplied => "proven by multiplying out".into(),
        Proof::Points(bound) => format!(
            "proven at {} points of finite fields: what is not {property} passes with a probability of at most 2^-{}",
            bound.points, bound.bits
        ),
    }
}

/// Lists the conditions of a case: " where a < b and not c = d". Empty without conditions.
pub(super) fn in_case(printer: &Printer<'_>, case: &[(Id, bool)]) -> String {
    let condition = |(id, holds): &(Id, bool)| format!("{}{}", if *holds { "" } else { "not " }, printer.excerpt(*id));
    let conditions: Vec<String> = case.iter().map(condition).collect();
    if conditions.is_empty() { String::new() } else { format!(" where {}", conditions.join(" and ")) }
}

/// Shows why an identity is wrong: by its remainder, or by its value at the witness if it could not be multiplied out.
pub(super) fn refutation(printer: &Printer<'_>, wrong: &Wrong) -> String {
    match &wrong.rest {
        Some(rest) => remainder(printer, rest),
        None => format!(" is {}", at_witness(printer, &wrong.witness)),
    }
}

/// Shows a remainder: " where a < b is 2·x", or " is 2·x".
pub(super) fn remainder(printer: &Printer<'_>, Remainder { rest, case, .. }: &Remainder) -> String {
    format!("{} is {}", in_case(printer, case), printer.excerpt(*rest))
}

/// Shows a value and its state: "3 where x = 1, y = 2".
pub(crate) fn at_witness(printer: &Printer<'_>, witness: &Witness) -> String {
    let symbol = |(symbol, value): &(Symbol, Ratio)| format!("{} = {}", printer.named(*symbol), ratio(*value));
    let state = commas(witness.state.iter().map(symbol));
    let value = match witness.value {
        Value::Exact(value) => ratio(value),
        Value::Near(value) => format!("{value:.3e}"),
    };
    if state.is_empty() { value } else { format!("{value} where {state}") }
}

fn ratio(Ratio { numerator, denominator }: Ratio) -> String {
    if denominator == 1 { numerator.to_string() } else { format!("{numerator}/{denominator}") }
}

/// Shows the remainder of an undecided identity: " where a < b: 2·x". Empty if the identity could not be multiplied out.
pub(crate) fn undecided(printer: &Printer<'_>, verdict: &Identity) -> String {
    verdict.rest().map_or_else(String::new, |Remainder { rest, case, .. }| {
        format!("{}: {}", in_case(printer, case), printer.excerpt(*rest))
    })
}
