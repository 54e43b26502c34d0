//! Energy errors after 10, 10⁴ and 10⁷ periods: what a single error at the end does not show.
//!
//! A regular orbit of the galaxy of Hénon and Heiles; a period is 2π. Costs are measured one after the other over short runs; the long ones,
//! which would take too long, are spread over all processors and not timed.

use crate::field::Field;
use crate::problems::galaxy::{Galaxy, REGULAR, energy, energy_error};
use crate::systems::HenonHeiles;
use differential_equations::methods::SymplecticIntegrator;
use differential_equations::prelude::{ExplicitRungeKutta, IVP, ODE};
use geoint_runtime::TaylorIntegrator;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::scene::flat;
use indicatif::ProgressBar;
use nalgebra_of_ode_solvers::SVector;
use ode_solvers::{Dop853, OutputType};
use std::f64::consts::TAU;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// Numbers of periods after which energies are compared.
const MARKS: [u64; 3] = [10, 10_000, 10_000_000];
/// What a run to the next mark may take by what a period costs, in seconds: ten minutes are for all.
const LONGEST: f64 = 25.0;
/// In the last of them every state that a method has is looked at.
const SEEN: u64 = 5;
/// Periods of a run that is timed, and how many times.
const TIMED: (u64, usize) = (500, 5);
/// Runs of other crates are at most so long: they remember all of their steps.
const PIECE: u64 = 1000;

/// A method.
pub struct Long {
    /// What it is called.
    pub name: String,
    /// Steps a period, or a tolerance.
    pub effort: String,
    /// Nanoseconds a period.
    pub cost: f64,
    /// The largest relative error of the energy around each mark.
    pub errors: Vec<After>,
}

/// What is measured at a mark.
#[derive(Clone, Copy, Debug)]
pub enum After {
    /// The largest relative error of the energy.
    Error(f64),
    /// The method has refused a step.
    Refused,
    /// It would take too long.
    TooLong,
}

/// From a state over a number of periods: states of which the last is the end.
type Advance = Box<dyn FnMut(u64) -> Option<Vec<f64>>>;

struct Candidate {
    name: String,
    effort: String,
    start: Box<dyn Fn() -> Advance + Sync + Send>,
}

/// All methods.
pub fn measure(bar: &ProgressBar) -> Vec<Long> {
    let candidates = candidates();
    bar.set_message("costs");
    let mut costs = vec![f64::INFINITY; candidates.len()];
    for _ in 0..TIMED.1 {
        for (candidate, cost) in candidates.iter().zip(&mut costs) {
            let mut advance = (candidate.start)();
            let begin = Instant::now();
            advance(TIMED.0);
            *cost = cost.min(1e9 * begin.elapsed().as_secs_f64() / TIMED.0 as f64);
        }
    }
    bar.inc(1);
    bar.set_message("long runs");
    let (next, done) = (AtomicUsize::new(0), Mutex::new(vec![]));
    // The dearest first, so that none is waited for alone.
    let mut order: Vec<usize> = (0..candidates.len()).collect();
    order.sort_by(|a, b| costs[*b].total_cmp(&costs[*a]));
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                while let Some(i) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let errors = errors((candidates[*i].start)(), costs[*i]);
                    done.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).push((*i, errors));
                }
            });
        }
    });
    bar.inc(1);
    let mut done = done.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner());
    done.sort_by_key(|(i, _)| *i);
    candidates
        .into_iter()
        .zip(costs)
        .zip(done)
        .map(|((Candidate { name, effort, .. }, cost), (_, errors))| Long { name, effort, cost, errors })
        .collect()
}

fn errors(mut advance: Advance, cost: f64) -> Vec<After> {
    let start = energy(REGULAR.start());
    let mut periods = 0;
    let mut refused = false;
    MARKS
        .into_iter()
        .map(|mark| {
            if 1e-9 * cost * (mark - periods) as f64 > LONGEST {
                return After::TooLong;
            }
            refused = refused || advance(mark - SEEN - periods).is_none();
            periods = mark;
            // One period after the other: its states are many enough.
            let mut worst = 0.0_f64;
            for _ in 0..SEEN {
                if refused {
                    return After::Refused;
                }
                match advance(1) {
                    Some(states) => worst = worst.max(energy_error(&states, start)),
                    None => refused = true,
                }
            }
            if refused { After::Refused } else { After::Error(worst) }
        })
        .collect()
}

fn start() -> State<[f64; 2]> {
    let [x, y, u, v] = REGULAR.start();
    State::new([x, y], [u, v])
}

const SYSTEM: HenonHeiles = HenonHeiles { lambda: 1.0 };

/// Steps of one length: those of a single period are all seen.
fn fixed<M: Method<HenonHeiles> + Send + Sync + 'static>(method: M, steps: u64) -> Candidate {
    let begin = move || -> Advance {
        let mut sim = SYSTEM.integrator(method, TAU / steps as f64, start());
        Box::new(move |periods| {
            if periods > 1 {
                sim.advance(periods * steps).ok()?;
                return Some(vec![]);
            }
            let mut states = vec![];
            for _ in 0..steps {
                sim.step().ok()?;
                states.extend(flat(&sim.state()));
            }
            Some(states)
        })
    };
    Candidate {
        name: Method::<HenonHeiles>::name(&method).to_string(),
        effort: steps.to_string(),
        start: Box::new(begin),
    }
}

