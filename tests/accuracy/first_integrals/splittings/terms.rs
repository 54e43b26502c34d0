//! Splittings by the terms of H.

use super::*;

#[test]
fn euler_by_terms() {
    let (energy, momentum) =
        (EULER.energy(), |w: &[f64; 3]| (w[0].powi(2) + 4.0 * w[1].powi(2) + 9.0 * w[2].powi(2)) / 2.0);
    EULER.splits(PoissonSplitting, &[7.494e-4, 1.874e-4, 4.685e-5], &[(&momentum, None), (&energy, Some(4.0e-5))]);
    EULER.splits(
        Suzuki4.of(PoissonSplitting),
        &[7.448e-8, 4.665e-9, 2.917e-10],
        &[(&momentum, None), (&energy, Some(7.4e-9))],
    );
}

#[test]
fn tops_by_terms() {
    let length = |x: &[f64; 6]| x[3] * x[3] + x[4] * x[4] + x[5] * x[5];
    let vertical = |x: &[f64; 6]| x[0] * x[3] + x[1] * x[4] + x[2] * x[5];
    let tops = |top: &Motion<HeavyTop, 6>, row: &[f64], moves: f64| {
        let energy = top.energy();
        top.splits(PoissonSplitting, row, &[(&length, None), (&vertical, None), (&energy, Some(moves))]);
    };
    tops(&LAGRANGE, &[2.242e-3, 5.608e-4, 1.402e-4], 4.1e-3);
    tops(&KOVALEVSKAYA, &[4.258e-3, 1.066e-3, 2.666e-4], 7.5e-4);
    tops(&GORYACHEV, &[4.185e-3, 1.048e-3, 2.620e-4], 8.1e-4);
    let (energy, spin) = (LAGRANGE.energy(), |x: &[f64; 6]| x[2]);
    LAGRANGE.splits(PoissonSplitting, &[2.242e-3], &[(&spin, Some(2.3e-3))]);
    LAGRANGE.splits(
        Suzuki4.of(PoissonSplitting),
        &[1.234e-6, 7.783e-8, 4.876e-9],
        &[(&length, None), (&vertical, None), (&energy, Some(1.7e-6))],
    );
}

#[test]
fn species_by_terms() {
    let sum = VOLTERRA.energy();
    VOLTERRA.splits(PoissonSplitting, &[1.545e-3, 3.855e-4, 9.632e-5], &[(&odd, None), (&sum, Some(1.3e-3))]);
    VOLTERRA.splits(
        Suzuki4.of(PoissonSplitting),
        &[3.841e-7, 2.404e-8, 1.503e-9],
        &[(&odd, None), (&sum, Some(4.2e-7))],
    );
    let wealth = PREDATORS.energy();
    PREDATORS.splits(PoissonSplitting, &[3.565e-3, 8.839e-4, 2.205e-4], &[(&wealth, Some(9.1e-3))]);
    PREDATORS.splits(Suzuki4.of(PoissonSplitting), &[7.891e-6, 4.973e-7, 3.115e-8], &[(&wealth, Some(3.1e-5))]);
}

#[test]
fn sites_by_terms() {
    let (energy, norm) =
        (WAVES.energy(), |x: &[f64; 8]| (0..4).map(|i| (1.0 + x[i] * x[i] + x[4 + i] * x[4 + i]).ln()).sum::<f64>());
    WAVES.splits(PoissonSplitting, &[1.456e-3, 3.641e-4, 9.102e-5], &[(&energy, Some(2.7e-4)), (&norm, Some(1.7e-3))]);
    WAVES.splits(Suzuki4.of(PoissonSplitting), &[2.643e-7, 1.657e-8, 1.037e-9], &[(&energy, Some(3.7e-8))]);
}

#[test]
fn vortices_by_pairs() {
    let gamma = VORTICES.system.gamma;
    let energy = VORTICES.energy();
    let across = |x: &[f64; 8]| (0..4).map(|i| gamma[i] * x[i]).sum::<f64>();
    let along = |x: &[f64; 8]| (0..4).map(|i| gamma[i] * x[4 + i]).sum::<f64>();
    VORTICES.splits(
        PoissonSplitting,
        &[1.459e-2, 3.696e-3, 9.273e-4],
        &[(&across, None), (&along, None), (&energy, Some(1.4e-2))],
    );
    VORTICES.splits(Suzuki4.of(PoissonSplitting), &[5.193e-6, 3.257e-7, 2.038e-8], &[(&energy, Some(1.9e-5))]);
}
