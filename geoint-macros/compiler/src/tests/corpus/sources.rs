//! Finds the Rust code of the repository: source files, and code blocks of Markdown pages and doc comments.

use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag, TagEnd};
use std::path::{Path, PathBuf};
use walkdir::WalkDir;

/// The root of the workspace.
pub(super) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("the crate is two folders below the workspace")
}

/// Returns the paths of all Rust files and Markdown pages below the root of the workspace, sorted.
///
/// Leaves out build output, hidden folders and symbolic links.
pub(super) fn files() -> Vec<PathBuf> {
    let entries = WalkDir::new(root()).sort_by_file_name().into_iter().filter_entry(|entry| {
        let name = entry.file_name().to_string_lossy();
        entry.depth() == 0 || !(name.starts_with('.') || name == "target")
    });
    let files = entries.map(|entry| entry.expect("a readable folder")).filter(|entry| entry.file_type().is_file());
    let paths = files.map(|entry| entry.path().strip_prefix(root()).expect("a path below the root").to_owned());
    paths.filter(|path| path.extension().is_some_and(|extension| extension == "rs" || extension == "md")).collect()
}

/// Returns the code blocks of a text that rustdoc takes for Rust, with their hidden lines.
pub(super) fn code_blocks(markdown: &str) -> Vec<String> {
    let mut blocks = vec![];
    let mut block: Option<String> = None;
    for event in Parser::new(markdown) {
        match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) if is_rust(&info) => block = Some(String::new()),
            Event::Text(text) => block.iter_mut().for_each(|block| block.push_str(&text)),
            Event::End(TagEnd::CodeBlock) => blocks.extend(block.take()),
            _ => {}
        }
    }
    blocks.iter().map(|block| block.lines().map(shown).collect::<Vec<_>>().join("\n")).collect()
}

/// Returns whether a code block is Rust. Its first word is `rust`, an attribute of rustdoc, or missing.
fn is_rust(info: &str) -> bool {
    let first = info.split([',', ' ']).next().unwrap_or_default();
    matches!(first, "" | "rust" | "no_run" | "should_panic" | "compile_fail" | "ignore" | "standalone_crate")
}

/// Removes the mark of a hidden line: `# use …` becomes `use …`, and `##` becomes `#`.
fn shown(line: &str) -> &str {
    let line = line.trim_start();
    match line.strip_prefix('#') {
        Some("") => "",
        Some(rest) if rest.starts_with('#') => rest,
        Some(rest) => rest.strip_prefix(' ').unwrap_or(line),
        None => line,
    }
}

/// Returns whether a text has the name of an attribute. Other texts need no scan.
pub(super) fn mentions_attribute(text: &str) -> bool {
    ["hamiltonian", "lagrangian", "vector_field", "energy_function"].iter().any(|name| text.contains(name))
}
