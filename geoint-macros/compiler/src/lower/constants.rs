//! Constants of the standard library, whose values the macro knows. A constant of the user may have any of their names.

use syn::{Path, UseTree};

use crate::ir::{Number, Ratio};

/// The value of `std::f64::consts::PI` and its like, if a path names one beyond doubt.
pub(super) fn of_path(path: &Path) -> Option<Number> {
    let segments: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
    let segments: Vec<&str> = segments.iter().map(String::as_str).collect();
    match segments[..] {
        ["std" | "core", "f64" | "f32", "consts", name] | ["f64" | "f32", "consts", name] => of_name(name),
        _ => None,
    }
}

/// Collects what a `use` inside the body brings in: name, value, whether by `*`. False if it is something else.
pub(super) fn imported(tree: &UseTree, path: &mut Vec<String>, names: &mut Vec<(String, Number, bool)>) -> bool {
    let inside = |path: &[String]| match path {
        [root, float, consts] => {
            matches!(root.as_str(), "std" | "core") && matches!(float.as_str(), "f64" | "f32") && consts == "consts"
        }
        _ => false,
    };
    let mut one = |known: String, name: String| match of_name(&known).filter(|_| inside(path)) {
        Some(value) => {
            names.push((name, value, false));
            true
        }
        None => false,
    };
    match tree {
        UseTree::Name(name) => one(name.ident.to_string(), name.ident.to_string()),
        UseTree::Rename(name) => one(name.ident.to_string(), name.rename.to_string()),
        UseTree::Glob(_) if inside(path) => {
            names.extend(CONSTANTS.iter().filter_map(|(name, _)| Some((name.to_string(), of_name(name)?, true))));
            true
        }
        UseTree::Glob(_) => false,
        UseTree::Path(step) => {
            path.push(step.ident.to_string());
            let known = imported(&step.tree, path, names);
            path.pop();
            known
        }
        UseTree::Group(group) => group.items.iter().all(|tree| imported(tree, path, names)),
    }
}

/// Roots are what they are called; the others are the nearest `f64`.
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
