//! Points of phase space: the states of users, the arrays of kernels, and moving points with sums of increments.

mod array;
pub(crate) mod body;
mod coordinates;
mod double_word;
mod per_coordinate;
mod point;
mod record;
pub(crate) mod state;
mod summation;
pub(crate) mod vector;

pub use array::{Array, Square};
pub use body::{BodyState, Placed};
pub(crate) use body::{normalisation, wrong_length};
pub use coordinates::Coordinates;
pub use double_word::DoubleWord;
pub use per_coordinate::PerCoordinate;
pub use point::Point;
pub(crate) use record::NEVER;
pub use record::{Record, Tape};
pub(crate) use state::Action;
pub use state::{ContactState, FlowState, Snapshot, State};
pub use summation::{Compensated, Plain, Summation, WithoutAction};
