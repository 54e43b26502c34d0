//! Coming from other libraries.
