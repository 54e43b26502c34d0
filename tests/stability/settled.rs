//! Steps keep invariants to rounding, and so do long runs. After each 1024 steps the accumulated rounding error is removed.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::system::StateOf;
use geoint_runtime::{Method, PhaseSpace, Real};
use geoint_tests::problems::{HenonHeiles, Kepler, QuarticChain, ShortPendulum, Spherical};

/// Predators and prey.
#[vector_field(keeps(wealth = b * x[0] - c * x[0].ln() + b * x[1] - a * x[1].ln()))]
fn predators(x: [f64; 2], a: f64, b: f64, c: f64) -> [f64; 2] {
    [x[0] * (a - b * x[1]), x[1] * (b * x[0] - c)]
}

/// Attraction to a centre.
#[hamiltonian]
fn falling_orbit(q: [f32; 2], p: [f32; 2], m: f32, mu: f32) -> f32 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - mu * m / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// Two links on a motor's axis: H has no formula that is worth writing down.
#[lagrangian]
fn links(q: [f64; 2], v: [f64; 2], m: f64, g: f64) -> f64 {
    m * (v[0] * v[0] + v[1] * v[1] / 2.0 + v[0] * v[1] * (q[0] - q[1]).cos()) + m * g * (2.0 * q[0].cos() + q[1].cos())
}

const CHAIN: QuarticChain = QuarticChain { w: [0.7, 1.4], k: [1.0, 0.8, 1.3] };
const HEILES: HenonHeiles = HenonHeiles { m: [1.3, 0.8], lambda: 1.0 };
const ORBIT: Kepler = Kepler { mass: 1.3, mu: 1.3 };

/// Returns the largest changes of invariants over 10⁵ steps, relative to their values at the start. The second run sets its state anew after each 1000
/// steps, so the accumulated rounding error is never removed.
fn changes<S, M, R, const N: usize>(
    (system, method, h): (S, M, R),
    start: StateOf<S, R>,
    value: impl Fn(&S, &StateOf<S, R>) -> [R; N],
) -> [[f64; N]; 2]
where
    S: PhaseSpace<R>,
    M: Method<S, R>,
    R: Real,
{
    let first = value(&system, &start).map(Real::magnitude);
    [false, true].map(|anew| {
        let mut sim = Integrator::new(system, method, h, start);
        let mut largest = [0.0; N];
        for _ in 0..100 {
            sim.advance(1000).unwrap_or_else(|error| panic!("{error}"));
            let now = value(&system, &sim.state());
            for ((largest, now), first) in largest.iter_mut().zip(now).zip(value(&system, &start)) {
                *largest = f64::max(*largest, (now - first).magnitude());
            }
            if anew {
                sim.set_state(sim.state());
            }
        }
        core::array::from_fn(|k| largest[k] / first[k])
    })
}

/// Asserts that the invariants stay within `roundings`. Control: the run without removal of drift exceeds twice this bound.
fn stays<S, M, R, const N: usize>(
    case: (S, M, R),
    start: StateOf<S, R>,
    value: impl Fn(&S, &StateOf<S, R>) -> [R; N],
    roundings: f64,
) where
    S: PhaseSpace<R>,
    M: Method<S, R>,
    R: Real,
{
    let name = case.1.name();
    let [settled, anew] = changes(case, start, value).map(|changes| changes.map(|change| change / R::epsilon()));
    println!("{name}: {settled:.1?}, begun anew {anew:.1?}");
    assert!(settled.iter().all(|change| *change <= roundings), "{name}: {settled:?} of {roundings} roundings");
    assert!(anew.iter().any(|change| *change > 2.0 * roundings), "{name}: nothing walks, {anew:?}");
}

