//! States at which gradients vanish or depend on each other, and the edges of domains.

use super::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::system::FirstIntegrals;

/// Follows a sleeping top, and tops near it. All four gradients depend on each other in the sleeping state.
#[test]
fn sleeping_tops_are_followed() {
    let top = LagrangeTop { a: 2.0, c: 1.0, l: 1.0 };
    for distance in [1e-3, 1e-5, 1e-7, 1e-9, 0.0] {
        let start = FlowState::new([distance, 0.0, 4.0, 0.0, distance, 1.0]);
        let before = top.integrals(0.0, &start.x);
        let mut sim = top.integrator(FourthOrder(DiscreteGradient), 0.05, start);
        for _ in 0..100 {
            sim.step().unwrap_or_else(|error| panic!("at {distance:e}: {error}"));
            let after = top.integrals(0.0, &sim.state().x);
            for (a, b) in after.iter().zip(before) {
                assert!((a - b).abs() < 2e-14, "at {distance:e}: {:e}", a - b);
            }
        }
    }
    // A permanent rotation of a free body.
    let body = EulerTop { a: 1.0, b: 2.0, c: 3.0 };
    let start = FlowState::new([0.0, 0.0, 1.3]);
    let mut sim = body.integrator(DiscreteGradient, 0.1, start);
    sim.advance(100).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(sim.state().x, start.x);
}

/// Near a permanent rotation both gradients of a free body agree. A projection still follows the body, also at the unstable rotation.
#[test]
fn projections_near_permanent_rotations() {
    let body = EulerTop { a: 1.0, b: 2.0, c: 3.0 };
    for distance in [1e-3, 1e-6, 1e-8, 1e-10, 1e-15, 0.0] {
        let start = FlowState::new([distance, 1.0, 0.0]);
        let before = body.integrals(0.0, &start.x);
        let mut sim = body.integrator(Projection(RK4, Integrals), 0.1, start);
        for _ in 0..100 {
            sim.step().unwrap_or_else(|error| panic!("at {distance:e}: {error}"));
            let after = body.integrals(0.0, &sim.state().x);
            assert!(after.iter().zip(before).all(|(a, b)| (a - b).abs() < 4e-15), "at {distance:e}: {after:?}");
        }
        assert!(distance > 1e-4 || (sim.state().x[1] - 1.0).abs() < 1e-3, "{:?}", sim.state());
    }
}

/// Near the equilibrium of Lotka and Volterra the gradient vanishes. The steps still follow the motion, and keep its distance from the equilibrium.
#[test]
fn gradients_that_vanish_are_no_failure() {
    let system = Predators { a: 2.0, b: 1.0, c: 1.0 };
    for distance in [1e-3, 1e-8, 0.0] {
        let start = FlowState::new([1.0 + distance, 2.0]);
        let mut sim = system.integrator(DiscreteGradient, 0.05, start);
        let mut furthest = 0.0_f64;
        for _ in 0..1000 {
            sim.step().unwrap_or_else(|error| panic!("at {distance:e}: {error}"));
            let [x, y] = sim.state().x;
            furthest = furthest.max((x - 1.0).abs());
            assert!((x - 1.0).hypot(y - 2.0) <= 1.5 * distance, "at {distance:e}: {x} {y}");
        }
        assert!((furthest - distance).abs() <= 2e-3 * distance + 1e-15, "at {distance:e}: {furthest:e}");
    }
}

/// A step out of the domain of a logarithm is refused, and the last state is kept.
#[test]
fn edges_of_integrals_are_refused() {
    let system = Predators { a: 2.0, b: 1.0, c: 1.0 };
    let mut sim = system.integrator(DiscreteGradient, 0.1, FlowState::new([-1.0, 0.5]));
    assert!(matches!(sim.step(), Err(StepError { failure: Failure::OutsideDomain { .. }, .. })), "outside");
    let start = FlowState::new([1.0, 0.5]);
    let mut sim = system.integrator(DiscreteGradient, 100.0, start);
    if sim.step().is_err() {
        assert_eq!(sim.state(), start);
    } else {
        assert!(sim.state().x.iter().all(|x| *x > 0.0));
    }
}

/// A bracket that has a pole where b vanishes: there the flow ends, after (1 + gx)²/(2gc).
#[hamiltonian(structure = {
    let b = 1.0 + g * x[0];
    [[0.0, 1.0 / b], [-1.0 / b, 0.0]]
})]
fn guiding_centre(x: [f64; 2], g: f64, c: f64) -> f64 {
    x[1].powi(3) - c * x[1]
}

