//! Planets.
