//! The functions that constraints keep at zero: one, or an array of them.

use super::{Lowering, Place, place};
use crate::ir::Id;
use syn::Expr;

impl Lowering {
    /// The functions that `constraint = expr` stands for, each with its place; none if something is wrong with them.
    pub(super) fn constraints(&mut self, expr: &Expr) -> Vec<(Id, Place)> {
        let value = self.expr(expr);
        let mut entries = vec![];
        if self.numbers(expr, value, &mut entries).is_none() {
            self.refuse(expr, "constraints are an array of numbers, one a constraint: `constraint = [g1, g2]`");
            return vec![];
        }
        // Elements of what is no literal array have the place of the whole.
        let places: Vec<Place> = match expr {
            Expr::Array(array) if array.elems.len() == entries.len() => array.elems.iter().map(place).collect(),
            _ => vec![place(expr); entries.len()],
        };
        entries.into_iter().zip(places).collect()
    }
}
