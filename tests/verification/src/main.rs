//! Measures what is claimed, and writes it to `VERIFICATION.md`: methods, functions of the language, examples, reports.
//!
//! `cargo run --release -p geoint-verification` fails if a claim does not hold, or if something that can be claimed has no
//! row. What it writes may differ from the page in the repository in digits; if words differ, the page is to be committed anew.
//!
//! Without optimisation measuring would take an hour, and every `cargo test` would build a thousand instances of methods. There the measured
//! tables are copied from the page in the repository. Missing rows, missing tests and other words still fail, within seconds and in every run of
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
