//! The page.

use super::{Section, chaos, done, encounters, scale, stiff, sums};
use std::fmt::Write;

const INTRODUCTION: &str = "# Stress

```text
cargo test --release -p geoint-tests --test stress -- --ignored           # all, and this page
STRESS=chaos cargo test --release -p geoint-tests --test stress -- --ignored --nocapture   # sections with this in their title, printed
```

Runs that are hard. A run ends at its time, or is refused, with the last good state kept; a row whose numbers are not as its section says fails.
A short part of each section is in every `cargo test`. Elsewhere: hostile input to every method of the lists (`tests/stability/hostile.rs`), the same
bits after saving and resuming (`tests/stability/saved.rs`) and on other processors (`tests/bits.rs`), every method for 10⁵ steps of `f32`
(`tests/builds/single.rs`).
";

/// All sections, written down; rows that fail are named.
#[test]
#[ignore = "some 20 minutes"]
fn the_page() {
    let chosen = std::env::var("STRESS").unwrap_or_default();
    let sections = [
        encounters::kepler(),
        encounters::bodies(),
        chaos::galaxy(),
        chaos::double_pendulum(),
        stiff::spring(),
        stiff::van_der_pol(),
        stiff::frequencies(),
        scale::units(),
        scale::places(),
        scale::single(),
        sums::growth(),
    ];
    let (mut text, mut failures) = (String::from(INTRODUCTION), vec![]);
    for Section { title, text: about, head, jobs } in sections {
        if !title.to_lowercase().contains(&chosen.to_lowercase()) {
            continue;
        }
        let rows = done(jobs);
        let _ = write!(text, "\n## {title}\n\n{about}\n\n| {} |\n|{}\n", head.join(" | "), "---|".repeat(head.len()));
        for row in rows {
            let _ = writeln!(text, "| {} |", row.cells.join(" | "));
            failures.extend(row.failure.map(|failure| format!("{title}: {failure}")));
        }
    }
    if chosen.is_empty() {
        std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/stress/README.md"), &text).expect("the page");
    } else {
        println!("{text}");
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
