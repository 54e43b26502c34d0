//! Where files go, and what happens when a program does not keep its word.

use std::env;
use std::error::Error;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// The path of the output file `name`, in the folder `geoint` of cargo's target directory, or in one below it that the name has; folders are
/// made if need be.
///
/// # Errors
/// If a folder cannot be made.
pub fn output(name: &str) -> io::Result<PathBuf> {
    let target = match env::var_os("CARGO_TARGET_DIR") {
        Some(target) => PathBuf::from(target),
        None => Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("target"),
    };
    let folder = target.join("geoint");
    let path = folder.join(name);
    fs::create_dir_all(&folder)?;
    fs::create_dir_all(path.parent().unwrap_or(&folder))?;
    Ok(path)
}

/// A path as short as it can be said from the current directory.
pub fn shown(path: &Path) -> String {
    let here = env::current_dir().unwrap_or_default();
    path.strip_prefix(here).unwrap_or(path).display().to_string()
}

/// An error that quotes `words` unless they hold: the programs fail when what they print is not true.
///
/// # Errors
/// If `holds` is false.
pub fn claim(words: &str, holds: bool) -> Result<(), Box<dyn Error>> {
    if !holds {
        return Err(format!("this did not hold: {words}").into());
    }
    println!("- {words}");
    Ok(())
}
