//! The scalar with twice the digits, by which others are judged.

use geoint_runtime::Real;
use geoint_tests::scalars::Double;

/// Identities to 10⁻²⁸: no table of values, and no function can be its own witness.
#[test]
fn functions_keep_their_identities() {
    let near = |what: &str, a: Double, b: Double| {
        let gap = (a - b).magnitude();
        assert!(gap <= 1e-28 * (1.0 + a.magnitude()), "{what}: {gap:.1e}");
    };
    for i in 1..40 {
        let x = Double::from(f64::from(i)) / 17.0;
        let (s, c) = x.sin_cos();
        near("√", x.sqrt() * x.sqrt(), x);
        near("∛", x.cbrt() * x.cbrt() * x.cbrt(), x);
        near("sin² + cos²", s * s + c * c, 1.0.into());
        near("sin 2x", (x + x).sin(), 2.0 * s * c);
        near("sin(x + π/3)", (x + Double::PI / 3.0).sin(), s * 0.5 + c * Double::from(0.75).sqrt());
        near("exp, ln", x.ln().exp(), x);
        near("exp(x + y)", (x + Double::LN_10).exp(), 10.0 * x.exp());
        near("atan2", s.atan2(c), if x > Double::PI { x - Double::PI * 2.0 } else { x });
        near("asin", (x / 3.0).asin().sin(), x / 3.0);
        near("tanh", x.tanh().atanh(), x);
        near("quotient", (x / 3.0) * 3.0, x);
    }
}

/// Derivatives at 0 are 1. The series therefore belong to sin and exp, not to other functions with the same symmetries.
#[test]
fn functions_have_the_right_scale() {
    let x = Double::from(1e-12);
    let cubic = x * x * x / 6.0;
    assert!((x.sin() - (x - cubic)).magnitude() < 1e-44);
    assert!((x.exp() - (1.0 + x + x * x / 2.0 + cubic)).magnitude() < 1e-31);
    assert!(((Double::from(2.0).ln() - Double::LN_2).magnitude()) < 1e-31);
    assert!((Double::from(1.0).atan() * 4.0 - Double::PI).magnitude() < 1e-30);
}
