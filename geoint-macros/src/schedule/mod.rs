//! From nodes to statements: what is computed when, once, and in which order.
//!
//! Every symbol has a binding time, a level: parameters are known before h is, h before the state, the start of a step
//! before Newton's iterates. A node is computed at the level of the latest symbol that it reads, by the routine of that
//! level, and later routines read it from a slot. Within a routine equal operations are one statement, and what belongs
//! to one branch of an `if` is computed in that branch.

mod arithmetic;
mod block;
mod kernel;
mod levels;
mod lowering;

use crate::ir::{Graph, Id, Symbol};
pub(crate) use block::{Block, Instruction, Operand, Operations, Register, Statement};
pub(crate) use kernel::{Kernel, Levels, Plan};
use levels::KnownLevels;
use lowering::Lowering;

/// Plans the routines of a kernel: `stores` are the own roots of the storing routines, a level each, `last` the roots of
/// the routines of the last level.
pub(crate) fn plan(graph: &mut Graph, level: impl Fn(Symbol) -> usize, stores: &[&[Id]], last: &[&[Id]]) -> Plan {
    let mut levels = KnownLevels::new(level);
    let mut slots: Vec<Vec<Id>> = vec![vec![]; stores.len()];
    let last = last.iter().map(|roots| Lowering::run(graph, &mut levels, &mut slots, stores.len(), roots)).collect();
    let mut store_blocks = vec![];
    for (level, own) in stores.iter().enumerate().rev() {
        // Slots of this level are complete: only later levels ask for them.
        let roots = [own, &slots[level][..]].concat();
        store_blocks.push(Lowering::run(graph, &mut levels, &mut slots, level, &roots));
    }
    store_blocks.reverse();
    Plan { stores: store_blocks, last, slots: slots.iter().map(Vec::len).collect() }
}

/// One routine without earlier ones.
pub(crate) fn routine(graph: &mut Graph, roots: &[Id]) -> Block {
    plan(graph, |_| 0, &[], &[roots]).last.remove(0)
}
