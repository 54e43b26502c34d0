//! Figures: each is one pair of axes with curves, as an SVG.
//!
//! All figures have one style. A curve differs from the others by its colour, its dashes and its marker; each of the three is
//! enough to identify it. Texts, axes and grid have the colour of the text around the figure, and the background is transparent.
//! So a figure fits light and dark pages. A note below the title states the method, the step and the units.

mod axis;
mod curve;
mod frame;
mod svg;
mod text;

pub use axis::Axis;
pub use curve::{Curve, Ink, palette};

use std::error::Error;
use std::fs;
use std::ops::Range;

/// A pair of axes with curves.
#[derive(Clone, Debug)]
pub struct Panel {
    title: String,
    note: String,
    x: Axis,
    y: Axis,
    equal: bool,
    curves: Vec<Curve>,
}

impl Panel {
    /// Draws the curves in this order. The note states the method, its step and the units.
    pub fn new(title: impl Into<String>, note: impl Into<String>, [x, y]: [Axis; 2], curves: Vec<Curve>) -> Self {
        Panel { title: title.into(), note: note.into(), x, y, equal: false, curves }
    }

    /// Uses one unit of length for both coordinates: a circle is a circle.
    pub fn equal(mut self) -> Self {
        self.equal = true;
        self
    }

    /// Extends a range of a panel with equal units until the ratio of width to height is `ratio`.
    fn fitted(&self, ratio: f64) -> Self {
        let mut panel = self.clone();
        if self.equal {
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

    /// Names the first text that a reader needs and that is missing.
    fn missing(&self) -> Option<&'static str> {
        let texts = [
            ("a title", !self.title.is_empty()),
            ("a note with method, step and units", !self.note.is_empty()),
            ("the label of an axis", ![&self.x, &self.y].iter().any(|axis| axis.label.is_empty())),
            ("the name of a curve", self.curves.iter().any(|curve| !curve.name.is_empty())),
        ];
        texts.into_iter().find(|(_, given)| !given).map(|(text, _)| text)
    }
}

/// Writes each panel to an output file and prints its path. The first file is `name`, the next ones are `name_2`, `name_3` and so on, with
/// the same extension. The plotting area has the ratio of width to height that `shape` gives.
///
/// # Errors
/// If a file cannot be written, or if a panel lacks its title, its note, the label of an axis or all names of curves.
pub fn figure(name: &str, shape: (i32, i32), panels: &[Panel]) -> Result<(), Box<dyn Error>> {
    println!();
    for (panel, i) in panels.iter().zip(1..) {
        if let Some(text) = panel.missing() {
            return Err(format!("{name}: `{}` lacks {text}", panel.title).into());
        }
        let name = if i == 1 { name.into() } else { name.replace(".svg", &format!("_{i}.svg")) };
        let path = crate::output(&name)?;
        let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        fs::write(&path, drawn(&stem, shape, panel))?;
        println!("figure      {}", crate::shown(&path));
    }
    Ok(())
}

/// Returns the text of the file.
fn drawn(stem: &str, (width, height): (i32, i32), panel: &Panel) -> String {
    let ratio = f64::from(width) / f64::from(height);
    frame::drawn(&panel.fitted(ratio), stem, ratio)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panel(curves: Vec<Curve>) -> Panel {
        Panel::new("T", "N", [Axis::linear("x", 0.0..1.0), Axis::decades("y", -4.0..0.0)], curves)
    }

    fn line() -> Vec<Curve> {
        vec![Curve::line("name", palette::BLUE, vec![(0.0, 1.0), (1.0, 0.1)])]
    }

    #[test]
    fn a_panel_states_what_it_shows() {
        assert_eq!(panel(line()).missing(), None);
        assert_eq!(
            Panel { note: String::new(), ..panel(line()) }.missing(),
            Some("a note with method, step and units")
        );
        assert_eq!(
            panel(vec![Curve { name: String::new(), ..line().remove(0) }]).missing(),
            Some("the name of a curve")
        );
    }

    #[test]
    fn a_circle_is_a_circle() {
        let axes = [Axis::linear("x", -1.0..1.0), Axis::linear("y", -1.0..1.0)];
        let panel = Panel::new("T", "N", axes, line()).equal().fitted(1.5);
        assert_eq!((panel.x.range, panel.y.range), (-1.5..1.5, -1.0..1.0));
    }

    /// The logarithm of zero has no place on the axis.
    #[test]
    fn zeros_leave_a_gap() {
        let points = vec![(0.0, 1.0), (0.5, 0.1), (0.6, 0.0), (0.8, 0.1), (1.0, 1.0)];
        let drawn = drawn("t", (1, 1), &panel(vec![Curve::line("name", palette::BLUE, points)]));
        let path = drawn.lines().find(|line| line.contains("clip-path")).unwrap();
        assert_eq!(path.matches('M').count(), 2);
    }

    /// Texts and axes have the colour of the page; no rectangle hides its background.
    #[test]
    fn figures_fit_light_and_dark_pages() {
        let drawn = drawn("t", (1, 1), &panel(line()));
        assert!(drawn.contains("fill=\"currentColor\"") && drawn.contains("prefers-color-scheme:dark"));
        let fills = drawn.split("fill=\"").skip(1).filter_map(|rest| rest.split_once('"')).map(|fill| fill.0);
        assert!(fills.into_iter().all(|fill| ["currentColor", "none"].contains(&fill)), "{drawn}");
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

    /// Contrast of at least 3 : 1 on white and on black, as in the Web Content Accessibility Guidelines 2.1, 1.4.11.
    #[test]
    fn colours_are_readable_on_white_and_on_black() {
        let inks = palette::ALL.into_iter().chain([palette::GREY]);
        for colour in inks.map(|ink| ink.colour).filter(|colour| *colour != "currentColor") {
            let part = |i: usize| f64::from(u8::from_str_radix(&colour[i..i + 2], 16).unwrap()) / 255.0;
            let linear = |c: f64| if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) };
            let [red, green, blue] = [1, 3, 5].map(|i| linear(part(i)));
            let luminance = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
            assert!(1.05 >= 3.0 * (luminance + 0.05) && luminance + 0.05 >= 3.0 * 0.05, "{colour}: {luminance}");
        }
    }
}
