//! Kepler orbits that almost hit the centre. Positions change by five orders of magnitude in one turn.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// Kepler's problem with a reduced mass.
#[hamiltonian]
fn comet(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - m / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// Returns the position after several turns from an apocentre, and the change of the energy.
macro_rules! end {
    ($method:expr, $momentum:expr) => {{
        let m = 1.3;
        let mut sim = Comet { m }.taylor($method, State::new([0.65, 0.0], [0.1 * m, $momentum * m]));
        let start = sim.energy();
        sim.advance_to(8.0).unwrap();
        (sim.state().q, (sim.energy() - start).abs())
    }};
}

/// A projection may choose a new origin at a pericentre, and leave an error there. It corrects this error later.
#[test]
fn a_projected_series_comes_back_to_its_energy() {
    for momentum in [0.01, 0.005, 0.002] {
        let taylor = Taylor { tolerance: 1e-13 };
        let (plain, _) = end!(taylor, momentum);
        let (projected, change) = end!(Projection(taylor, Energy), momentum);
        let apart = (projected[0] - plain[0]).hypot(projected[1] - plain[1]);
        // At a distance of 10⁻⁵ from the centre, the rounding of the energy is 10⁵ ε.
        assert!(change <= 2e-9, "{momentum}: {change:.1e}");
        assert!(apart <= 1e-7, "{momentum}: {apart:.1e}");
    }
}
