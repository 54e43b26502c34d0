//! The long part: sections of a page, each a list of runs.

mod chaos;
mod encounters;
mod page;
mod scale;
mod stiff;
mod sums;

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A line of a table, and a message if its bound is exceeded.
pub(super) struct Row {
    cells: Vec<String>,
    failure: Option<String>,
}

/// Returns a row that fails unless `holds`.
fn row(cells: Vec<String>, holds: bool) -> Row {
    let failure = (!holds).then(|| cells.join(", "));
    Row { cells, failure }
}

/// A run that gives a row.
type Job = Box<dyn FnOnce() -> Row + Send>;

/// The part of a table that stands on the page. Columns have indices.
enum Part {
    /// These columns of the chosen rows.
    Columns(&'static [usize], fn(&[String]) -> bool),
    /// A row for each cell of the column `row`, and a column for each of these cells of the column `by`, filled from the column `value`.
    Pivot { row: usize, by: usize, cells: &'static [&'static str], value: usize, chosen: fn(&[String]) -> bool },
}

/// Chooses all rows.
fn all(_: &[String]) -> bool {
    true
}

/// A table.
struct Section {
    title: &'static str,
    text: &'static str,
    head: &'static [&'static str],
    part: Part,
    jobs: Vec<Job>,
}

/// Writes a number.
fn short(x: f64) -> String {
    if x == 0.0 { "0".into() } else { format!("{x:.1e}") }
}

/// Runs all jobs on all processors.
fn done(jobs: Vec<Job>) -> Vec<Row> {
    let count = jobs.len();
    let jobs: Vec<_> = jobs.into_iter().map(|job| Mutex::new(Some(job))).collect();
    let rows: Vec<_> = (0..count).map(|_| Mutex::new(None)).collect();
    let next = AtomicUsize::new(0);
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let taken = next.fetch_add(1, Ordering::Relaxed);
                    let Some(job) = jobs.get(taken) else { break };
                    let Some(job) = job.lock().expect("nobody else has this one").take() else { break };
                    let row = job();
                    eprintln!("{}", row.cells.join(" | "));
                    *rows[taken].lock().expect("nobody else has this one") = Some(row);
                }
            });
        }
    });
    rows.into_iter().filter_map(|row| row.into_inner().ok().flatten()).collect()
}
