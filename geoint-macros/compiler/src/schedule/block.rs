//! Statements: what a routine does, in order.

use crate::ir::{Function, Number, Relation, Symbol};

/// So many numbers go through one operation where they are side by side.
pub(crate) const LANES: usize = 4;

/// A value of a routine that is computed once.
pub(crate) type Register = usize;

/// What an instruction reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Operand {
    Constant(Number),
    Truth(bool),
    /// Something that the routine is given.
    Input(Symbol),
    /// A value stored by the routine of an earlier level.
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

/// One step of a routine.
#[derive(Clone, Debug)]
pub(crate) enum Statement {
    Let(Register, Instruction),
    /// Sine and cosine of one argument.
    SinCos(Register, Register, Operand),
    /// Kepler's motion along some orbits, each by its five numbers: four results each.
    Kepler(Vec<[Register; 4]>, Vec<Vec<Operand>>),
    /// exp(A) − 1, as an array of columns, by the size of A and its entries that are not zero with their places, column by column.
    FlowMatrix(Register, usize, Vec<(usize, Operand)>),
    /// Such a matrix times a vector; it is a register, or slots from this one on.
    FlowChange(Vec<Register>, Operand, Vec<Operand>),
    /// Four numbers side by side.
    Gather(Register, [Operand; LANES]),
    /// Each of four numbers that are side by side, or the first ones.
    Spread(Vec<Register>, Register),
    /// Values that depend on a condition; each branch computes what only it needs.
    If {
        registers: Vec<Register>,
        condition: Operand,
        first: Block,
        second: Block,
    },
}

/// Statements and what comes of them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Block {
    pub(crate) statements: Vec<Statement>,
    pub(crate) results: Vec<Operand>,
}

/// How much a block does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Operations {
    /// Sums, differences, products.
    pub(crate) arithmetic: usize,
    /// Divisions and square roots.
    pub(crate) divisions: usize,
    /// Functions; a sine with its cosine is one.
    pub(crate) calls: usize,
}

impl Operations {
    /// Every operation as one, a·b + c as two, a sine with its cosine as two.
    pub(crate) fn total(self) -> usize {
        self.arithmetic + self.divisions + self.calls
    }

    /// Roughly how long they take, in units of one sum.
    pub(crate) fn weight(self) -> usize {
        self.arithmetic + 4 * self.divisions + 20 * self.calls
    }
}

impl std::ops::Add for Operations {
    type Output = Operations;
    fn add(self, other: Operations) -> Operations {
        Operations {
            arithmetic: self.arithmetic + other.arithmetic,
            divisions: self.divisions + other.divisions,
            calls: self.calls + other.calls,
        }
    }
}

/// What an instruction reads, in order, to be looked at or written: a copy to look at would cost more than the look.
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
    /// How long a function takes, in units of one sum.
    pub(crate) const CALL_LATENCY: u32 = 10;

    /// Calls a function for all that it reads, in order.
    pub(crate) fn for_each_operand(&self, visit: &mut dyn FnMut(&Operand)) {
        each_operand!(self, visit);
    }

    /// The same, to be written.
    fn for_each_operand_mut(&mut self, visit: &mut dyn FnMut(&mut Operand)) {
        each_operand!(self, visit);
    }

    /// What it reads.
    pub(crate) fn operands(&self) -> Vec<Operand> {
        let mut operands = Vec::with_capacity(3);
        self.for_each_operand(&mut |operand| operands.push(*operand));
        operands
    }

    /// Reads something else, in the same order.
    pub(super) fn replace(&mut self, operands: &[Operand]) {
        let mut new = operands.iter();
        self.for_each_operand_mut(&mut |old| *old = new.next().copied().unwrap_or(*old));
    }

    /// What it does, to nothing.
    pub(super) fn blank(&self) -> Instruction {
        let mut blank = self.clone();
        blank.for_each_operand_mut(&mut |operand| *operand = Operand::Truth(false));
        blank
    }

    /// Whether it is a sum, a difference, a product, a quotient, a root, or a change of sign.
    pub(super) fn is_arithmetic(&self) -> bool {
        use Instruction::{Add, Div, Mul, MulAdd, Neg, Sqrt, Sub};
        matches!(self, Neg(_) | Add(..) | Sub(..) | Mul(..) | Div(..) | MulAdd(..) | Sqrt(_))
    }

    /// How many of its first operands may change places.
    pub(super) fn commuting(&self) -> usize {
        match self {
            Instruction::Add(..) | Instruction::Mul(..) | Instruction::MulAdd(..) => 2,
            _ => 0,
        }
    }

    /// When the value is there, in units of one sum: after the last of its operands. Rounded figures that processors of
    /// the last ten years have in common; only the order of sums depends on them.
    pub(crate) fn ready(&self, operand: impl Fn(&Operand) -> u32) -> u32 {
        match self {
            Instruction::Neg(a) | Instruction::Not(a) => operand(a),
            Instruction::Compare(_, a, b) | Instruction::And(a, b) | Instruction::Or(a, b) => {
                operand(a).max(operand(b))
            }
            Instruction::Add(a, b) | Instruction::Sub(a, b) | Instruction::Mul(a, b) => 1 + operand(a).max(operand(b)),
            Instruction::MulAdd(a, b, c) => 1 + operand(a).max(operand(b)).max(operand(c)),
            Instruction::Div(a, b) => 4 + operand(a).max(operand(b)),
            Instruction::Sqrt(a) => 4 + operand(a),
            Instruction::Call(_, args) => Self::CALL_LATENCY + args.iter().map(operand).max().unwrap_or(0),
        }
    }
}

