//! Oscillators whose solution is known, and those with an invariant set.

use super::*;

/// q'' + γ q' + q = 0 from (q, p), by the roots of the characteristic polynomial where they are complex.
fn exact([q, p]: [f64; 2], gamma: f64, t: f64) -> [f64; 2] {
    let omega = (1.0 - gamma * gamma / 4.0).sqrt();
    let (sin, cos) = (omega * t).sin_cos();
    let decay = (-gamma * t / 2.0).exp();
    let b = (p + gamma * q / 2.0) / omega;
    let position = decay * (q * cos + b * sin);
    [position, decay * omega * (b * cos - q * sin) - gamma / 2.0 * position]
}

#[test]
fn p_damped() {
    for gamma in [0.01, 0.1, 1.0, 2.0] {
        for h in [0.1, 0.05] {
            let steps = if gamma > 0.5 { 15.0 } else { 50.0 } / h;
            let start = ContactState::new(-0.25, 0.75, 0.0);
            let mut one = DampedOscillator { gamma }.integrator(ContactSplitting, h, start);
            let mut three = ThreePieces { gamma }.integrator(ContactSplitting, h, start);
            let mut e = [0.0_f64; 2];
            for n in 1..=steps as usize {
                one.step().unwrap();
                three.step().unwrap();
                let x = exact([-0.25, 0.75], gamma, n as f64 * h)[0];
                e[0] = e[0].max((one.state().q - x).abs());
                e[1] = e[1].max((three.state().q - x).abs());
            }
            println!("{gamma} {h} {e:?}");
        }
    }
}

#[test]
fn p_driven() {
    let (beta, omega) = (0.3, core::f64::consts::PI / 3.0);
    for gamma in [0.01, 0.1, 1.0, 2.0_f64] {
        let amplitude = -beta / ((gamma * omega).powi(2) + (1.0 - omega * omega).powi(2)).sqrt();
        let phase = (gamma * omega).atan2(omega * omega - 1.0);
        let x = |t: f64| amplitude * (omega * t + phase).sin();
        let start = ContactState::new(x(0.0), amplitude * omega * phase.cos(), 0.0);
        for h in [0.1, 0.05] {
            let mut sim = Driven { gamma, beta, omega }.integrator(ContactSplitting, h, start);
            let mut sim4 = Driven { gamma, beta, omega }.integrator(Suzuki4.of(ContactSplitting), h, start);
            let mut e = [0.0_f64; 2];
            for n in 1..=(50.0 / h) as usize {
                sim.step().unwrap();
                sim4.step().unwrap();
                e[0] = e[0].max((sim.state().q - x(n as f64 * h)).abs());
                e[1] = e[1].max((sim4.state().q - x(n as f64 * h)).abs());
            }
            println!("{gamma} {h} {e:?}");
        }
    }
}

#[test]
fn p_cosmo() {
    let system = Cosmological { r: 1.0 };
    for h in [0.2, 0.1, 0.05] {
        for (q, p) in [(1.0, 0.5), (0.3, 1.2), (1.0, 0.0)] {
        let s = -(2.0 - q * q - p * p as f64).sqrt();
        let mut sim = system.integrator(ContactSplitting, h, ContactState::new(q, p, s));
        let mut largest = 0.0_f64;
        for x in sim.until(20.0) {
            let x = x.unwrap();
            largest = largest.max(system.energy(&x).abs());
        }
        println!("{h} {largest:.3e} {:?}", sim.state());
        }
    }
    let mut sim = system.integrator(ContactSplitting, 0.1, ContactState::new(0.0, 0.0, -1.0));
    sim.advance(200).unwrap();
    println!("{:?}", sim.state());
}

#[test]
fn p_quadratic() {
    for a in [0.1, 1.5] {
        let system = QuadraticDissipation { a };
        let start = ContactState::new(0.5, 0.5, -0.2);
        let truth = solution(&system, &start, 50.0, 400);
        for h in [0.2, 0.1, 0.05] {
            println!("{a} {h} {:?} {:?}", after(system, ContactSplitting, h, start, 50.0).map(|x| gap(&x, &truth)),
             after(system, Suzuki4.of(ContactSplitting), h, start, 50.0).map(|x| gap(&x, &truth)));
        }
    }
}
