//! S48: the equations of a neuron (A. L. Hodgkin & A. F. Huxley, J. Physiol. 117 (1952) 500). Each one is linear in its own variable. A lift therefore
//! splits into exact flows of the voltage and of the gates (Z. Chen, B. Raman & A. Stern, SIAM J. Sci. Comput. 42 (2020) B273).

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::measure::extrapolated;

/// Voltage v and gates m, h, n as H = p·X(q). Units: mV, ms, μA/cm².
#[contact_hamiltonian(lift)]
fn neuron(q: [f64; 4], p: [f64; 4], s: f64, current: f64) -> f64 {
    let [v, m, h, n] = q;
    let sodium = 120.0 * m.powi(3) * h * (v - 50.0);
    let potassium = 36.0 * n.powi(4) * (v + 77.0);
    let opening = [
        (v + 40.0) / (10.0 - 10.0 * (-(v + 40.0) / 10.0).exp()),
        0.07 * (-(v + 65.0) / 20.0).exp(),
        (v + 55.0) / (100.0 - 100.0 * (-(v + 55.0) / 10.0).exp()),
    ];
    let closing = [
        4.0 * (-(v + 65.0) / 18.0).exp(),
        1.0 / (1.0 + (-(v + 35.0) / 10.0).exp()),
        0.125 * (-(v + 65.0) / 80.0).exp(),
    ];
    let gate = |i: usize| p[i + 1] * (opening[i] * (1.0 - q[i + 1]) - closing[i] * q[i + 1]);
    p[0] * (current - sodium - potassium - 0.3 * (v + 54.4)) + gate(0) + gate(1) + gate(2) + 0.0 * s
}

const SYSTEM: Neuron = Neuron { current: 10.0 };

/// The neuron at rest.
const REST: [f64; 4] = [-65.0, 0.053, 0.596, 0.3177];

/// X(q), written anew.
fn rates(x: &[f64]) -> [f64; 4] {
    let (v, [m, h, n]) = (x[0], [x[1], x[2], x[3]]);
    let ions = 120.0 * m * m * m * h * (50.0 - v) + 36.0 * n * n * n * n * (-77.0 - v) + 0.3 * (-54.4 - v);
    let m_opens = 0.1 * (v + 40.0) / -f64::exp_m1(-(v + 40.0) / 10.0);
    let n_opens = 0.01 * (v + 55.0) / -f64::exp_m1(-(v + 55.0) / 10.0);
    let h_closes = 1.0 / (1.0 + f64::exp(-(v + 35.0) / 10.0));
    [
        SYSTEM.current + ions,
        m_opens * (1.0 - m) - 4.0 * f64::exp(-(v + 65.0) / 18.0) * m,
        0.07 * f64::exp(-(v + 65.0) / 20.0) * (1.0 - h) - h_closes * h,
        n_opens * (1.0 - n) - 0.125 * f64::exp(-(v + 65.0) / 80.0) * n,
    ]
}

fn states(h: f64, steps: u64) -> Result<Vec<[f64; 4]>, StepError> {
    let mut sim = SYSTEM.integrator(ContactSplitting, h, ContactState::new(REST, [0.0; 4], 0.0));
    (0..steps).map(|_| sim.step().map(|()| sim.state().q)).collect()
}

/// One spike, which reaches 40 mV.
#[test]
fn a_spike_is_of_order_two() -> Result<(), StepError> {
    let exact = extrapolated(|_, x| rates(x).to_vec(), 0.0, REST.to_vec(), 6.0, 200);
    let mut errors = [0.0; 3];
    for (error, steps) in errors.iter_mut().zip([600, 1200, 2400]) {
        let states = states(6.0 / steps as f64, steps)?;
        let peak = states.iter().map(|x| x[0]).fold(f64::NEG_INFINITY, f64::max);
        assert!(peak > 39.0 && peak < 42.0, "{peak}");
        *error = (states[states.len() - 1][0] - exact[0]).abs();
    }
    assert!(errors[2] < 1e-4 && errors.windows(2).all(|two| (two[0] / two[1] - 4.0).abs() < 0.1), "{errors:?}");
    Ok(())
}

/// Opening probabilities stay in [0, 1] at steps at which those of explicit Euler do not.
#[test]
fn gates_stay_probabilities() -> Result<(), StepError> {
    let probable = |x: &[f64; 4]| x[1..].iter().all(|gate| (0.0..=1.0).contains(gate));
    for h in [0.1, 0.5, 2.0] {
        let states = states(h, 400)?;
        assert!(states.iter().all(|x| probable(x) && x[0] > -77.0 && x[0] < 50.0), "h = {h}");
    }
    let mut x = REST;
    let euler = (0..400).map(|_| {
        let rates = rates(&x);
        x = [0, 1, 2, 3].map(|i| x[i] + 0.5 * rates[i]);
        x
    });
    assert!(!euler.take(20).all(|x| probable(&x)));
    Ok(())
}
