//! The coefficients of damping: one for all coordinates, one for each, or a matrix.

use super::Lowering;
use super::value::Value;
use crate::ir::Id;
use crate::parse::Shape;
use syn::Expr;

impl Lowering {
    /// The square matrix that `damping = expr` stands for; zeros if something is wrong with it.
    pub(super) fn damping(&mut self, expr: &Expr, coordinates: &Shape) -> Vec<Vec<Id>> {
        let n = coordinates.len();
        let said = self.errors.len();
        let value = self.expr(expr);
        let mut entries = vec![];
        let extents = self.numbers(expr, value, &mut entries);
        let zero = self.graph.zero();
        let diagonal = |entry: &dyn Fn(usize) -> Id| {
            let row = |i| (0..n).map(|j| if i == j { entry(i) } else { zero }).collect();
            (0..n).map(row).collect()
        };
        match extents.as_deref() {
            _ if self.errors.len() > said => diagonal(&|_| zero),
            Some([]) => diagonal(&|_| entries[0]),
            Some(extents) if extents == [n] || extents == coordinates.extents => diagonal(&|i| entries[i]),
            Some(extents) if extents == [n, n] => entries.chunks(n).map(<[Id]>::to_vec).collect(),
            other => {
                let found = match other {
                    Some(extents) => extents.iter().map(ToString::to_string).collect::<Vec<_>>().join("×"),
                    None => "rows of different lengths".into(),
                };
                let expected = match n {
                    1 => "a number".into(),
                    _ => format!("a number, an array of {n} numbers, one a coordinate, or a matrix of {n}×{n} numbers"),
                };
                self.refuse(expr, format!("damping is {expected}; this is {found}"));
                diagonal(&|_| zero)
            }
        }
    }

    /// Collects the numbers in nested arrays; their extents from outside in, unless rows differ.
    fn numbers(&mut self, expr: &Expr, value: Value, entries: &mut Vec<Id>) -> Option<Vec<usize>> {
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
