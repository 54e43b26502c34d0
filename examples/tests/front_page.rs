//! Pages for readers name examples, figures and folders that exist.

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("")
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

#[test]
fn every_example_is_listed_run_and_shown() {
    let (page, manifest) = (read("examples/README.md"), read("examples/Cargo.toml"));
    for file in fs::read_dir(root().join("examples/src/bin")).unwrap() {
        let name = file.unwrap().file_name().into_string().unwrap();
        let example = name.trim_end_matches(".rs");
        assert!(manifest.contains(&format!("name = \"{example}\"")), "{example} is no example in the manifest");
        assert!(page.contains(&format!("(src/bin/{name})")), "{example} is not in the list");
    }
    assert!(page.contains("--example NAME\n"), "the command that runs an example is missing");
    for file in fs::read_dir(root().join("examples/figures")).unwrap() {
        let name = file.unwrap().file_name().into_string().unwrap();
        assert!(page.contains(&format!("](figures/{name})")), "{name} is neither shown nor linked");
    }
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
