//! Runs that are saved and go on elsewhere, bit for bit.

use super::Trajectory;
use crate::scalar::Real;
use crate::space::Tape;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;

/// The layout of [`Saved::words`]. It changes where a run of an earlier version could not go on.
pub const FORMAT: u32 = 9;

/// A run at a moment: what steps hand on to the next one, as words of bits.
///
/// System, method and tolerances are not part of it: the program that goes on makes a run of the same kind, which then takes over time, step
/// size, state, what its sums have lost, and what its method remembers. With the feature `serde` it is written and read in every
/// format; numbers are whole ones, so that no format rounds them.
///
/// # Words
///
/// A scalar is its bits (`f64::to_bits`; those of `f32` in the lower half), a whole number is itself, an answer is 0 or 1; what may be missing
/// has an answer before it. An [`Integrator`](crate::Integrator) has, in this order:
///
/// 1. t₀ in two words, h, the number of steps of length h since t₀, and the time that a call asked for, if it equals the present but for rounding;
/// 2. three numbers of steps: all; those before the user gave a state; those before the state was last set, by the user or at an event. Then whether the
///    point is in the coordinates of the method (see [`Method::INNER`](crate::Method::INNER)). Methods that keep invariants add all coordinates of
///    the state that the user gave;
/// 3. the point: all coordinates, the action, what the sums of both have lost, by how much time is ahead in two words, 0;
/// 4. the memory of the method: its [`Record`](crate::space::Record);
/// 5. whether `until_event` found an event, the time of the last one, and a bit for each function that had an event then, in two words of 32 bits.
///
/// An [`Adaptive`](crate::Adaptive) run has 1; steps taken, their number when the user gave a state, steps rejected, and the same coordinates; 3; the largest magnitude of each coordinate, errors
/// caused in it, and the longest time in which the state changes; the length of the next step by its rung, its direction, the last error, and
/// whether the last step was rejected; for which length the method was prepared last; 4 for whole steps and for halves; 5. A
/// [`TaylorIntegrator`](crate::TaylorIntegrator) has 1, 3, steps taken, their number when the user gave a state, the direction, largest magnitudes, the length of the last step, and
/// of those in a row that ended at conditions how many went nowhere, and 5; its coefficients are computed anew.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Saved {
    /// [`FORMAT`].
    pub format: u32,
    /// The name of the method.
    pub method: String,
    /// The bits of a scalar.
    pub bits: u32,
    /// All numbers.
    pub words: Vec<u64>,
}

/// Why a run can not go on from what was saved. It is then as it was.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ResumeError {
    /// It was saved in another format.
    Format(u32),
    /// It is that of another method.
    Method(String),
    /// Its scalars have so many bits.
    Scalar(u32),
    /// There are more or fewer words than this run has: the system is another one, or its sums are.
    Words {
        /// Of this run.
        expected: usize,
        /// That were saved.
        found: usize,
    },
    /// One of its numbers, or the time that follows from them, is not finite.
    NonFinite,
}

impl fmt::Display for ResumeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ResumeError::Format(format) => write!(f, "the run was saved in format {format}; this is {FORMAT}"),
            ResumeError::Method(name) => write!(f, "the run was one of {name}"),
            ResumeError::Scalar(bits) => write!(f, "the run had numbers of {bits} bits"),
            ResumeError::Words { expected, found } => {
                write!(
                    f,
                    "the run has {expected} numbers, not {found}: its system, or the kind of its sums, is another one"
                )
            }
            ResumeError::NonFinite => f.write_str("a number of the run, or its time, is not finite"),
        }
    }
}

impl core::error::Error for ResumeError {}

/// A scalar that is a word of bits.
pub trait Bits: Real {
    /// How many.
    const BITS: u32;
    /// The bits.
    fn to_word(self) -> u64;
    /// From bits.
    fn from_word(word: u64) -> Self;
}

impl Bits for f64 {
    const BITS: u32 = 64;
    fn to_word(self) -> u64 {
        self.to_bits()
    }
    fn from_word(word: u64) -> Self {
        f64::from_bits(word)
    }
}

impl Bits for f32 {
    const BITS: u32 = 32;
    fn to_word(self) -> u64 {
        u64::from(self.to_bits())
    }
    fn from_word(word: u64) -> Self {
        f32::from_bits(word as u32)
    }
}

