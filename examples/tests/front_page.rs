//! What the front pages say, they say alike, and what they show is there.

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("")
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// A page of the documentation as it stands in the README: code without links, headings one level lower.
fn without_links(page: &str) -> String {
    let mut text = String::new();
    let mut rest = page;
    while let Some((before, link)) = rest.split_once("[`") {
        let (code, after) = link.split_once("`]").expect("a link ends");
        text.push_str(&format!("{before}`{code}`"));
        rest = after.strip_prefix('(').map_or(after, |target| target.split_once(')').expect("a target ends").1);
    }
    text.push_str(rest);
    text.lines().map(|line| if line.starts_with("# ") { format!("#{line}\n") } else { format!("{line}\n") }).collect()
}

#[test]
fn the_readme_has_the_tables_of_the_documentation() {
    let readme = read("README.md");
    for page in ["which_method", "contact", "lagrangians", "flows"] {
        let text = without_links(&read(&format!("geoint-runtime/docs/{page}.md")));
        assert!(
            readme.contains(&text),
            "README.md and geoint-runtime/docs/{page}.md differ; in README.md belongs\n\n{text}"
        );
    }
}

#[test]
fn links_are_taken_away() {
    assert_eq!(without_links("# A\n[`B`] and [`C::<1>`](C), [D](E)"), "## A\n`B` and `C::<1>`, [D](E)\n");
}

#[test]
fn every_example_is_listed_run_and_shown() {
    let (page, manifest) = (read("examples/README.md"), read("examples/Cargo.toml"));
    for file in fs::read_dir(root().join("examples/src/bin")).unwrap() {
        let name = file.unwrap().file_name().into_string().unwrap();
        let example = name.trim_end_matches(".rs");
        assert!(manifest.contains(&format!("name = \"{example}\"")), "{example} is no example in the manifest");
        assert!(page.contains(&format!("(src/bin/{name})")), "{example} is not in the list");
        assert!(page.contains(&format!("--example {example}\n")), "how to run {example} is not said");
    }
    for file in fs::read_dir(root().join("examples/figures")).unwrap() {
        let name = file.unwrap().file_name().into_string().unwrap();
        assert!(page.contains(&format!("](figures/{name})")), "{name} is not shown");
    }
}

#[test]
fn links_of_the_pages_lead_to_files() {
    let pages = [
        ("README.md", ""),
        ("examples/README.md", "examples/"),
        ("CONTRIBUTING.md", ""),
        ("tests/STATEMENTS.md", "tests/"),
        ("tests/benches/README.md", "tests/benches/"),
        ("tests/benches/work_precision/README.md", "tests/benches/work_precision/"),
        ("tests/stress/README.md", "tests/stress/"),
    ];
    for (page, folder) in pages {
        let text = read(page);
        let places: Vec<String> = text.lines().filter(|line| line.starts_with('#')).map(place).collect();
        let targets = text.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|link| link.0);
        for target in targets.filter(|target| !target.contains("://")) {
            let there = match target.strip_prefix('#') {
                Some(within) => places.iter().any(|place| place == within),
                None => root().join(folder).join(target).exists(),
            };
            assert!(there, "{page}: {target} is not there");
        }
    }
}

/// What leads to a heading.
fn place(heading: &str) -> String {
    let words = heading.trim_start_matches('#').trim().to_lowercase();
    let letters = words.chars().filter(|c| c.is_alphanumeric() || [' ', '-', '_'].contains(c));
    letters.map(|c| if c == ' ' { '-' } else { c }).collect()
}

/// Other crates are compiled by the workspace that compares with them, and by nothing else.
#[test]
fn no_rival_is_compiled_by_the_workspace() {
    let manifest = read("tests/rivals/Cargo.toml");
    let (lock, other) = (read("Cargo.lock"), read("tests/rivals/Cargo.lock"));
    for rival in ["ode_solvers", "differential-equations", "diffsol", "scirs2-integrate"] {
        let package = format!("name = \"{rival}\"\n");
        assert!(manifest.contains(&format!("{rival} = ")) && other.contains(&package), "{rival} is compared with");
        assert!(!lock.contains(&package), "{rival} is a dependency of the workspace");
    }
}

/// CONTRIBUTING names files and folders as code.
#[test]
fn paths_of_the_contributing_page_are_true() {
    let page = read("CONTRIBUTING.md");
    let paths = page.split('`').skip(1).step_by(2).filter(|code| code.contains('/') && !code.contains(' '));
    let mut count = 0;
    for path in paths {
        assert!(root().join(path).exists(), "{path} is not there");
        count += 1;
    }
    assert!(count > 5);
}
