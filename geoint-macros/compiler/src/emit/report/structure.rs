//! Reports the skew matrix S of x' = S ∇H, entry by entry.

use super::{Report, entropy};
use crate::analyze::Identity;
use crate::derive::Parted;
use crate::derive::proof::Structure;
use crate::diff::entropy::EntropyStep;
use crate::ir::{Id, Symbol};
use crate::legendre::FirstOrder;

/// Reports a matrix S of the user, or the matrices L and M of a system with an entropy.
pub(super) fn given(report: &mut Report<'_>, structure: &Structure, step: Option<&EntropyStep>) {
    writeln!(report, "\nStructure");
    let equation = match step {
        Some(_) => {
            "x' = L ∇E + M ∇S with skew L and symmetric M; a state at which M is not positive semidefinite is refused"
        }
        None => "x' = S ∇H with skew S",
    };
    writeln!(report, "- {equation}");
    brackets(report, &structure.matrix);
    match &structure.poisson {
        Ok(()) => writeln!(report, "- a Poisson structure: Jacobi's identity holds"),
        Err(([i, j, k], verdict)) => {
            let rest = verdict.rest().map_or_else(String::new, |rest| format!(" leave {}", report.excerpt(rest.rest)));
            let word = if matches!(verdict, Identity::Wrong(_)) { "not" } else { "not proven to be" };
            writeln!(report, "- {word} a Poisson structure: in Jacobi's identity indices ({i}, {j}, {k}){rest}")
        }
    }
    step.iter().for_each(|step| entropy::friction(report, step));
}

/// Reports a matrix S that was found for a field and its integral I.
pub(super) fn found(report: &mut Report<'_>, Parted { integral, matrix, poisson, unique }: &Parted) {
    let alone = if *unique == Some(true) { "" } else { ", one of many" };
    writeln!(report, "\nStructure");
    writeln!(report, "- x' = S ∇I with I = {} and skew S, found{alone}", report.excerpt(*integral));
    brackets(report, matrix);
    match poisson {
        true => writeln!(report, "- a Poisson structure: Jacobi's identity holds"),
        false => writeln!(report, "- not proven to be a Poisson structure"),
    }
}

/// Reports Ω and S = Ω⁻¹ of a Lagrangian that is linear in the velocities, and canonical coordinates.
pub(super) fn of_lagrangian(report: &mut Report<'_>, found: &FirstOrder) {
    writeln!(report, "\nStructure");
    entries(report, &found.form, |_, [i, j]| format!("Ω[{i}][{j}]"));
    writeln!(report, "- x' = S ∇H with S = Ω⁻¹, a Poisson structure because Ω = dϑ");
    brackets(report, &found.structure);
    let Some(canonical) = &found.canonical else {
        return writeln!(
            report,
            "- no canonical coordinates: Ω vanishes on no half of the coordinates, or a change of gauge for it is not elementary; \
             `Gauss` and `ImplicitMidpoint` are those of x' = S ∇H, which are not symplectic"
        );
    };
    if !report.graph().is_zero(canonical.gauge) {
        writeln!(report, "- gauge: ϑ + ∇f with f = {}", report.excerpt(canonical.gauge));
    }
    for (replaced, position) in &canonical.replaced {
        writeln!(
            report,
            "- canonical coordinates: {} and, in the place of {}, {}",
            report.named(Symbol::Position(*position)),
            report.named(Symbol::Position(*replaced)),
            report.excerpt(canonical.values[*replaced as usize])
        );
    }
    writeln!(report, "- `Gauss` and `ImplicitMidpoint` are those of canonical coordinates: symplectic")
}

/// Writes the brackets {xᵢ, xⱼ} = S[i][j].
fn brackets(report: &mut Report<'_>, matrix: &[Vec<Id>]) {
    entries(report, matrix, |report, indices| {
        let [a, b] = indices.map(|i| report.named(Symbol::Position(i as u32)));
        format!("{{{a}, {b}}}")
    });
}

/// Writes the nonzero entries of a skew matrix above its diagonal.
fn entries(report: &mut Report<'_>, matrix: &[Vec<Id>], name: fn(&Report<'_>, [usize; 2]) -> String) {
    let graph = report.graph();
    for (i, row) in matrix.iter().enumerate() {
        for (j, entry) in row.iter().enumerate().skip(i + 1).filter(|(_, entry)| !graph.is_zero(**entry)) {
            writeln!(report, "- {} = {}", name(report, [i, j]), report.excerpt(*entry));
        }
    }
}
