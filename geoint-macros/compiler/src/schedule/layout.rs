//! Places of the inputs and results of a routine: arrays and indices. The loop pass needs the places, and the printer names the arrays.

use crate::ir::Symbol;
use crate::parse::{Energy, Leaf, Shape};

/// A variable of a routine. The order of the variants decides the order of loops.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) enum Array {
    Position,
    Momentum,
    Velocity,
    /// The momentum increment of a kick before a flow.
    Kick,
    /// The array argument of the emitted function, such as the unknowns of an implicit step.
    Argument,
    /// The increments of a flow.
    Increment,
    /// A parameter, by its number.
    Parameter(usize),
    /// A number outside of arrays.
    Number(Symbol),
}

impl Array {
    /// Returns the number of an array. Hashes of these numbers decide the order of loops.
    pub(super) fn number(self) -> usize {
        match self {
            Array::Position => 0,
            Array::Momentum => 1,
            Array::Velocity => 2,
            Array::Kick => 3,
            Array::Argument => 4,
            Array::Increment => 5,
            Array::Parameter(number) => 6 + number,
            Array::Number(_) => usize::MAX,
        }
    }
}

/// An entry of an array, or a number without indices.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Place {
    pub(crate) array: Array,
    /// From outside in.
    pub(crate) indices: Vec<usize>,
}

impl Place {
    /// Returns the place of a number outside of arrays.
    pub(crate) fn number(symbol: Symbol) -> Place {
        Place { array: Array::Number(symbol), indices: vec![] }
    }
}

/// The places of all inputs of a routine.
#[derive(Clone, Debug)]
pub(crate) struct Layout<'a> {
    pub(crate) coordinates: &'a Shape,
    pub(crate) parameters: Vec<&'a Shape>,
    /// The symbols in the array `Argument`, with their indices.
    pub(crate) argument: Vec<(Symbol, Vec<usize>)>,
}

impl Layout<'_> {
    /// Returns the place of a symbol.
    pub(crate) fn place(&self, symbol: Symbol) -> Place {
        if let Some((_, indices)) = self.argument.iter().find(|(other, _)| *other == symbol) {
            return Place { array: Array::Argument, indices: indices.clone() };
        }
        let coordinate = |array, i| Place { array, indices: coordinate(self.coordinates, i) };
        match symbol {
            Symbol::Position(i) => coordinate(Array::Position, i),
            Symbol::Momentum(i) => coordinate(Array::Momentum, i),
            Symbol::Velocity(i) => coordinate(Array::Velocity, i),
            Symbol::MomentumIncrement(i) => coordinate(Array::Kick, i),
            Symbol::Parameter(i) => self.parameter(i),
            _ => Place::number(symbol),
        }
    }

    /// Returns the place of a scalar of the parameters. Constants from outside of the function follow the parameters.
    fn parameter(&self, i: u32) -> Place {
        let mut rest = i as usize;
        for (number, shape) in self.parameters.iter().enumerate() {
            if rest < shape.len() {
                return Place { array: Array::Parameter(number), indices: shape.indices(rest) };
            }
            rest -= shape.len();
        }
        Place::number(Symbol::Parameter(i))
    }
}

impl<'a> Layout<'a> {
    /// Returns the places of the coordinates and parameters of a function.
    pub(crate) fn of(energy: &'a Energy) -> Layout<'a> {
        let parameters = energy.parameters().map(|argument| &argument.shape).collect();
        Layout { coordinates: &energy.coordinates.shape, parameters, argument: vec![] }
    }

    /// Returns the layout of functions over any scalar: all coordinates are one row, and so are all parameters.
    pub(crate) fn flat(coordinates: &'a Shape, parameters: &'a Shape) -> Layout<'a> {
        let degrees = coordinates.len() as u32;
        let point = (0..degrees).map(Symbol::Position).chain((0..degrees).map(Symbol::Momentum));
        let argument = point.enumerate().map(|(i, symbol)| (symbol, vec![i])).collect();
        Layout { coordinates, parameters: vec![parameters], argument }
    }

    /// Returns the shape of all parameters in a row.
    pub(crate) fn row_of_parameters(&self) -> Shape {
        Shape { extents: vec![self.parameters.iter().map(|shape| shape.len()).sum()], leaf: Leaf::Plain }
    }
}

/// Returns the indices of a coordinate in its array. A single coordinate is emitted as an array of length 1.
pub(crate) fn coordinate(shape: &Shape, i: u32) -> Vec<usize> {
    if shape.extents.is_empty() { vec![0] } else { shape.indices(i as usize) }
}
