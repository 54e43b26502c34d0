//! A panel in its place: title, note, names, axes, grid and curves, from top to bottom.

use super::curve::{Curve, Marked};
use super::names::{apart, width, wrapped};
use super::svg::{Anchor, Document, Pen, Place};
use super::{Axis, Names, Panel};

/// Space around the plotting area, in pixels.
const LEFT: i32 = 58;
const RIGHT: i32 = 18;
pub(super) const BELOW: i32 = 48;
/// Of a line of text.
const ROW: i32 = 17;
/// Of the piece of a curve that stands before its name, and around it.
const SAMPLE: i32 = 24;
const SPACE: i32 = 6;

const INK: &str = "#333";
const GRID: &str = "#e4e4e4";
const AXIS_WIDTH: i32 = 10;

pub(super) struct Frame<'a> {
    panel: &'a Panel,
    /// Of the area in which curves are drawn.
    id: String,
    /// Corner and size of the plotting area, in pixels.
    left: i32,
    top: i32,
    width: i32,
    height: i32,
}

/// The space above the plotting area of a width, in pixels: title, note, names, and the label of the ordinate.
pub(super) fn above(panel: &Panel, width: i32) -> i32 {
    let rows = notes(panel, width).len() + rows_of_names(panel, width).len() + 1;
    30 + ROW * rows as i32 + 6
}

fn notes(panel: &Panel, width: i32) -> Vec<String> {
    wrapped(&panel.note, width + RIGHT)
}

fn named(panel: &Panel) -> impl Iterator<Item = &Curve> {
    panel.curves.iter().filter(|curve| !curve.name.is_empty())
}

/// The curves that are named above, in rows that are not too wide.
fn rows_of_names(panel: &Panel, most: i32) -> Vec<Vec<(i32, &Curve)>> {
    let mut rows: Vec<Vec<(i32, &Curve)>> = vec![];
    let mut x = 0;
    for curve in named(panel).filter(|_| panel.names == Names::Above) {
        let length = SAMPLE + SPACE + width(&curve.name, false);
        if x + length > most || rows.is_empty() {
            x = 0;
            rows.push(vec![]);
        }
        rows.last_mut().into_iter().for_each(|row| row.push((x, curve)));
        x += length + 3 * SPACE;
    }
    rows
}

impl<'a> Frame<'a> {
    /// Beside the frame that ends at `start`.
    pub(super) fn new(panel: &'a Panel, id: String, start: i32, above: i32, (width, height): (i32, i32)) -> Self {
        Frame { panel, id, left: start + LEFT, top: above, width, height }
    }

    /// Where the next frame may start: behind the names at the ends of curves, and behind the title.
    pub(super) fn end(&self) -> i32 {
        let name = |curve: &Curve| SAMPLE + 2 * SPACE + width(&curve.name, false);
        let names = match self.panel.names {
            Names::AtEnds => named(self.panel).map(name).max().unwrap_or(0),
            Names::Above => 0,
        };
        let title = width(&self.panel.title, true);
        self.left + (self.width + names).max(title) + RIGHT
    }

    pub(super) fn draw(&self, to: &mut Document) {
        to.clip(&self.id, (10 * self.left, 10 * self.top), (10 * self.width, 10 * self.height));
        self.header(to);
        self.axes(to);
        for curve in &self.panel.curves {
            self.curve(curve, to);
        }
        if self.panel.names == Names::AtEnds {
            self.names_at_ends(to);
        }
    }

    fn header(&self, to: &mut Document) {
        let x = 10 * self.left;
        to.text((x, 180), Anchor::Start, true, &self.panel.title);
        let mut y = 38;
        for line in notes(self.panel, self.width) {
            to.text((x, 10 * y), Anchor::Start, false, &line);
            y += ROW;
        }
        for row in rows_of_names(self.panel, self.width) {
            for (offset, curve) in row {
                self.sample(curve, (self.left + offset, y), to);
            }
            y += ROW;
        }
        to.text((x, 10 * (self.top - 13)), Anchor::Start, false, &self.panel.y.label);
        let below = (x + 5 * self.width, 10 * (self.top + self.height + 36));
        to.text(below, Anchor::Middle, false, &self.panel.x.label);
    }

