//! Runs of generated steppers. Parameters and step sizes are hidden from the optimiser.

use crate::paired::Run;
use geoint_runtime::method::Method;
use geoint_runtime::prelude::*;
use geoint_runtime::space::{Array, Coordinates};
use std::hint::black_box;

/// Returns the state with coordinates (q₀, q₁, p₀, p₁).
pub(crate) fn plane([q0, q1, p0, p1]: [f64; 4]) -> State<[f64; 2]> {
    State::new([q0, q1], [p0, p1])
}

/// Returns a run of a Hamiltonian system.
pub(crate) fn generated<S, M>(system: S, method: M, h: f64, start: State<S::Coordinates>) -> Run
where
    S: Hamiltonian + 'static,
    S::Coordinates: 'static,
    M: Method<S, f64> + 'static,
{
    Box::new(move |n| {
        let mut sim = Integrator::new(black_box(system), method, black_box(h), start);
        sim.advance(n).expect("a regular problem");
        let State { q, p, .. } = sim.state();
        [q, p].iter().flat_map(|x| x.into_array().as_slice().to_vec()).collect()
    })
}

/// Returns a run of a contact system in the plane.
pub(crate) fn contact_run<S, M>(system: S, method: M, h: f64, start: ContactState<[f64; 2]>) -> Run
where
    S: PhaseSpace<State = ContactState<[f64; 2]>, Phase = [[f64; 2]; 2], Action = f64> + 'static,
    M: Method<S> + 'static,
{
    Box::new(move |steps| {
        let mut sim = Integrator::new(system, black_box(method), black_box(h), black_box(start));
        sim.advance(black_box(steps)).unwrap();
        let ContactState { q, p, s, .. } = sim.state();
        vec![q[0], q[1], p[0], p[1], s]
    })
}

/// Returns a run of a vector field.
pub(crate) fn flow<S, M, const N: usize>(system: S, method: M, h: f64, start: [f64; N]) -> Run
where
    S: PhaseSpace<State = FlowState<[f64; N]>> + 'static,
    M: Method<S> + 'static,
{
    Box::new(move |n| {
        let mut sim = Integrator::new(black_box(system), method, black_box(h), FlowState::new(start));
        sim.advance(n).expect("a regular problem");
        sim.state().x.to_vec()
    })
}
