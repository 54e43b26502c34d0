//! Tests of exact numbers.

use super::*;

#[test]
fn square_roots_are_exact() {
    let root = |n: i128| Number::integer(n).pow(Ratio::HALF).unwrap();
    assert_eq!(root(3).mul(root(3)), Number::integer(3));
    assert_eq!(root(12), root(3).mul(Number::integer(2)));
    assert_eq!(root(2).mul(root(3)), root(6));
    assert_eq!(root(6).mul(root(2)), root(3).mul(Number::integer(2)));
    assert_eq!(root(144), Number::integer(12));
    assert_eq!(root(3).add(root(3).neg()), Number::ZERO);
    assert_eq!(root(3).pow(Ratio::integer(-2)), Ratio::new(1, 3).map(Number::Exact));
    assert_eq!(root(3).pow(Ratio::integer(-1)).unwrap().mul(root(3)), Number::ONE);
    // √9.81 = 3√109/10.
    let decimal = Number::decimal("9.81").unwrap().pow(Ratio::HALF).unwrap();
    assert_eq!(decimal.mul(decimal), Number::decimal("9.81").unwrap());
    for n in [2.0_f64, 3.0, 0.3, 9.81, 7e-5, 1e9 + 7.0] {
        let number = Number::decimal(&n.to_string()).unwrap();
        assert_eq!(number.pow(Ratio::HALF).unwrap().to_f64(), n.sqrt(), "{n}");
    }
    assert_eq!(Number::integer(-3).pow(Ratio::HALF), None);
    assert_eq!(Number::integer(2).pow(Ratio { numerator: 3, denominator: 2 }), Some(root(2).mul(Number::integer(2))));
}

/// √2 is 1.41421356237309504880168872420969807857….
#[test]
fn no_root_is_a_ratio() {
    let root = Number::integer(2).pow(Ratio::HALF).unwrap();
    for (decimal, rest) in
        [("1.4142135623730951", -5.1198311275790302e-17), ("1.41421356237309504", 8.801688724209698e-18)]
    {
        let decimal = Number::decimal(decimal).unwrap();
        for difference in [root.add(decimal.neg()), decimal.neg().add(root), decimal.add(root.neg()).neg()] {
            assert!((difference.to_f64() / rest - 1.0).abs() < 1e-15, "{difference:?}");
        }
    }
    assert_eq!(root.add(Number::ONE).to_f64(), 1.0 + std::f64::consts::SQRT_2);
}

#[test]
fn decimals_are_exact_while_short() {
    assert_eq!(Number::decimal("9.81"), Ratio::new(981, 100).map(Number::Exact));
    assert_eq!(Number::decimal("1e3"), Some(Number::integer(1000)));
    assert_eq!(Number::decimal("6.67430e-11"), Ratio::new(66743, 10_i128.pow(15)).map(Number::Exact));
    assert_eq!(Number::decimal("1.380649e-23"), Ratio::new(1_380_649, 10_i128.pow(29)).map(Number::Exact));
    let long = "0.12345678901234567890123456789012345678901";
    assert_eq!(Number::decimal(long), Some(Number::float(long.parse().unwrap())));
    assert_eq!(Number::decimal("1e400").map(Number::to_f64), Some(f64::INFINITY));
}

#[test]
fn thirds_cancel() {
    let third = Number::integer(3).pow(Ratio::integer(-1)).unwrap();
    assert_eq!(third.mul(Number::integer(3)), Number::ONE);
    assert_eq!(third.add(third).add(third), Number::ONE);
}

#[test]
fn powers_that_are_not_real_numbers_are_refused() {
    assert_eq!(Number::integer(-2).pow(Ratio::HALF), None);
    assert_eq!(Number::ZERO.pow(Ratio::integer(-1)), None);
}

#[test]
fn overflow_falls_back_to_floating_point() {
    let big = Number::float(2.0_f64.powi(80) + 2.0_f64.powi(30));
    assert!(matches!(big.mul(big), Number::Float(_)));
    assert_eq!(big.mul(big).to_f64(), big.to_f64() * big.to_f64());
}

#[test]
fn numbers_of_the_machine_are_exact_and_come_back() {
    for x in [std::f64::consts::PI, -0.1, 1e-20, 3e30, 2.0_f64.powi(-70) * 3.0, 1.5e300, 5e-324, f64::INFINITY] {
        assert_eq!(Number::float(x).to_f64(), x);
    }
    assert!(matches!(Number::float(std::f64::consts::PI), Number::Exact(_)));
}

#[test]
fn long_ratios_are_rounded_once_to_the_nearest_even() {
    let one = 1_i128 << 60;
    for (numerator, rounded) in [
        (one + 128, 2.0_f64.powi(60)),
        (one + 129, 2.0_f64.powi(60) + 256.0),
        (one + 384, 2.0_f64.powi(60) + 512.0),
        (-one - 129, -(2.0_f64.powi(60) + 256.0)),
    ] {
        assert_eq!(Ratio::new(numerator, 1).unwrap().to_f64(), rounded);
        let scaled = Ratio::new(numerator, 3 * one).unwrap().to_f64();
        assert!((scaled * 3.0 * one as f64 / numerator as f64 - 1.0).abs() < 4e-16);
    }
    let tenth = Ratio::new(10_i128.pow(30), 10_i128.pow(31) + 1).unwrap();
    assert_eq!(tenth.to_f64(), 0.1);
    for text in ["1.380649e-23", "6.62607015e-34", "1.602176634e-19", "0.1234567890123456789", "299792458.123456789"] {
        assert_eq!(Number::decimal(text).unwrap().to_f64(), text.parse::<f64>().unwrap(), "{text}");
    }
}
