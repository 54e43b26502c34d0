//! Accepted forms: they compile, without a warning where a lint is denied, and mean what they say.
#![deny(non_ascii_idents)]

mod assignments;
mod condition_on_parameters;
mod constants_outside;
mod crate_path;
mod damping;
mod energy_functions;
mod flows;
mod language;
mod lengths_and_aliases;
pub mod lints_of_every_attribute;
mod lints_of_the_user;
mod names_of_the_user;
mod no_parameters;
mod raw_names_and_docs;
mod renamed_arguments;
mod requirements;
mod single_precision;
mod states;
pub mod strict_lints;
mod unused_arguments;
mod vectors;
mod visibility;
