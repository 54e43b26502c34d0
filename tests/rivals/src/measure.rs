//! Runs of all entries in turns: what else the machine does meets all of them alike.

use crate::entry::{Entry, Point};
use indicatif::ProgressBar;
use std::hint::black_box;
use std::panic::{self, AssertUnwindSafe};
use std::time::Instant;

/// How long a single run may take, in seconds: longer ones are not timed again.
const LONGEST: f64 = 0.04;
/// A run is repeated until it takes so long.
const SHORTEST: f64 = 2e-4;
/// Errors below this are rounding.
const ROUNDING: f64 = 3e-15;
/// Rounds in which everything is timed.
pub const ROUNDS: usize = 5;

/// The points of all entries. `judge` gives the error of the states of a run.
pub fn measure(entries: &[Entry], judge: &dyn Fn(&[f64]) -> f64, rounds: usize, bar: &ProgressBar) -> Vec<Vec<Point>> {
    // Steps by hand panic where they are far too long.
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    let mut points: Vec<Vec<Point>> = entries.iter().map(|entry| explored(entry, judge, bar)).collect();
    panic::set_hook(hook);
    for round in 0..rounds {
        // Effort by effort, so that neighbours in time are rivals.
        let most = points.iter().map(Vec::len).max().unwrap_or(0);
        for place in 0..most {
            for (entry, points) in entries.iter().zip(&mut points) {
                let Some(point) = points.get_mut(place) else { continue };
                point.seconds.push(timed(entry, point.effort));
            }
        }
        bar.set_message(format!("round {}", round + 1));
        bar.inc(1);
    }
    points
}

/// Efforts from the least on, until errors are rounding, or runs take too long.
fn explored(entry: &Entry, judge: &dyn Fn(&[f64]) -> f64, bar: &ProgressBar) -> Vec<Point> {
    bar.set_message(entry.name.clone());
    let mut points: Vec<Point> = vec![];
    let mut worse = 0;
    for effort in &entry.efforts {
        let begin = Instant::now();
        let states = panic::catch_unwind(AssertUnwindSafe(|| (entry.run)(black_box(*effort)))).ok().flatten();
        let seconds = begin.elapsed().as_secs_f64();
        let error = states.map_or(f64::NAN, |states| judge(&states));
        if error.is_finite() && error < 1.0 {
            // Errors of steps that are far too long are any.
            let is_worse = error < 0.1 && points.last().is_some_and(|last| last.error <= error);
            worse = if is_worse { worse + 1 } else { 0 };
            points.push(Point { effort: *effort, error, seconds: vec![] });
        }
        // Steps that are far too long may take long to be refused.
        let most = if points.is_empty() { 10.0 * LONGEST } else { LONGEST };
        if seconds > most || error < ROUNDING || worse > 2 {
            break;
        }
    }
    points
}

/// Seconds that a run takes.
fn timed(entry: &Entry, effort: f64) -> f64 {
    let mut runs = 0;
    let begin = Instant::now();
    loop {
        black_box((entry.run)(black_box(effort)));
        runs += 1;
        let seconds = begin.elapsed().as_secs_f64();
        if seconds >= SHORTEST {
            return seconds / f64::from(runs);
        }
    }
}

/// In how many seconds an entry has an error from which on all finer runs have it, up to its best one; between points on straight lines of
/// logarithms. None where it has not.
pub fn time_at(points: &[Point], level: f64) -> Option<f64> {
    let best = (0..points.len()).min_by(|a, b| points[*a].error.total_cmp(&points[*b].error))?;
    let good = points[..=best].iter().rev().take_while(|point| point.error <= level).count();
    let first = best + 1 - good;
    let reached = points.get(first).filter(|_| good > 0)?;
    let Some(before) = first.checked_sub(1).map(|before| &points[before]) else { return Some(reached.least()) };
    let part = (before.error / level).ln() / (before.error / reached.error).ln();
    // The coarser run may be the slower one, if it is iterated more often.
    let time = (before.least().ln() + part * (reached.least() / before.least()).ln()).exp();
    Some(time.min(reached.least()))
}
