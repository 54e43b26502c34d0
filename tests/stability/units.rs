//! Units: a change of units by powers of two changes no bit of a result. The energy is kept to rounding in all units.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Hamiltonian, IntoIntegrator, Method};
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::*;
use std::marker::PhantomData;

/// Exponents of units: the number 1 in plain units is 2ᵏ in the new units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Units {
    pub(super) q: i32,
    pub(super) p: i32,
    pub(super) t: i32,
}

pub(super) const PLAIN: Units = Units { q: 0, p: 0, t: 0 };
const UNITS: [Units; 5] = [
    Units { q: 3, p: -5, t: 1 },
    Units { q: 37, p: 97, t: 23 },
    Units { q: -33, p: -80, t: -53 },
    Units { q: 100, p: -100, t: -7 },
    Units { q: -100, p: 100, t: 40 },
];

/// Units of 10¹⁰⁰: energies are 10²⁰⁰, and their squares overflow.
const FAR: [Units; 2] = [Units { q: -330, p: -330, t: 0 }, Units { q: 330, p: 330, t: 0 }];

/// 2ᵏ.
pub(super) fn power(k: i32) -> f64 {
    2.0_f64.powi(k)
}

/// A system that can be written in other units.
trait Measured {
    type System: Hamiltonian<f64>;
    /// Further units, in which the energy and its derivatives keep all their digits.
    const FURTHER: &'static [Units] = &[];

