//! Bodies that attract each other, in Jacobi coordinates and in heliocentric coordinates. Both describe the same energy, split differently.

mod both;
mod errors;
mod refused;
mod written;
