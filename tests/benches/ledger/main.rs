//! Ledger of the runtime: times of steps and bytes of code, beside hand-written steps and beside an earlier revision.
//!
//! `cargo bench -p geoint-benches --bench ledger` prints the ledger and writes `target/geoint/ledger.csv`. `-- --reference REV` chooses the
//! revision. This build and the reference run by turns, in three processes each.

#[allow(dead_code, reason = "other programs use the rest")]
#[path = "../by_hand/mod.rs"]
mod by_hand;
#[allow(dead_code, reason = "other programs use the rest")]
#[path = "../cargo.rs"]
mod cargo;
mod code;
#[path = "../paired.rs"]
mod paired;
mod reference;
#[allow(dead_code, reason = "other programs use the rest")]
#[path = "../rows/mod.rs"]
mod rows;
#[path = "../systems.rs"]
mod systems;
mod table;
#[path = "../turns.rs"]
mod turns;

use anyhow::{Context, Result};
use cargo::{Build, own_checkout, own_target_folder};
use clap::{Arg, ArgAction, Command};
use serde::{Deserialize, Serialize};
use std::path::Path;
use table::{Code, Table};

/// Processes of each build.
const PROCESSES: usize = 3;

/// The library whose machine code is counted.
const LIBRARY: &str = "pendulum_step";

/// A row of one process: medians over batches. Times are nanoseconds a step.
///
/// Invariant: names of columns stay, because later builds read the rows of this one.
#[derive(Clone, Serialize, Deserialize)]
struct Row {
    name: String,
    nanoseconds: f64,
    by_hand: f64,
    ratio: f64,
}

fn main() -> Result<()> {
    let flag = |name: &'static str| Arg::new(name).long(name).action(ArgAction::SetTrue).hide(true);
    let arguments = Command::new("ledger")
        .arg(Arg::new("reference").long("reference").value_name("REV").default_value(reference::DEFAULT))
        .args(["bench", "test", "list", "rows"].map(flag))
        .get_matches();
    if arguments.get_flag("rows") {
        return print_rows();
    }
    // `cargo test` passes these options: the rows must run, times do not matter.
    if arguments.get_flag("test") || arguments.get_flag("list") {
        rows::all();
        return Ok(());
    }
    let library = Build { checkout: own_checkout(), target_folder: own_target_folder() }.library(LIBRARY)?;
    let revision = arguments.get_one::<String>("reference").expect("a default");
    let reference = Reference::build(revision)
        .inspect_err(|error| eprintln!("\nNo reference: {error:#}. Only ratios to hand-written steps follow."))
        .ok();

    let own = std::env::current_exe()?;
    let mut programs = vec![own.as_path()];
    programs.extend(reference.as_ref().map(|reference| reference.program.as_path()));
    let mut runs = turns::run(&programs, PROCESSES)?.into_iter();
    let own_runs: Vec<Vec<Row>> = runs.next().context("this build has not run")?;
    let reference_runs: Option<Vec<Vec<Row>>> = runs.next();

    let code = Code { own: code::bytes(&library)?, reference: reference.and_then(|reference| reference.code) };
    let table = Table { lines: table::lines(&own_runs, reference_runs.as_deref())?, code };
    print!("{table}");
    let folder = own_target_folder().join("geoint");
    std::fs::create_dir_all(&folder)?;
    table.write(&folder.join("ledger.csv"))
}

/// Times all rows in this process and prints the result.
fn print_rows() -> Result<()> {
    let rows = rows::all();
    turns::print(rows.iter().map(|pair| {
        let ratio = pair.ratio();
        let [nanoseconds, by_hand] = ratio.nanoseconds;
        Row { name: pair.name.clone(), nanoseconds, by_hand, ratio: ratio.median }
    }))
}

/// The build of an earlier revision.
struct Reference {
    program: std::path::PathBuf,
    /// Bytes of code, if the revision has the library.
    code: Option<u64>,
}

impl Reference {
    fn build(revision: &str) -> Result<Self> {
        let checkout = reference::checkout(revision)?;
        let target_folder = checkout.join("target");
        let build = Build { checkout: &checkout, target_folder: &target_folder };
        let has_library = |checkout: &Path| checkout.join(format!("tests/benches/examples/{LIBRARY}.rs")).exists();
        let code = if has_library(&checkout) { Some(code::bytes(&build.library(LIBRARY)?)?) } else { None };
        Ok(Reference { program: build.bench("ledger")?, code })
    }
}
