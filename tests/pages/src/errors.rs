//! The page of the guide on errors, from `errors.txt` and the messages of the compile-fail tests.
//!
//! An entry of `errors.txt` is a line `== message`, a line with the meaning, and perhaps a program that compiles. Programs are tests of the guide.
//! Entries without a program form a table. The table of errors at run time is written by hand.

use crate::project::Project;

const ENTRIES: &str = "tests/pages/errors.txt";

/// Returns the page as `//!` lines. Fails if a message of `errors.txt` occurs in no expected output of a compile-fail test.
pub(crate) fn page(project: &Project) -> Result<String, String> {
    let mut messages = String::new();
    for folder in ["tests/essentials/mistakes", "tests/messages/src/ui"] {
        for file in project.files(folder, ".stderr") {
            messages += &project.read(&file)?;
        }
    }
    let (mut text, mut short) = (HEAD.to_owned(), String::new());
    for entry in project.read(ENTRIES)?.split("\n== ").skip(1) {
        let mut lines = entry.trim_end().lines();
        let (message, meaning) = (lines.next().unwrap_or_default(), lines.next().unwrap_or_default());
        if !messages.contains(message) {
            return Err(format!("{ENTRIES}: no compile-fail test has the message: {message}"));
        }
        let program: String = lines.map(|line| format!("{line}\n")).collect();
        if program.is_empty() {
            short += &format!("| {message} | {meaning} |\n");
        } else {
            text += &format!(
                "**{message}**\n\n{meaning}\n```\n# use geoint_runtime::{{methods::*, prelude::*}};\n{program}```\n"
            );
        }
    }
    text += SHORT;
    text += &short;
    text += TAIL;
    Ok(text.lines().map(|line| format!("//! {line}").trim_end().to_owned() + "\n").collect())
}

const HEAD: &str = "\
Find a message here, read its meaning, and copy a repair that compiles.

This page is generated: each message occurs in a test, and each program compiles. Every message of the compiler points at the term in the way.

# When the program is compiled

";

const SHORT: &str = "\
| message | meaning and repair |
|---|---|
";

const TAIL: &str = "
# When it runs

`step` returns a [`StepError`](crate::StepError): the time `t`, the length `h` of the step, and the [`failure`](crate::Failure). The run still holds the last
good state. Change the step, the state or the system, and go on. `error.is_shortest()` tells that an adaptive run has tried shorter steps already.

| `failure` | meaning | remedy |
|---|---|---|
| `InvalidParameter` | a parameter of the system is not a number | set it; the message has its name |
| `NonFiniteState`, `InvalidStepSize`, `NotNormalised`, … | an input is not finite, or a quaternion not of length 1 | check it; `r.renormalize()` |
| `NoMomentum` | the velocities have no momenta, for instance v > c | choose v inside the domain of L; see [mechanisms](super::_10_mechanisms) |
| `OffConstraint` | the state does not satisfy a constraint | start from `system.state_on_constraint(…)` |
| `DependentConstraints` | constraints do not determine the motion: bars in one line | start elsewhere, or choose other lengths |
| `OutsideDomain`, `Pole` | a root, logarithm, pole or singular mass matrix on the way, or friction that adds energy | shorten the step, or correct the friction; the message has the term |
| `NonFinite`, `NotConverged`, `Unsolved`, `Turned` | the step is too long for its equation | shorten the step |
| `Singular` | several solutions: long step, dead point of a linkage, parallel gradients of integrals | shorten the step; start elsewhere; `Projection(RK4, Integrals)` |
| `LedAstray`, `Rounded` | a correction exceeds half of the step, or rounding changes an invariant | shorten the step; take other units |
| `OutOfRange` | a value is too small or too large for `f32` or `f64` | take other units, or `f64` |
| `Inaccurate`, `Diverges`, `NoRates`, `Sliding`, `TooManySteps` | an adaptive run or a Taylor series cannot go on: a collision, a jump | stop there; shorten the shortest step; raise `steps_at_most` |
| `NoEvent` | the event function is zero all along, or not a number | change the function |
| `TimePassed`, `NotInLastStep` | the time lies behind the run; for `at`, outside of the last step | `sampled_at` with times ahead |

Next: [limits](super::_18_limits), [a run in practice](super::_06_runs).
";
