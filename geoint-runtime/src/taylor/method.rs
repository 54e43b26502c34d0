//! Taylor methods: their order, and the choice of the step length.

use crate::scalar::{Real, Series};
use crate::sealed::Sealed;
use crate::solving::Failure;
use crate::space::{PerCoordinate, Record};
use crate::system::Jets;
use core::fmt::Debug;

/// Orders of [`Taylor`], each with the smallest tolerance for which it is chosen.
///
/// The order p = 1 − ½ ln ε minimises the work for a unit of time (À. Jorba & M. Zou, Exp. Math. 14 (2005) 99). Here ε is the last term of a step,
/// relative to the state: `tolerance`/512. The table contains only a few even orders near p, because each order is compiled.
const ORDERS: [(f64, usize); 4] = [(1e-4, 8), (1e-6, 10), (1e-8, 12), (1e-13, 16)];

/// Order for smaller tolerances.
const LARGEST_ORDER: usize = 20;

/// Taylor series of the solution. Step length and order follow from the tolerance.
///
/// The error of a step is about `tolerance` times the size of the positions for positions, and times the size of the momenta for momenta. The last
/// two coefficients determine the step length, so that the last term is smaller than this error by a factor 512. Without this factor, truncation
/// would let the energy drift. A tolerance smaller by a factor c shortens the steps of order p by c^(1/p).
///
/// Tolerances below the accuracy of the scalar count as this accuracy, and those above 1/16 as 1/16. A tolerance of 1 or more is an error.
///
/// No invariant is conserved exactly, but all within the tolerance. At the default tolerance, rounding changes the energy of a Kepler orbit by 1 to
/// 6·10⁻¹⁴ in 10⁴ periods, as a random walk. A [projection](crate::Projection) removes this.
///
/// The order is 8 for tolerances from 10⁻⁴ on, 10 from 10⁻⁶ on, 12 from 10⁻⁸ on, 16 from 10⁻¹³ on, and 20 below.
///
/// À. Jorba & M. Zou, Exp. Math. 14 (2005) 99.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// #[hamiltonian]
/// fn pendulum(q: f64, p: f64) -> f64 {
///     p * p / 2.0 - q.cos()
/// }
///
/// let mut sim = Pendulum.taylor(Taylor::default(), State::new(1.5, 0.0));
/// sim.advance_to(10.0)?;
/// assert!((sim.state().q + 1.054049155450843232884424488481).abs() < 1e-14);
/// # Ok::<(), StepError>(())
/// ```
#[doc(alias("TIDES", "heyoka", "Taylor series"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taylor {
    /// Error of a step, relative to the state.
    pub tolerance: f64,
}

/// Taylor series of order `P`, with steps that follow from the tolerance; see [`Taylor`]. Only this order is compiled.
///
/// A low order takes shorter steps with less rounding. Example: three bodies on a figure eight, integrated over 100 periods forth and back. Order 10
/// returns to within 0.7·10⁻¹², and order 20 to within 2·10⁻¹² in a quarter of the time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaylorOrder<const P: usize> {
    /// Error of a step, relative to the state.
    pub tolerance: f64,
}

/// Taylor series of order `P` with steps of fixed length. A step before a given time may be shorter, and so may a step to the point at which a
/// condition of the energy changes.
///
/// The accuracy is not controlled. A step is refused if it leads far beyond a point where the series ends. Such points are poles of the energy and
/// zeros of bases of non-integer powers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaylorFixed<const P: usize> {
    /// Length of a step; negative to go back in time.
    pub h: f64,
}

impl Default for Taylor {
    /// Accuracy of `f64`.
    fn default() -> Self {
        Taylor { tolerance: f64::EPSILON }
    }
}

impl<const P: usize> Default for TaylorOrder<P> {
    /// Accuracy of `f64`.
    fn default() -> Self {
        TaylorOrder { tolerance: f64::EPSILON }
    }
}

/// Choice of the step length.
#[derive(Clone, Copy, Debug)]
pub enum Steps {
    /// Adapted to this tolerance.
    Tolerance(f64),
    /// Fixed length.
    Length(f64),
}

/// [`Taylor`], [`TaylorOrder`] or [`TaylorFixed`], or one of them [projected](crate::Projection) to invariants.
///
/// Sealed, because orders are part of types.
pub trait TaylorMethod<S: Jets<R>, R: Real = f64>: Sealed + Copy + Debug {
    /// An array with one value for each order, from 1 on or from 0 on.
    type Orders<X: Copy + Debug>: Copy + Debug + AsRef<[X]> + AsMut<[X]>;
    /// A scalar type: a series with the same number of coefficients.
    type Series: Real;
    /// History for the correction of the ends of steps.
    type Memory: Copy + Debug + Record<R>;

