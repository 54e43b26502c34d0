//! Energies that jump, or bend, at a condition.

use geoint_runtime::method::implicit::SolvedBy;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::DiscreteField;
use geoint_runtime::scalar::Real;
use geoint_runtime::system::StateOf;
use geoint_runtime::{Autonomous, Failure, Hamiltonian, Method, PhaseSpace};
use geoint_tests::grid::pairs;
use geoint_tests::methods::{self, Visitor};

macro_rules! energies {
    ($($name:ident($q:ident, $p:ident) $energy:expr => $System:ident;)*) => { $(
        #[hamiltonian]
        fn $name($q: f64, $p: f64, m: f64) -> f64 {
            $p * $p / (2.0 * m) + $energy
        }
    )* };
}

energies! {
    step_of_potential(q, p) if q < 0.0 { 1.0 } else { 0.0 } => StepOfPotential;
    step_down(q, p) if q >= 0.0 { 0.7 } else { 0.0 } => StepDown;
    step_of_force(q, p) if q < 0.25 { q * q } else { 2.0 - q } => StepOfForce;
    two_steps(q, p) if q < 0.0 { 1.0 } else if q < 0.5 { 0.5 } else { 0.0 } => TwoSteps;
    sign(q, p) 0.3 * q.signum() => Sign;
    factor(q, p) (2.0 + q) * (if q > 0.0 && p < 5.0 { 1.0 } else { 0.8 }) => Factor;
    // These do not jump.
    bent(q, p) if q < 0.0 { q * q } else { 0.5 * q } => Bent;
    spring(q, p) if q > 0.0 { 2.0 * q * q } else { 0.5 * q * q } => Spring;
    three_kinks(q, p) (q - 0.2).abs() + 0.5 * (q + 0.1).abs() + 0.7 * (q - 0.4).max(0.0) => ThreeKinks;
    // This energy jumps.
    jump_and_kink(q, p) (q - 0.2).signum() * q + 0.5 * q.max(0.1) => JumpAndKink;
}

// The last start is at rest, exactly at a kink.
const STARTS: [(f64, f64); 6] = [(1.0, -2.0), (1.0, -1.0), (0.5, -2.0), (-1.0, 1.3), (-1.0, 2.6), (0.0, 0.0)];
const STEPS: [f64; 5] = [0.05, 0.1, 0.125, 0.325, 0.65];

/// A method that claims to keep the energy keeps it in every accepted step.
struct Kept<S> {
    system: S,
    mass: f64,
    smooth: bool,
    taken: u32,
    /// The largest error of a step, in units of 1 + |H|.
    rounding: f64,
}

impl<S: Hamiltonian<Coordinates = f64>> Visitor<S, f64> for Kept<S> {
    fn visit<M: Method<S> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        if !method.claims().conserves_energy {
            return;
        }
        for ((q, p), h) in pairs(&STARTS, &STEPS, 5, &format!("{name}, {}", std::any::type_name::<S>())) {
            // From some starts, sums of steps end at the switch, up to rounding.
            let start = State::new(q, p * self.mass);
            let mut sim = self.system.integrator(method, h, start);
            let energy = sim.energy();
            let mut outcome = Ok(());
            while sim.steps() < 60 && outcome.is_ok() {
                outcome = sim.step();
                let error = (sim.energy() - energy).abs() / (1.0 + energy.abs());
                assert!(error < self.rounding, "{name}: {error:.1e} at {:?}, h = {h} from {start:?}", sim.state());
            }
            self.taken += u32::try_from(sim.steps()).unwrap();
            let refused = matches!(outcome, Err(StepError { failure: Failure::OutsideDomain { .. }, .. }));
            assert!(!(self.smooth && refused), "{name}: {outcome:?}, h = {h} from {start:?}");
            let mut bulk = self.system.integrator(method, h, start);
            // Compares texts, because a NaN in a correction is not equal to itself.
            let (all, single) = ((bulk.advance(60), bulk.state()), (outcome, sim.state()));
            assert_eq!(format!("{all:?}"), format!("{single:?}"), "{name}: h = {h} from {start:?}");
        }
    }
}

