//! Figures: curves with their names at their ends or in a row above, as an SVG.
//!
//! One style for all: thin lines in colours that colour-blind readers can tell apart, a faint grid, and no box around.

use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::error::Error;
use std::fs;
use std::ops::Range;
use std::path::Path;

/// Colours of M. Okabe and K. Ito, told apart by colour-blind readers too.
pub mod palette {
    pub use plotters::style::RGBColor as Colour;

    /// Nearly black.
    pub const BLACK: Colour = Colour(0x26, 0x26, 0x26);
    /// Orange.
    pub const ORANGE: Colour = Colour(0xE6, 0x9F, 0x00);
    /// Sky blue.
    pub const SKY: Colour = Colour(0x56, 0xB4, 0xE9);
    /// Bluish green.
    pub const GREEN: Colour = Colour(0x00, 0x9E, 0x73);
    /// Blue.
    pub const BLUE: Colour = Colour(0x00, 0x72, 0xB2);
    /// Vermilion.
    pub const VERMILION: Colour = Colour(0xD5, 0x5E, 0x00);
    /// Reddish purple.
    pub const PURPLE: Colour = Colour(0xCC, 0x79, 0xA7);
    /// Grey, for what the others are compared with.
    pub const GREY: Colour = Colour(0xB4, 0xB4, 0xB4);
}

/// Plotters places everything on whole pixels; a canvas this much finer than the figure makes curves smooth.
const FINE: i32 = 10;
/// Space around the plotting area of a panel, in pixels.
const LEFT: i32 = 56;
const RIGHT: i32 = 20;
const ABOVE: i32 = 60;
const BELOW: i32 = 52;
/// More space on the right for names at the ends of curves, and the least distance between two of them.
const NAMES: i32 = 206;
const NAME_HEIGHT: i32 = 17;
const INK: RGBColor = RGBColor(0x33, 0x33, 0x33);
const GRID: RGBColor = RGBColor(0xE4, 0xE4, 0xE4);

/// A curve, and a dot at its end if `dot` is not zero; without a width, dots at all of its points.
#[derive(Clone, Debug)]
pub struct Curve {
    /// What it is called in the figure, if anything.
    pub name: String,
    /// Its colour, see [`palette`].
    pub colour: RGBColor,
    /// Width of the line in pixels.
    pub width: f64,
    /// Radius of the dots in pixels.
    pub dot: f64,
    /// The points.
    pub points: Vec<(f64, f64)>,
}

impl Curve {
    /// A line without dots.
    pub fn line(name: impl Into<String>, colour: RGBColor, points: Vec<(f64, f64)>) -> Self {
        Curve { name: name.into(), colour, width: 1.8, dot: 0.0, points }
    }

    /// Dots without a line.
    pub fn dots(name: impl Into<String>, colour: RGBColor, points: Vec<(f64, f64)>) -> Self {
        Curve { name: name.into(), colour, width: 0.0, dot: 1.6, points }
    }
}

/// Where curves are named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Names {
    /// At their right ends.
    AtEnds,
    /// In a row above.
    Above,
}

/// What the coordinates of a panel are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Itself.
    Linear,
    /// A length in the same unit as the first coordinate: a circle is a circle.
    Equal,
    /// A positive number by its decimal logarithm; the range counts decades.
    Logarithmic,
    /// The same, and so is the first coordinate.
    DoublyLogarithmic,
}

impl Scale {
    /// Where a point is drawn, in the units of the ranges. What is too small for a logarithm is at the lower edge.
    fn place(self, panel: &Panel, (x, y): (f64, f64)) -> (f64, f64) {
        let decades = |x: f64, range: &Range<f64>| x.max(f64::MIN_POSITIVE).log10().max(range.start);
        match self {
            Scale::Linear | Scale::Equal => (x, y),
            Scale::Logarithmic => (x, decades(y, &panel.y)),
            Scale::DoublyLogarithmic => (decades(x, &panel.x), decades(y, &panel.y)),
        }
    }
}

/// A pair of axes with curves.
#[derive(Clone, Debug)]
pub struct Panel {
    /// What is to be seen.
    pub title: String,
    /// The first coordinate with its unit.
    pub x_label: String,
    /// The second coordinate with its unit.
    pub y_label: String,
    /// From where to where, at least.
    pub x: Range<f64>,
    /// From where to where, at least.
    pub y: Range<f64>,
    /// What the coordinates are.
    pub scale: Scale,
    /// Where curves are named.
    pub names: Names,
    /// From the first to the topmost.
    pub curves: Vec<Curve>,
}

