//! The checkout of an earlier revision, as the reference of a comparison.
//!
//! Folder: `target/geoint/reference/<revision>`. The checkout and its build are kept for the next comparison.

use crate::cargo::{own_checkout, own_target_folder};
use anyhow::{Context, Result, ensure};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The state before the redesign.
pub(crate) const DEFAULT: &str = "4fb39fceb44157293724df1b2dc789a5a4f5743e";

/// The folder of the benchmarks in a checkout.
const BENCHES: &str = "tests/benches";

/// The file by which a revision is known to have a ledger.
const LEDGER: &str = "tests/benches/ledger/main.rs";

/// Returns a checkout of a revision that has a ledger: its own, or the benchmarks of this checkout laid over its tree.
pub(crate) fn checkout(revision: &str) -> Result<PathBuf> {
    let commit = format!("{revision}^{{commit}}");
    let hash = git(&["rev-parse", "--verify", &commit], None)
        .with_context(|| format!("the revision {revision} is not in the repository of this checkout"))?;
    let folder = own_target_folder().join("geoint/reference").join(&hash);
    if !folder.exists() {
        // An incomplete checkout has another name.
        let part = folder.with_extension("part");
        if part.exists() {
            fs::remove_dir_all(&part)?;
        }
        fs::create_dir_all(&part)?;
        let index = part.join("index");
        git(&["read-tree", &hash], Some(&index))?;
        git(&["checkout-index", "--all", &format!("--prefix={}/", part.display())], Some(&index))?;
        fs::remove_file(index)?;
        fs::rename(part, &folder)?;
    }
    if git(&["cat-file", "-e", &format!("{hash}:{LEDGER}")], None).is_err() {
        lay_over(&own_checkout().join(BENCHES), &folder.join(BENCHES))?;
        lay_over(&own_checkout().join("Cargo.lock"), &folder.join("Cargo.lock"))?;
    }
    Ok(folder)
}

/// Runs git in this checkout, with a separate index if `index` names a file, and returns the output.
fn git(arguments: &[&str], index: Option<&Path>) -> Result<String> {
    let mut command = Command::new("git");
    command.current_dir(own_checkout()).args(arguments);
    if let Some(index) = index {
        command.env("GIT_INDEX_FILE", index);
    }
    let output = command.output().context("git does not start")?;
    ensure!(
        output.status.success(),
        "`git {}` failed: {}",
        arguments[0],
        String::from_utf8_lossy(&output.stderr).trim()
    );
    Ok(String::from_utf8(output.stdout)?.trim().into())
}

/// Copies a file or a folder. Equal files keep their times, so that cargo does not compile again.
fn lay_over(from: &Path, to: &Path) -> Result<()> {
    if from.is_dir() {
        fs::create_dir_all(to)?;
        for entry in fs::read_dir(from)? {
            let name = entry?.file_name();
            lay_over(&from.join(&name), &to.join(&name))?;
        }
    } else {
        let content = fs::read(from)?;
        if fs::read(to).ok().as_ref() != Some(&content) {
            fs::write(to, content)?;
        }
    }
    Ok(())
}
