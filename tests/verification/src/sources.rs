//! The sources of the project, in which what needs a row is looked up.

use std::fs;
use std::path::{Path, PathBuf};

/// The folder of the workspace.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
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

/// Whether all that a page names in backticks as a test, or as a file, is there: `folder::test`, `folder/file.rs`.
pub(crate) fn missing(page: &str) -> Vec<String> {
    let text = read(page);
    let named = text.split('`').skip(1).step_by(2).filter(|name| name.contains('/'));
    let there = |name: &str| if name.contains("::") { is_test(name) } else { root().join(name).is_file() };
    named.filter(|name| !there(name)).map(ToOwned::to_owned).collect()
}

/// Whether `folder::test` names a function in a file below a folder.
pub(crate) fn is_test(place: &str) -> bool {
    let Some((folder, test)) = place.rsplit_once("::") else { return false };
    let names = [format!("fn {test}("), format!("{test}:"), format!("{{ {test},")];
    below(folder).iter().any(|path| {
        let text = read(path);
        names.iter().any(|name| text.contains(name))
    })
}
