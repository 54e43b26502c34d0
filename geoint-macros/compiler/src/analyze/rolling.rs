//! Finds constraints A(q, t) v + b(q, t) = 0 that are rates of functions of positions. By Poincaré's lemma, these rows are closed: ∂ᵢAⱼ = ∂ⱼAᵢ and ∂ᵢb = ∂ₜAᵢ.

use super::identity::{Identity, identity, multiple, vanishes};
use crate::diff::constraint::Row;
use crate::diff::jacobian;
use crate::ir::{Graph, Id, Symbol};

/// Facts about constraints of velocities.
#[derive(Debug)]
pub(crate) enum Binding {
    /// a − c·b of the rows a and b is the rate of a function of positions, which is given if its formula is simple.
    Pair { rows: [usize; 2], factor: Id, function: Option<Id> },
    /// There is one row, and none of its products with a function of positions is such a rate (Frobenius).
    Nonholonomic,
    /// There is one row, and the same is not proven.
    Unknown,
    /// There are several rows, and no such pair was found.
    NoPair,
}

/// Returns whether a row is the rate of a function of positions.
pub(crate) fn is_rate(graph: &mut Graph, row: &Row) -> bool {
    curl(graph, row).into_iter().all(|entry| vanishes(graph, entry))
}

/// The function of q whose rate is a row with constant entries.
pub(crate) fn integral(graph: &mut Graph, gradient: &[Id], drift: Id) -> Option<Id> {
    if !graph.is_zero(drift) || gradient.iter().any(|entry| graph.reads(*entry).moves()) {
        return None;
    }
    let positions: Vec<Id> = (0..gradient.len() as u32).map(|i| graph.symbol(Symbol::Position(i))).collect();
    Some(graph.dot(gradient, &positions))
}

/// Finds pairs of rows that bind positions. No single row is a rate. Beside constraints of positions, rows may be rates on their surface: then only pairs
/// are reported.
pub(crate) fn bindings(graph: &mut Graph, rows: &[Row]) -> Vec<Binding> {
    let all = rows.len();
    let rows: Vec<&Row> = rows.iter().filter(|row| row.value.is_none()).collect();
    let curls: Vec<Vec<Id>> = rows.iter().map(|row| curl(graph, row)).collect();
    let mut found = vec![];
    for i in 0..rows.len() {
        for j in i + 1..rows.len() {
            let Some(factor) = common_factor(graph, &curls[i], &curls[j]) else { continue };
            let mut rest = |a: Id, b: Id| graph.build(a - factor * b);
            let gradient: Vec<Id> = rows[i].gradient.iter().zip(&rows[j].gradient).map(|(a, b)| rest(*a, *b)).collect();
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

/// c with a = c·b for all entries, a number times powers of parameters.
fn common_factor(graph: &mut Graph, a: &[Id], b: &[Id]) -> Option<Id> {
    let first = (0..b.len()).find(|k| !graph.is_zero(b[*k]))?;
    let factor = multiple(graph, a[first], b[first])?;
    for (a, b) in a.iter().zip(b) {
        let rest = graph.build(*a - factor * *b);
        if !vanishes(graph, rest) {
            return None;
        }
    }
    Some(factor)
}

/// All ∂ᵢAⱼ − ∂ⱼAᵢ with i < j, where b is the entry of time.
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

/// Returns whether α∧dα is proven to differ from 0 for the form α of a row: then no integrating factor exists.
fn is_nonholonomic(graph: &mut Graph, row: &Row, curl: &[Id]) -> bool {
    let n = row.gradient.len() + 1;
    let alpha = [&row.gradient[..], &[row.drift]].concat();
    let place = |i: usize, j: usize| i * n - i * (i + 1) / 2 + j - i - 1;
    for i in 0..n {
        for j in i + 1..n {
            for k in j + 1..n {
                let [a, b, c] = [[i, j, k], [j, i, k], [k, i, j]].map(|[one, x, y]| (alpha[one], curl[place(x, y)]));
                let wedge = graph.build(a.0 * a.1 - b.0 * b.1 + c.0 * c.1);
                if matches!(identity(graph, wedge), Identity::Wrong(_)) {
                    return true;
                }
            }
        }
    }
    false
}
