//! What belongs to systems without momenta: the entries of a field, the structure S of x' = S(x) ∇H, and what a field keeps.

use super::value::Value;
use super::{Lowering, Place, place};
use crate::ir::{Graph, Id};
use crate::parse::{Kept, Shape, StructureForm, StructureKind};
use quote::ToTokens;
use syn::Expr;

/// S of x' = S(x) ∇H.
#[derive(Clone, Debug)]
pub(crate) enum Skew {
    /// Its rows.
    Matrix(Vec<Vec<Id>>),
    /// x' = ∇C × ∇H.
    Nambu(Id),
}

impl Skew {
    /// That of a form without one.
    pub(super) fn none() -> Skew {
        Skew::Matrix(vec![])
    }
}

/// A function I of x that a field is said to keep.
#[derive(Clone, Debug)]
pub(crate) struct Integral {
    pub(crate) value: Id,
    /// b, if it changes by b·∇I.
    pub(crate) but: Option<Vec<Id>>,
    pub(crate) place: Place,
}

/// S of (q, p)' = (∂H/∂p, −∂H/∂q) for the halves of x.
pub(crate) fn canonical(graph: &mut Graph, n: usize) -> Vec<Vec<Id>> {
    let entry = |i: usize, j: usize| i128::from(j == i + n / 2) - i128::from(i == j + n / 2);
    let mut row = |i: usize| (0..n).map(|j| graph.integer(entry(i, j))).collect();
    (0..n).map(&mut row).collect()
}

impl Lowering {
    /// The entries of a field, in order.
    pub(super) fn entries(&mut self, syntax: &impl ToTokens, value: Value, coordinates: &Shape) -> Vec<Id> {
        let (said, told) = (self.errors.len(), matches!(value, Value::Poison));
        let mut entries = vec![];
        self.numbers(syntax, value, &mut entries);
        if !told && self.errors.len() == said && entries.len() != coordinates.len() {
            let n = coordinates.len();
            self.refuse(syntax, format!("expected {n} numbers, one a coordinate; found {}", entries.len()));
        }
        entries.resize(coordinates.len(), self.graph.zero());
        entries
    }

    /// What `keeps(…)` says.
    pub(super) fn integral(&mut self, kept: &Kept, coordinates: &Shape) -> Integral {
        let value = self.expr(&kept.value);
        let value = self.real(&kept.value, value);
        let but = kept.but.as_ref().map(|expr| {
            let b = self.expr(expr);
            self.entries(expr, b, coordinates)
        });
        Integral { value, but, place: place(&kept.value) }
    }

    /// S, in the coordinates x.
    pub(super) fn structure(&mut self, form: &StructureForm, x: &[Id], coordinates: &Shape) -> Skew {
        let (n, expr) = (x.len(), &form.expr);
        let are = |lengths: &[usize]| coordinates.extents.ends_with(lengths);
        match form.kind {
            StructureKind::So3 if are(&[3]) => {
                Skew::Matrix(self.blocks(n, 3, |lowering, i, j, at| lowering.cross(&x[at..at + 3], i, j)))
            }
            // m and γ, in a row or as two vectors.
            StructureKind::Se3 if are(&[6]) || are(&[2, 3]) => {
                Skew::Matrix(self.blocks(n, 6, |lowering, i, j, at| match (i / 3, j / 3) {
                    (0, 0) => lowering.cross(&x[at..at + 3], i, j),
                    (1, 1) => lowering.graph.zero(),
                    _ => lowering.cross(&x[at + 3..at + 6], i % 3, j % 3),
                }))
            }
            StructureKind::Canonical if n.is_multiple_of(2) => Skew::Matrix(canonical(&mut self.graph, n)),
            StructureKind::Nambu if n == 3 => {
                let value = self.expr(expr);
                Skew::Nambu(self.real(expr, value))
            }
            StructureKind::Entries => Skew::Matrix(self.matrix(expr, n)),
            StructureKind::So3 => {
                self.wrong_length(expr, "`so3` is a structure of 3 coordinates, or of an array of such")
            }
            StructureKind::Se3 => self.wrong_length(
                expr,
                "`se3` is a structure of 6 coordinates, or of 2 vectors, or of an array of rows of 6",
            ),
            StructureKind::Canonical => {
                self.wrong_length(expr, "`canonical` is a structure of an even number of coordinates")
            }
            StructureKind::Nambu => self.wrong_length(expr, "`nambu(C)` is a structure of 3 coordinates"),
        }
    }

