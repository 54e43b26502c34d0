//! Build costs of a user's crate: the pendulum with its step written by hand, with one method, and with ten.
//! `cargo test --profile bench -p geoint-tests --test skipped costs -- --ignored --nocapture` prints the table.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// Number of builds of each crate, in turns. The shortest build counts.
const ROUNDS: usize = 8;

const BY_HAND: &str = "
pub fn run(n: u64, m: f64, l: f64, g: f64, h: f64, mut q: f64, mut p: f64) -> (f64, f64) {
    let (kick, drift) = (-h * m * g * l, h / (m * l * l));
    p += 0.5 * kick * q.sin();
    for _ in 1..n {
        q += drift * p;
        p += kick * q.sin();
    }
    q += drift * p;
    p += 0.5 * kick * q.sin();
    (q, p)
}
";

const ENERGY: &str = "
use geoint_runtime::prelude::*;

#[hamiltonian]
fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
    p * p / (2.0 * m * l * l) - m * g * l * q.cos()
}
";

const METHODS: [&str; 10] = [
    "StormerVerlet",
    "PositionVerlet",
    "BlanesMoan4",
    "BlanesMoanSrkn14a",
    "Chin4A",
    "RK4",
    "ImplicitMidpoint",
    "Gauss::<3>",
    "DiscreteGradient",
    "FourthOrder(DiscreteGradient)",
];

fn by_methods(methods: &[&str]) -> String {
    let run = |(i, method): (usize, &&str)| {
        format!(
            "
pub fn run{i}(n: u64, m: f64, l: f64, g: f64, h: f64, q: f64, p: f64) -> Result<State<f64>, StepError> {{
    let mut sim = Pendulum {{ m, l, g }}.integrator({method}, h, State::new(q, p));
    sim.advance(n)?;
    Ok(sim.state())
}}
"
        )
    };
    methods.iter().enumerate().map(run).fold(ENERGY.to_string(), |text, run| text + &run)
}

/// A crate in the output folder.
struct Crate {
    name: &'static str,
    folder: PathBuf,
    seconds: f64,
}

impl Crate {
    fn new(name: &'static str, text: &str) -> Self {
        let tests = Path::new(env!("CARGO_MANIFEST_DIR"));
        let target = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from).unwrap_or(tests.with_file_name("target"));
        let folder = target.join("geoint/costs").join(name);
        std::fs::create_dir_all(folder.join("src")).expect("a folder");
        let runtime = tests.with_file_name("geoint-runtime");
        let manifest = format!(
            "[package]\nname = \"{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\n[workspace]\n[dependencies]\ngeoint-runtime = {{ path = {runtime:?} }}\n"
        );
        std::fs::write(folder.join("Cargo.toml"), manifest).expect("a manifest");
        std::fs::write(folder.join("src/lib.rs"), text).expect("a source");
        std::fs::copy(tests.with_file_name("Cargo.lock"), folder.join("Cargo.lock")).expect("a lock file");
        Crate { name, folder, seconds: f64::INFINITY }
    }

    /// Builds the crate anew. Its dependencies exist after the first build.
    fn build(&self) -> f64 {
        let source = self.folder.join("src/lib.rs");
        let text = std::fs::read(&source).expect("a source");
        std::fs::write(&source, text).expect("a source");
        let begin = Instant::now();
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args([
            "rustc",
            "--offline",
            "--release",
            "--lib",
            "--quiet",
            "--",
            "--emit=obj,link",
            "-Ccodegen-units=1",
        ]);
        let target = self.folder.with_file_name("target");
        let status = cargo.current_dir(&self.folder).env("CARGO_TARGET_DIR", target).status().expect("cargo");
        assert!(status.success(), "{}", self.name);
        begin.elapsed().as_secs_f64()
    }

    /// Returns the size of its object file in bytes.
    fn bytes(&self) -> u64 {
        let objects = self.folder.with_file_name("target/release/deps");
        let name = format!("{}-", self.name);
        let is_object = |file: &std::path::PathBuf| {
            file.extension().is_some_and(|end| end == "o")
                && file.file_name().is_some_and(|file| file.to_string_lossy().starts_with(&name))
        };
        let files = std::fs::read_dir(objects).expect("objects").filter_map(|file| Some(file.ok()?.path()));
        files.filter(is_object).filter_map(|file| Some(file.metadata().ok()?.len())).max().unwrap_or(0)
    }
}

#[test]
#[ignore = "builds crates"]
fn costs_of_a_crate() {
    let mut crates = [
        Crate::new("by_hand", BY_HAND),
        Crate::new("no_method", ENERGY),
        Crate::new("one_method", &by_methods(&METHODS[..1])),
        Crate::new("ten_methods", &by_methods(&METHODS)),
    ];
    for each in &crates {
        each.build();
    }
    for _ in 0..ROUNDS {
        for each in &mut crates {
            each.seconds = each.seconds.min(each.build());
        }
    }
    println!("| crate | seconds | beside by hand | bytes of its object |\n|---|---|---|---|");
    for each in &crates {
        println!(
            "| {} | {:.2} | {:.2} | {} |",
            each.name,
            each.seconds,
            each.seconds / crates[0].seconds,
            each.bytes()
        );
    }
}
