//! Errors and remedies.
