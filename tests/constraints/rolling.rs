//! Constraints of velocities: errors, laws and controls. References are closed forms, and states by an extrapolation method with 22 digits. First errors such
//! as 4.58e-4 are those of another program.

use crate::systems::orders;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// A particle whose height changes with its path: z' = y x'.
#[hamiltonian(rolling = [v[2] - q[1] * v[0]])]
fn particle(q: [f64; 3], p: [f64; 3], k: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 2.0 + k * (q[0] * q[0] + q[1] * q[1]) / 2.0
}

/// Chaplygin's sleigh: centre of mass and heading; a is the distance from the blade to the centre of mass.
#[lagrangian(rolling = [v[1] * q[2].cos() - v[0] * q[2].sin() - a * v[2]])]
fn sleigh(q: [f64; 3], v: [f64; 3], m: f64, i: f64, a: f64) -> f64 {
    m * (v[0] * v[0] + v[1] * v[1]) / 2.0 + i * v[2] * v[2] / 2.0
}

/// The same sleigh with the point of contact as coordinates: a mass matrix that depends on the heading.
#[lagrangian(rolling = [v[1] * q[2].cos() - v[0] * q[2].sin()])]
fn sleigh_by_contact(q: [f64; 3], v: [f64; 3], m: f64, i: f64, a: f64) -> f64 {
    let (x, y) = (v[0] - a * v[2] * q[2].sin(), v[1] + a * v[2] * q[2].cos());
    m * (x * x + y * y) / 2.0 + i * v[2] * v[2] / 2.0
}

/// A vertical disk on a slope: x, y, roll, heading.
#[lagrangian(rolling = [v[0] - r * v[2] * q[3].cos(), v[1] - r * v[2] * q[3].sin()])]
fn disk(q: [f64; 4], v: [f64; 4], m: f64, r: f64, i: f64, j: f64, g: f64) -> f64 {
    m * (v[0] * v[0] + v[1] * v[1]) / 2.0 + i * v[2] * v[2] / 2.0 + j * v[3] * v[3] / 2.0 + m * g * q[0]
}

/// A ball on a table that turns: its centre, and three numbers whose rates are its angular velocity.
#[lagrangian(rolling = [v[0] - r * v[3] + omega * q[1], v[1] + r * v[2] - omega * q[0]])]
fn ball(q: [f64; 5], v: [f64; 5], m: f64, r: f64, omega: f64) -> f64 {
    let i = 0.4 * m * r * r;
    m * (v[0] * v[0] + v[1] * v[1]) / 2.0 + i * (v[2] * v[2] + v[3] * v[3] + v[4] * v[4]) / 2.0
}

/// Two oscillators and a gearbox between them, whose ratio depends on a pendulum.
#[hamiltonian(rolling = [v[0] + (0.8 * q[2].sin() + 0.4 * (2.0 * q[2]).cos()) * v[1]])]
fn gearbox(q: [f64; 3], p: [f64; 3], c: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 2.0 + (q[0] * q[0] + q[1] * q[1]) / 2.0 - q[2].cos()
        + c * (2.0 * q[2]).sin()
}

const SLEIGH: Sleigh = Sleigh { m: 1.3, i: 0.4, a: 0.5 };

/// The start of the sleigh: −0.6 along the blade, ω = 0.9, heading 0.2 and the point of contact (0, 0).
fn start_of_sleigh() -> State<[f64; 3]> {
    let (sin, cos) = 0.2_f64.sin_cos();
    SLEIGH.at([0.5 * cos, 0.5 * sin, 0.2], [-0.6 * cos - 0.45 * sin, -0.6 * sin + 0.45 * cos, 0.9])
}

/// The speed along the blade, and ω.
fn along(State { q, p, .. }: &State<[f64; 3]>) -> [f64; 2] {
    let (sin, cos) = q[2].sin_cos();
    [(p[0] * cos + p[1] * sin) / 1.3, p[2] / 0.4]
}

fn far<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.iter().zip(b).fold(0.0, |far, (a, b)| f64::max(far, (a - b).abs()))
}

