//! Tests of enclosures against values and difference quotients.

use super::*;

type Function = (&'static str, fn(Enclosure<f64>) -> Enclosure<f64>, fn(f64) -> f64, [f64; 2]);

/// The table of all functions, with their intervals, their values, and the arguments of the test.
const FUNCTIONS: &[Function] = &[
    ("sqrt", Real::sqrt, Real::sqrt, [0.0, 9.0]),
    ("cbrt", Real::cbrt, Real::cbrt, [-3.0, 3.0]),
    ("sin", Real::sin, Real::sin, [-9.0, 9.0]),
    ("cos", Real::cos, Real::cos, [-9.0, 9.0]),
    ("tan", Real::tan, Real::tan, [-1.5, 1.5]),
    ("asin", Real::asin, Real::asin, [-1.0, 1.0]),
    ("acos", Real::acos, Real::acos, [-1.0, 1.0]),
    ("atan", Real::atan, Real::atan, [-5.0, 5.0]),
    ("sinh", Real::sinh, Real::sinh, [-3.0, 3.0]),
    ("cosh", Real::cosh, Real::cosh, [-3.0, 3.0]),
    ("tanh", Real::tanh, Real::tanh, [-3.0, 3.0]),
    ("asinh", Real::asinh, Real::asinh, [-3.0, 3.0]),
    ("acosh", Real::acosh, Real::acosh, [1.0, 4.0]),
    ("atanh", Real::atanh, Real::atanh, [-0.99, 0.99]),
    ("exp", Real::exp, Real::exp, [-3.0, 3.0]),
    ("exp2", Real::exp2, Real::exp2, [-3.0, 3.0]),
    ("exp_m1", Real::exp_m1, Real::exp_m1, [-3.0, 3.0]),
    ("ln", Real::ln, Real::ln, [0.01, 5.0]),
    ("ln_1p", Real::ln_1p, Real::ln_1p, [-0.9, 5.0]),
    ("log2", Real::log2, Real::log2, [0.01, 5.0]),
    ("log10", Real::log10, Real::log10, [0.01, 5.0]),
    ("abs", Real::abs, Real::abs, [-2.0, 2.0]),
    ("reciprocal", |x| Enclosure::from_f64(1.0) / x, |x| 1.0 / x, [0.1, 4.0]),
    ("product", |x| x * (x - Enclosure::from_f64(1.0)), |x| x * (x - 1.0), [-2.0, 2.0]),
    ("power", |x| x.powf(Enclosure::from_f64(1.7)), |x| Real::powf(x, 1.7), [0.0, 3.0]),
    ("exponent", |x| Enclosure::from_f64(1.3).powf(x), |x| Real::powf(1.3, x), [-2.0, 3.0]),
    ("hypot", |x| x.hypot(Enclosure::from_f64(0.5)), |x| Real::hypot(x, 0.5), [-2.0, 2.0]),
    ("angle", |x| x.atan2(Enclosure::from_f64(0.5)), |x| Real::atan2(x, 0.5), [-2.0, 2.0]),
    ("larger", |x| x.max(-x), |x| x.max(-x), [-2.0, 2.0]),
    (
        "chosen",
        |x| Enclosure::choose(x.less(Enclosure::from_f64(0.3)), || [x], || [x + x])[0],
        |x| if x < 0.3 { x } else { x + x },
        [-1.0, 1.0],
    ),
];

/// Values and difference quotients lie in their enclosures, on wide and on narrow parts.
#[test]
fn enclosures_enclose() {
    for (name, enclosed, value, [low, high]) in FUNCTIONS {
        for parts in [1, 3, 16, 1000] {
            for part in 0..parts {
                let at = |i: f64| low + (high - low) * i / f64::from(parts);
                let (a, b) = (at(part.into()), at(f64::from(part) + 1.0));
                let found = enclosed(Enclosure::new(Interval::new(a, b), ONE));
                let mut last: Option<(f64, f64)> = None;
                for i in 0..=20 {
                    let x = (a + (b - a) * f64::from(i) / 20.0).clamp(a, b);
                    let y = value(x);
                    assert!(found.value.low <= y && y <= found.value.high, "{name}({x}) = {y} in {:?}", found.value);
                    if let Some((x0, y0)) = last.filter(|(x0, _)| *x0 != x) {
                        let slope = (y - y0) / (x - x0);
                        // The difference is rounded.
                        let rounding = 1e-14 * (1.0 + y.abs()) / (x - x0).abs();
                        let (low, high) = (found.rate.low - rounding, found.rate.high + rounding);
                        assert!(low <= slope && slope <= high, "{name}'({x}) = {slope} in {:?}", found.rate);
                    }
                    last = Some((x, y));
                }
                // Narrow parts have narrow values.
                let (width, steepest) = (found.value.high - found.value.low, found.rate.abs().high);
                let narrow = parts < 1000 || width <= 4.0 * (1.0 + steepest) * (b - a);
                assert!(narrow, "{name} on {a}..{b}: {:?}", found.value);
            }
        }
    }
}

#[test]
fn undefined_values_give_the_whole_line() {
    let [below, nan] = [-2.0, f64::NAN].map(Enclosure::<f64>::constant);
    for x in [below.sqrt(), below.ln(), below.asin(), below.acosh(), nan, nan + below, nan.sin().exp() * nan] {
        assert!(x.value.contains_zero(), "{x:?}");
    }
    assert!(nan.value.is_whole() && below.ln().value.is_whole());
    // Zero times an unbounded interval is zero, as for a branch that is not taken.
    let zero = Enclosure::<f64>::constant(0.0);
    assert_eq!((zero * nan).value, zero.value);
}

#[test]
fn comparisons_have_three_answers() {
    let [one, two] = [1.0, 2.0].map(Enclosure::<f64>::constant);
    let both = Enclosure::<f64>::new(Interval::new(0.5, 1.5), ONE);
    let answer = |mask: Possible| (mask.yes, mask.no);
    assert_eq!(answer(one.less(two)), (true, false));
    assert_eq!(answer(two.less(one)), (false, true));
    assert_eq!(answer(one.less(one)), (false, true));
    assert_eq!(answer(one.less_equal(one) & one.equal(one)), (true, false));
    assert_eq!(answer(both.less(one)), (true, true));
    assert_eq!(answer(!both.less(two)), (false, true));
    assert_eq!(answer(both.less(one) | one.less(two)), (true, false));
}
