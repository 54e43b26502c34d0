//! Statements: the work of a routine, in order.

use super::address::Successive;
use super::call::{Call, JointFunction};
use super::instruction::{Instruction, Operand, Register};
use super::layout::Place;
use super::operations::Operations;

/// The number of lanes of a pack. One operation computes all lanes.
pub(crate) const LANES: usize = 4;

/// One step of a routine.
#[derive(Clone, Debug)]
pub(crate) enum Statement {
    Let(Register, Instruction),
    /// Calls a routine of the runtime with several results.
    Call(Call),
    /// Computes one of two branches. Values without another use are computed inside of the branch.
    If {
        registers: Vec<Register>,
        condition: Operand,
        first: Block,
        second: Block,
    },
    /// Computes alike values, one for each member of a loop.
    Loop(Loop),
    /// Collects four numbers in one register.
    Gather(Register, [Operand; LANES]),
    /// One operation on packs. The statement replaces `members` alike statements.
    Pack {
        register: Register,
        instruction: Instruction,
        members: usize,
    },
    /// Reads the numbers of a pack, or its first ones.
    Spread(Vec<Register>, Register),
    /// Writes a value to an array of the caller.
    Write(Place, Operand),
}

/// A loop over alike statements.
#[derive(Clone, Debug)]
pub(crate) struct Loop {
    /// The number of the array.
    pub(crate) array: usize,
    pub(crate) length: usize,
    /// The operands of a member, and their registers in the body.
    pub(crate) reads: Vec<(Register, Successive)>,
    /// The statements of a member, in the registers of the first member.
    pub(crate) body: Vec<Statement>,
    /// The registers of an entry in the body.
    pub(crate) results: Vec<Register>,
    /// The registers of each entry in statements after the loop.
    pub(crate) members: Vec<Vec<Register>>,
    /// The entries of an array of the caller, if the loop has no array of its own.
    pub(crate) target: Option<Successive>,
}

/// Statements and their results.
#[derive(Clone, Debug, Default)]
pub(crate) struct Block {
    pub(crate) statements: Vec<Statement>,
    pub(crate) results: Vec<Operand>,
}

impl Statement {
    /// Visits the registers of the statement. Branches and loops declare their own registers.
    pub(super) fn for_each_register(&self, visit: &mut dyn FnMut(Register)) {
        match self {
            Statement::Let(register, _) | Statement::Gather(register, _) | Statement::Pack { register, .. } => {
                visit(*register);
            }
            Statement::Call(call) => call.results.iter().flatten().copied().for_each(visit),
            Statement::Spread(registers, _) | Statement::If { registers, .. } => {
                registers.iter().copied().for_each(visit);
            }
            Statement::Loop(_) | Statement::Write(..) => {}
        }
    }

    /// Returns the registers of the statement.
    pub(super) fn registers(&self) -> Vec<Register> {
        let mut registers = vec![];
        self.for_each_register(&mut |register| registers.push(register));
        registers
    }

    /// Visits all operands, including the operands of branches and loops.
    pub(super) fn for_each_operand(&self, visit: &mut dyn FnMut(&Operand)) {
        match self {
            Statement::Let(_, instruction) | Statement::Pack { instruction, .. } => instruction.for_each_operand(visit),
            Statement::Call(call) => call.arguments.iter().flatten().for_each(visit),
            Statement::Gather(_, four) => four.iter().for_each(visit),
            Statement::Spread(_, register) => visit(&Operand::Register(*register)),
            Statement::If { condition, first, second, .. } => {
                visit(condition);
                for branch in [first, second] {
                    branch.statements.iter().for_each(|statement| statement.for_each_operand(visit));
                    branch.results.iter().for_each(&mut *visit);
                }
            }
            Statement::Loop(all) => all.body.iter().for_each(|statement| statement.for_each_operand(visit)),
            Statement::Write(_, value) => visit(value),
        }
    }

    /// Returns the operations of the statement. Of two branches, the more expensive branch counts.
    fn operations(&self) -> Operations {
        match self {
            Statement::Let(_, instruction) => instruction.operations(),
            Statement::Call(call) => call.operations(),
            Statement::If { first, second, .. } => {
                let (first, second) = (first.operations(), second.operations());
                if first.total() < second.total() { second } else { first }
            }
            Statement::Loop(all) => all.length * sum(&all.body),
            Statement::Pack { instruction, members, .. } => *members * instruction.operations(),
            Statement::Gather(..) | Statement::Spread(..) | Statement::Write(..) => Operations::default(),
        }
    }
}

/// Returns the operations of all statements.
fn sum(statements: &[Statement]) -> Operations {
    statements.iter().map(Statement::operations).fold(Operations::default(), |a, b| a + b)
}

impl Block {
    /// Returns the registers of all statements.
    pub(crate) fn registers(&self) -> Vec<Register> {
        let mut registers = Vec::with_capacity(self.statements.len());
        for statement in &self.statements {
            statement.for_each_register(&mut |register| registers.push(register));
        }
        registers
    }

    /// Returns the first register that neither the block nor its branches use.
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

    /// Returns the registers of matrices.
    pub(crate) fn matrices(&self) -> Vec<Register> {
        let of = |statement: &Statement| match statement {
            Statement::Call(Call { function: JointFunction::FlowMatrix { .. }, results, .. }) => results.concat(),
            _ => vec![],
        };
        self.statements.iter().flat_map(of).collect()
    }

    /// Returns the operations of all statements. Loops and packs do not change this number.
    pub(crate) fn operations(&self) -> Operations {
        sum(&self.statements)
    }
}
