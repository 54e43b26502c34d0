//! The page of the ablation.

use crate::accelerators::{Accelerator, Group};
use crate::turns::median;
use serde::Deserialize;
use std::fmt;

/// The rule: smallest gain that counts.
const GAIN: f64 = 1.10;

/// The rule: an accelerator stays if it gains on this number of rows.
const ROWS: usize = 2;

/// Rows with a larger spread between processes are marked, and do not count for the verdicts. The spread is the distance of the quartiles over the
/// median.
const STEADY: f64 = 0.05;

/// The first part of the page.
const INTRODUCTION: &str = include_str!("introduction.md");

/// The last part of the page: accelerators that a prototype has decided.
const DECIDED: &str = include_str!("decided.md");

/// A row of one process.
#[derive(Clone, Deserialize)]
pub(crate) struct Row {
    /// Group, system, method and step size.
    pub(crate) name: String,
    /// Median time of a step; not a number where the run fails.
    pub(crate) nanoseconds: f64,
    /// The final state, or the reason of the failure.
    pub(crate) state: String,
}

impl Row {
    fn belongs_to(&self, group: Group) -> bool {
        self.name.strip_prefix(group.name()).is_some_and(|rest| rest.starts_with(": "))
    }

    fn fails(&self) -> bool {
        self.nanoseconds.is_nan()
    }

    fn numbers(&self) -> Vec<f64> {
        self.state.split(' ').filter_map(|x| x.parse().ok()).collect()
    }
}

/// Runs of the complete runtime and of one variant, by turns.
pub(crate) struct Measured<'a> {
    pub(crate) accelerator: &'a Accelerator,
    pub(crate) with: Vec<Vec<Row>>,
    pub(crate) without: Vec<Vec<Row>>,
}

impl Measured<'_> {
    /// Returns the time without the accelerator over the time with the accelerator, or nothing if the variant fails.
    ///
    /// Each time is the median over processes.
    fn gain(&self, row: usize) -> Option<f64> {
        let time = |runs: &[Vec<Row>]| median(runs.iter().map(|rows| rows[row].nanoseconds).collect());
        let failed = self.without.iter().any(|rows| rows[row].fails());
        (!failed).then(|| time(&self.without) / time(&self.with))
    }

    /// Returns the largest difference of final states, relative to the largest entry. Rows that fail do not count.
    fn difference(&self) -> f64 {
        let of_row = |(a, b): (&Row, &Row)| {
            let (a, b) = (a.numbers(), b.numbers());
            let scale = a.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
            a.iter().zip(&b).map(|(a, b)| (a - b).abs() / scale).fold(0.0, f64::max)
        };
        let rows = self.with[0].iter().zip(&self.without[0]).filter(|(_, without)| !without.fails());
        rows.map(of_row).fold(0.0, f64::max)
    }

    /// Returns a list of the rows that fail, with the reasons.
    fn failures(&self) -> String {
        let failed = self.without[0].iter().filter(|row| row.fails());
        failed.map(|row| format!("\n- Without `{}`, {}: {}.\n", self.accelerator.name, row.name, row.state)).collect()
    }
}

/// The page: introduction, verdicts and decisions by the prototype.
pub(crate) struct Page<'a> {
    pub(crate) measured: Vec<Measured<'a>>,
}

impl Page<'_> {
    /// Returns the median time of a row over all processes of the complete runtime, and the distance of the quartiles over the median.
    fn complete(&self, row: usize) -> (f64, f64) {
        let runs = self.measured.iter().flat_map(|measured| &measured.with);
        let mut times: Vec<f64> = runs.map(|rows| rows[row].nanoseconds).collect();
        times.sort_by(f64::total_cmp);
        let (n, middle) = (times.len(), median(times.clone()));
        (middle, (times[3 * n / 4] - times[n / 4]) / middle)
    }

    /// Returns the gains of an accelerator on the steady rows of its groups; nothing for rows that fail without the accelerator.
    fn gains(&self, measured: &Measured<'_>) -> Vec<Option<f64>> {
        let rows = measured.with[0].iter().enumerate();
        let of_group = rows.filter(|(_, row)| measured.accelerator.groups.iter().any(|group| row.belongs_to(*group)));
        let steady = of_group.filter(|(place, _)| self.complete(*place).1 <= STEADY);
        steady.map(|(place, _)| measured.gain(place)).collect()
    }

    fn summary(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "| accelerator | lines | rows with 10 % | mean gain | largest gain | difference | verdict |")?;
        writeln!(f, "|---|---|---|---|---|---|---|")?;
        for measured in &self.measured {
            let Accelerator { name, technique, lines, .. } = measured.accelerator;
            let all = self.gains(measured);
            let gains: Vec<f64> = all.iter().copied().flatten().collect();
            let gained = gains.iter().filter(|gain| **gain >= GAIN).count();
            let verdict = match (gained >= ROWS, gains.len() < all.len()) {
                (true, _) => "stays",
                (false, true) => "stays: steps fail without it",
                (false, false) => "delete",
            };
            let mean = (gains.iter().map(|gain| gain.ln()).sum::<f64>() / gains.len() as f64).exp();
            let largest = gains.iter().copied().fold(0.0, f64::max);
            let difference = measured.difference();
            writeln!(
                f,
                "| `{name}`: {technique} | {lines} | {gained} | {mean:.3} | {largest:.2} | {difference:.0e} | {verdict} |"
            )?;
        }
        Ok(())
    }

    fn group(&self, f: &mut fmt::Formatter<'_>, group: Group) -> fmt::Result {
        let all = &self.measured[0].with[0];
        let places: Vec<usize> = (0..all.len()).filter(|&place| all[place].belongs_to(group)).collect();
        writeln!(f, "\n### {}\n\n| row | ns a step | spread |\n|---|---|---|", group.name())?;
        for (number, &place) in places.iter().enumerate() {
            let (time, spread) = self.complete(place);
            let name = &all[place].name[group.name().len() + 2..];
            let mark = if spread > STEADY { " (unsteady)" } else { "" };
            writeln!(f, "| {}: {name} | {time:.0} | {:.1} %{mark} |", number + 1, 100.0 * spread)?;
        }
        let numbers: String = (1..=places.len()).map(|number| format!(" {number} |")).collect();
        writeln!(f, "\n| gain on row |{numbers}\n|---|{}", "---|".repeat(places.len()))?;
        for measured in self.measured.iter().filter(|measured| measured.accelerator.groups.contains(&group)) {
            write!(f, "| `{}` |", measured.accelerator.name)?;
            for &place in &places {
                match measured.gain(place) {
                    Some(gain) if gain >= GAIN => write!(f, " **{gain:.2}** |")?,
                    Some(gain) => write!(f, " {gain:.2} |")?,
                    None => write!(f, " fails |")?,
                }
            }
            writeln!(f)?;
        }
        Ok(())
    }
}

impl fmt::Display for Page<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{INTRODUCTION}")?;
        self.summary(f)?;
        let failures: String = self.measured.iter().map(Measured::failures).collect();
        write!(f, "{failures}\n{DECIDED}")
    }
}

/// The times of all rows, and the gain of each accelerator on each row of its groups.
pub(crate) struct Rows<'a>(pub(crate) &'a Page<'a>);

impl fmt::Display for Rows<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "## Gain on each row")?;
        for group in Group::ALL {
            self.0.group(f, group)?;
        }
        Ok(())
    }
}