fn ended<S, M, const N: usize>(system: S, method: M, h: f64, start: State<[f64; N]>, time: f64) -> State<[f64; N]>
where
    S: geoint_runtime::Constrained<Coordinates = [f64; N], Array = [f64; N], State = State<[f64; N]>>,
    M: Method<S>,
{
    crate::systems::run(system, method, h, start, time).state()
}

fn has_order(order: f64, errors: &[f64]) {
    assert!(orders(errors).iter().all(|found| (found - order).abs() < 0.15), "{errors:?}");
}

#[test]
fn a_particle_with_a_height() {
    // Free: y = y₀ + bt, x = (a/b)(asinh y − asinh y₀), z = (a/b)(√(1 + y²) − √(1 + y₀²)).
    let (a, b, y0, t) = (1.0, 0.8, 0.3_f64, 5.0);
    let y = y0 + b * t;
    let root = |y: f64| (1.0 + y * y).sqrt();
    let exact = [a / b * (y.asinh() - y0.asinh()), y, a / b * (root(y) - root(y0))];
    let speed = a / root(y0);
    let start = State::new([0.0, y0, 0.0], [speed, b, y0 * speed]);
    let errors = [0.1, 0.05, 0.025].map(|h| far(ended(Particle { k: 0.0 }, DiscreteGradient, h, start, t).q, exact));
    has_order(2.0, &errors);
    assert!((errors[0] / 4.58e-4 - 1.0).abs() < 0.02, "{errors:?}");
    // With a spring.
    let start = State::new([1.0, 0.5, 0.0], [0.3, 0.8, 0.15]);
    let exact = [-0.844_888_237_998_635_5, -0.625_308_326_998_897_6, -0.499_996_784_534_301_03];
    let velocity = [0.535_350_523_719_687, 0.706_391_885_702_150_3];
    let at_end = |h: f64| ended(Particle { k: 1.0 }, DiscreteGradient, h, start, 5.0);
    let errors = [0.1, 0.05, 0.025].map(|h| far(at_end(h).q, exact));
    has_order(2.0, &errors);
    assert!((errors[0] / 2.93e-3 - 1.0).abs() < 0.02, "{errors:?}");
    let errors = [0.1, 0.05, 0.025].map(|h| far([at_end(h).p[0], at_end(h).p[1]], velocity));
    has_order(2.0, &errors);
    let fourth = |h: f64| ended(Particle { k: 1.0 }, Suzuki4.of(DiscreteGradient), h, start, 5.0);
    let errors = [0.1, 0.05, 0.025].map(|h| far(fourth(h).q, exact));
    has_order(4.0, &errors);
    assert!((errors[0] / 4.96e-7 - 1.0).abs() < 0.05, "{errors:?}");
    let errors = [0.1, 0.05, 0.025].map(|h| far([fourth(h).p[0], fourth(h).p[1]], velocity));
    has_order(4.0, &errors);
}

#[test]
fn a_sleigh_turns_round() -> Result<(), StepError> {
    let exact = [-3.629_773_253_476_449_5, -0.327_433_045_197_489_87, 3.582_185_253_001_450_4];
    let contact = |State { q, .. }: State<[f64; 3]>| [q[0] - 0.5 * q[2].cos(), q[1] - 0.5 * q[2].sin(), q[2]];
    let errors =
        [0.1, 0.05, 0.025].map(|h| far(contact(ended(SLEIGH, DiscreteGradient, h, start_of_sleigh(), 6.0)), exact));
    has_order(2.0, &errors);
    let mut sim = SLEIGH.integrator(DiscreteGradient, 0.1, start_of_sleigh());
    let energy = sim.energy();
    for _ in 0..200 {
        sim.step()?;
        assert!((sim.energy() - energy).abs() < 1e-13);
        let State { q, p, .. } = sim.state();
        let rate = (p[1] * q[2].cos() - p[0] * q[2].sin()) / 1.3 - 0.5 * p[2] / 0.4;
        assert!(rate.abs() < 5e-15, "{rate:e}");
    }
    let [speed, turning] = along(&sim.state());
    assert!((speed - 0.9010).abs() < 1e-4 && (turning / 5.152e-7 - 1.0).abs() < 1e-3, "{speed} {turning:e}");
    sim.advance(800)?;
    let [speed, turning] = along(&sim.state());
    assert!((speed - 0.900_961_025_367_229_3).abs() < 1e-13 && turning.abs() < 1e-13);
    // A run back in time returns to the start.
    let mut back =
        SLEIGH.integrator(DiscreteGradient, -0.1, ended(SLEIGH, DiscreteGradient, 0.1, start_of_sleigh(), 6.0));
    back.advance(60)?;
    assert!(far(back.state().q, start_of_sleigh().q) < 1e-12);
    Ok(())
}

