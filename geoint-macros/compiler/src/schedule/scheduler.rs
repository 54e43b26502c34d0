//! What all routines of a system share when they are scheduled: the graph, and the places of coordinates and parameters in emitted code.

use super::layout::{Array, Layout, Place};
use super::space::Argument;
use crate::ir::{Graph, Symbol};

/// The graph and the places. Routines and kernels turn their nodes into statements with it.
pub(crate) struct Scheduler<'a> {
    pub(crate) graph: &'a mut Graph,
    /// Places of coordinates and parameters.
    pub(crate) layout: Layout<'a>,
    /// True if positions and momenta are halves of the array of coordinates.
    pub(crate) has_momenta: bool,
}

impl<'a> Scheduler<'a> {
    /// Returns the places of the inputs of a routine with this argument.
    pub(super) fn places(&self, argument: Option<&Argument>) -> Layout<'a> {
        let mut layout = self.layout.clone();
        layout.argument.extend(argument.iter().flat_map(|argument| argument.space.places()));
        layout
    }

    /// Returns the place of the increment of a coordinate.
    pub(super) fn increment(&self, symbol: Symbol) -> Place {
        let Place { indices, .. } = self.layout.place(symbol);
        let half = match symbol {
            Symbol::Position(_) => 0,
            Symbol::Momentum(_) => 1,
            _ => return Place::number(Symbol::ActionIncrement),
        };
        let indices = if self.has_momenta { [&[half], &indices[..]].concat() } else { indices };
        Place { array: Array::Increment, indices }
    }
}
