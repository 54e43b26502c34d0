//! Linear momenta, norms, many bodies, and weights that are parameters.

use super::*;

#[test]
fn many_bodies() {
    let bodies = quote! {
        fn outer_solar_system(q: [Vector3<f64>; 6], p: [Vector3<f64>; 6], m: [f64; 6], g: f64) -> f64 {
            let mut energy = 0.0;
            for i in 0..6 {
                energy += p[i].norm_squared() / (2.0 * m[i]);
                for j in 0..i {
                    energy -= g * m[i] * m[j] / (q[i] - q[j]).norm();
                }
            }
            energy
        }
    };
    let found = momenta(bodies);
    let names: Vec<&str> = found.iter().filter_map(|line| line.split(':').next()).collect();
    let expected = ["angular momentum about ", "total momentum along "];
    let expected: Vec<String> =
        expected.iter().flat_map(|name| ["x", "y", "z"].map(|axis| format!("{name}{axis}"))).collect();
    assert_eq!(names, expected);
    assert_eq!(found[4], "total momentum along y: p1 + p4 + p7 + p10 + p13 + p16");
    // Two independent pairs.
    let pairs = quote! {
        fn pairs(q: [[f64; 2]; 4], p: [[f64; 2]; 4], m: f64, k: f64) -> f64 {
            let mut energy = 0.0;
            for i in 0..4 {
                energy += (p[i][0].powi(2) + p[i][1].powi(2)) / (2.0 * m);
            }
            for i in [0, 2] {
                energy -= k / ((q[i][0] - q[i + 1][0]).powi(2) + (q[i][1] - q[i + 1][1]).powi(2)).sqrt();
            }
            energy
        }
    };
    let expected = [
        "angular momentum: q0·p1 - q1·p0 + q2·p3 - q3·p2",
        "angular momentum: q4·p5 - q5·p4 + q6·p7 - q7·p6",
        "momentum: p0 + p2",
        "momentum: p1 + p3",
        "momentum: p4 + p6",
        "momentum: p5 + p7",
    ];
    assert_eq!(momenta(pairs), expected);
}

#[test]
fn linear_momenta_and_norms() {
    let energies = [
        (
            quote! { fn toda(q: [f64; 3], p: [f64; 3], m: f64) -> f64 {
                p.iter().map(|p| p * p).sum::<f64>() / (2.0 * m) + (q[0] - q[1]).exp() + (q[1] - q[2]).exp()
            } },
            vec!["total momentum: p0 + p1 + p2"],
        ),
        (
            quote! { fn gear(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
                p[0] * p[0] / m + p[1] * p[1] + (3.0 * q[0] - 2.0 * q[1] + k).cos()
            } },
            vec!["momentum: p0 + 3·p1/2"],
        ),
        // A charge in a magnetic field, then a force around a centre away from the origin.
        (
            quote! { fn charge(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
                ((p[0] + q[1] / 4.0).powi(2) + (p[1] - q[0] / 4.0).powi(2)).powi(2) / m
            } },
            vec![
                "angular momentum: q0·p1 - q1·p0",
                "sum of squares: q0² + 16·p0² + q1² + 16·p1²",
                "momentum: p0 - q1/4",
                "momentum: q0/4 + p1",
            ],
        ),
        (
            planar(quote! { -k / ((q[0] - 1.0).powi(2) + q[1] * q[1]).sqrt() }),
            vec!["angular momentum: q0·p1 - p1 - q1·p0"],
        ),
        (
            quote! { fn schroedinger(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
                let n = |i: usize| q[i] * q[i] + p[i] * p[i];
                k * (n(0).powi(2) + n(1).powi(2)) - q[0] * q[1] - p[0] * p[1]
            } },
            vec!["norm: q0² + p0² + q1² + p1²"],
        ),
        // Momenta of coordinates that H does not read are reported elsewhere.
        (quote! { fn cyclic(q: [f64; 2], p: [f64; 2]) -> f64 { (p[0] * q[0]).sin() + p[1].cosh() } }, vec![]),
        (quote! { fn one(q: f64, p: f64) -> f64 { (p * p + q * q).sqrt() } }, vec![]),
    ];
    for (item, expected) in energies {
        let text = item.to_string();
        assert_eq!(momenta(item), expected, "{text}");
    }
}