    fn wrong_length(&mut self, expr: &Expr, message: &str) -> Skew {
        self.refuse(expr, message);
        Skew::Matrix(vec![])
    }

    /// A matrix of equal blocks on the diagonal, the entries of each by where it begins.
    fn blocks(&mut self, n: usize, block: usize, entry: impl Fn(&mut Self, usize, usize, usize) -> Id) -> Vec<Vec<Id>> {
        let mut rows = vec![];
        for i in 0..n {
            let mut row = vec![];
            for j in 0..n {
                let same = i / block == j / block;
                row.push(if same { entry(self, i % block, j % block, i / block * block) } else { self.graph.zero() });
            }
            rows.push(row);
        }
        rows
    }

    /// An entry of the matrix of v ↦ a × v.
    fn cross(&mut self, a: &[Id], i: usize, j: usize) -> Id {
        match (3 + j - i) % 3 {
            1 => self.graph.neg(a[3 - i - j]),
            2 => a[3 - i - j],
            _ => self.graph.zero(),
        }
    }

    /// S by its entries: an array of arrays, or a function of i and j that is asked for i < j.
    fn matrix(&mut self, expr: &Expr, n: usize) -> Vec<Vec<Id>> {
        let said = self.errors.len();
        let zero = self.graph.zero();
        if matches!(expr, Expr::Closure(closure) if closure.inputs.len() != 2) {
            self.refuse(expr, "an entry of S has two indices: `|i, j| …`, asked for i < j");
            return vec![];
        }
        if self.is_no_matrix(expr) {
            self.refuse(expr, forms(n));
            return vec![];
        }
        let value = self.expr(expr);
        if let Value::Callable(callable, sees) = &value {
            let mut matrix = vec![vec![zero; n]; n];
            for j in 0..n {
                for i in 0..j {
                    let indices = vec![Value::Integer(i as i128), Value::Integer(j as i128)];
                    let entry = self.apply(expr, (callable, sees), indices);
                    if self.errors.len() > said {
                        return vec![];
                    }
                    matrix[i][j] = self.real(expr, entry);
                    matrix[j][i] = self.graph.neg(matrix[i][j]);
                }
            }
            return matrix;
        }
        let mut entries = vec![];
        let extents = self.numbers(expr, value, &mut entries);
        if self.errors.len() > said {
            return vec![];
        }
        if extents.as_deref() != Some(&[n, n][..]) {
            self.refuse(expr, forms(n));
            return vec![];
        }
        entries.chunks(n).map(<[Id]>::to_vec).collect()
    }

    /// Whether that is another name than those of structures, or one of them with other arguments.
    fn is_no_matrix(&self, expr: &Expr) -> bool {
        let name = |expr: &Expr| match expr {
            Expr::Path(path) => path.path.get_ident().map(ToString::to_string),
            _ => None,
        };
        match expr {
            Expr::Lit(_) => true,
            Expr::Call(call) => name(&call.func).is_some_and(|name| StructureKind::NAMES.contains(&name.as_str())),
            expr => name(expr).is_some_and(|name| self.scopes.get(&name).is_none()),
        }
    }
}

fn forms(n: usize) -> String {
    format!(
        "a structure is `so3`, `se3`, `canonical`, `nambu(C)`, a matrix of {n}×{n} numbers, or `|i, j| …` for i < j"
    )
}
