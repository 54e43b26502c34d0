//! Linear flows: a matrix that is computed once, and what it adds to a vector.

use super::block::{Instruction, Operand, Register, Statement};
use super::levels::whole;
use super::lowering::Lowering;
use crate::ir::{Function, Id, Symbol};

impl<F: Fn(Symbol) -> usize> Lowering<'_, F> {
    /// exp(A) − 1 of a matrix, by its size and its entries with their places.
    pub(super) fn flow_matrix(&mut self, args: &[Id]) -> Operand {
        let (size, entries) = (whole(self.graph, args[0]), &args[1..]);
        let entries: Vec<(usize, Operand)> =
            entries.chunks_exact(2).map(|entry| (whole(self.graph, entry[0]), self.operand(entry[1]))).collect();
        let ready = entries.iter().map(|(_, entry)| self.ready(entry)).max().unwrap_or(0) + Instruction::CALL_LATENCY;
        let register = self.register(ready);
        if let Some(scope) = self.scopes.last_mut() {
            scope.block.statements.push(Statement::FlowMatrix(register, size, entries));
        }
        Operand::Register(register)
    }

    /// All rows of such a matrix times a vector, as one call.
    pub(super) fn flow_change(&mut self, args: &[Id]) -> Operand {
        let (row, of) = (whole(self.graph, args[0]), args[1..].to_vec());
        let matrix = self.operand(of[0]);
        let x: Vec<Operand> = of[1..].iter().map(|x| self.operand(*x)).collect();
        let ready = x.iter().map(|x| self.ready(x)).max().unwrap_or(0) + Instruction::CALL_LATENCY;
        let registers: Vec<Register> = x.iter().map(|_| self.register(ready)).collect();
        for (row, register) in registers.iter().enumerate() {
            let row = self.graph.integer(row as i128);
            let result = self.graph.call(Function::FlowChange, &[&[row], &of[..]].concat());
            if let Some(scope) = self.scopes.last_mut() {
                scope.values.insert(result, Operand::Register(*register));
            }
        }
        let own = Operand::Register(registers[row]);
        if let Some(scope) = self.scopes.last_mut() {
            scope.block.statements.push(Statement::FlowChange(registers, matrix, x));
        }
        own
    }
}
