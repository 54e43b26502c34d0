//! Kepler's motion: calls that do not need each other, together.

use super::block::{Instruction, Operand, Register, Statement};
use super::lowering::Lowering;
use crate::ir::{Function, Id, Node, Symbol};

impl<F: Fn(Symbol) -> usize> Lowering<'_, F> {
    /// Kepler's motion along all orbits that do not need each other, as one call.
    pub(super) fn kepler(&mut self, id: Id, args: &[Id]) -> Operand {
        let mut orbits: Vec<Vec<Id>> = vec![args.to_vec()];
        let always: Vec<Id> = self.scopes.last().map(|scope| scope.always.ids().collect()).unwrap_or_default();
        for other in always {
            if let Node::Call(Function::KeplerF, args) = self.graph.node(other)
                && self.known(other).is_none()
                && !orbits.contains(args)
            {
                let args = args.clone();
                let (reached, ends) = (self.graph.reachable(&args), self.kepler_calls(&orbits));
                let needs = |ids: &[Id], end: &[Id]| ids.iter().any(|id| end.contains(id));
                let before = self.graph.reachable(&orbits.concat());
                let own = self.kepler_calls(std::slice::from_ref(&args));
                if !needs(&reached, &ends) && !needs(&before, &own) {
                    orbits.push(args);
                }
            }
        }
        let operands: Vec<Vec<Operand>> =
            orbits.iter().map(|args| args.iter().map(|arg| self.operand(*arg)).collect()).collect();
        let ready = operands.iter().flatten().map(|x| self.ready(x)).max().unwrap_or(0) + Instruction::CALL_LATENCY;
        let registers: Vec<[Register; 4]> =
            orbits.iter().map(|_| std::array::from_fn(|_| self.register(ready))).collect();
        let results = self.kepler_calls(&orbits);
        let mut own = Operand::Register(registers[0][0]);
        if let Some(scope) = self.scopes.last_mut() {
            for (result, register) in results.iter().zip(registers.as_flattened()) {
                scope.values.insert(*result, Operand::Register(*register));
                if *result == id {
                    own = Operand::Register(*register);
                }
            }
            scope.block.statements.push(Statement::Kepler(registers, operands));
        }
        own
    }

    /// The four nodes of each orbit, in order.
    fn kepler_calls(&mut self, orbits: &[Vec<Id>]) -> Vec<Id> {
        let of = |args: &Vec<Id>| Function::KEPLER.map(|function| self.graph.call(function, args));
        orbits.iter().flat_map(of).collect()
    }
}