#[test]
fn a_mass_matrix_that_turns() {
    let system = SleighByContact { m: 1.3, i: 0.4, a: 0.5 };
    let (sin, cos) = 0.2_f64.sin_cos();
    let start = system.at([0.0, 0.0, 0.2], [-0.6 * cos, -0.6 * sin, 0.9]);
    let exact = [-3.629_773_253_476_449_5, -0.327_433_045_197_489_87, 3.582_185_253_001_450_4];
    let errors = [0.2, 0.1, 0.05].map(|h| far(ended(system, DiscreteGradient, h, start, 6.0).q, exact));
    has_order(2.0, &errors);
    assert!((errors[0] / 3.87e-2 - 1.0).abs() < 0.05, "{errors:?}");
    let errors = [0.2, 0.1, 0.05].map(|h| far(ended(system, Suzuki4.of(DiscreteGradient), h, start, 6.0).q, exact));
    has_order(4.0, &errors);
    assert!((errors[0] / 2.79e-5 - 1.0).abs() < 0.05, "{errors:?}");
}

#[test]
fn a_disk_does_not_run_down_its_slope() {
    let (m, r, i, j, g) = (1.2, 0.5, 0.2, 0.1, 3.0);
    let (heading, turning, rolling, t) = (0.4_f64, 0.7, 1.1, 8.0);
    let k = m * g * r / (i + m * r * r);
    let system = Disk { m, r, i, j, g };
    let start = system
        .at([0.0, 0.0, 0.0, heading], [r * rolling * heading.cos(), r * rolling * heading.sin(), rolling, turning]);
    // φ' = A + B sin θ with θ = heading + turning·t; x' = rφ' cos θ, y' = rφ' sin θ.
    let (a, b) = (rolling - k / turning * heading.sin(), k / turning);
    let angle = heading + turning * t;
    let x = |th: f64| r / turning * (a * th.sin() + b * th.sin().powi(2) / 2.0);
    let y = |th: f64| r / turning * (-a * th.cos() + b * (th / 2.0 - (2.0 * th).sin() / 4.0));
    let roll = |th: f64| (a * th - b * th.cos()) / turning;
    let exact = [x(angle) - x(heading), y(angle) - y(heading), roll(angle) - roll(heading), angle];
    let errors = [0.1, 0.05, 0.025].map(|h| far(ended(system, DiscreteGradient, h, start, t).q, exact));
    has_order(2.0, &errors);
    assert!((errors[0] / 1.21e-2 - 1.0).abs() < 0.02, "{errors:?}");
    assert_eq!(ended(system, DiscreteGradient, 0.1, start, t).p[3], start.p[3]);
}

