//! What the test programs share: energies, scalars, the list of all methods, measurements. Not published.

pub mod scalars;
pub mod problems;
pub mod methods;
pub mod measure;
pub mod outer_planets;
