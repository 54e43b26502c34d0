//! Kepler's motion against fifty digits, and against itself on random orbits.

use geoint_runtime::Real;
use geoint_runtime::private::slope::kepler;

type Point = ([f64; 3], [f64; 3]);

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}

/// Returns the five numbers that determine an orbit: q·q, q·v, v·v, μ and h.
fn numbers((q, v): Point, mu: f64, h: f64) -> [f64; 5] {
    [dot(&q, &q), dot(&q, &v), dot(&v, &v), mu, h]
}

/// Computes N orbits at once, and returns one row of results per orbit.
fn side_by_side<R: Real, const N: usize>(orbits: [[R; 5]; N]) -> [[R; 4]; N] {
    let ends = kepler(std::array::from_fn(|kind| orbits.map(|orbit| orbit[kind])));
    std::array::from_fn(|i| ends.map(|row| row[i]))
}

fn alone<R: Real>(orbit: [R; 5]) -> [R; 4] {
    side_by_side([orbit])[0]
}

/// The end of an orbit as a piece of an energy has it.
fn flow(start: Point, mu: f64, h: f64) -> Point {
    moved(start, alone(numbers(start, mu, h)))
}

/// Increments by f − 1, g, ḟ, ġ − 1.
fn moved((q, v): Point, [f, g, f_rate, g_rate]: [f64; 4]) -> Point {
    let end = |x: &[f64; 3], a, b| std::array::from_fn(|i| x[i] + (f64::mul_add(a, q[i], b * v[i])));
    (end(&q, f, g), end(&v, f_rate, g_rate))
}

fn distance(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    let d: [f64; 3] = std::array::from_fn(|i| a[i] - b[i]);
    dot(&d, &d).sqrt()
}

/// The larger relative error of q and v.
fn error(found: &Point, expected: &Point) -> f64 {
    let relative = |a: &[f64; 3], b: &[f64; 3]| distance(a, b) / dot(b, b).sqrt();
    let errors = [relative(&found.0, &expected.0), relative(&found.1, &expected.1)];
    if errors[0].is_nan() || errors[1].is_nan() { f64::NAN } else { errors[0].max(errors[1]) }
}

/// Output of references.py beside this file.
const REFERENCES: &str = include_str!("references.txt");

#[test]
fn orbits_end_where_fifty_digits_say() {
    let mut worst: f64 = 0.0;
    for line in REFERENCES.lines() {
        let numbers: Vec<f64> = line.split(' ').map(|number| number.parse().expect("a number")).collect();
        let vector = |i: usize| [numbers[i], numbers[i + 1], numbers[i + 2]];
        let (start, end) = ((vector(2), vector(5)), (vector(8), vector(11)));
        let error = error(&flow(start, 1.0, numbers[1]), &end) / numbers[14].max(1.0);
        assert!(error <= 1e-15, "e = {}, h = {}: {error:.1e} of its condition", numbers[0], numbers[1]);
        worst = worst.max(error);
    }
    // The references are no copy of the tested function.
    assert!(worst > 1e-17);
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}

/// Numbers between 0 and 1 that repeat.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// From 10^low to 10^high, with many of every size.
    fn decades(&mut self, low: f64, high: f64) -> f64 {
        10_f64.powf(self.between(low, high))
    }
}

/// Returns a point of an orbit of eccentricity `e` about μ, with its pericentre at distance `pericentre`, at the true anomaly `anomaly`.
fn orbit(e: f64, mu: f64, pericentre: f64, anomaly: f64) -> Point {
    let (sin, cos) = anomaly.sin_cos();
    let parameter = pericentre * (1.0 + e);
    let (r, speed) = (parameter / (1.0 + e * cos), (mu / parameter).sqrt());
    let in_space = |x: f64, y: f64| [0.6 * x - 0.64 * y, 0.8 * x + 0.48 * y, 0.6 * y];
    (in_space(r * cos, r * sin), in_space(-speed * sin, speed * (e + cos)))
}

