//! Prints statements and instructions.

use super::writer::Writer;
use crate::ir::Relation;
use crate::schedule::{Block, Instruction, LANES, Operand, Statement};
use proc_macro2::Delimiter;

impl Writer<'_> {
    /// Prints a statement.
    pub(super) fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Loop(each) => return self.print_loop(each),
            Statement::Let(register, instruction) | Statement::Pack { register, instruction, .. } => {
                self.register(*register);
                self.punct("=");
                self.instruction(instruction);
            }
            Statement::Call(call) => self.joint_call(call),
            Statement::Gather(register, four) => {
                self.register(*register);
                self.punct("=");
                self.path("R", "four");
                self.grouped(Delimiter::Parenthesis, |writer| writer.list(four));
            }
            Statement::Spread(registers, four) => {
                self.grouped(Delimiter::Bracket, |writer| {
                    for lane in 0..LANES {
                        match registers.get(lane) {
                            Some(register) => writer.register(*register),
                            None => writer.word("_"),
                        }
                        writer.punct(",");
                    }
                });
                self.punct("=");
                self.register(*four);
                self.punct(".");
                self.literal(0);
            }
            Statement::If { registers, condition, first, second } => {
                self.grouped(Delimiter::Bracket, |writer| writer.registers(registers));
                self.punct("=");
                self.path("R", "choose");
                self.grouped(Delimiter::Parenthesis, |writer| {
                    writer.operand(condition);
                    writer.punct(",");
                    writer.branch(first);
                    writer.punct(",");
                    writer.branch(second);
                });
            }
            Statement::Write(place, value) => {
                self.place(place);
                self.punct("=");
                self.operand(value);
            }
        }
        self.punct(";");
    }

    /// Prints `|| { statements [results,] }`.
    fn branch(&mut self, block: &Block) {
        self.punct("||");
        self.grouped(Delimiter::Brace, |writer| {
            let declaration = writer.declaration(&[], &block.registers());
            writer.extend(declaration);
            block.statements.iter().for_each(|statement| writer.statement(statement));
            writer.list(&block.results);
        });
    }

    /// Prints an instruction.
    pub(super) fn instruction(&mut self, instruction: &Instruction) {
        match instruction {
            Instruction::Neg(a) => self.prefix("-", a),
            Instruction::Not(a) => self.prefix("!", a),
            Instruction::Add(a, b) => self.infix(a, "+", b),
            Instruction::Sub(a, b) => self.infix(a, "-", b),
            Instruction::Mul(a, b) => self.infix(a, "*", b),
            Instruction::Div(a, b) => self.infix(a, "/", b),
            Instruction::And(a, b) => self.infix(a, "&", b),
            Instruction::Or(a, b) => self.infix(a, "|", b),
            Instruction::Compare(Relation::Less, a, b) => self.method("less", a, &[*b]),
            Instruction::Compare(Relation::LessEqual, a, b) => self.method("less_equal", a, &[*b]),
            Instruction::Compare(Relation::Equal, a, b) => self.method("equal", a, &[*b]),
            Instruction::MulAdd(a, b, c) => self.method("multiply_add", a, &[*b, *c]),
            Instruction::Sqrt(a) => self.method("sqrt", a, &[]),
            Instruction::Call(function, args) => {
                let entry = function.entry();
                match &args[..] {
                    [x, rest @ ..] if entry.public => self.method(entry.name, x, rest),
                    _ => {
                        self.path("slope", entry.name);
                        self.grouped(Delimiter::Parenthesis, |writer| writer.separated(args));
                    }
                }
            }
        }
    }

    /// Prints a sign and an operand.
    fn prefix(&mut self, sign: &str, a: &Operand) {
        self.punct(sign);
        self.operand(a);
    }

    /// Prints a sign between two operands.
    fn infix(&mut self, a: &Operand, sign: &str, b: &Operand) {
        self.operand(a);
        self.punct(sign);
        self.operand(b);
    }

    /// Prints `x.name(args)`.
    pub(super) fn method(&mut self, name: &'static str, x: &Operand, args: &[Operand]) {
        self.operand(x);
        self.punct(".");
        self.word(name);
        self.grouped(Delimiter::Parenthesis, |writer| writer.separated(args));
    }
}
