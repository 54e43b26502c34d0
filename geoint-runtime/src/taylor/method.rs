//! Which order, and which steps?

use crate::scalar::{Real, Series};
use crate::sealed::Sealed;
use crate::solving::Refusal;
use crate::space::{PerCoordinate, Record};
use crate::system::Jets;
use core::fmt::Debug;

/// The orders of [`Taylor`], each with the smallest tolerance for which it is chosen.
///
/// Let ε be the last term of a step, relative to the state: the order p = 1 − ½ ln ε takes the least work for a unit of time (À. Jorba & M. Zou, Exp. Math. 14
/// (2005) 99). Here ε is `tolerance`/512. The table has the even orders near p, and few of them, because each one is compiled.
const ORDERS: [(f64, usize); 4] = [(1e-4, 8), (1e-6, 10), (1e-8, 12), (1e-13, 16)];

/// The order for smaller tolerances.
const LARGEST_ORDER: usize = 20;

/// Taylor series of the solution, with steps and an order that follow from the tolerance.
///
/// The error of a step is about `tolerance` times the size of the positions, in positions, and of the momenta, in momenta; steps are
/// chosen from the last two coefficients, for a last term 512 times smaller, because the energy would drift with what is truncated otherwise.
/// By a tolerance that is so many times smaller they are shorter by the root of the order.
/// Tolerances below the accuracy of the scalar count as that, those above 1/16 as 1/16, and from 1 on they are none. Nothing is kept exactly, everything to the tolerance: at the
/// default the energy of a Kepler orbit walks 1 to 6·10⁻¹⁴ in 10⁴ periods, by rounding; [projected](crate::Projection) it does not. The order
/// follows from the tolerance: 8 from 10⁻⁴ on, 10 from 10⁻⁶ on, 12 from 10⁻⁸ on, 16 from 10⁻¹³ on, and 20 below.
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
    /// The error of a step, relative to the state.
    pub tolerance: f64,
}

/// Taylor series of order `P`, with steps that follow from the tolerance; see [`Taylor`]. One order is compiled.
///
/// Of a low order steps are shorter, and round less: three bodies on a figure eight return after 100 periods forth and back to 0.7·10⁻¹² by
/// order 10, to 2·10⁻¹² by order 20 in a quarter of the time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaylorOrder<const P: usize> {
    /// The error of a step, relative to the state.
    pub tolerance: f64,
}

/// Taylor series of order `P` with steps of one length; the last one on the way to a time may be shorter, and one on the way to where a
/// condition of the energy changes sides. Nothing tells how accurate they are; but one that leads far beyond where a series ends, at a pole of the
/// energy or where a power of it vanishes that is no whole one, is refused.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaylorFixed<const P: usize> {
    /// The length of a step; negative to go back in time.
    pub h: f64,
}

impl Default for Taylor {
    /// As accurate as `f64` is.
    fn default() -> Self {
        Taylor { tolerance: f64::EPSILON }
    }
}

impl<const P: usize> Default for TaylorOrder<P> {
    /// As accurate as `f64` is.
    fn default() -> Self {
        TaylorOrder { tolerance: f64::EPSILON }
    }
}

/// How steps are chosen.
#[derive(Clone, Copy, Debug)]
pub enum Steps {
    /// From the tolerance.
    Tolerance(f64),
    /// All of one length.
    Length(f64),
}

/// [`Taylor`], [`TaylorOrder`] or [`TaylorFixed`], and these [projected](crate::Projection) to invariants.
///
/// Sealed: orders are part of types.
pub trait TaylorMethod<S: Jets<R>, R: Real = f64>: Sealed + Copy + Debug {
    /// A value for each order, from 1 on or from 0 on.
    type Orders<X: Copy + Debug>: Copy + Debug + AsRef<[X]> + AsMut<[X]>;
    /// A series of as many coefficients, as a scalar.
    type Series: Real;
    /// What steps hand on to the next one, where their ends are put right.
    type Memory: Copy + Debug + Record<R>;

    /// How steps are chosen.
    fn steps(&self) -> Steps;
    /// The order.
    fn order(&self) -> usize;
    /// The memory before the first step, which begins at `origin`.
    fn memory(origin: &S::Phase) -> Self::Memory;
    /// Returns the correction of the end of a step by the series. `time` is [t, h]; the step goes from `ends[0]` at the time t to `ends[1]` at t + h.
    ///
    /// # Errors
    /// The end cannot be corrected.
    fn correction(
        &self,
        memory: &mut Self::Memory,
        system: &S,
        time: [R; 2],
        ends: [&S::Phase; 2],
    ) -> Result<Option<S::Phase>, Refusal>;
    /// A series from its coefficients, that of order 0 first.
    fn series(coefficient: impl FnMut(usize) -> R) -> Self::Series;
    /// The coefficients of a series.
    fn coefficients(series: &Self::Series) -> &[R];
    /// The same value for each order.
    fn fill<X: Copy + Debug>(x: X) -> Self::Orders<X>;
    /// The coefficients of [`Jets::jet`] up to `order`, in the unit and at the time `start`.
    fn jet(
        order: usize,
        system: &S,
        start: [R; 2],
        x: (&S::Phase, &S::Action),
        jet: &mut Self::Orders<PerCoordinate<S::Phase, S::Action>>,
        switches: &mut Self::Orders<S::Switches>,
    );
}

/// Ends of steps that are left as they are.
macro_rules! as_it_is {
    () => {
        fn memory(_: &S::Phase) {}
        #[inline(always)]
        fn correction(&self, (): &mut (), _: &S, _: [R; 2], _: [&S::Phase; 2]) -> Result<Option<S::Phase>, Refusal> {
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

/// The first `P` orders. Not inlined: beside others the code of one order is slower by a twentieth.
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

/// The methods of one order.
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
