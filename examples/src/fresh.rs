//! Checks that the figures in the repository are those which the examples draw.
//!
//! `cargo run -p geoint-examples --bin fresh` compares the files in `examples/figures` with the files that all examples have just
//! written; with the argument `update` it replaces them. On the same machine the files are equal. Another processor or another library
//! of elementary functions rounds differently: then all texts are equal, and no point of a curve is more than a pixel away from the
//! other curve. Curves that depend on rounding errors may differ in their points.

use geoint_examples::output;
use std::collections::BTreeSet;
use std::error::Error;
use std::fs;
use std::path::Path;

type Point = (f64, f64);

/// A pixel in the units of the figures.
const PIXEL: f64 = 10.0;

fn main() -> Result<(), Box<dyn Error>> {
    let committed = Path::new(env!("CARGO_MANIFEST_DIR")).join("figures");
    let drawn = output("")?;
    let update = std::env::args().nth(1).as_deref() == Some("update");
    let names: BTreeSet<String> = figures(&committed)?.union(&figures(&drawn)?).cloned().collect();
    let (mut stale, mut equal) = (vec![], 0);
    for name in &names {
        let [old, new] = [&committed, &drawn].map(|folder| fs::read_to_string(folder.join(name)).unwrap_or_default());
        if update && !new.is_empty() {
            fs::write(committed.join(name), &new)?;
        } else if update {
            fs::remove_file(committed.join(name))?;
        }
        equal += usize::from(old == new);
        if let Some(difference) = (old != new).then(|| difference(&old, &new)).flatten() {
            stale.push(format!("{name}: {difference}"));
        }
    }
    println!("{} figures, {equal} of them equal to the last bit", names.len());
    match (update, stale.is_empty()) {
        (true, _) | (_, true) => Ok(()),
        _ => {
            Err(format!("not what the examples draw (`.ci/examples update` replaces them): {}", stale.join("; "))
                .into())
        }
    }
}

/// Returns the names of the figures in a folder.
fn figures(folder: &Path) -> Result<BTreeSet<String>, Box<dyn Error>> {
    let mut names = BTreeSet::new();
    for file in fs::read_dir(folder)? {
        let name = file?.file_name().to_string_lossy().into_owned();
        if name.ends_with(".svg") {
            names.insert(name);
        }
    }
    Ok(names)
}

/// Describes a visible difference between two figures.
fn difference(old: &str, new: &str) -> Option<String> {
    if old.is_empty() || new.is_empty() {
        return Some("one of the two files is missing".into());
    }
    if old.lines().count() != new.lines().count() {
        return Some("the number of elements differs".into());
    }
    old.lines().zip(new.lines()).find_map(|(old, new)| {
        let [a, b] = [old, new].map(|line| line.split_once(" d=\"").unwrap_or((line, "")));
        if without_place(a.0) != without_place(b.0) {
            return Some(format!("`{}` in place of `{}`", b.0, a.0));
        }
        if a.0.contains("class=\"rounding\"") {
            return None;
        }
        let apart = apart(&parts(a.1), &parts(b.1)).max(apart(&parts(b.1), &parts(a.1)));
        (apart > PIXEL).then(|| format!("a curve is {:.1} pixels from where it was", apart / PIXEL))
    })
}

/// Removes the attributes of a text, because its place depends on numbers. Other elements stay as they are.
fn without_place(element: &str) -> &str {
    let text = element.strip_prefix("<text ").and_then(|text| text.split_once('>'));
    text.map_or(element, |text| text.1)
}

/// Reads the parts of a path: each begins at a place; differences follow.
fn parts(path: &str) -> Vec<Vec<Point>> {
    path.split('M').skip(1).map(part).collect()
}

fn part(path: &str) -> Vec<Point> {
    // Minus signs and commands separate numbers.
    let spaced = path.replace('-', " -").replace(|c: char| c.is_alphabetic() || c == '"', " ");
    let numbers: Vec<f64> = spaced.split_whitespace().filter_map(|number| number.parse().ok()).collect();
    let mut at = (0.0, 0.0);
    let step = |step: &[f64]| {
        at = (at.0 + step[0], at.1 + step[1]);
        at
    };
    numbers.chunks_exact(2).map(step).collect()
}

/// Returns the largest distance of a point of some lines from other lines.
fn apart(lines: &[Vec<Point>], others: &[Vec<Point>]) -> f64 {
    let nearest = |point: &Point| others.iter().map(|line| distance(*point, line)).fold(f64::INFINITY, f64::min);
    lines.iter().flatten().map(nearest).fold(0.0, f64::max)
}

fn distance((x, y): Point, line: &[Point]) -> f64 {
    let first = line.first().map_or(f64::INFINITY, |at| (x - at.0).hypot(y - at.1));
    let segments = line.windows(2).map(|ends| {
        let (along, off) = ((ends[1].0 - ends[0].0, ends[1].1 - ends[0].1), (x - ends[0].0, y - ends[0].1));
        let square = along.0 * along.0 + along.1 * along.1;
        let part = if square > 0.0 { ((off.0 * along.0 + off.1 * along.1) / square).clamp(0.0, 1.0) } else { 0.0 };
        (off.0 - part * along.0).hypot(off.1 - part * along.1)
    });
    segments.fold(first, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    const LINE: &str = "<path fill=\"none\" d=\"M0 0l100 0 100 50-20-7\"/>";

    #[test]
    fn paths_are_read() {
        let path = LINE.split_once(" d=\"").unwrap().1;
        assert_eq!(parts(path), [[(0.0, 0.0), (100.0, 0.0), (200.0, 50.0), (180.0, 43.0)]]);
    }

    #[test]
    fn roundings_are_no_difference_and_pixels_are() {
        // Another point on the same line, and one at a distance of half a pixel.
        assert_eq!(difference(LINE, "<path fill=\"none\" d=\"M0 0l50 0 50 0 100 55-20-7\"/>"), None);
        assert!(difference(LINE, "<path fill=\"none\" d=\"M0 0l100 0 100 90-20-7\"/>").is_some());
        assert!(difference(LINE, "<path fill=\"red\" d=\"M0 0l100 0 100 50-20-7\"/>").is_some());
        assert!(difference(LINE, "").is_some());
        let text = |text: &str, y: i32| format!("<text x=\"1\" y=\"{y}\">{text}</text>");
        assert_eq!(difference(&text("a", 1), &text("a", 5)), None);
        assert!(difference(&text("a", 1), &text("b", 1)).is_some());
    }

    #[test]
    fn roundings_may_be_anywhere() {
        let curve = |y: i32| format!("<path class=\"rounding\" fill=\"none\" d=\"M0 {y}l100 0\"/>");
        assert_eq!(difference(&curve(0), &curve(900)), None);
    }
}
