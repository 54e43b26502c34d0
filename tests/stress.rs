//! Long runs: a quick part in every `cargo test`, and a long one whose results go to `target/geoint/stress.md`:
//! `cargo test --release -p geoint-tests --test stress -- --ignored`.

use geoint_runtime::prelude::*;
use geoint_runtime::space::Summation;
use geoint_tests::measure::regression;
use geoint_tests::problems::{Kepler, Pendulum, Problem};
use std::fmt::Write;

/// Energy errors after 10⁴, 10⁵ … steps, the root mean square over a few starts, in units of the energy.
fn growth<S, M, C>(runs: Vec<Integrator<S, M, f64, C>>, most: u32) -> Vec<(f64, f64)>
where
    S: PhaseSpace,
    M: Method<S>,
    C: Summation<S::Phase>,
{
    let mut squares = vec![0.0; most as usize - 3];
    let count = runs.len() as f64;
    for mut run in runs {
        let energy = run.energy();
        for (power, square) in (4..=most).zip(&mut squares) {
            run.advance(10_u64.pow(power) - run.steps()).expect("steps");
            *square += (run.energy() / energy - 1.0).powi(2) / count;
        }
    }
    (4..=most).zip(squares).map(|(power, square)| (10_f64.powi(power as i32), square.sqrt())).collect()
}

/// The exponent a of an error Nᵃ.
fn exponent(points: &[(f64, f64)]) -> f64 {
    let logarithms: Vec<_> = points.iter().map(|(n, error)| (n.ln(), error.max(1e-17).ln())).collect();
    regression(&logarithms).slope
}

/// Starts that differ in the last digits, and so in all roundings.
fn pendulums<M: Method<Pendulum>>(method: M, h: f64, starts: u32) -> Vec<Integrator<Pendulum, M>> {
    let start = |i: u32| State::new(1.1 + 1e-3 * f64::from(i), 0.4);
    (0..starts).map(|i| Pendulum::system::<f64>().integrator(method, h, start(i))).collect()
}

fn orbits<M: Method<Kepler>>(method: M, h: f64, starts: u32) -> Vec<Integrator<Kepler, M>> {
    let start = |i: u32| State::new([0.9 + 1e-3 * f64::from(i), 0.2], [-0.3, 1.9]);
    (0..starts).map(|i| Kepler::system::<f64>().integrator(method, h, start(i))).collect()
}

/// Numbers of steps, and the errors after them.
type Growth = Vec<(f64, f64)>;

/// Methods whose energy error is rounding alone, plain and with compensated sums.
fn brouwer(most: u32, starts: u32) -> Vec<(String, [Growth; 2])> {
    let mut rows = vec![];
    macro_rules! rows {
        ($($system:literal, $starts:ident: $($method:expr, $h:literal),+;)*) => { $($(
            let plain = growth($starts($method, $h, starts), most);
            let compensated = growth($starts($method, $h, starts).into_iter().map(Integrator::compensated).collect(), most);
            rows.push((format!("{}, {}, h = {}", $system, stringify!($method), $h), [plain, compensated]));
        )+)* };
    }
    rows! {
        "pendulum", pendulums: StormerVerlet, 1e-7, BlanesMoanSrkn14a, 0.003, Gauss::<3>, 0.003, DiscreteGradient, 0.02;
        "Kepler", orbits: StormerVerlet, 1e-7, BlanesMoanSrkn14a, 0.003, Gauss::<3>, 0.003, DiscreteGradient, 0.02;
    }
    rows
}

/// Errors of rounding walk at random at worst, so that after 10⁴ steps they are far below N ε.
#[test]
fn rounding_does_not_grow_like_the_number_of_steps() {
    for (name, [_, compensated]) in brouwer(4, 1) {
        let (steps, error) = compensated[compensated.len() - 1];
        assert!(error <= 10.0 * f64::EPSILON * steps.sqrt(), "{name}: {error:.1e} after {steps:.0}");
    }
}

/// Brouwer's law over 10⁸ steps: √N where roundings are independent.
#[test]
#[ignore = "10⁸ steps"]
fn brouwers_law() {
    let mut text = String::from(
        "# Stress\n\n## Rounding\n\nRelative error of the energy after N steps, the root mean square of eight starts, and the exponent of N by which it grows: \
         0.5 for roundings that are independent (D. Brouwer, Astron. J. 46 (1937) 149), 1 for those with a bias.\n\n\
         | method | sums | 10⁴ | 10⁵ | 10⁶ | 10⁷ | 10⁸ | exponent |\n|---|---|---|---|---|---|---|---|\n",
    );
    let mut failures = vec![];
    for (name, both) in brouwer(8, 8) {
        for (sums, points) in ["plain", "compensated"].into_iter().zip(&both) {
            let errors = points.iter().map(|(_, error)| format!("{error:.1e}")).collect::<Vec<_>>().join(" | ");
            let exponent = exponent(points);
            let _ = writeln!(text, "| {name} | {sums} | {errors} | {exponent:.2} |");
            let last = points[points.len() - 1];
            if sums == "compensated" && last.1 > 10.0 * f64::EPSILON * last.0.sqrt() {
                failures.push(format!("{name}: {:.1e}", last.1));
            }
        }
    }
    let target = std::env::var_os("CARGO_TARGET_DIR").map(std::path::PathBuf::from);
    let folder =
        target.unwrap_or(std::path::Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("target")).join("geoint");
    std::fs::create_dir_all(&folder).expect("the folder of output");
    std::fs::write(folder.join("stress.md"), &text).expect("the page");
    println!("{text}");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
