//! Elements of an SVG, one in each line. Coordinates are whole tenths of a pixel.

use super::text::{FONT, TITLE};
use std::fmt::Write;

/// The shape of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Marker {
    Disc,
    Square,
    Diamond,
    Up,
    Down,
    Cross,
    Plus,
}

impl Marker {
    /// Returns the corners around the centre. All shapes have about the same area; a disc has no corners.
    fn corners(self) -> &'static [(f64, f64)] {
        match self {
            Marker::Disc => &[],
            Marker::Square => &[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
            Marker::Diamond => &[(0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)],
            Marker::Up => &[(0.0, -1.3), (1.2, 0.9), (-1.2, 0.9)],
            Marker::Down => &[(0.0, 1.3), (1.2, -0.9), (-1.2, -0.9)],
            Marker::Plus => &[
                (-0.4, -1.3),
                (0.4, -1.3),
                (0.4, -0.4),
                (1.3, -0.4),
                (1.3, 0.4),
                (0.4, 0.4),
                (0.4, 1.3),
                (-0.4, 1.3),
                (-0.4, 0.4),
                (-1.3, 0.4),
                (-1.3, -0.4),
                (-0.4, -0.4),
            ],
            Marker::Cross => &[
                (0.0, -0.55),
                (0.75, -1.3),
                (1.3, -0.75),
                (0.55, 0.0),
                (1.3, 0.75),
                (0.75, 1.3),
                (0.0, 0.55),
                (-0.75, 1.3),
                (-1.3, 0.75),
                (-0.55, 0.0),
                (-1.3, -0.75),
                (-0.75, -1.3),
            ],
        }
    }

    /// Returns a closed path around a centre.
    fn around(self, (x, y): Place, r: i32) -> String {
        let scaled =
            |(a, b): &(f64, f64)| (x + (a * f64::from(r)).round() as i32, y + (b * f64::from(r)).round() as i32);
        match self.corners() {
            [] => format!("M{} {y}a{r} {r} 0 1 0 {} 0a{r} {r} 0 1 0 {} 0z", x - r, 2 * r, -2 * r),
            corners => through(&corners.iter().map(scaled).collect::<Vec<_>>()) + "z",
        }
    }
}

/// Returns the commands of a path through places.
fn through(places: &[Place]) -> String {
    let (mut x, mut y) = places[0];
    let mut path = format!("M{x} {y}l");
    for (i, to) in places[1..].iter().enumerate() {
        // A minus sign also separates numbers.
        let (gap, comma) = (if i > 0 && to.0 >= x { " " } else { "" }, if to.1 >= y { " " } else { "" });
        let _ = write!(path, "{gap}{}{comma}{}", to.0 - x, to.1 - y);
        (x, y) = *to;
    }
    path
}

/// Tenths of pixels to the right and down.
pub(super) type Place = (i32, i32);

/// How a path is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pen<'a> {
    pub(super) colour: &'a str,
    /// Width in tenths of a pixel.
    pub(super) width: i32,
    pub(super) dashes: &'a str,
    /// Whether the path is faint, like a grid.
    pub(super) faint: bool,
    /// Name of the area outside of which nothing is drawn.
    pub(super) clip: Option<&'a str>,
    /// Whether the places depend on rounding errors.
    pub(super) rounding: bool,
}

/// The part of a text that stands at its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

pub(super) struct Document {
    text: String,
}

impl Document {
    /// Starts a document of a size in pixels. It shrinks to the width of the page, and takes its colour from the page. As an image it has no
    /// page; then the style makes it light on dark screens.
    pub(super) fn new(width: i32, height: i32, description: &str) -> Self {
        let mut document = Document { text: String::new() };
        document.line(format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {0} {1}\" \
             style=\"max-width:100%;height:auto\" role=\"img\" font-family=\"sans-serif\" font-size=\"{2}\" fill=\"currentColor\">",
            10 * width,
            10 * height,
            10 * FONT
        ));
        document.line(format_args!("<desc>{}</desc>", escaped(description)));
        document.line(format_args!("<style>@media(prefers-color-scheme:dark){{svg:root{{color:#ddd}}}}</style>"));
        document
    }

    pub(super) fn finish(mut self) -> String {
        self.text.push_str("</svg>\n");
        self.text
    }

    fn line(&mut self, element: std::fmt::Arguments<'_>) {
        // Writing to a string does not fail.
        let _ = writeln!(self.text, "{element}");
    }

    /// Defines an area by its upper left corner, its width and its height, in tenths of a pixel.
    pub(super) fn clip(&mut self, id: &str, (x, y): Place, (width, height): Place) {
        self.line(format_args!("<clipPath id=\"{id}\"><path d=\"M{x} {y}h{width}v{height}h{}z\"/></clipPath>", -width));
    }

    /// Writes a text in bold letters.
    pub(super) fn title(&mut self, (x, y): Place, text: &str) {
        let (text, y) = (escaped(text), y + 3 * TITLE);
        self.line(format_args!(
            "<text x=\"{x}\" y=\"{y}\" font-weight=\"bold\" font-size=\"{}\">{text}</text>",
            10 * TITLE
        ));
    }

    /// Writes a text; `y` is the middle of its letters.
    pub(super) fn text(&mut self, (x, y): Place, anchor: Anchor, text: &str) {
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        // The baseline is about a third of the font size below the middle.
        let (text, y) = (escaped(text), y + 10 * FONT / 3);
        self.line(format_args!("<text x=\"{x}\" y=\"{y}\"{anchor}>{text}</text>"));
    }

    /// Draws a line through the places of each part.
    pub(super) fn lines(&mut self, parts: &[Vec<Place>], pen: Pen<'_>) {
        let path: String = parts.iter().filter(|part| part.len() > 1).map(|part| through(part)).collect();
        let clip = pen.clip.map(|id| format!(" clip-path=\"url(#{id})\"")).unwrap_or_default();
        let dashes = match pen.dashes {
            "none" => String::new(),
            dashes => format!(" stroke-dasharray=\"{dashes}\""),
        };
        let faint = if pen.faint { " stroke-opacity=\".15\"" } else { "" };
        let (colour, width, class) = (pen.colour, pen.width, class(pen));
        self.line(format_args!(
            "<path{class} fill=\"none\" stroke=\"{colour}\"{faint} stroke-width=\"{width}\" stroke-linejoin=\"round\"{dashes}{clip} d=\"{path}\"/>"
        ));
    }

    /// Draws markers at places, of a radius in tenths of a pixel. Open markers are outlines.
    pub(super) fn markers(&mut self, places: &[Place], marker: Marker, radius: i32, open: bool, pen: Pen<'_>) {
        let (colour, class) = (pen.colour, class(pen));
        if marker == Marker::Disc && !open {
            // A line of length zero with round ends is a disc, and takes a tenth of the bytes.
            let path: String = places.iter().map(|(x, y)| format!("M{x} {y}h0")).collect();
            self.line(format_args!(
                "<path{class} fill=\"none\" stroke=\"{colour}\" stroke-width=\"{}\" stroke-linecap=\"round\" d=\"{path}\"/>",
                2 * radius
            ));
            return;
        }
        let path: String = places.iter().map(|place| marker.around(*place, radius)).collect();
        let paint = if open {
            format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"{}\"", pen.width)
        } else {
            format!("fill=\"{colour}\"")
        };
        self.line(format_args!("<path{class} {paint} d=\"{path}\"/>"));
    }
}

fn class(pen: Pen<'_>) -> &'static str {
    if pen.rounding { " class=\"rounding\"" } else { "" }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
