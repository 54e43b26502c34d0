//! The ledger as a table: times, ratios, and the rule for both kinds of ratios.

use crate::Row;
use crate::turns::median;
use anyhow::{Context, Result};
use std::fmt;
use std::path::Path;

/// The rule: bound on the geometric mean of all ratios.
const LARGEST_MEAN: f64 = 1.05;

/// The rule: bound on each ratio.
const LARGEST_ROW: f64 = 1.25;

/// Name of the library whose code is counted.
const CODE: &str = "pendulum, StormerVerlet";

/// One row: medians over processes. Times are nanoseconds a step.
pub(crate) struct Line {
    pub(crate) name: String,
    pub(crate) own: f64,
    pub(crate) reference: Option<f64>,
    pub(crate) by_hand: f64,
    /// Ratio to the hand-written step.
    pub(crate) to_hand: f64,
    /// Ratio to the reference.
    pub(crate) to_reference: Option<f64>,
}

/// Bytes of machine code.
pub(crate) struct Code {
    pub(crate) own: u64,
    pub(crate) reference: Option<u64>,
}

/// Joins the rows of all processes of this build and of the reference.
pub(crate) fn lines(own: &[Vec<Row>], reference: Option<&[Vec<Row>]>) -> Result<Vec<Line>> {
    let over = |runs: &[Vec<Row>], name: &str, value: fn(&Row) -> f64| {
        let values: Vec<f64> = runs.iter().flatten().filter(|row| row.name == name).map(value).collect();
        (!values.is_empty()).then(|| median(values))
    };
    let line = |row: &Row| {
        let of = |value| over(own, &row.name, value).expect("a row of the first process");
        let of_reference = |value| reference.and_then(|runs| over(runs, &row.name, value));
        let (own, to_hand) = (of(|row| row.nanoseconds), of(|row| row.ratio));
        let reference = of_reference(|row| row.nanoseconds);
        Line {
            name: row.name.clone(),
            own,
            reference,
            by_hand: of(|row| row.by_hand),
            to_hand,
            to_reference: reference.map(|reference| own / reference),
        }
    };
    Ok(own.first().context("no process has run")?.iter().map(line).collect())
}

/// The geometric mean and the worst row of one kind of ratios.
pub(crate) struct Summary<'a> {
    pub(crate) mean: f64,
    pub(crate) worst: (&'a str, f64),
}

impl<'a> Summary<'a> {
    /// Returns nothing if a row has no ratio.
    pub(crate) fn of(lines: &'a [Line], ratio: fn(&Line) -> Option<f64>) -> Option<Self> {
        let ratios: Option<Vec<_>> = lines.iter().map(|line| Some((line.name.as_str(), ratio(line)?))).collect();
        let ratios = ratios?;
        let logarithms: f64 = ratios.iter().map(|(_, ratio)| ratio.ln()).sum();
        let worst = ratios.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1))?;
        Some(Summary { mean: (logarithms / ratios.len() as f64).exp(), worst })
    }

    fn verdict(&self) -> &'static str {
        if self.mean <= LARGEST_MEAN && self.worst.1 <= LARGEST_ROW { "holds" } else { "fails" }
    }
}

impl fmt::Display for Summary<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (verdict, (name, ratio)) = (self.verdict(), self.worst);
        write!(f, "{verdict}: geometric mean {:.3}, worst row {ratio:.3} ({name})", self.mean)
    }
}

/// The complete ledger.
pub(crate) struct Table {
    pub(crate) lines: Vec<Line>,
    pub(crate) code: Code,
}

impl Table {
    /// Summaries of the ratios to the reference and to hand-written steps.
    fn summaries(&self) -> [Option<Summary<'_>>; 2] {
        [Summary::of(&self.lines, |line| line.to_reference), Summary::of(&self.lines, |line| Some(line.to_hand))]
    }

    /// Writes the table as a file of comma-separated values.
    pub(crate) fn write(&self, file: &Path) -> Result<()> {
        let mut writer = csv::Writer::from_path(file)?;
        writer.write_record(["row", "unit", "own", "reference", "by hand", "own / reference", "own / by hand"])?;
        let number = |digits: usize, x: Option<f64>| x.map_or(String::new(), |x| format!("{x:.digits$}"));
        for line in &self.lines {
            let Line { name, own, reference, by_hand, to_hand, to_reference } = line;
            let times = [Some(*own), *reference, Some(*by_hand)].map(|time| number(2, time));
            let ratios = [*to_reference, Some(*to_hand)].map(|ratio| number(4, ratio));
            let texts = times.into_iter().chain(ratios);
            writer.write_record([name.clone(), "ns".into()].into_iter().chain(texts))?;
        }
        let summaries = self.summaries();
        let ratios = |name: &str, of: fn(&Summary<'_>) -> String| {
            let texts = summaries.each_ref().map(|summary| summary.as_ref().map_or(String::new(), of));
            [name.into(), String::new(), String::new(), String::new(), String::new()].into_iter().chain(texts)
        };
        writer.write_record(ratios("geometric mean", |summary| format!("{:.4}", summary.mean)))?;
        writer.write_record(ratios("worst row", |summary| format!("{:.4}", summary.worst.1)))?;
        writer.write_record(ratios("rule", |summary| summary.verdict().into()))?;
        let Code { own, reference } = self.code;
        let bytes = [Some(own), reference].map(|bytes| bytes.map_or(String::new(), |bytes| bytes.to_string()));
        let ratio = number(4, reference.map(|reference| own as f64 / reference as f64));
        let [own, reference] = bytes;
        writer.write_record([CODE.into(), "bytes".into(), own, reference, String::new(), ratio, String::new()])?;
        Ok(writer.flush()?)
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ratio = |x: Option<f64>| x.map_or("–".into(), |x| format!("{x:.3}"));
        let time = |x: Option<f64>| x.map_or("–".into(), |x| format!("{x:.1}"));
        writeln!(
            f,
            "\n{:<48} {:>8} {:>9} {:>8}  {:>11} {:>9}",
            "ns a step", "own", "reference", "by hand", "/ reference", "/ by hand"
        )?;
        for Line { name, own, reference, by_hand, to_hand, to_reference } in &self.lines {
            let (to_reference, reference) = (ratio(*to_reference), time(*reference));
            writeln!(f, "{name:<48} {own:>8.1} {reference:>9} {by_hand:>8.1}  {to_reference:>11} {to_hand:>9.3}")?;
        }
        let Code { own, reference } = self.code;
        let reference = reference.map_or("–".into(), |bytes| bytes.to_string());
        writeln!(f, "\nbytes of code, {CODE}: {own}, reference {reference}")?;
        writeln!(f, "\nrule: geometric mean at most {LARGEST_MEAN}, no row above {LARGEST_ROW}")?;
        let [to_reference, to_hand] = self.summaries();
        let reason = |name: &str| format!("not decided: there is no {name}");
        let text = |summary: Option<Summary<'_>>, name| summary.map_or(reason(name), |summary| summary.to_string());
        writeln!(f, "against the reference: {}", text(to_reference, "reference"))?;
        writeln!(f, "against hand-written steps: {}", text(to_hand, "hand-written step"))
    }
}
