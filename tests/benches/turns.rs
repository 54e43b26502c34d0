//! Child processes, which time the same rows by turns.
//!
//! Addresses and the load of the machine differ from process to process. One process may be off by half of its time. The median over several
//! processes is stable.

use anyhow::{Context, Result, ensure};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::path::Path;
use std::process::Command;

/// The argument that makes a program print its rows.
pub(crate) const ROWS: &str = "--rows";

/// Runs each program in several processes, in alternating order: first, second, second, first, …. Returns the rows by program and process.
pub(crate) fn run<T: DeserializeOwned>(programs: &[&Path], processes: usize) -> Result<Vec<Vec<Vec<T>>>> {
    let mut runs: Vec<_> = programs.iter().map(|_| Vec::new()).collect();
    for round in 0..processes {
        let mut order: Vec<usize> = (0..programs.len()).collect();
        if round % 2 == 1 {
            order.reverse();
        }
        for i in order {
            runs[i].push(rows_of(programs[i])?);
        }
    }
    Ok(runs)
}

/// Runs a program and reads its rows.
fn rows_of<T: DeserializeOwned>(program: &Path) -> Result<Vec<T>> {
    let output =
        Command::new(program).arg(ROWS).output().with_context(|| format!("{} does not start", program.display()))?;
    ensure!(output.status.success(), "{} failed: {}", program.display(), String::from_utf8_lossy(&output.stderr));
    let rows: csv::Result<Vec<T>> = csv::Reader::from_reader(&output.stdout[..]).into_deserialize().collect();
    rows.with_context(|| format!("{} prints other rows than expected", program.display()))
}

/// Prints rows for the parent process.
pub(crate) fn print<T: Serialize>(rows: impl IntoIterator<Item = T>) -> Result<()> {
    let mut writer = csv::Writer::from_writer(std::io::stdout());
    for row in rows {
        writer.serialize(row)?;
    }
    Ok(writer.flush()?)
}

/// Returns the median. Panics if there are no values.
pub(crate) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    if values.len() % 2 == 1 { values[middle] } else { 0.5 * (values[middle - 1] + values[middle]) }
}