fn check<S: SolvedBy<DiscreteGradient> + DiscreteField + Autonomous<Coordinates = f64>>(
    system: S,
    mass: f64,
    smooth: bool,
) {
    let mut kept = Kept { system, mass, smooth, taken: 0, rounding: 1e-12 };
    kept.visit(DiscreteGradient);
    kept.visit(Gonzalez);
    kept.visit(ItohAbe);
    kept.visit(ItohAbePair);
    kept.visit(SymmetrisedItohAbe);
    kept.visit(CoordinateIncrement::default());
    kept.visit(FourthOrder(DiscreteGradient));
    kept.visit(Suzuki4.of(DiscreteGradient));
    kept.visit(MeanValue::<3>);
    // The error of these methods is measured elsewhere. A jump of the energy is far larger than this bound.
    kept.rounding = 1e-9;
    methods::projected(&mut kept);
    methods::relaxed(&mut kept);
    assert!(kept.taken > 2000, "{}", kept.taken);
}

#[test]
fn the_energy_is_kept_across_a_switch() {
    // With mass 1 steps of 0.1 end at the switch up to rounding.
    for m in [1.0, 1.3] {
        check(StepOfPotential { m }, m, false);
        check(StepDown { m }, m, false);
        check(StepOfForce { m }, m, false);
        check(TwoSteps { m }, m, false);
        check(Sign { m }, m, false);
        check(Factor { m }, m, false);
        check(Bent { m }, m, true);
        check(Spring { m }, m, true);
    }
}

/// An iteration that alternates between the sides of a jump has no solution, even if other solutions are near. The jump must not be accepted as rounding.
#[test]
fn jumps_are_no_rounding() {
    // Regression test: steps from these starts were accepted with an error of 1e-3 to 0.2 in the energy.
    let starts = [
        (-0.7098436037139653, 0.8889953838868171),
        (-0.22561210646640695, 0.5765589928454418),
        (-0.3584680296066671, 0.09441012627953915),
        (0.2706822120892436, -0.9928532218481347),
        (0.07881845409631882, -0.5034736742325647),
        (-0.7215320890640515, -0.4832874672031866),
        (-0.9061356566472132, 0.8150098492517137),
        (0.6683098163242362, 0.8295365974591673),
        (-0.8110975934743747, 0.8682373154441223),
    ];
    fn check<S: SolvedBy<DiscreteGradient> + DiscreteField + Autonomous<Coordinates = f64>>(
        system: S,
        starts: &[(f64, f64)],
    ) {
        fn runs<S: Hamiltonian<Coordinates = f64>, M: Method<S>>(system: S, method: M, starts: &[(f64, f64)]) {
            for (q, p) in starts {
                for h in [0.05, 0.2, 0.7, -0.3] {
                    let mut sim = system.integrator(method, h, State::new(*q, *p));
                    let energy = sim.energy();
                    while sim.steps() < 40 && sim.step().is_ok() {
                        let error = (sim.energy() - energy).abs();
                        assert!(error < 1e-12, "{}: {error:.1e}, h = {h} from {q}, {p}", method.name());
                    }
                }
            }
        }
        runs(system, DiscreteGradient, starts);
        runs(system, FourthOrder(DiscreteGradient), starts);
        runs(system, Gonzalez, starts);
        runs(system, ItohAbePair, starts);
    }
    check(ThreeKinks { m: 0.7 }, &starts);
    check(JumpAndKink { m: 1.0 }, &starts);
    check(JumpAndKink { m: 1.3 }, &starts);
}

#[hamiltonian]
fn well(q: [f64; 2], p: [f64; 2], m: f64, k: f64, r: f64) -> f64 {
    let depth = if q[0] * q[0] + q[1] * q[1] < r * r { -k } else { 0.0 };
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + depth
}

/// A spring that is cut where it ends.
#[hamiltonian]
fn cut(q: [f64; 2], p: [f64; 2], m: f64, k: f64, r: f64) -> f64 {
    let square = q[0] * q[0] + q[1] * q[1];
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + if square < r * r { k / 2.0 * (square - r * r) } else { 0.0 }
}

