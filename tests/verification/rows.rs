//! Nothing is claimed without a row in `VERIFICATION.md`. The program that writes the page says so without measuring anew where it is not optimised.

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
