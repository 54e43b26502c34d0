//! The layout of a figure: title, note, legend, axes, grid and curves, from top to bottom.

use super::curve::{Curve, Marked};
use super::svg::{Anchor, Document, Pen, Place};
use super::text::{FONT, width, wrapped};
use super::{Axis, Panel};

/// Width of every figure in pixels.
const WIDTH: i32 = 560;
/// Letters are at least 10 pixels high on a screen 400 pixels wide.
const _: () = assert!(400 * FONT >= 10 * WIDTH);
/// Space around the plotting area in pixels.
const LEFT: i32 = 72;
const RIGHT: i32 = 20;
const BELOW: i32 = 56;
/// Space left of the title, and below it.
const MARGIN: i32 = 8;
const TITLE_ROW: i32 = 30;
/// Height of a line of text.
const ROW: i32 = 20;
/// Length of the sample of a curve in the legend, and the space around it.
const SAMPLE: i32 = 26;
const SPACE: i32 = 6;

const AXIS: Pen<'_> =
    Pen { colour: "currentColor", width: 10, dashes: "none", faint: false, clip: None, rounding: false };

/// Draws a panel. The name of the figure identifies its plotting area among other figures of a page.
pub(super) fn drawn(panel: &Panel, name: &str, ratio: f64) -> String {
    let (notes, legend) = (wrapped(&panel.note, WIDTH - 2 * MARGIN), legend(panel));
    let top = TITLE_ROW + ROW * (notes.len() + legend.len() + 1) as i32 + 3 * SPACE;
    let width = WIDTH - LEFT - RIGHT;
    let frame = Frame { panel, name, top, width, height: (f64::from(width) / ratio).round() as i32 };
    let description = format!("{}: {}.", panel.title, panel.note);
    let mut document = Document::new(WIDTH, top + frame.height + BELOW, &description);
    frame.header(&notes, &legend, &mut document);
    frame.axes(&mut document);
    document.clip(name, (10 * LEFT, 10 * top), (10 * width, 10 * frame.height));
    for curve in &panel.curves {
        frame.curve(curve, &mut document);
    }
    document.finish()
}

/// Arranges the named curves in rows, each with its distance from the left in pixels.
fn legend(panel: &Panel) -> Vec<Vec<(i32, &Curve)>> {
    let mut rows: Vec<Vec<(i32, &Curve)>> = vec![];
    let mut x = MARGIN;
    for curve in panel.curves.iter().filter(|curve| !curve.name.is_empty()) {
        let length = SAMPLE + SPACE + width(&curve.name);
        match rows.last_mut() {
            Some(row) if x + length <= WIDTH - MARGIN => row.push((x, curve)),
            _ => {
                x = MARGIN;
                rows.push(vec![(x, curve)]);
            }
        }
        x += length + 3 * SPACE;
    }
    rows
}

/// A panel and its plotting area, in pixels.
struct Frame<'a> {
    panel: &'a Panel,
    name: &'a str,
    top: i32,
    width: i32,
    height: i32,
}

