//! Pieces of canonical energies: every family against its differential equation, methods for them, and what is refused.

mod centres;
mod check;
mod flows;
mod lengths;
mod methods;
mod time;
