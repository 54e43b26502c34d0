//! Splittings by terms of H and by planes: errors against the same solutions, conserved quantities, and quantities that must move.

mod increments;
mod planes;
mod spins;
mod terms;

use super::systems::*;
use super::{Motion, VERTICAL};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::system::FirstIntegrals;

/// A function of x; and the largest change on the way in the first run, nothing if steps keep it to rounding.
type Watched<'a, const N: usize> = (&'a dyn Fn(&[f64; N]) -> f64, Option<f64>);

impl<S, const N: usize> Motion<S, N>
where
    S: FirstIntegrals<State = FlowState<[f64; N]>, Phase = [f64; N]>,
{
    /// Compares errors in n, 2n, … steps with a row of the table. Each watched function must be conserved, or move by its expected amount.
    fn splits<M: Method<S> + Copy>(&self, method: M, row: &[f64], watched: &[Watched<'_, N>]) {
        for (k, expected) in row.iter().enumerate() {
            let steps = self.steps << k;
            let mut sim = Integrator::new(self.system, method, self.time / steps as f64, FlowState::new(self.start));
            let mut changes = vec![0.0_f64; watched.len()];
            for _ in 0..steps {
                sim.step().unwrap_or_else(|error| panic!("{}: {error}", self.name));
                for (change, (f, _)) in changes.iter_mut().zip(watched) {
                    *change = change.max((f(&sim.state().x) - f(&self.start)).abs());
                }
            }
            let x = sim.state().x;
            let error = x.iter().zip(&self.end).map(|(x, end)| (x - end).abs()).fold(0.0, f64::max);
            let name = format!("{}, {}, {steps} steps", self.name, method.name());
            assert!((error / expected - 1.0).abs() < 0.02, "{name}: {error:.3e}, not {expected:.3e}");
            for (i, (change, (_, moves))) in changes.iter().zip(watched).enumerate() {
                match moves {
                    None => assert!(*change <= 2e-14 * f64::from(1 << k), "{name}: {i} moves by {change:e}"),
                    Some(moves) if k == 0 => {
                        assert!((change / moves - 1.0).abs() < 0.1, "{name}: {i} moves by {change:e}, not {moves:e}");
                    }
                    Some(_) => assert!(*change > 1e-12, "{name}: {i} is kept"),
                }
            }
        }
        let order = f64::from(method.claims().order);
        // Only symmetric methods: the order of the others is farther from its limit in these steps.
        for pair in row.windows(2).filter(|_| method.claims().symmetric) {
            let measured = (pair[0] / pair[1]).log2();
            assert!((measured - order).abs() < 0.05, "{}: order {measured}", self.name);
        }
    }

    fn energy(&self) -> impl Fn(&[f64; N]) -> f64 + use<S, N> {
        let system = self.system;
        move |x| system.hamiltonian(0.0, x, &())
    }
}

const EULER: Motion<FreeBody, 3> = Motion {
    name: "Euler's top",
    system: FreeBody { inertia: [1.0, 2.0, 3.0] },
    start: [0.5, 0.8, -0.4],
    time: 10.0,
    end: [-0.85561253291713022033, 0.39740054543889689429, -0.56629580211666389173],
    steps: 100,
};

const VOLTERRA: Motion<Volterra, 5> = Motion {
    name: "Volterra's lattice",
    system: Volterra,
    start: [1.0, 0.5, 0.8, 1.2, 0.6],
    time: 3.0,
    end: [
        2.5295809086075229707,
        0.078530750263851688815,
        1.2831423193222661713,
        0.060863164275746965526,
        0.14788285753061220365,
    ],
    steps: 30,
};

const PREDATORS: Motion<LotkaVolterra, 2> = Motion {
    name: "predators and prey",
    system: LotkaVolterra { a: 2.0, b: 1.0, c: 1.0 },
    start: [1.0, 0.5],
    time: 5.0,
    end: [0.77147673840262978160, 0.51045216400203446710],
    steps: 50,
};

const RING: Motion<Ring, 3> = Motion {
    name: "ring",
    system: Ring,
    start: [1.0, 0.5, 0.8],
    time: 5.0,
    end: [0.95356474896859081907, 0.48952391985507311643, 0.85691133117633606449],
    steps: 50,
};

const LORENZ: Motion<LorenzCore, 3> = Motion {
    name: "Lorenz 1984",
    system: LorenzCore { b: 4.0 },
    start: [1.0, 0.5, -0.3],
    time: 3.0,
    end: [-1.1274566134891053462, -0.21756567454193858326, 0.14665183926834799221],
    steps: 60,
};

const LAGRANGE: Motion<HeavyTop, 6> = Motion {
    name: "Lagrange's top",
    system: HeavyTop { inertia: [2.0, 2.0, 1.0], r: [0.0, 0.0, 1.0] },
    start: [0.3, -0.2, 2.0, VERTICAL[0], VERTICAL[1], VERTICAL[2]],
    time: 5.0,
    end: [
        -1.1469732122463854901,
        -0.93183370060149636357,
        2.0,
        -0.94971702955080800372,
        -0.12623583522340901208,
        0.28653460120313219441,
    ],
    steps: 50,
};

const KOVALEVSKAYA: Motion<HeavyTop, 6> = Motion {
    name: "Kovalevskaya's top",
    system: HeavyTop { inertia: [2.0, 2.0, 1.0], r: [1.0, 0.0, 0.0] },
    start: [0.3, -0.2, 0.5, VERTICAL[0], VERTICAL[1], VERTICAL[2]],
    time: 5.0,
    end: [
        1.1601930438033888589,
        1.1272590121190907921,
        -0.57298984740226171146,
        -0.060848877436403746300,
        0.071075203946147870697,
        -0.99561324293057844058,
    ],
    steps: 50,
};

const GORYACHEV: Motion<HeavyTop, 6> = Motion {
    name: "Goryachev's top",
    system: HeavyTop { inertia: [4.0, 4.0, 1.0], r: [1.0, 0.0, 0.0] },
    start: [0.4, 0.3, -0.3, VERTICAL[0], VERTICAL[1], VERTICAL[2]],
    time: 5.0,
    end: [
        -2.2272284378830630335,
        1.8634927218740777820,
        0.59072334447721822587,
        -0.55237098967358042588,
        -0.43471674586206646449,
        -0.71127184721042124622,
    ],
    steps: 50,
};

const WAVES: Motion<AblowitzLadik, 8> = Motion {
    name: "Ablowitz and Ladik",
    system: AblowitzLadik,
    start: [0.5, 0.1, -0.2, 0.3, 0.0, 0.4, 0.2, -0.1],
    time: 2.0,
    end: [
        -0.13423447273867066019,
        0.0018969427673376861584,
        0.26757772295915770435,
        0.15825055912463559002,
        0.55044711613164499503,
        -0.10124090257074487773,
        -0.067567555249788739612,
        0.42978123526427892912,
    ],
    steps: 40,
};

const VORTICES: Motion<Vortices, 8> = Motion {
    name: "vortices",
    system: Vortices { gamma: [1.0, 2.0, -1.0, 3.0] },
    start: [0.0, 1.0, 0.2, -1.1, 0.0, 0.3, 1.2, -0.4],
    time: 1.0,
    end: [
        1.2131199504944379595,
        -1.5530891711957601067,
        -0.29701546410884065870,
        0.032014309262747198375,
        -1.9315032888371548361,
        -0.55207141742493087460,
        -2.5057253649990021506,
        -0.42335974710399518842,
    ],
    steps: 50,
};

const CHARGE: Motion<Charge, 6> = Motion {
    name: "charge",
    system: Charge,
    start: [0.5, -0.3, 0.2, 0.4, 0.7, -0.1],
    time: 5.0,
    end: [
        -0.63772189560547351992,
        0.61721232894004678030,
        -0.19668686109139586141,
        -0.53834266129082627439,
        -0.36740455661945594058,
        0.10259489007550804684,
    ],
    steps: 50,
};

/// ln x₁x₃x₅ of Volterra's lattice.
fn odd(x: &[f64; 5]) -> f64 {
    (x[0] * x[2] * x[4]).ln()
}

/// S of Lorenz's core has no Poisson bracket, and planes keep none.
#[test]
fn claims() {
    fn of<S: PhaseSpace>(method: impl Method<S>) -> [bool; 2] {
        let claims = method.claims();
        [claims.symplectic, claims.conserves_energy]
    }
    assert_eq!(of::<FreeBody>(PoissonSplitting), [true, false]);
    assert_eq!(of::<FreeBody>(Suzuki4.of(PlanarSplitting)), [false, true]);
    assert_eq!(of::<LorenzCore>(BlanesMoan4X.of(PoissonSplitting)), [false, false]);
}