#[test]
fn energies() {
    let energy = |system: &QuarticChain, state: &State<[f64; 2]>| [system.energy(state)];
    // The median of 24 starts has 4.8, the worst has 6.9.
    stays((CHAIN, DiscreteGradient, 0.05), State::new([0.3, 1.0], [0.2, 0.6]), energy, 6.0);
    let start = State::new([0.3, 1.0], [0.2, 0.5]);
    // The worst of 37 starts has 7.
    stays((CHAIN, Gonzalez, 0.05), start, energy, 8.0);
    // The worst of 37 starts has 6.6.
    stays((CHAIN, Projection(RK4, Energy), 0.05), State::new([0.3, 1.0], [0.2, 0.1]), energy, 6.0);
    stays((CHAIN, Relaxation(RK4), 0.05), start, energy, 9.0);
    stays((CHAIN, Suzuki4.of(DiscreteGradient), 0.05), State::new([0.7, -0.4], [1.0, -0.8]), energy, 9.0);
    let links = Links { m: 1.3, g: 2.0 };
    stays((links, DiscreteGradient, 0.03), links.at([0.3, 1.4], [0.5, 0.1]), |s, x| [s.energy(x)], 2.0);
}

fn momentum(_: &Kepler, s: &State<[f64; 2]>) -> f64 {
    s.q[0] * s.p[1] - s.q[1] * s.p[0]
}

#[test]
fn momenta_beside_the_energy() {
    let start = State::new([0.5, 0.0], [0.3, 2.2]);
    stays((ORBIT, FourthOrder(DiscreteGradient), 0.05), start, |k, s| [momentum(k, s)], 5.0);
    // With h = 0.05 rounding errors hardly accumulate.
    stays((ORBIT, DiscreteGradient, 0.06), start, |k, s| [momentum(k, s), k.energy(s)], 12.0);
}

/// Nearly straight ellipses, started at either end. A run from the pericentre has a large rounding error of the energy far from the centre. Removal along
/// the gradient of the energy alone would change the angular momentum by 4·10⁻⁷. A run from the apocentre has lost decisive digits of its displacement
/// close to the centre. Removal there would change the energy by 2·10⁻⁸.
#[test]
fn close_to_a_collision() {
    for (e, [energies, momenta]) in
        [(0.99, [[1e-13, 1e-12], [1e-14, 1e-12]]), (0.9999, [[1e-11, 1e-10], [1e-14, 1e-10]])]
    {
        let speed = f64::sqrt((1.0 - e) / (1.0 + e));
        let [far, near] = [([1.0 + e, 0.0], [0.0, 1.3 * speed]), ([1.0 - e, 0.0], [0.0, 1.3 / speed])];
        for (k, (q, p)) in [far, near].into_iter().enumerate() {
            let start = State::new(q, p);
            let mut sim = Adaptive::new(ORBIT, DiscreteGradient, 1e-6, start);
            let (mut energy, mut turning) = (0.0_f64, 0.0_f64);
            for _ in 0..150 {
                sim.advance(100).expect("an ellipse");
                let state = sim.state();
                if state.q[0].hypot(state.q[1]) > 0.5 {
                    energy = energy.max((sim.energy() / ORBIT.energy(&start) - 1.0).abs());
                    turning = turning.max((momentum(&ORBIT, &state) / momentum(&ORBIT, &start) - 1.0).abs());
                }
            }
            assert!(energy <= energies[k] && turning <= momenta[k], "e = {e}: {energy:e}, {turning:e}");
        }
    }
}

#[test]
fn integrals_of_fields() {
    let field = Predators { a: 2.0, b: 1.0, c: 1.0 };
    let wealth = |system: &Predators, state: &FlowState<[f64; 2]>| [system.wealth(state)];
    stays((field, DiscreteGradient, 0.1), FlowState::new([1.0, 0.5]), wealth, 8.0);
    stays((field, FourthOrder(DiscreteGradient), 0.1), FlowState::new([1.0, 0.5]), wealth, 8.0);
}

/// One coordinate grows, another one shrinks, and their product stays.
#[vector_field(keeps(area = x[0] * x[1]))]
fn stretched(x: [f64; 2], k: f64) -> [f64; 2] {
    [k * x[0], -k * x[1]]
}

/// Far from the start, the displacement has the last digits of the largest coordinates. Removal of drift by the displacement would change the area by 10⁻⁶.
#[test]
fn what_grows_beside_what_shrinks() {
    fn check<M: Method<Stretched>>(method: M) {
        let mut sim = Stretched { k: 0.001 }.integrator(method, 1.0, FlowState::new([1.3, 0.8]));
        let first = sim.integrals()[0];
        for _ in 0..14 {
            sim.advance(2000).expect("steps");
            let change = (sim.integrals()[0] / first - 1.0).abs();
            assert!(change <= 1e-14, "{:?}: {change:e}", sim.state());
        }
    }
    check(DiscreteGradient);
    check(FourthOrder(DiscreteGradient));
    check(Projection(RK4, Integrals));
}

