//! Rules for pages that people write: lengths, links, versions, functions.

use crate::project::Project;

/// The most words of each page.
const MOST_WORDS: [(&str, usize); 10] = [
    ("README.md", 1500),
    ("ARCHITECTURE.md", 3500),
    ("CONTRIBUTING.md", 900),
    ("CHANGELOG.md", 2500),
    ("examples/README.md", 2000),
    ("tests/benches/README.md", 3000),
    ("tests/stress/README.md", 1500),
    ("geoint-macros/docs/hamiltonian.md", 1500),
    ("geoint-macros/docs/lagrangian.md", 1000),
    ("geoint-macros/docs/vector_field.md", 1000),
];

/// The most words of all Markdown pages to read.
const MOST_WORDS_IN_ALL: usize = 21_000;
/// Pages of tables, to look things up. Tests check their rows.
const TABLES: [&str; 2] = [MEASURED, "tests/STATEMENTS.md"];
const MEASURED: &str = "VERIFICATION.md";

/// The most lines of a page of the guide.
const MOST_LINES: usize = 120;

/// Returns every rule that is broken.
pub(crate) fn check(project: &Project) -> Result<(), Vec<String>> {
    let mut problems = vec![];
    if let Err(problem) = lengths(project, &mut problems).and_then(|()| versions(project, &mut problems)) {
        problems.push(problem);
    }
    problems.extend(functions(project).err());
    for page in project.files("", ".md") {
        if let Err(problem) = links(project, &page, &mut problems) {
            problems.push(problem);
        }
    }
    if problems.is_empty() { Ok(()) } else { Err(problems) }
}

fn lengths(project: &Project, problems: &mut Vec<String>) -> Result<(), String> {
    for (page, most) in MOST_WORDS {
        let words = project.read(page)?.split_whitespace().count();
        if words > most {
            problems.push(format!("{page} has {words} words, and may have {most}"));
        }
    }
    let mut words = 0;
    for page in project.files("", ".md").iter().filter(|page| !TABLES.contains(&page.as_str())) {
        words += project.read(page)?.split_whitespace().count();
    }
    if words > MOST_WORDS_IN_ALL {
        problems.push(format!(
            "all pages but {} have {words} words, and may have {MOST_WORDS_IN_ALL}",
            TABLES.join(" and ")
        ));
    }
    for page in project.files("geoint-runtime/src/guide", ".rs") {
        let lines = project.read(&page)?.lines().count();
        if lines > MOST_LINES {
            problems.push(format!("{page} has {lines} lines, and may have {MOST_LINES}"));
        }
    }
    Ok(())
}

/// Pages name the version of Rust that the manifest asks for.
fn versions(project: &Project, problems: &mut Vec<String>) -> Result<(), String> {
    let manifest = project.read("Cargo.toml")?;
    let rust = manifest.split("rust-version = \"").nth(1).and_then(|rest| rest.split('"').next());
    let rust = rust.ok_or("Cargo.toml has no rust-version")?;
    for page in ["README.md", "geoint-runtime/src/guide/_01_first_picture.rs"] {
        if !project.read(page)?.contains(&format!("Rust {rust}")) {
            problems.push(format!("{page} does not say that it needs Rust {rust}"));
        }
    }
    Ok(())
}

/// The guide names every function that VERIFICATION.md measures. Inverse functions may stand in a group (`asin` …).
fn functions(project: &Project) -> Result<(), String> {
    const PAGE: &str = "geoint-runtime/src/guide/_04_language.rs";
    let (measured, page) = (project.read(MEASURED)?, project.read(PAGE)?);
    let section = measured.split("\n## Functions of the language").nth(1).and_then(|rest| rest.split("\n## ").next());
    let names = section.unwrap_or_default().lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next());
    let is_inverse = |name: &str| name.starts_with('a') && page.contains(&format!("`{}`", &name[1..]));
    let other_rows = ["quotient", "branch"];
    match names
        .filter(|name| !other_rows.contains(name))
        .find(|name| !page.contains(&format!("`{name}`")) && !is_inverse(name))
    {
        Some(name) => Err(format!("{PAGE} does not name the function `{name}`")),
        None => Ok(()),
    }
}

/// Relative links lead to files, and links within a page to its headings.
fn links(project: &Project, page: &str, problems: &mut Vec<String>) -> Result<(), String> {
    let text = project.read(page)?;
    let folder = page.rsplit_once('/').map_or("", |(folder, _)| folder);
    // Pages of documentation link to items of Rust.
    let is_rustdoc = folder.ends_with("docs") || page.starts_with("geoint-macros");
    let places: Vec<String> = text.lines().filter(|line| line.starts_with('#')).map(place).collect();
    let targets = text.split("](").skip(1).filter_map(|rest| rest.split([')', ' ']).next());
    for target in targets.filter(|target| !target.contains("://") && !target.contains('`')) {
        let (file, within) = target.split_once('#').map_or((target, None), |(file, within)| (file, Some(within)));
        let is_there = match within {
            Some(within) if file.is_empty() => places.iter().any(|place| place == within),
            _ if is_rustdoc && !file.contains('.') => true,
            _ if folder.is_empty() => project.has(file),
            _ => project.has(&format!("{folder}/{file}")),
        };
        if !is_there {
            problems.push(format!("{page}: the link {target} leads nowhere"));
        }
    }
    Ok(())
}

/// Returns the target that leads to a heading.
fn place(heading: &str) -> String {
    let words = heading.trim_start_matches('#').trim().to_lowercase();
    let letters = words.chars().filter(|c| c.is_alphanumeric() || [' ', '-', '_'].contains(c));
    letters.map(|c| if c == ' ' { '-' } else { c }).collect()
}
