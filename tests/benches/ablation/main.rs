//! Ablation: the gain of each accelerator of implicit steps. The gain is the time without the accelerator over the time with the accelerator.
//!
//! `cargo bench -p geoint-benches --bench ablation` compiles one variant of the runtime for each accelerator, runs it and the complete
//! runtime by turns, and writes `tests/benches/ABLATION.md`, and the gain on each row to `target/geoint/ablation.md`. Arguments select
//! accelerators by name; both parts are then printed.

mod accelerators;
#[allow(dead_code, reason = "the ledger uses the rest")]
#[path = "../cargo.rs"]
mod cargo;
mod page;
#[allow(dead_code, reason = "the ledger uses the rest")]
#[path = "../turns.rs"]
mod turns;
mod variant;

use accelerators::ACCELERATORS;
use anyhow::Result;
use page::{Measured, Page, Rows};
use std::path::Path;

/// Processes of each variant, and of the complete runtime beside it.
const PROCESSES: usize = 3;

/// A run of all variants writes this page.
const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/ABLATION.md");

fn main() -> Result<()> {
    // `cargo test` passes these options: the program must compile, times do not matter.
    if std::env::args().any(|argument| argument == "--test" || argument == "--list") {
        return Ok(());
    }
    let selected: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let accelerators: Vec<_> = ACCELERATORS
        .iter()
        .filter(|accelerator| selected.is_empty() || selected.iter().any(|name| name == accelerator.name))
        .collect();

    // Compilation would disturb the measurement, so it comes first.
    let complete = variant::compile(None)?;
    let mut programs = Vec::new();
    for accelerator in &accelerators {
        programs.push(variant::compile(Some(accelerator.name))?);
    }
    let mut measured = Vec::new();
    for (accelerator, program) in accelerators.into_iter().zip(&programs) {
        eprintln!("without {}", accelerator.name);
        let mut runs = turns::run(&[complete.as_path(), program.as_path()], PROCESSES)?;
        let without = runs.pop().expect("two programs");
        let with = runs.pop().expect("two programs");
        measured.push(Measured { accelerator, with, without });
    }
    let page = Page { measured };
    let rows = Rows(&page).to_string();
    if selected.is_empty() {
        std::fs::write(Path::new(PAGE), page.to_string())?;
        std::fs::write(cargo::own_target_folder().join("geoint/ablation.md"), rows)?;
    } else {
        print!("{page}\n{rows}");
    }
    Ok(())
}
