//! Pieces of canonical energies: every family against its differential equation, methods for pieces, and refused steps.

mod centres;
mod check;
mod flows;
mod lengths;
mod methods;
mod time;
