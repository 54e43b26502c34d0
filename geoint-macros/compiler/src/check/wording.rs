//! Identities in words.

use crate::analyze::crossings::{Discontinuity, Kind};
use crate::analyze::{Identity, Proof, Remainder, Value, Witness};
use crate::ir::{Id, Ratio, Symbol, print::Printer};
use proc_macro2::Ident;

/// How something was proven, which otherwise would be `wrong`.
pub(crate) fn proven(proof: Proof, wrong: &str) -> String {
    match proof {
        Proof::Multiplied => "proven by multiplying out".into(),
        Proof::Points(bound) => format!(
            "proven at {} points of finite fields: what is not {wrong} passes with a probability of at most 2^-{}",
            bound.points, bound.bits
        ),
    }
}

/// " where a < b and not c = d", or nothing.
pub(crate) fn in_case(printer: &Printer<'_>, case: &[(Id, bool)]) -> String {
    let condition = |(id, holds): &(Id, bool)| format!("{}{}", if *holds { "" } else { "not " }, printer.excerpt(*id));
    let conditions: Vec<String> = case.iter().map(condition).collect();
    if conditions.is_empty() { String::new() } else { format!(" where {}", conditions.join(" and ")) }
}

/// " is 2·x", what remains of what is not zero; or a state, and what it is there.
pub(crate) fn remains(printer: &Printer<'_>, rest: Option<&Remainder>, witness: &Witness) -> String {
    match rest {
        Some(rest) => left(printer, rest),
        None => format!(" is {}", at_witness(printer, witness)),
    }
}

/// " where a < b is 2·x", or " is 2·x".
pub(crate) fn left(printer: &Printer<'_>, Remainder { rest, case, .. }: &Remainder) -> String {
    format!("{} is {}", in_case(printer, case), printer.excerpt(*rest))
}

/// "3 where x = 1, y = 2".
pub(crate) fn at_witness(printer: &Printer<'_>, witness: &Witness) -> String {
    let symbol = |(symbol, value): &(Symbol, Ratio)| format!("{} = {}", printer.named(*symbol), ratio(*value));
    let state: Vec<String> = witness.state.iter().map(symbol).collect();
    let value = match witness.value {
        Value::Exact(value) => ratio(value),
        Value::Near(value) => format!("{value:.3e}"),
    };
    if state.is_empty() { value } else { format!("{value} where {}", state.join(", ")) }
}

fn ratio(Ratio { numerator, denominator }: Ratio) -> String {
    if denominator == 1 { numerator.to_string() } else { format!("{numerator}/{denominator}") }
}

/// What remains of what was not decided.
pub(crate) fn open(printer: &Printer<'_>, verdict: &Identity) -> String {
    match verdict.rest() {
        Some(Remainder { rest, case, .. }) => format!("{}: {}", in_case(printer, case), printer.excerpt(*rest)),
        None => String::new(),
    }
}

/// Says where a function with a derivative of zero may jump.
pub(crate) fn discontinuity(
    printer: &Printer<'_>,
    name: &Ident,
    but: &str,
    Discontinuity { equal: [a, b], kind, .. }: Discontinuity,
) -> String {
    let [a, b] = [a, b].map(|id| printer.excerpt(id));
    match kind {
        Kind::Crossed => format!(
            "`{name}` was not proven to be constant along the field{but}: its derivative is zero, but it may jump where {a} = {b}; if you \
             know that it does not, say `keeps(assume({name} = …))`"
        ),
        Kind::Followed => format!(
            "`{name}` jumps where {a} = {b}, and solutions stay there, so that rounding decides its value: make both sides equal \
             there, or keep what this condition compares"
        ),
        Kind::Angle => format!(
            "`{name}` was not proven to be constant along the field{but}: both arguments of this `atan2` vanish where {a} = {b}, and the \
             angle jumps there by less than a turn; take the common factor out of both"
        ),
    }
}
