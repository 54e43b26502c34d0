//! The tables, once for both pages: rows of cells, some of which are marked.

use crate::long::{After, Long};
use crate::page::Measured;
use crate::winners::{self, SAME, WANTED, Winner, power, short};

/// What stands in a table.
pub struct Cell {
    /// Its words.
    pub text: String,
    /// Whether it misses what is wanted.
    pub marked: bool,
}

/// Headings and rows.
pub struct Table {
    headings: Vec<&'static str>,
    rows: Vec<Vec<Cell>>,
}

fn cell(text: impl Into<String>) -> Cell {
    Cell { text: text.into(), marked: false }
}

impl Table {
    /// In Markdown, with marks in bold.
    pub fn markdown(&self) -> String {
        let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
        let shown = |cell: &Cell| if cell.marked { format!("**{}**", cell.text) } else { cell.text.clone() };
        let mut text = line(self.headings.iter().map(|heading| (*heading).to_owned()).collect());
        text += &format!("|{}\n", "---|".repeat(self.headings.len()));
        text.extend(self.rows.iter().map(|row| line(row.iter().map(shown).collect())));
        text
    }

    /// Empties the first cell of each row that repeats the first cell of the row above.
    pub fn grouped(mut self) -> Self {
        let mut above = String::new();
        for row in &mut self.rows {
            if row[0].text == above {
                row[0].text.clear();
            } else {
                above.clone_from(&row[0].text);
            }
        }
        self
    }

    /// As it stands in a page.
    pub fn html(&self) -> String {
        let escaped = |text: &str| text.replace('&', "&amp;").replace('<', "&lt;");
        let heading = |heading: &&str| format!("<th>{}", escaped(heading));
        let shown =
            |cell: &Cell| format!("<td{}>{}", if cell.marked { " class=\"slow\"" } else { "" }, escaped(&cell.text));
        let mut text = String::from("<div class=\"wide\"><table>\n<tr>");
        text.extend(self.headings.iter().map(heading));
        for row in &self.rows {
            text += "\n<tr>";
            text.extend(row.iter().map(shown));
        }
        text + "\n</table></div>\n"
    }
}

/// Winners of problems at all levels, with steps by hand. Times are microseconds a unit of time.
pub fn winners<'a>(all: impl IntoIterator<Item = &'a Measured>) -> Table {
    let headings = vec!["problem", "error", "ours", "µs", "best other crate", "µs", "ratio", "by hand", "µs"];
    let mut rows = vec![];
    for measured in all {
        for winner in winners::winners(measured) {
            let best = [&winner.ours, &winner.rival, &winner.hand].map(|best| match best {
                Some((name, time)) => [cell(name.clone()), cell(short(*time))],
                None => [cell("–"), cell("–")],
            });
            let [ours, rival, hand] = best;
            let first = vec![cell(measured.problem.title), cell(power(winner.level))];
            rows.push(first.into_iter().chain(ours).chain(rival).chain([ratio(&winner)]).chain(hand).collect());
        }
    }
    Table { headings, rows }
}

/// Winners of problems at all levels, with the time in the cell of the method, and without steps by hand.
pub fn short_winners(all: &[Measured]) -> Table {
    let headings = vec!["problem", "error", "ours, µs", "best other crate, µs", "ratio"];
    let best = |best: &Option<(String, f64)>| {
        cell(best.as_ref().map_or("–".into(), |(name, time)| format!("{name}, {}", short(*time))))
    };
    let rows = all.iter().flat_map(|measured| {
        winners::winners(measured).into_iter().map(|winner| {
            let first = [cell(measured.problem.title), cell(power(winner.level))];
            first.into_iter().chain([best(&winner.ours), best(&winner.rival), ratio(&winner)]).collect()
        })
    });
    Table { headings, rows: rows.collect() }.grouped()
}

/// Our time over the time of the best other crate; marked if it misses the goal.
fn ratio(winner: &Winner) -> Cell {
    Cell {
        text: winner.ratio().map_or("–".into(), |ratio| format!("{ratio:.2}")),
        marked: winner.is_lost() || winner.ratio().is_some_and(|ratio| ratio > WANTED),
    }
}

/// Generated steps beside the same ones by hand.
pub fn twins(all: &[Measured]) -> Table {
    let rows = all.iter().flat_map(|measured| {
        winners::twins(measured).into_iter().map(|(name, [generated, by_hand], ratio)| {
            let ratio = Cell { text: format!("{ratio:.2}"), marked: ratio > SAME };
            let times = [generated, by_hand].map(|time| cell(short(time)));
            [cell(measured.problem.title), cell(name)].into_iter().chain(times).chain([ratio]).collect()
        })
    });
    Table { headings: vec!["problem", "method", "generated, ns a step", "by hand", "ratio"], rows: rows.collect() }
}

/// Generated steps beside the same ones by hand, without the times by hand.
pub fn short_twins(all: &[Measured]) -> Table {
    let Table { mut headings, mut rows } = twins(all);
    headings.remove(3);
    for row in &mut rows {
        row.remove(3);
    }
    Table { headings, rows }.grouped()
}

/// Energies over long times.
pub fn long(all: &[Long]) -> Table {
    let error = |after: &After| match after {
        After::Error(error) => cell(format!("{error:.1e}")),
        After::Refused => cell("refused"),
        After::TooLong => cell("too long"),
    };
    let row = |long: &Long| {
        let whose = cell(long.name.clone());
        let effort = cell(long.effort.clone());
        [whose, effort, cell(short(long.cost))].into_iter().chain(long.errors.iter().map(error)).collect()
    };
    let headings = vec!["method", "steps a period, or tolerance", "ns a period", "10 periods", "10⁴", "10⁷"];
    Table { headings, rows: all.iter().map(row).collect() }
}
