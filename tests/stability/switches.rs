//! Energies that jump, or bend, at a condition.

use geoint_runtime::prelude::*;
use geoint_runtime::system::DiscreteField;
use geoint_runtime::{Autonomous, Hamiltonian, Method};
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
}

// The last one is at rest, exactly at a kink.
const STARTS: [(f64, f64); 6] = [(1.0, -2.0), (1.0, -1.0), (0.5, -2.0), (-1.0, 1.3), (-1.0, 2.6), (0.0, 0.0)];
const STEPS: [f64; 5] = [0.05, 0.1, 0.125, 0.325, 0.65];

/// What claims to keep the energy keeps it in every step that it takes.
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
        for ((q, p), h) in pairs(&STARTS, &STEPS, 3, &format!("{name}, {}", std::any::type_name::<S>())) {
            // Starts at which sums of steps end at the switch, up to rounding.
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
            let refused = matches!(outcome, Err(StepError::OutsideDomain { .. }));
            assert!(!(self.smooth && refused), "{name}: {outcome:?}, h = {h} from {start:?}");
            let mut bulk = self.system.integrator(method, h, start);
            // As text: a correction that is not a number equals nothing.
            let (all, single) = ((bulk.advance(60), bulk.state()), (outcome, sim.state()));
            assert_eq!(format!("{all:?}"), format!("{single:?}"), "{name}: h = {h} from {start:?}");
        }
    }
}

fn check<S: DiscreteField + Autonomous<Coordinates = f64>>(system: S, mass: f64, smooth: bool) {
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
    // How far these are from the energy is measured elsewhere; a jump is much more.
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