impl Frame<'_> {
    fn header(&self, notes: &[String], legend: &[Vec<(i32, &Curve)>], to: &mut Document) {
        to.title((10 * MARGIN, 10 * TITLE_ROW / 2), &self.panel.title);
        let mut y = TITLE_ROW + ROW / 2;
        for line in notes {
            to.text((10 * MARGIN, 10 * y), Anchor::Start, line);
            y += ROW;
        }
        for row in legend {
            for (x, curve) in row {
                self.sample(curve, (*x, y), to);
            }
            y += ROW;
        }
        to.text((10 * MARGIN, 10 * (y + SPACE)), Anchor::Start, &self.panel.y.label);
        let below = (10 * LEFT + 5 * self.width, 10 * (self.top + self.height + 42));
        to.text(below, Anchor::Middle, &self.panel.x.label);
    }

    fn axes(&self, to: &mut Document) {
        let Panel { x, y, .. } = self.panel;
        let (left, top) = (10 * LEFT, 10 * self.top);
        let (right, bottom) = (left + 10 * self.width, top + 10 * self.height);
        let inside = |axis: &Axis, value: &f64| (-1e-9..=1.0 + 1e-9).contains(&axis.place(*value));
        let mut grid = vec![];
        let mut ticks = vec![];
        for (value, text) in x.ticks(f64::from(self.width) / 70.0).iter().filter(|tick| inside(x, &tick.0)) {
            let at = left + tenths(x.place(*value), self.width);
            grid.push(vec![(at, top), (at, bottom)]);
            ticks.push(vec![(at, bottom), (at, bottom + 40)]);
            to.text((at, bottom + 150), Anchor::Middle, text);
        }
        for (value, text) in y.ticks(f64::from(self.height) / 45.0).iter().filter(|tick| inside(y, &tick.0)) {
            let at = bottom - tenths(y.place(*value), self.height);
            grid.push(vec![(left, at), (right, at)]);
            ticks.push(vec![(left - 40, at), (left, at)]);
            to.text((left - 70, at), Anchor::End, text);
        }
        ticks.push(vec![(left, top), (left, bottom), (right, bottom)]);
        to.lines(&grid, Pen { faint: true, ..AXIS });
        to.lines(&ticks, AXIS);
    }

    /// Returns the place of a point, or `None` if a coordinate is not finite.
    fn place(&self, (x, y): (f64, f64)) -> Option<Place> {
        let (x, y) = (self.panel.x.place(x), self.panel.y.place(y));
        (x.is_finite() && y.is_finite()).then(|| {
            let bottom = 10 * (self.top + self.height);
            (10 * LEFT + tenths(x, self.width), bottom - tenths(y, self.height))
        })
    }

    fn holds(&self, (x, y): Place) -> bool {
        let (left, top) = (10 * LEFT, 10 * self.top);
        (left - 1..=left + 10 * self.width + 1).contains(&x) && (top - 1..=top + 10 * self.height + 1).contains(&y)
    }

    fn pen<'b>(&'b self, curve: &'b Curve) -> Pen<'b> {
        let (colour, dashes) = (curve.ink.colour, curve.ink.dashes);
        let width = if curve.width > 0.0 { (10.0 * curve.width) as i32 } else { 11 };
        Pen { colour, width, dashes, clip: Some(self.name), rounding: curve.rounding, ..AXIS }
    }

    fn curve(&self, curve: &Curve, to: &mut Document) {
        let places: Vec<_> = curve.points.iter().map(|point| self.place(*point)).collect();
        if curve.width > 0.0 {
            let parts = places.split(Option::is_none).map(|part| {
                let part: Vec<Place> = part.iter().flatten().copied().collect();
                simplified(&part)
            });
            to.lines(&parts.collect::<Vec<_>>(), self.pen(curve));
        }
        if curve.marker > 0.0 {
            let skipped = if curve.marked == Marked::Last { places.len().saturating_sub(1) } else { 0 };
            let mut places: Vec<_> = places[skipped..].iter().flatten().copied().collect();
            places.retain(|place| self.holds(*place));
            places.dedup();
            to.markers(&places, curve.shape(), (10.0 * curve.marker) as i32, curve.open, self.pen(curve));
        }
    }

    /// Draws a sample of a curve and its name, from a place in pixels to the right.
    fn sample(&self, curve: &Curve, (x, y): Place, to: &mut Document) {
        let pen = Pen { clip: None, ..self.pen(curve) };
        if curve.width > 0.0 {
            let wide = Pen { width: pen.width.max(14), ..pen };
            to.lines(&[vec![(10 * x, 10 * y), (10 * (x + SAMPLE), 10 * y)]], wide);
        }
        if curve.marker > 0.0 {
            let radius = (10.0 * curve.marker.max(3.0)) as i32;
            to.markers(&[(10 * x + 5 * SAMPLE, 10 * y)], curve.shape(), radius, curve.open, pen);
        }
        to.text((10 * (x + SAMPLE + SPACE), 10 * y), Anchor::Start, &curve.name);
    }
}

/// Converts a part of a length in pixels to tenths of a pixel. Places far outside are moved closer.
fn tenths(part: f64, length: i32) -> i32 {
    (part.clamp(-20.0, 20.0) * f64::from(10 * length)).round() as i32
}

/// Largest distance of a simplified line from its places, in tenths of a pixel.
const TOLERANCE: f64 = 1.0;

/// Removes places from a line. The remaining line is nowhere more than the tolerance away from the removed places.
/// D. H. Douglas & T. K. Peucker, Cartographica 10 (1973) 112.
fn simplified(line: &[Place]) -> Vec<Place> {
    if line.len() < 3 {
        return line.to_vec();
    }
    let mut kept = vec![false; line.len()];
    let mut open = vec![(0, line.len() - 1)];
    while let Some((first, last)) = open.pop() {
        (kept[first], kept[last]) = (true, true);
        let distances = (first + 1..last).map(|i| (distance(line[i], line[first], line[last]), i));
        if let Some((far, i)) = distances.max_by(|a, b| a.0.total_cmp(&b.0))
            && far > TOLERANCE
        {
            open.extend([(first, i), (i, last)]);
        }
    }
    line.iter().zip(kept).filter(|(_, kept)| *kept).map(|(place, _)| *place).collect()
}

/// Returns the distance of a place from the line between two others.
fn distance(place: Place, from: Place, to: Place) -> f64 {
    let difference = |a: Place, b: Place| (f64::from(a.0 - b.0), f64::from(a.1 - b.1));
    let (along, off) = (difference(to, from), difference(place, from));
    let square = along.0 * along.0 + along.1 * along.1;
    let part = if square > 0.0 { ((off.0 * along.0 + off.1 * along.1) / square).clamp(0.0, 1.0) } else { 0.0 };
    (off.0 - part * along.0).hypot(off.1 - part * along.1)
}
