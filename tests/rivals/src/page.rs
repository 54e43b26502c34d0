//! What is written: a figure a problem, all numbers, a page with all figures, and the table of winners.

use crate::entry::{Entry, Point, Whose};
use crate::problems::Problem;
use crate::winners;
use geoint_examples::output;
use geoint_examples::plot::{Axis, Curve, Panel, figure, palette};
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// A problem with what was measured of its entries.
pub struct Measured {
    /// The problem.
    pub problem: Problem,
    /// Of each entry.
    pub points: Vec<Vec<Point>>,
}

const FOLDER: &str = "work_precision";

/// Writes everything to the folder of output, and figures and the table to `tests/benches/work_precision` if asked to.
pub fn write(all: &[Measured], commit: bool) -> Result<(), Box<dyn Error>> {
    for measured in all {
        figure(&format!("{FOLDER}/{}.svg", measured.problem.name), (620, 430), &[panel(measured)])?;
    }
    fs::write(output(&format!("{FOLDER}/results.csv"))?, results(all)?)?;
    fs::write(output(&format!("{FOLDER}/index.html"))?, html(all))?;
    let table = winners::table(all);
    println!("\n{table}");
    fs::write(output(&format!("{FOLDER}/winners.md"))?, &table)?;
    if commit {
        let to = Path::new(env!("CARGO_MANIFEST_DIR")).join("../benches").join(FOLDER);
        fs::create_dir_all(&to)?;
        for measured in all {
            let file = format!("{}.svg", measured.problem.name);
            fs::copy(output(&format!("{FOLDER}/{file}"))?, to.join(file))?;
        }
        fs::write(to.join("README.md"), page(all, &table))?;
    }
    Ok(())
}

/// The lower envelope of a family: time a unit of time in microseconds, and error.
fn envelope<'a>(measured: &'a Measured, chosen: impl Fn(&Entry) -> bool) -> Vec<(f64, f64)> {
    let entries = measured.problem.entries.iter().zip(&measured.points).filter(|(entry, _)| chosen(entry));
    let mut points: Vec<(f64, f64)> = entries
        .flat_map(|(_, points)| {
            points.iter().map(|point| (1e6 * point.least() / measured.problem.duration, point.error))
        })
        .collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut least = f64::INFINITY;
    points.retain(|point| {
        let better = point.1 < least;
        least = least.min(point.1);
        better
    });
    points
}

/// Families in the order in which they come, without repetitions.
fn families(problem: &Problem, whose: Whose) -> Vec<&'static str> {
    let mut families = vec![];
    for entry in problem.entries.iter().filter(|entry| entry.whose == whose) {
        if !families.contains(&entry.family) {
            families.push(entry.family);
        }
    }
    families
}

fn panel(measured: &Measured) -> Panel {
    let Problem { title, note, .. } = &measured.problem;
    let mut curves = vec![];
    for (whose, inks) in
        [(Whose::Ours, &palette::ALL[..]), (Whose::Rival, &palette::ALL[1..]), (Whose::Hand, &palette::ALL[6..])]
    {
        for (family, ink) in families(&measured.problem, whose).into_iter().zip(inks.iter().cycle()) {
            let points = envelope(measured, |entry| entry.whose == whose && entry.family == family);
            let curve = Curve::line(family, *ink, points);
            curves.push(match whose {
                Whose::Ours => curve.solid().marked(2.5),
                Whose::Rival => curve,
                Whose::Hand => curve.solid().width(0.8).marked(2.5).open(),
            });
        }
    }
    let decades = |of: fn(&(f64, f64)) -> f64| {
        let all = envelope_points(measured);
        let least = all.iter().map(of).fold(f64::INFINITY, f64::min).log10().floor();
        let most = all.iter().map(of).fold(0.0, f64::max).log10().ceil();
        least..most.max(least + 1.0)
    };
    let x = Axis::decades("µs for a unit of time", decades(|point| point.0));
    let y = Axis::decades("error at the end, relative", decades(|point| point.1));
    Panel::new(*title, format!("{note}. Ours solid, other crates dashed, by hand with open markers"), [x, y], curves)
}