/// A bracket whose quotient has none.
#[hamiltonian(structure = |_, _| 1.0 / (1.0 + x[0] * x[0]))]
fn curved(x: [f64; 2]) -> f64 {
    x[1] * x[1] / 2.0 - x[0].cos()
}

#[test]
fn poles_of_a_structure_are_watched() {
    let (system, start) = (GuidingCentre { g: 0.5, c: 0.4 }, FlowState::new([-1.9, 0.0]));
    fn ends<M: Method<GuidingCentre, Proof = ()>>(system: GuidingCentre, start: FlowState<[f64; 2]>, method: M) {
        for h in [1e-3, 0.1, 10.0] {
            let mut sim = Integrator::new(system, method, h, start);
            let (error, last) = loop {
                let last = sim.state();
                if let Err(error) = sim.step() {
                    break (error, last);
                }
            };
            let name = method.name();
            assert_eq!(sim.state(), last, "{name}");
            assert!((last.t - 0.00625).abs() < 2.5e-3 || h > 1e-3 && last == start, "{name}: {last:?}");
            let text = error.to_string();
            assert!(text.contains("x[0]·g + 1") || text.contains("x[1]³ - x[1]·c"), "{name}: {text}");
        }
    }
    ends(system, start, DiscreteGradient);
    ends(system, start, FourthOrder(DiscreteGradient));
    ends(system, start, Gauss::<2>);
    ends(system, start, PoissonSplitting);
    ends(system, start, PlanarSplitting);

    let mut sim = Curved.integrator(FourthOrder(DiscreteGradient), 0.5, FlowState::new([2.3, 0.4]));
    let energy = sim.energy();
    sim.advance(1000).unwrap_or_else(|error| panic!("{error}"));
    assert!((sim.energy() - energy).abs() < 2e-15);
}

/// The distance from a centre, which has no derivative there.
#[vector_field(keeps(distance = (x[0] * x[0] + m * x[1] * x[1]).sqrt()))]
fn around(x: [f64; 2], m: f64) -> [f64; 2] {
    [-m * x[1], x[0]]
}

/// As a factor it has one, which its formula does not know.
#[vector_field(keeps(square = x[0] * x[0] + x[1] * x[1]))]
fn faster_outside(x: [f64; 2], m: f64) -> [f64; 2] {
    let r = (x[0] * x[0] + x[1] * x[1]).sqrt();
    [-m * r * x[1], m * r * x[0]]
}

#[hamiltonian]
fn cone(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// If a step needs a derivative that does not exist, the error names the term.
#[test]
fn edges_of_derivatives_are_named() {
    fn refused<S: PhaseSpace, M: Method<S>>(system: S, method: M, start: S::State, elsewhere: S::State) {
        let mut sim = Integrator::new(system, method, 0.1, start);
        let Err(StepError { failure: Failure::OutsideDomain { what }, .. }) = sim.step() else {
            panic!("{}", method.name())
        };
        assert!(what.starts_with("a derivative that is not a number: ") && what.contains("[0]² + "), "{what}");
        Integrator::new(system, method, 0.1, elsewhere).advance(10).unwrap_or_else(|error| panic!("{error}"));
    }
    let [centre, outside] = [0.0, 0.3].map(|x| FlowState::new([x, 0.0]));
    let system = Around { m: 1.5 };
    refused(system, DiscreteGradient, centre, outside);
    refused(system, FourthOrder(DiscreteGradient), centre, outside);
    refused(system, Projection(RK4, Integrals), centre, outside);
    refused(FasterOutside { m: 1.5 }, ImplicitMidpoint, centre, outside);
    let [tip, outside] = [0.0, 0.3].map(|q| State::new([q, 0.0], [0.0, 0.2]));
    refused(Cone { m: 1.5 }, DiscreteGradient, State::new([0.0; 2], [0.0; 2]), outside);
    refused(Cone { m: 1.5 }, StormerVerlet, tip, outside);
    // The implicit midpoint rule needs no derivative of this term and stays at the centre.
    let mut sim = system.integrator(ImplicitMidpoint, 0.1, centre);
    assert!(sim.advance(10).is_ok() && sim.state().x == [0.0; 2]);
}

/// A moment of inertia of 10⁻⁹ gives 10⁹ turns per step. Far from the body, terms round by more than the size of the state itself. A point that
/// consists of rounding alone is no solution.
#[test]
fn what_is_rounding_alone_is_no_solution() {
    let system = FreeBody { inertia: [1e-9, 1.0, 1.0] };
    let start = FlowState::new([0.5, 0.8, -0.4]);
    let length = |state: FlowState<[f64; 3]>| state.x.iter().map(|x| x * x).sum::<f64>();
    for h in [1.0, 10.0, 1000.0] {
        let mut sim = system.integrator(FourthOrder(DiscreteGradient), h, start);
        for _ in 0..5 {
            let before = sim.state();
            match sim.step() {
                Ok(()) => assert!((length(sim.state()) - length(start)).abs() < 1e-9, "h = {h}: {:?}", sim.state()),
                Err(_) => assert_eq!(sim.state(), before),
            }
        }
    }
}

/// A zero field keeps every state, under every method. The two integrals alone leave no coordinate to move.
#[test]
fn a_field_of_nothing_stays() {
    #[vector_field(keeps(first = x[0], second = w * x[1]))]
    fn nothing(x: [f64; 2], w: f64) -> [f64; 2] {
        [0.0, 0.0]
    }
    let start = FlowState::new([0.3, -0.7]);
    fn stays<M: Method<Nothing>>(method: M, start: FlowState<[f64; 2]>) {
        let mut sim = Integrator::new(Nothing { w: 1.3 }, method, 0.1, start);
        sim.advance(10).unwrap_or_else(|error| panic!("{}: {error}", method.name()));
        assert_eq!(sim.state().x, start.x, "{}", method.name());
    }
    stays(DiscreteGradient, start);
    stays(FourthOrder(DiscreteGradient), start);
    stays(Projection(RK4, Integrals), start);
    stays(Gauss::<2>, start);
}

/// Energy and angular momentum of a planet.
#[vector_field(keeps(
    energy = (x[2] * x[2] + x[3] * x[3]) / 2.0 - k / x[0].hypot(x[1]),
    spin = x[0] * x[3] - x[1] * x[2],
))]
fn planet(x: [f64; 4], k: f64) -> [f64; 4] {
    let cube = x[0].hypot(x[1]).powi(3);
    [x[2], x[3], -k * x[0] / cube, -k * x[1] / cube]
}

