//! Friction, heat, driving.
