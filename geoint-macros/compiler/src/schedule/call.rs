//! Calls of functions of the runtime that have several results.

use super::instruction::{Operand, Register};
use super::operations::Operations;
use crate::ir::Function;

/// A function with several results.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum JointFunction {
    /// Sine and cosine of one argument.
    SinCos,
    /// Kepler's motion. One call serves several orbits: each has five arguments, and the results of `Function::KEPLER`.
    Kepler,
    /// exp(A) − 1, as an array of columns. The arguments are the nonzero entries of A. Places count all entries, column by column.
    FlowMatrix { size: usize, places: Vec<usize> },
    /// The product of a matrix and a vector. The matrix is the first argument: a register, or its first slot.
    FlowChange,
}

/// A call of such a function for one or more problems. Each problem has a list of arguments and a list of results.
#[derive(Clone, Debug)]
pub(crate) struct Call {
    pub(crate) function: JointFunction,
    pub(crate) results: Vec<Vec<Register>>,
    pub(crate) arguments: Vec<Vec<Operand>>,
}

impl JointFunction {
    /// Returns the number of results of one problem.
    pub(super) fn results(&self, arguments: &[Operand]) -> usize {
        match self {
            JointFunction::SinCos => 2,
            JointFunction::Kepler => Function::KEPLER.len(),
            JointFunction::FlowMatrix { .. } => 1,
            JointFunction::FlowChange => arguments.len() - 1,
        }
    }

    /// Returns the operations of one problem.
    fn operations(&self, arguments: &[Operand]) -> Operations {
        match self {
            JointFunction::SinCos | JointFunction::Kepler => Operations::calls(self.results(arguments)),
            // A series of some 16 terms, and some squarings.
            JointFunction::FlowMatrix { size, .. } => {
                Operations::arithmetic(16 * size * (arguments.len() + size * size))
            }
            JointFunction::FlowChange => Operations::arithmetic(2 * self.results(arguments).pow(2)),
        }
    }
}

impl Call {
    /// Returns the operations of all problems.
    pub(super) fn operations(&self) -> Operations {
        let all = self.arguments.iter().map(|arguments| self.function.operations(arguments));
        all.fold(Operations::default(), |a, b| a + b)
    }
}
