//! The state that the stages of one compilation share: the function, its expressions, the user's names, and messages.

mod names;

use crate::diagnostics::{Diagnostics, Result};
use crate::ir::{Graph, HashMap, Id, Node, print::Printer};
use crate::lower::{self, Lowered, Place, Terms};
use crate::parse::{Energy, Form};
use proc_macro2::Span;
use std::fmt::Display;

pub(crate) use names::Names;

/// One annotated function on its way through the stages.
pub(crate) struct Compilation<'a> {
    pub(crate) energy: &'a Energy,
    /// The kind of system. A Lagrangian that is linear in the velocities becomes [`Form::FirstOrder`].
    pub(crate) form: Form,
    pub(crate) graph: Graph,
    /// Source position of each node: first and last token of the first expression with this value.
    pub(crate) places: HashMap<Id, Place>,
    pub(crate) names: Names<'a>,
    /// Messages of the current stage.
    pub(crate) diagnostics: Diagnostics,
}

impl<'a> Compilation<'a> {
    /// Lowers the body of a function and the expressions of its attribute.
    pub(crate) fn lowered(energy: &'a Energy) -> Result<(Compilation<'a>, Terms)> {
        let Lowered { graph, places, constants, terms } = lower::body(energy)?;
        let (names, form) = (Names { energy, constants }, energy.form);
        Ok((Compilation { energy, form, graph, places, names, diagnostics: Diagnostics::default() }, terms))
    }

    /// Returns the number of degrees of freedom, or of coordinates if there are no momenta.
    pub(crate) fn degrees(&self) -> u32 {
        self.energy.degrees()
    }

    /// Returns the extents of the array of positions: `[1]` for a scalar.
    pub(crate) fn positions(&self) -> Vec<usize> {
        match &self.energy.coordinates.shape.extents[..] {
            [] => vec![1],
            extents => extents.to_vec(),
        }
    }

    /// Returns a printer of nodes with the user's names.
    pub(crate) fn printer(&self) -> Printer<'_> {
        Printer::new(&self.graph, &self.names)
    }

    /// Returns the formula of a node, cut to the length of a message.
    pub(crate) fn excerpt(&self, id: Id) -> String {
        self.printer().excerpt(id)
    }

    /// Reports a term at its source position, or at `span` if no expression of the user has its value.
    pub(crate) fn blame(&mut self, term: Id, span: Span, why: &str) {
        let place = self.places.get(&term).copied().unwrap_or((span, span));
        let message = format!("{why}: {}", self.excerpt(term));
        self.diagnostics.at_place(place, message);
    }

    /// Reports a message at one token.
    pub(crate) fn report_at(&mut self, span: Span, message: impl Display) {
        self.diagnostics.at_place((span, span), message);
    }

    /// Returns the source position of a node. Symbols and numbers have none, because they may occur elsewhere first.
    pub(crate) fn written(&self, id: Id) -> Option<Place> {
        let compound = !matches!(self.graph.node(id), Node::Symbol(_) | Node::Number(_));
        self.places.get(&id).copied().filter(|_| compound)
    }

    /// Ends a stage: returns its value, or the messages that it has reported.
    pub(crate) fn checked<T>(&mut self, value: T) -> Result<T> {
        std::mem::take(&mut self.diagnostics).or(value)
    }
}