impl Panel {
    /// Curves in linear coordinates, named above.
    pub fn new(title: &str, [x_label, y_label]: [&str; 2], [x, y]: [Range<f64>; 2], curves: Vec<Curve>) -> Self {
        let [title, x_label, y_label] = [title, x_label, y_label].map(Into::into);
        Panel { title, x_label, y_label, x, y, scale: Scale::Linear, names: Names::Above, curves }
    }
}

/// Writes panels as [`save`] does to the output file `name`, and says where it is.
///
/// # Errors
/// If the file cannot be written.
pub fn figure(name: &str, size: (u32, u32), panels: &[Panel]) -> Result<(), Box<dyn Error>> {
    let path = crate::output(name)?;
    save(&path, size, panels)?;
    println!("\nfigure      {}", crate::shown(&path));
    Ok(())
}

/// Writes panels side by side, each `width` × `height` pixels, as an SVG.
///
/// # Errors
/// If the file cannot be written.
pub fn save(path: &Path, (width, height): (u32, u32), panels: &[Panel]) -> Result<(), Box<dyn Error>> {
    let whole = (width * panels.len() as u32, height);
    let fine = (whole.0 * FINE as u32, whole.1 * FINE as u32);
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, fine).into_drawing_area();
        root.fill(&WHITE)?;
        for (area, panel) in root.split_evenly((1, panels.len())).iter().zip(panels) {
            draw(area, panel).map_err(|e| e.to_string())?;
        }
        root.present()?;
    }
    let size = |(w, h): (u32, u32)| format!("<svg width=\"{w}\" height=\"{h}\"");
    fs::write(path, svg.replacen(&size(fine), &size(whole), 1))?;
    Ok(())
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), DrawingAreaErrorKind<std::io::Error>>;

fn draw(area: &Area<'_>, panel: &Panel) -> Drawn {
    let (width, height) = area.dim_in_pixel();
    let right = if panel.names == Names::AtEnds { RIGHT + NAMES } else { RIGHT };
    let inner = (width as i32 - (LEFT + right) * FINE, height as i32 - (ABOVE + BELOW) * FINE);
    let (x, y) = if panel.scale == Scale::Equal {
        equal(panel.x.clone(), panel.y.clone(), f64::from(inner.0) / f64::from(inner.1))
    } else {
        (panel.x.clone(), panel.y.clone())
    };

    let mut chart = ChartBuilder::on(area)
        .margin_top(ABOVE * FINE)
        .margin_right(right * FINE)
        .margin_bottom(24 * FINE)
        .x_label_area_size((BELOW - 24) * FINE)
        .y_label_area_size(LEFT * FINE)
        .build_cartesian_2d(x, y)?;
    let decades = |y: &f64| if y.fract() == 0.0 { format!("10{}", superscript(*y)) } else { String::new() };
    let plain = |x: &f64| number(*x);
    chart
        .configure_mesh()
        .x_label_formatter(if panel.scale == Scale::DoublyLogarithmic { &decades } else { &plain })
        .y_label_formatter(match panel.scale {
            Scale::Logarithmic | Scale::DoublyLogarithmic => &decades,
            Scale::Linear | Scale::Equal => &plain,
        })
        .x_labels(if panel.scale == Scale::Equal { 14 } else { 7 })
        .y_labels(if panel.scale == Scale::Equal { 14 } else { 10 })
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID.stroke_width(FINE as u32))
        .axis_style(INK.stroke_width(FINE as u32))
        .label_style(font(12).color(&INK))
        .set_all_tick_mark_size(4 * FINE)
        .draw()?;

    for curve in &panel.curves {
        let points = curve.points.iter().map(|point| panel.scale.place(panel, *point));
        let mut dotted = 0;
        if curve.width > 0.0 {
            let stroke = curve.colour.stroke_width((curve.width * f64::from(FINE)) as u32);
            chart.draw_series(LineSeries::new(points.clone(), stroke))?;
            dotted = points.len().saturating_sub(1);
        }
        if curve.dot > 0.0 {
            let radius = (curve.dot * f64::from(FINE)) as i32;
            let dots = points.skip(dotted).map(|at| Circle::new(at, radius, curve.colour.filled()));
            chart.draw_series(dots)?;
        }
    }

    let heading = |text: &str, x: i32, y: i32, style: &TextStyle<'_>| area.draw_text(text, style, (x * FINE, y * FINE));
    heading(&panel.title, LEFT, 18, &at(HPos::Left, bold(15).color(&INK)))?;
    heading(&panel.y_label, LEFT, 44, &at(HPos::Left, font(12).color(&INK)))?;
    let middle = LEFT + inner.0 / FINE / 2;
    heading(&panel.x_label, middle, height as i32 / FINE - 14, &at(HPos::Center, font(12).color(&INK)))?;
    match panel.names {
        Names::AtEnds => names_at_ends(area, &chart, panel),
        Names::Above => names_above(area, panel),
    }
}

