//! Who is first at an error: the best of ours, of other crates, and of steps by hand.

use crate::entry::Whose;
use crate::measure::time_at;
use crate::page::Measured;

/// Errors at which winners are named.
pub const LEVELS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// What is wanted: ours in at most so much of the time of the best rival.
pub const WANTED: f64 = 0.7;

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

/// The table of all problems in Markdown.
pub fn table(all: &[Measured]) -> String {
    let mut text = String::from(
        "| problem | error | ours | µs a unit of time | best other crate | µs | ratio | by hand | µs |\n|---|---|---|---|---|---|---|---|---|\n",
    );
    for measured in all {
        for winner in winners(measured) {
            let [ours, rival, hand] = [&winner.ours, &winner.rival, &winner.hand].map(|best| match best {
                Some((name, time)) => (format!("`{name}`"), short(*time)),
                None => ("–".into(), "–".into()),
            });
            let ratio = winner.ratio().map_or("–".into(), |ratio| match ratio {
                ratio if ratio > WANTED => format!("**{ratio:.2}**"),
                ratio => format!("{ratio:.2}"),
            });
            text += &format!(
                "| {} | 10{} | {} | {} | {} | {} | {ratio} | {} | {} |\n",
                measured.problem.title,
                raised(winner.level.log10().round() as i32),
                ours.0,
                ours.1,
                rival.0,
                rival.1,
                hand.0,
                hand.1
            );
        }
    }
    text
}

/// Three digits.
fn short(x: f64) -> String {
    match x {
        x if x >= 100.0 => format!("{x:.0}"),
        x if x >= 10.0 => format!("{x:.1}"),
        x if x >= 1.0 => format!("{x:.2}"),
        x => format!("{x:.3}"),
    }
}

fn raised(n: i32) -> String {
    let digit = |c: char| match c {
        '-' => '⁻',
        c => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][c as usize - '0' as usize],
    };
    n.to_string().chars().map(digit).collect()
}
