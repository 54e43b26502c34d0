//! Expressions whose value is a number or an array: damping, forces, constraints, and the entries of a vector field.

use super::value::{Value, shaped};
use super::{Lowering, Place, place};
use crate::ir::{Id, Symbol};
use crate::parse::{Energy, Form, Role, Shape};
use quote::ToTokens;
use syn::Expr;

/// Name of the velocities ∂H/∂p in a force on an energy H(q, p).
pub(crate) const VELOCITY: &str = "v";

/// A scalar, a vector or a nested array of numbers.
pub(super) struct Numbers {
    /// All numbers in order.
    pub(super) entries: Vec<Id>,
    /// Extents from outside in. `None` if rows have different lengths.
    pub(super) extents: Option<Vec<usize>>,
}

impl Numbers {
    /// Returns the rows of a matrix of the given width.
    pub(super) fn into_rows(self, width: usize) -> Vec<Vec<Id>> {
        self.entries.chunks(width).map(<[Id]>::to_vec).collect()
    }
}

impl Lowering {
    /// Evaluates an expression to numbers. `None` after an error.
    fn numbers_of(&mut self, expr: &Expr) -> Option<Numbers> {
        let errors = self.errors.len();
        let value = self.expr(expr);
        let numbers = self.numbers(expr, value);
        (self.errors.len() == errors).then_some(numbers)
    }

    /// Returns the numbers in a value.
    pub(super) fn numbers(&mut self, syntax: &impl ToTokens, value: Value) -> Numbers {
        match value {
            Value::Vector(entries) => Numbers { extents: Some(vec![entries.len()]), entries },
            Value::List(items) => {
                let rows: Vec<Numbers> = items.iter().map(|item| self.numbers(syntax, item.clone())).collect();
                let row = rows.first().map_or(Some(vec![]), |row| row.extents.clone());
                let row = row.filter(|row| rows.iter().all(|other| other.extents.as_ref() == Some(row)));
                let extents = row.map(|row| [vec![rows.len()], row].concat());
                Numbers { entries: rows.into_iter().flat_map(|row| row.entries).collect(), extents }
            }
            number => Numbers { entries: vec![self.real(syntax, number)], extents: Some(vec![]) },
        }
    }

    /// Returns the entries of a vector field, one for each coordinate.
    pub(super) fn entries(&mut self, syntax: &impl ToTokens, value: Value, coordinates: &Shape) -> Vec<Id> {
        let (errors, is_poison) = (self.errors.len(), value.is_poison());
        let Numbers { mut entries, .. } = self.numbers(syntax, value);
        if !is_poison && self.errors.len() == errors && entries.len() != coordinates.len() {
            let n = coordinates.len();
            self.refuse(syntax, format!("expected {n} numbers, one a coordinate; found {}", entries.len()));
        }
        entries.resize(coordinates.len(), self.graph.zero());
        entries
    }

    /// Returns the square matrix of an argument such as `damping = expr`. The expression is one coefficient, one for each coordinate, or a matrix. Empty after
    /// an error.
    pub(super) fn coefficients(&mut self, argument: &str, expr: &Expr, coordinates: &Shape) -> Vec<Vec<Id>> {
        let n = coordinates.len();
        let Some(numbers) = self.numbers_of(expr) else { return vec![] };
        let coefficients = match numbers.extents.as_deref() {
            Some([]) => vec![numbers.entries[0]; n],
            Some(extents) if extents == [n] || extents == coordinates.extents => numbers.entries,
            Some(extents) if extents == [n, n] => return numbers.into_rows(n),
            other => {
                let found = match other.map(|extents| extents.iter().map(ToString::to_string).collect::<Vec<_>>()) {
                    Some(extents) => format!("an array of {}", extents.join("×")),
                    None => "rows of different lengths".into(),
                };
                let expected = match n {
                    1 => "a number".into(),
                    _ => format!("a number, an array of {n} numbers, one a coordinate, or a matrix of {n}×{n} numbers"),
                };
                self.refuse(expr, format!("{argument} is {expected}; found {found}"));
                return vec![];
            }
        };
        let zero = self.graph.zero();
        let row = |i| (0..n).map(|j| if i == j { coefficients[i] } else { zero }).collect();
        (0..n).map(row).collect()
    }

    /// Binds the velocities ∂H/∂p of an energy to the name [`VELOCITY`]. A Lagrangian has its own name for them. Returns `false` after an error at `expr`.
    fn binds_velocities(&mut self, expr: &Expr, energy: &Energy) -> bool {
        if energy.form != Form::Hamiltonian {
            return true;
        }
        if energy.arguments.iter().any(|argument| argument.name == VELOCITY) {
            self.refuse(expr, "`v` is the velocity ∂H/∂p here: give the argument `v` another name");
            return false;
        }
        let ids: Vec<Id> = (0..energy.degrees()).map(|i| self.graph.symbol(Symbol::Velocity(i))).collect();
        self.scopes.bind(&VELOCITY, shaped(&energy.coordinates.shape, &ids));
        true
    }

    /// Returns the entries of `force = expr`, one for each coordinate. Empty after an error.
    pub(super) fn force(&mut self, expr: &Expr, energy: &Energy) -> Vec<Id> {
        let shape = &energy.coordinates.shape;
        let n = shape.len();
        if !self.binds_velocities(expr, energy) {
            return vec![];
        }
        let Some(Numbers { entries, extents }) = self.numbers_of(expr) else { return vec![] };
        let fits =
            extents.is_some_and(|extents| extents == [n] || extents == shape.extents || extents.is_empty() && n == 1);
        if !fits {
            let name = energy.argument(Role::Position).map(|positions| positions.name.to_string()).unwrap_or_default();
            self.refuse(expr, format!("a force has an entry for each of the {n} coordinates, as `{name}` has"));
            return vec![];
        }
        entries
    }

    /// Returns the functions of `rolling = expr`, a number or an array. Empty after an error.
    pub(super) fn rolling(&mut self, expr: &Expr, energy: &Energy) -> Vec<(Id, Place)> {
        if self.binds_velocities(expr, energy) { self.constraints(expr) } else { vec![] }
    }

    /// Returns the functions of `constraint = expr`, a number or an array. Empty after an error.
    pub(super) fn constraints(&mut self, expr: &Expr) -> Vec<(Id, Place)> {
        let value = self.expr(expr);
        let Numbers { entries, extents } = self.numbers(expr, value);
        if extents.is_none() {
            self.refuse(expr, "constraints are an array of numbers, one a constraint: `[g1, g2]`");
            return vec![];
        }
        // The elements of a literal array have their own places.
        let places: Vec<Place> = match expr {
            Expr::Array(array) if array.elems.len() == entries.len() => array.elems.iter().map(place).collect(),
            _ => vec![place(expr); entries.len()],
        };
        entries.into_iter().zip(places).collect()
    }
}
