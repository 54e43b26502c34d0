//! Routines: functions of the emitted code, with named outputs.

use super::block::{Block, Operations};
use super::kernel::statements;
use super::passes::arranged;
use super::scheduler::Scheduler;
use crate::ir::{Id, Symbol};

/// Symbols in order, and the extents of the array that holds them.
#[derive(Clone, Debug)]
pub(crate) struct Space {
    pub(crate) symbols: Vec<Symbol>,
    /// From outside in: `[5, 3]` for `[[R; 3]; 5]`.
    pub(crate) extents: Vec<usize>,
}

impl Space {
    /// Arranges unknowns in an array by their number. One array of positions has the extents `positions`, positions with momenta are two of them, and
    /// any other unknowns form a row.
    pub(crate) fn of_unknowns(symbols: Vec<Symbol>, positions: &[usize]) -> Space {
        let degrees: usize = positions.iter().product();
        let extents = match symbols.len() {
            count if count == degrees => positions.to_vec(),
            count if count == 2 * degrees => phase(positions),
            count => vec![count],
        };
        Space { symbols, extents }
    }

    /// Returns the number of symbols.
    pub(crate) fn len(&self) -> usize {
        self.symbols.len()
    }

    /// Returns the symbols with their indices.
    pub(crate) fn places(&self) -> Vec<(Symbol, Vec<usize>)> {
        self.symbols.iter().enumerate().map(|(i, symbol)| (*symbol, indices(&self.extents, i))).collect()
    }
}

/// Returns the extents of the array of positions and momenta.
pub(crate) fn phase(positions: &[usize]) -> Vec<usize> {
    [&[2], positions].concat()
}

/// Returns the indices of the `i`-th number of an array.
pub(crate) fn indices(extents: &[usize], mut i: usize) -> Vec<usize> {
    let mut indices = vec![0; extents.len()];
    for (index, extent) in indices.iter_mut().zip(extents).rev() {
        *index = i % extent;
        i /= extent;
    }
    indices
}

/// An array that a routine reads in addition to coordinates and parameters.
#[derive(Clone, Debug)]
pub(crate) struct Argument {
    pub(crate) name: &'static str,
    pub(crate) space: Space,
}

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
