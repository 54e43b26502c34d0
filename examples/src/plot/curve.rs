//! What is drawn: points, and what tells them from those of other curves.

use super::svg::Marker;

/// How curves are told apart: by colour, by dashes, by the shape of their points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ink {
    pub(super) colour: &'static str,
    /// Lengths of dashes and gaps, in tenths of a pixel.
    pub(super) dashes: &'static str,
    pub(super) marker: Marker,
}

/// Colours of M. Okabe and K. Ito, which colour-blind readers tell apart; each has dashes and a marker of its own, for
/// readers who see none of them.
pub mod palette {
    use super::{Ink, Marker};

    const fn ink(colour: &'static str, dashes: &'static str, marker: Marker) -> Ink {
        Ink { colour, dashes, marker }
    }

    /// Blue: without dashes; discs.
    pub const BLUE: Ink = ink("#0072b2", "none", Marker::Disc);
    /// Vermilion: dashes; squares.
    pub const VERMILION: Ink = ink("#d55e00", "70 30", Marker::Square);
    /// Bluish green: dashes and dots; diamonds.
    pub const GREEN: Ink = ink("#009e73", "90 30 20 30", Marker::Diamond);
    /// Orange: short dashes; triangles.
    pub const ORANGE: Ink = ink("#e69f00", "40 25", Marker::Up);
    /// Sky blue: dots; triangles upside down.
    pub const SKY: Ink = ink("#56b4e9", "18 18", Marker::Down);
    /// Reddish purple: dashes and two dots; crosses.
    pub const PURPLE: Ink = ink("#cc79a7", "80 25 18 25 18 25", Marker::Cross);
    /// Nearly black: long dashes; upright crosses.
    pub const BLACK: Ink = ink("#262626", "140 40", Marker::Plus);
    /// The seven, the most different ones first.
    pub const ALL: [Ink; 7] = [BLUE, VERMILION, GREEN, ORANGE, SKY, PURPLE, BLACK];
    /// Grey, for what the others are compared with; without dashes, and wider.
    pub const GREY: Ink = ink("#9a9a9a", "none", Marker::Disc);
}

/// Points with a line, with markers, or with both.
#[derive(Clone, Debug)]
pub struct Curve {
    pub(super) name: String,
    pub(super) ink: Ink,
    /// Of the line, in pixels; none if zero.
    pub(super) width: f64,
    /// Half the size of the markers, in pixels; none if zero.
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
    /// A line without markers. Curves without a name belong to the one before.
    pub fn line(name: impl Into<String>, ink: Ink, points: Vec<(f64, f64)>) -> Self {
        let width = if ink == palette::GREY { 3.0 } else { 1.6 };
        let name = name.into();
        Curve { name, ink, width, marker: 0.0, marked: Marked::All, open: false, rounding: false, points }
    }

    /// Markers without a line.
    pub fn dots(name: impl Into<String>, ink: Ink, points: Vec<(f64, f64)>) -> Self {
        Curve { width: 0.0, marker: 3.0, ..Curve::line(name, ink, points) }
    }

    /// Markers that are too small for a shape are discs.
    pub(super) fn shape(&self) -> Marker {
        if self.marker < 1.2 { Marker::Disc } else { self.ink.marker }
    }

    /// With a line of this width in pixels.
    pub fn width(self, width: f64) -> Self {
        Curve { width, ..self }
    }

    /// With markers at all points, of twice this size in pixels.
    pub fn marked(self, marker: f64) -> Self {
        Curve { marker, ..self }
    }

    /// With a marker at its end.
    pub fn marked_at_end(self, marker: f64) -> Self {
        Curve { marker, marked: Marked::Last, ..self }
    }

    /// With markers that do not hide what lies below.
    pub fn open(self) -> Self {
        Curve { open: true, ..self }
    }

    /// Without dashes, where a line is too short or too winding for them.
    pub fn solid(self) -> Self {
        Curve { ink: Ink { dashes: "none", ..self.ink }, ..self }
    }

    /// The points are roundings, or depend on them: another processor may place them elsewhere.
    pub fn rounding(self) -> Self {
        Curve { rounding: true, ..self }
    }
}
