//! One file for each form: from the expressions of the user to a system with its routines.

mod bodies;
mod canonical;
mod constrained;
mod contact;
mod field;
mod first_order;
mod lagrangian;
mod structured;
mod velocities;

use crate::compilation::Compilation;
use crate::derive::Derived;
use crate::diagnostics::Result;
use crate::lower::Terms;
use crate::parse::Form;

/// Proves the structure of a system, checks the user's requests, and derives the routines of every method.
pub(crate) fn derived(compilation: &mut Compilation<'_>, terms: Terms) -> Result<Derived> {
    match compilation.form {
        Form::Hamiltonian => canonical::derived(compilation, terms, None),
        Form::Contact => contact::derived(compilation, terms, None),
        Form::Lagrangian | Form::Herglotz | Form::FirstOrder => lagrangian::derived(compilation, terms),
        Form::Bodies => bodies::derived(compilation, &terms),
        Form::Structured => structured::derived(compilation, terms),
        Form::Field => field::derived(compilation, &terms),
    }
}
