//! Claims of methods, and their measurements.

use crate::lists;
use crate::page::{Page, short};
use geoint_runtime::method::{Failure, Visitor};
use geoint_runtime::{Claims, Method};
use geoint_tests::bare::Bare;
use geoint_tests::counting::allocations_during;
use geoint_tests::measure::{Observed, error, form_defect, observed, solutions, symmetry_defect};
use geoint_tests::scalars::{Double, Dual};
use geoint_tests::scene::Scene;
use std::hint::black_box;
use std::marker::PhantomData;

/// Accepted distance between an observed order and the claim.
const TOLERANCE: f64 = 0.15;
/// From this order on, errors reach the rounding of tables before the leading term dominates. They may fall faster than the leading term, or slower by this
/// amount.
const HIGH: u32 = 8;
const ROUNDED: f64 = 0.75;
/// Largest defects of claimed properties. A method of order 2 or less must exceed `SEEN` if it does not claim the property. Symmetry is measured in
/// double-double arithmetic. The rounding of tables to `f64` is left there, without the rounding of steps.
const SYMMETRIC: f64 = 1e-17;
const FORM: f64 = 1e-12;
const ENERGY: f64 = 2e-12;
const SEEN: f64 = 1e-9;
/// Number of steps over which the energy is followed.
const STEPS: u64 = 2000;

/// A list of the catalogue, on two scenes.
pub(crate) struct List {
    pub(crate) name: &'static str,
    pub(crate) about: &'static str,
    pub(crate) scenes: [&'static str; 2],
    pub(crate) rows: Vec<Row>,
}

/// The measurements of a method.
pub(crate) struct Row {
    name: String,
    claims: Claims,
    /// The observed order on each scene, with the constant of the leading term.
    orders: Vec<(Observed, f64)>,
    symmetry: Result<f64, Failure>,
    form: Result<f64, Failure>,
    energy: Result<f64, Failure>,
    evaluations: f64,
    allocations: u64,
}

impl List {
    pub(crate) fn new(name: &'static str, about: &'static str, scenes: [&'static str; 2]) -> Self {
        List { name, about, scenes, rows: vec![] }
    }

    fn row(&mut self, name: String, claims: Claims) -> &mut Row {
        let place = self.rows.iter().position(|row| row.name == name).unwrap_or_else(|| {
            let (symmetry, form, energy) = (Ok(f64::NAN), Ok(f64::NAN), Ok(f64::NAN));
            let row =
                Row { name, claims, orders: vec![], symmetry, form, energy, evaluations: f64::NAN, allocations: 0 };
            self.rows.push(row);
            self.rows.len() - 1
        });
        &mut self.rows[place]
    }
}

/// Observes orders.
pub(crate) struct Orders<'a, P> {
    list: &'a mut List,
    duration: f64,
    solutions: Vec<Vec<Double>>,
    scene: PhantomData<P>,
}

impl<'a, P: Scene> Orders<'a, P> {
    pub(crate) fn over(list: &'a mut List, duration: f64) -> Self {
        Orders { list, duration, solutions: solutions::<P>(duration, 16), scene: PhantomData }
    }
}

impl<P: Scene> Visitor<P::Over<Double>, Double> for Orders<'_, P> {
    fn visit<M: Method<P::Over<Double>, Double> + 'static>(&mut self, method: M) {
        let claims = method.claims();
        // A long step may fail. The order concerns short steps.
        let of = |n| error::<P, M>(method, self.duration, n, &self.solutions).unwrap_or(f64::INFINITY);
        let observed = observed(of);
        let constant = observed.constant(self.duration, claims.order);
        self.list.row(method.name().to_string(), claims).orders.push((observed, constant));
    }
}

/// Measures the distance from the start after steps forward and back.
pub(crate) struct Symmetries<'a, P> {
    pub(crate) list: &'a mut List,
    pub(crate) h: f64,
    pub(crate) scene: PhantomData<P>,
}

impl<P: Scene> Visitor<P::Over<Double>, Double> for Symmetries<'_, P> {
    fn visit<M: Method<P::Over<Double>, Double> + 'static>(&mut self, method: M) {
        let symmetry = symmetry_defect::<P, M, Double>(method, self.h, 3);
        self.list.row(method.name().to_string(), method.claims()).symmetry = symmetry;
    }
}

/// Measures the form that a map keeps, by derivatives of steps.
pub(crate) struct Forms<'a, P> {
    pub(crate) list: &'a mut List,
    pub(crate) h: f64,
    pub(crate) scene: PhantomData<P>,
}

impl<P: Scene> Visitor<P::Over<Dual>, Dual> for Forms<'_, P> {
    fn visit<M: Method<P::Over<Dual>, Dual> + 'static>(&mut self, method: M) {
        let form = form_defect::<P, M>(method, self.h, 3);
        self.list.row(method.name().to_string(), method.claims()).form = form;
    }
}

/// Runs in `f64`, the scalar of users.
pub(crate) struct Runs<'a, P> {
    pub(crate) list: &'a mut List,
    pub(crate) h: f64,
    pub(crate) scene: PhantomData<P>,
}

