//! Checks the density of an invariant measure: a function ρ(x) with div(ρf) = 0 for the field f.

use super::wording::{refutation, undecided};
use crate::analyze::crossings::{self, Kind};
use crate::analyze::{Identity, claims, identity};
use crate::compilation::Compilation;
use crate::derive::Measure;
use crate::diagnostics::Result;
use crate::ir::{Id, Symbol};
use crate::lower::Terms;

/// Proves that the flow of a field keeps the user's density. Reports a density that is not kept, reads other symbols than x, or is zero everywhere.
pub(crate) fn measure(compilation: &mut Compilation<'_>, terms: &Terms, field: &[Id]) -> Result<Option<Measure>> {
    let Some((density, place)) = terms.measure else { return Ok(None) };
    let x: Vec<Symbol> = (0..compilation.degrees()).map(Symbol::Position).collect();
    let message = if let Some(message) = unsuitable(compilation, density, field) {
        message
    } else {
        let (balance, jump) = (
            claims::is_density(&mut compilation.graph, &x, field, density),
            crossings::flux_may_jump(&mut compilation.graph, &x, field, density),
        );
        match (&balance, jump) {
            (Identity::Zero(proof), None) => return Ok(Some(Measure { density, proof: *proof })),
            (Identity::Zero(_), Some(jump)) => {
                let [a, b] = jump.equal.map(|id| compilation.excerpt(id));
                match jump.kind {
                    Kind::Turn => {
                        format!("{UNPROVEN}: ρ or the field jumps where {a} comes round; {INSTEAD_OF_ANGLES}")
                    }
                    _ => format!(
                        "{UNPROVEN}: div(ρf) is zero on both sides of {a} = {b}, but ρf may jump there; {ONE_FLUX}"
                    ),
                }
            }
            _ => unbalanced(compilation, &x, field, &balance),
        }
    };
    compilation.diagnostics.at_place(place, message);
    compilation.checked(None)
}

/// Explains why a function is no density of x, whatever its derivatives are.
fn unsuitable(compilation: &mut Compilation<'_>, density: Id, field: &[Id]) -> Option<String> {
    let reads = compilation.graph.reads(density);
    if reads.t {
        return Some(
            "a density that reads time is not kept: write ρ as a function of the coordinates and parameters".into(),
        );
    }
    if reads.p || reads.s {
        return Some(
            "the density of a lift is a function of its positions: leave out the momenta and the action".into(),
        );
    }
    if field.iter().any(|f| compilation.graph.reads(*f).s) {
        return Some(
            "the field reads the action, so its flow has no density of positions alone: make the action a coordinate"
                .into(),
        );
    }
    identity(&mut compilation.graph, density).is_zero().then(|| {
        "this density is zero everywhere: write a function that is positive somewhere, such as `1.0` for the volume"
            .into()
    })
}

/// Explains why div(ρf) is not zero, or was not proven to be zero.
fn unbalanced(compilation: &mut Compilation<'_>, x: &[Symbol], field: &[Id], balance: &Identity) -> String {
    let (divergence, _) = claims::divergence(&mut compilation.graph, x, field);
    let (printer, divergence) = (compilation.printer(), compilation.excerpt(divergence));
    let refuted = match balance {
        Identity::Wrong(wrong) => {
            format!("the flow does not keep this density: div(ρf)/ρ{}", refutation(&printer, wrong))
        }
        _ => format!("{UNPROVEN}: of div(ρf)/ρ remains{}", undecided(&printer, balance)),
    };
    format!("{refuted}; with div f = {divergence}, ρ needs f·∇ρ = −ρ div f")
}

const UNPROVEN: &str = "this density was not proven to be kept";

const INSTEAD_OF_ANGLES: &str = "write it by the sine and cosine of the angle";

const ONE_FLUX: &str = "give ρ times the velocity across this surface one value";