fn envelope_points(measured: &Measured) -> Vec<(f64, f64)> {
    measured
        .points
        .iter()
        .flatten()
        .map(|point| (1e6 * point.least() / measured.problem.duration, point.error.max(1e-17)))
        .collect()
}

fn results(all: &[Measured]) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut table = csv::Writer::from_writer(vec![]);
    table.write_record(["problem", "whose", "family", "method", "effort", "error", "least s", "median s"])?;
    for Measured { problem, points } in all {
        for (entry, points) in problem.entries.iter().zip(points) {
            for point in points {
                let whose = format!("{:?}", entry.whose).to_lowercase();
                let numbers = [point.effort, point.error, point.least(), point.median()].map(|x| format!("{x:e}"));
                let words = [problem.name, &whose, entry.family, &entry.name].map(String::from);
                table.write_record(words.into_iter().chain(numbers))?;
            }
        }
    }
    Ok(table.into_inner()?)
}

const STYLE: &str = "\
:root{color-scheme:light dark}\
body{font:16px/1.5 system-ui,sans-serif;margin:0 auto;max-width:60rem;padding:1rem;background:#fff;color:#222}\
img{width:100%;height:auto}\
.wide{overflow-x:auto}\
table{border-collapse:collapse;font-size:.85rem}\
td,th{padding:.2rem .6rem;border-bottom:1px solid #bbb;text-align:left;white-space:nowrap}\
.slow{font-weight:bold;color:#b00020}\
@media(prefers-color-scheme:dark){body{background:#161616;color:#ddd}td,th{border-color:#444}.slow{color:#ff8a80}\
img{filter:invert(.92) hue-rotate(180deg)}}";

fn html(all: &[Measured]) -> String {
    let mut text = String::new();
    let _ = write!(
        text,
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n\
         <title>Run time against error</title>\n<style>{STYLE}</style>\n<h1>Run time against error</h1>\n\
         <p>The relative error at the end against the time for a unit of simulated time: the shortest of {} runs in turns. A ratio is our time over \
         that of the fastest other crate; those above {} are marked.</p>\n",
        crate::measure::ROUNDS,
        winners::WANTED
    );
    for measured in all {
        let Problem { name, title, note, reference, .. } = &measured.problem;
        let _ = write!(
            text,
            "<h2>{title}</h2>\n<p>{note}. Reference: {reference}.</p>\n<img src=\"{name}.svg\" alt=\"{title}: error against time\">\n\
             <div class=\"wide\"><table>\n<tr><th>error<th>ours<th>µs<th>other crate<th>µs<th>ratio<th>by hand<th>µs\n"
        );
        for winner in winners::winners(measured) {
            let cells = [&winner.ours, &winner.rival, &winner.hand].map(|best| match best {
                Some((name, time)) => format!("<td>{}<td>{time:.3}", name.replace('<', "&lt;")),
                None => "<td>–<td>–".into(),
            });
            let slow = if winner.ratio().is_some_and(|ratio| ratio > winners::WANTED) { " class=\"slow\"" } else { "" };
            let ratio = winner.ratio().map_or("–".into(), |ratio| format!("{ratio:.2}"));
            let [ours, rival, hand] = cells;
            let _ = writeln!(text, "<tr><td>{:.0e}{ours}{rival}<td{slow}>{ratio}{hand}", winner.level);
        }
        text.push_str("</table></div>\n");
    }
    text.push_str("</html>\n");
    text
}

/// The page that is committed.
fn page(all: &[Measured], table: &str) -> String {
    let mut text = format!(
        "# Run time against error\n\n```text\ncargo run --release --manifest-path tests/rivals/Cargo.toml -- --commit\n```\n\n\
         The relative error at the end against the time for a unit of simulated time, each the shortest of {} runs in turns with all others. \
         Lines are lower envelopes of families. In the table a time is interpolated between runs; a ratio is ours over the fastest other crate, \
         bold above {}.\n\n{table}",
        crate::measure::ROUNDS,
        winners::WANTED
    );
    for measured in all {
        let Problem { name, title, note, reference, .. } = &measured.problem;
        let _ = write!(text, "\n## {title}\n\n{note}. Reference: {reference}.\n\n![{title}]({name}.svg)\n");
    }
    text
}
