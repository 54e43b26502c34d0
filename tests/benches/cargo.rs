//! Builds of benchmarks in any checkout, by the cargo that runs the benchmark.

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

impl Artifact {
    fn library(self) -> Result<PathBuf> {
        let is_library = |file: &PathBuf| file.extension().is_some_and(|extension| extension == "rlib");
        let name = self.target.name;
        self.filenames.into_iter().find(is_library).with_context(|| format!("cargo names no library of `{name}`"))
    }
}

#[derive(Deserialize)]
struct Target {
    name: String,
}

/// A checkout and the folder for its build.
pub(crate) struct Build<'a> {
    pub(crate) checkout: &'a Path,
    pub(crate) target_folder: &'a Path,
}

impl Build<'_> {
    /// Compiles a bench of this package and returns its executable.
    pub(crate) fn bench(&self, name: &str) -> Result<PathBuf> {
        let artifact = self.compile(&["bench", "--no-run", "-p", "geoint-benches", "--bench", name], &[], name)?;
        artifact.executable.with_context(|| format!("cargo names no executable of `{name}`"))
    }

    /// Compiles an example of this package, of the crate type `lib`, in one unit of code, and returns the library.
    pub(crate) fn library(&self, name: &str) -> Result<PathBuf> {
        let arguments = ["rustc", "--release", "-p", "geoint-benches", "--example", name];
        self.compile(&arguments, &["-Ccodegen-units=1"], name)?.library()
    }

    /// Compiles the runtime with these options of rustc and returns the library.
    pub(crate) fn runtime(&self, options: &[&str]) -> Result<PathBuf> {
        let arguments = ["rustc", "--release", "-p", "geoint-runtime", "--lib", "--features", "std,alloc"];
        self.compile(&arguments, options, "geoint_runtime")?.library()
    }

    fn compile(&self, arguments: &[&str], for_rustc: &[&str], name: &str) -> Result<Artifact> {
        let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo")));
        command.current_dir(self.checkout).args(arguments).stderr(Stdio::inherit());
        command.arg("--target-dir").arg(self.target_folder).arg("--message-format=json-render-diagnostics");
        if !for_rustc.is_empty() {
            command.arg("--").args(for_rustc);
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

/// Returns the root of this checkout.
pub(crate) fn own_checkout() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// Returns the target folder of this program.
pub(crate) fn own_target_folder() -> &'static Path {
    // Cargo names a subfolder of the target folder, whatever option or variable chose it.
    Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("a subfolder of the target folder")
}
