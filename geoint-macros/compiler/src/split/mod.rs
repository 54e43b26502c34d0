//! Splits an energy or a field into pieces with flows in closed form.
//!
//! A. Bravetti, M. Seri, M. Vermeeren & F. Zadra, Celest. Mech. Dyn. Astr. 132 (2020) 7, for contact Hamiltonians. P. G. Kevrekidis,
//! arXiv:2605.09103 (2026), for the energies that split.

mod polynomial;
mod products;
mod time;
mod flow;
mod scalar;
mod families;
mod linear_motion;
mod atoms;
mod powers;
mod nystrom;
mod partition;
mod nearest;
mod mechanics;
mod increment;
mod modified;
mod fields;
mod perturbed;

pub(crate) use families::tried;
pub(crate) use fields::{Motion, NoPart, Part, parts, planes, solved_planes};
pub(crate) use flow::{Family, Flow, Piece, Space, may_end};
pub(crate) use increment::{increments, steady};
pub(crate) use mechanics::{Mechanics, mechanics};
pub(crate) use modified::modified_energy;
pub(crate) use nearest::nearest;
pub(crate) use partition::{Partition, Pieces, Rejected, coupled_pieces, pieces};
pub(crate) use perturbed::{Division, Jump, NoPart as NoExactPart, OwnMotion, Perturbed, divided};
pub(crate) use time::Clock;
