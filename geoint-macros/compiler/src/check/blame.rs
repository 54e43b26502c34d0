//! Where a term was written.

use crate::diagnostics::Diagnostics;
use crate::ir::HashMap;
use crate::ir::{Graph, Id, Node, print::Printer};
use crate::lower::Place;
use proc_macro2::Span;

/// Reports a term where it was written, else at `span`: it may have been put together from several that were written.
pub(super) fn blame(
    (term, span): (Id, Span),
    why: &str,
    printer: &Printer<'_>,
    places: &HashMap<Id, Place>,
    errors: &mut Diagnostics,
) {
    let place = places.get(&term).copied().unwrap_or((span, span));
    errors.at_place(place, format!("{why}: {}", printer.excerpt(term)));
}

/// Where a node was written, if it is more than a symbol or a number, which may have been written elsewhere first.
pub(super) fn written(graph: &Graph, places: &HashMap<Id, Place>, id: Id) -> Option<Place> {
    let more = !matches!(graph.node(id), Node::Symbol(_) | Node::Number(_));
    places.get(&id).copied().filter(|_| more)
}
