//! Writes a program with random systems of all forms. `.ci/random` compiles and runs it.

use super::config;
use super::functions::arithmetic;
use crate::parse::Form;
use crate::tests::expansion;
use proc_macro2::TokenStream;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use std::fmt::Write;

/// Leaves of random expressions. Numbers have their type, because rustc does not infer it at a method call.
const LEAVES: [&str; 9] = ["q", "p", "t", "a", "w[0]", "w[1]", "2.0_f64", "0.5_f64", "K"];

/// A template for random systems of one form. The arguments `t: f64, a: f64, w: [f64; 2]` follow `arguments`.
struct Written {
    form: Form,
    attribute: &'static str,
    arguments: &'static str,
    returned: &'static str,
    /// Each `#` is a random expression.
    body: &'static str,
    check: &'static str,
    coordinates: usize,
}

const ALL: [Written; 6] = [
    Written {
        form: Form::Hamiltonian,
        attribute: "hamiltonian",
        arguments: "q: f64, p: f64",
        returned: "f64",
        body: "p * p / 2.6 + # + # * #",
        check: "jets::of_field, jets::rates",
        coordinates: 2,
    },
    Written {
        form: Form::Hamiltonian,
        attribute: "hamiltonian(damping = 0.2 + a * a)",
        arguments: "q: f64, p: f64",
        returned: "f64",
        body: "p * p / 2.6 + # + # * #",
        check: "jets::of_field, jets::rates",
        coordinates: 2,
    },
    Written {
        form: Form::Contact,
        attribute: "contact_hamiltonian",
        arguments: "q: f64, p: f64, s: f64",
        returned: "f64",
        body: "p * p / 2.6 + # + # * #",
        check: "jets::of_contact, jets::contact_rates",
        coordinates: 3,
    },
    Written {
        form: Form::Hamiltonian,
        attribute: "hamiltonian(structure = so3)",
        arguments: "x: [f64; 3]",
        returned: "f64",
        body: "let [q, p, z] = x; z * z / 3.0 + z * (#) + #",
        check: "jets::of_field, jets::rates",
        coordinates: 3,
    },
    Written {
        form: Form::Field,
        attribute: "vector_field",
        arguments: "x: [f64; 2]",
        returned: "[f64; 2]",
        body: "let [q, p] = x; [# - # * #, # + #]",
        check: "jets::of_field, jets::rates",
        coordinates: 2,
    },
    Written {
        form: Form::Lagrangian,
        attribute: "lagrangian",
        arguments: "q: f64, v: f64",
        returned: "f64",
        body: "let p = 0.3 * q; v * v * (1.3 + (#).tanh()) + # + # * #",
        check: "jets::of_field, jets::rates",
        coordinates: 2,
    },
];

/// Returns the arguments of an attribute.
fn arguments(attribute: &str) -> TokenStream {
    let inner = attribute.split_once('(').map_or("", |(_, rest)| &rest[..rest.len() - 1]);
    inner.parse().expect("tokens")
}

/// Returns a random system that the macro accepts.
fn accepted(written: &Written, runner: &mut TestRunner) -> String {
    let Written { form, attribute, arguments: coordinates, returned, body, .. } = written;
    let action = if *form == Form::Contact { Form::Contact } else { Form::Hamiltonian };
    loop {
        let mut text = String::new();
        for (i, part) in body.split('#').enumerate() {
            if i > 0 {
                let expression = arithmetic(action, &LEAVES).new_tree(runner).expect("a value").current();
                let (_, expression) = expression.split_once("const K: f64 = 1.5;").expect("the body");
                write!(text, "({})", expression.trim_end().trim_end_matches('}')).expect("text");
            }
            text += part;
        }
        let item = format!(
            "fn energy({coordinates}, t: f64, a: f64, w: [f64; 2]) -> {returned} {{ const K: f64 = 1.5; {text} }}"
        );
        let Ok(tokens) = item.parse() else { continue };
        let emitted = expansion(*form, arguments(attribute), tokens);
        if !emitted.contains("compile_error") {
            return item;
        }
    }
}

/// Writes `RANDOM_SYSTEMS` systems of each form to the file `RANDOM_FILE`.
#[test]
#[ignore = "writes a program: .ci/random"]
fn write_systems() {
    let each: u32 = std::env::var("RANDOM_SYSTEMS").ok().and_then(|n| n.parse().ok()).unwrap_or(10);
    let file = std::env::var("RANDOM_FILE").expect("RANDOM_FILE names a file");
    let mut runner = TestRunner::new(config());
    let (mut modules, mut calls) = (String::new(), String::new());
    for (form, written) in ALL.iter().enumerate() {
        for i in 0..each {
            let (attribute, check, coordinates) = (written.attribute, written.check, written.coordinates);
            let item = accepted(written, &mut runner);
            writeln!(
                modules,
                "mod e{form}_{i} {{ use geoint_runtime::prelude::*;\n#[{attribute}]\npub(super) {item} }}"
            )
            .expect("text");
            writeln!(calls, "check!(seen: {check}, e{form}_{i} {coordinates} {:?});", format!("{attribute}: {item}"))
                .expect("text");
        }
    }
    std::fs::write(file, format!("{modules}\nfn all(seen: &mut Seen) {{\n{calls}}}\n")).expect("the file");
}
