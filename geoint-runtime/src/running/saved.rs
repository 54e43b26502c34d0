//! Saves runs, and resumes them bit for bit.

use super::Trajectory;
use super::pace::Pace;
use super::run::Run;
use crate::scalar::Real;
use crate::space::{Record, Tape};
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;

/// Version of the layout of [`Saved::words`]. It changes if a saved run of an earlier version could not be resumed.
pub const FORMAT: u32 = 9;

/// A saved run: all data that steps hand on to the next step, as words of bits.
///
/// System, method and tolerances are not included. The program that resumes a run builds a run of the same kind. This run then takes over time, step
/// size, state, the rounding errors of compensated sums, and the history of the method. With the feature `serde`, it can be
/// written and read in every format of serde. All words are integers, so no format rounds them.
///
/// # Words
///
/// A scalar is stored as its bits (`f64::to_bits`; those of `f32` in the lower half). An integer is stored as itself, a boolean as 0 or 1. An
/// optional value has a boolean before it. Five groups occur in all runs:
///
/// - **clock**: t₀ in two words, h, the number of steps of length h since t₀, and the time that a call requested, if it equals the present time up to
///   rounding;
/// - **origin**: all coordinates of the state that the user gave. Present if the method conserves invariants;
/// - **point**: all coordinates, the action, the rounding errors of both sums, the lead of time in two words, 0;
/// - **history**: the [`Record`](crate::space::Record) of the memory of the method;
/// - **events**: whether `until_event` found an event, the time of the last one, and a bit for each function that had an event then, in two words of
///   32 bits.
///
/// An [`Integrator`](crate::Integrator) has, in this order:
///
/// 1. the clock;
/// 2. the number of steps, its value when the user gave a state, and its value when the state was last set, by the user or at an event;
/// 3. whether the point is the inner point of the method (see [`Handling`](crate::method::Handling)), and the origin;
/// 4. point, history, events.
///
/// An [`Adaptive`](crate::Adaptive) run has:
///
/// 1. the clock;
/// 2. the number of steps, its value when the user gave a state, the number of rejected steps, and the origin;
/// 3. the point;
/// 4. the largest magnitude of each coordinate, the errors caused in it, and the longest time in which the state changes;
/// 5. the rung of the next step length, its direction, the last error, whether the last step was rejected, and the time in which the first state
///    changes;
/// 6. the length of the coefficients computed last, and the number and longest length of the steps with informative errors;
/// 7. the history of whole steps, that of halves, and the events.
///
/// A [`TaylorIntegrator`](crate::TaylorIntegrator) has:
///
/// 1. clock, point, history, and the unit of time of the coefficients, which are recomputed;
/// 2. the number of steps, and its value when the user gave a state;
/// 3. the direction, the largest magnitudes, and the length of the last step;
/// 4. the record of the changes of conditions (six words), and the events.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Saved {
    /// [`FORMAT`].
    pub format: u32,
    /// Name of the method.
    pub method: String,
    /// Number of bits of a scalar.
    pub bits: u32,
    /// All words.
    pub words: Vec<u64>,
}

/// Reason why a run cannot be resumed. The run that was to take over is unchanged.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ResumeError {
    /// The run was saved in this other format.
    Format(u32),
    /// The run has this other method.
    Method(String),
    /// The scalars of the run have this number of bits.
    Scalar(u32),
    /// The number of words differs, so the system or the kind of sums is another one.
    Words {
        /// Number of words of this run.
        expected: usize,
        /// Number of words that were saved.
        found: usize,
    },
    /// A number of the run, or the time that follows from its numbers, is not finite.
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

/// A scalar that can be stored as a word of bits.
pub trait Bits: Real {
    /// Number of bits.
    const BITS: u32;
    /// Returns the bits.
    fn to_word(self) -> u64;
    /// Returns the scalar with these bits.
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

/// A run that can be saved. All runs can, also `dyn Resumable<State = State<f64>>`, whose method is chosen at run time.
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
    /// Saves the present run. [`Saved`] describes the content.
    fn saved(&self) -> Saved;

    /// Continues from a saved run of the same system under the same method, with the same kind of sums. Time and a fixed step size are those of the
    /// saved run. Tolerances, bounds and the order of a Taylor series are those of this run. Its last step is not available for dense output.
    ///
    /// # Errors
    /// Fails if the saved run is of another kind. This run is then unchanged.
    fn resume(&mut self, saved: &Saved) -> Result<(), ResumeError>;
}

impl<P: Pace<Real: Bits>> Run<P> {
    /// Passes all data that change from step to step to `tape`.
    fn record(&mut self, tape: &mut impl Tape<P::Real>) {
        self.pace.record(tape);
        self.reported.record(tape);
    }
}

impl<P: Pace<Real: Bits>> Resumable for Run<P> {
    fn saved(&self) -> Saved {
        let mut words = Writer(Vec::new());
        self.clone().record(&mut words);
        Saved { format: FORMAT, method: self.pace.name().to_string(), bits: P::Real::BITS, words: words.0 }
    }

    fn resume(&mut self, saved: &Saved) -> Result<(), ResumeError> {
        let Saved { format, method, bits, words } = saved;
        if *format != FORMAT {
            return Err(ResumeError::Format(*format));
        }
        if self.pace.name() != **method {
            return Err(ResumeError::Method(method.clone()));
        }
        if *bits != P::Real::BITS {
            return Err(ResumeError::Scalar(*bits));
        }
        let mut resumed = self.clone();
        let mut reader = Reader { words, read: 0, finite: true };
        resumed.record(&mut reader);
        if reader.read != words.len() {
            return Err(ResumeError::Words { expected: reader.read, found: words.len() });
        }
        if !(reader.finite && resumed.pace.complete()) {
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

/// Reads words. After the last word, nothing is changed, but the count continues.
struct Reader<'a> {
    words: &'a [u64],
    read: usize,
    /// Whether all numbers so far are finite. After its first step, no run contains other numbers.
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
