//! Lifts.
use super::*;

#[test]
fn p_vdp() {
    println!("{}\n{}\n{}\n{}", Thermostat::REPORT, Descent::REPORT, PendulumInBath::REPORT, VanDerPol::REPORT);
    for (eps, h, end) in [(5.0, 0.1, 100.0), (5.0, 0.05, 100.0), (50.0, 0.005, 500.0), (50.0, 0.02, 500.0), (100.0, 0.002, 900.0)] {
        let mut sim = VanDerPol { eps }.integrator(ContactSplitting, h, ContactState::new(2.0, 0.0, 0.0));
        let mut crossings = vec![];
        let mut amplitude = 0.0_f64;
        let mut before = sim.state();
        for x in sim.until(end) {
            let x = x.unwrap();
            if before.q < 0.0 && x.q >= 0.0 {
                crossings.push(before.t + h * before.q / (before.q - x.q));
            }
            if x.t > end / 2.0 { amplitude = amplitude.max(x.q.abs()); }
            before = x;
        }
        let n = crossings.len();
        println!("{eps} {h} {n} {} {} amp {amplitude}", (crossings[n - 1] - crossings[1]) / (n - 2) as f64, crossings[n-1]-crossings[n-2]);
    }
    let system = ForcedVanDerPol { eps: 5.0, a: 5.0, omega: 2.463 };
    for h in [0.02, 0.01, 0.005] {
        println!("{:?}", after(system, ContactSplitting, h, ContactState::new(2.0, 0.0, 2.0), 20.0).unwrap());
    }
    println!("{:?}", after(system, Suzuki4.of(ContactSplitting), 0.005, ContactState::new(2.0, 0.0, 2.0), 20.0).unwrap());
}

#[test]
fn p_descent() {
    let system = Descent { b: 0.2 };
    for h in [0.1, 1.0, 10.0, 100.0] {
        let mut sim = system.integrator(ContactSplitting, h, ContactState::new([1.5, 0.1], [0.0, 0.0], 0.0));
        let u = |q: [f64; 2]| (q[0] * q[0] + q[1] * q[1] - 1.0).powi(2) / 4.0 + 0.1 * q[0] * q[0];
        let mut x = sim.state();
        let mut grows = 0;
        for _ in 0..2000 {
            sim.step().unwrap();
            if u(sim.state().q) > u(x.q) { grows += 1; }
            x = sim.state();
        }
        println!("{h} {x:?} {} {grows}", u(x.q));
    }
}

#[test]
fn p_bath() {
    let system = PendulumInBath { gamma: 0.1 };
    let start = ContactState::new([2.5, 0.0, 1.0], [0.0; 3], 0.0);
    let e = |q: [f64; 3]| q[1] * q[1] / 2.0 - q[0].cos() + q[2];
    for h in [0.2, 0.1, 0.05] {
        let run = |order4: bool| {
        let (mut a, mut b) = (system.integrator(ContactSplitting, h, start), system.integrator(Suzuki4.of(ContactSplitting), h, start));
        let mut x = start;
        let (mut down, mut worst) = (0, 0.0_f64);
        for _ in 0..(50.0 / h) as usize {
            let y = if order4 { b.step().unwrap(); b.state() } else { a.step().unwrap(); a.state() };
            if y.q[2] < x.q[2] { down += 1 }
            x = y;
            worst = worst.max((e(x.q) - e(start.q)).abs());
        }
        println!("{h} {down} {worst:.2e} {:?}", x.q);
        };
        run(false);
        run(true);
    }
}