/// The time since the pericentre, less whole periods; how well both ends' numbers determine it, in roundings; and the period.
fn time((q, v): &Point, e: f64, mu: f64, beta: f64) -> (f64, f64, f64) {
    let (r, square) = (dot(q, q).sqrt(), dot(v, v));
    let unit = mu / beta.abs().powf(1.5);
    let sine = dot(q, v) * beta.abs().sqrt() / mu;
    let scale = dot(q, q).sqrt() * square.sqrt() * beta.abs().sqrt() / mu;
    let cancelled = (2.0 * mu / r + square) / beta.abs();
    if beta > 0.0 {
        let cosine = 1.0 - r * beta / mu;
        let anomaly = sine.atan2(cosine);
        let size = (scale + 1.0) / e + anomaly.abs() + sine.abs();
        (unit * (anomaly - sine), unit * size * cancelled, unit * std::f64::consts::TAU)
    } else {
        let anomaly = (sine / e).asinh();
        (unit * (sine - anomaly), unit * (scale + anomaly.abs()) * cancelled, f64::INFINITY)
    }
}

/// By how much, relative to its size, the end of an orbit moves for a relative change of 1 of each number that is given.
fn condition(start: Point, mu: f64, h: f64, small: f64) -> f64 {
    let end = flow(start, mu, h);
    let moved = |changed: Point, mu: f64, h: f64| {
        let other = flow(changed, mu, h);
        let relative = |a, b| distance(a, b) / dot(b, b).sqrt();
        relative(&other.0, &end.0).max(relative(&other.1, &end.1)) / small
    };
    let coordinates = (0..6).map(|i| {
        let mut changed = start;
        let x = if i < 3 { &mut changed.0 } else { &mut changed.1 };
        x[i % 3] += small * dot(x, x).sqrt();
        moved(changed, mu, h)
    });
    coordinates.sum::<f64>() + moved(start, mu * (1.0 + small), h) + moved(start, mu, h * (1.0 + small))
}

#[test]
fn random_orbits_keep_what_orbits_keep_and_kepler_s_equation() {
    let mut random = Random(1);
    for case in 0..100_000 {
        let e = if case % 7 == 0 { 1.0 - random.decades(-9.0, -1.0) } else { random.between(0.05, 5.0) };
        let (mu, pericentre) = (random.decades(-6.0, 6.0), random.decades(-3.0, 3.0));
        let widest = if e < 1.0 { 3.1 } else { 0.95 * (-1.0 / e).acos() };
        let start = orbit(e, mu, pericentre, random.between(-widest, widest));
        let unit = (pericentre.powi(3) / mu).sqrt();
        let h = unit * random.decades(-3.0, 3.0) * if case % 2 == 0 { 1.0 } else { -1.0 };
        let end = flow(start, mu, h);
        let context = format!("case {case}: e = {e}, h = {} of the pericentre's time", h / unit);
        let rounding = 1e-14 * condition(start, mu, h, 1e-7).max(1.0);
        let energy = |(q, v): &Point| (0.5 * dot(v, v), mu / dot(q, q).sqrt());
        let [(kinetic, potential), (kinetic_end, potential_end)] = [&start, &end].map(energy);
        let change =
            (kinetic_end - potential_end - kinetic + potential) / (kinetic + kinetic_end + potential + potential_end);
        assert!(change.abs() < rounding, "{context}: energy {change:.1e}");
        let moments = [&start, &end].map(|(q, v)| cross(q, v));
        let sizes = [&start, &end].map(|(q, v)| (dot(q, q) * dot(v, v)).sqrt());
        let change = distance(&moments[0], &moments[1]) / (sizes[0] + sizes[1]);
        assert!(change < rounding, "{context}: angular momentum {change:.1e}");
        let beta = 2.0 * (potential - kinetic);
        let [(before, first, period), (after, second, _)] = [&start, &end].map(|point| time(point, e, mu, beta));
        let late = after - before - h;
        let late = if period.is_finite() { late - (late / period).round() * period } else { late };
        let known = 1e-14 * (first + second + h.abs() * (kinetic + potential) / beta.abs())
            + rounding * (dot(&end.0, &end.0) / dot(&end.1, &end.1)).sqrt();
        assert!(late.abs() < known, "{context}: {late:.1e}, known to {known:.1e}");
    }
}

