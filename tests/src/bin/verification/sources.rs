//! The sources of the project, in which what needs a row is looked up.

use std::fs;
use std::path::{Path, PathBuf};

/// The folder of the workspace.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("")
}

/// The text of a file.
///
/// # Panics
/// If there is none: then a table of this program names a file that is gone.
pub(crate) fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// All files of Rust below a folder, by their paths from the root, in order.
pub(crate) fn below(folder: &str) -> Vec<String> {
    let mut found = vec![];
    for entry in fs::read_dir(root().join(folder)).unwrap_or_else(|error| panic!("{folder}: {error}")).flatten() {
        let path = format!("{folder}/{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            found.extend(below(&path));
        } else if path.ends_with(".rs") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// Whether `path::test` names a file below the root and a function in it.
pub(crate) fn is_test(place: &str) -> bool {
    place.rsplit_once("::").is_some_and(|(path, test)| {
        let text = fs::read_to_string(root().join(path)).unwrap_or_default();
        [format!("fn {test}("), format!("{test}:"), format!("{{ {test},")].iter().any(|text_of| text.contains(text_of))
    })
}