    /// Returns the possible units next to the requested units. A constant of the energy may fix one unit.
    fn possible(units: Units) -> Units {
        units
    }
    fn system(units: Units) -> Self::System;
    /// Units of positions, then momenta.
    fn coordinates(units: Units) -> Vec<i32>;
    /// In plain units.
    const START: [&'static [f64]; 2];
    const STEP: f64;
}

fn start<P: Measured>(units: Units) -> State<<P::System as geoint_runtime::Cotangent>::Coordinates> {
    let exponents = P::coordinates(units);
    let (by_q, by_p) = exponents.split_at(P::START[0].len());
    let [q, p] = [(0, by_q), (1, by_p)]
        .map(|(i, by)| -> Vec<f64> { P::START[i].iter().zip(by).map(|(x, k)| x * power(*k)).collect() });
    state::<P::System, f64>(0.0, &q, &p)
}

/// A state in plain units, bit by bit.
fn plain<P: Measured, Q: geoint_runtime::Coordinates<Real = f64>>(units: Units, state: &State<Q>) -> Vec<u64> {
    flat(state).iter().zip(P::coordinates(units)).map(|(x, k)| (x * power(-k)).to_bits()).collect()
}

impl Measured for Kepler {
    type System = Kepler;
    fn system(Units { q, p, t }: Units) -> Kepler {
        Kepler { mass: 1.6 * power(p + t - q), mu: 2.3 * power(2 * q + p - t) }
    }
    fn coordinates(Units { q, p, .. }: Units) -> Vec<i32> {
        vec![q, q, p, p]
    }
    const START: [&'static [f64]; 2] = [&[0.9, 0.2], &[-0.3, 1.9]];
    const STEP: f64 = 0.05;
}

impl Measured for HenonHeiles {
    type System = HenonHeiles;
    const FURTHER: &'static [Units] = &FAR;
    // The stiffness is 1.
    fn possible(units: Units) -> Units {
        Units { t: units.p - units.q, ..units }
    }
    fn system(Units { q, p, .. }: Units) -> HenonHeiles {
        HenonHeiles { m: [1.7, 0.6].map(|m| m * power(2 * p - 2 * q)), lambda: 0.8 * power(-q) }
    }
    fn coordinates(Units { q, p, .. }: Units) -> Vec<i32> {
        vec![q, q, p, p]
    }
    const START: [&'static [f64]; 2] = [&[0.3, -0.2], &[0.35, 0.0]];
    const STEP: f64 = 0.2;
}

/// The same ellipse in polar coordinates: a length beside an angle, and not separable.
#[hamiltonian]
fn polar(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] / (q[0] * q[0])) / (2.0 * m) - k / q[0]
}

impl Measured for Polar {
    type System = Polar;
    fn system(Units { q, p, t }: Units) -> Polar {
        Polar { m: 1.6 * power(p + t - q), k: 2.3 * power(2 * q + p - t) }
    }
    fn coordinates(Units { q, p, .. }: Units) -> Vec<i32> {
        vec![q, 0, p, q + p]
    }
    const START: [&'static [f64]; 2] = [&[0.9, 0.0], &[-0.3, 1.9]];
    const STEP: f64 = 0.05;
}

/// Tests a list of methods on one system.
struct InUnits<P>(Vec<String>, PhantomData<P>);

impl<P: Measured> Visitor<P::System, f64> for InUnits<P> {
    fn visit<M: Method<P::System, f64> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        // A run may be refused, but after the same number of steps in all units.
        let run = |units: Units| {
            let mut sim = P::system(units).integrator(method, P::STEP * power(units.t), start::<P>(units));
            let energy = sim.energy();
            let outcome = sim.advance(30).is_ok();
            (plain::<P, _>(units, &sim.state()), (sim.energy() - energy).abs() / energy.abs(), sim.steps(), outcome)
        };
        let (expected, _, steps, outcome) = run(PLAIN);
        for units in UNITS.iter().chain(P::FURTHER).map(|units| P::possible(*units)) {
            let seen = run(units);
            if (&seen.0, seen.2, seen.3) != (&expected, steps, outcome) {
                self.0.push(format!("{name} in {units:?}: {seen:?}, plain {expected:?}"));
            }
            if method.claims().conserves_energy && (seen.1 > 1e-14 || seen.1.is_nan()) {
                self.0.push(format!("{name} in {units:?}: energy {:.1e}", seen.1));
            }
        }
    }
}

macro_rules! in_all_units {
    ($($test:ident: $System:ident, $($list:ident)*;)*) => { $(
        #[test]
        fn $test() {
            let mut units = InUnits::<$System>(vec![], PhantomData);
            $( methods::$list(&mut units); )*
            assert!(units.0.is_empty(), "{}", units.0.join("\n"));
        }
    )* };
}

in_all_units! {
    kepler_in_all_units: Kepler, kinds_of_general kinds_of_discrete_gradient projected relaxed kinds_of_separable kinds_of_nystrom
        kinds_of_force_gradient;
    henon_heiles_in_all_units: HenonHeiles, kinds_of_cubic kinds_of_itoh_abe itoh_abe_one_way coordinate_increment
        kinds_of_discrete_gradient;
    polar_in_all_units: Polar, kinds_of_general kinds_of_discrete_gradient kinds_of_itoh_abe itoh_abe_one_way
        coordinate_increment projected relaxed;
}

/// Adaptive steps have the same lengths in all units.
#[test]
fn adaptive_in_all_units() {
    fn check<P: Measured, M: Method<P::System, f64>>(name: &str, method: M) {
        let run = |units: Units| {
            let mut sim = P::system(units).adaptive(method, 1e-7, start::<P>(units));
            sim.advance(30).unwrap();
            (plain::<P, _>(units, &sim.state()), (sim.time() * power(-units.t)).to_bits(), sim.rejections())
        };
        for units in UNITS.map(P::possible) {
            assert_eq!(run(units), run(PLAIN), "{name} in {units:?}");
        }
    }
    check::<Kepler, _>("DOP853", DOP853);
    check::<Kepler, _>("Gauss<3>", Gauss::<3>);
    check::<Polar, _>("Gauss<4>", Gauss::<4>);
    check::<Kepler, _>("DiscreteGradient", DiscreteGradient);
    check::<Polar, _>("DiscreteGradient", DiscreteGradient);
    check::<Polar, _>("Projection", Projection(RK4, Energy));
}

/// Three masses on springs, of which a force pushes one.
#[hamiltonian]
fn pushed(q: [f64; 3], p: [f64; 3], t: f64, m: f64, k: f64, f: f64, omega: f64) -> f64 {
    let [a, b] = [q[1] - q[0], q[2] - q[1]];
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m) + k * (q[0] * q[0] + a * a + b * b) / 2.0
        - f * q[0] * (omega * t).sin()
        - f * q[0]
}

/// The same, from rest without a force at first.
#[hamiltonian]
fn shaken(q: [f64; 3], p: [f64; 3], t: f64, m: f64, k: f64, f: f64, omega: f64) -> f64 {
    let [a, b] = [q[1] - q[0], q[2] - q[1]];
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m) + k * (q[0] * q[0] + a * a + b * b) / 2.0
        - f * q[0] * (omega * t).sin()
}

