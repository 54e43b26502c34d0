//! Benchmark of steps: each generated stepper beside an expert's hand-written one.
//!
//! `cargo bench -p geoint-benches --bench step` prints tables of ratios, then criterion's absolute times of one step.
//! `RATIOS=only` omits criterion's part.

#[allow(dead_code, reason = "other programs use the rest")]
mod by_hand;
mod comparisons;
mod paired;
mod rows;
mod systems;

use criterion::Criterion;
use paired::{Pair, Ratio, Run};
use std::hint::black_box;
use std::time::{Duration, Instant};

fn main() {
    let by_hand = rows::all();
    let tables = [
        ("discrete gradient / Verlet", comparisons::discrete_gradients()),
        ("without the action / with it", comparisons::without_action()),
        ("step() in a loop / advance(n)", comparisons::single_steps()),
        ("A + B / BlanesMoanSrkn14a, same error", comparisons::exact_parts()),
    ];

    // `cargo test` passes these options: the rows must run, times do not matter.
    if !std::env::args().any(|arg| arg == "--test" || arg == "--list") {
        table("generated / hand-written", &by_hand);
        for (title, pairs) in &tables {
            table(title, pairs);
        }
    }
    if std::env::var("RATIOS").is_ok_and(|value| value == "only") {
        return;
    }
    let mut criterion = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(800))
        .without_plots()
        .configure_from_args();
    for pair in &by_hand {
        absolute(&mut criterion, &format!("{}, generated", pair.name), &pair.subject);
        absolute(&mut criterion, &format!("{}, by hand", pair.name), &pair.unit);
    }
    criterion.final_summary();
}

/// Prints the ratios of these pairs.
fn table(title: &str, pairs: &[Pair]) {
    // The first argument that is not an option selects rows by name, as criterion does.
    let selected = std::env::args().skip(1).find(|arg| !arg.starts_with('-')).unwrap_or_default();
    println!("\n{title:<40} ratio  quartiles       ns/step");
    for pair in pairs.iter().filter(|pair| pair.name.contains(&selected)) {
        let Ratio { median, quartiles: [low, high], nanoseconds: [subject, unit] } = pair.ratio();
        println!("{:<40} {median:.3}  {low:.3} … {high:.3}  {subject:.1} / {unit:.1}", pair.name);
    }
}

/// Times a run by criterion, with one step as the unit.
fn absolute(criterion: &mut Criterion, name: &str, run: &Run) {
    criterion.bench_function(name, |bencher| {
        bencher.iter_custom(|steps| {
            let start = Instant::now();
            black_box(run(steps));
            start.elapsed()
        });
    });
}
