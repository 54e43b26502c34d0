//! Curves: points with a line, with markers, or with both.

use super::svg::Marker;

/// Colour, dashes and marker of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ink {
    pub(super) colour: &'static str,
    /// Lengths of dashes and gaps, in tenths of a pixel.
    pub(super) dashes: &'static str,
    pub(super) marker: Marker,
}

/// Colours after M. Okabe and K. Ito, which colour-blind readers can distinguish. Blue is lighter, and orange and sky blue are darker, so that
/// all are readable on white and on black. Each has its own dashes and its own marker.
pub mod palette {
    use super::{Ink, Marker};

    const fn ink(colour: &'static str, dashes: &'static str, marker: Marker) -> Ink {
        Ink { colour, dashes, marker }
    }

    /// Blue: without dashes; discs.
    pub const BLUE: Ink = ink("#0f7bc0", "none", Marker::Disc);
    /// Vermilion: dashes; squares.
    pub const VERMILION: Ink = ink("#d55e00", "70 30", Marker::Square);
    /// Bluish green: dashes and dots; diamonds.
    pub const GREEN: Ink = ink("#009e73", "90 30 20 30", Marker::Diamond);
    /// Orange: short dashes; triangles.
    pub const ORANGE: Ink = ink("#bf8600", "40 25", Marker::Up);
    /// Sky blue: dots; triangles upside down.
    pub const SKY: Ink = ink("#3a9cd4", "18 18", Marker::Down);
    /// Reddish purple: dashes and two dots; crosses.
    pub const PURPLE: Ink = ink("#cb76a5", "80 25 18 25 18 25", Marker::Cross);
    /// The colour of texts, black on a light page: long dashes; upright crosses.
    pub const BLACK: Ink = ink("currentColor", "140 40", Marker::Plus);
    /// All colours but grey. The first ones differ most.
    pub const ALL: [Ink; 7] = [BLUE, VERMILION, GREEN, ORANGE, SKY, PURPLE, BLACK];
    /// Grey, for a reference: a wider line without dashes.
    pub const GREY: Ink = ink("#8c8c8c", "none", Marker::Disc);
}

/// Points with a line, with markers, or with both.
#[derive(Clone, Debug)]
pub struct Curve {
    pub(super) name: String,
    pub(super) ink: Ink,
    /// Width of the line in pixels; zero for no line.
    pub(super) width: f64,
    /// Half the size of the markers in pixels; zero for no markers.
    pub(super) marker: f64,
    pub(super) marked: Marked,
    pub(super) open: bool,
    pub(super) rounding: bool,
    pub(super) points: Vec<(f64, f64)>,
}

/// Which points have markers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Marked {
    All,
    Last,
}

impl Curve {
    /// Draws a line without markers. A curve without a name belongs to the curve before it.
    pub fn line(name: impl Into<String>, ink: Ink, points: Vec<(f64, f64)>) -> Self {
        let width = if ink == palette::GREY { 3.0 } else { 1.6 };
        let name = name.into();
        Curve { name, ink, width, marker: 0.0, marked: Marked::All, open: false, rounding: false, points }
    }

    /// Draws markers without a line.
    pub fn dots(name: impl Into<String>, ink: Ink, points: Vec<(f64, f64)>) -> Self {
        Curve { width: 0.0, marker: 3.0, ..Curve::line(name, ink, points) }
    }

    /// Returns the shape of the markers. Very small markers are discs.
    pub(super) fn shape(&self) -> Marker {
        if self.marker < 1.2 { Marker::Disc } else { self.ink.marker }
    }

    /// Sets the width of the line in pixels.
    pub fn width(self, width: f64) -> Self {
        Curve { width, ..self }
    }

    /// Draws markers of twice this size in pixels at all points.
    pub fn marked(self, marker: f64) -> Self {
        Curve { marker, ..self }
    }

    /// Draws one marker at the last point.
    pub fn marked_at_end(self, marker: f64) -> Self {
        Curve { marker, marked: Marked::Last, ..self }
    }

    /// Draws only the outlines of markers, so that they do not hide other curves.
    pub fn open(self) -> Self {
        Curve { open: true, ..self }
    }

    /// Draws the line without dashes, for short or winding curves.
    pub fn solid(self) -> Self {
        Curve { ink: Ink { dashes: "none", ..self.ink }, ..self }
    }

    /// Marks points that depend on rounding errors: they may differ on another processor.
    pub fn rounding(self) -> Self {
        Curve { rounding: true, ..self }
    }
}
