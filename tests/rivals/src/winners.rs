//! Who is first at an error: the best of ours, of other crates, and of steps by hand; and generated steps beside the same ones by hand.

use crate::entry::{Entry, Point, Whose, median};
use crate::measure::time_at;
use crate::page::Measured;

/// Errors at which winners are named.
pub const LEVELS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// What is wanted: ours in at most so much of the time of the best rival,
pub const WANTED: f64 = 0.7;

/// and generated steps in at most so much of the time of the same ones by hand.
pub const SAME: f64 = 1.05;

/// Shorter runs are mostly their beginning and end.
const SHORTEST: f64 = 2e-5;

/// Who is first at a level.
pub struct Winner {
    /// The error.
    pub level: f64,
    /// The fastest of each kind, with microseconds per unit of time.
    pub ours: Option<(String, f64)>,
    /// Of other crates.
    pub rival: Option<(String, f64)>,
    /// Of steps by hand.
    pub hand: Option<(String, f64)>,
}

impl Winner {
    /// Our time over that of the best rival.
    pub fn ratio(&self) -> Option<f64> {
        Some(self.ours.as_ref()?.1 / self.rival.as_ref()?.1)
    }

    /// Whether another crate is first, or has the level alone.
    pub fn is_lost(&self) -> bool {
        self.rival.is_some() && self.ratio().is_none_or(|ratio| ratio > 1.0)
    }
}

/// The winners of a problem at all levels.
pub fn winners(Measured { problem, points }: &Measured) -> Vec<Winner> {
    let best = |whose: Whose, level: f64| {
        let times = problem.entries.iter().zip(points).filter(|(entry, _)| entry.whose == whose);
        let times = times.filter_map(|(entry, points)| Some((entry.name.clone(), time_at(points, level)?)));
        let fastest = times.min_by(|a, b| a.1.total_cmp(&b.1));
        fastest.map(|(name, seconds)| (name, 1e6 * seconds / problem.duration))
    };
    let at = |level| Winner {
        level,
        ours: best(Whose::Ours, level),
        rival: best(Whose::Rival, level),
        hand: best(Whose::Hand, level),
    };
    LEVELS.into_iter().map(at).collect()
}

/// Generated steps beside the same ones by hand: the method, nanoseconds a step of both, and the ratio, medians over numbers of steps.
pub fn twins(Measured { problem, points }: &Measured) -> Vec<(String, [f64; 2], f64)> {
    let all = || problem.entries.iter().zip(points);
    let hands = all().filter(|(entry, _)| entry.whose == Whose::Hand);
    hands
        .filter_map(|(hand, by_hand): (&Entry, &Vec<Point>)| {
            let same = |entry: &Entry| entry.whose == Whose::Ours && entry.name == hand.name;
            let (_, generated) = all().find(|(entry, _)| same(entry))?;
            let pairs: Vec<(&Point, &Point)> = generated
                .iter()
                .filter_map(|point| Some((point, by_hand.iter().find(|other| other.effort == point.effort)?)))
                .filter(|(_, other)| other.least() > SHORTEST)
                .collect();
            let over = |of: &dyn Fn(&(&Point, &Point)) -> f64| median(pairs.iter().map(of).collect());
            let times = [
                over(&|(ours, _)| 1e9 * ours.least() / ours.effort),
                over(&|(_, hand)| 1e9 * hand.least() / hand.effort),
            ];
            Some((hand.name.clone(), times, over(&|(ours, hand)| ours.least() / hand.least())))
        })
        .filter(|(_, _, ratio)| ratio.is_finite())
        .collect()
}

/// In words, what is missed of a problem; nothing if nothing is.
pub fn missed(measured: &Measured) -> Vec<String> {
    let mut missed = vec![];
    for winner in winners(measured) {
        let level = power(winner.level);
        match (&winner.ours, &winner.rival, winner.ratio()) {
            (Some((ours, _)), Some((rival, _)), Some(ratio)) if ratio > 1.0 => {
                missed.push(format!("at {level} {rival} is faster: {ours} takes {ratio:.2} of its time"));
            }
            (Some((ours, _)), Some((rival, _)), Some(ratio)) if ratio > WANTED => {
                missed.push(format!("at {level} {ours} takes {ratio:.2} of the time of {rival}, above {WANTED}"));
            }
            (None, Some((rival, _)), _) => missed.push(format!("{level} is reached by {rival} alone")),
            _ => {}
        }
    }
    missed
}

/// A power of ten in words.
pub fn power(level: f64) -> String {
    let digit = |c: char| match c {
        '-' => '⁻',
        c => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][c as usize - '0' as usize],
    };
    let raised: String = (level.log10().round() as i32).to_string().chars().map(digit).collect();
    format!("10{raised}")
}

/// Three digits.
pub fn short(x: f64) -> String {
    match x {
        x if x >= 100.0 => format!("{x:.0}"),
        x if x >= 10.0 => format!("{x:.1}"),
        x if x >= 1.0 => format!("{x:.2}"),
        x if x >= 0.1 => format!("{x:.3}"),
        x => format!("{x:.2e}"),
    }
}
