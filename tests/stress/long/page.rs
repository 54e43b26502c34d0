//! Writes the page.

use super::{Part, Row, Section, chaos, done, encounters, scale, stiff, sums};
use std::fmt::Write;
use std::path::{Path, PathBuf};

const INTRODUCTION: &str = "# Stress

```text
cargo test --profile bench -p geoint-tests --test stress -- --ignored           # all, and this page
STRESS=chaos cargo test --profile bench -p geoint-tests --test stress -- --ignored --nocapture   # sections with this title
```

Hard runs. Each run ends at its time, or is refused and keeps the last good state. Tables show the largest error of the energy, unless the text
names another quantity. A row outside the bounds of its section fails. `target/geoint/stress` has the complete tables, with steps and reasons of
refusals. A short part of each section runs in every `cargo test`.
";

fn table(head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut text = format!("\n| {} |\n|{}\n", head.join(" | "), "---|".repeat(head.len()));
    for row in rows {
        let _ = writeln!(text, "| {} |", row.join(" | "));
    }
    text
}

impl Part {
    /// Returns this part of the table. The last column of a table with refusals describes the end of a run.
    fn table(&self, head: &[&str], rows: &[Row]) -> String {
        let value = |cells: &[String], column: usize| {
            let refused = cells.last().is_some_and(|end| end.starts_with("refused"));
            if refused { "refused".into() } else { cells[column].clone() }
        };
        let rows = rows.iter().map(|row| &row.cells[..]);
        match self {
            Part::Columns(columns, chosen) => {
                let (last, first) = columns.split_last().expect("columns");
                let head: Vec<_> = columns.iter().map(|column| head[*column]).collect();
                let rows = rows.filter(|cells| chosen(cells)).map(|cells| {
                    first.iter().map(|column| cells[*column].clone()).chain([value(cells, *last)]).collect()
                });
                table(&head, rows)
            }
            Part::Pivot { row, by, cells: columns, value: from, chosen } => {
                let mut lines: Vec<Vec<String>> = vec![];
                for cells in rows.filter(|cells| chosen(cells)) {
                    let Some(column) = columns.iter().position(|column| *column == cells[*by]) else { continue };
                    if !lines.iter().any(|line| line[0] == cells[*row]) {
                        let empty = columns.iter().map(|_| String::new());
                        lines.push([cells[*row].clone()].into_iter().chain(empty).collect());
                    }
                    let line = lines.iter_mut().find(|line| line[0] == cells[*row]).expect("a line");
                    line[column + 1] = value(cells, *from);
                }
                let mut titles: Vec<String> = columns.iter().map(|column| column.to_string()).collect();
                if !head[*by].is_empty() {
                    titles[0] = format!("{}: {}", head[*by], titles[0]);
                }
                let head: Vec<_> = [head[*row]].into_iter().chain(titles.iter().map(String::as_str)).collect();
                table(&head, lines)
            }
        }
    }
}

/// Runs all sections, and writes complete tables and the page. Names the rows that fail.
#[test]
#[ignore = "some 20 minutes"]
fn the_page() {
    let chosen = std::env::var("STRESS").unwrap_or_default().to_lowercase();
    let sections = [
        encounters::kepler(),
        encounters::bodies(),
        chaos::chaos(),
        stiff::spring(),
        stiff::van_der_pol(),
        stiff::frequencies(),
        scale::scale(),
        sums::growth(),
    ];
    let target = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    let target = target.unwrap_or(Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("target"));
    let folder = target.join("geoint/stress");
    std::fs::create_dir_all(&folder).expect("the folder of sections");
    let (mut text, mut failures) = (String::from(INTRODUCTION), vec![]);
    for (number, Section { title, text: about, head, part, jobs }) in sections.into_iter().enumerate() {
        let file = folder.join(format!("{number}_page.md"));
        if title.to_lowercase().contains(&chosen) {
            let rows = done(jobs);
            let opening = format!("\n## {title}\n\n{about}\n");
            let complete = table(head, rows.iter().map(|row| row.cells.clone()));
            std::fs::write(folder.join(format!("{number}.md")), format!("{opening}{complete}")).expect("the section");
            std::fs::write(&file, format!("{opening}{}", part.table(head, &rows))).expect("its part on the page");
            let failed = rows.into_iter().filter_map(|row| row.failure);
            failures.extend(failed.map(|failure| format!("{title}: {failure}")));
        }
        text += &std::fs::read_to_string(&file).unwrap_or_default();
    }
    std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/stress/README.md"), &text).expect("the page");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
