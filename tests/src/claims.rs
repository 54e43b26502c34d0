//! What methods claim, judged on scenes: orders in double-double, forms by dual numbers, symmetry by steps forth and back.

use crate::measure::{error, form_defect, observed_order, solutions, symmetry_defect};
use crate::problems::{HenonHeiles, Problem};
use crate::scalars::{Double, Dual};
use crate::scene::Scene;
use geoint_runtime::method::{Refusal, Visitor};
use geoint_runtime::{Claims, Method};
use std::marker::PhantomData;

/// How far an observed order may be from the claim.
pub const TOLERANCE: f64 = 0.15;

/// Observes the order of every method that it visits.
pub struct Orders<P> {
    duration: f64,
    solutions: Vec<Vec<Double>>,
    failures: Vec<String>,
    visited: usize,
    problem: PhantomData<P>,
}

impl<P: Scene> Orders<P> {
    /// Over a time that is not a multiple of any period.
    /// The solution is extrapolated in so many parts.
    pub fn over(duration: f64, parts: usize) -> Self {
        let solutions = solutions::<P>(duration, parts);
        Orders { duration, solutions, failures: vec![], visited: 0, problem: PhantomData }
    }

    /// The order of a method.
    pub fn observe<M: Method<P::Over<Double>, Double>>(&self, method: M) -> f64 {
        // A long step may fail; the order is about short ones.
        observed_order(|n| error::<P, M>(method, self.duration, n, &self.solutions).unwrap_or(f64::INFINITY))
    }

    /// How many methods there were, if all orders are as claimed.
    pub fn finish(self) -> usize {
        assert!(self.failures.is_empty(), "{}:\n{}", P::NAME, self.failures.join("\n"));
        self.visited
    }
}

/// Where errors of order 8 to 12 already fall as their leading term before the rounding of the tables stops them.
/// Elsewhere they may fall faster, but not more slowly.
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

/// A step long enough for what is not symplectic or symmetric to show.
pub struct Geometry<P> {
    h: f64,
    failures: Vec<String>,
    controls: usize,
    problem: PhantomData<P>,
}

impl<P: Scene> Geometry<P> {
    /// With steps of this length.
    pub fn with_step(h: f64) -> Self {
        Geometry { h, failures: vec![], controls: 0, problem: PhantomData }
    }

    /// `kept` bounds the defect from above if the property is claimed, 10⁻⁶ from below if not: of a composition of high
    /// order that is not asked, because it may come as close to the exact flow as its order says.
    fn judge(&mut self, name: &str, order: u32, claimed: bool, defect: Result<f64, Refusal>, kept: f64) {
        let control = !claimed && order <= 2;
        self.controls += usize::from(control);
        let good = matches!(defect, Ok(defect) if (!claimed || defect <= kept) && (!control || defect > 1e-6));
        let shown = defect.map_or_else(|error| error.to_string(), |defect| format!("{defect:.1e}"));
        println!("{:16} {name:45} {claimed:5} {shown}", P::NAME);
        if !good {
            self.failures.push(format!("{name}: claimed {claimed}, defect {shown}"));
        }
    }

    /// How many methods showed what a failure looks like, if all is as claimed.
    pub fn finish(self) -> usize {
        assert!(self.failures.is_empty(), "{}:\n{}", P::NAME, self.failures.join("\n"));
        self.controls
    }
}

impl<P: Scene> Visitor<P::Over<Dual>, Dual> for Geometry<P> {
    fn visit<M: Method<P::Over<Dual>, Dual> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let defect = form_defect::<P, M>(method, self.h, 3);
        self.judge(&name, method.claims().order, method.claims().symplectic, defect, 1e-12);
    }
}

/// The same measurement for symmetry; another type because its scalar is another.
pub struct Symmetry<P>(pub Geometry<P>);

impl<P: Scene> Visitor<P::Over<f64>, f64> for Symmetry<P> {
    fn visit<M: Method<P::Over<f64>, f64> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let defect = symmetry_defect::<P, M, f64>(method, self.0.h, 3);
        self.0.judge(&name, method.claims().order, method.claims().symmetric, defect, 1e-13);
    }
}
