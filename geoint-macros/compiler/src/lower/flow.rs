//! Attribute expressions of systems without momenta: the structure S of x' = S(x) ∇H, and first integrals.

use super::value::Value;
use super::{Lowering, Place};
use crate::ir::{Graph, Id};
use crate::parse::{Kept, Shape, StructureForm, StructureKind};
use syn::Expr;

/// S of x' = S(x) ∇H.
#[derive(Clone, Debug)]
pub(crate) enum Skew {
    /// Rows of S.
    Matrix(Vec<Vec<Id>>),
    /// C of x' = ∇C × ∇H.
    Nambu(Id),
}

impl Skew {
    /// Returns the structure of a system without one, or after an error.
    pub(super) fn none() -> Skew {
        Skew::Matrix(vec![])
    }
}

/// S and M of x' = L ∇E + M ∇S, as stated by the user.
#[derive(Clone, Debug)]
pub(crate) struct Entropy {
    pub(crate) value: Id,
    pub(crate) place: Place,
    /// The rows of M.
    pub(crate) friction: Vec<Vec<Id>>,
}

/// A first integral I(x) of a vector field, as stated by the user.
#[derive(Clone, Debug)]
pub(crate) struct Integral {
    pub(crate) value: Id,
    /// b of a function with the rate b·∇I.
    pub(crate) but: Option<Vec<Id>>,
    pub(crate) place: Place,
}

/// Returns S of (q, p)' = (∂H/∂p, −∂H/∂q) for the halves of x.
pub(crate) fn canonical(graph: &mut Graph, n: usize) -> Vec<Vec<Id>> {
    let entry = |i: usize, j: usize| i128::from(j == i + n / 2) - i128::from(i == j + n / 2);
    let mut row = |i: usize| (0..n).map(|j| graph.integer(entry(i, j))).collect();
    (0..n).map(&mut row).collect()
}

impl Lowering {
    /// Evaluates a first integral.
    pub(super) fn integral(&mut self, kept: &Kept, coordinates: &Shape) -> Integral {
        let (value, place) = self.number(&kept.value);
        let but = kept.but.as_ref().map(|expr| {
            let b = self.expr(expr);
            self.entries(expr, b, coordinates)
        });
        Integral { value, but, place }
    }

    /// Evaluates an entropy and its friction matrix.
    pub(super) fn entropy(&mut self, value: &Expr, friction: &Expr, coordinates: &Shape) -> Entropy {
        let (value, place) = self.number(value);
        Entropy { value, place, friction: self.coefficients("friction", friction, coordinates) }
    }

    /// Evaluates S in the coordinates x.
    pub(super) fn structure(&mut self, form: &StructureForm, x: &[Id], coordinates: &Shape) -> Skew {
        let (n, expr) = (x.len(), &form.expr);
        let are = |lengths: &[usize]| coordinates.extents.ends_with(lengths);
        let message = match form.kind {
            StructureKind::So3 if are(&[3]) => {
                let blocks = self.blocks(n, 3, |lowering, i, j, start| lowering.cross(&x[start..start + 3], i, j));
                return Skew::Matrix(blocks);
            }
            // m and γ are the halves of a row, or two rows.
            StructureKind::Se3 if are(&[6]) || are(&[2, 3]) => {
                return Skew::Matrix(self.blocks(n, 6, |lowering, i, j, start| match (i / 3, j / 3) {
                    (0, 0) => lowering.cross(&x[start..start + 3], i, j),
                    (1, 1) => lowering.graph.zero(),
                    _ => lowering.cross(&x[start + 3..start + 6], i % 3, j % 3),
                }));
            }
            StructureKind::Canonical if n.is_multiple_of(2) => return Skew::Matrix(canonical(&mut self.graph, n)),
            StructureKind::Nambu if n == 3 => return Skew::Nambu(self.number(expr).0),
            StructureKind::Entries => return Skew::Matrix(self.matrix(expr, n)),
            StructureKind::So3 => "`so3` is a structure of 3 coordinates, or of an array of such",
            StructureKind::Se3 => "`se3` is a structure of 6 coordinates, or of 2 vectors, or of an array of rows of 6",
            StructureKind::Canonical => "`canonical` is a structure of an even number of coordinates",
            StructureKind::Nambu => "`nambu(C)` is a structure of 3 coordinates",
        };
        self.refuse(expr, message);
        Skew::none()
    }

    /// Returns a matrix of equal blocks on the diagonal. `entry(i, j, start)` is entry (i, j) of the block that starts at row `start`.
    fn blocks(&mut self, n: usize, block: usize, entry: impl Fn(&mut Self, usize, usize, usize) -> Id) -> Vec<Vec<Id>> {
        let mut row = |i: usize| {
            let in_block = |j: usize| i / block == j / block;
            let columns = (0..n).map(|j| match in_block(j) {
                true => entry(self, i % block, j % block, i / block * block),
                false => self.graph.zero(),
            });
            columns.collect()
        };
        (0..n).map(&mut row).collect()
    }

    /// Returns entry (i, j) of the matrix of v ↦ a × v.
    fn cross(&mut self, a: &[Id], i: usize, j: usize) -> Id {
        match (3 + j - i) % 3 {
            1 => self.graph.neg(a[3 - i - j]),
            2 => a[3 - i - j],
            _ => self.graph.zero(),
        }
    }

    /// Evaluates the entries of S: an array of arrays, or a function of i and j for i < j. Empty after an error.
    fn matrix(&mut self, expr: &Expr, n: usize) -> Vec<Vec<Id>> {
        let errors = self.errors.len();
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
        if let Value::Function(function) = &value {
            let mut matrix = vec![vec![zero; n]; n];
            for j in 0..n {
                for i in 0..j {
                    let indices = vec![Value::Integer(i as i128), Value::Integer(j as i128)];
                    let entry = self.apply(expr, function, indices);
                    if self.errors.len() > errors {
                        return vec![];
                    }
                    matrix[i][j] = self.real(expr, entry);
                    matrix[j][i] = self.graph.neg(matrix[i][j]);
                }
            }
            return matrix;
        }
        let numbers = self.numbers(expr, value);
        if self.errors.len() > errors {
            return vec![];
        }
        if numbers.extents.as_deref() != Some(&[n, n][..]) {
            self.refuse(expr, forms(n));
            return vec![];
        }
        numbers.into_rows(n)
    }

    /// Returns whether an expression is an unknown name, a literal, or the name of a structure with wrong arguments.
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
