//! Every method has the order that it claims, on nonlinear problems with masses other than 1.
//!
//! Errors are measured in double-double against an extrapolated solution of another program, at a final time that is
//! not a multiple of any forcing period.

use geoint_runtime::method::splitting::Flow::{Drift, Kick};
use geoint_runtime::method::splitting::KickFirst;
use geoint_runtime::prelude::*;
use geoint_runtime::{Claims, Method, QuadraticKinetic, Separable, Splitting};
use geoint_tests::measure::{distance, error, observed_order, solutions};
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::*;
use geoint_tests::scalars::Double;
use std::marker::PhantomData;

/// How far an observed order may be from the claim.
const TOLERANCE: f64 = 0.15;

/// Observes the order of every method that it visits.
struct Orders<P> {
    duration: f64,
    solutions: Vec<Vec<Double>>,
    failures: Vec<String>,
    visited: usize,
    problem: PhantomData<P>,
}

impl<P: Problem> Orders<P> {
    fn over(duration: f64) -> Self {
        let solutions = solutions::<P>(duration, 24);
        Orders { duration, solutions, failures: vec![], visited: 0, problem: PhantomData }
    }

    fn observe<M: Method<P::Over<Double>, Double>>(&self, method: M) -> f64 {
        // A long step may fail; the order is about short ones.
        observed_order(|n| error::<P, M>(method, self.duration, n, &self.solutions).unwrap_or(f64::INFINITY))
    }

    fn finish(self, expected: usize) {
        assert!(self.failures.is_empty(), "{}:\n{}", P::NAME, self.failures.join("\n"));
        assert_eq!(self.visited, expected, "{}: methods visited", P::NAME);
    }
}

/// Where errors of order 8 to 12 already fall as their leading term before the rounding of the tables stops them.
/// Elsewhere they may fall faster, but not more slowly.
fn is_asymptotic<P: Problem>(order: u32) -> bool {
    order < 8 || P::NAME == HenonHeiles::NAME
}

