//! Facts about energies: what is proven, and what must not be.

mod damping;
mod identity;
mod mean_value;
mod momenta;
mod steep;
mod structures;
