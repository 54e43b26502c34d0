//! Figures: panels of curves side by side, as an SVG whose bits depend on the points alone.
//!
//! One style for all. A curve differs from the others by its colour, its dashes and its marker, so that it can be told apart
//! without any one of the three. Below the title of a panel stands what was computed how: without it there is no figure.

mod axis;
mod curve;
mod frame;
mod names;
mod svg;

pub use axis::Axis;
pub use curve::{Curve, Ink, palette};

use frame::Frame;
use std::error::Error;
use std::fs;
use std::ops::Range;
use svg::Document;

/// A pair of axes with curves.
#[derive(Clone, Debug)]
pub struct Panel {
    title: String,
    note: String,
    x: Axis,
    y: Axis,
    equal: bool,
    names: Names,
    curves: Vec<Curve>,
}

/// Where curves are named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Names {
    AtEnds,
    Above,
}

impl Panel {
    /// Curves from the first to the topmost, named at their right ends. The note says the method, its step and the units.
    pub fn new(title: impl Into<String>, note: impl Into<String>, [x, y]: [Axis; 2], curves: Vec<Curve>) -> Self {
        Panel { title: title.into(), note: note.into(), x, y, equal: false, names: Names::AtEnds, curves }
    }

    /// With one unit of length for both coordinates: a circle is a circle.
    pub fn equal(mut self) -> Self {
        self.equal = true;
        self
    }

    /// With the names of the curves in rows above.
    pub fn named_above(mut self) -> Self {
        self.names = Names::Above;
        self
    }

    /// The ranges that are drawn in a plotting area of a size: the smallest around those of the axes with equal units.
    fn fitted(&self, (width, height): (i32, i32)) -> Self {
        let mut panel = self.clone();
        if self.equal {
            let ratio = f64::from(width) / f64::from(height);
            let half = |range: &Range<f64>| (range.end - range.start) / 2.0;
            let half_width = half(&self.x.range).max(half(&self.y.range) * ratio);
            let around = |range: &Range<f64>, half: f64| {
                let middle = 0.5 * (range.start + range.end);
                middle - half..middle + half
            };
            panel.x.range = around(&self.x.range, half_width);
            panel.y.range = around(&self.y.range, half_width / ratio);
        }
        panel
    }

    /// What a reader without the source would miss.
    fn unsaid(&self) -> Option<&'static str> {
        let said = [
            ("a title", !self.title.is_empty()),
            ("a note with method, step and units", !self.note.is_empty()),
            ("the label of an axis", ![&self.x, &self.y].iter().any(|axis| axis.label.is_empty())),
            ("the name of a curve", self.curves.iter().any(|curve| !curve.name.is_empty())),
        ];
        said.into_iter().find(|(_, said)| !said).map(|(what, _)| what)
    }
}

/// Writes panels side by side, each with a plotting area of `size` pixels, to the output file `name`, and says where it is.
///
/// # Errors
/// If the file cannot be written, or if a panel lacks its title, its note, the label of an axis or all names of curves.
pub fn figure(name: &str, size: (i32, i32), panels: &[Panel]) -> Result<(), Box<dyn Error>> {
    for panel in panels {
        if let Some(what) = panel.unsaid() {
            return Err(format!("{name}: `{}` lacks {what}", panel.title).into());
        }
    }
    let path = crate::output(name)?;
    let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    fs::write(&path, drawn(&stem, size, panels))?;
    println!("\nfigure      {}", crate::shown(&path));
    Ok(())
}

/// The text of the file.
fn drawn(stem: &str, size: (i32, i32), panels: &[Panel]) -> String {
    let panels: Vec<_> = panels.iter().map(|panel| panel.fitted(size)).collect();
    let above = panels.iter().map(|panel| frame::above(panel, size.0)).max().unwrap_or(0);
    let mut frames = Vec::new();
    let mut left = 0;
    for (i, panel) in panels.iter().enumerate() {
        let frame = Frame::new(panel, format!("{stem}-{i}"), left, above, size);
        left = frame.end();
        frames.push(frame);
    }
    let said: Vec<_> = panels.iter().map(|panel| format!("{}: {}.", panel.title, panel.note)).collect();
    let mut document = Document::new(left, above + size.1 + frame::BELOW, &said.join(" "));
    for frame in &frames {
        frame.draw(&mut document);
    }
    document.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panel(curves: Vec<Curve>) -> Panel {
        Panel::new("T", "N", [Axis::linear("x", 0.0..1.0), Axis::decades("y", -4.0..0.0)], curves)
    }

    #[test]
    fn a_panel_says_what_it_shows() {
        let line = || vec![Curve::line("name", palette::BLUE, vec![(0.0, 1.0), (1.0, 0.1)])];
        assert_eq!(panel(line()).unsaid(), None);
        assert_eq!(Panel { note: String::new(), ..panel(line()) }.unsaid(), Some("a note with method, step and units"));
        assert_eq!(
            panel(vec![Curve { name: String::new(), ..line().remove(0) }]).unsaid(),
            Some("the name of a curve")
        );
    }

    /// A logarithm of zero has no place, least of all that of the smallest number on the axis.
    #[test]
    fn zeros_leave_a_gap() {
        let points = vec![(0.0, 1.0), (0.5, 0.1), (0.6, 0.0), (0.8, 0.1), (1.0, 1.0)];
        let drawn = drawn("t", (100, 100), &[panel(vec![Curve::line("name", palette::BLUE, points)])]);
        let path = drawn.lines().find(|line| line.contains("clip-path")).unwrap();
        assert_eq!(path.matches('M').count(), 2);
    }

    #[test]
    fn colours_dashes_and_markers_differ() {
        let all = palette::ALL;
        for (i, a) in all.iter().enumerate() {
            for b in &all[i + 1..] {
                assert!(a.colour != b.colour && a.dashes != b.dashes && a.marker != b.marker, "{a:?} {b:?}");
            }
        }
    }
}
