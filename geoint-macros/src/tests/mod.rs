//! Tests of the whole compiler; nothing outside of a proc-macro crate can call its insides.

mod cost;
mod meaning;
mod snapshots;
