//! Paths of output files, and errors for claims that are false.

use std::env;
use std::error::Error;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Returns the path of the output file `name` in the folder `geoint` of cargo's target directory. The name may contain a subfolder.
/// Missing folders are created.
///
/// # Errors
/// If a folder cannot be created.
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

/// Returns a path relative to the current directory, if the path is below this directory.
pub fn shown(path: &Path) -> String {
    let here = env::current_dir().unwrap_or_default();
    path.strip_prefix(here).unwrap_or(path).display().to_string()
}

/// Prints the claim `words` if it is true. A program with a false claim fails.
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
