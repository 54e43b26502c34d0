//! Checks that all rows exist. Each list of the catalogue needs a table. Each name that a method gives itself, and each function that users may write,
//! needs a row.

use crate::page::Page;
use geoint_verification::sources;

/// Names of tables that users make.
const OF_USERS: [&str; 2] = ["Splitting", "RungeKutta"];
/// Lists that are made of others.
const OF_OTHERS: [&str; 2] = ["conservative", "autonomous"];

/// Reports all subjects in the sources that have no row.
pub(crate) fn complete(page: &mut Page) {
    let catalogue = sources::read("geoint-runtime/src/method/catalogue.rs");
    let text = page.text().to_owned();
    for (function, _) in catalogue.lines().filter_map(|line| line.strip_prefix("pub fn ")?.split_once('<')) {
        let shown = OF_OTHERS.contains(&function) || text.contains(&format!("\n### `catalogue::{function}`\n"));
        page.claim(shown, format_args!("catalogue::{function} has no table"));
    }
    let rows = text.lines().filter_map(|line| Some(line.strip_prefix("| `")?.split_once('`')?.0));
    let words: Vec<&str> = rows.flat_map(|name| name.split(" of ")).collect();
    // Functions of users have a formula in the table of the compiler. Helpers have none.
    let functions = sources::read("geoint-macros/compiler/src/ir/op.rs");
    let written = functions.lines().filter(|line| {
        line.starts_with("    ") && line.ends_with(");") && (line.contains(", x.") || line.contains(", y."))
    });
    for name in written.filter_map(|line| line.split_whitespace().nth(1)?.split('(').next()) {
        page.claim(words.contains(&name), format_args!("the function {name} has no row"));
    }
    let folder = "geoint-runtime/src/method";
    for path in sources::below(folder) {
        let text = sources::read(&path);
        // Methods in comments are examples.
        let code = text.split("#[cfg(test)]").next().unwrap_or_default();
        let code: String = code.lines().filter(|line| !line.starts_with("//")).flat_map(|line| [line, "\n"]).collect();
        let after = |start: &str, end: char| -> Vec<String> {
            code.split(start).skip(1).filter_map(|rest| Some(rest.split_once(end)?.0.to_owned())).collect()
        };
        let tables = if path.starts_with(&format!("{folder}/tables/")) { after("\npub const ", ':') } else { vec![] };
        let literal =
            [after("Name::new(\"", '"'), after("Name::new(stringify!(", ')'), after(".named(\"", '"')].concat();
        for name in tables.into_iter().chain(literal).filter(|name| !name.starts_with('$')) {
            let known = words.contains(&name.as_str()) || OF_USERS.contains(&name.as_str());
            page.claim(known, format_args!("{name}, of {path}, has no row"));
        }
    }
}
