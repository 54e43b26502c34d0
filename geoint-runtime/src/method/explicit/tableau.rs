//! Coefficients of Runge–Kutta methods, explicit and implicit.

/// A Runge–Kutta method of `S` stages: kᵢ = f(t + cᵢh, x + h Σⱼ aᵢⱼkⱼ) and x₁ = x + h Σᵢ bᵢkᵢ. It is explicit if aᵢⱼ = 0 for j ≥ i.
///
/// The type checks nothing. The constructors of methods check their tables. Limit: wider scalars get the digits of `f64`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tableau<const S: usize> {
    /// Coefficients aᵢⱼ, one row for each stage.
    pub a: [[f64; S]; S],
    /// Weights bᵢ.
    pub b: [f64; S],
    /// Nodes cᵢ.
    pub c: [f64; S],
}