    fn axes(&self, to: &mut Document) {
        let Panel { x, y, .. } = self.panel;
        let (left, top) = (10 * self.left, 10 * self.top);
        let (right, bottom) = (left + 10 * self.width, top + 10 * self.height);
        let inside = |axis: &Axis, value: &f64| (-1e-9..=1.0 + 1e-9).contains(&axis.place(*value));
        let mut grid = vec![];
        let mut ticks = vec![];
        for (value, text) in x.ticks(f64::from(self.width) / 60.0).iter().filter(|tick| inside(x, &tick.0)) {
            let at = left + tenths(x.place(*value), self.width);
            grid.push(vec![(at, top), (at, bottom)]);
            ticks.push(vec![(at, bottom), (at, bottom + 40)]);
            to.text((at, bottom + 130), Anchor::Middle, false, text);
        }
        for (value, text) in y.ticks(f64::from(self.height) / 40.0).iter().filter(|tick| inside(y, &tick.0)) {
            let at = bottom - tenths(y.place(*value), self.height);
            grid.push(vec![(left, at), (right, at)]);
            ticks.push(vec![(left - 40, at), (left, at)]);
            to.text((left - 70, at), Anchor::End, false, text);
        }
        ticks.push(vec![(left, top), (left, bottom), (right, bottom)]);
        let pen = Pen { colour: GRID, width: AXIS_WIDTH, dashes: "none", clip: None, rounding: false };
        to.lines(&grid, pen);
        to.lines(&ticks, Pen { colour: INK, ..pen });
    }

    /// Where a point is drawn; nowhere if it has no coordinates.
    fn place(&self, (x, y): (f64, f64)) -> Option<Place> {
        let (x, y) = (self.panel.x.place(x), self.panel.y.place(y));
        (x.is_finite() && y.is_finite()).then(|| {
            let bottom = 10 * (self.top + self.height);
            (10 * self.left + tenths(x, self.width), bottom - tenths(y, self.height))
        })
    }

    fn holds(&self, (x, y): Place) -> bool {
        let (left, top) = (10 * self.left, 10 * self.top);
        (left - 1..=left + 10 * self.width + 1).contains(&x) && (top - 1..=top + 10 * self.height + 1).contains(&y)
    }

    fn pen<'b>(&'b self, curve: &'b Curve) -> Pen<'b> {
        let (colour, dashes) = (curve.ink.colour, curve.ink.dashes);
        let width = if curve.width > 0.0 { (10.0 * curve.width) as i32 } else { 11 };
        Pen { colour, width, dashes, clip: Some(&self.id), rounding: curve.rounding }
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

    /// A piece of a curve and its name, beginning at a place in pixels.
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
        to.text((10 * (x + SAMPLE + SPACE), 10 * y), Anchor::Start, false, &curve.name);
    }

    /// Names right of the plotting area, each with a thin line that leads to the last point which is drawn.
    fn names_at_ends(&self, to: &mut Document) {
        let last = |curve: &Curve| {
            let places = curve.points.iter().rev().filter_map(|point| self.place(*point));
            places.into_iter().find(|place| self.holds(*place)).unwrap_or((10 * self.left, 10 * self.top))
        };
        let ends: Vec<_> = named(self.panel).map(last).collect();
        let mut heights: Vec<_> = ends.iter().map(|end| end.1 / 10).collect();
        apart(&mut heights, ROW, self.top, self.top + self.height);
        let x = self.left + self.width + SPACE;
        let leader = Pen { colour: "#777", width: 5, dashes: "none", clip: None, rounding: false };
        for ((curve, end), y) in named(self.panel).zip(ends).zip(heights) {
            to.lines(&[vec![end, (10 * x, 10 * y)]], Pen { rounding: curve.rounding, ..leader });
            self.sample(curve, (x, y), to);
        }
    }
}

/// A part of a length in pixels; what is far outside is not quite as far.
fn tenths(part: f64, length: i32) -> i32 {
    (part.clamp(-20.0, 20.0) * f64::from(10 * length)).round() as i32
}

/// Of a pixel, in the units of places.
const TENTH: f64 = 1.0;

/// The line through fewer of its places, nowhere further than a tenth of a pixel from the others.
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
            && far > TENTH
        {
            open.extend([(first, i), (i, last)]);
        }
    }
    line.iter().zip(kept).filter(|(_, kept)| *kept).map(|(place, _)| *place).collect()
}

/// From a place to the line between two others.
fn distance(place: Place, from: Place, to: Place) -> f64 {
    let difference = |a: Place, b: Place| (f64::from(a.0 - b.0), f64::from(a.1 - b.1));
    let (along, off) = (difference(to, from), difference(place, from));
    let square = along.0 * along.0 + along.1 * along.1;
    let part = if square > 0.0 { ((off.0 * along.0 + off.1 * along.1) / square).clamp(0.0, 1.0) } else { 0.0 };
    (off.0 - part * along.0).hypot(off.1 - part * along.1)
}
