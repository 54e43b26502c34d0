//! Fields with integrals, rigid bodies.