impl<P: Problem> Visitor<P::Over<Double>, Double> for Orders<P> {
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

/// Methods of each list.
const GENERAL: usize = 17;
const DISCRETE_GRADIENT: usize = 20;
const PROJECTED: usize = 2;
const RELAXED: usize = 2;
const ITOH_ABE: usize = 5;
const ITOH_ABE_ONE_WAY: usize = 2;
const COORDINATE_INCREMENT: usize = 2;
const CUBIC: usize = 8;
const SEPARABLE: usize = 22;
const NYSTROM: usize = 4;
const FORCE_GRADIENT: usize = 9;
const PERTURBED: usize = 8;
const PERTURBED_GRADIENT: usize = 8;
const PROCESSED: usize = 2;

#[test]
fn quadratic_kinetic_energy() {
    let mut orders = Orders::<HenonHeiles>::over(6.1);
    methods::general(&mut orders);
    methods::discrete_gradient(&mut orders);
    methods::projected(&mut orders);
    methods::relaxed(&mut orders);
    methods::separable(&mut orders);
    methods::nystrom(&mut orders);
    methods::force_gradient(&mut orders);
    methods::perturbed(&mut orders);
    methods::perturbed_gradient(&mut orders);
    methods::processed(&mut orders);
    methods::cubic(&mut orders);
    methods::itoh_abe(&mut orders);
    orders.finish(
        GENERAL
            + DISCRETE_GRADIENT
            + PROJECTED
            + RELAXED
            + ITOH_ABE
            + SEPARABLE
            + NYSTROM
            + FORCE_GRADIENT
            + PERTURBED
            + PERTURBED_GRADIENT
            + PROCESSED
            + CUBIC,
    );
}

#[test]
fn other_kinetic_energy() {
    let mut orders = Orders::<Relativistic>::over(1.3);
    methods::general(&mut orders);
    methods::discrete_gradient(&mut orders);
    methods::projected(&mut orders);
    methods::relaxed(&mut orders);
    methods::itoh_abe_one_way(&mut orders);
    methods::separable(&mut orders);
    orders.finish(GENERAL + DISCRETE_GRADIENT + PROJECTED + RELAXED + ITOH_ABE_ONE_WAY + SEPARABLE);
}

#[test]
fn not_separable() {
    let mut orders = Orders::<DoublePendulum>::over(1.3);
    methods::general(&mut orders);
    methods::discrete_gradient(&mut orders);
    methods::projected(&mut orders);
    methods::itoh_abe_one_way(&mut orders);
    orders.finish(GENERAL + DISCRETE_GRADIENT + PROJECTED + ITOH_ABE_ONE_WAY);
}

#[test]
fn driven_potential() {
    let mut orders = Orders::<DrivenPendulum>::over(3.9);
    methods::general(&mut orders);
    methods::discrete_gradient(&mut orders);
    methods::separable(&mut orders);
    methods::nystrom(&mut orders);
    methods::force_gradient(&mut orders);
    orders.finish(GENERAL + DISCRETE_GRADIENT + SEPARABLE + NYSTROM + FORCE_GRADIENT);
}

#[test]
fn driven_kinetic_and_potential() {
    let mut orders = Orders::<Breathing>::over(2.7);
    methods::general(&mut orders);
    methods::discrete_gradient(&mut orders);
    methods::separable(&mut orders);
    orders.finish(GENERAL + DISCRETE_GRADIENT + SEPARABLE);
}

#[test]
fn driven_and_not_separable() {
    let mut orders = Orders::<SwingingMass>::over(3.9);
    methods::general(&mut orders);
    methods::discrete_gradient(&mut orders);
    methods::itoh_abe_one_way(&mut orders);
    methods::coordinate_increment(&mut orders);
    methods::itoh_abe(&mut orders);
    orders.finish(GENERAL + ITOH_ABE + DISCRETE_GRADIENT + ITOH_ABE_ONE_WAY + COORDINATE_INCREMENT);
}

/// The measure itself: it is not order 4 what is not.
#[test]
fn a_lower_order_is_seen() {
    let orders = Orders::<HenonHeiles>::over(6.1);
    let within = |observed: f64, claim: f64| (observed - claim).abs() <= TOLERANCE;
    // The triple jump with its weights in another order, and each Verlet step as kick and drift once more.
    let [long, back] = [1.3512071919596578, -1.7024143839193153];
    let flows = [
        Kick(0.5 * back),
        Drift(back),
        Kick(0.5 * (back + long)),
        Drift(long),
        Kick(long),
        Drift(long),
        Kick(0.5 * long),
    ];
    let broken = Splitting::<3, KickFirst>::new(4, flows);
    let observed = orders.observe(broken);
    assert!(!within(observed, 4.0), "{observed}");
    assert!(!within(orders.observe(StormerVerlet), 4.0));
    assert!(!within(orders.observe(ExplicitEuler), 2.0));
}

/// Why Nyström tables are refused: on a T that is not quadratic those of order 6 and 8 fall to 4 or less.
#[test]
fn nystrom_tables_lose_their_order_elsewhere() {
    let orders = Orders::<Relativistic>::over(1.3);
    let (a, b) = (orders.observe(*BlanesMoanSrkn14a.table()), orders.observe(*BceRkn17_8.table()));
    assert!(a < 4.5 && b < 4.5, "{a} {b}");
}

/// Whether a system has a property, decided by the compiler: the inherent constant, if it exists, hides that of the
/// trait.
struct Has<S>(PhantomData<S>);
trait Lacks {
    const KICK_AND_DRIFT: bool = false;
    const QUADRATIC_KINETIC: bool = false;
}
impl<S> Lacks for Has<S> {}
impl<S: Separable> Has<S> {
    const KICK_AND_DRIFT: bool = true;
}
impl<S: QuadraticKinetic> Has<S> {
    const QUADRATIC_KINETIC: bool = true;
}

#[test]
fn methods_are_refused_without_proof() {
    macro_rules! assert_structure {
        ($($System:ident: $kick:literal $quadratic:literal;)*) => { $(
            assert_eq!(Has::<$System>::KICK_AND_DRIFT, $kick, stringify!($System));
            assert_eq!(Has::<$System>::QUADRATIC_KINETIC, $quadratic, stringify!($System));
        )* };
    }
    assert_structure! {
        Pendulum: true true;
        Kepler: true true;
        KeplerVector: true true;
        HenonHeiles: true true;
        QuarticChain: true true;
        DoublePendulum: false false;
        Relativistic: true false;
        DrivenPendulum: true true;
        Breathing: true false;
        SwingingMass: false false;
        OneSided: true true;
        ThreeBodies: true true;
        Lattice: true true;
        Toda: true true;
        LotkaVolterra: true false;
        Magnetic: false false;
        Spherical: false false;
    }
}

/// The solution that everything is measured against does not depend on its own step.
#[test]
fn the_reference_is_accurate() {
    fn check<P: Problem>(duration: f64) {
        let [coarse, fine] = [24, 36].map(|parts| solutions::<P>(duration, parts));
        let gap = coarse.iter().zip(&fine).map(|(a, b)| distance(a, b)).fold(0.0, f64::max);
        assert!(gap < 1e-21, "{}: {gap:.1e}", P::NAME);
    }
    check::<HenonHeiles>(6.1);
    check::<Relativistic>(1.3);
    check::<DoublePendulum>(1.3);
    check::<DrivenPendulum>(3.9);
    check::<Breathing>(2.7);
    check::<SwingingMass>(3.9);
}