/// On a circle both gradients are parallel, and near it almost parallel. A step keeps both integrals to 10⁻¹² or is refused. Projections are never
/// refused, because the circle exists and leads back.
#[test]
fn near_circles_steps_keep_all_or_are_refused() {
    fn run<M: Method<Planet>>(method: M, h: f64, eccentricity: f64) -> u64 {
        let system = Planet { k: 1.3 };
        let speed = (1.3 * (1.0 + eccentricity) / (1.0 - eccentricity)).sqrt();
        let start = FlowState::new([1.0 - eccentricity, 0.0, 0.0, speed]);
        let before = system.integrals(0.0, &start.x);
        let mut sim = Integrator::new(system, method, h, start);
        for step in 0..100 {
            let last = sim.state();
            if sim.step().is_err() {
                assert_eq!(sim.state(), last);
                return step;
            }
            let after = system.integrals(0.0, &sim.state().x);
            let changed = after.iter().zip(before).any(|(a, b)| (a - b).abs() > 1e-12);
            assert!(!changed, "{}, h = {h}, {eccentricity:e}: {after:?}", method.name());
        }
        100
    }
    let mut refused = 0;
    for h in [0.5, 0.1, -0.02] {
        for eccentricity in [0.0, 1e-12, 1e-9, 1e-6, 1e-4, 0.1] {
            let steps = [run(DiscreteGradient, h, eccentricity), run(FourthOrder(DiscreteGradient), h, eccentricity)];
            refused += steps.iter().filter(|steps| **steps < 100).count();
            assert!(eccentricity < 0.1 || steps == [100; 2], "h = {h}: {steps:?}");
            let projected = run(Projection(RK4, Integrals), h, eccentricity);
            assert_eq!(projected, 100, "h = {h}, {eccentricity:e}");
        }
    }
    assert!(refused > 0);
}

/// x₁/x₀² stays where both die away.
#[vector_field(keeps(ratio = x[1] / x[0].powi(2)))]
fn dying(x: [f64; 2], k: f64) -> [f64; 2] {
    [-k * x[0], -2.0 * k * x[1]]
}

/// Two of three species die out; their sum and a product of powers stay.
#[vector_field(keeps(product = x[0].powf(a) * x[1].powf(b)))]
fn dying_out(x: [f64; 3], a: f64, b: f64) -> [f64; 3] {
    [-b * x[0] * x[2], a * x[1] * x[2], x[2] * (b * x[0] - a * x[1])]
}

