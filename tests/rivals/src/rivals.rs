//! Other crates, each called as its documentation shows. All take the same field, whose momenta come after positions.

use crate::entry::{Entry, Whose};
use crate::field::Field;
use differential_equations::methods::SymplecticIntegrator;
use differential_equations::prelude::{ExplicitRungeKutta, IVP, ODE};
use diffsol::{NalgebraMat, OdeBuilder, OdeSolverMethod};
use nalgebra_of_ode_solvers::SVector;
use ode_solvers::{Dop853, OutputType};
use scirs2_integrate::ode::{ODEMethod, ODEOptions, solve_ivp};
use std::hint::black_box;
use std::marker::PhantomData;

/// A field for the traits of other crates.
struct Of<F>(PhantomData<F>);

impl<F: Field<N>, const N: usize> ode_solvers::System<f64, SVector<f64, N>> for Of<F> {
    fn system(&self, t: f64, y: &SVector<f64, N>, dy: &mut SVector<f64, N>) {
        F::rate(t, &y.data.0[0], &mut dy.data.0[0]);
    }
}

impl<F: Field<N>, const N: usize> ODE<f64, [f64; N]> for Of<F> {
    fn diff(&self, t: f64, y: &[f64; N], dy: &mut [f64; N]) {
        F::rate(t, y, dy);
    }
}

/// How much of a run is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    /// The end.
    End,
    /// All states that the crate gives back, which are those at the ends of its steps where it gives these.
    Steps,
}

impl Seen {
    fn of<const N: usize>(self, states: &[[f64; N]]) -> Option<Vec<f64>> {
        match self {
            Seen::End => states.last().map(|y| y.to_vec()),
            Seen::Steps => Some(states.as_flattened().to_vec()),
        }
    }
}

/// Rivals that take a field.
pub fn of_field<F: Field<N>, const N: usize>(field: F, duration: f64, seen: Seen) -> Vec<Entry> {
    let start = field.start();
    vec![
        Entry::tolerances(Whose::Rival, "ode_solvers", "ode_solvers Dop853", move |tolerance| {
            let y = SVector::<f64, N>::from(black_box(start));
            let mut stepper = Dop853::new(Of::<F>(PhantomData), 0.0, duration, duration, y, tolerance, tolerance);
            // The ends of steps. Of states at equal distances this version extrapolates the last one from the step that comes after the last but one,
            // far beyond its end.
            stepper.set_output(OutputType::Sparse);
            stepper.integrate().ok()?;
            let states: Vec<[f64; N]> = stepper.y_out().iter().map(|y| y.data.0[0]).collect();
            seen.of(&states)
        }),
        Entry::tolerances(Whose::Rival, "differential-equations", "differential-equations dop853", move |tolerance| {
            let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(10_000_000);
            let solution =
                IVP::ode(&Of::<F>(PhantomData), 0.0, duration, black_box(start)).method(method).solve().ok()?;
            seen.of(&solution.y)
        }),
        diffsol(slices::<F, N>, start.to_vec(), duration, seen),
        scirs(slices::<F, N>, start.to_vec(), duration, seen),
    ]
}

/// A field of slices. What takes any number of unknowns is compiled once for all problems.
type Rate = fn(f64, &[f64], &mut [f64]);

fn slices<F: Field<N>, const N: usize>(t: f64, y: &[f64], dy: &mut [f64]) {
    if let (Ok(y), Ok(dy)) = (y.try_into(), dy.try_into()) {
        F::rate(t, y, dy);
    }
}

fn diffsol(rate: Rate, start: Vec<f64>, duration: f64, seen: Seen) -> Entry {
    Entry::tolerances(Whose::Rival, "diffsol", "diffsol tsit45", move |tolerance| {
        let (begin, n) = (start.clone(), start.len());
        let problem = OdeBuilder::<NalgebraMat<f64>>::new()
            .rtol(tolerance)
            .atol(vec![tolerance; n])
            .rhs(move |x, _p, t, y| rate(t, x, y))
            .init(move |_p, _t, y| y.copy_from_slice(&begin), n)
            .build()
            .ok()?;
        let mut solver = problem.tsit45().ok()?;
        let (states, times, _) = solver.solve(duration).ok()?;
        let first = if seen == Seen::End { times.len() - 1 } else { 0 };
        Some((first..times.len()).flat_map(|k| (0..n).map(move |i| (i, k))).map(|place| states[place]).collect())
    })
}

fn scirs(rate: Rate, start: Vec<f64>, duration: f64, seen: Seen) -> Entry {
    Entry::tolerances(Whose::Rival, "scirs2-integrate", "scirs2-integrate DOP853", move |tolerance| {
        let options = ODEOptions {
            method: ODEMethod::DOP853,
            rtol: tolerance,
            atol: tolerance,
            max_steps: 10_000_000,
            ..ODEOptions::default()
        };
        let rate = move |t: f64, y: ndarray::ArrayView1<'_, f64>| {
            let mut dy = ndarray::Array1::zeros(y.len());
            if let (Some(y), Some(dy)) = (y.as_slice(), dy.as_slice_mut()) {
                rate(t, y, dy);
            }
            dy
        };
        let start = ndarray::Array1::from(black_box(&start).clone());
        let solution = solve_ivp(rate, [0.0, duration], start, Some(options)).ok()?;
        match seen {
            Seen::End => solution.y.last().map(|y| y.to_vec()),
            Seen::Steps => Some(solution.y.iter().flatten().copied().collect()),
        }
    })
}

/// Rivals for H = T(p) + V(q).
pub fn of_separable<F: Field<N>, const N: usize>(field: F, duration: f64, first: u64, seen: Seen) -> Vec<Entry> {
    let start = field.start();
    macro_rules! entry {
        ($name:literal, $method:ident) => {
            Entry::steps(
                Whose::Rival,
                "differential-equations",
                concat!("differential-equations ", $name),
                first,
                move |n| {
                    let method = SymplecticIntegrator::$method(duration / n as f64).max_steps(100_000_000);
                    let solution =
                        IVP::ode(&Of::<F>(PhantomData), 0.0, duration, black_box(start)).method(method).solve().ok()?;
                    seen.of(&solution.y)
                },
            )
        };
    }
    vec![entry!("velocity_verlet", velocity_verlet), entry!("ruth_forest", ruth_forest)]
}
