//! A force beside the energy: a number, or one for each coordinate.

use super::Lowering;
use super::value::shaped;
use crate::ir::{Id, Symbol};
use crate::parse::{Energy, Form, Role};
use syn::Expr;

/// What the velocities ∂H/∂p are called in a force on an energy H(q, p).
pub(crate) const VELOCITY: &str = "v";

impl Lowering {
    /// The entries of `force = expr`, in the order of coordinates; none if something is wrong with it.
    pub(super) fn force(&mut self, expr: &Expr, energy: &Energy) -> Vec<Id> {
        let shape = &energy.coordinates.shape;
        let n = shape.len();
        if energy.form == Form::Hamiltonian {
            if energy.arguments.iter().any(|argument| argument.name == VELOCITY) {
                self.refuse(expr, "in a force `v` is the velocity ∂H/∂p: give the argument `v` another name");
                return vec![];
            }
            let ids: Vec<Id> = (0..n as u32).map(|i| self.graph.symbol(Symbol::Velocity(i))).collect();
            self.scopes.bind(&VELOCITY, shaped(shape, &ids));
        }
        let said = self.errors.len();
        let value = self.expr(expr);
        let mut entries = vec![];
        let extents = self.numbers(expr, value, &mut entries);
        if self.errors.len() > said {
            return vec![];
        }
        let fits =
            extents.is_some_and(|extents| extents == [n] || extents == shape.extents || extents.is_empty() && n == 1);
        if !fits {
            let name = energy.argument(Role::Position).map(|positions| positions.name.to_string()).unwrap_or_default();
            self.refuse(expr, format!("a force has an entry for each of the {n} coordinates, as `{name}` has"));
            return vec![];
        }
        entries
    }
}
