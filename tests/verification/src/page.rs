//! The page: sections of text and tables, and a comparison with the page in the repository.

use geoint_verification::sources;
use std::fmt::Display;
use std::process::ExitCode;

/// The text and the failures written so far.
pub(crate) struct Page {
    /// The page in the repository.
    before: String,
    text: String,
    failures: Vec<String>,
}

const FILE: &str = "VERIFICATION.md";

const OPENING: &str = "# Verification\n\n\
    This page lists the claims of the project, and the measurement of each. The following program writes it:\n\n\
    ```sh\ncargo run --release -p geoint-verification\n```\n\n\
    The program fails if a claim does not hold. It also fails if a method, a function of the language, a family of flows, an example or a \
    sentence of a report has no row here. `.ci/verification` writes the page anew: digits may change, words must not.\n";

/// Headings at which the measured part begins and ends.
#[cfg(debug_assertions)]
const METHODS: &str = "\n## Methods\n";
#[cfg(debug_assertions)]
const EXAMPLES: &str = "\n## Examples\n";

impl Page {
    pub(crate) fn new() -> Self {
        let before = std::fs::read_to_string(sources::root().join(FILE)).unwrap_or_default();
        Page { before, text: OPENING.into(), failures: vec![] }
    }

    /// Returns the text written so far.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Copies the measured part from the page in the repository.
    #[cfg(debug_assertions)]
    pub(crate) fn copy_measured(&mut self) {
        let measured = self.before.split_once(METHODS).and_then(|(_, rest)| rest.split_once(EXAMPLES));
        self.text += METHODS;
        self.text += measured.map_or("", |measured| measured.0);
    }

    /// Writes a heading and the text below it.
    pub(crate) fn section(&mut self, level: usize, heading: &str, text: &str) {
        self.text += &format!("\n{} {heading}\n", "#".repeat(level));
        if !text.is_empty() {
            self.text += &format!("\n{text}\n");
        }
    }

    /// Writes a table with a row of headings.
    pub(crate) fn table<const N: usize>(&mut self, headings: [&str; N], rows: impl IntoIterator<Item = [String; N]>) {
        let line = |cells: [String; N]| format!("| {} |\n", cells.join(" | "));
        self.text += "\n";
        self.text += &line(headings.map(String::from));
        self.text += &line(headings.map(|_| String::from("---")));
        for row in rows {
            self.text += &line(row);
        }
    }

    /// Records a failure unless `holds`.
    pub(crate) fn claim(&mut self, holds: bool, what: impl Display) {
        if !holds {
            self.failures.push(what.to_string());
        }
    }

    /// Compares with the page in the repository, and writes the new page.
    pub(crate) fn finish(mut self) -> ExitCode {
        self.claim(
            words(&self.before) == words(&self.text),
            format_args!("{FILE} had other words: it is to be committed anew"),
        );
        if let Err(error) = std::fs::write(sources::root().join(FILE), &self.text) {
            self.failures.push(format!("{FILE}: {error}"));
        }
        for failure in &self.failures {
            eprintln!("does not hold: {failure}");
        }
        if self.failures.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }
}

/// Returns a text without measured numbers: those with a point or an exponent.
fn words(text: &str) -> String {
    let is_measured = |word: &&str| word.parse::<f64>().is_ok() && word.contains(['.', 'e']);
    let words = text.split_whitespace().map(|word| word.trim_end_matches([',', ';']));
    words.filter(|word| !is_measured(word)).collect::<Vec<_>>().join(" ")
}

/// Writes a number with two digits.
#[cfg(not(debug_assertions))]
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