/// At the edge of a square well the force vanishes on both sides. Neither a series nor an estimate of errors detects the jump, at any tolerance.
#[test]
fn steps_to_a_tolerance_end_where_the_energy_jumps() {
    // Units of one, and units of atoms.
    for [length, mass, time] in [[1.0, 1.0, 1.0], [1e-10, 1e-26, 1e-13]] {
        let [momentum, energy] = [mass * length / time, mass * length * length / (time * time)];
        let system = Well { m: 1.3 * mass, k: 0.4 * energy, r: length };
        let start = State::new([-3.0 * length, 0.6 * length], [momentum, 0.0]);
        // The particle flies 2.2 lengths with a velocity of 1/1.3.
        let there = 2.2 * 1.3 * time;
        let end = |outcome: Result<(), StepError>, state: State<[f64; 2]>| {
            let Err(StepError { failure: Failure::OutsideDomain { what }, .. }) = outcome else {
                panic!("{outcome:?} at {state:?}")
            };
            assert!(what.starts_with("the energy jumps where a condition changes, by -k"), "{what}");
            assert!(what.contains("shift one side") && what.contains("`DiscreteGradient`"), "{what}");
            assert!((state.t / there - 1.0).abs() < 1e-12, "{state:?}");
        };
        let mut adaptive = system.adaptive(DOP853, 1e-9, start);
        end(adaptive.advance_to(10.0 * time), adaptive.state());
        let mut halved = system.adaptive(StormerVerlet, 1e-6, start);
        end(halved.advance_to(10.0 * time), halved.state());
        let mut series = system.taylor(Taylor { tolerance: 1e-12 }, start);
        end(series.advance_to(10.0 * time), series.state());
        // A method that keeps the energy continues.
        let mut secants = system.adaptive(DiscreteGradient, 1e-3, start);
        secants.advance_to(10.0 * time).unwrap_or_else(|error| panic!("{error}"));
        assert!((secants.energy() / system.energy(&start) - 1.0).abs() < 1e-12);
    }
    let fixed =
        Well { m: 1.3, k: 0.4, r: 1.0 }.taylor(TaylorFixed::<12> { h: 0.5 }, State::new([-3.0, 0.6], [1.0, 0.0]));
    let (mut sim, mut outcome) = (fixed, Ok(()));
    while outcome.is_ok() && sim.state().t < 10.0 {
        outcome = sim.step();
    }
    assert!(matches!(outcome, Err(StepError { failure: Failure::OutsideDomain { .. }, .. })), "{outcome:?}");
    assert!(Well::<f64>::REPORT.contains("Jumps\n- H may jump where q[0]² + q[1]² = r²"), "{}", Well::<f64>::REPORT);
}

#[hamiltonian]
fn short_well(q: [f32; 2], p: [f32; 2], m: f32, k: f32, r: f32) -> f32 {
    let depth = if q[0] * q[0] + q[1] * q[1] < r * r { -k } else { 0.0 };
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + depth
}

/// Steps of fixed length end before a jump of the energy, in calls of any length. Otherwise the run would continue with another energy, without a report. A
/// method that keeps the energy passes.
#[test]
fn steps_of_one_length_end_where_the_energy_jumps() {
    fn ends<S, M>(system: S, method: M, h: S::Real, start: StateOf<S, S::Real>, there: f64)
    where
        S: Jumping,
        M: Method<S, S::Real>,
    {
        let name = method.name();
        let run = || Integrator::new(system, method, h, start);
        let (mut bulk, mut singly) = (run(), run());
        let outcome = bulk.advance(5000);
        let Err(StepError { failure: Failure::OutsideDomain { what }, .. }) = outcome else {
            panic!("{name}: {outcome:?} at {:?}", bulk.state())
        };
        assert!(what.starts_with("the energy jumps where a condition changes, by -k"), "{name}: {what}");
        let left = (there - S::number(bulk.time())) / S::number(h);
        assert!(left > -0.1 && left < 1.1, "{name}: {left} steps are left");
        let singly_ends = (0..5000).find_map(|_| singly.step().err());
        assert_eq!((singly_ends, singly.state()), (outcome.err(), bulk.state()), "{name}");
    }
    for [length, mass, time] in [[1.0, 1.0, 1.0], [1e-10, 1e-26, 1e-13]] {
        let [momentum, energy] = [mass * length / time, mass * length * length / (time * time)];
        let system = Well { m: 1.3 * mass, k: 0.4 * energy, r: length };
        let start = State::new([-3.0 * length, 0.6 * length], [momentum, 0.0]);
        // In units of time.
        let there = 2.2 * 1.3 * time;
        // A step of the second length enters and leaves the well.
        for h in [0.0013 * time, 2.5 * time] {
            ends(system, StormerVerlet, h, start, there);
            ends(system, RK4, h, start, there);
            ends(system, BlanesMoan6, h, start, there);
            ends(system, Gauss::<2>, h, start, there);
            ends(system, ImplicitMidpoint, h, start, there);
            ends(system, Suzuki4.of(ImplicitMidpoint), h, start, there);
            ends(system, DOP853, h, start, there);
        }
        let mut back = system.integrator(RK4, -0.01 * time, State { p: [-momentum, 0.0], ..start });
        assert!(
            matches!(back.advance(5000), Err(StepError { failure: Failure::OutsideDomain { .. }, .. })),
            "{:?}",
            back.state()
        );
        let mut summed = system.integrator(StormerVerlet, 0.01 * time, start).compensated();
        assert!(
            matches!(summed.advance(5000), Err(StepError { failure: Failure::OutsideDomain { .. }, .. })),
            "{:?}",
            summed.state()
        );
        // Controls: a run beside the well, and methods that keep the energy.
        let beside = State::new([-3.0 * length, 1.1 * length], [momentum, 0.0]);
        system.integrator(StormerVerlet, 0.01 * time, beside).advance(5000).unwrap_or_else(|error| panic!("{error}"));
        let mut kept = system.integrator(DiscreteGradient, 0.0013 * time, start);
        kept.advance(5000).unwrap_or_else(|error| panic!("{error}"));
        assert!((kept.energy() / system.energy(&start) - 1.0).abs() < 1e-11, "{:e}", kept.energy());
        let mut projected = system.integrator(Projection(RK4, Energy), 0.0013 * time, start);
        let outcome = projected.advance(5000);
        assert!(
            (projected.energy() / system.energy(&start) - 1.0).abs() < 1e-11,
            "{outcome:?} {:e}",
            projected.energy()
        );
    }
    let short = ShortWell { m: 1.3, k: 0.4, r: 1.0 };
    ends(short, StormerVerlet, 0.0013, State::new([-3.0, 0.6], [1.0, 0.0]), 2.2 * 1.3);
    ends(short, Gauss::<2>, 0.01, State::new([-3.0, 0.6], [1.0, 0.0]), 2.2 * 1.3);
}

