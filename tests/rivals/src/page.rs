//! What is written: a figure a problem, all numbers, a page with all figures, and the tables.

use crate::entry::{Entry, Point, Whose};
use crate::long::Long;
use crate::measure::ROUNDS;
use crate::problems::Problem;
use crate::tables;
use crate::winners::{self, SAME, WANTED};
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
/// For which processors the program was built.
const BUILD: &str = if cfg!(target_feature = "fma") { "native" } else { "plain" };

/// Writes everything to the folder of output, and figures and tables to `tests/benches/work_precision` if asked to.
pub fn write(all: &[Measured], long: &[Long], commit: bool) -> Result<(), Box<dyn Error>> {
    for measured in all {
        figure(&format!("{FOLDER}/{}.svg", measured.problem.name), (620, 430), &[panel(measured)])?;
    }
    fs::write(output(&format!("{FOLDER}/results.csv"))?, results(all)?)?;
    let index = output(&format!("{FOLDER}/index.html"))?;
    fs::write(&index, html(all, long)?)?;
    println!("\n{}", tables::twins(all).markdown());
    if !long.is_empty() {
        println!("{}", tables::long(long).markdown());
    }
    println!("page        {}", geoint_examples::shown(&index));
    if commit {
        let to = Path::new(env!("CARGO_MANIFEST_DIR")).join("../benches").join(FOLDER);
        fs::create_dir_all(&to)?;
        if BUILD == "plain" {
            for measured in all {
                let file = format!("{}.svg", measured.problem.name);
                fs::copy(output(&format!("{FOLDER}/{file}"))?, to.join(file))?;
            }
        }
        fs::write(to.join(if BUILD == "plain" { "README.md" } else { "native.md" }), markdown(all, long))?;
    }
    Ok(())
}

/// Points as they are drawn: microseconds for a unit of time, and error.
fn places<'a>(measured: &'a Measured, chosen: impl Fn(&Entry) -> bool + 'a) -> impl Iterator<Item = (f64, f64)> + 'a {
    let Measured { problem, points } = measured;
    let chosen = problem.entries.iter().zip(points).filter(move |(entry, _)| chosen(entry));
    chosen.flat_map(|(_, points)| points).map(|point| (1e6 * point.least() / problem.duration, point.error.max(1e-17)))
}

