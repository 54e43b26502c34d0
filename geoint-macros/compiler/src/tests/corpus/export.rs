//! Writes expansions as formatted Rust files, for reading.

use super::comparison::Entry;
use super::sources::root;
use proc_macro2::TokenStream;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// Returns the empty folder that `EXPANSIONS` names, in the target folder of cargo.
pub(super) fn folder() -> Option<PathBuf> {
    let name = env::var_os("EXPANSIONS")?;
    let target = root().join(env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()));
    let folder = target.join("geoint/expansions").join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("expansions of an earlier run are removed");
    }
    Some(folder)
}

/// Writes an expansion to a file below a folder: `PATH/NAME.rs`, with a folder for each module.
pub(super) fn write(folder: &Path, entry: &Entry, tokens: &TokenStream) {
    let file = folder.join(&entry.path).join(entry.name.replace("::", "/") + ".rs");
    fs::create_dir_all(file.parent().expect("a path with a folder")).expect("a folder for expansions");
    fs::write(file, formatted(tokens)).expect("an expansion is written");
}

/// Returns formatted code. A refused method is no file of Rust, and stays as it is.
fn formatted(tokens: &TokenStream) -> String {
    syn::parse2(tokens.clone()).map_or_else(|_| tokens.to_string(), |file| prettyplease::unparse(&file))
}