impl Statement {
    /// Calls a function for the values that it computes, but for those that only a branch needs.
    pub(super) fn for_each_register(&self, visit: &mut dyn FnMut(Register)) {
        match self {
            Statement::Let(register, _) | Statement::FlowMatrix(register, ..) | Statement::Gather(register, _) => {
                visit(*register);
            }
            Statement::SinCos(sin, cos, _) => {
                visit(*sin);
                visit(*cos);
            }
            Statement::Kepler(registers, _) => registers.as_flattened().iter().copied().for_each(visit),
            Statement::FlowChange(registers, ..)
            | Statement::Spread(registers, _)
            | Statement::If { registers, .. } => registers.iter().copied().for_each(visit),
        }
    }

    /// Those values.
    pub(crate) fn registers(&self) -> Vec<Register> {
        let mut registers = vec![];
        self.for_each_register(&mut |register| registers.push(register));
        registers
    }

    /// Calls a function for all that it reads, in branches too.
    pub(super) fn for_each_operand(&self, visit: &mut dyn FnMut(&Operand)) {
        match self {
            Statement::Let(_, instruction) => instruction.for_each_operand(visit),
            Statement::SinCos(_, _, x) => visit(x),
            Statement::Kepler(_, orbits) => orbits.iter().flatten().for_each(visit),
            Statement::FlowMatrix(_, _, entries) => entries.iter().for_each(|(_, entry)| visit(entry)),
            Statement::FlowChange(_, matrix, x) => {
                visit(matrix);
                x.iter().for_each(visit);
            }
            Statement::Gather(_, four) => four.iter().for_each(visit),
            Statement::Spread(_, register) => visit(&Operand::Register(*register)),
            Statement::If { condition, first, second, .. } => {
                visit(condition);
                for branch in [first, second] {
                    branch.statements.iter().for_each(|statement| statement.for_each_operand(visit));
                    branch.results.iter().for_each(&mut *visit);
                }
            }
        }
    }
}

impl Block {
    /// The values that its statements compute, without those that only a branch needs.
    pub(crate) fn registers(&self) -> Vec<Register> {
        let mut registers = Vec::with_capacity(self.statements.len());
        for statement in &self.statements {
            statement.for_each_register(&mut |register| registers.push(register));
        }
        registers
    }

    /// The first register after all that it writes and reads, in branches too.
    pub(super) fn unused(&self) -> Register {
        let mut next = 0;
        let mut write = |register: Register| {
            if register >= next {
                next = register + 1;
            }
        };
        let mut read = |operand: &Operand| {
            if let Operand::Register(register) = operand {
                write(*register);
            }
        };
        for statement in &self.statements {
            statement.for_each_operand(&mut read);
        }
        self.results.iter().for_each(&mut read);
        for statement in &self.statements {
            statement.for_each_register(&mut write);
        }
        next
    }

    /// Registers that hold a matrix.
    pub(crate) fn matrices(&self) -> Vec<Register> {
        let of = |statement: &Statement| match statement {
            Statement::FlowMatrix(register, ..) => Some(*register),
            _ => None,
        };
        self.statements.iter().filter_map(of).collect()
    }

    /// What the block costs; of two branches the dearer one.
    pub(crate) fn operations(&self) -> Operations {
        let one = |arithmetic, divisions, calls| Operations { arithmetic, divisions, calls };
        let cost = |statement: &Statement| match statement {
            Statement::Let(_, instruction) => match instruction {
                Instruction::Add(..) | Instruction::Sub(..) | Instruction::Mul(..) | Instruction::Neg(_) => {
                    one(1, 0, 0)
                }
                Instruction::MulAdd(..) => one(2, 0, 0),
                Instruction::Div(..) | Instruction::Sqrt(_) => one(0, 1, 0),
                Instruction::Call(..) => one(0, 0, 1),
                Instruction::Compare(..) | Instruction::And(..) | Instruction::Or(..) | Instruction::Not(_) => {
                    one(0, 0, 0)
                }
            },
            // Blocks are counted before numbers are put side by side.
            Statement::Gather(..) | Statement::Spread(..) => one(0, 0, 0),
            Statement::SinCos(..) => one(0, 0, 2),
            Statement::Kepler(registers, _) => one(0, 0, 4 * registers.len()),
            // A series of some 16 terms, some doublings.
            Statement::FlowMatrix(_, size, entries) => one(16 * size * (entries.len() + size * size), 0, 0),
            Statement::FlowChange(registers, ..) => one(2 * registers.len().pow(2), 0, 0),
            Statement::If { first, second, .. } => {
                let (first, second) = (first.operations(), second.operations());
                if first.total() < second.total() { second } else { first }
            }
        };
        self.statements.iter().map(cost).fold(Operations::default(), |a, b| a + b)
    }
}
