//! Builds of a target of this package in any checkout, by the cargo that runs the benchmark.

use anyhow::{Context, Result, ensure};
use serde::Deserialize;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A line of cargo's report in JSON about a compiled target. Lines of other kinds have other fields.
#[derive(Deserialize)]
struct Artifact {
    target: Target,
    filenames: Vec<PathBuf>,
    executable: Option<PathBuf>,
}

#[derive(Deserialize)]
struct Target {
    name: String,
}

/// A checkout and the folder for its build.
pub(crate) struct Build<'a> {
    pub(crate) checkout: &'a Path,
    pub(crate) target_folder: &'a Path,
    /// Options of rustc beside those of the environment.
    pub(crate) flags: &'a str,
}

impl Build<'_> {
    /// Compiles a bench and returns its executable.
    pub(crate) fn bench(&self, name: &str) -> Result<PathBuf> {
        let artifact = self.compile(&["bench", "--no-run", "--bench", name], &[], name)?;
        artifact.executable.with_context(|| format!("cargo names no executable of `{name}`"))
    }

    /// Compiles an example of the crate type `lib` in one unit of code, and returns the library.
    pub(crate) fn library(&self, name: &str) -> Result<PathBuf> {
        let artifact = self.compile(&["rustc", "--release", "--example", name], &["--", "-Ccodegen-units=1"], name)?;
        let is_library = |file: &PathBuf| file.extension().is_some_and(|extension| extension == "rlib");
        artifact.filenames.into_iter().find(is_library).with_context(|| format!("cargo names no library of `{name}`"))
    }

    fn compile(&self, arguments: &[&str], for_rustc: &[&str], name: &str) -> Result<Artifact> {
        let mut command = cargo();
        command.current_dir(self.checkout).args(arguments).args(["-p", "geoint-benches"]);
        command.arg("--target-dir").arg(self.target_folder).arg("--message-format=json-render-diagnostics");
        command.args(for_rustc).stderr(Stdio::inherit());
        if !self.flags.is_empty() {
            command.env("RUSTFLAGS", [&std::env::var("RUSTFLAGS").unwrap_or_default(), self.flags].join(" "));
        }
        let output = command.output().context("cargo does not start")?;
        ensure!(output.status.success(), "`{name}` does not compile in {}", self.checkout.display());
        String::from_utf8(output.stdout)?
            .lines()
            .filter_map(|line| serde_json::from_str::<Artifact>(line).ok())
            .find(|artifact| artifact.target.name == name)
            .with_context(|| format!("cargo does not report `{name}`"))
    }
}

/// The cargo that runs this benchmark.
fn cargo() -> Command {
    Command::new(std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo")))
}

/// The root of this checkout.
pub(crate) fn own_checkout() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// The target folder into which cargo has built this program.
pub(crate) fn own_target_folder() -> &'static Path {
    // Cargo names a subfolder of the target folder, whatever option or variable chose it.
    Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("a subfolder of the target folder")
}