macro_rules! springs {
    ($($System:ident)*) => { $(
        impl Measured for $System {
            type System = $System;
            fn system(Units { q, p, t }: Units) -> $System {
                let (m, k) = (1.6 * power(p + t - q), 0.9 * power(p - q - t));
                $System { m, k, f: 0.7 * power(p - t), omega: 2.1 * power(-t) }
            }
            fn coordinates(Units { q, p, .. }: Units) -> Vec<i32> {
                vec![q, q, q, p, p, p]
            }
            const START: [&'static [f64]; 2] = [&[0.0; 3], &[0.0; 3]];
            const STEP: f64 = 0.05;
        }
    )* };
}

springs!(Pushed Shaken);

/// If every coordinate is zero, or at rest, the first step has no natural unit.
#[test]
fn adaptive_from_rest_in_all_units() {
    fn check<P: Measured, M: Method<P::System, f64>>(
        method: M,
        start: impl Fn(Units) -> State<<P::System as geoint_runtime::Cotangent>::Coordinates>,
    ) {
        let run = |units: Units| {
            let mut sim = P::system(units).adaptive(method, 1e-7, start(units));
            sim.step().unwrap();
            let rejected = sim.rejections();
            sim.advance(29).unwrap();
            (plain::<P, _>(units, &sim.state()), (sim.time() * power(-units.t)).to_bits(), rejected)
        };
        for units in UNITS.map(P::possible) {
            assert_eq!(run(units), run(PLAIN), "{} in {units:?}", method.name());
        }
        let rejected = run(PLAIN).2;
        assert!(rejected == 0, "{}: the first step is too long, {rejected} rejected", method.name());
    }
    let pericentre = |units: Units| State::new([0.5 * power(units.q), 0.0], [0.0, 1.6 * power(units.p)]);
    macro_rules! all {
        ($($method:expr),*) => { $(
            check::<Kepler, _>($method, pericentre);
            check::<Pushed, _>($method, start::<Pushed>);
            check::<Shaken, _>($method, start::<Shaken>);
        )* };
    }
    all!(DOP853, DiscreteGradient, BlanesMoanSrkn14a, StormerVerlet);
}

/// The removal of accumulated rounding errors after 1024 steps is the same in all units.
#[test]
fn settled_in_all_units() {
    fn check<P: Measured, M: Method<P::System, f64>>(method: M) {
        let run = |units: Units| {
            let mut sim = P::system(units).integrator(method, P::STEP * power(units.t), start::<P>(units));
            sim.advance(1030).unwrap();
            plain::<P, _>(units, &sim.state())
        };
        for units in UNITS.iter().chain(P::FURTHER).map(|units| P::possible(*units)) {
            assert_eq!(run(units), run(PLAIN), "{} in {units:?}", method.name());
        }
    }
    check::<Kepler, _>(DiscreteGradient);
    check::<Kepler, _>(FourthOrder(DiscreteGradient));
    check::<Kepler, _>(Projection(RK4, Energy));
    check::<Polar, _>(DiscreteGradient);
}

/// Energies in SI units: the Earth, and an electron.
struct Si {
    energies: Vec<(String, f64)>,
    kepler: Kepler,
    polar: Polar,
    h: f64,
    radius: f64,
    momentum: f64,
}

fn largest<S: Hamiltonian<f64>, M: Method<S>>(system: S, method: M, h: f64, start: State<S::Coordinates>) -> f64 {
    let mut sim = system.integrator(method, h, start);
    let energy = sim.energy();
    (0..300).map(|_| sim.step().map_or(f64::INFINITY, |()| (sim.energy() / energy - 1.0).abs())).fold(0.0, f64::max)
}

impl Visitor<Kepler, f64> for Si {
    fn visit<M: Method<Kepler, f64> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        if method.claims().conserves_energy {
            let start = State::new([self.radius, 0.0], [0.0, self.momentum]);
            self.energies.push((name, largest(self.kepler, method, self.h, start)));
        }
    }
}

impl Visitor<Polar, f64> for Si {
    fn visit<M: Method<Polar, f64> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        if method.claims().conserves_energy {
            let start = State::new([self.radius, 0.0], [0.0, self.momentum * self.radius]);
            self.energies.push((name, largest(self.polar, method, self.h, start)));
        }
    }
}

#[test]
fn energy_in_si_units() {
    // Mass, coupling, distance and speed.
    for (m, k, radius, speed) in [(5.972e24, 7.928e44, 1.47e11, 3.6e4), (9.109e-31, 2.307e-28, 5.29e-11, 2.4e6)] {
        let (kepler, polar) = (Kepler { mass: m, mu: k }, Polar { m, k });
        let mut si = Si { energies: vec![], kepler, polar, h: 0.1 * radius / speed, radius, momentum: m * speed };
        methods::kinds_of_discrete_gradient::<Kepler, f64>(&mut si);
        methods::projected::<Kepler, f64>(&mut si);
        methods::relaxed::<Kepler, f64>(&mut si);
        methods::kinds_of_discrete_gradient::<Polar, f64>(&mut si);
        methods::projected::<Polar, f64>(&mut si);
        methods::relaxed::<Polar, f64>(&mut si);
        for (name, error) in si.energies {
            println!("{name:36} {error:.1e}");
            assert!(error <= 3e-14, "{name}: {error:.1e}");
        }
    }
}
