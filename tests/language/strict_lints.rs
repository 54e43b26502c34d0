//! Generated code is quiet in a crate that forbids what it can.
#![deny(
    warnings,
    missing_docs,
    missing_debug_implementations,
    missing_copy_implementations,
    rust_2018_idioms,
    unreachable_pub,
    unused,
    unused_qualifications,
    unused_lifetimes,
    unused_results,
    trivial_casts,
    trivial_numeric_casts,
    single_use_lifetimes,
    let_underscore_drop,
    unsafe_code,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
// These would have the energies themselves written otherwise.
#![allow(
    clippy::many_single_char_names,
    clippy::must_use_candidate,
    clippy::suboptimal_flops,
    clippy::imprecise_flops,
    clippy::default_constructed_unit_structs
)]

/// Everything is public, everything has a doc.
pub mod model {
    use geoint_runtime::methods::*;
    use geoint_runtime::prelude::*;

    /// Two coupled rods.
    #[hamiltonian]
    pub fn rods(q: [f64; 2], p: [f64; 2], m: [f64; 2], t: f64) -> f64 {
        let s = (q[0] - q[1]).sin();
        p[0] * p[0] / m[0] + p[1] * p[1] / (m[1] * (1.0 + s * s)) - (1.0 + t) * q[0].cos() - q[1].cos().max(0.5)
    }

    /// A branch and a domain.
    #[hamiltonian]
    pub fn wall(q: f64, p: f64) -> f64 {
        let push = if q < 0.0 { q * q } else { (1.0 + q).ln() };
        0.5 * p * p + push + (1.0 - p * p).sqrt()
    }

    /// A parameter that damping alone reads.
    #[hamiltonian(damping = [[c[0], 0.0], [0.0, c[1] * t * t]])]
    pub fn damped(q: [f64; 2], p: [f64; 2], t: f64, c: [f64; 2]) -> f64 {
        p[0] * p[0] + p[1] * p[1] + q[0] * q[0] * q[1] * q[1]
    }

    const N: usize = 20;

    /// Long enough for loops.
    #[hamiltonian(const N = 20)]
    pub fn row(q: [[f64; 2]; N], p: [[f64; 2]; N], i: [f64; N], array0: f64) -> f64 {
        let mut energy = 0.0;
        for k in 0..N {
            let [x, y] = [q[k][0] - q[(k + 1) % N][0], q[k][1]];
            let motion = (p[k][0] * p[k][0] + p[k][1] * p[k][1]) / i[k];
            energy += motion - array0 * x.cos() * y.sin() + (x * x + y * y).sqrt();
        }
        energy
    }

    /// One step of each.
    ///
    /// # Errors
    /// As the integrators say.
    pub fn steps() -> Result<(), StepError> {
        let rods = Rods { m: [1.0, 2.0] };
        rods.integrator(Gauss::<2>::default(), 0.01, State::new([0.1, 0.2], [0.3, 0.4])).advance(3)?;
        Damped { c: [0.1, 0.2] }.integrator(DiscreteGradient, 0.01, State::new([0.1, 0.2], [0.3, 0.4])).advance(3)?;
        let row = Row { i: [1.3; 20], array0: 0.7 };
        row.integrator(DiscreteGradient, 0.01, State::new([[0.1, 1.0]; 20], [[0.2, 0.3]; 20])).advance(3)?;
        Wall.integrator(PositionVerlet, 0.01, State::new(0.1, 0.2)).advance(3)
    }
}

#[test]
fn compiles_and_means_what_it_says() {
    model::steps().expect("a step");
}
