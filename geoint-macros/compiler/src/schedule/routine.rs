//! Routines: functions of the emitted code, with named outputs.

use super::block::Block;
use super::lowering::statements;
use super::operations::Operations;
use super::passes::arranged;
use super::scheduler::Scheduler;
use super::space::{Argument, Space, indices};
use crate::ir::{Id, Symbol};

/// The form of an output.
#[derive(Clone, Debug)]
pub(crate) enum Extent {
    Number,
    /// An array with these extents.
    Array(Vec<usize>),
    /// The derivative of an array by an array of equal extents, row by row.
    Square(Vec<usize>),
    /// New values of coordinates, which the routine writes in place.
    Coordinates(Vec<Symbol>),
    /// Increments of coordinates, which the routine writes to the variable `d`.
    Increments(Vec<Symbol>),
}

/// Values that a routine computes for one purpose.
#[derive(Clone, Debug)]
pub(crate) struct Output {
    /// Name of the variable that receives the values.
    pub(crate) name: &'static str,
    pub(crate) extent: Extent,
    pub(crate) nodes: Vec<Id>,
}

impl Output {
    /// Creates an output with one number.
    pub(crate) fn number(name: &'static str, node: Id) -> Output {
        Output { name, extent: Extent::Number, nodes: vec![node] }
    }

    /// Creates an output with an array of numbers.
    pub(crate) fn array(name: &'static str, extents: &[usize], nodes: Vec<Id>) -> Output {
        Output { name, extent: Extent::Array(extents.to_vec()), nodes }
    }

    /// Creates an output with an array of one dimension.
    pub(crate) fn row(name: &'static str, nodes: Vec<Id>) -> Output {
        Output { name, extent: Extent::Array(vec![nodes.len()]), nodes }
    }

    /// Creates an output with the derivative of an array by an array of equal extents.
    pub(crate) fn square(name: &'static str, extents: &[usize], rows: &[Vec<Id>]) -> Output {
        Output { name, extent: Extent::Square(extents.to_vec()), nodes: rows.concat() }
    }

    /// Returns the indices of every value in its array.
    pub(crate) fn places(&self) -> Vec<Vec<usize>> {
        let extents = match &self.extent {
            Extent::Number | Extent::Coordinates(_) | Extent::Increments(_) => vec![],
            Extent::Array(extents) => extents.clone(),
            Extent::Square(extents) => extents.repeat(2),
        };
        (0..self.nodes.len()).map(|i| indices(&extents, i)).collect()
    }
}

/// A function of the emitted code: its outputs as nodes, and its statements.
#[derive(Clone, Debug, Default)]
pub(crate) struct Routine {
    pub(crate) name: &'static str,
    pub(crate) argument: Option<Argument>,
    pub(crate) outputs: Vec<Output>,
    /// Statements. Their results are the values of all outputs, in order. Empty until the routine is scheduled.
    pub(crate) block: Block,
}

impl Routine {
    /// Creates a routine from its outputs.
    pub(crate) fn new(name: &'static str, outputs: Vec<Output>) -> Routine {
        Routine { name, outputs, ..Routine::default() }
    }

    /// Creates a routine with one number as its output.
    pub(crate) fn number(name: &'static str, node: Id) -> Routine {
        Routine::new(name, vec![Output::number(name, node)])
    }

    /// Creates a routine with one row of numbers as its output.
    pub(crate) fn row(name: &'static str, nodes: Vec<Id>) -> Routine {
        Routine::new(name, vec![Output::row(name, nodes)])
    }

    /// Creates a routine with one array as its output.
    pub(crate) fn array(name: &'static str, output: &'static str, extents: &[usize], nodes: Vec<Id>) -> Routine {
        Routine::new(name, vec![Output::array(output, extents, nodes)])
    }

    /// Adds an array that the routine reads.
    pub(crate) fn reading(self, name: &'static str, space: &Space) -> Routine {
        Routine { argument: Some(Argument { name, space: space.clone() }), ..self }
    }

    /// Returns the nodes of all outputs.
    pub(crate) fn nodes(&self) -> Vec<Id> {
        self.outputs.iter().flat_map(|output| &output.nodes).copied().collect()
    }

    /// Computes the statements of a routine that prepares nothing.
    pub(crate) fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        self.block = statements(scheduler.graph, &self.nodes());
        self.arrange(scheduler);
    }

    /// Runs the passes over the statements.
    pub(super) fn arrange(&mut self, scheduler: &Scheduler<'_>) {
        let layout = scheduler.places(self.argument.as_ref());
        let mut targets = vec![];
        for output in &self.outputs {
            match &output.extent {
                Extent::Coordinates(symbols) => targets.extend(symbols.iter().map(|symbol| layout.place(*symbol))),
                Extent::Increments(symbols) => {
                    targets.extend(symbols.iter().map(|symbol| scheduler.increment(*symbol)))
                }
                _ => {}
            }
        }
        self.block = arranged(std::mem::take(&mut self.block), &layout, &targets);
    }

    /// Returns the cost of the statements.
    pub(crate) fn operations(&self) -> Operations {
        self.block.operations()
    }
}
