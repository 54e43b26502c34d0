//! Methods have the order that they claim, on nonlinear problems with masses other than 1: one method of each kind of step on each kind of energy,
//! and every table of order 8 or more.
//!
//! Errors are measured in double-double arithmetic against an extrapolated solution of another program, at a final time that is not a multiple of
//! any forcing period. `geoint-verification` measures every method of every list in the same way.

use geoint_runtime::method::splitting::Flow::{Drift, Kick};
use geoint_runtime::method::splitting::KickFirst;
use geoint_runtime::prelude::*;
use geoint_runtime::{QuadraticKinetic, Separable, Splitting};
use geoint_tests::claims::{Orders, TOLERANCE};
use geoint_tests::measure::{distance, solutions};
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::*;
use std::marker::PhantomData;

/// Parts in which solutions are extrapolated.
const PARTS: usize = 24;

/// Methods of each list.
const GENERAL: usize = 5;
const DISCRETE_GRADIENT: usize = 5;
const PROJECTED: usize = 2;
const RELAXED: usize = 2;
const ITOH_ABE: usize = 3;
const ITOH_ABE_ONE_WAY: usize = 2;
const COORDINATE_INCREMENT: usize = 2;
const CUBIC: usize = 2;
const SEPARABLE: usize = 4;
const NYSTROM: usize = 2;
const FORCE_GRADIENT: usize = 3;
const PERTURBED: usize = 3;
const PERTURBED_GRADIENT: usize = 3;
const PROCESSED: usize = 3;

#[test]
fn quadratic_kinetic_energy() {
    let mut orders = Orders::<HenonHeiles>::over(6.1, PARTS);
    methods::kinds_of_general(&mut orders);
    methods::kinds_of_discrete_gradient(&mut orders);
    methods::projected(&mut orders);
    methods::relaxed(&mut orders);
    methods::kinds_of_separable(&mut orders);
    methods::kinds_of_nystrom(&mut orders);
    methods::kinds_of_force_gradient(&mut orders);
    methods::kinds_of_perturbed(&mut orders);
    methods::kinds_of_perturbed_gradient(&mut orders);
    methods::processed(&mut orders);
    methods::kinds_of_cubic(&mut orders);
    methods::kinds_of_itoh_abe(&mut orders);
    assert_eq!(
        orders.finish(),
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
            + CUBIC
    );
}

/// Here the error of order 8 to 12 falls as its leading term before the rounding of coefficients stops it, so the order is bounded from both sides.
#[test]
fn tables_of_order_eight_and_more() {
    let mut orders = Orders::<HenonHeiles>::over(6.1, PARTS);
    orders.visit(DOP853);
    orders.visit(Gauss::<4>);
    orders.visit(Gauss::<5>);
    orders.visit(Gauss::<6>);
    orders.visit(KahanLi8_17a.of(StormerVerlet));
    orders.visit(SofroniouSpaletta10_35.of(StormerVerlet));
    orders.visit(BceRkn17_8);
    orders.visit(BceRkn19_8);
    orders.visit(Omelyan8_11F11GP);
    assert_eq!(orders.finish(), 9);
}

#[test]
fn other_kinetic_energy() {
    let mut orders = Orders::<Relativistic>::over(1.3, PARTS);
    methods::kinds_of_general(&mut orders);
    methods::kinds_of_discrete_gradient(&mut orders);
    methods::projected(&mut orders);
    methods::relaxed(&mut orders);
    methods::itoh_abe_one_way(&mut orders);
    methods::kinds_of_separable(&mut orders);
    assert_eq!(orders.finish(), GENERAL + DISCRETE_GRADIENT + PROJECTED + RELAXED + ITOH_ABE_ONE_WAY + SEPARABLE);
}

#[test]
fn not_separable() {
    let mut orders = Orders::<DoublePendulum>::over(1.3, PARTS);
    methods::kinds_of_general(&mut orders);
    methods::kinds_of_discrete_gradient(&mut orders);
    methods::projected(&mut orders);
    methods::itoh_abe_one_way(&mut orders);
    assert_eq!(orders.finish(), GENERAL + DISCRETE_GRADIENT + PROJECTED + ITOH_ABE_ONE_WAY);
}

#[test]
fn driven_potential() {
    let mut orders = Orders::<DrivenPendulum>::over(3.9, PARTS);
    methods::kinds_of_general(&mut orders);
    methods::kinds_of_discrete_gradient(&mut orders);
    methods::kinds_of_separable(&mut orders);
    methods::kinds_of_nystrom(&mut orders);
    methods::kinds_of_force_gradient(&mut orders);
    assert_eq!(orders.finish(), GENERAL + DISCRETE_GRADIENT + SEPARABLE + NYSTROM + FORCE_GRADIENT);
}

#[test]
fn driven_kinetic_and_potential() {
    let mut orders = Orders::<Breathing>::over(2.7, PARTS);
    methods::kinds_of_general(&mut orders);
    methods::kinds_of_discrete_gradient(&mut orders);
    methods::kinds_of_separable(&mut orders);
    assert_eq!(orders.finish(), GENERAL + DISCRETE_GRADIENT + SEPARABLE);
}

#[test]
fn driven_and_not_separable() {
    let mut orders = Orders::<SwingingMass>::over(3.9, PARTS);
    methods::kinds_of_general(&mut orders);
    methods::kinds_of_discrete_gradient(&mut orders);
    methods::itoh_abe_one_way(&mut orders);
    methods::coordinate_increment(&mut orders);
    methods::kinds_of_itoh_abe(&mut orders);
    assert_eq!(orders.finish(), GENERAL + DISCRETE_GRADIENT + ITOH_ABE + ITOH_ABE_ONE_WAY + COORDINATE_INCREMENT);
}

/// The measure itself: it is not order 4 what is not.
#[test]
fn a_lower_order_is_seen() {
    let orders = Orders::<HenonHeiles>::over(6.1, PARTS);
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
    let orders = Orders::<Relativistic>::over(1.3, PARTS);
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
        let [coarse, fine] = [PARTS, 36].map(|parts| solutions::<P>(duration, parts));
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
