//! Visitors that compare the claims of methods with measurements on a scene.
//!
//! [`Orders`] observes orders in double-double arithmetic. [`Geometry`] measures whether steps keep the symplectic, Poisson or contact form,
//! by derivatives in dual numbers. [`Symmetry`] measures the distance from the start after steps forward and back.

use crate::measure::{error, form_defect, observed_order, solutions, symmetry_defect};
use crate::problems::{HenonHeiles, Problem};
use crate::scalars::{Double, Dual};
use crate::scene::Scene;
use geoint_runtime::method::{Failure, Visitor};
use geoint_runtime::{Claims, Method};
use std::marker::PhantomData;

/// The largest accepted difference between an observed and a claimed order.
///
/// The value is below ½, so an order that is wrong by 1 fails. It is above zero, because the next term of the error still counts at the observed steps.
pub const TOLERANCE: f64 = 0.15;

/// The number of steps in which defects are measured. With several steps, defects include the values that a method hands to its next step.
const MEASURED_STEPS: u64 = 3;

/// Bounds the rounding of the form defect after [`MEASURED_STEPS`].
const FORM_TOLERANCE: f64 = 1e-12;

/// Bounds the rounding of the symmetry defect after [`MEASURED_STEPS`] forward and back.
const SYMMETRY_TOLERANCE: f64 = 1e-13;

/// The least defect of a control. It is far above both tolerances.
const CONTROL_DEFECT: f64 = 1e-6;

/// Observes the order of every method that it visits, on the scene `P`.
pub struct Orders<P> {
    duration: f64,
    solutions: Vec<Vec<Double>>,
    failures: Vec<String>,
    visited: usize,
    problem: PhantomData<P>,
}

impl<P: Scene> Orders<P> {
    /// Prepares the measurement over a time interval. Errors are taken at four times in the interval.
    ///
    /// Precondition: `duration` is not a multiple of any period of the motion, because errors may cancel over a period. The reference solution
    /// comes from extrapolation without a method of the runtime. It uses `parts` intervals for each quarter of `duration`.
    pub fn over(duration: f64, parts: usize) -> Self {
        let solutions = solutions::<P>(duration, parts);
        Orders { duration, solutions, failures: vec![], visited: 0, problem: PhantomData }
    }

    /// Returns the observed order of a method. NaN if all errors are too large or are rounding.
    pub fn observe<M: Method<P::Over<Double>, Double>>(&self, method: M) -> f64 {
        // A long step may fail. The order depends on short steps only, so a failed run counts as an infinite error.
        observed_order(|n| error::<P, M>(method, self.duration, n, &self.solutions).unwrap_or(f64::INFINITY))
    }

    /// Returns the number of visited methods. Panics if a method has not the claimed order.
    pub fn finish(self) -> usize {
        assert!(self.failures.is_empty(), "{}:\n{}", P::NAME, self.failures.join("\n"));
        self.visited
    }
}

/// Returns whether the error of a method shows its leading term before rounding dominates.
///
/// Coefficients of tables are rounded to `f64`. From order 8 on, errors reach this rounding before they fall as their leading term. Hénon–Heiles is
/// the exception. Elsewhere the observed order may exceed the claim, but not fall below it.
fn is_asymptotic<P: Scene>(order: u32) -> bool {
    order < 8 || P::NAME == <HenonHeiles as Problem>::NAME
}

impl<P: Scene> Visitor<P::Over<Double>, Double> for Orders<P> {
    fn visit<M: Method<P::Over<Double>, Double> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let Claims { order, .. } = method.claims();
        let observed = self.observe(method);
        self.visited += 1;
        println!("{:16} {name:45} claims {order:2}, observed {observed:6.3}", P::NAME);
        let excess = observed - f64::from(order);
        if !(excess >= -TOLERANCE && (excess <= TOLERANCE || !is_asymptotic::<P>(order))) {
            self.failures.push(format!("{name} claims order {order}, observed {observed:.3}"));
        }
    }
}

/// Measures whether every visited method keeps the form of the scene `P`.
///
/// The step must be so long that the defect of a method without the property exceeds `CONTROL_DEFECT`. Such methods of low order are
/// controls: they show that the measurement detects a defect.
pub struct Geometry<P> {
    h: f64,
    failures: Vec<String>,
    controls: usize,
    problem: PhantomData<P>,
}

impl<P: Scene> Geometry<P> {
    /// Prepares the measurement with steps of length `h`.
    pub fn with_step(h: f64) -> Self {
        Geometry { h, failures: vec![], controls: 0, problem: PhantomData }
    }

    /// Compares the defect of a method with its claim.
    ///
    /// If the method claims the property, the defect must be at most `tolerance`. If not, and the order is at most 2, the method is a control
    /// and the defect must exceed [`CONTROL_DEFECT`]. A method of higher order without the claim passes with any defect, because it may be
    /// close to the exact flow, which has the property.
    fn judge(&mut self, name: &str, order: u32, claimed: bool, defect: Result<f64, Failure>, tolerance: f64) {
        let control = !claimed && order <= 2;
        self.controls += usize::from(control);
        let good =
            matches!(defect, Ok(defect) if (!claimed || defect <= tolerance) && (!control || defect > CONTROL_DEFECT));
        let shown = defect.map_or_else(|error| error.to_string(), |defect| format!("{defect:.1e}"));
        println!("{:16} {name:45} {claimed:5} {shown}", P::NAME);
        if !good {
            self.failures.push(format!("{name}: claimed {claimed}, defect {shown}"));
        }
    }

    /// Returns the number of controls. Panics if the defect of a method contradicts its claim.
    pub fn finish(self) -> usize {
        assert!(self.failures.is_empty(), "{}:\n{}", P::NAME, self.failures.join("\n"));
        self.controls
    }
}

impl<P: Scene> Visitor<P::Over<Dual>, Dual> for Geometry<P> {
    fn visit<M: Method<P::Over<Dual>, Dual> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let defect = form_defect::<P, M>(method, self.h, MEASURED_STEPS);
        self.judge(&name, method.claims().order, method.claims().symplectic, defect, FORM_TOLERANCE);
    }
}

/// Measures whether every visited method is symmetric: steps of length h, then as many of length −h, return to the start.
///
/// Symmetry is a type of its own because it needs the scalar `f64`, while [`Geometry`] needs dual numbers.
pub struct Symmetry<P>(pub Geometry<P>);

impl<P: Scene> Visitor<P::Over<f64>, f64> for Symmetry<P> {
    fn visit<M: Method<P::Over<f64>, f64> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let defect = symmetry_defect::<P, M, f64>(method, self.0.h, MEASURED_STEPS);
        self.0.judge(&name, method.claims().order, method.claims().symmetric, defect, SYMMETRY_TOLERANCE);
    }
}
