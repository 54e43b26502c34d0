//! Rigid bodies: attitudes as unit quaternions, angular momenta in the frame of the body, and centres of mass with their momenta.
//!
//! Kernels read a quaternion in the order of nalgebra, (i, j, k, w), and a vector as the pure quaternion (x, y, z, 0). Attitudes and momenta then have
//! the same shape. The rows of the centres of mass follow those of the attitudes, with one row for each body.

use crate::scalar::{Real, signed, zero};
use crate::sealed::Sealed;
use crate::space::{Array, Coordinates, Snapshot};
use crate::system::PhaseSpace;
use core::fmt::Debug;
use nalgebra::{Quaternion, Unit, UnitQuaternion, Vector3, Vector4};

/// Returns the four numbers of a quaternion: i, j, k, w.
fn numbers<R: Real>(r: UnitQuaternion<R>) -> [R; 4] {
    let quaternion: Quaternion<R> = *r.as_ref();
    quaternion.coords.into()
}

/// Returns the quaternion with these numbers, without normalisation, so that a state shows the result of the steps.
fn quaternion<R: Real>(numbers: [R; 4]) -> UnitQuaternion<R> {
    Unit::new_unchecked(Quaternion { coords: Vector4::from(numbers) })
}

impl<R: Real> Coordinates for UnitQuaternion<R> {
    type Real = R;
    type Array = [[R; 4]; 1];
    #[inline(always)]
    fn into_array(self) -> [[R; 4]; 1] {
        [numbers(self)]
    }
    #[inline(always)]
    fn from_array([r]: [[R; 4]; 1]) -> Self {
        quaternion(r)
    }
}

impl<R: Real, const N: usize> Coordinates for [UnitQuaternion<R>; N] {
    type Real = R;
    type Array = [[R; 4]; N];
    #[inline(always)]
    fn into_array(self) -> [[R; 4]; N] {
        self.map(numbers)
    }
    #[inline(always)]
    fn from_array(array: [[R; 4]; N]) -> Self {
        array.map(quaternion)
    }
}

/// The attitudes of one or more bodies. An attitude rotates vectors from the frame of the body to the frame of space.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no attitude",
    note = "attitudes are `UnitQuaternion<f64>` and `[UnitQuaternion<f64>; N]`, and those of `f32`"
)]
pub trait Attitudes: Coordinates {
    /// The angular momenta, each in the frame of its body.
    type Momenta: Copy + Debug + PartialEq;
    /// Converts momenta to pure quaternions.
    fn momenta_into_array(momenta: Self::Momenta) -> Self::Array;
    /// Converts pure quaternions to momenta.
    fn momenta_from_array(array: Self::Array) -> Self::Momenta;
}

impl<R: Real> Attitudes for UnitQuaternion<R> {
    type Momenta = Vector3<R>;
    fn momenta_into_array(momentum: Vector3<R>) -> [[R; 4]; 1] {
        [pure(momentum)]
    }
    fn momenta_from_array([momentum]: [[R; 4]; 1]) -> Vector3<R> {
        vector(momentum)
    }
}

impl<R: Real, const N: usize> Attitudes for [UnitQuaternion<R>; N] {
    type Momenta = [Vector3<R>; N];
    fn momenta_into_array(momenta: [Vector3<R>; N]) -> [[R; 4]; N] {
        momenta.map(pure)
    }
    fn momenta_from_array(array: [[R; 4]; N]) -> [Vector3<R>; N] {
        array.map(vector)
    }
}

fn pure<R: Real>(v: Vector3<R>) -> [R; 4] {
    let [x, y, z] = v.into();
    [x, y, z, zero()]
}

fn vector<R: Real>([x, y, z, _]: [R; 4]) -> Vector3<R> {
    Vector3::new(x, y, z)
}

/// The type of the centres of mass of bodies with the attitudes `A`: one `Vector3` for each body, or `()` for bodies about fixed points. The momenta of the
/// centres have the same type.
#[diagnostic::on_unimplemented(
    message = "`{Self}` are no centres of mass of bodies with the attitudes `{A}`",
    note = "each body has one: `Vector3<f64>` beside `UnitQuaternion<f64>`, `[Vector3<f64>; N]` beside `[UnitQuaternion<f64>; N]`"
)]
pub trait Centres<A: Attitudes>: Copy + Debug + PartialEq {
    /// Attitudes and centres, or the momenta of both, as one array.
    type Array: Array<Real = A::Real>;
    /// Joins `rows`, which hold attitudes or angular momenta, and these centres.
    fn beside(self, rows: A::Array) -> Self::Array;
    /// Separates attitudes, or angular momenta, from centres.
    fn apart(array: Self::Array) -> (A::Array, Self);
}

impl<A: Attitudes> Centres<A> for () {
    type Array = A::Array;
    #[inline(always)]
    fn beside(self, rows: A::Array) -> A::Array {
        rows
    }
    #[inline(always)]
    fn apart(array: A::Array) -> (A::Array, ()) {
        (array, ())
    }
}