/// To a pole: small over large is kept there.
#[vector_field(keeps(ratio = x[0] / (1.0 + x[1] * x[1])))]
fn rising(x: [f64; 2], k: f64) -> [f64; 2] {
    [2.0 * k * x[0] * x[1], k * (1.0 + x[1] * x[1])]
}

/// Returns the largest change of a function in `steps` steps, or up to the first refusal.
fn moves<S, M, const N: usize>(
    system: S,
    method: M,
    (h, steps): (f64, u32),
    x: [f64; N],
    f: fn(&S, &S::State) -> f64,
) -> f64
where
    S: PhaseSpace<State = FlowState<[f64; N]>> + Copy,
    M: Method<S>,
{
    let mut sim = Integrator::new(system, method, h, FlowState::new(x));
    let (before, mut largest) = (f(&system, &sim.state()), 0.0_f64);
    for _ in 0..steps {
        if sim.step().is_err() {
            break;
        }
        largest = largest.max((f(&system, &sim.state()) - before).abs());
    }
    largest
}

/// Digits refer to the present size of a coordinate, even after a decay by many orders of magnitude. A step over a pole must not count as solved
/// because no change is visible.
#[test]
fn projections_keep_what_is_steep_in_small_coordinates() {
    for h in [0.3, 1.0] {
        let change = moves(Dying { k: 1.3 }, Projection(RK4, Integrals), (h, 60), [0.5, 0.3], Dying::ratio);
        assert!(change < 2e-14, "h = {h}: {change:e}");
    }
    for (h, bound) in [(0.3, 2e-15), (1.0, 2e-15), (2.0, 1e-10)] {
        let (species, method) = (DyingOut { a: -0.7, b: 1.3 }, Projection(DOP853, Integrals));
        let change = moves(species, method, (h, 60), [0.5, 0.3, 0.8], DyingOut::product);
        assert!(change < bound, "h = {h}: {change:e}");
    }
    for h in [0.1, 0.02, -0.05] {
        let change = moves(Rising { k: 1.0 }, Projection(RK4, Integrals), (h, 200), [0.7, 0.2], Rising::ratio);
        assert!(change < 1e-12, "h = {h}: {change:e}");
    }
}

/// Predators and prey that come near to dying out: what is kept is steep there.
#[vector_field(keeps(wealth = d * x[0] - c * x[0].ln() + b * x[1] - a * x[1].ln()))]
fn outbreaks(x: [f64; 2], a: f64, b: f64, c: f64, d: f64) -> [f64; 2] {
    [x[0] * (a - b * x[1]), x[1] * (d * x[0] - c)]
}

/// exp x₀ sin bx₁: at h = 3 a step takes 30 orders of magnitude from x₁.
#[vector_field(keeps(steep = x[0].exp() * (b * x[1]).sin()))]
fn to_the_axis(x: [f64; 2], b: f64) -> [f64; 2] {
    [b * (b * x[1]).cos(), -(b * x[1]).sin()]
}

/// An error can be small compared with earlier values of a coordinate and still exceed its present value. Steps keep the integrals all the same.
#[test]
fn steps_keep_what_is_steep_in_small_coordinates() {
    fn keep<M: Method<Dying> + Method<Outbreaks> + Method<ToTheAxis>>(method: M) {
        let ratio = moves(Dying { k: 1.3 }, method, (0.3, 60), [0.5, 0.3], Dying::ratio);
        assert!(ratio < 2e-14, "{ratio:e}");
        let system = Outbreaks { a: 1.1, b: 1.0, c: 0.9, d: 1.0 };
        for (h, start) in [(0.003, 30.0), (0.02, 30.0), (0.02, 10.0)] {
            let wealth = moves(system, method, (h, 5000), [start; 2], Outbreaks::wealth);
            assert!(wealth < 1e-13, "h = {h}, from {start}: {wealth:e}");
        }
        for (h, bound) in [(0.3, 2e-15), (1.0, 2e-14), (3.0, 1e-12)] {
            let steep = moves(ToTheAxis { b: 1.3 }, method, (h, 20), [0.5, 0.3], ToTheAxis::steep);
            assert!(steep < bound, "h = {h}: {steep:e}");
        }
    }
    keep(DiscreteGradient);
    keep(FourthOrder(DiscreteGradient));
    // Nothing is refused on the way.
    let system = Outbreaks { a: 1.1, b: 1.0, c: 0.9, d: 1.0 };
    let mut sim = system.integrator(DiscreteGradient, 0.02, FlowState::new([30.0; 2]));
    sim.advance(5000).unwrap_or_else(|error| panic!("{error}"));
}
