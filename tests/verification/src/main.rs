//! Measures the claims on methods, functions of the language, examples and reports, and writes the measurements to `VERIFICATION.md`.
//!
//! `cargo run --release -p geoint-verification` fails if a claim does not hold, or if a subject of claims has no row. The written page may differ from the
//! page in the repository in digits. If words differ, commit the new page.
//!
//! Without optimisation the measurement would take an hour, and every `cargo test` would build a thousand instances of methods. An unoptimised build copies
//! the measured tables from the page in the repository. It still fails for missing rows, missing tests and other words, within seconds and in every run of
//! the tests (`rows.rs`).

mod examples;
#[cfg(not(debug_assertions))]
mod language;
#[cfg(not(debug_assertions))]
mod lists;
#[cfg(not(debug_assertions))]
mod methods;
mod page;
mod reports;
mod rows;
#[cfg(not(debug_assertions))]
mod taylor;

use page::Page;
use std::process::ExitCode;

#[cfg(not(debug_assertions))]
#[global_allocator]
static ALLOCATOR: geoint_tests::counting::Counting = geoint_tests::counting::Counting;

fn main() -> ExitCode {
    let mut page = Page::new();
    measured(&mut page);
    rows::complete(&mut page);
    examples::section(&mut page);
    reports::section(&mut page);
    page.finish()
}

#[cfg(not(debug_assertions))]
fn measured(page: &mut Page) {
    methods::section(page);
    taylor::section(page);
    language::section(page);
}

#[cfg(debug_assertions)]
fn measured(page: &mut Page) {
    page.copy_measured();
}