/// Returns an orbit of eccentricity 0 to 5, and a time of up to a thousand times the time scale of the pericentre, of either sign.
fn any_orbit(random: &mut Random, decades: f64) -> (Point, f64, f64) {
    let e = random.between(0.0, 5.0) * random.next();
    let (mu, pericentre) = (random.decades(-decades, decades), random.decades(-decades, decades));
    let widest = if e < 1.0 { 3.1 } else { 0.95 * (-1.0 / e).acos() };
    let start = orbit(e, mu, pericentre, random.between(-widest, widest));
    let h = (pericentre.powi(3) / mu).sqrt() * random.decades(-3.0, 3.0) * if random.next() < 0.5 { 1.0 } else { -1.0 };
    (start, mu, h)
}

#[test]
fn random_orbits_are_the_same_in_all_units() {
    let (mut random, mut others) = (Random(2), 0);
    let (length, time) = (2.0_f64.powi(60), 2.0_f64.powi(-25));
    let scaled = |(q, v): Point| (q.map(|x| x * length), v.map(|x| x * length / time));
    for case in 0..100_000 {
        let (start, mu, h) = any_orbit(&mut random, 3.0);
        let end = flow(start, mu, h);
        assert!(end.0.iter().chain(&end.1).all(|x| x.is_finite()), "case {case}: {start:?}, {mu}, {h}");
        let there = flow(scaled(start), mu * length.powi(3) / time.powi(2), h * time);
        // If intermediate numbers overflow, the computation takes another path and rounds differently.
        if there != scaled(end) {
            others += 1;
            let lost = error(&there, &scaled(end)) / condition(start, mu, h, 1e-7).max(1.0);
            assert!(lost < 4.0 * f64::EPSILON, "case {case}: {start:?}, {mu}, {h}: {lost:e}");
        }
    }
    assert!(others < 1000, "{others}");
}

/// In single precision, in units of its condition.
#[test]
fn random_orbits_of_single_numbers() {
    let mut random = Random(3);
    let mut worst = 0.0_f64;
    for case in 0..100_000 {
        let (start, mu, h) = any_orbit(&mut random, 2.0);
        let given = numbers(start, mu, h).map(|x| x as f32);
        let exact = moved(start, alone(given.map(f64::from)));
        let found = moved(start, alone(given).map(f64::from));
        let lost = error(&found, &exact);
        assert!(lost.is_finite(), "case {case}: {start:?}, {mu}, {h}: {found:?}");
        // The condition takes as long as ten orbits.
        if case % 10 == 0 {
            let small = 1e-9;
            let condition: f64 = (0..5)
                .map(|i| {
                    let mut changed = given.map(f64::from);
                    changed[i] *= 1.0 + small;
                    error(&moved(start, alone(changed)), &exact) / small
                })
                .sum();
            worst = worst.max(lost / (1.0 + condition) / f64::from(f32::EPSILON));
        }
    }
    println!("{worst:.1} ε");
    assert!(worst < 4.0, "{worst} ε of their condition");
}

#[test]
fn flows_of_other_fields_and_of_no_time_are_exact_where_formulas_are() {
    let start = ([0.3, -0.4, 1.2], [0.5, 0.1, -0.2]);
    assert_eq!(flow(start, 1.7, 0.0), start);
    let straight = flow(start, 0.0, 2.5);
    assert!(error(&straight, &(std::array::from_fn(|i| start.0[i] + 2.5 * start.1[i]), start.1)) < 1e-15);
    // Repelled: head on, v²/2 + 1/r is kept, and the particle comes back. The distance at the end is the difference of numbers 17 times as
    // large.
    let end = flow(([2.0, 0.0, 0.0], [-1.0, 0.0, 0.0]), -1.0, 20.0);
    let kept = 0.5 * end.1[0] * end.1[0] + 1.0 / end.0[0];
    assert!((kept - 1.0).abs() < 4.0 * 17.0 * 2.0 * f64::EPSILON && end.0[0] > 2.0 && end.1[0] > 1.0);
}

