//! The page of the guide on errors, from `errors.txt` and the messages of the compile-fail tests.
//!
//! An entry of `errors.txt` is a line `== message`, a line with the meaning, and a program that compiles. Each message must occur in a test.

use crate::project::Project;

const ENTRIES: &str = "tests/pages/errors.txt";

/// Returns the page.
pub(crate) fn page(project: &Project) -> Result<String, String> {
    let mut messages = String::new();
    for folder in ["tests/essentials/mistakes", "tests/messages/src/ui"] {
        for file in project.files(folder, ".stderr") {
            messages += &project.read(&file)?;
        }
    }
    let mut text = HEAD.to_owned();
    for entry in project.read(ENTRIES)?.split("== ").skip(1) {
        let mut lines = entry.trim_end().lines();
        let (message, meaning) = (lines.next().unwrap_or_default(), lines.next().unwrap_or_default());
        if !messages.contains(message) {
            return Err(format!("{ENTRIES}: no compile-fail test has the message: {message}"));
        }
        text += &format!("**{message}**\n\n{meaning}\n```\n# use geoint_runtime::prelude::*;\n");
        lines.for_each(|line| text += &format!("{line}\n"));
        text += "```\n";
    }
    text += TAIL;
    Ok(text.lines().map(|line| format!("//! {line}").trim_end().to_owned() + "\n").collect())
}

const HEAD: &str = "\
Find a message here, read its meaning, and copy a repair that compiles.

This page is generated: each message occurs in a test, and each program compiles. Every message of the compiler points at the term in the way.

# When the program is compiled

";

const TAIL: &str = "
# When it runs

`step` returns a [`StepError`](crate::StepError). The run still holds the last good state. Change the step, the state or the system, and go on.

| error | meaning | remedy |
|---|---|---|
| `InvalidParameter` | a parameter of the system is not a number | set it; the message has its name |
| `NonFiniteState`, `InvalidStepSize` | the given state or step is not a finite number | check the input |
| `NoMomentum` | the velocities belong to no momentum | use `system.at(q, v)`; see [mechanisms](super::_10_mechanisms) |
| `OffConstraint` | the state does not satisfy a constraint | start from `system.state_on_constraint(…)` |
| `OutsideDomain` | a root, logarithm or pole lies on the way | shorten the step; the message has the term |
| `NonFinite`, `NotConverged`, `Singular` | the step is too long for its equation | shorten the step |
| `LedAstray`, `Rounded` | the step has lost the invariants, or their digits | shorten the step |
| `Turned` | an angle moves by more than half a turn in a step | shorten the step |
| `OutOfRange` | the energy underflows or overflows | take other units, or `f64` |
| `StepTooSmall` | an adaptive run or a Taylor series cannot go on | its `reason` has the cause: a collision, a jump |
| `TooManySteps` | `steps_at_most` was reached | raise it, or loosen the tolerance |

Next: [limits](super::_18_limits), [a run in practice](super::_06_runs).
";
