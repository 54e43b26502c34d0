//! Every claim has a row in `VERIFICATION.md`, and every statement of `tests/STATEMENTS.md` has tests. Without optimisation nothing is measured.

use geoint_verification::project::Project;
use geoint_verification::sources;
use geoint_verification::statements::Names;
use std::process::Command;

#[test]
#[cfg_attr(not(debug_assertions), ignore = "measures for minutes: `.ci/verification`")]
fn every_claim_has_a_row() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    let output = Command::new(env!("CARGO_BIN_EXE_geoint-verification"))
        .current_dir(folder)
        .output()
        .expect("the program starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn every_statement_names_what_exists() {
    let project = Project::here();
    let faults = Names::of(&project).faults(&sources::read("tests/STATEMENTS.md"));
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