#[test]
fn a_ball_on_a_table_runs_in_circles() -> Result<(), StepError> {
    let (m, r, omega) = (1.0, 0.3, 1.5);
    let system = Ball { m, r, omega };
    let ([x, y], [u, w]) = ([0.5, 0.2], [0.3, -0.1]);
    let spin = [(omega * x - w) / r, (u + omega * y) / r, 0.4];
    let start = system.at([x, y, 0.0, 0.0, 0.0], [u, w, spin[0], spin[1], spin[2]]);
    // Circles with 2Ω/7 about the point where the velocity vanishes.
    let rate = 2.0 * omega / 7.0;
    let centre = [x - w / rate, y + u / rate];
    let at = |t: f64| {
        let (sin, cos) = (rate * t).sin_cos();
        let (a, b) = (x - centre[0], y - centre[1]);
        [centre[0] + a * cos - b * sin, centre[1] + a * sin + b * cos]
    };
    let place = |h: f64| {
        let State { q, .. } = ended(system, DiscreteGradient, h, start, 10.0);
        [q[0], q[1]]
    };
    let errors = [0.1, 0.05, 0.025].map(|h| far(place(h), at(10.0)));
    has_order(2.0, &errors);
    // The table does work: the energy changes, and the energy less Ω times an angular momentum is constant.
    let law = |state: &State<[f64; 5]>| {
        let State { q, p, .. } = state;
        system.energy(state) - omega * (q[0] * p[1] - q[1] * p[0] + p[4])
    };
    let mut sim = system.integrator(DiscreteGradient, 0.1, start);
    let (energy, constant) = (sim.energy(), law(&start));
    let mut changed = 0.0_f64;
    for _ in 0..300 {
        sim.step()?;
        assert!((law(&sim.state()) - constant).abs() < 2e-14);
        changed = changed.max((sim.energy() - energy).abs());
    }
    assert!(changed > 1e-2, "the table does no work: {changed:e}");
    Ok(())
}

/// The mean energy in each fifth of a run, less the energy at its start.
fn drift(mut next: impl FnMut() -> f64, start: f64) -> [f64; 5] {
    core::array::from_fn(|_| (0..800).map(|_| next() - start).sum::<f64>() / 800.0)
}

/// On the gearbox some methods lose energy steadily, which a mean over time shows.
#[test]
fn a_gearbox_keeps_its_energy() -> Result<(), StepError> {
    let start = State::new([1.0, 0.3, 0.0], [-0.24, 0.6, 2.5]);
    let exact = [0.736_342_850_715_262_5, -0.978_089_368_246_935_6, 9.705_889_963_398_56];
    let errors = [0.1, 0.05, 0.025].map(|h| far(ended(Gearbox { c: 0.5 }, DiscreteGradient, h, start, 5.0).q, exact));
    has_order(2.0, &errors);
    assert!((errors[0] / 6.02e-3 - 1.0).abs() < 0.02, "{errors:?}");
    let mut sim = Gearbox { c: 0.5 }.integrator(DiscreteGradient, 0.1, start);
    let energy = sim.energy();
    let mut failed = None;
    let means = drift(
        || {
            failed = failed.take().or(sim.step().err());
            sim.energy()
        },
        energy,
    );
    assert!(failed.is_none() && means.iter().all(|mean| mean.abs() < 1e-11), "{means:?}");
    // The discrete Lagrange–d'Alembert principle with (A₀ + A₁)(q₁ − q₀) = 0 drifts, where A₀ and A₁ are the rows at both ends (Cortés & Martínez 2001).
    let mut control = control::Lagrange::new([1.0, 0.3, 0.0], [-0.24, 0.6, 2.5], 0.1);
    let means = drift(|| control.step(), energy);
    assert!(means.windows(2).all(|pair| pair[1] < pair[0] - 0.01), "{means:?}");
    Ok(())
}

/// Nonholonomic RATTLE keeps a volume, so the turning of the sleigh cannot die out: it turns back (McLachlan & Perlmutter 2006).
#[test]
fn a_volume_is_wrong_for_the_sleigh() {
    let speed = control::rattle(&start_of_sleigh(), 0.1, 200);
    assert!((speed + 0.8996).abs() < 1e-3, "{speed}");
}

