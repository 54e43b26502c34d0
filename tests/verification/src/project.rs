//! The files of the project, as texts.

use crate::sources;
use std::collections::BTreeMap;

/// Folders whose files are read.
const FOLDERS: [&str; 4] = ["tests", "examples", "geoint-macros/compiler/src", "geoint-runtime/src"];

/// Files by their paths from the root of the workspace.
#[derive(Debug, Default)]
pub struct Project(BTreeMap<String, String>);

impl Project {
    /// Reads the project that this crate belongs to.
    ///
    /// # Panics
    /// If a file cannot be read.
    pub fn here() -> Self {
        let manifests = ["tests/Cargo.toml".to_owned()];
        let paths = FOLDERS.iter().flat_map(|folder| sources::below(folder)).chain(manifests);
        Project(paths.map(|path| (path.clone(), sources::read(&path))).collect())
    }

    /// Returns a project of these paths and texts.
    pub fn of(files: &[(&str, &str)]) -> Self {
        Project(files.iter().map(|(path, text)| ((*path).to_owned(), (*text).to_owned())).collect())
    }

    /// Returns the text of a file, if there is one.
    pub fn read(&self, path: &str) -> Option<&str> {
        self.0.get(path).map(String::as_str)
    }

    /// Returns the files below a folder with their texts, in order.
    pub fn below(&self, folder: &str) -> impl Iterator<Item = (&str, &str)> {
        let folder = format!("{folder}/");
        let files = self.0.iter().filter(move |(path, _)| path.starts_with(&folder));
        files.map(|(path, text)| (path.as_str(), text.as_str()))
    }
}