/// A run that can be saved.
pub trait Recorded: Clone {
    type Real: Bits;
    /// The name of its method.
    fn name(&self) -> crate::method::Name;
    /// Shows everything that changes from step to step.
    fn record(&mut self, tape: &mut impl Tape<Self::Real>);
    /// What follows from that is computed anew; whether the state, the time too, is finite.
    fn complete(&mut self) -> bool;
}

/// A run that can be saved: all of them, also `dyn Resumable<State = State<f64>>`, whose method is chosen while the program runs.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// #[hamiltonian]
/// fn pendulum(q: f64, p: f64, g: f64) -> f64 {
///     p * p / 2.0 - g * q.cos()
/// }
///
/// let start = || Pendulum { g: 9.81 }.integrator(DiscreteGradient, 0.01, State::new(1.0, 0.0));
/// let mut sim = start();
/// sim.advance(1000)?;
/// let saved = sim.saved();
/// sim.advance(1000)?;
///
/// let mut other = start();
/// other.resume(&saved).expect("the same method, and the same system");
/// other.advance(1000)?;
/// assert_eq!(other.state(), sim.state());
/// # Ok::<(), StepError>(())
/// ```
#[doc(alias("checkpoint", "serialize"))]
pub trait Resumable: Trajectory {
    /// The run now, to go on from later: [`Saved`] says what it holds.
    fn saved(&self) -> Saved;

    /// Goes on from what was saved of a run of the same system under the same method, with the same kind of sums. Time and a fixed step size are
    /// those of that run; tolerances, bounds and the order of a Taylor series are those of this one, which knows no last step to look into.
    ///
    /// # Errors
    /// If this is another kind of run; nothing has changed then.
    fn resume(&mut self, saved: &Saved) -> Result<(), ResumeError>;
}

impl<T: Recorded + Trajectory> Resumable for T {
    fn saved(&self) -> Saved {
        let mut words = Writer(Vec::new());
        self.clone().record(&mut words);
        Saved { format: FORMAT, method: self.name().to_string(), bits: T::Real::BITS, words: words.0 }
    }

    fn resume(&mut self, saved: &Saved) -> Result<(), ResumeError> {
        let Saved { format, method, bits, words } = saved;
        if *format != FORMAT {
            return Err(ResumeError::Format(*format));
        }
        if self.name() != **method {
            return Err(ResumeError::Method(method.clone()));
        }
        if *bits != T::Real::BITS {
            return Err(ResumeError::Scalar(*bits));
        }
        let mut resumed = self.clone();
        let mut reader = Reader { words, read: 0, finite: true };
        resumed.record(&mut reader);
        if reader.read != words.len() {
            return Err(ResumeError::Words { expected: reader.read, found: words.len() });
        }
        if !(reader.finite && resumed.complete()) {
            return Err(ResumeError::NonFinite);
        }
        *self = resumed;
        Ok(())
    }
}

struct Writer(Vec<u64>);

impl<R: Bits> Tape<R> for Writer {
    fn scalar(&mut self, x: &mut R) {
        self.0.push(x.to_word());
    }
    fn count(&mut self, n: &mut u64) {
        self.0.push(*n);
    }
}

/// Where words have come to an end nothing is changed, and the count goes on.
struct Reader<'a> {
    words: &'a [u64],
    read: usize,
    /// Whether all numbers so far are: no run has others from its first step on.
    finite: bool,
}

impl Reader<'_> {
    fn next(&mut self) -> Option<u64> {
        self.read += 1;
        self.words.get(self.read - 1).copied()
    }
}

impl<R: Bits> Tape<R> for Reader<'_> {
    fn scalar(&mut self, x: &mut R) {
        if let Some(word) = self.next() {
            *x = R::from_word(word);
            self.finite &= x.magnitude() < f64::INFINITY;
        }
    }
    fn count(&mut self, n: &mut u64) {
        if let Some(word) = self.next() {
            *n = word;
        }
    }
    fn number(&mut self, x: &mut f64) {
        if let Some(word) = self.next() {
            *x = f64::from_bits(word);
            self.finite &= x.is_finite();
        }
    }
}
