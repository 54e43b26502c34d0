//! Splittings by terms of H and by planes: errors against the same solutions, what they keep, and what they must move.

use super::systems::*;
use super::{Motion, VERTICAL};
use geoint_runtime::prelude::*;
use geoint_runtime::system::FirstIntegrals;

/// A function of x; and the largest change on the way in the first run, nothing if steps keep it to rounding.
type Watched<'a, const N: usize> = (&'a dyn Fn(&[f64; N]) -> f64, Option<f64>);

impl<S, const N: usize> Motion<S, N>
where
    S: FirstIntegrals<State = FlowState<[f64; N]>, Phase = [f64; N]>,
{
    /// Compares errors in n, 2n, … steps with a row of the table, and what is kept and what moves.
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
        for pair in row.windows(2) {
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

/// Suzuki's composition.
macro_rules! four {
    ($map:expr) => {
        Suzuki4.of($map)
    };
}

#[test]
fn euler_by_terms() {
    let (energy, momentum) =
        (EULER.energy(), |w: &[f64; 3]| (w[0].powi(2) + 4.0 * w[1].powi(2) + 9.0 * w[2].powi(2)) / 2.0);
    EULER.splits(PoissonSplitting, &[7.494e-4, 1.874e-4, 4.685e-5], &[(&momentum, None), (&energy, Some(4.0e-5))]);
    EULER.splits(
        four!(PoissonSplitting),
        &[7.448e-8, 4.665e-9, 2.917e-10],
        &[(&momentum, None), (&energy, Some(7.4e-9))],
    );
}

#[test]
fn tops_by_terms() {
    let length = |x: &[f64; 6]| x[3] * x[3] + x[4] * x[4] + x[5] * x[5];
    let vertical = |x: &[f64; 6]| x[0] * x[3] + x[1] * x[4] + x[2] * x[5];
    let tops = |top: &Motion<HeavyTop, 6>, row: &[f64], moves: f64| {
        let energy = top.energy();
        top.splits(PoissonSplitting, row, &[(&length, None), (&vertical, None), (&energy, Some(moves))]);
    };
    tops(&LAGRANGE, &[2.242e-3, 5.608e-4, 1.402e-4], 4.1e-3);
    tops(&KOVALEVSKAYA, &[4.258e-3, 1.066e-3, 2.666e-4], 7.5e-4);
    tops(&GORYACHEV, &[4.185e-3, 1.048e-3, 2.620e-4], 8.1e-4);
    let (energy, spin) = (LAGRANGE.energy(), |x: &[f64; 6]| x[2]);
    LAGRANGE.splits(PoissonSplitting, &[2.242e-3], &[(&spin, Some(2.3e-3))]);
    LAGRANGE.splits(
        four!(PoissonSplitting),
        &[1.234e-6, 7.783e-8, 4.876e-9],
        &[(&length, None), (&vertical, None), (&energy, Some(1.7e-6))],
    );
}

/// ln x₁x₃x₅ of Volterra's lattice.
fn odd(x: &[f64; 5]) -> f64 {
    (x[0] * x[2] * x[4]).ln()
}

#[test]
fn species_by_terms() {
    let sum = VOLTERRA.energy();
    VOLTERRA.splits(PoissonSplitting, &[1.545e-3, 3.855e-4, 9.632e-5], &[(&odd, None), (&sum, Some(1.3e-3))]);
    VOLTERRA.splits(four!(PoissonSplitting), &[3.841e-7, 2.404e-8, 1.503e-9], &[(&odd, None), (&sum, Some(4.2e-7))]);
    let wealth = PREDATORS.energy();
    PREDATORS.splits(PoissonSplitting, &[3.565e-3, 8.839e-4, 2.205e-4], &[(&wealth, Some(9.1e-3))]);
    PREDATORS.splits(four!(PoissonSplitting), &[7.891e-6, 4.973e-7, 3.115e-8], &[(&wealth, Some(3.1e-5))]);
}

#[test]
fn sites_by_terms() {
    let (energy, norm) =
        (WAVES.energy(), |x: &[f64; 8]| (0..4).map(|i| (1.0 + x[i] * x[i] + x[4 + i] * x[4 + i]).ln()).sum::<f64>());
    WAVES.splits(PoissonSplitting, &[1.456e-3, 3.641e-4, 9.102e-5], &[(&energy, Some(2.7e-4)), (&norm, Some(1.7e-3))]);
    WAVES.splits(four!(PoissonSplitting), &[2.643e-7, 1.657e-8, 1.037e-9], &[(&energy, Some(3.7e-8))]);
}

#[test]
fn vortices_by_pairs() {
    let gamma = VORTICES.system.gamma;
    let energy = VORTICES.energy();
    let across = |x: &[f64; 8]| (0..4).map(|i| gamma[i] * x[i]).sum::<f64>();
    let along = |x: &[f64; 8]| (0..4).map(|i| gamma[i] * x[4 + i]).sum::<f64>();
    VORTICES.splits(
        PoissonSplitting,
        &[1.459e-2, 3.696e-3, 9.273e-4],
        &[(&across, None), (&along, None), (&energy, Some(1.4e-2))],
    );
    VORTICES.splits(four!(PoissonSplitting), &[5.193e-6, 3.257e-7, 2.038e-8], &[(&energy, Some(1.9e-5))]);
}

#[test]
fn euler_by_planes() {
    let (energy, momentum) =
        (EULER.energy(), |w: &[f64; 3]| (w[0].powi(2) + 4.0 * w[1].powi(2) + 9.0 * w[2].powi(2)) / 2.0);
    EULER.splits(PlanarSplitting, &[2.193e-3, 5.492e-4, 1.373e-4], &[(&energy, None), (&momentum, Some(5.2e-4))]);
    EULER.splits(
        four!(PlanarSplitting),
        &[5.214e-8, 3.260e-9, 2.038e-10],
        &[(&energy, None), (&momentum, Some(8.6e-8))],
    );
}

#[test]
fn species_by_planes() {
    let wealth = PREDATORS.energy();
    PREDATORS.splits(PlanarSplitting, &[7.339e-3, 1.838e-3, 4.597e-4], &[(&wealth, None)]);
    let sum = VOLTERRA.energy();
    VOLTERRA.splits(PlanarSplitting, &[9.265e-4, 2.317e-4, 5.793e-5], &[(&sum, None), (&odd, Some(3.6e-4))]);
    VOLTERRA.splits(four!(PlanarSplitting), &[3.544e-8, 2.212e-9, 1.382e-10], &[(&sum, None), (&odd, Some(5.1e-8))]);
    let (sum, product) = (RING.energy(), |x: &[f64; 3]| x[0] * x[1] * x[2]);
    RING.splits(PlanarSplitting, &[5.310e-4, 1.324e-4, 3.309e-5], &[(&sum, None), (&product, Some(3.5e-4))]);
    RING.splits(four!(PlanarSplitting), &[1.185e-7, 7.414e-9, 4.634e-10], &[(&sum, None), (&product, Some(4.5e-8))]);
}

/// Two planes are solved for, and one turns; that one dominates the error where it is solved for as well.
#[test]
fn lorenz_by_planes() {
    let energy = LORENZ.energy();
    LORENZ.splits(PlanarSplitting, &[1.201e-4, 3.004e-5, 7.509e-6], &[(&energy, None)]);
}

/// Four sites, none of whose planes has a flow in closed form.
#[test]
fn sites_by_planes() {
    let (energy, norm) =
        (WAVES.energy(), |x: &[f64; 8]| (0..4).map(|i| (1.0 + x[i] * x[i] + x[4 + i] * x[4 + i]).ln()).sum::<f64>());
    WAVES.splits(PlanarSplitting, &[5.108e-4, 1.278e-4, 3.196e-5], &[(&energy, None), (&norm, Some(1.2e-4))]);
}

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

/// Of the planes of a charge one is solved for; three turn, and so do all nine of heavy tops, or they are parabolas.
#[test]
fn more_than_three_coordinates_by_planes() {
    let energy = CHARGE.energy();
    CHARGE.splits(PlanarSplitting, &[2.227e-3, 5.561e-4, 1.390e-4], &[(&energy, None)]);
    let length = |x: &[f64; 6]| x[3] * x[3] + x[4] * x[4] + x[5] * x[5];
    let rows: [(&Motion<HeavyTop, 6>, &[f64], f64); 3] = [
        (&LAGRANGE, &[2.251e-2, 5.634e-3, 1.409e-3], 6.12e-3),
        (&KOVALEVSKAYA, &[3.461e-3, 8.677e-4, 2.171e-4], 2.16e-3),
        (&GORYACHEV, &[3.419e-3, 8.550e-4, 2.138e-4], 3.08e-3),
    ];
    for (top, row, moves) in rows {
        let energy = top.energy();
        top.splits(PlanarSplitting, row, &[(&energy, None), (&length, Some(moves))]);
    }
}

/// S is searched for: that of predators and of Volterra's lattice is the one that their energies have.
#[test]
fn fields_by_planes() {
    /// The same motion of a field.
    fn of<S, const N: usize>(motion: &Motion<impl Copy, N>, system: S) -> Motion<S, N> {
        let Motion { name, start, time, end, steps, .. } = *motion;
        Motion { name, system, start, time, end, steps }
    }
    let predators = of(&PREDATORS, Predators { a: 2.0, b: 1.0, c: 1.0 });
    let wealth = PREDATORS.energy();
    predators.splits(PlanarSplitting, &[7.339e-3, 1.838e-3, 4.597e-4], &[(&wealth, None)]);
    predators.splits(PoissonSplitting, &[3.565e-3, 8.839e-4, 2.205e-4], &[(&wealth, Some(9.1e-3))]);
    let sum = VOLTERRA.energy();
    let volterra = of(&VOLTERRA, VolterraField);
    volterra.splits(PlanarSplitting, &[9.265e-4, 2.317e-4, 5.793e-5], &[(&sum, None), (&odd, Some(3.6e-4))]);
    volterra.splits(four!(PlanarSplitting), &[3.544e-8, 2.212e-9, 1.382e-10], &[(&sum, None), (&odd, Some(5.1e-8))]);
    let charge = CHARGE.energy();
    of(&CHARGE, ChargeField).splits(PlanarSplitting, &[2.227e-3, 5.561e-4, 1.390e-4], &[(&charge, None)]);
    // Of many S, one with fewer planes.
    let (euler, lorenz) = (EULER.energy(), LORENZ.energy());
    let top = of(&EULER, EulerTop { a: 1.0, b: 2.0, c: 3.0 });
    top.splits(PlanarSplitting, &[2.982e-4, 7.454e-5, 1.863e-5], &[(&euler, None)]);
    of(&LORENZ, LorenzField { b: 4.0 }).splits(PlanarSplitting, &[1.201e-4, 3.004e-5, 7.509e-6], &[(&lorenz, None)]);
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
