//! From nodes to statements: when each value is computed, once, and in which order.
//!
//! Every symbol has a binding time, a level: parameters are known before h is, h before the state, the start of a step
//! before Newton's iterates. A node has the level of its latest symbol, and the routine of this level computes the node.
//! Later routines read the value from a slot.
//!
//! The passes run in this order. `lowering` turns the nodes of a routine into statements: sums without their common factors (`factors`),
//! operations in the order in which operands are ready (`arithmetic`), calls with several results (`joint`), and branches (`together`).
//! Equal operations are one statement. Values with uses in one branch only are computed in this branch. `passes` then arranges the statements as `loops` or `packs`.
//! The printer in `emit` decides nothing.

mod arithmetic;
mod block;
mod factors;
mod instruction;
mod joint;
mod kernel;
mod layout;
mod levels;
mod loops;
mod lowering;
mod packs;
mod passes;
mod routine;
mod scheduler;
mod together;

pub(crate) use block::{Block, LANES, Operations, Statement};
pub(crate) use instruction::{Instruction, Operand, Register};
pub(crate) use joint::{Call, JointFunction};
pub(crate) use kernel::{Kernel, Levels, cost};
#[cfg(test)]
pub(crate) use kernel::{Plan, plan, statements};
pub(crate) use layout::{Array, Layout, Place, coordinate};
pub(crate) use loops::{Computed, Loop, Run, Source};
#[cfg(test)]
pub(crate) use passes::arranged;
pub(crate) use routine::{Argument, Extent, Output, Routine, Space, phase};
pub(crate) use scheduler::Scheduler;
