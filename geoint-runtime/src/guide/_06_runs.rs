//! A run in practice.
