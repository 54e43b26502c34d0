//! The page.

use super::{Section, chaos, done, encounters, scale, stiff, sums};
use std::fmt::Write;
use std::path::{Path, PathBuf};

const INTRODUCTION: &str = "# Stress

```text
cargo test --profile bench -p geoint-tests --test stress -- --ignored           # all, and this page
STRESS=chaos cargo test --profile bench -p geoint-tests --test stress -- --ignored --nocapture   # sections with this in their title, anew
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
    let chosen = std::env::var("STRESS").unwrap_or_default().to_lowercase();
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
    let target = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    let target = target.unwrap_or(Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("target"));
    let folder = target.join("geoint/stress");
    std::fs::create_dir_all(&folder).expect("the folder of sections");
    let (mut text, mut failures) = (String::from(INTRODUCTION), vec![]);
    for (number, Section { title, text: about, head, jobs }) in sections.into_iter().enumerate() {
        let file = folder.join(format!("{number}.md"));
        if title.to_lowercase().contains(&chosen) {
            let mut part =
                format!("\n## {title}\n\n{about}\n\n| {} |\n|{}\n", head.join(" | "), "---|".repeat(head.len()));
            for row in done(jobs) {
                let _ = writeln!(part, "| {} |", row.cells.join(" | "));
                failures.extend(row.failure.map(|failure| format!("{title}: {failure}")));
            }
            std::fs::write(&file, part).expect("the section");
        }
        text += &std::fs::read_to_string(&file).unwrap_or_default();
    }
    std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/stress/README.md"), &text).expect("the page");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
