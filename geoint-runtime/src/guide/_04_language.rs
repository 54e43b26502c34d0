//! The language of energies.