/// Implements [`Centres`] for one body, and for N bodies.
macro_rules! centres {
    ([$($n:ident)?] $attitudes:ty, $centres:ty, $rows:expr) => {
        impl<R: Real $(, const $n: usize)?> Centres<$attitudes> for $centres {
            type Array = [[[R; 4]; $rows]; 2];
            #[inline(always)]
            fn beside(self, rows: [[R; 4]; $rows]) -> Self::Array {
                [rows, <$attitudes>::momenta_into_array(self)]
            }
            #[inline(always)]
            fn apart([rows, centres]: Self::Array) -> ([[R; 4]; $rows], Self) {
                (rows, <$attitudes>::momenta_from_array(centres))
            }
        }
    };
}

centres!([] UnitQuaternion<R>, Vector3<R>, 1);
centres!([N] [UnitQuaternion<R>; N], [Vector3<R>; N], N);

/// Attitudes with centres of mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed<A, C> {
    r: A,
    q: C,
}

impl<A: Attitudes, C: Centres<A>> Coordinates for Placed<A, C> {
    type Real = A::Real;
    type Array = C::Array;
    #[inline(always)]
    fn into_array(self) -> C::Array {
        self.q.beside(self.r.into_array())
    }
    #[inline(always)]
    fn from_array(array: C::Array) -> Self {
        let (r, q) = C::apart(array);
        Placed { r: A::from_array(r), q }
    }
}

/// A point of the phase space of rigid bodies at a time: plain data.
#[doc(alias("rigid body", "quaternion"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyState<A: Attitudes, C: Centres<A> = ()> {
    /// Time.
    pub t: A::Real,
    /// The attitude of each body. It rotates vectors from the frame of the body to the frame of space.
    pub r: A,
    /// The angular momentum of each body in its own frame.
    pub m: A::Momenta,
    /// The centres of mass, in space. `()` for bodies about fixed points.
    pub q: C,
    /// The momenta of the centres of mass, in space.
    pub p: C,
}

impl<A: Attitudes> BodyState<A> {
    /// The point (`r`, `m`) at t = 0.
    pub fn new(r: A, m: A::Momenta) -> Self {
        BodyState::at(zero(), r, m)
    }

    /// The point (`r`, `m`) at time `t`.
    pub fn at(t: A::Real, r: A, m: A::Momenta) -> Self {
        BodyState { t, r, m, q: (), p: () }
    }

    /// Adds centres of mass at `q` with momenta `p`, both in space.
    pub fn with_centres<C: Centres<A>>(self, q: C, p: C) -> BodyState<A, C> {
        let BodyState { t, r, m, .. } = self;
        BodyState { t, r, m, q, p }
    }
}

impl<A: Attitudes, C: Centres<A>> Sealed for BodyState<A, C> {}

impl<A: Attitudes, C: Centres<A>> Snapshot for BodyState<A, C> {
    type Real = A::Real;
    type Phase = [C::Array; 2];
    type Action = ();
    const ALIKE: usize = A::Array::LEN;
    const ATTITUDES: bool = true;
    #[inline]
    fn time(&self) -> A::Real {
        self.t
    }
    #[inline]
    fn of(t: A::Real, [positions, momenta]: [C::Array; 2], (): ()) -> Self {
        let ((r, q), (m, p)) = (C::apart(positions), C::apart(momenta));
        BodyState { t, r: A::from_array(r), m: A::momenta_from_array(m), q, p }
    }
    #[inline]
    fn parts(self) -> (A::Real, [C::Array; 2], ()) {
        let [r, m] = [self.r.into_array(), A::momenta_into_array(self.m)];
        (self.t, [self.q.beside(r), self.p.beside(m)], ())
    }
}

/// The permitted error of the length of a quaternion, in units of ε. It covers a user's product of hundreds of rotations, and the end of a run between two
/// normalisations.
const ROUNDING_OF_LENGTH: f64 = 1024.0;

/// The largest length of a quaternion, in units of 1/ε, that can be normalised without the loss of all digits.
const LONGEST: f64 = 1.0 / (1 << 20) as f64;

fn length<R: Real>(r: &[R; 4]) -> R {
    r.iter().fold(zero::<R>(), |sum, x| x.multiply_add(*x, sum)).sqrt()
}

/// Returns the length of the first quaternion that is not a unit quaternion to rounding.
pub(crate) fn wrong_length<S: PhaseSpace<R>, R: Real>(z: &S::Phase) -> Option<f64> {
    let mut z = *z;
    let mut lengths = S::attitudes(&mut z).iter().map(length);
    let wrong = |length: &R| (*length - R::from_f64(1.0)).magnitude() > ROUNDING_OF_LENGTH * R::epsilon();
    lengths.find(wrong).map(signed)
}

/// Returns the increments that normalise all quaternions. NaN for a quaternion that is so long that its attitude has no correct digit.
pub(crate) fn normalisation<S: PhaseSpace<R>, R: Real>(z: &S::Phase) -> S::Phase {
    let one = R::from_f64(1.0);
    let (mut z, mut dz) = (*z, S::Phase::zero());
    for (r, dr) in S::attitudes(&mut z).iter().zip(S::attitudes(&mut dz)) {
        let length = length(r);
        let excess = r.iter().fold(-one, |sum, x| x.multiply_add(*x, sum));
        // 1/|r| − 1 without cancellation.
        let factor = -excess / (length * (one + length));
        let short = length.less(R::from_f64(LONGEST / R::epsilon()));
        let [factor] = R::choose(short, || [factor], || [R::from_f64(f64::NAN)]);
        for (x, dx) in r.iter().zip(dr) {
            *dx = factor * *x;
        }
    }
    dz
}
