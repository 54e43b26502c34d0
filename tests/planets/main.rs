//! Bodies that attract each other, in coordinates of Jacobi and in heliocentric ones: both are the same energy, solved in other parts.

mod both;
mod errors;
mod refused;
mod written;
