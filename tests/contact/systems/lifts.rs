//! Flows of q, or of (q, s), that a contact system lifts.

use super::*;

/// The mean time between passages of q = 0 upwards, the first one left out, and the amplitude.
fn period(eps: f64, h: f64, end: f64) -> (f64, f64) {
    let mut sim = VanDerPol { eps }.integrator(ContactSplitting, h, ContactState::new(2.0, 0.0, 0.0));
    let states: Vec<ContactState<f64>> = sim.until(end).map(|x| x.unwrap()).collect();
    let upwards = states.windows(2).filter(|x| x[0].q < 0.0 && x[1].q >= 0.0);
    let times: Vec<f64> = upwards.map(|x| x[0].t + h * x[0].q / (x[0].q - x[1].q)).collect();
    let n = times.len();
    ((times[n - 1] - times[1]) / (n - 2) as f64, largest(states[states.len() / 2..].iter().map(|x| x.q)))
}

/// Periods of the limit cycle: 11.6122 and 82.5083.
#[test]
fn stiff_oscillations_have_their_period() {
    let (mild, _) = period(5.0, 0.05, 100.0);
    assert!((mild - 11.6101).abs() < 5e-4, "{mild}");
    let (stiff, amplitude) = period(50.0, 0.005, 500.0);
    assert!((stiff - 82.5083).abs() < 2e-4, "{stiff}");
    assert!((amplitude - 2.003).abs() < 1e-3, "{amplitude}");
    // At hε = 1 stable, and late.
    let (long, amplitude) = period(50.0, 0.02, 800.0);
    assert!(amplitude < 2.25 && (long - 82.5083).abs() < 15.0, "{long} {amplitude}");
}

#[test]
fn lifts_are_of_the_order_of_the_method() {
    let forced = ForcedVanDerPol { eps: 5.0, a: 5.0, omega: 2.463 };
    let start = ContactState::new(2.0, 0.0, 2.0);
    // The base alone: p does not act on it.
    let field = |t: f64, x: &[f64]| vec![x[1], 5.0 * (1.0 - x[0] * x[0]) * x[1] - x[0] + 5.0 * f64::cos(2.463 * t)];
    let truth = extrapolated(field, 0.0, vec![2.0, 2.0], 20.0, 400);
    let off = |x: Vec<f64>| gap(&[x[0], x[2]], &truth);
    let two = [0.01, 0.005].map(|h| off(after(forced, ContactSplitting, h, start, 20.0)));
    assert!(two[1] < 1e-4 && (order(two) - 2.0).abs() < 0.1, "{two:?}");
    let four = [0.01, 0.005].map(|h| off(after(forced, Suzuki4.of(ContactSplitting), h, start, 20.0)));
    assert!(four[1] < 1e-6 && (order(four) - 4.0).abs() < 0.2, "{four:?}");
}

#[test]
fn forced_oscillations_stay_bounded() {
    let system = ForcedVanDerPol { eps: 5.0, a: 5.0, omega: 2.463 };
    let mut sim = system.integrator(ContactSplitting, 0.02, ContactState::new(2.0, 0.0, 2.0));
    assert!(sim.until(500.0).all(|x| x.is_ok_and(|x| x.q.abs() < 2.5 && x.s.abs() < 12.0)));
}

#[test]
fn every_step_of_a_descent_leads_downhill() {
    let system = Descent { b: 0.3 };
    let height = |[x, y]: [f64; 2]| (x * x + y * y - 1.0).powi(2) / 4.0 + system.b * x * x / 2.0;
    for h in [0.1, 1.0, 10.0, 100.0] {
        for start in [[1.6, 0.2], [-0.1, 0.05], [0.9, -1.4]] {
            let mut sim = system.integrator(ContactSplitting, h, ContactState::new(start, [0.0; 2], 0.0));
            let mut before = height(start);
            for _ in 0..2000 {
                sim.step().unwrap();
                let now = height(sim.state().q);
                assert!(now <= before + 1e-15, "h = {h}: {before} {now}");
                before = now;
            }
            assert!(before < 1e-15 && sim.state().q[1].abs() > 0.999, "h = {h}: {before}");
        }
    }
}

/// The pieces exchange energy, so E = v²/2 − cos q + heat is conserved to the order of the method. Heat, and with it entropy, never falls.
#[test]
fn a_heat_bath_takes_the_energy_that_friction_takes() {
    let system = PendulumInBath { gamma: 0.1 };
    let start = ContactState::new([2.5, 0.0, 1.0], [0.0; 3], 0.0);
    let total = |[q, v, heat]: [f64; 3]| v * v / 2.0 - q.cos() + heat;
    let drift = |states: &[[f64; 3]]| largest(states.iter().map(|x| total(*x) - total(start.q)));
    let two = [0.1, 0.05].map(|h| {
        let mut sim = system.integrator(ContactSplitting, h, start);
        let states: Vec<[f64; 3]> = sim.until(50.0).map(|x| x.unwrap().q).collect();
        assert!(states.windows(2).all(|x| x[1][2] >= x[0][2]), "h = {h}: heat falls");
        drift(&states)
    });
    assert!(two[1] < 1e-3 && (order(two) - 2.0).abs() < 0.05, "{two:?}");
    let four = [0.1, 0.05].map(|h| {
        let mut sim = system.integrator(Suzuki4.of(ContactSplitting), h, start);
        drift(&sim.until(50.0).map(|x| x.unwrap().q).collect::<Vec<_>>())
    });
    assert!(four[1] < 1e-7 && (order(four) - 4.0).abs() < 0.1, "{four:?}");
}
