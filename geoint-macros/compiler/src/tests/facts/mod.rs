//! Facts about energies: the compiler must claim them if they are proven, and only then.

mod damping;
mod identity;
mod mean_value;
mod momenta;
mod steep;
mod structures;
