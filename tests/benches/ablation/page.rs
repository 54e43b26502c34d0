//! The page of the ablation.

use crate::accelerators::Accelerator;
use crate::turns::median;
use serde::Deserialize;
use std::fmt;

/// The rule: an accelerator stays if it gains this much on so many rows.
const GAIN: f64 = 1.10;
const ROWS: usize = 2;

/// Rows whose processes differ by more than this are marked.
const STEADY: f64 = 0.05;

/// The introduction, and the part that was decided by a prototype.
const INTRODUCTION: &str = include_str!("introduction.md");
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
    fn group(&self) -> &str {
        self.name.split(": ").next().expect("a first part")
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
    /// Time without the accelerator over time with it. Nothing where the variant fails.
    fn gain(&self, row: usize) -> Option<f64> {
        let time = |runs: &[Vec<Row>]| median(runs.iter().map(|rows| rows[row].nanoseconds).collect());
        let failed = self.without.iter().any(|rows| rows[row].fails());
        (!failed).then(|| time(&self.without) / time(&self.with))
    }

    /// The largest difference of final states, relative to the largest entry, over all rows that do not fail.
    fn difference(&self) -> f64 {
        let of_row = |(a, b): (&Row, &Row)| {
            let (a, b) = (a.numbers(), b.numbers());
            let scale = a.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
            a.iter().zip(&b).map(|(a, b)| (a - b).abs() / scale).fold(0.0, f64::max)
        };
        let rows = self.with[0].iter().zip(&self.without[0]).filter(|(_, without)| !without.fails());
        rows.map(of_row).fold(0.0, f64::max)
    }

    fn gains(&self) -> impl Iterator<Item = Option<f64>> {
        (0..self.with[0].len()).map(|row| self.gain(row))
    }

    fn verdict(&self) -> &'static str {
        let gained = self.gains().flatten().filter(|gain| *gain >= GAIN).count();
        match (self.gains().any(|gain| gain.is_none()), gained >= ROWS) {
            (_, true) => "stays",
            (true, false) => "stays: steps fail without it",
            (false, false) => "delete",
        }
    }
}

/// All that was measured.
pub(crate) struct Page<'a> {
    pub(crate) measured: Vec<Measured<'a>>,
}

impl Page<'_> {
    /// Times of one row in all processes of the complete runtime: median, and distance of the quartiles over the median.
    fn complete(&self, row: usize) -> (f64, f64) {
        let runs = self.measured.iter().flat_map(|measured| &measured.with);
        let mut times: Vec<f64> = runs.map(|rows| rows[row].nanoseconds).collect();
        times.sort_by(f64::total_cmp);
        let (n, middle) = (times.len(), median(times.clone()));
        (middle, (times[3 * n / 4] - times[n / 4]) / middle)
    }

    fn summary(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "| accelerator | lines | rows with 10 % | mean gain | largest gain | states differ by | verdict |"
        )?;
        writeln!(f, "|---|---|---|---|---|---|---|")?;
        for measured in &self.measured {
            let Accelerator { name, technique, lines } = measured.accelerator;
            let gains: Vec<f64> = measured.gains().flatten().collect();
            let gained = gains.iter().filter(|gain| **gain >= GAIN).count();
            let mean = (gains.iter().map(|gain| gain.ln()).sum::<f64>() / gains.len() as f64).exp();
            let largest = gains.iter().copied().fold(0.0, f64::max);
            let (difference, verdict) = (measured.difference(), measured.verdict());
            writeln!(
                f,
                "| `{name}`: {technique} | {lines} | {gained} | {mean:.3} | {largest:.2} | {difference:.0e} | {verdict} |"
            )?;
        }
        Ok(())
    }

    fn group(&self, f: &mut fmt::Formatter<'_>, group: &str, places: &[usize]) -> fmt::Result {
        let rows = &self.measured[0].with[0];
        writeln!(f, "\n### {group}\n\n| row | ns a step | spread |\n|---|---|---|")?;
        for (number, &row) in places.iter().enumerate() {
            let (time, spread) = self.complete(row);
            let name = &rows[row].name[group.len() + 2..];
            let mark = if spread > STEADY { " (unsteady)" } else { "" };
            writeln!(f, "| {}: {name} | {time:.0} | {:.1} %{mark} |", number + 1, 100.0 * spread)?;
        }
        let numbers: String = (1..=places.len()).map(|number| format!(" {number} |")).collect();
        writeln!(f, "\n| gain on row |{numbers}\n|---|{}", "---|".repeat(places.len()))?;
        for measured in &self.measured {
            write!(f, "| `{}` |", measured.accelerator.name)?;
            for &row in places {
                match measured.gain(row) {
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
        write!(f, "{INTRODUCTION}\n")?;
        self.summary(f)?;
        let failures = self.measured.iter().flat_map(|measured| {
            let failed = measured.without[0].iter().filter(|row| row.fails());
            failed.map(|row| format!("- Without `{}`, {}: {}.\n", measured.accelerator.name, row.name, row.state))
        });
        write!(f, "\n{}", failures.collect::<String>())?;
        writeln!(f, "\n## Gain on each row")?;
        let rows = &self.measured[0].with[0];
        let mut groups: Vec<(&str, Vec<usize>)> = Vec::new();
        for (place, row) in rows.iter().enumerate() {
            match groups.last_mut() {
                Some((group, places)) if *group == row.group() => places.push(place),
                _ => groups.push((row.group(), vec![place])),
            }
        }
        for (group, places) in groups {
            self.group(f, group, &places)?;
        }
        write!(f, "\n{DECIDED}")
    }
}
