//! Values of constants of the standard library. Only full paths and imports count, because the user may define other constants of the same names.

use crate::ir::{Number, Ratio};
use syn::{Path, UseTree};

/// Returns the value of a path such as `std::f64::consts::PI`. `None` if the path could name another constant.
pub(super) fn of_path(path: &Path) -> Option<Number> {
    let segments: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
    let segments: Vec<&str> = segments.iter().map(String::as_str).collect();
    match segments[..] {
        ["std" | "core", "f64" | "f32", "consts", name] | ["f64" | "f32", "consts", name] => of_name(name),
        _ => None,
    }
}

/// A constant that `use` imports.
pub(super) struct Import {
    pub(super) name: String,
    pub(super) value: Number,
    /// Whether the import is `*`. Imports by name have precedence.
    pub(super) is_glob: bool,
}

/// Returns the constants that a `use` imports. `None` if it imports anything else.
pub(super) fn imported(tree: &UseTree) -> Option<Vec<Import>> {
    let mut imports = vec![];
    collect(tree, &mut vec![], &mut imports).map(|()| imports)
}

fn collect(tree: &UseTree, path: &mut Vec<String>, imports: &mut Vec<Import>) -> Option<()> {
    let names: Vec<&str> = path.iter().map(String::as_str).collect();
    let is_inside = matches!(names[..], ["std" | "core", "f64" | "f32", "consts"]);
    let mut one = |known: &str, name: String, is_glob: bool| {
        imports.push(Import { name, value: of_name(known).filter(|_| is_inside)?, is_glob });
        Some(())
    };
    match tree {
        UseTree::Name(name) => one(&name.ident.to_string(), name.ident.to_string(), false),
        UseTree::Rename(name) => one(&name.ident.to_string(), name.rename.to_string(), false),
        UseTree::Glob(_) => CONSTANTS.iter().try_for_each(|(name, _)| one(name, name.to_string(), true)),
        UseTree::Path(step) => {
            path.push(step.ident.to_string());
            let known = collect(&step.tree, path, imports);
            path.pop();
            known
        }
        UseTree::Group(group) => group.items.iter().try_for_each(|tree| collect(tree, path, imports)),
    }
}

/// Returns the value of a constant. Roots are exact, other constants are the nearest `f64`.
fn of_name(name: &str) -> Option<Number> {
    match name {
        "SQRT_2" => Number::integer(2).pow(Ratio::HALF),
        "FRAC_1_SQRT_2" => Number::HALF.pow(Ratio::HALF),
        _ => CONSTANTS.iter().find(|(known, _)| *known == name).map(|(_, value)| Number::float(*value)),
    }
}

macro_rules! table {
    ($($constant:ident)*) => { &[$((stringify!($constant), std::f64::consts::$constant)),*] };
}

const CONSTANTS: &[(&str, f64)] = table!(PI TAU E SQRT_2 LN_2 LN_10 LOG2_E LOG10_E LOG2_10 LOG10_2 FRAC_1_PI FRAC_2_PI
    FRAC_2_SQRT_PI FRAC_1_SQRT_2 FRAC_PI_2 FRAC_PI_3 FRAC_PI_4 FRAC_PI_6 FRAC_PI_8);
