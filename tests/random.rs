//! Random systems of all forms, written by `.ci/random`. The emitted Taylor coefficients are compared with coefficients by truncated series.

#![allow(warnings, reason = "random programs")]

use geoint_runtime::scalar::Series;
use geoint_tests::jets::{self, BAR, Both, N};
use geoint_tests::scalars::Double;

/// Bound on the growth of rounding errors beyond `BAR`. Its unit is the error of series in f64, or the change under a rounding of the start.
const GROWN: f64 = 8.0;

/// Counts of compared systems and points, and the failures.
#[derive(Default)]
struct Seen {
    /// Systems with finite coefficients at one point or more.
    systems: u64,
    /// Points at which both ways agree to `BAR`, and points with larger rounding errors.
    points: [u64; 2],
    failures: Vec<String>,
}

impl Seen {
    /// Compares both ways at a point with the exact coefficients. Returns whether numbers could be compared.
    fn see(&mut self, name: &str, x: &[f64], mut both: Both, exact: Vec<[Double; N]>, nearby: &[[f64; N]]) -> bool {
        // The change under a rounding of the start alone is the condition.
        let (exact, noise) = jets::exact(&both.series, &exact);
        let rounded: Vec<Vec<f64>> = nearby.iter().map(|x| x[1..].to_vec()).collect();
        let noise = noise.max(jets::error(&rounded, &exact));
        // Larger coefficients leave the range of a double word.
        let moderate = exact.iter().flatten().all(|x| x.abs() < 1e100);
        if !both.is_finite() || !moderate || exact.iter().all(|x| x[2..].iter().all(|x| *x == 0.0)) {
            return false;
        }
        both.series = exact;
        let (error, most) = (both.error(), BAR.max(GROWN * noise));
        self.points[usize::from(most > BAR)] += 1;
        if !(error <= most) {
            self.failures.push(format!("{name} at {x:?}: {error:.1e}, and {noise:.1e} by series"));
        }
        // Control: wrong coefficients are detected.
        both.kernel.iter_mut().flatten().for_each(|x| *x *= 1.0 + 1e-10);
        if most == BAR && both.error() <= BAR {
            self.failures.push(format!("{name} at {x:?}: wrong coefficients are not seen"));
        }
        true
    }
}

/// Points to try until a system has finite coefficients.
const POINTS: [[f64; 3]; 6] =
    [[0.7, 0.4, 0.3], [1.3, 0.6, -0.2], [-0.6, 0.8, 0.5], [0.4, -0.9, 0.7], [2.1, 1.7, 1.2], [-1.4, -0.5, -0.8]];

macro_rules! check {
    ($seen:ident: $of:path, $rates:path, $module:ident $n:literal $text:literal) => {{
        let (t, a, w) = (0.3, 0.8, [0.45, 1.7]);
        type Over = Series<f64, N>;
        type Exact = Series<Double, N>;
        let system = $module::Energy::<f64> { a, w };
        let over = $module::Energy::<Over> { a: Series::constant(a), w: w.map(Series::constant) };
        let exact =
            $module::Energy::<Exact> { a: Series::constant(a.into()), w: w.map(|w| Series::constant(w.into())) };
        let mut any = false;
        for x in &POINTS {
            let x = &x[..$n];
            let both = $of(&system, &over, t, x);
            let doubles: Vec<Double> = x.iter().map(|x| Double::from(*x)).collect();
            let nearby: Vec<f64> = x.iter().map(|x| x * (1.0 + f64::EPSILON)).collect();
            let nearby = $rates(&over, &nearby, t);
            any |= $seen.see($text, x, both, $rates(&exact, &doubles, t.into()), &nearby);
        }
        $seen.systems += u64::from(any);
    }};
}

include!(env!("RANDOM_FILE"));

#[test]
fn kernels_agree_with_series() {
    let mut seen = Seen::default();
    all(&mut seen);
    let Seen { systems, points, failures } = seen;
    println!("{systems} systems; {points:?} points");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(systems > 0 && points[0] > 4 * points[1], "{points:?}");
}
