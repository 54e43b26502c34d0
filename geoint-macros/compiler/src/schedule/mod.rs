//! From nodes to statements: when each value is computed, once, and in which order.
//!
//! Every symbol has a binding time, a level: parameters are known before h is, h before the state, the start of a step
//! before Newton's iterates. A node has the level of its latest symbol, and the routine of this level computes the node.
//! Later routines read the value from a slot.
//!
//! The passes run in this order. `lowering` turns the nodes of a routine into statements: sums without their common factors (`factors`),
//! operations in the order in which operands are ready (`arithmetic`), calls with several results (`routines`), and branches (`together`).
//! Equal operations are one statement. Values with uses in one branch only are computed in this branch. `passes` then arranges the statements as `loops` or `packs`.
//! The printer in `emit` decides nothing.

mod arithmetic;
mod block;
mod factors;
mod instruction;
mod kernel;
mod layout;
mod levels;
mod loops;
mod lowering;
mod packs;
mod passes;
mod routines;
mod together;

pub(crate) use block::{Block, LANES, Operations, Statement};
pub(crate) use instruction::{Instruction, Operand, Register};
#[cfg(test)]
pub(crate) use kernel::plan;
pub(crate) use kernel::{Kernel, Levels, Plan};
pub(crate) use layout::{Array, Layout, Place, coordinate};
pub(crate) use loops::{Computed, Loop, Run, Source};
pub(crate) use passes::arranged;
pub(crate) use routines::{Call, Routine};
