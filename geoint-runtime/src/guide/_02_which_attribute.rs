//! Which attribute.
