//! Methods have the order that they claim, on nonlinear problems with masses other than 1.
//!
//! The tests measure one method of each kind of step on each kind of energy, and the tables of order 8 or more. Controls show that the observed
//! order of a wrong table is wrong. `geoint-verification` measures every method of every list in the same way.
//!
//! Errors are measured in double-double arithmetic. The reference solution is extrapolated during the test, from Gragg's midpoint rule, and shares no
//! code with the methods. No final time is a multiple of a period of the forcing, so errors do not cancel over whole periods.
//!
//! Another test checks which systems have a proven splitting T(p) + V(q) and a proven quadratic T. The lists of methods depend on these properties.

use geoint_runtime::method::flows::Flow::{Drift, Kick};
use geoint_runtime::methods::*;
use geoint_runtime::{QuadraticKinetic, Separable, Splitting};
use geoint_tests::claims::{Orders, TOLERANCE};
use geoint_tests::measure::{distance, solutions};
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::*;
use std::marker::PhantomData;

/// Number of intervals of the extrapolated solution in each quarter of a run. `the_reference_is_accurate` shows that the number is large enough.
const PARTS: usize = 24;

// Number of methods in each list. `visit` of `Orders` fails if an observed order is wrong, and `finish` returns the number of methods. A test fails if
// this number changes. `ITOH_ABE_ONE_WAY` has the methods of order 1, which are not symmetric.
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

/// T(p) + V(q) with a quadratic T, without time, and H of degree 3: every list but `COORDINATE_INCREMENT` accepts this system. Methods of order 1 are
/// measured on other systems.
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

/// Tables of order 8 to 12 on Hénon–Heiles. The leading term dominates the error here before the rounding of coefficients to `f64` does. The observed
/// order is therefore bounded from both sides. On other systems it is bounded from below only.
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

/// T(p) + V(q) with a T that is not quadratic: Nyström and force-gradient tables do not accept this system.
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

/// H is not T(p) + V(q): no kicks and drifts.
#[test]
fn not_separable() {
    let mut orders = Orders::<DoublePendulum>::over(1.3, PARTS);
    methods::kinds_of_general(&mut orders);
    methods::kinds_of_discrete_gradient(&mut orders);
    methods::projected(&mut orders);
    methods::itoh_abe_one_way(&mut orders);
    assert_eq!(orders.finish(), GENERAL + DISCRETE_GRADIENT + PROJECTED + ITOH_ABE_ONE_WAY);
}

/// V depends on time: no projection and no relaxation, which need a constant energy.
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

/// T and V depend on time. T has no proven constant mass matrix, so Nyström tables do not accept this system.
#[test]
fn driven_kinetic_and_potential() {
    let mut orders = Orders::<Breathing>::over(2.7, PARTS);
    methods::kinds_of_general(&mut orders);
    methods::kinds_of_discrete_gradient(&mut orders);
    methods::kinds_of_separable(&mut orders);
    assert_eq!(orders.finish(), GENERAL + DISCRETE_GRADIENT + SEPARABLE);
}

/// H depends on time and is not T(p) + V(q). The system has one degree of freedom, so the
/// division by (increment · direction) in `CoordinateIncrement` is always possible.
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

/// Control: a wrong table, and methods of a lower order, do not pass as order 4 or 2.
#[test]
fn a_lower_order_is_seen() {
    let orders = Orders::<HenonHeiles>::over(6.1, PARTS);
    let within = |observed: f64, claim: f64| (observed - claim).abs() <= TOLERANCE;
    // Yoshida's method of order 4 takes three Verlet steps of the lengths long·h, back·h, long·h. This table takes them in the sequence back, long,
    // long, with adjacent kicks merged. The sequence is not a palindrome, so the table does not have order 4.
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
    // Three drifts, and the claim of order 4.
    let broken = Splitting::<3>::new(4, flows);
    let observed = orders.observe(broken);
    assert!(!within(observed, 4.0), "{observed}");
    assert!(!within(orders.observe(StormerVerlet), 4.0));
    assert!(!within(orders.observe(ExplicitEuler), 2.0));
}

/// Nyström tables of order 6 and 8 have at most order 4 if T is not quadratic. The methods therefore refuse such systems; the test calls their plain
/// splitting tables, which accept every T(p) + V(q).
#[test]
fn nystrom_tables_lose_their_order_elsewhere() {
    let orders = Orders::<Relativistic>::over(1.3, PARTS);
    let (a, b) = (orders.observe(*BlanesMoanSrkn14a.table()), orders.observe(*BceRkn17_8.table()));
    assert!(a < 4.5 && b < 4.5, "{a} {b}");
}

/// `Has::<S>` tells which properties of a system are proven. The compiler decides: an inherent constant hides the constant of the trait `Lacks`.
struct Has<S>(PhantomData<S>);
/// The constants of systems that have no inherent constants.
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

/// The macro implements `Separable` if H = T(p) + V(q) is proven, and `QuadraticKinetic` if T is proven to be quadratic, too. The first column is
/// `Separable`, the second column is `QuadraticKinetic`.
#[test]
fn systems_have_only_proven_properties() {
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

/// The reference solution does not change by more than 10⁻²¹ if the extrapolation uses 36 intervals instead of `PARTS`.
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