/// A well over some scalar.
trait Jumping: PhaseSpace<Self::Real> {
    type Real: Real;
    fn number(x: Self::Real) -> f64 {
        x.magnitude()
    }
}

impl Jumping for Well {
    type Real = f64;
}

impl Jumping for ShortWell {
    type Real = f32;
}

/// Under friction as well, where the momentum would jump.
#[contact_hamiltonian]
fn well_with_friction(q: f64, p: f64, s: f64, k: f64, g: f64) -> f64 {
    p * p / 2.0 + if q * q < 1.0 { -k } else { 0.0 } + g * s
}

#[test]
fn contact_steps_end_where_the_energy_jumps() {
    let (system, start) = (WellWithFriction { k: 0.4, g: 0.1 }, ContactState::new(-3.0, 2.0, 0.0));
    fn ends(outcome: Result<(), StepError>, state: ContactState<f64>) {
        assert!(
            matches!(outcome, Err(StepError { failure: Failure::OutsideDomain { .. }, .. })),
            "{outcome:?} {state:?}"
        );
        assert!(state.q < -1.0 && state.q > -1.03, "{state:?}");
    }
    let mut split = system.integrator(ContactSplitting, 0.01, start);
    ends(split.advance(5000), split.state());
    let mut implicit = system.integrator(ContactMidpoint, 0.01, start);
    ends(implicit.advance(5000), implicit.state());
}

/// A condition at which the energy does not jump ends no step.
#[test]
fn steps_to_a_tolerance_pass_where_nothing_jumps() {
    let (system, start) = (Cut { m: 1.3, k: 2.0, r: 1.1 }, State::new([-3.0, 0.6], [1.0, 0.0]));
    let mut series = system.taylor(Taylor { tolerance: 1e-12 }, start);
    let mut adaptive = system.adaptive(DOP853, 1e-9, start);
    series.advance_to(10.0).unwrap_or_else(|error| panic!("{error}"));
    adaptive.advance_to(10.0).unwrap_or_else(|error| panic!("{error}"));
    let gap = (0..2).map(|i| (series.state().q[i] - adaptive.state().q[i]).abs()).fold(0.0, f64::max);
    assert!(gap < 1e-6 && (series.energy() - system.energy(&start)).abs() < 1e-11, "{gap:e}");
    for report in [Cut::<f64>::REPORT, Bent::<f64>::REPORT, Spring::<f64>::REPORT, ThreeKinks::<f64>::REPORT] {
        assert!(!report.contains("Jumps"), "{report}");
    }
}
