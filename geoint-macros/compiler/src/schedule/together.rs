//! Lowers nodes with common work: partners among functions, and selections by one condition.

use super::block::Statement;
use super::instruction::{Instruction, Operand, Register};
use super::lowering::Lowering;
use crate::ir::{Function, Id, Node, Symbol};

impl<F: Fn(Symbol) -> usize> Lowering<'_, F> {
    /// Lowers a function together with its partner, if the partner is needed too. Partners share work: sine and cosine are one call, a mean
    /// and its derivative have the same branches.
    pub(super) fn call(&mut self, function: Function, args: &[Id]) -> Operand {
        let values: Vec<Operand> = args.iter().map(|arg| self.operand(*arg)).collect();
        let partner = function.partner().map(|partner| (partner, self.graph.call(partner, args)));
        let wanted =
            |id: Id| self.scopes.last().is_some_and(|scope| scope.always.contains(id)) && self.known(id).is_none();
        let Some((partner, id)) = partner.filter(|(_, id)| wanted(*id)) else {
            return self.emit(Instruction::Call(function, values));
        };
        let (own, other) = match function {
            Function::Sin | Function::Cos => {
                let [sin, cos] = self.sin_cos(values[0]);
                if function == Function::Sin { (sin, cos) } else { (cos, sin) }
            }
            _ => {
                let own = self.emit(Instruction::Call(function, values.clone()));
                (own, self.emit(Instruction::Call(partner, values)))
            }
        };
        if let Some(scope) = self.scopes.last_mut() {
            scope.values.insert(id, other);
        }
        own
    }

    /// Lowers all independent selections by one condition as one `if`.
    pub(super) fn select(&mut self, id: Id, condition: Id) -> Operand {
        let mut group = vec![id];
        for other in self.unconditional() {
            let is_candidate = matches!(self.graph.node(other), Node::Select(c, _, _) if *c == condition)
                && other != id
                && self.known(other).is_none();
            if is_candidate && self.are_independent(&group, &[other]) {
                group.push(other);
            }
        }
        let condition = self.operand(condition);
        let (mut first, mut second) = (vec![], vec![]);
        for member in &group {
            if let Node::Select(_, a, b) = self.graph.node(*member) {
                first.push(*a);
                second.push(*b);
            }
        }
        let (first, second) = (self.block(&first), self.block(&second));
        let ready = first.results.iter().chain(&second.results).map(|x| self.ready(x)).max().unwrap_or(0);
        let registers: Vec<Register> = group.iter().map(|_| self.register(ready)).collect();
        let own = self.set_all(id, &group, &registers);
        self.push(Statement::If { registers, condition, first, second });
        own
    }

    /// Returns the unconditional nodes of the innermost scope.
    pub(super) fn unconditional(&self) -> Vec<Id> {
        self.scopes.last().map(|scope| scope.always.ids().collect()).unwrap_or_default()
    }

    /// Returns whether no node of one list needs a node of the other list.
    pub(super) fn are_independent(&self, some: &[Id], others: &[Id]) -> bool {
        let needs = |ids: &[Id], ends: &[Id]| self.graph.reachable(ids).iter().any(|id| ends.contains(id));
        !needs(some, others) && !needs(others, some)
    }

    /// Sets the values of some nodes. Returns the value of the node `id` of the list.
    pub(super) fn set_all(&mut self, id: Id, nodes: &[Id], registers: &[Register]) -> Operand {
        if let Some(scope) = self.scopes.last_mut() {
            for (node, register) in nodes.iter().zip(registers) {
                scope.values.insert(*node, Operand::Register(*register));
            }
        }
        Operand::Register(registers[nodes.iter().position(|node| *node == id).unwrap_or(0)])
    }
}