#[test]
fn orbits_that_meet_the_centre_end_there() {
    let is_lost = |point: Point| point.0.iter().chain(&point.1).all(|x| x.is_nan());
    // From rest at distance 1: π/√8 until the centre.
    let fall = std::f64::consts::PI / 8_f64.sqrt();
    let rest = ([1.0, 0.0, 0.0], [0.0; 3]);
    for sign in [1.0, -1.0] {
        assert!(!is_lost(flow(rest, 1.0, sign * 0.999 * fall)));
        for part in [1.001, 1.5, 2.0, 2.5, 17.0, 1e6] {
            assert!(is_lost(flow(rest, 1.0, sign * part * fall)), "{part}");
        }
    }
    // Outward and back; faster than the speed of escape outward for ever, inward not.
    let outward = ([1.0, 2.0, -2.0], [0.1, 0.2, -0.2]);
    assert!(!is_lost(flow(outward, 1.0, 3.0)));
    assert!(is_lost(flow(outward, 1.0, 30.0)));
    let escaping = ([1.0, 2.0, -2.0], [1.0, 2.0, -2.0]);
    assert!(!is_lost(flow(escaping, 1.0, 1e3)));
    assert!(is_lost(flow(escaping, 1.0, -10.0)));
    assert!(is_lost(flow(([0.0; 3], [0.1, 0.2, 0.3]), 1.0, 0.1)), "no distance");
    // An orbit that passes the centre continues, however near it passes.
    assert!(!is_lost(flow(([1.0, 0.0, 0.0], [0.0, 1e-5, 0.0]), 1.0, 2.0)));
}

/// Orbits side by side end as they do alone. They fill a part of a register of the processor, one register, or several.
#[test]
fn orbits_side_by_side_are_those_alone() {
    fn check<const N: usize>() {
        let one = |i: usize| numbers(orbit(0.1 * (i % 7) as f64, 1.3, 1.0 + i as f64, 0.7 * i as f64), 1.3, 0.4);
        let orbits: [[f64; 5]; N] = std::array::from_fn(one);
        let together = side_by_side(orbits);
        assert_eq!(together, orbits.map(alone));
        // One orbit needs the safe path. The others take it as well, and their ends differ only by rounding.
        let mut mixed = orbits;
        mixed[N / 2][4] = 400.0;
        for (i, (end, alone)) in side_by_side(mixed).into_iter().zip(together).enumerate().filter(|(i, _)| *i != N / 2)
        {
            let near = end.iter().zip(alone).all(|(a, b)| (a - b).abs() < 4.0 * f64::EPSILON);
            assert!(near, "{i}: {end:?}, {alone:?}");
        }
    }
    check::<1>();
    check::<2>();
    check::<3>();
    check::<4>();
    check::<5>();
    check::<6>();
    check::<7>();
    check::<8>();
    check::<9>();
    check::<18>();
}

#[test]
fn single_numbers_have_their_own_digits() {
    let start = numbers(orbit(0.3, 1.0, 0.7, 0.5), 1.0, 0.6);
    for (long, short) in alone(start).iter().zip(alone(start.map(|x| x as f32))) {
        assert!((long - f64::from(short)).abs() < 1e-6, "{long} {short}");
    }
}

/// A comet from far away leaves as it came, up to the condition of the five input numbers. Squares of distance and speed determine the distance of
/// the passage less precisely than coordinates.
#[test]
fn hyperbolas_from_far() {
    let (mu, pericentre) = (1.7, 0.3_f64);
    let mut worst = 0.0_f64;
    for e in [1.02_f64, 1.5, 5.0, 50.0] {
        let speed = (mu * (1.0 + e) / pericentre).sqrt();
        let nearest = ([pericentre, 0.0, 0.0], [0.0, speed, 0.0]);
        for distance in [1e1, 1e3, 1e5] {
            for duration in [distance * pericentre / speed, -distance * pericentre / speed] {
                let start = flow(nearest, mu, duration);
                let (q, v) = start;
                let (mirrored, h) = (([q[0], -q[1], 0.0], [-v[0], v[1], 0.0]), -2.0 * duration);
                let end = moved(start, alone(numbers(start, mu, h)));
                let small = 1e-3 / distance.powi(2);
                let condition: f64 = (0..5)
                    .map(|i| {
                        let mut changed = numbers(start, mu, h);
                        changed[i] *= 1.0 + small;
                        error(&moved(start, alone(changed)), &end) / small
                    })
                    .sum();
                let lost = error(&end, &mirrored) / condition;
                assert!(lost < 4.0 * f64::EPSILON, "e = {e} from {distance:e}: {lost:e} of its condition");
                worst = worst.max(lost);
            }
        }
    }
    assert!(worst > 0.0);
}
