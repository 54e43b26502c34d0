//! Operations of a routine and their operands.

use super::operations::Operations;
use crate::ir::{Function, Number, Relation, Symbol};

/// A computed value of a routine.
pub(crate) type Register = usize;

/// A value for an instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Operand {
    Constant(Number),
    Truth(bool),
    /// A variable of the routine, or an entry of one of its arrays.
    Input(Symbol),
    /// A stored value of an earlier level: the level, and the index.
    Slot(usize, usize),
    Register(Register),
}

/// One operation.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Instruction {
    Neg(Operand),
    Add(Operand, Operand),
    Sub(Operand, Operand),
    Mul(Operand, Operand),
    Div(Operand, Operand),
    /// a·b + c.
    MulAdd(Operand, Operand, Operand),
    Sqrt(Operand),
    Call(Function, Vec<Operand>),
    Compare(Relation, Operand, Operand),
    And(Operand, Operand),
    Or(Operand, Operand),
    Not(Operand),
}

/// Visits the operands of an instruction in order, by shared or mutable reference. In an unoptimised build, a copy of the
/// instruction would cost more than the visit.
macro_rules! each_operand {
    ($instruction:expr, $visit:expr) => {
        match $instruction {
            Instruction::Neg(a) | Instruction::Not(a) | Instruction::Sqrt(a) => $visit(a),
            Instruction::Compare(_, a, b)
            | Instruction::And(a, b)
            | Instruction::Or(a, b)
            | Instruction::Add(a, b)
            | Instruction::Sub(a, b)
            | Instruction::Mul(a, b)
            | Instruction::Div(a, b) => {
                $visit(a);
                $visit(b);
            }
            Instruction::MulAdd(a, b, c) => {
                $visit(a);
                $visit(b);
                $visit(c);
            }
            Instruction::Call(_, args) => {
                for arg in args {
                    $visit(arg);
                }
            }
        }
    };
}

impl Instruction {
    /// Latency of a function call, in units of one sum.
    pub(super) const CALL_LATENCY: u32 = 10;

    /// Visits all operands in order.
    pub(super) fn for_each_operand(&self, visit: &mut dyn FnMut(&Operand)) {
        each_operand!(self, visit);
    }

    /// Visits all operands in order. The visitor may replace operands.
    fn for_each_operand_mut(&mut self, visit: &mut dyn FnMut(&mut Operand)) {
        each_operand!(self, visit);
    }

    /// Returns all operands in order.
    pub(crate) fn operands(&self) -> Vec<Operand> {
        let mut operands = Vec::with_capacity(3);
        self.for_each_operand(&mut |operand| operands.push(*operand));
        operands
    }

    /// Replaces the operands, in order.
    pub(super) fn replace(&mut self, operands: &[Operand]) {
        let mut new = operands.iter();
        self.for_each_operand_mut(&mut |old| *old = new.next().copied().unwrap_or(*old));
    }

    /// Returns the operation without its operands: equal for all instructions of one kind.
    pub(super) fn blank(&self) -> Instruction {
        let mut blank = self.clone();
        blank.for_each_operand_mut(&mut |operand| *operand = Operand::Truth(false));
        blank
    }

    /// Returns whether the operation is a sum, a difference, a product, a quotient, a root, or a change of sign.
    pub(super) fn is_arithmetic(&self) -> bool {
        use Instruction::{Add, Div, Mul, MulAdd, Neg, Sqrt, Sub};
        matches!(self, Neg(_) | Add(..) | Sub(..) | Mul(..) | Div(..) | MulAdd(..) | Sqrt(_))
    }

    /// Returns whether the value is a condition.
    pub(super) fn is_condition(&self) -> bool {
        use Instruction::{And, Compare, Not, Or};
        matches!(self, Compare(..) | And(..) | Or(..) | Not(_))
    }

    /// Returns the number of leading operands that may be exchanged.
    pub(super) fn commuting(&self) -> usize {
        match self {
            Instruction::Add(..) | Instruction::Mul(..) | Instruction::MulAdd(..) => 2,
            _ => 0,
        }
    }

    /// Returns the time at which the value is computed, in units of one sum, from the times of its operands. The latencies are rounded figures
    /// of processors of the last ten years. Only the order of sums depends on the latencies.
    pub(super) fn ready(&self, operand: impl Fn(&Operand) -> u32) -> u32 {
        let mut last = 0;
        self.for_each_operand(&mut |x| last = operand(x).max(last));
        let latency = match self {
            Instruction::Neg(_) => 0,
            Instruction::Div(..) | Instruction::Sqrt(_) => 4,
            Instruction::Call(..) => Self::CALL_LATENCY,
            _ if self.is_condition() => 0,
            _ => 1,
        };
        last + latency
    }

    /// Returns the cost of the instruction. Conditions are free.
    pub(super) fn operations(&self) -> Operations {
        match self {
            Instruction::MulAdd(..) => Operations::arithmetic(2),
            Instruction::Div(..) | Instruction::Sqrt(_) => Operations { divisions: 1, ..Operations::default() },
            Instruction::Call(..) => Operations::calls(1),
            _ if self.is_condition() => Operations::default(),
            _ => Operations::arithmetic(1),
        }
    }
}
