//! Differential equations as other crates take them.

use geoint_tests::scalars::Scalar;

/// y' = rate(t, y) in every scalar, from a start at t = 0.
pub trait Field<const N: usize>: Copy + Send + Sync + 'static {
    /// Where it starts.
    fn start(&self) -> [f64; N];
    /// y'.
    fn rate<R: Scalar>(t: R, y: &[R; N], dy: &mut [R; N]);
}
