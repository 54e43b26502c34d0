//! Coefficients of Runge–Kutta methods.

/// A Runge–Kutta method of `S` stages.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tableau<const S: usize> {
    /// Coefficients aᵢⱼ, one row for each stage.
    pub a: [[f64; S]; S],
    /// Weights.
    pub b: [f64; S],
    /// Nodes.
    pub c: [f64; S],
}
