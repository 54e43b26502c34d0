//! Measures what is claimed, and writes it to `VERIFICATION.md`: methods, functions of the language, examples, reports.
//!
//! `cargo run --release -p geoint-tests --bin verification` fails if a claim does not hold, or if something that can be claimed has no
//! row. What it writes may differ from the page in the repository in digits; if words differ, the page is to be committed anew. Without
//! optimisation it would take an hour, and every `cargo test` would build a thousand instances of methods: there is nothing then.

#[cfg(not(debug_assertions))]
mod examples;
#[cfg(not(debug_assertions))]
mod language;
#[cfg(not(debug_assertions))]
mod lists;
#[cfg(not(debug_assertions))]
mod methods;
#[cfg(not(debug_assertions))]
mod page;
#[cfg(not(debug_assertions))]
mod reports;
#[cfg(not(debug_assertions))]
mod sources;
#[cfg(not(debug_assertions))]
mod taylor;

#[cfg(not(debug_assertions))]
#[global_allocator]
static ALLOCATOR: geoint_tests::counting::Counting = geoint_tests::counting::Counting;

#[cfg(not(debug_assertions))]
fn main() -> std::process::ExitCode {
    let mut page = page::Page::new();
    methods::section(&mut page);
    taylor::section(&mut page);
    language::section(&mut page);
    examples::section(&mut page);
    reports::section(&mut page);
    page.finish()
}

#[cfg(debug_assertions)]
fn main() -> std::process::ExitCode {
    eprintln!("cargo run --release -p geoint-tests --bin verification");
    std::process::ExitCode::FAILURE
}
