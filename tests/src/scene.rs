//! A scene: a system in every scalar, with a start, its differential equation, and the form that its flow keeps.
//!
//! Methods are judged on scenes, whatever the kind of phase space.

use crate::problems::Problem;
use crate::scalars::Scalar;
use geoint_runtime::private::Action;
use geoint_runtime::space::{Array, Snapshot};
use geoint_runtime::system::StateOf;
use geoint_runtime::{PhaseSpace, Real, VectorField};

/// A system in every scalar.
pub trait Scene {
    /// The system over another scalar.
    type Over<R: Scalar>: PhaseSpace<R>;
    /// Name of the scene.
    const NAME: &'static str;

    /// The system with its parameters.
    fn over<R: Scalar>() -> Self::Over<R>;

    /// When and where it starts; an action comes last.
    fn start() -> (f64, Vec<f64>);

    /// x' by the derivatives of the energy, or by hand.
    fn rate<R: Scalar>(system: &Self::Over<R>, t: R, x: &[R]) -> Vec<R>;

    /// Directions in which the start may move: all directions, unless there are constraints.
    fn directions() -> Vec<Vec<f64>> {
        let n = Self::start().1.len();
        (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect()
    }

    /// Returns the defect of a map in the form that the flow keeps. The map leads from `before` to `after`, and small displacements in `directions`
    /// to `images`.
    fn form_defect(directions: &[Vec<f64>], images: &[Vec<f64>], before: &[f64], after: &[f64]) -> f64;

    /// Returns the part of a state that is compared with solutions. The default is all of it. Scenes with constraints remove the momentum normal to
    /// the constraint, because a method may carry such a part along.
    fn compared<R: Scalar>(x: Vec<R>) -> Vec<R> {
        x
    }

    /// Returns the quantities that a field keeps in place of an energy.
    fn kept(_x: &[f64]) -> Option<Vec<f64>> {
        None
    }

    /// Returns the energy after `duration`. The energy of a contact system may decay.
    fn energy_after(_duration: f64, energy: f64) -> f64 {
        energy
    }
}

/// Start time of the runs of problems. Forces begin at another time.
const FROM: f64 = 0.4;

impl<P: Problem> Scene for P {
    type Over<R: Scalar> = P::Over<R>;
    const NAME: &'static str = P::NAME;

    fn over<R: Scalar>() -> Self::Over<R> {
        <P as Problem>::system()
    }

    fn start() -> (f64, Vec<f64>) {
        let (q, p) = P::START;
        (FROM, [q, p].concat())
    }

    fn rate<R: Scalar>(system: &Self::Over<R>, t: R, x: &[R]) -> Vec<R> {
        field(system, t, x)
    }

    fn form_defect(directions: &[Vec<f64>], images: &[Vec<f64>], _: &[f64], _: &[f64]) -> f64 {
        canonical_defect(directions, images)
    }
}

/// A state from plain numbers, an action last.
pub fn point<T: Snapshot>(t: T::Real, x: &[T::Real]) -> T {
    let (mut z, mut action) = (T::Phase::zero(), T::Action::zero());
    assert_eq!(x.len(), T::Phase::LEN + T::Action::LEN);
    let (coordinates, rest) = x.split_at(T::Phase::LEN);
    z.as_mut_slice().copy_from_slice(coordinates);
    action.numbers_mut().copy_from_slice(rest);
    T::of(t, z, action)
}

/// Returns all numbers of a state except the time, with an action last.
pub fn flat<T: Snapshot>(state: &T) -> Vec<T::Real> {
    let (_, z, action) = state.parts();
    [z.as_slice(), action.numbers()].concat()
}

/// x' of a system without an action.
pub fn field<S: VectorField<R>, R: Real>(system: &S, t: R, x: &[R]) -> Vec<R> {
    let (_, z, ()) = point::<StateOf<S, R>>(t, x).parts();
    let mut rate = S::Phase::zero();
    system.rate(t, &z, &mut rate);
    rate.as_slice().to_vec()
}

/// max |ω(Mu, Mv) − ω(u, v)| over all pairs of directions, with ω = Σ dqᵢ ∧ dpᵢ.
pub fn canonical_defect(directions: &[Vec<f64>], images: &[Vec<f64>]) -> f64 {
    let form = |u: &[f64], v: &[f64]| {
        let n = u.len() / 2;
        (0..n).map(|i| u[i] * v[n + i] - u[n + i] * v[i]).sum::<f64>()
    };
    let mut defect = 0.0_f64;
    for (u, after_u) in directions.iter().zip(images) {
        for (v, after_v) in directions.iter().zip(images) {
            defect = defect.max((form(after_u, after_v) - form(u, v)).abs());
        }
    }
    defect
}

/// Returns the distance of ds − p dq from a multiple of its value before, for displacements in `directions`. The last direction is that of s.
pub fn contact_defect_along(directions: &[Vec<f64>], images: &[Vec<f64>], before: &[f64], after: &[f64]) -> f64 {
    let n = before.len() / 2;
    let form = |p: &[f64], u: &[f64]| u[2 * n] - (0..n).map(|i| p[n + i] * u[i]).sum::<f64>();
    let factor = images.last().map_or(f64::NAN, |image| form(after, image));
    let pairs = directions.iter().zip(images);
    pairs.map(|(u, image)| (form(after, image) - factor * form(before, u)).abs()).fold(0.0, f64::max)
}

/// Returns the distance of ds − p dq from a multiple of its value before, for all unit vectors as directions.
pub fn contact_defect(images: &[Vec<f64>], before: &[f64], after: &[f64]) -> f64 {
    let n = before.len() / 2;
    let form = |p: &[f64], u: &[f64]| u[2 * n] - (0..n).map(|i| p[n + i] * u[i]).sum::<f64>();
    let forms: Vec<f64> = images.iter().map(|image| form(after, image)).collect();
    let factor = forms[2 * n];
    let was = |j: usize| if j < n { -before[n + j] } else { 0.0 };
    (0..2 * n).map(|j| (forms[j] - factor * was(j)).abs()).fold(0.0, f64::max)
}

/// max |M S Mᵀ − S'| with the structure matrices before and after, for all unit vectors as directions.
pub fn poisson_defect(images: &[Vec<f64>], before: &[Vec<f64>], after: &[Vec<f64>]) -> f64 {
    let n = images.len();
    let carried = |i: usize, j: usize| -> f64 {
        (0..n).flat_map(|k| (0..n).map(move |l| (k, l))).map(|(k, l)| images[k][i] * before[k][l] * images[l][j]).sum()
    };
    let pairs = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
    pairs.map(|(i, j)| (carried(i, j) - after[i][j]).abs()).fold(0.0, f64::max)
}
