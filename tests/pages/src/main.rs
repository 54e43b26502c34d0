//! Writes everything in the documentation that follows from other files, and checks the rest.
//!
//! `cargo run -p geoint-pages` writes the pages. With `-- --check` it writes nothing, and fails with the name of each page that is not as it would be
//! written, or that breaks a rule of the project: too many words, a link that leads nowhere, an old version.

mod errors;
mod methods;
mod project;
mod rules;

use project::Project;
use std::process::ExitCode;

fn main() -> ExitCode {
    let project = Project::new(std::env::args().any(|argument| argument == "--check"));
    let outcome = write(&project).and_then(|()| rules::check(&project));
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(problems) => {
            eprintln!("{}", problems.join("\n"));
            ExitCode::FAILURE
        }
    }
}

/// Writes or checks each generated page.
fn write(project: &Project) -> Result<(), Vec<String>> {
    let mut problems = vec![];
    for (path, text) in [
        ("geoint-runtime/docs/methods.txt", methods::table(project)),
        ("geoint-runtime/src/guide/_16_errors.rs", errors::page(project)),
    ] {
        let outcome = text.and_then(|text| project.write(path, &text));
        problems.extend(outcome.err());
    }
    if problems.is_empty() { Ok(()) } else { Err(problems) }
}
