//! Constraints A(q, t) v + b(q, t) = 0, as of rolling wheels: which of them are rates of functions of positions and time?
//!
//! The row (A, b) of a rate is closed: ∂ᵢAⱼ = ∂ⱼAᵢ and ∂ᵢb = ∂ₜAᵢ. By Poincaré's lemma, a closed row is a rate, at least near each point. The functions
//! below test whether rows are closed. "Function of positions" includes functions of time here.

use super::identity::{Identity, identity, multiple, vanishes};
use crate::diff::constraint::Row;
use crate::diff::jacobian;
use crate::ir::{Graph, Id, Symbol};

/// A finding: do constraints of velocities bind positions?
#[derive(Debug)]
pub(crate) enum Binding {
    /// Row i − `factor`·row j is the rate of a function of positions. The function is given if the entries A of this combination are constant and its b
    /// is 0. The indices i and j count constraints of velocities only.
    Pair { rows: [usize; 2], factor: Id, function: Option<Id> },
    /// There is one row. By Frobenius' theorem, none of its products with a function of positions is a rate.
    Nonholonomic,
    /// There is one row. It is not a rate, but its product with a function of positions may be one.
    Unknown,
    /// There are several rows, and no pair was found. Factors that read positions or time, factors that are sums, and combinations of three rows are not
    /// searched.
    NoPair,
}

/// Returns whether a row is proven to be closed. It is then the rate of a function of positions.
pub(crate) fn is_rate(graph: &mut Graph, row: &Row) -> bool {
    curl(graph, row).into_iter().all(|entry| vanishes(graph, entry))
}

/// Returns Σ Aᵢqᵢ, whose rate is the row, if A is constant and b = 0. Integrals of other rows are not computed.
pub(crate) fn integral(graph: &mut Graph, gradient: &[Id], drift: Id) -> Option<Id> {
    if !graph.is_zero(drift) || gradient.iter().any(|entry| graph.reads(*entry).moves()) {
        return None;
    }
    let positions: Vec<Id> = (0..gradient.len() as u32).map(|i| graph.symbol(Symbol::Position(i))).collect();
    Some(graph.dot(gradient, &positions))
}

/// Finds pairs of rows that bind positions. The caller has refused rows that are rates by themselves.
///
/// Beside constraints of positions, a row may be a rate on their surface, although it is none elsewhere. Only pairs are reported then.
pub(crate) fn bindings(graph: &mut Graph, rows: &[Row]) -> Vec<Binding> {
    let all = rows.len();
    // A row with a value is the rate of a constraint of positions.
    let rows: Vec<&Row> = rows.iter().filter(|row| row.value.is_none()).collect();
    let curls: Vec<Vec<Id>> = rows.iter().map(|row| curl(graph, row)).collect();
    let mut found = vec![];
    for i in 0..rows.len() {
        for j in i + 1..rows.len() {
            let Some(factor) = common_factor(graph, &curls[i], &curls[j]) else { continue };
            let mut rest = |of_i: Id, of_j: Id| graph.build(of_i - factor * of_j);
            let pairs = rows[i].gradient.iter().zip(&rows[j].gradient);
            let gradient: Vec<Id> = pairs.map(|(of_i, of_j)| rest(*of_i, *of_j)).collect();
            let drift = rest(rows[i].drift, rows[j].drift);
            found.push(Binding::Pair { rows: [i, j], factor, function: integral(graph, &gradient, drift) });
        }
    }
    match rows[..] {
        _ if rows.len() < all || rows.is_empty() => {}
        [row] if is_nonholonomic(graph, row, &curls[0]) => found.push(Binding::Nonholonomic),
        [_] => found.push(Binding::Unknown),
        _ if found.is_empty() => found.push(Binding::NoPair),
        _ => {}
    }
    found
}

/// Returns c with u = c·v for all entries. c is a number times powers of parameters, so it is constant. This is needed: d(cα) = c dα holds for constants.
fn common_factor(graph: &mut Graph, u: &[Id], v: &[Id]) -> Option<Id> {
    let first = (0..v.len()).find(|k| !graph.is_zero(v[*k]))?;
    let factor = multiple(graph, u[first], v[first])?;
    for (u, v) in u.iter().zip(v) {
        let rest = graph.build(*u - factor * *v);
        if !vanishes(graph, rest) {
            return None;
        }
    }
    Some(factor)
}

/// Returns all ∂ᵢAⱼ − ∂ⱼAᵢ with i < j, ordered by i, then j. Time is the last coordinate, and b is its entry of A.
fn curl(graph: &mut Graph, row: &Row) -> Vec<Id> {
    let n = row.gradient.len();
    let symbols: Vec<Symbol> = (0..n as u32).map(Symbol::Position).chain([Symbol::Time]).collect();
    let entries = [&row.gradient[..], &[row.drift]].concat();
    let slopes = jacobian(graph, &entries, &symbols);
    let mut curl = vec![];
    for i in 0..=n {
        for j in i + 1..=n {
            curl.push(graph.sub(slopes[j][i], slopes[i][j]));
        }
    }
    curl
}

/// Returns whether α∧dα is proven not to vanish identically, for the form α = A dq + b dt of a row. Then no integrating factor exists.
///
/// (α∧dα)ᵢⱼₖ = αᵢ dαⱼₖ − αⱼ dαᵢₖ + αₖ dαᵢⱼ.
fn is_nonholonomic(graph: &mut Graph, row: &Row, curl: &[Id]) -> bool {
    let n = row.gradient.len() + 1;
    let alpha = [&row.gradient[..], &[row.drift]].concat();
    // The index in `curl` of the entry i < j. The rows before i have (n − 1) + … + (n − i) = i n − i (i + 1)/2 entries.
    let place = |i: usize, j: usize| i * n - i * (i + 1) / 2 + j - i - 1;
    for i in 0..n {
        for j in i + 1..n {
            for k in j + 1..n {
                let [of_i, of_j, of_k] = [i, j, k].map(|index| alpha[index]);
                let [d_jk, d_ik, d_ij] = [(j, k), (i, k), (i, j)].map(|(row, column)| curl[place(row, column)]);
                let wedge = graph.build(of_i * d_jk - of_j * d_ik + of_k * d_ij);
                if matches!(identity(graph, wedge), Identity::Wrong(_)) {
                    return true;
                }
            }
        }
    }
    false
}
