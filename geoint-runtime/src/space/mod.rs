//! Points of phase space: the states of users, the arrays of kernels, and moving points with sums of increments.

mod array;
mod body;
mod coordinates;
mod double_word;
mod per_coordinate;
mod point;
mod record;
mod state;
mod summation;
pub(crate) mod vector;

pub use array::{Array, Square};
pub use body::{Attitudes, BodyState, Centres, Placed};
pub(crate) use body::{normalisation, wrong_length};
pub use coordinates::Coordinates;
pub use double_word::DoubleWord;
pub use per_coordinate::PerCoordinate;
pub use point::Point;
pub(crate) use record::NEVER;
pub use record::{Record, Tape};
pub use state::{Action, ContactState, FlowState, Snapshot, State};
pub use summation::{Compensated, Plain, Summation, WithoutAction};
