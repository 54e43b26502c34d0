//! From nodes to statements: what is computed when, once, and in which order.
//!
//! Every symbol has a binding time, a level: parameters are known before h is, h before the state, the start of a step
//! before Newton's iterates. A node is computed at the level of the latest symbol that it reads, by the routine of that
//! level, and later routines read it from a slot. Within a routine equal operations are one statement, and what belongs
//! to one branch of an `if` is computed in that branch. Alike statements become loops (`families`), or four go side by side (`lanes`).

mod arithmetic;
mod block;
mod factors;
mod families;
mod kepler;
mod matrix;
mod kernel;
mod lanes;
mod levels;
mod lowering;
mod routine;

pub(crate) use block::{Block, Instruction, LANES, Operand, Operations, Register, Statement};
pub(crate) use families::{Families, Family, Indices, Item, Run, Source, families};
pub(crate) use kernel::{Kernel, Levels};
#[cfg(test)]
pub(crate) use kernel::{Plan, plan, statements};
pub(crate) use lanes::side_by_side;
pub(crate) use routine::{Argument, Extent, Output, Routine, Space, phase};