/// Multipliers of a state: explicit methods use them, and they are the force of the blade across its direction.
#[test]
fn multipliers_are_forces() -> Result<(), StepError> {
    let exact = [-3.629_773_253_476_449_5, -0.327_433_045_197_489_87];
    let contact = |State { q, .. }: State<[f64; 3]>| [q[0] - 0.5 * q[2].cos(), q[1] - 0.5 * q[2].sin()];
    let mut sim = SLEIGH.integrator(RK4, 0.01, start_of_sleigh());
    sim.advance(600)?;
    assert!(far(contact(sim.state()), exact) < 1e-7);
    let mut sim = SLEIGH.adaptive(DOP853, 1e-12, start_of_sleigh());
    sim.advance_to(6.0)?;
    assert!(far(contact(sim.state()), exact) < 1e-10);
    // ω' = −(ma/J) v ω with J = I + ma² is the moment −aμ of the blade over I, so μ = I m v ω/J.
    let [speed, turning] = along(&sim.state());
    let expected = 0.4 * (1.3 * 0.5 / (0.4 + 1.3 * 0.25)) * speed * turning / 0.5;
    assert!((sim.multipliers()[0] - expected).abs() < 1e-10, "{} {expected}", sim.multipliers()[0]);
    Ok(())
}

/// A robot with two driven wheels: x, y, heading, and the angles of the right and the left wheel, at a distance b of the middle.
#[lagrangian(rolling = [
    v[1] * q[2].cos() - v[0] * q[2].sin(),
    v[0] * q[2].cos() + v[1] * q[2].sin() + b * v[2] - r * v[3],
    v[0] * q[2].cos() + v[1] * q[2].sin() - b * v[2] - r * v[4]
])]
fn robot(q: [f64; 5], v: [f64; 5], m: f64, i: f64, j: f64, b: f64, r: f64) -> f64 {
    m * (v[0] * v[0] + v[1] * v[1]) / 2.0 + i * v[2] * v[2] / 2.0 + j * (v[3] * v[3] + v[4] * v[4]) / 2.0
}

/// A row that keeps the angle of (x, y).
#[hamiltonian(rolling = [q[0] * v[1] - q[1] * v[0]])]
fn turned(q: [f64; 3], p: [f64; 3], m: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m)
}

#[test]
fn reports_say_what_is_bound() {
    let report = Sleigh::<f64>::REPORT;
    assert!(report.contains("velocities are bound, positions are not") && report.contains("volume"), "{report}");
    assert!(report.contains("- the energy\n"), "{report}");
    // The wheels turn by angles whose difference is that of the heading.
    let report = Robot::<f64>::REPORT;
    let turn = "row 1 − 1·row 2 is the rate of a function of positions: ";
    let rest = report.split(turn).nth(1).expect(report);
    assert!(rest.lines().next().is_some_and(|line| line.ends_with("stays constant")), "{report}");
    // A row that is the rate of an angle but for a factor: no claim is made.
    let report = Turned::<f64>::REPORT;
    assert!(report.contains("whether it binds positions is not known"), "{report}");
    let report = Ball::<f64>::REPORT;
    assert!(report.contains("no combination of two rows with constant factors"), "{report}");
    assert!(
        report.contains("the energy changes at the rate −μ[0]·(q[1]·omega)") && report.contains("- p[4]: no row binds"),
        "{report}"
    );
    assert!(!report.contains("- the energy\n"), "{report}");
}

