//! Taylor series of solutions: coefficients, steps, and states between them.

#![allow(clippy::excessive_precision, reason = "digits as they are published")]

/// Tests runs that search for events in different ways.
macro_rules! every_run {
    ($system:expr, $state:expr, $h:expr, |$sim:ident| $body:expr) => {
        every_run!($system, $state, $h, 1e-13, |$sim| $body)
    };
    ($system:expr, $state:expr, $h:expr, $tolerance:expr, |$sim:ident| $body:expr) => {{
        let mut $sim = $system.taylor(Taylor::default(), $state);
        $body;
        let mut $sim = $system.taylor(TaylorFixed::<12> { h: $h }, $state);
        $body;
        let mut $sim = $system.integrator(Gauss::<3>, $h, $state);
        $body;
        let mut $sim = $system.adaptive(DOP853, $tolerance, $state);
        $body;
    }};
}

mod conditions;
mod corrupt;
mod dense;
mod edges;
mod events;
mod fixed;
mod functions;
mod going_on;
mod input;
mod last_step;
mod orders;
mod output;
mod recurrences;
mod rest;
mod scales;
mod solutions;