#[test]
fn single_precision() {
    let system = ShortPendulum { m: 1.3, l: 0.9, g: 2.0 };
    stays((system, DiscreteGradient, 0.05_f32), State::new(1.0, 0.5), |s, x| [s.energy(x)], 3.75);
}

/// Twenty steps on an orbit whose acceleration changes by a factor of twenty. In single precision, corrections are as large as the last digits. A term of
/// their series is small at the apocentre and large near the centre.
#[test]
fn few_digits_and_long_steps() {
    let system = FallingOrbit { m: 1.3, mu: 1.0 };
    let mut sim = Integrator::new(system, DiscreteGradient, 0.2_f32, State::new([0.4, 0.0], [0.0, 2.6]));
    let first = sim.energy();
    for _ in 0..5000 {
        sim.advance(37).expect("a regular orbit");
        let change = (sim.energy() / first - 1.0).abs();
        assert!(change <= 128.0 * f32::EPSILON, "{change:e} at {}", sim.time());
    }
}

/// A conserved momentum and a coordinate at rest keep every bit.
#[test]
fn what_does_not_move() {
    let system = Spherical { m: 1.3, v: 0.7 };
    let mut sim = Integrator::new(system, DiscreteGradient, 0.1, State::new([1.1, 0.9, 0.2], [0.1, 0.3, 0.7]));
    sim.advance(5000).expect("a regular orbit");
    assert_eq!(sim.state().p[2], 0.7);
    let mut sim = Integrator::new(HEILES, DiscreteGradient, 0.1, State::new([0.0, 0.3], [0.0, 0.1]));
    sim.advance(5000).expect("a motion in a plane");
    assert_eq!([sim.state().q[0], sim.state().p[0]], [0.0; 2]);
}

/// The drift is removed after the same steps for any call lengths, and in a resumed run.
#[test]
fn by_the_same_steps() {
    let new = || Integrator::new(HEILES, DiscreteGradient, 0.1, State::new([0.1, 0.2], [0.3, 0.1]));
    let (mut at_once, mut singly, mut begun_anew) = (new(), new(), new());
    at_once.advance(2500).expect("a regular orbit");
    for _ in 0..2500 {
        singly.step().expect("a regular orbit");
    }
    assert_eq!(at_once.state(), singly.state());
    let mut elsewhere = Integrator::new(HEILES, DiscreteGradient, -0.3, State::new([0.2, 0.0], [0.0, 0.1]));
    elsewhere.resume(&at_once.saved()).expect("a run of the same kind");
    at_once.advance(1000).expect("a regular orbit");
    elsewhere.advance(1000).expect("a regular orbit");
    assert_eq!(at_once.saved(), elsewhere.saved());
    // Control: a run whose state is set anew has another reference for the removal, and differs.
    begun_anew.advance(2500).expect("a regular orbit");
    begun_anew.set_state(begun_anew.state());
    begun_anew.advance(1000).expect("a regular orbit");
    assert_ne!(at_once.state(), begun_anew.state());
}

/// The drift of adaptive runs is removed, too.
#[test]
fn steps_that_adapt() {
    let start = State::new([0.4, 0.0], [0.0, 2.6]);
    let mut largest = [0.0_f64; 2];
    for (anew, largest) in largest.iter_mut().enumerate() {
        let mut sim = Adaptive::new(ORBIT, DiscreteGradient, 1e-4, start);
        let first = ORBIT.energy(&start);
        for _ in 0..50 {
            for _ in 0..1000 {
                sim.step().expect("a regular orbit");
            }
            *largest = largest.max((sim.energy() / first - 1.0).abs());
            if anew == 1 {
                sim.set_state(sim.state());
            }
        }
    }
    assert!(largest[0] < 15.0 * f64::EPSILON && largest[1] > 2.0 * largest[0], "{largest:?}");
}
