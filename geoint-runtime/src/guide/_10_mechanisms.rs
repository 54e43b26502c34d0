//! Lagrangians, mechanisms, constraints.
