//! A build of the steps with one accelerator switched off.

use crate::cargo::{Build, own_checkout, own_target_folder};
use anyhow::{Context, Result, ensure};
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::Command;

/// Compiles the steps without an accelerator, or the complete runtime, and returns the program.
///
/// Cargo passes the switch to the runtime alone. A switch in `RUSTFLAGS` would compile all dependencies once more for each variant.
pub(crate) fn compile(without: Option<&str>) -> Result<PathBuf> {
    let folder = own_target_folder().join("geoint/ablation");
    let build = Build { checkout: own_checkout(), target_folder: &folder };
    let switch = without.map(|name| format!("--cfg=geoint_without=\"{name}\""));
    let options: Vec<&str> = switch.iter().map(String::as_str).collect();
    let runtime = build.runtime(&options)?;

    let program = folder.join(format!("steps-{}{}", without.unwrap_or("complete"), std::env::consts::EXE_SUFFIX));
    let mut rustc = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| OsString::from("rustc")));
    // The options of the release profile, and those of the user.
    rustc.args(["--edition=2024", "--crate-name=ablation_steps", "-Copt-level=3"]);
    rustc.args(std::env::var("RUSTFLAGS").unwrap_or_default().split_whitespace());
    rustc.arg(format!("-Ldependency={}", folder.join("release/deps").display()));
    rustc.arg(format!("--extern=geoint_runtime={}", runtime.display()));
    rustc.arg(own_checkout().join("tests/benches/ablation/steps/main.rs")).arg("-o").arg(&program);
    // The attributes look up the name of the runtime in the manifest of this package.
    let status =
        rustc.env("CARGO_MANIFEST_DIR", env!("CARGO_MANIFEST_DIR")).status().context("rustc does not start")?;
    ensure!(status.success(), "the steps do not compile without {}", without.unwrap_or("nothing"));
    Ok(program)
}