/// Our steps that adapt, at eight times a period.
macro_rules! adapting {
    ($name:expr, $tolerance:expr, $sim:expr) => {
        Candidate {
            name: $name.into(),
            effort: format!("{:.0e}", $tolerance),
            start: Box::new(move || {
                let mut sim = $sim;
                let mut done = 0;
                Box::new(move |periods| {
                    done += periods;
                    let mut states = vec![];
                    if periods > 1 {
                        sim.advance_to(TAU * done as f64).ok()?;
                        return Some(states);
                    }
                    for k in (0..8).rev() {
                        sim.advance_to(TAU * (done as f64 - f64::from(k) / 8.0)).ok()?;
                        states.extend(flat(&sim.state()));
                    }
                    Some(states)
                })
            }),
        }
    };
}

struct Of;

impl ODE<f64, [f64; 4]> for Of {
    fn diff(&self, t: f64, y: &[f64; 4], dy: &mut [f64; 4]) {
        Galaxy::rate(t, y, dy);
    }
}

impl ode_solvers::System<f64, SVector<f64, 4>> for Of {
    fn system(&self, t: f64, y: &SVector<f64, 4>, dy: &mut SVector<f64, 4>) {
        Galaxy::rate(t, &y.data.0[0], &mut dy.data.0[0]);
    }
}

/// Another crate, which goes from a state over a number of periods.
fn rival(
    name: &str,
    effort: String,
    run: impl Fn([f64; 4], u64) -> Option<Vec<[f64; 4]>> + Copy + Send + Sync + 'static,
) -> Candidate {
    let begin = move || -> Advance {
        let mut now = REGULAR.start();
        Box::new(move |periods| {
            let mut left = periods;
            loop {
                let piece = left.min(PIECE);
                let states = run(now, piece)?;
                now = *states.last()?;
                left -= piece;
                if left == 0 {
                    return Some(if periods > 1 { vec![] } else { states.as_flattened().to_vec() });
                }
            }
        })
    };
    Candidate { name: name.into(), effort, start: Box::new(begin) }
}

fn candidates() -> Vec<Candidate> {
    let mut all = vec![
        fixed(StormerVerlet, 40),
        fixed(StormerVerlet, 200),
        fixed(BlanesMoan4, 10),
        fixed(BlanesMoan4, 40),
        fixed(BlanesMoanSrkn14a, 4),
        fixed(BlanesMoanSrkn14a, 12),
        fixed(BceRkn17_8, 8),
        fixed(Rnia10_8_6, 4),
        fixed(Rnia10_8_6, 12),
        fixed(Gauss::<3>, 8),
        fixed(DiscreteGradient, 20),
        fixed(FourthOrder(DiscreteGradient), 10),
        adapting!("adaptive(DOP853)", 1e-6, SYSTEM.adaptive(DOP853, 1e-6, start())),
        adapting!("adaptive(DOP853)", 1e-12, SYSTEM.adaptive(DOP853, 1e-12, start())),
        adapting!("Taylor", 1e-6, TaylorIntegrator::new(SYSTEM, Taylor { tolerance: 1e-6 }, start())),
        adapting!("Taylor", 1e-16, TaylorIntegrator::new(SYSTEM, Taylor { tolerance: 1e-16 }, start())),
    ];
    for (name, steps, verlet) in
        [("differential-equations velocity_verlet", 40, true), ("differential-equations ruth_forest", 40, false)]
    {
        all.push(rival(name, steps.to_string(), move |start, periods| {
            let (h, end) = (TAU / f64::from(steps), TAU * periods as f64);
            let ivp = IVP::ode(&Of, 0.0, end, start);
            let solution = if verlet {
                ivp.method(SymplecticIntegrator::velocity_verlet(h).max_steps(usize::MAX)).solve()
            } else {
                ivp.method(SymplecticIntegrator::ruth_forest(h).max_steps(usize::MAX)).solve()
            };
            Some(solution.ok()?.y)
        }));
    }
    for tolerance in [1e-6, 1e-12] {
        all.push(rival("differential-equations dop853", format!("{tolerance:.0e}"), move |start, periods| {
            let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(usize::MAX);
            Some(IVP::ode(&Of, 0.0, TAU * periods as f64, start).method(method).solve().ok()?.y)
        }));
        all.push(rival("ode_solvers Dop853", format!("{tolerance:.0e}"), move |start, periods| {
            let end = TAU * periods as f64;
            let mut stepper = Dop853::new(Of, 0.0, end, end, SVector::from(start), tolerance, tolerance);
            // As in `rivals.rs`.
            stepper.set_output(OutputType::Sparse);
            stepper.integrate().ok()?;
            Some(stepper.y_out().iter().map(|y| y.data.0[0]).collect())
        }));
    }
    all
}