/// The lower envelope of a family.
fn envelope(measured: &Measured, chosen: impl Fn(&Entry) -> bool) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = places(measured, chosen).collect();
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
    let Problem { title, note, measured: what, .. } = &measured.problem;
    let mut curves = vec![];
    for (whose, inks) in
        [(Whose::Ours, &palette::ALL[..]), (Whose::Rival, &palette::ALL[1..]), (Whose::Hand, &palette::ALL[6..])]
    {
        for (family, ink) in families(&measured.problem, whose).into_iter().zip(inks.iter().cycle()) {
            let points = envelope(measured, |entry| entry.whose == whose && entry.family == family);
            if points.is_empty() {
                continue;
            }
            let curve = Curve::line(family, *ink, points).rounding();
            curves.push(match whose {
                Whose::Ours => curve.solid().marked(2.5),
                Whose::Rival => curve,
                Whose::Hand => curve.solid().width(0.8).marked(2.5).open(),
            });
        }
    }
    let decades = |of: fn(&(f64, f64)) -> f64| {
        let (least, most) = places(measured, |_| true)
            .map(|point| of(&point))
            .fold((f64::INFINITY, 0.0_f64), |(least, most), x| (least.min(x), most.max(x)));
        let (least, most) = (least.log10().floor(), most.log10().ceil());
        least..most.max(least + 1.0)
    };
    let x = Axis::decades("µs for a unit of time", decades(|point| point.0));
    let y = Axis::decades("error", decades(|point| point.1));
    let note = format!("{note}. The error is {what}. Ours solid, other crates dashed, by hand with open markers");
    Panel::new(*title, note, [x, y], curves)
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
.wide{overflow-x:auto}\
.wide svg{display:block;min-width:44rem}\
table{border-collapse:collapse;font-size:.85rem}\
td,th{padding:.2rem .6rem;border-bottom:1px solid #bbb;text-align:left;white-space:nowrap}\
.slow{font-weight:bold;color:#b00020}\
@media(prefers-color-scheme:dark){body{background:#161616;color:#ddd}td,th{border-color:#444}.slow{color:#ff8a80}}";

/// What the tables are about.
fn opening() -> String {
    format!(
        "Each method runs with many step sizes or tolerances, in a {BUILD} build. Times are microseconds for one unit of simulated time: the shortest of \
         {ROUNDS} runs in turns with all other methods. The time for an error is interpolated; all finer runs have at most this error. The ratio is our \
         time over the time of the fastest other crate. At most {WANTED} is wanted."
    )
}

/// What the second table is about.
fn about_twins() -> String {
    format!(
        "Nanoseconds a step of generated steps, and their time over that of the same steps by hand: medians over numbers of steps. Hand-written steps \
         of `DiscreteGradient` carry rounding errors as generated steps do. At most {SAME} is wanted."
    )
}

const ABOUT_LONG: &str = "A regular Hénon–Heiles orbit with the period 2π: the largest relative error of the energy in five periods up to a time. Times \
                          are those of short runs.";

const ABOUT_FIGURES: &str = "A line is the lower envelope of a family of methods. Each figure states its start, its duration T and its error. The reference \
                             comes from extrapolation to order 24 in double-double arithmetic.";

/// What is missed, as sentences.
fn missed(measured: &Measured) -> String {
    let missed = winners::missed(measured);
    if missed.is_empty() { String::new() } else { format!("Missed: {}.", missed.join("; ")) }
}

fn html(all: &[Measured], long: &[Long]) -> Result<String, Box<dyn Error>> {
    let mut text = String::new();
    write!(
        text,
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n\
         <title>Run time against error</title>\n<style>{STYLE}</style>\n<h1>Run time against error</h1>\n<p>{}</p>\n",
        opening()
    )?;
    for measured in all {
        let Problem { name, title, note, measured: what, reference, .. } = &measured.problem;
        let figure = fs::read_to_string(output(&format!("{FOLDER}/{name}.svg"))?)?;
        write!(
            text,
            "<h2>{title}</h2>\n<p>{note}. The error is {what}. Reference: {reference}.</p>\n<div class=\"wide\">{figure}</div>\n<p class=\"slow\">{}</p>\n{}",
            missed(measured).replace('<', "&lt;"),
            tables::winners([measured]).html()
        )?;
    }
    write!(text, "<h2>Generated and by hand</h2>\n<p>{}</p>\n{}", about_twins(), tables::twins(all).html())?;
    if !long.is_empty() {
        write!(text, "<h2>Energy over long times</h2>\n<p>{ABOUT_LONG}</p>\n{}", tables::long(long).html())?;
    }
    text.push_str("</html>\n");
    Ok(text)
}

/// The page that is committed.
fn markdown(all: &[Measured], long: &[Long]) -> String {
    let flags = if BUILD == "plain" { "" } else { "RUSTFLAGS=\"-C target-cpu=native\" " };
    let mut text = format!(
        "# Run time against error, {BUILD} build\n\n```text\n{flags}cargo run --release --manifest-path tests/rivals/Cargo.toml -- --commit\n```\n\n{}\n\n{}\n",
        opening(),
        tables::short_winners(all).markdown()
    );
    for measured in all {
        let missed = missed(measured);
        if !missed.is_empty() {
            text += &format!("**{}.** {missed}\n\n", measured.problem.title);
        }
    }
    text += &format!("## Generated and by hand\n\n{}\n\n{}", about_twins(), tables::short_twins(all).markdown());
    if BUILD == "plain" && !long.is_empty() {
        text += &format!("\n## Energy over long times\n\n{ABOUT_LONG}\n\n{}", tables::long(long).grouped().markdown());
    }
    if BUILD == "plain" {
        text += &format!("\n## Figures\n\n{ABOUT_FIGURES}\n");
        for measured in all {
            let Problem { name, title, .. } = &measured.problem;
            text += &format!("\n![{title}]({name}.svg)\n");
        }
    }
    text
}
