//! The coefficients of damping: one for all coordinates, one for each, or a matrix.

use super::Lowering;
use super::value::Value;
use crate::ir::Id;
use crate::parse::Shape;
use quote::ToTokens;
use syn::Expr;

impl Lowering {
    /// The square matrix that `damping = expr` stands for; none if something is wrong with it.
    pub(super) fn damping(&mut self, expr: &Expr, coordinates: &Shape) -> Vec<Vec<Id>> {
        let n = coordinates.len();
        let said = self.errors.len();
        let value = self.expr(expr);
        let mut entries = vec![];
        let extents = self.numbers(expr, value, &mut entries);
        if self.errors.len() > said {
            return vec![];
        }
        let coefficients = match extents.as_deref() {
            Some([]) => vec![entries[0]; n],
            Some(extents) if extents == [n] || extents == coordinates.extents => entries,
            Some(extents) if extents == [n, n] => return entries.chunks(n).map(<[Id]>::to_vec).collect(),
            other => {
                let found = match other.map(|extents| extents.iter().map(ToString::to_string).collect::<Vec<_>>()) {
                    Some(extents) => format!("an array of {}", extents.join("×")),
                    None => "rows of different lengths".into(),
                };
                let expected = match n {
                    1 => "a number".into(),
                    _ => format!("a number, an array of {n} numbers, one a coordinate, or a matrix of {n}×{n} numbers"),
                };
                self.refuse(expr, format!("damping is {expected}; found {found}"));
                return vec![];
            }
        };
        let zero = self.graph.zero();
        let row = |i| (0..n).map(|j| if i == j { coefficients[i] } else { zero }).collect();
        (0..n).map(row).collect()
    }

    /// Collects the numbers in nested arrays; their extents from outside in, unless rows differ.
    pub(super) fn numbers(&mut self, expr: &impl ToTokens, value: Value, entries: &mut Vec<Id>) -> Option<Vec<usize>> {
        match value {
            Value::Vector(ids) => {
                entries.extend(&ids);
                Some(vec![ids.len()])
            }
            Value::List(items) => {
                let inner: Vec<_> = items.iter().map(|item| self.numbers(expr, item.clone(), entries)).collect();
                let first = inner.first().cloned().unwrap_or(Some(vec![]))?;
                let same = inner.iter().all(|other| other.as_ref() == Some(&first));
                same.then(|| [vec![items.len()], first].concat())
            }
            number => {
                entries.push(self.real(expr, number));
                Some(vec![])
            }
        }
    }
}
