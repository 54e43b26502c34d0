//! Writes expansions as formatted Rust files, for reading.

use super::comparison::Entry;
use super::sources::root;
use proc_macro2::TokenStream;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// Writes an expansion to `geoint/expansions/FOLDER/PATH/NAME.rs` in the target folder.
pub(super) fn write(folder: &Path, entry: &Entry, tokens: &TokenStream) {
    let folder = target().join("geoint/expansions").join(folder).join(&entry.path);
    fs::create_dir_all(&folder).expect("a folder for expansions");
    fs::write(folder.join(entry.name.clone() + ".rs"), formatted(tokens)).expect("an expansion is written");
}

/// Returns formatted code. Code that is no file of Rust, such as a refused method, stays as it is.
fn formatted(tokens: &TokenStream) -> String {
    syn::parse2(tokens.clone()).map_or_else(|_| tokens.to_string(), |file| prettyplease::unparse(&file))
}

/// Returns the target folder of cargo.
fn target() -> PathBuf {
    root().join(env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()))
}
