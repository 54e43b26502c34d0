//! The expression graph: operations, interned nodes, the symbols that a node reads, and printed formulas. It knows neither syntax nor emission.

mod affine;
mod call;
pub(crate) mod formula;
pub(crate) mod graph;
pub(crate) mod collect;
pub(crate) mod hash;
mod hash_index;
mod id;
mod node;
pub(crate) mod number;
pub(crate) mod op;
pub(crate) mod print;
mod product;
mod reads;
mod sign;
pub(crate) mod substitute;
mod sum;
mod symbol;
mod table;

pub(crate) use affine::AffineForms;
pub(crate) use graph::{Graph, UndefinedAt};
pub(crate) use hash::HashMap;
pub(crate) use hash_index::HashIndex;
pub(crate) use id::Id;
pub(crate) use node::Node;
pub(crate) use number::{Number, Ratio, factors_of_radicand};
pub(crate) use op::{Function, Relation, of_steps};
pub(crate) use reads::Reads;
pub(crate) use sign::Sign;
pub(crate) use symbol::Symbol;
pub(crate) use table::Table;