/// A start that slips is refused with the name of its row, and `state_on_constraint` puts it right. A step from a point at which rows depend on each other is
/// refused, too.
#[test]
fn a_start_that_slips() -> Result<(), StepError> {
    let State { q, p, .. } = start_of_sleigh();
    let slipping = State::new(q, [p[0], p[1] + 1e-6, p[2]]);
    let row = "v[1]·cos(q[2]) - v[0]·sin(q[2]) - v[2]·a";
    let mut sim = SLEIGH.integrator(DiscreteGradient, 0.1, slipping);
    assert_eq!(sim.step(), Err(StepError::new(Failure::OffConstraint { what: row }, 0.0, 0.1)));
    assert_eq!(sim.state(), slipping);
    SLEIGH.integrator(DiscreteGradient, 0.1, SLEIGH.state_on_constraint(&slipping)?).step()?;
    for refused in [SLEIGH.integrator(RK4, 0.1, slipping).step(), SLEIGH.adaptive(DOP853, 1e-9, slipping).step()] {
        assert_eq!(refused.expect_err("slips").failure, Failure::OffConstraint { what: row });
    }
    // A state that is set later must obey the row, and a state at an event need not to rounding.
    let mut sim = SLEIGH.adaptive(DOP853, 1e-6, start_of_sleigh());
    sim.advance(5)?;
    let event = sim.until_event(20.0, Direction::Any, |x| x.q[2] - 1.5)?;
    assert!(event.is_some());
    sim.advance(5)?;
    let good = sim.state();
    sim.set_state(State { t: good.t, ..slipping });
    assert_eq!(sim.step().expect_err("slips").failure, Failure::OffConstraint { what: row });
    sim.set_state(State { t: good.t, ..start_of_sleigh() });
    sim.step()?;

    /// Two rows that are parallel where x = 1 or y = 0.
    #[hamiltonian(rolling = [v[0] - q[1] * v[2], q[0] * v[0] - q[1] * v[2]])]
    fn parallel(q: [f64; 3], p: [f64; 3], m: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m)
    }
    let mut sim = Parallel { m: 1.4 }.integrator(DiscreteGradient, 0.1, State::new([1.0, 0.5, 0.0], [0.0, 0.3, 0.0]));
    let refused = sim.step().expect_err("parallel");
    assert!(matches!(refused.failure, Failure::DependentConstraints { .. }), "{refused}");
    Ok(())
}

/// In single precision, in other units, and with steps far too long.
#[test]
fn other_numbers() -> Result<(), StepError> {
    let (sin, cos) = 0.2_f32.sin_cos();
    let system = SleighBySingle { m: 1.3, i: 0.4, a: 0.5 };
    let start = system.at([0.5 * cos, 0.5 * sin, 0.2], [-0.6 * cos - 0.45 * sin, -0.6 * sin + 0.45 * cos, 0.9]);
    let mut sim = system.integrator(DiscreteGradient, 0.1, system.state_on_constraint(&start)?);
    let energy = sim.energy();
    sim.advance(1000)?;
    assert!((sim.energy() / energy - 1.0).abs() < 1e-5);
    // Lengths times 2, masses times 8, times times 4: states differ by powers of two only.
    let scaled = Sleigh { m: 8.0 * 1.3, i: 32.0 * 0.4, a: 1.0 };
    let State { q, p, .. } = start_of_sleigh();
    let start = State::new([2.0 * q[0], 2.0 * q[1], q[2]], [4.0 * p[0], 4.0 * p[1], 8.0 * p[2]]);
    let (mut one, mut other) =
        (SLEIGH.integrator(DiscreteGradient, 0.1, start_of_sleigh()), scaled.integrator(DiscreteGradient, 0.4, start));
    one.advance(500)?;
    other.advance(500)?;
    let (a, b) = (one.state(), other.state());
    assert_eq!([2.0 * a.q[0], 2.0 * a.q[1], a.q[2]], b.q);
    assert_eq!([4.0 * a.p[0], 4.0 * a.p[1], 8.0 * a.p[2]], b.p);
    for h in [1.0, 10.0, 1e3] {
        let mut sim = SLEIGH.integrator(DiscreteGradient, h, start_of_sleigh());
        let energy = sim.energy();
        for _ in 0..100 {
            let before = sim.state();
            match sim.step() {
                Ok(()) => assert!((sim.energy() - energy).abs() < 1e-12, "{h}: {:e}", sim.energy() - energy),
                Err(_) => assert_eq!(sim.state(), before),
            }
        }
    }
    Ok(())
}

/// The sleigh in single precision.
#[lagrangian(rolling = [v[1] * q[2].cos() - v[0] * q[2].sin() - a * v[2]])]
fn sleigh_by_single(q: [f32; 3], v: [f32; 3], m: f32, i: f32, a: f32) -> f32 {
    m * (v[0] * v[0] + v[1] * v[1]) / 2.0 + i * v[2] * v[2] / 2.0
}

/// Two methods of the literature, each of which fails on one of the problems above.
mod control {
    use geoint_runtime::prelude::State;

    /// The row A(q) of the sleigh.
    fn row(q: [f64; 3]) -> [f64; 3] {
        [-q[2].sin(), q[2].cos(), -0.5]
    }