    /// Returns how the step length is chosen.
    fn steps(&self) -> Steps;
    /// Returns the order.
    fn order(&self) -> usize;
    /// Returns the history before the first step, which starts at `origin`.
    fn memory(origin: &S::Phase) -> Self::Memory;
    /// Returns the correction of the end of a step by the series. `time` is [t, h]. The step goes from `ends[0]` at the time t to `ends[1]` at t + h.
    ///
    /// # Errors
    /// Fails if the end cannot be corrected.
    fn correction(
        &self,
        memory: &mut Self::Memory,
        system: &S,
        time: [R; 2],
        ends: [&S::Phase; 2],
    ) -> Result<Option<S::Phase>, Failure>;
    /// Builds a series from its coefficients, starting at order 0.
    fn series(coefficient: impl FnMut(usize) -> R) -> Self::Series;
    /// Returns the coefficients of a series.
    fn coefficients(series: &Self::Series) -> &[R];
    /// Returns an array with the same value for each order.
    fn fill<X: Copy + Debug>(x: X) -> Self::Orders<X>;
    /// Computes the coefficients of [`Jets::jet`] up to `order`. `start` is the unit and the time.
    fn jet(
        order: usize,
        system: &S,
        start: [R; 2],
        x: (&S::Phase, &S::Action),
        jet: &mut Self::Orders<PerCoordinate<S::Phase, S::Action>>,
        switches: &mut Self::Orders<S::Switches>,
    );
}

/// Implements methods that do not correct the ends of steps.
macro_rules! as_it_is {
    () => {
        fn memory(_: &S::Phase) {}
        #[inline(always)]
        fn correction(&self, (): &mut (), _: &S, _: [R; 2], _: [&S::Phase; 2]) -> Result<Option<S::Phase>, Failure> {
            Ok(None)
        }
    };
}

impl Sealed for Taylor {}
impl<const P: usize> Sealed for TaylorOrder<P> {}
impl<const P: usize> Sealed for TaylorFixed<P> {}

impl<S: Jets<R>, R: Real> TaylorMethod<S, R> for Taylor {
    type Orders<X: Copy + Debug> = [X; 20];
    type Series = Series<R, 20>;
    type Memory = ();

    #[inline(always)]
    fn steps(&self) -> Steps {
        Steps::Tolerance(self.tolerance)
    }
    as_it_is!();
    #[inline(always)]
    fn order(&self) -> usize {
        ORDERS.iter().find(|(least, _)| self.tolerance >= *least).map_or(LARGEST_ORDER, |(_, order)| *order)
    }
    fn series(coefficient: impl FnMut(usize) -> R) -> Series<R, 20> {
        Series(core::array::from_fn(coefficient))
    }
    fn coefficients(series: &Series<R, 20>) -> &[R] {
        &series.0
    }
    fn fill<X: Copy + Debug>(x: X) -> [X; 20] {
        [x; 20]
    }
    #[inline]
    fn jet(
        order: usize,
        system: &S,
        start: [R; 2],
        x: (&S::Phase, &S::Action),
        jet: &mut [PerCoordinate<S::Phase, S::Action>; 20],
        switches: &mut [S::Switches; 20],
    ) {
        match order {
            8 => part::<8, S, R>(system, start, x, jet, switches),
            10 => part::<10, S, R>(system, start, x, jet, switches),
            12 => part::<12, S, R>(system, start, x, jet, switches),
            16 => part::<16, S, R>(system, start, x, jet, switches),
            _ => part::<LARGEST_ORDER, S, R>(system, start, x, jet, switches),
        }
    }
}

/// Computes the first `P` orders. Not inlined: the code of each order is faster on its own.
#[inline(never)]
fn part<const P: usize, S: Jets<R>, R: Real>(
    system: &S,
    [unit, t]: [R; 2],
    (z, s): (&S::Phase, &S::Action),
    jet: &mut [PerCoordinate<S::Phase, S::Action>],
    switches: &mut [S::Switches],
) {
    if let (Some(jet), Some(switches)) = (jet.first_chunk_mut(), switches.first_chunk_mut()) {
        system.jet::<P>(unit, t, z, s, jet, switches);
    }
}

/// Implements the methods of one order.
macro_rules! of_one_order {
    ($($method:ident, $steps:expr;)*) => { $(
        impl<S: Jets<R>, R: Real, const P: usize> TaylorMethod<S, R> for $method<P> {
            type Orders<X: Copy + Debug> = [X; P];
            type Series = Series<R, P>;
            type Memory = ();

            #[inline(always)]
            fn steps(&self) -> Steps {
                let steps: fn(&Self) -> Steps = $steps;
                steps(self)
            }
            as_it_is!();
            #[inline(always)]
            fn order(&self) -> usize {
                P
            }
            fn series(coefficient: impl FnMut(usize) -> R) -> Series<R, P> {
                Series(core::array::from_fn(coefficient))
            }
            fn coefficients(series: &Series<R, P>) -> &[R] {
                &series.0
            }
            fn fill<X: Copy + Debug>(x: X) -> [X; P] {
                [x; P]
            }
            #[inline]
            fn jet(
                _: usize,
                system: &S,
                [unit, t]: [R; 2],
                (z, s): (&S::Phase, &S::Action),
                jet: &mut [PerCoordinate<S::Phase, S::Action>; P],
                switches: &mut [S::Switches; P],
            ) {
                system.jet(unit, t, z, s, jet, switches);
            }
        }
    )* };
}

of_one_order! {
    TaylorOrder, |method| Steps::Tolerance(method.tolerance);
    TaylorFixed, |method| Steps::Length(method.h);
}
