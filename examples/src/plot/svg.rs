//! Elements of an SVG, one a line: texts, lines, curves. Coordinates are whole tenths of a pixel.

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
    /// The corners around the centre, of about the same area for all; none for a disc.
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

    /// A closed path around a centre.
    fn around(self, (x, y): Place, r: i32) -> String {
        let scaled =
            |(a, b): &(f64, f64)| (x + (a * f64::from(r)).round() as i32, y + (b * f64::from(r)).round() as i32);
        match self.corners() {
            [] => format!("M{} {y}a{r} {r} 0 1 0 {} 0a{r} {r} 0 1 0 {} 0z", x - r, 2 * r, -2 * r),
            corners => through(&corners.iter().map(scaled).collect::<Vec<_>>()) + "z",
        }
    }
}

/// The commands of a path through places.
fn through(places: &[Place]) -> String {
    let (mut x, mut y) = places[0];
    let mut path = format!("M{x} {y}l");
    for (i, to) in places[1..].iter().enumerate() {
        // A minus sign separates numbers, too.
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
    /// In tenths of a pixel.
    pub(super) width: i32,
    pub(super) dashes: &'a str,
    /// The area beyond which nothing is drawn.
    pub(super) clip: Option<&'a str>,
    /// Whether the places depend on roundings.
    pub(super) rounding: bool,
}

/// On which side of a place a text begins.
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
    /// White, of a size in pixels, and shown as wide as there is room.
    pub(super) fn new(width: i32, height: i32, description: &str) -> Self {
        let mut document = Document { text: String::new() };
        document.line(format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {0} {1}\" \
             style=\"max-width:100%;height:auto\" role=\"img\" font-family=\"sans-serif\" font-size=\"120\">",
            10 * width,
            10 * height
        ));
        document.line(format_args!("<desc>{}</desc>", escaped(description)));
        document.line(format_args!("<path fill=\"#fff\" d=\"M0 0h{}v{}h{}z\"/>", 10 * width, 10 * height, -10 * width));
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

    /// An area by its upper left corner, its width and its height, in tenths of a pixel.
    pub(super) fn clip(&mut self, id: &str, (x, y): Place, (width, height): Place) {
        self.line(format_args!("<clipPath id=\"{id}\"><path d=\"M{x} {y}h{width}v{height}h{}z\"/></clipPath>", -width));
    }

    /// A text at the height of its middle.
    pub(super) fn text(&mut self, (x, y): Place, anchor: Anchor, bold: bool, text: &str) {
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let bold = if bold { " font-weight=\"bold\" font-size=\"140\"" } else { "" };
        // Letters without ascenders are half as high as wide capitals; a third of the size lies above their middle.
        self.line(format_args!(
            "<text x=\"{x}\" y=\"{}\"{anchor}{bold} fill=\"#333\">{}</text>",
            y + 42,
            escaped(text)
        ));
    }

    /// Lines through places; each of the parts begins anew.
    pub(super) fn lines(&mut self, parts: &[Vec<Place>], pen: Pen<'_>) {
        let path: String = parts.iter().filter(|part| part.len() > 1).map(|part| through(part)).collect();
        let clip = pen.clip.map(|id| format!(" clip-path=\"url(#{id})\"")).unwrap_or_default();
        let dashes = match pen.dashes {
            "none" => String::new(),
            dashes => format!(" stroke-dasharray=\"{dashes}\""),
        };
        let (colour, width, class) = (pen.colour, pen.width, class(pen));
        self.line(format_args!(
            "<path{class} fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"{dashes}{clip} d=\"{path}\"/>"
        ));
    }

    /// Markers at places, of a radius in tenths of a pixel; open ones have white inside.
    pub(super) fn markers(&mut self, places: &[Place], marker: Marker, radius: i32, open: bool, pen: Pen<'_>) {
        let (colour, class) = (pen.colour, class(pen));
        if marker == Marker::Disc && !open {
            // A line of no length with round ends is a disc, in a tenth of the bytes.
            let path: String = places.iter().map(|(x, y)| format!("M{x} {y}h0")).collect();
            self.line(format_args!(
                "<path{class} fill=\"none\" stroke=\"{colour}\" stroke-width=\"{}\" stroke-linecap=\"round\" d=\"{path}\"/>",
                2 * radius
            ));
            return;
        }
        let path: String = places.iter().map(|place| marker.around(*place, radius)).collect();
        let paint = if open {
            format!("fill=\"#fff\" fill-opacity=\".6\" stroke=\"{colour}\" stroke-width=\"{}\"", pen.width)
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
