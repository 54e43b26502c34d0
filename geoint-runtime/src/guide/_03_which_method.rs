//! Which method.
