//! From a field to its energy: when is there one, and what is it?
//!
//! In the plane div f = 0 is enough (J. Liouville), on a simply connected domain; then f = (∂H/∂p, −∂H/∂q). The planar fields of
//! T. Aung, *Numerical ODE solvers that preserve first integrals*, MSc thesis, Rochester Institute of Technology, 2000, chapters 2
//! to 4: nothing is written but f, and H is derived when this is compiled; or the divergence, which says that there is none. What is
//! derived is kept to rounding.

use geoint_examples::plot::{Axis, Curve, Ink, Panel, figure, palette};
use geoint_examples::{changes, claim, largest, table};
use geoint_runtime::Method;
use geoint_runtime::prelude::*;
use geoint_runtime::system::PhaseSpace;
use std::error::Error;

/// Example 2.2.2: the saddle.
#[vector_field]
fn saddle(x: [f64; 2]) -> [f64; 2] {
    [x[0] + x[1], x[0] - x[1]]
}

/// Example 2.2.3, as printed.
#[vector_field]
fn linear(x: [f64; 2]) -> [f64; 2] {
    [x[0] + 2.0 * x[1], x[0] - x[1]]
}

/// Example 2.2.3, as H is printed.
#[vector_field]
fn parabola(x: [f64; 2]) -> [f64; 2] {
    [x[0] + 2.0 * x[1], x[0] * x[0] - x[1]]
}

/// Example 2.2.4: its divergence is t + 2.
#[vector_field]
fn swelling(x: [f64; 2], t: f64) -> [f64; 2] {
    [x[0] * t - 2.0 * x[1], x[0] + 2.0 * x[1]]
}

/// Example 2.2.5: H reads time.
#[vector_field]
fn driven(x: [f64; 2], t: f64) -> [f64; 2] {
    [x[0] * t + 2.0 * x[1], x[0] * x[0] - x[1] * t]
}

/// Example 2.2.7 with F = cosh p, which is free there.
#[vector_field]
fn half_given(x: [f64; 2]) -> [f64; 2] {
    let [q, p] = x;
    [-2.0 * p * q - 2.0 * q + p.sinh(), p * p - 2.0 * q + 2.0 * p]
}

/// Example 3.1.1: the oscillator.
#[vector_field]
fn oscillator(x: [f64; 2], omega: f64) -> [f64; 2] {
    [x[1], -omega * omega * x[0]]
}

/// Example 3.1.2: Duffing's.
#[vector_field]
fn duffing(x: [f64; 2]) -> [f64; 2] {
    [x[1], -x[0] - x[0].powi(3)]
}

/// Example 4.1.2: predators and prey, with a multiplier.
#[vector_field]
fn predators(x: [f64; 2], a: f64, b: f64, c: f64) -> [f64; 2] {
    [x[0] * (a - b * x[1]), x[1] * (b * x[0] - c)]
}
fn main() {}