/// Vortices of strength Γ in q = x, p = Γy conserve Σ Γ y, Σ Γ x and Σ Γ (x² + y²).
#[test]
fn weights_may_be_parameters() {
    let vortices = quote! {
        fn vortices(q: [f64; 3], p: [f64; 3], gamma: [f64; 3]) -> f64 {
            let mut energy = 0.0;
            for i in 0..3 {
                for j in 0..i {
                    let (x, y) = (q[i] - q[j], p[i] / gamma[i] - p[j] / gamma[j]);
                    energy -= gamma[i] * gamma[j] * (x * x + y * y).ln() / (4.0 * std::f64::consts::PI);
                }
            }
            energy
        }
    };
    let expected = [
        "total momentum: p0 + p1 + p2",
        "sum of squares: q0²·c0 + p0²/c0 + q1²·c1 + p1²/c1 + q2²·c2 + p2²/c2",
        "position: q0·c0 + q1·c1 + q2·c2",
    ];
    assert_eq!(momenta(vortices), expected);
    let cases = [
        // A charge in a uniform field, in two gauges, with a central force and without.
        (
            quote! { fn f(q: [f64; 2], p: [f64; 2], m: f64, b: f64) -> f64 {
                ((p[0] + b * q[1]).powi(2) + (p[1] - b * q[0]).powi(2)) / (2.0 * m) - 1.0 / q[0].hypot(q[1])
            } },
            vec!["angular momentum: q0·p1 - q1·p0"],
        ),
        (
            quote! { fn f(q: [f64; 2], p: [f64; 2], m: f64, b: f64) -> f64 {
                ((p[0] + b * q[1]).powi(2) + (p[1] - b * q[0]).powi(2)).sqrt() / m
            } },
            vec![
                "angular momentum: q0·p1 - q1·p0",
                "sum of squares: p0² + p1² + q0²·c1² + q1²·c1²",
                "momentum: p0 - q1·c1",
                "momentum: p1 + q0·c1",
            ],
        ),
        (
            quote! { fn f(q: [f64; 2], p: [f64; 2], m: f64, b: f64) -> f64 {
                (p[0] * p[0] + (p[1] - b * q[0]).powi(2)).sqrt() / m
            } },
            vec!["angular momentum: q0² - q1² - 2·q0·p1/c1 + 2·q1·p0/c1", "momentum: p0 - q1·c1"],
        ),
        (
            quote! { fn f(q: [f64; 2], p: [f64; 2], m: f64, b: f64) -> f64 {
                ((p[0] + b * q[1]).powi(2) + p[1] * p[1]) / (2.0 * m) + (q[0] * q[0] + q[1] * q[1]).powi(2)
            } },
            vec!["angular momentum: q0² - q1² + 2·q0·p1/c1 - 2·q1·p0/c1"],
        ),
        // Independent oscillators with quadratic energies.
        (
            quote! { fn f(q: [f64; 2], p: [f64; 2], m: [f64; 2], k: [f64; 2]) -> f64 {
                (0..2).map(|i| p[i] * p[i] / (2.0 * m[i]) + k[i] * q[i] * q[i] / 2.0).sum::<f64>()
            } },
            vec!["sum of squares: p0² + q0²·c0·c2", "sum of squares: p1² + q1²·c1·c3"],
        ),
        // Gears with different numbers of teeth. In the second energy, the weights depend on time.
        (
            quote! { fn f(q: [f64; 2], p: [f64; 2], m: f64, n: [f64; 2]) -> f64 {
                p[0] * p[0] / m + p[1] * p[1] + (n[0] * q[0] - n[1] * q[1]).cos()
            } },
            vec!["momentum: p0·c2 + p1·c1"],
        ),
        (
            quote! { fn f(q: [f64; 2], p: [f64; 2], t: f64, n: f64) -> f64 {
                p[0].cosh() + p[1] * p[1] + (n * t * q[0] - q[1]).cos()
            } },
            vec![],
        ),
        // The weights of the two pairs disagree.
        (
            quote! { fn f(q: [f64; 2], p: [f64; 2], a: f64, b: f64) -> f64 {
                p[0].cosh() + p[1] * p[1] + (a * q[0] - q[1]).cos() + (b * q[0] - q[1]).cosh()
            } },
            vec![],
        ),
    ];
    for (item, expected) in cases {
        let text = item.to_string();
        assert_eq!(momenta(item), expected, "{text}");
    }
}