    /// Inverse masses of the sleigh.
    const W: [f64; 3] = [1.0 / 1.3, 1.0 / 1.3, 1.0 / 0.4];

    /// The speed along the blade after so many steps of nonholonomic RATTLE.
    pub(super) fn rattle(start: &State<[f64; 3]>, h: f64, steps: u32) -> f64 {
        let (mut q, mut p) = (start.q, start.p);
        let weigh = |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| a[i] * W[i] * b[i]).sum::<f64>();
        // λ of the equations of motion: (A W A) λ = −A' v.
        let rate = [-q[2].cos() * p[2] * W[2], -q[2].sin() * p[2] * W[2], 0.0];
        let mut multiplier = -weigh(rate, p) / weigh(row(q), row(q));
        for _ in 0..steps {
            let a = row(q);
            let half: [f64; 3] = core::array::from_fn(|i| p[i] + h / 2.0 * a[i] * multiplier);
            q = core::array::from_fn(|i| q[i] + h * W[i] * half[i]);
            let a = row(q);
            multiplier = -2.0 / h * weigh(a, half) / weigh(a, a);
            p = core::array::from_fn(|i| half[i] + h / 2.0 * a[i] * multiplier);
        }
        (p[0] * q[2].cos() + p[1] * q[2].sin()) / 1.3
    }

    /// The gearbox with c = 0.5 by the discrete Lagrange–d'Alembert principle.
    pub(super) struct Lagrange {
        before: [f64; 3],
        now: [f64; 3],
        h: f64,
    }

    fn gear(z: f64) -> f64 {
        0.8 * z.sin() + 0.4 * (2.0 * z).cos()
    }

    fn force([x, y, z]: [f64; 3]) -> [f64; 3] {
        [-x, -y, -z.sin() - (2.0 * z).cos()]
    }

    impl Lagrange {
        /// The first two points: a step of order 2 along the motion.
        pub(super) fn new(q: [f64; 3], v: [f64; 3], h: f64) -> Self {
            let row = [1.0, gear(q[2]), 0.0];
            let slope = 0.8 * q[2].cos() - 0.8 * (2.0 * q[2]).sin();
            let f = force(q);
            let along = row[0] * f[0] + row[1] * f[1] + slope * v[2] * v[1];
            let multiplier = -along / (1.0 + row[1] * row[1]);
            let now = core::array::from_fn(|i| q[i] + h * v[i] + h * h / 2.0 * (f[i] + multiplier * row[i]));
            Lagrange { before: q, now: solved(now, q, [1.0, gear(q[2]), 0.0]), h }
        }

        /// Takes a step, and returns the energy at the middle of three points, with the central difference as velocity.
        pub(super) fn step(&mut self) -> f64 {
            let Lagrange { before, now, h } = *self;
            let (f, row) = (force(now), [1.0, gear(now[2]), 0.0]);
            let free: [f64; 3] = core::array::from_fn(|i| 2.0 * now[i] - before[i] + h * h * f[i]);
            let after = solved(free, now, row);
            let v: [f64; 3] = core::array::from_fn(|i| (after[i] - before[i]) / (2.0 * h));
            let [x, y, z] = now;
            *self = Lagrange { before: now, now: after, h };
            v.iter().map(|v| v * v / 2.0).sum::<f64>() + (x * x + y * y) / 2.0 - z.cos() + 0.5 * (2.0 * z).sin()
        }
    }

    /// The point free + κ·row with (A₀ + A₁)(q₁ − q₀) = 0.
    fn solved(free: [f64; 3], from: [f64; 3], row: [f64; 3]) -> [f64; 3] {
        // A₁ reads z alone, and the third entry of `row` is 0.
        let sum = [2.0, gear(from[2]) + gear(free[2])];
        let rest = sum[0] * (free[0] - from[0]) + sum[1] * (free[1] - from[1]);
        let kappa = -rest / (sum[0] * row[0] + sum[1] * row[1]);
        core::array::from_fn(|i| free[i] + kappa * row[i])
    }
}
