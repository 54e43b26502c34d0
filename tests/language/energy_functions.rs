//! Functions from outside: before and behind the energy, in modules, with functions, constants and aliases of their own.
#![deny(warnings, missing_docs, unreachable_pub, clippy::all)]

use geoint_runtime::nalgebra::Vector2;
use geoint_runtime::prelude::*;

// The energy is above what it calls.
#[hamiltonian(with(quartic))]
fn above(q: f64, p: f64, k: f64) -> f64 {
    p * p / 3.0 + quartic(q, k)
}

#[energy_function]
fn quartic(x: f64, k: f64) -> f64 {
    // A name that the energy has as well, for something else.
    let q = k * x;
    q * x * x * x
}

mod forces {
    use geoint_runtime::prelude::*;

    pub(crate) const DEPTH: f64 = 0.5;

    pub(crate) mod inner {
        use geoint_runtime::prelude::*;

        /// The energy's module has another function of this name.
        #[energy_function]
        pub(crate) fn square(x: f64) -> f64 {
            x * x
        }
    }

    // What this calls is private to the module.
    #[energy_function(with(cube))]
    fn sixth(x: f64) -> f64 {
        cube(x) * cube(x)
    }

    #[energy_function]
    fn cube(x: f64) -> f64 {
        x.powi(3)
    }

    #[energy_function(with(sixth, inner::square))]
    pub(super) fn well(x: f64) -> f64 {
        crate::energy_functions::forces::DEPTH * (sixth(x) - inner::square(x) + std::f64::consts::PI)
    }
}
use forces::well;

#[energy_function]
fn square(x: f64) -> f64 {
    2.0 * x * x
}

#[hamiltonian(with(well, square, forces::inner::square))]
fn both(q: f64, p: f64) -> f64 {
    square(p) + forces::inner::square(p) + well(q)
}

mod series {
    use geoint_runtime::nalgebra::Vector2;
    use geoint_runtime::prelude::*;

    const TERMS: usize = 4;
    type Real = f64;
    type Plane = Vector2<Real>;

    /// Bessel's function of order 0; lengths and types have names here.
    #[energy_function(const TERMS = 4, type Real = f64)]
    pub(crate) fn bessel(r: &Plane) -> Real {
        let mut term = 1.0;
        let mut sum = term;
        for n in 1..=TERMS {
            term *= -r.norm_squared() / (4.0 * (n * n) as Real);
            sum += term;
        }
        sum
    }
}
use series::bessel;

const TERMS: i32 = 1;

/// What `TERMS` is here is not what it is in `bessel`.
#[contact_hamiltonian(with(bessel), const TERMS = 1)]
fn wave(q: Vector2<f64>, p: Vector2<f64>, s: f64, gamma: f64) -> f64 {
    p.norm_squared() / f64::from(1 + TERMS) + bessel(&q) + gamma * s
}

#[energy_function]
fn short(x: f32) -> f32 {
    x.cos()
}

#[hamiltonian(with(short))]
fn single(q: f32, p: f32) -> f32 {
    p * p / 3.0 + short(q)
}

/// Energies that are parts of others; what damps the one does not damp the other.
#[energy_function]
#[hamiltonian]
fn spring(q: f64, p: f64, m: f64) -> f64 {
    p * p / (2.0 * m) + q.powi(4)
}

#[hamiltonian(damping = 0.1 * q * q)]
#[energy_function]
fn swing(q: f64, p: f64) -> f64 {
    p * p / 2.6 - q.cos()
}

#[hamiltonian(with(spring, swing))]
fn coupled(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
    spring(q[0], p[0], m) + swing(q[1], p[1]) + k * q[0] * q[1]
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-14 * a.abs().max(1.0), "{a} {b}");
}

#[test]
fn compiles_and_means_what_it_says() {
    // Items of a block.
    #[energy_function]
    fn local(x: f64) -> f64 {
        (0.3 * x).sin()
    }
    #[hamiltonian(with(local))]
    fn inside(q: f64, p: f64) -> f64 {
        p * p / 3.0 + local(q)
    }

    close(Above { k: 0.7 }.energy(&State::new(0.3, 0.5)), above(0.3, 0.5, 0.7));
    close(Both.energy(&State::new(0.3, 0.5)), both(0.3, 0.5));
    close(Inside.energy(&State::new(0.3, 0.5)), inside(0.3, 0.5));
    close(Spring { m: 0.7 }.energy(&State::new(0.3, 0.5)), spring(0.3, 0.5, 0.7));
    close(Swing.energy(&State::new(0.3, 0.5)), swing(0.3, 0.5));
    let (q, p) = ([0.3, 0.4], [0.5, -0.6]);
    close(Coupled { m: 0.7, k: 0.2 }.energy(&State::new(q, p)), coupled(q, p, 0.7, 0.2));
    Coupled { m: 0.7, k: 0.2 }.integrator(StormerVerlet, 0.1, State::new(q, p)).advance(10).unwrap();
    let (q, p) = (Vector2::new(0.3, -0.4), Vector2::new(0.5, 0.6));
    close(Wave { gamma: 0.3 }.energy(&ContactState::new(q, p, 0.7)), wave(q, p, 0.7, 0.3));
    assert!((Single.energy(&State::new(0.3, 0.5)) - single(0.3, 0.5)).abs() < 1e-6);

    let mut sim = Both.integrator(DiscreteGradient, 0.1, State::new(0.3, 0.5));
    let start = sim.energy();
    sim.advance(1000).unwrap();
    assert!((sim.energy() - start).abs() < 1e-13);
}
