//! The files of the project.

use std::fs;
use std::path::{Path, PathBuf};

/// The folder of the project, and whether files in it may be written.
pub(crate) struct Project {
    root: PathBuf,
    check: bool,
}

impl Project {
    pub(crate) fn new(check: bool) -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        Project { root: root.canonicalize().unwrap_or(root), check }
    }

    /// Returns the text of a file.
    pub(crate) fn read(&self, path: &str) -> Result<String, String> {
        fs::read_to_string(self.root.join(path)).map_err(|error| format!("{path}: {error}"))
    }

    /// Writes a generated file, or returns an error if it differs and is only checked.
    pub(crate) fn write(&self, path: &str, text: &str) -> Result<(), String> {
        if self.read(path).is_ok_and(|old| old == text) {
            return Ok(());
        }
        if self.check {
            return Err(format!("{path} is not as it would be written: run `cargo run -p geoint-pages`"));
        }
        fs::write(self.root.join(path), text).map_err(|error| format!("{path}: {error}"))
    }

    /// Returns whether a file or folder exists.
    pub(crate) fn has(&self, path: &str) -> bool {
        self.root.join(path).exists()
    }

    /// Returns the paths of all files below a folder whose names end in `ending`, sorted.
    pub(crate) fn files(&self, folder: &str, ending: &str) -> Vec<String> {
        let mut found = vec![];
        let mut open = vec![folder.to_owned()];
        while let Some(folder) = open.pop() {
            for entry in fs::read_dir(self.root.join(&folder)).into_iter().flatten().flatten() {
                let name = entry.file_name().to_string_lossy().into_owned();
                let path = if folder.is_empty() { name.clone() } else { format!("{folder}/{name}") };
                let is_link = entry.file_type().is_ok_and(|kind| kind.is_symlink());
                if is_link || name.starts_with('.') || name == "target" {
                    continue;
                }
                if entry.path().is_dir() {
                    open.push(path);
                } else if name.ends_with(ending) {
                    found.push(path);
                }
            }
        }
        found.sort();
        found
    }
}
