//! The graph of an energy: operations, interned nodes, what they read, their formula. Knows no syntax and no emission.

mod call;
pub(crate) mod graph;
pub(crate) mod collect;
pub(crate) mod hash;
mod id;
mod known;
mod line;
mod node;
pub(crate) mod number;
mod of_steps;
pub(crate) mod op;
pub(crate) mod print;
mod product;
mod reads;
mod sign;
pub(crate) mod substitute;
mod sum;
mod table;

pub(crate) use graph::{Graph, Partial};
pub(crate) use hash::HashMap;
pub(crate) use id::Id;
pub(crate) use known::Known;
pub(crate) use line::Lines;
pub(crate) use node::Node;
pub(crate) use number::Ratio;
pub(crate) use number::{Number, factors_of_radicand};
pub(crate) use of_steps::of_steps;
pub(crate) use op::{Function, Relation, Symbol};
pub(crate) use reads::Reads;
pub(crate) use sign::Sign;
pub(crate) use table::Table;
