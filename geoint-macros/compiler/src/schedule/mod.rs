//! From nodes to statements. Each value is computed once: here it is decided at which level, in which branch and in which order.
//!
//! A routine is a function of the emitted code, given by the nodes of its outputs (`routine`). A kernel is a list of routines that share prepared numbers
//! (`kernel`; its `cost` lets `split` compare partitions of an energy, by the counts in `operations`). `Scheduler` holds the graph and the places of symbols in
//! arrays (`scheduler`, `layout`, `space`).
//!
//! Every symbol has a level, the moment at which it is known (`levels`): parameters before h, h before the state, the start of a step before
//! Newton's iterates. A node has the level of its latest symbol. The routine of this level computes the node. If a later level reads it, it is stored in a slot, an
//! entry of an array.
//!
//! 1. `lowering` turns nodes into statements (`block`, `instruction`, `call`). Equal operations are one statement. Values that only one branch uses are computed in this
//!    branch. Helpers of this step: `factors` takes common factors out of sums; `arithmetic` orders the operands of sums and products by the moment at which they are
//!    ready; `joint` computes several results by one call, such as sine and cosine; `together` merges selections by one condition into one branch.
//! 2. `passes` arranges the statements: repeated statements become `loops` over successive entries of arrays (`address`), and four alike operations become
//!    `packs`, which the processor computes as one vector.
//!
//! `factors` and `arithmetic` decide how results are rounded. Later passes keep every operation and its operands, so no bit of a result changes. The output is the
//! same in every build, and the printer in `emit` decides nothing.

mod address;
mod arithmetic;
mod block;
mod call;
mod factors;
mod instruction;
mod joint;
mod kernel;
mod layout;
mod levels;
mod loops;
mod lowering;
mod operations;
mod packs;
mod passes;
mod routine;
mod scheduler;
mod space;
mod together;

pub(crate) use address::{Computed, Source, Successive};
pub(crate) use block::{Block, LANES, Loop, Statement};
pub(crate) use call::{Call, JointFunction};
pub(crate) use instruction::{Instruction, Operand, Register};
pub(crate) use kernel::{Kernel, Levels, cost};
#[cfg(test)]
pub(crate) use kernel::{Plan, plan};
pub(crate) use layout::{Array, Layout, Place, coordinate};
#[cfg(test)]
pub(crate) use lowering::statements;
pub(crate) use operations::Operations;
#[cfg(test)]
pub(crate) use passes::arranged;
pub(crate) use routine::{Extent, Output, Routine};
pub(crate) use scheduler::Scheduler;
pub(crate) use space::{Argument, Space, phase};