type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

fn names_at_ends(area: &Area<'_>, chart: &Chart<'_, '_>, panel: &Panel) -> Drawn {
    let base = area.get_base_pixel();
    let end_height = |curve: &Curve| {
        let (x, y) = panel.scale.place(panel, *curve.points.last().unwrap_or(&(0.0, 0.0)));
        chart.backend_coord(&(x, y.clamp(panel.y.start, panel.y.end))).1 - base.1
    };
    let mut ends: Vec<_> = named(panel).map(|curve| (end_height(curve), curve)).collect();
    ends.sort_by_key(|end| end.0);
    for i in 1..ends.len() {
        ends[i].0 = ends[i].0.max(ends[i - 1].0 + NAME_HEIGHT * FINE);
    }
    let x = area.dim_in_pixel().0 as i32 - (RIGHT + NAMES - 8) * FINE;
    ends.iter()
        .try_for_each(|(y, curve)| area.draw_text(&curve.name, &at(HPos::Left, bold(12).color(&curve.colour)), (x, *y)))
}

fn named(panel: &Panel) -> impl DoubleEndedIterator<Item = &Curve> {
    panel.curves.iter().filter(|curve| !curve.name.is_empty())
}

fn names_above(area: &Area<'_>, panel: &Panel) -> Drawn {
    let mut x = area.dim_in_pixel().0 as i32 - RIGHT * FINE;
    for curve in named(panel).rev() {
        // No fonts are measured here: 7 pixels are the mean width of a letter.
        x -= 7 * curve.name.chars().count() as i32 * FINE;
        area.draw_text(&curve.name, &at(HPos::Left, font(12).color(&INK)), (x, 44 * FINE))?;
        x -= 8 * FINE;
        area.draw(&Circle::new((x, 44 * FINE), 4 * FINE, curve.colour.filled()))?;
        x -= 16 * FINE;
    }
    Ok(())
}

/// The smallest ranges around the given ones with equal units, for a plotting area of which the ratio of width to
/// height is `ratio`.
fn equal(x: Range<f64>, y: Range<f64>, ratio: f64) -> (Range<f64>, Range<f64>) {
    let half = ((x.end - x.start) / 2.0).max((y.end - y.start) / 2.0 * ratio);
    let around = |range: Range<f64>, half: f64| {
        let middle = 0.5 * (range.start + range.end);
        middle - half..middle + half
    };
    (around(x, half), around(y, half / ratio))
}

fn font(size: i32) -> TextStyle<'static> {
    // Plotters divides by 1.24.
    ("sans-serif", f64::from(size * FINE) * 1.24).into_font().into()
}

fn bold(size: i32) -> TextStyle<'static> {
    ("sans-serif", f64::from(size * FINE) * 1.24).into_font().style(FontStyle::Bold).into()
}

fn at(side: HPos, style: TextStyle<'_>) -> TextStyle<'_> {
    style.pos(Pos::new(side, VPos::Center))
}

/// A number with a sign that is as wide as a digit; rounded, because ticks may be a rounding away from what they mean.
fn number(x: f64) -> String {
    let rounded = (x * 1e9).round() / 1e9 + 0.0;
    rounded.to_string().replace('-', "−")
}

/// A whole number as an exponent.
fn superscript(n: f64) -> String {
    let raised = |c| match c {
        '-' => '⁻',
        digit => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize - '0' as usize],
    };
    format!("{n:.0}").chars().map(raised).collect()
}
