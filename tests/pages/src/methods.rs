//! The table of all methods, from the measured page VERIFICATION.md.

use crate::project::Project;

/// The page that `cargo run --release -p geoint-verification` writes.
const MEASURED: &str = "VERIFICATION.md";

/// Tables of compositions, which every symmetric map has.
const COMPOSITIONS: [&str; 7] =
    ["Yoshida4", "Suzuki4", "McLachlan4", "Yoshida6a", "McLachlan6_9", "KahanLi8_17a", "SofroniouSpaletta10_35"];

const HEAD: &str = "Each list is a function of [`catalogue`](crate::method::catalogue) and needs the stated property. *Forces* is the number of \
                    evaluations of the force in a step; implicit steps have none. VERIFICATION.md has the measured orders and errors.\n\n\
                    Every symmetric method also has compositions of higher order, as `Suzuki4.of(StormerVerlet)`: `Yoshida4`, `Suzuki4` and \
                    `McLachlan4` of order 4, `Yoshida6a` and `McLachlan6_9` of order 6, `KahanLi8_17a` of order 8, `SofroniouSpaletta10_35` of order 10. \
                    They are symmetric and have the invariants of the map.\n";

/// Returns the table: for each list of the catalogue its methods with order, structure and cost.
pub(crate) fn table(project: &Project) -> Result<String, String> {
    let page = project.read(MEASURED)?;
    let mut text = HEAD.to_owned();
    let mut methods = 0;
    for list in page.split("\n### `catalogue::").skip(1) {
        let list = list.split("\n## ").next().unwrap_or(list);
        let list = list.split("\n### ").next().unwrap_or(list);
        let (name, rest) = list.split_once('`').ok_or("a heading of VERIFICATION.md does not end")?;
        let about = rest.trim_start().split(" On ").next().unwrap_or_default();
        let rows: Vec<Vec<&str>> = rest.lines().filter(|line| line.starts_with('|')).map(cells).collect();
        let Some((head, rows)) = rows.split_first() else { continue };
        let column = |name: &str| head.iter().position(|cell| *cell == name);
        let (Some(method), Some(order)) = (column("method"), column("order")) else { continue };
        text += &format!(
            "\n# `{name}`\n\n{about}\n\n| method | order | symmetric | keeps its form | keeps the energy | forces |\n|---|---|---|---|---|---|\n"
        );
        let is_composed = |name: &str| COMPOSITIONS.iter().any(|table| name.starts_with(&format!("`{table} of")));
        for row in rows.iter().filter(|row| row[method].starts_with('`') && !is_composed(row[method])) {
            let claim = |name: &str| column(name).map_or("–", |i| row[i].split(',').next().unwrap_or("–"));
            let forces = claim("cost; allocations").split(';').next().unwrap_or("–");
            let forces = if forces.parse::<u32>().is_ok() { forces } else { "–" };
            let [symmetric, form, energy] = ["symmetric", "form", "energy"].map(claim);
            text += &format!("| {} | {} | {symmetric} | {form} | {energy} | {forces} |\n", row[method], row[order]);
            methods += 1;
        }
    }
    if methods < 60 { Err(format!("{MEASURED} has only {methods} methods")) } else { Ok(text) }
}

fn cells(row: &str) -> Vec<&str> {
    row.trim_matches('|').split('|').map(str::trim).collect()
}
