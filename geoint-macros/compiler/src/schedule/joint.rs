//! Functions of the runtime with several results. The results share work, so one statement computes them.

use super::block::Statement;
use super::call::{Call, JointFunction};
use super::instruction::{Instruction, Operand, Register};
use super::levels::whole;
use super::lowering::Lowering;
use crate::ir::{Function, Id, Node, Symbol};

impl<F: Fn(Symbol) -> usize> Lowering<'_, F> {
    /// Adds a call. Returns the results of each problem.
    fn call_joint(&mut self, function: JointFunction, arguments: Vec<Vec<Operand>>) -> Vec<Vec<Register>> {
        let ready = arguments.iter().flatten().map(|x| self.ready(x)).max().unwrap_or(0) + Instruction::CALL_LATENCY;
        let mut results: Vec<Vec<Register>> = vec![];
        for one in &arguments {
            results.push((0..function.results(one)).map(|_| self.register(ready)).collect());
        }
        self.push(Statement::Call(Call { function, results: results.clone(), arguments }));
        results
    }

    /// Lowers a sine and its cosine, and returns both.
    pub(super) fn sin_cos(&mut self, x: Operand) -> [Operand; 2] {
        let results = self.call_joint(JointFunction::SinCos, vec![vec![x]]);
        [0, 1].map(|k| Operand::Register(results[0][k]))
    }

    /// Lowers exp(A) − 1 of a matrix. The arguments of the node are the size, then the place and the value of each entry.
    pub(super) fn flow_matrix(&mut self, args: &[Id]) -> Operand {
        let (mut places, mut entries) = (vec![], vec![]);
        for entry in args[1..].chunks_exact(2) {
            places.push(whole(self.graph, entry[0]));
            entries.push(self.operand(entry[1]));
        }
        let function = JointFunction::FlowMatrix { size: whole(self.graph, args[0]), places };
        Operand::Register(self.call_joint(function, vec![entries])[0][0])
    }

    /// Lowers all rows of the product of a matrix and a vector as one call. The arguments of the node are the row, the matrix, and the vector.
    pub(super) fn flow_change(&mut self, id: Id, args: &[Id]) -> Operand {
        let arguments = args[1..].iter().map(|arg| self.operand(*arg)).collect();
        let results = self.call_joint(JointFunction::FlowChange, vec![arguments]).concat();
        let mut rows = vec![];
        for row in 0..results.len() {
            let row = self.graph.integer(row as i128);
            rows.push(self.graph.call(Function::FlowChange, &[&[row], &args[1..]].concat()));
        }
        self.set_all(id, &rows, &results)
    }

    /// Lowers Kepler's motion along all independent orbits as one call.
    pub(super) fn kepler(&mut self, id: Id, args: &[Id]) -> Operand {
        let mut orbits = vec![args.to_vec()];
        for other in self.unconditional() {
            let Node::Call(Function::KeplerF, args) = self.graph.node(other) else { continue };
            if self.known(other).is_some() || orbits.contains(args) {
                continue;
            }
            let args = args.clone();
            let (known, own) = (self.kepler_calls(&orbits), self.kepler_calls(std::slice::from_ref(&args)));
            if self.are_independent(&known, &own) {
                orbits.push(args);
            }
        }
        let arguments = orbits.iter().map(|args| args.iter().map(|arg| self.operand(*arg)).collect()).collect();
        let results = self.call_joint(JointFunction::Kepler, arguments).concat();
        let nodes = self.kepler_calls(&orbits);
        self.set_all(id, &nodes, &results)
    }

    /// Returns the nodes of all results of some orbits.
    fn kepler_calls(&mut self, orbits: &[Vec<Id>]) -> Vec<Id> {
        let of = |args: &Vec<Id>| Function::KEPLER.map(|function| self.graph.call(function, args));
        orbits.iter().flat_map(of).collect()
    }
}
