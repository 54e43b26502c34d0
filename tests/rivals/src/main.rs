//! Run time against error: problems × methods × efforts, beside other crates and steps by hand, all in one run.
//!
//! ```text
//! cargo run --release --manifest-path tests/rivals/Cargo.toml             # everything: at most ten minutes
//! cargo run --release --manifest-path tests/rivals/Cargo.toml -- kepler   # one, or those whose names contain the word
//! cargo run --release --manifest-path tests/rivals/Cargo.toml -- long     # energies over long times
//! … -- --commit                                                           # copies figures and tables to tests/benches
//! ```
//!
//! `target/geoint/work_precision` then has a figure for each problem, `results.csv`, and `index.html` with all of it.

#[allow(dead_code, reason = "the benches of steps use all of it")]
#[path = "../../benches/by_hand/mod.rs"]
mod by_hand;
mod entry;
mod field;
mod long;
mod measure;
mod page;
mod problems;
mod rivals;
#[allow(dead_code, reason = "the benches of steps use all of it")]
#[path = "../../benches/systems.rs"]
mod systems;
mod tables;
mod winners;

use indicatif::{ProgressBar, ProgressStyle};
use page::Measured;
use std::error::Error;
use std::time::Duration;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let commit = arguments.iter().any(|argument| argument == "--commit");
    let words: Vec<&String> = arguments.iter().filter(|word| !word.starts_with("--")).collect();
    if commit && !words.is_empty() {
        return Err("--commit writes pages with all problems".into());
    }
    let is_name = |word: &str| word == "long" || problems::ALL.iter().any(|(name, _)| *name == word);
    let fits = |name: &str, word: &str| if is_name(word) { name == word } else { name.contains(word) };
    let wanted = |name: &str| words.is_empty() || words.iter().any(|word| fits(name, word));
    let chosen: Vec<_> = problems::ALL.into_iter().filter(|(name, _)| wanted(name)).collect();
    let bar = ProgressBar::new(chosen.len() as u64 * (measure::ROUNDS as u64 + 1) + if wanted("long") { 2 } else { 0 });
    bar.set_style(ProgressStyle::with_template("{prefix} {bar:30} {pos}/{len} {elapsed} {msg}")?);
    bar.enable_steady_tick(Duration::from_millis(500));
    let mut all = vec![];
    for (name, problem) in chosen {
        bar.set_prefix(name);
        bar.set_message("reference");
        let problem = problem();
        bar.inc(1);
        let points = measure::measure(&problem.entries, &*problem.judge, measure::ROUNDS, &bar);
        let measured = Measured { problem, points };
        bar.suspend(|| println!("{}", tables::winners([&measured]).markdown()));
        all.push(measured);
    }
    bar.set_prefix("long");
    let long = if wanted("long") { long::measure(&bar) } else { vec![] };
    bar.finish_and_clear();
    page::write(&all, &long, commit)
}
