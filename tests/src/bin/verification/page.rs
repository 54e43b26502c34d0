//! The page: sections of text and tables, what does not hold, and whether the page in the repository says the same.

use crate::sources;
use std::fmt::Display;
use std::process::ExitCode;

/// What has been written so far.
pub(crate) struct Page {
    text: String,
    failures: Vec<String>,
    /// What is known not to hold, and is said on the page.
    open: Vec<String>,
}

const FILE: &str = "VERIFICATION.md";

const OPENING: &str = "# Verification\n\n\
    What is claimed, and what is measured of it. This page is written by\n\n\
    ```sh\ncargo run --release -p geoint-tests --bin verification\n```\n\n\
    which fails if a claim does not hold, or if a method, a function of the language, a family of flows, an example or a sentence of a \
    report has no row here. `.ci/verification` writes it anew: digits may move, words may not.\n";

const OPEN: &str = "With constraints, what a position is rounded by, divided by the length of a step, is seen in the momentum, and compositions have \
    short steps: the discrete gradient is symmetric to that.";

impl Page {
    pub(crate) fn new() -> Self {
        Page { text: OPENING.into(), failures: vec![], open: vec![] }
    }

    /// A heading and what is said below it.
    pub(crate) fn section(&mut self, level: usize, heading: &str, text: &str) {
        self.text += &format!("\n{} {heading}\n", "#".repeat(level));
        if !text.is_empty() {
            self.text += &format!("\n{text}\n");
        }
    }

    /// A table with a row of headings.
    pub(crate) fn table<const N: usize>(&mut self, headings: [&str; N], rows: impl IntoIterator<Item = [String; N]>) {
        let line = |cells: [String; N]| format!("| {} |\n", cells.join(" | "));
        self.text += "\n";
        self.text += &line(headings.map(String::from));
        self.text += &line(headings.map(|_| String::from("---")));
        for row in rows {
            self.text += &line(row);
        }
    }

    /// Something does not hold unless `holds`.
    pub(crate) fn claim(&mut self, holds: bool, what: impl Display) {
        if !holds {
            self.failures.push(what.to_string());
        }
    }

    /// Something does not hold, and the page says so.
    pub(crate) fn open(&mut self, what: impl Display) {
        self.open.push(what.to_string());
    }

    /// Writes the page.
    pub(crate) fn finish(mut self) -> ExitCode {
        self.section(2, "What does not hold", OPEN);
        let open = self.open.iter().map(|what| format!("- {what}\n")).collect::<String>();
        self.text += &format!("\n{open}");
        self.claim(!self.open.is_empty(), "all of it holds now: the section is to go");
        let path = sources::root().join(FILE);
        let before = std::fs::read_to_string(&path).unwrap_or_default();
        self.claim(
            words(&before) == words(&self.text),
            format_args!("{FILE} had other words: it is to be committed anew"),
        );
        if let Err(error) = std::fs::write(&path, &self.text) {
            self.failures.push(format!("{FILE}: {error}"));
        }
        for failure in &self.failures {
            eprintln!("does not hold: {failure}");
        }
        if self.failures.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }
}

/// A text without the numbers that are measured: those with a point or an exponent.
fn words(text: &str) -> String {
    let is_measured = |word: &&str| word.parse::<f64>().is_ok() && word.contains(['.', 'e']);
    let words = text.split_whitespace().map(|word| word.trim_end_matches([',', ';']));
    words.filter(|word| !is_measured(word)).collect::<Vec<_>>().join(" ")
}

/// A number with two digits.
pub(crate) fn short(x: f64) -> String {
    if x == 0.0 {
        "0.0".into()
    } else if x.is_nan() {
        "–".into()
    } else if (0.1..1000.0).contains(&x.abs()) {
        format!("{x:.2}")
    } else {
        format!("{x:.1e}")
    }
}