impl<P: Scene> Visitor<P::Over<f64>> for Runs<'_, P> {
    fn visit<M: Method<P::Over<f64>> + 'static>(&mut self, method: M) {
        let h = self.h;
        let row = self.list.row(method.name().to_string(), method.claims());
        row.energy = energy_error::<P, M>(method, h);
        let (t, x) = P::start();
        let mut sim = Bare::<P, M, f64>::new(method, h, t, &x);
        row.allocations = allocations_during(|| black_box(sim.advance(100)).map_or((), drop));
        row.evaluations = sim.evaluations() as f64 / 100.0;
    }
}

/// Returns the largest error of the energy, or of the invariants of a field, relative to the start.
fn energy_error<P: Scene, M: Method<P::Over<f64>>>(method: M, h: f64) -> Result<f64, Failure> {
    let (t, x) = P::start();
    let mut sim = Bare::<P, M, f64>::new(method, h, t, &x);
    let kept = |sim: &Bare<P, M, f64>| P::kept(&sim.state()).unwrap_or_else(|| vec![sim.energy()]);
    let begin = kept(&sim);
    let mut largest = 0.0_f64;
    for _ in 0..STEPS {
        sim.step()?;
        for (now, begin) in kept(&sim).iter().zip(&begin) {
            let off = (now - P::energy_after(sim.time() - t, *begin)).abs() / begin.abs();
            // `max` would drop a NaN.
            largest = if off > largest || off.is_nan() { off } else { largest };
        }
    }
    Ok(largest)
}

impl Row {
    /// Returns the claims that do not hold.
    fn failures(&self) -> Vec<String> {
        let Claims { order, symmetric, symplectic, conserves_energy, .. } = self.claims;
        let mut failures = vec![];
        for (Observed { order: seen, .. }, _) in &self.orders {
            let excess = seen - f64::from(order);
            let good = if order < HIGH { excess.abs() <= TOLERANCE } else { excess.is_nan() || excess >= -ROUNDED };
            if !good {
                failures.push(format!("order {order} is claimed, {seen:.3} is observed"));
            }
        }
        let mut property = |what: &str, claimed: bool, defect: &Result<f64, Failure>, bound: f64| {
            let control = !claimed && order <= 2;
            let off =
                defect.as_ref().map_or(f64::INFINITY, |defect| if defect.is_nan() { f64::INFINITY } else { *defect });
            if !(claimed && off <= bound || control && off > SEEN || !claimed && !control) {
                failures.push(format!("{what}: {claimed} is claimed, it is off by {off:.1e}"));
            }
        };
        property("symmetric", symmetric, &self.symmetry, SYMMETRIC);
        property("keeps the form", symplectic, &self.form, FORM);
        property("keeps the energy", conserves_energy, &self.energy, ENERGY);
        if self.allocations > 0 {
            failures.push(format!("{} allocations", self.allocations));
        }
        failures
    }

    fn cells(&self) -> [String; 8] {
        let Claims { order, symmetric, symplectic, conserves_energy, forces, .. } = self.claims;
        let join = |of: &dyn Fn(&(Observed, f64)) -> String| self.orders.iter().map(of).collect::<Vec<_>>().join(", ");
        let property = |claimed: bool, defect: &Result<f64, Failure>| {
            let claimed = if claimed { "yes" } else { "no" };
            defect.as_ref().map_or_else(|error| format!("{claimed}, {error}"), |x| format!("{claimed}, {}", short(*x)))
        };
        let evaluations = match forces {
            Some(forces) => forces.to_string(),
            None => format!("solved: {}", short(self.evaluations)),
        };
        [
            format!("`{}`", self.name),
            order.to_string(),
            join(&|(seen, _)| short(seen.order)),
            join(&|(_, constant)| short(*constant)),
            property(symmetric, &self.symmetry),
            property(symplectic, &self.form),
            property(conserves_energy, &self.energy),
            format!("{evaluations}; {}", self.allocations),
        ]
    }
}

/// A table for each list.
pub(crate) fn section(page: &mut Page) {
    page.section(
        2,
        "Methods",
        "Each list of the catalogue is measured on two nonlinear scenes with masses other than 1. *Observed* and *constants* have a value for each \
         scene. The next columns are measured on the first scene. *Yes* and *no* are claims, and a defect follows.\n\n\
         - *observed*: log₂ e(h)/e(h/2) in double-double arithmetic, for the smallest step h with errors above the rounding of tables. The \
         reference is extrapolation to order 24. “–” means that no step has such errors.\n\
         - *constants*: e/hᵖ with the claimed order p. The error e is the root-mean-square over four times.\n\
         - *symmetric*: the distance from the start after three steps forward and three steps back, in double-double arithmetic.\n\
         - *form*: the defect of the symplectic, contact or Poisson form in the derivative of three steps, from dual numbers.\n\
         - *energy*: the largest relative error in 2000 steps, of the energy, of its law of decay, or of the integrals of a field.\n\
         - *cost*: evaluations of the force in a step. After *solved*, the number of points at which a step evaluates its equation.\n\
         - *allocations*: the number in 100 steps.",
    );
    for List { name, about, scenes, rows } in lists::all() {
        page.section(3, name, &format!("{about} On {}.", scenes.join(" and ")));
        page.table(
            ["method", "order", "observed", "constants", "symmetric", "form", "energy", "cost; allocations"],
            rows.iter().map(Row::cells),
        );
        for row in rows {
            for failure in row.failures() {
                page.claim(false, format_args!("{name}, {}: {failure}", row.name));
            }
            page.claim(row.orders.len() == 2, format_args!("{name}, {}: two scenes", row.name));
        }
    }
}
