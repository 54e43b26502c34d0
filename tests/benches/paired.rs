//! Time of one program in units of another, on a machine that others use as well.
//!
//! Both programs run by turns, in batches of the same number of steps. A batch ends before the scheduler of a busy machine is likely to
//! interrupt it. Each pair of batches gives a ratio, and the median of the ratios ignores disturbances of a minority of the batches. The order
//! within pairs alternates, so that a drift of the clock frequency cancels.

use std::hint::black_box;
use std::time::{Duration, Instant};

const ROUNDS: usize = 1501;
const BATCH: Duration = Duration::from_micros(300);

/// Takes a number of steps from a fixed start and returns the final state.
pub(crate) type Run = Box<dyn Fn(u64) -> Vec<f64>>;

/// Two programs that take steps of the same problem.
pub(crate) struct Pair {
    /// The problem and the method.
    pub(crate) name: String,
    /// The program that is measured.
    pub(crate) subject: Run,
    /// The program whose time is the unit.
    pub(crate) unit: Run,
}

/// The ratio subject / unit, and the time of a step.
pub(crate) struct Ratio {
    pub(crate) median: f64,
    /// The lower and the upper quartile of the ratios.
    #[allow(dead_code, reason = "the ledger prints medians only")]
    pub(crate) quartiles: [f64; 2],
    /// Median nanoseconds a step, of the subject and of the unit.
    pub(crate) nanoseconds: [f64; 2],
}

impl Pair {
    /// Returns the largest difference of both results after these steps, relative to the largest entry.
    pub(crate) fn difference(&self, steps: u64) -> f64 {
        let (a, b) = ((self.subject)(steps), (self.unit)(steps));
        assert_eq!(a.len(), b.len());
        let scale = b.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let differences = a.iter().zip(&b).map(|(a, b)| (a - b).abs() / scale);
        // `f64::max` would lose a NaN.
        differences.fold(0.0, |m, d| if d <= m { m } else { d })
    }

    pub(crate) fn ratio(&self) -> Ratio {
        let steps = steps_of_a_batch(&self.unit);
        time(&self.subject, steps);
        let (mut ratios, mut subjects, mut units) = (vec![], vec![], vec![]);
        for round in 0..ROUNDS {
            let (subject, unit) = if round % 2 == 0 {
                let subject = time(&self.subject, steps);
                (subject, time(&self.unit, steps))
            } else {
                let unit = time(&self.unit, steps);
                (time(&self.subject, steps), unit)
            };
            ratios.push(subject / unit);
            subjects.push(subject * 1e9 / steps as f64);
            units.push(unit * 1e9 / steps as f64);
        }
        for sample in [&mut ratios, &mut subjects, &mut units] {
            sample.sort_by(f64::total_cmp);
        }
        Ratio {
            median: ratios[ROUNDS / 2],
            quartiles: [ratios[ROUNDS / 4], ratios[3 * ROUNDS / 4]],
            nanoseconds: [subjects[ROUNDS / 2], units[ROUNDS / 2]],
        }
    }
}

/// Returns the median time of a step in nanoseconds, over runs of this length. Takes about 0.15 s.
#[allow(dead_code, reason = "the ablation alone times single runs")]
pub(crate) fn nanoseconds(run: &Run, steps: u64) -> f64 {
    let rounds = ((0.15 / time(run, steps)) as usize).clamp(11, 2001);
    let mut sample: Vec<f64> = (0..rounds).map(|_| time(run, steps) * 1e9 / steps as f64).collect();
    sample.sort_by(f64::total_cmp);
    sample[rounds / 2]
}

fn steps_of_a_batch(run: &Run) -> u64 {
    let mut steps = 64;
    loop {
        let seconds = time(run, steps);
        if seconds > 0.1 * BATCH.as_secs_f64() {
            return (steps as f64 * BATCH.as_secs_f64() / seconds) as u64;
        }
        steps *= 2;
    }
}

fn time(run: &Run, steps: u64) -> f64 {
    let start = Instant::now();
    black_box(run(black_box(steps)));
    start.elapsed().as_secs_f64()
}
