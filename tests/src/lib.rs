//! Shared code of the test programs: energies, scalars, the list of all methods, measurements. Not published.

pub mod scalars;
pub mod scene;
pub mod problems;
pub mod scenes;
pub mod methods;
pub mod bare;
pub mod grid;
pub mod measure;
pub mod claims;
pub mod counting;
pub mod outer_planets;
pub mod jets;
