//! Other crates, each called as its documentation shows.

use crate::entry::{Entry, Whose};
use crate::problems::Field;
use differential_equations::methods::SymplecticIntegrator;
use differential_equations::prelude::{ExplicitRungeKutta, Hamiltonian, IVP, ODE};
use diffsol::{NalgebraMat, OdeBuilder, OdeSolverMethod};
use nalgebra_of_ode_solvers::SVector;
use ode_solvers::dop853::Dop853;
use scirs2_integrate::ode::{ODEMethod, ODEOptions, solve_ivp};
use std::hint::black_box;

/// A field for the traits of other crates.
struct Of<F>(F);

impl<F: Field<N>, const N: usize> ode_solvers::System<f64, SVector<f64, N>> for Of<F> {
    fn system(&self, t: f64, y: &SVector<f64, N>, dy: &mut SVector<f64, N>) {
        self.0.rate(t, &y.data.0[0], &mut dy.data.0[0]);
    }
}

impl<F: Field<N>, const N: usize> ODE<f64, [f64; N]> for Of<F> {
    fn diff(&self, t: f64, y: &[f64; N], dy: &mut [f64; N]) {
        self.0.rate(t, y, dy);
    }
}

/// Rivals that take a field.
pub fn of_field<F: Field<N>, const N: usize>(field: F, duration: f64) -> Vec<Entry> {
    let start = field.start();
    vec![
        Entry::tolerances(Whose::Rival, "ode_solvers", "ode_solvers Dop853", move |tolerance| {
            let y = SVector::<f64, N>::from(black_box(start));
            let mut stepper = Dop853::new(Of(field), 0.0, duration, duration, y, tolerance, tolerance);
            stepper.integrate().ok()?;
            stepper.y_out().last().map(|y| y.as_slice().to_vec())
        }),
        Entry::tolerances(Whose::Rival, "differential-equations", "differential-equations dop853", move |tolerance| {
            let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(10_000_000);
            let solution = IVP::ode(&Of(field), 0.0, duration, black_box(start)).method(method).solve().ok()?;
            solution.y.last().map(|y| y.to_vec())
        }),
        Entry::tolerances(Whose::Rival, "diffsol", "diffsol tsit45", move |tolerance| {
            let problem = OdeBuilder::<NalgebraMat<f64>>::new()
                .rtol(tolerance)
                .atol([tolerance; N])
                .rhs(move |x, _p, t, y| {
                    let (mut now, mut rate) = ([0.0; N], [0.0; N]);
                    (0..N).for_each(|i| now[i] = x[i]);
                    field.rate(t, &now, &mut rate);
                    (0..N).for_each(|i| y[i] = rate[i]);
                })
                .init(move |_p, _t, y| (0..N).for_each(|i| y[i] = start[i]), N)
                .build()
                .ok()?;
            let mut solver = problem.tsit45().ok()?;
            let (states, times, _) = solver.solve(duration).ok()?;
            Some((0..N).map(|i| states[(i, times.len() - 1)]).collect())
        }),
        Entry::tolerances(Whose::Rival, "scirs2-integrate", "scirs2-integrate DOP853", move |tolerance| {
            let options = ODEOptions {
                method: ODEMethod::DOP853,
                rtol: tolerance,
                atol: tolerance,
                max_steps: 10_000_000,
                ..ODEOptions::default()
            };
            let rate = move |t: f64, y: ndarray::ArrayView1<'_, f64>| {
                let (mut now, mut rate) = ([0.0; N], [0.0; N]);
                now.iter_mut().zip(y.iter()).for_each(|(now, y)| *now = *y);
                field.rate(t, &now, &mut rate);
                ndarray::Array1::from(rate.to_vec())
            };
            let start = ndarray::Array1::from(black_box(start).to_vec());
            let solution = solve_ivp(rate, [0.0, duration], start, Some(options)).ok()?;
            solution.y.last().map(|y| y.to_vec())
        }),
    ]
}

/// Positions first, then momenta, q' a function of momenta and p' of positions.
struct Halves<F, const N: usize>(F);

impl<F: Field<N>, const N: usize> Hamiltonian<f64, Vec<f64>> for Halves<F, N> {
    fn velocity(&self, t: f64, q: &Vec<f64>, p: &Vec<f64>, dq: &mut Vec<f64>) {
        halves(&self.0, t, q, p, dq, 0);
    }
    fn force(&self, t: f64, q: &Vec<f64>, p: &Vec<f64>, dp: &mut Vec<f64>) {
        halves(&self.0, t, q, p, dp, N / 2);
    }
}

fn halves<F: Field<N>, const N: usize>(field: &F, t: f64, q: &[f64], p: &[f64], to: &mut [f64], from: usize) {
    let (mut now, mut rate) = ([0.0; N], [0.0; N]);
    now[..N / 2].copy_from_slice(q);
    now[N / 2..].copy_from_slice(p);
    field.rate(t, &now, &mut rate);
    to.copy_from_slice(&rate[from..from + N / 2]);
}

/// Rivals for H = T(p) + V(q).
pub fn of_separable<F: Field<N>, const N: usize>(field: F, duration: f64, first: u64) -> Vec<Entry> {
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
                    let system = Halves::<F, N>(field);
                    let start = black_box(start).to_vec();
                    let solution = IVP::hamiltonian(&system, 0.0, duration, start).method(method).solve().ok()?;
                    solution.y.last().cloned()
                },
            )
        };
    }
    vec![entry!("velocity_verlet", velocity_verlet), entry!("ruth_forest", ruth_forest)]
}
