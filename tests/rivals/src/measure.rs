//! Runs of all entries in turns: what else the machine does meets all of them alike.

use crate::entry::{Entry, Point};
use indicatif::ProgressBar;
use std::hint::black_box;
use std::time::Instant;

/// How long a single run may take, in seconds: longer ones are not timed again.
const LONGEST: f64 = 0.04;
/// A run is repeated until it takes so long.
const SHORTEST: f64 = 2e-4;
/// Errors below this are rounding.
const ROUNDING: f64 = 3e-15;
/// Rounds in which everything is timed.
pub const ROUNDS: usize = 5;

/// |x − end| over |end|.
fn error(x: &[f64], end: &[f64]) -> f64 {
    let square = |x: &mut dyn Iterator<Item = f64>| x.map(|x| x * x).sum::<f64>().sqrt();
    square(&mut x.iter().zip(end).map(|(x, end)| x - end)) / square(&mut end.iter().copied())
}

/// The points of all entries. `judge` gives the error of a final state.
pub fn measure(entries: &[Entry], judge: &dyn Fn(&[f64]) -> f64, rounds: usize, bar: &ProgressBar) -> Vec<Vec<Point>> {
    let mut points: Vec<Vec<Point>> = entries.iter().map(|entry| explored(entry, judge, bar)).collect();
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
        let state = (entry.run)(black_box(*effort));
        let seconds = begin.elapsed().as_secs_f64();
        let error = state.map_or(f64::NAN, |state| judge(&state));
        if error.is_finite() && error < 1.0 {
            worse = if points.last().is_some_and(|last| last.error <= error) { worse + 1 } else { 0 };
            points.push(Point { effort: *effort, error, seconds: vec![] });
        }
        if seconds > LONGEST || error < ROUNDING || worse > 2 {
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

/// The error relative to a reference.
pub fn relative_to(end: Vec<f64>) -> impl Fn(&[f64]) -> f64 {
    move |x| error(x, &end)
}

/// In how many seconds an entry has an error, between its points on the lower envelope; none where it has not.
pub fn time_at(points: &[Point], level: f64) -> Option<f64> {
    let mut best: Option<f64> = None;
    for (i, point) in points.iter().enumerate() {
        if point.error <= level {
            best = Some(best.map_or(point.least(), |best| best.min(point.least())));
        }
        let Some(next) = points.get(i + 1) else { continue };
        if point.error > level && next.error <= level {
            let part = (point.error / level).ln() / (point.error / next.error).ln();
            let time = (point.least().ln() + part * (next.least() / point.least()).ln()).exp();
            best = Some(best.map_or(time, |best| best.min(time)));
        }
    }
    best
}
