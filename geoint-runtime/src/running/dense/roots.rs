//! The zero of a function that is known by evaluation alone, between points at which it has different signs.

use crate::running::StepError;

/// Where g(θ) = 0 between two points with values of different signs: the secant with an end that is kept twice counting half (Illinois).
/// M. Dowell & P. Jarratt, BIT 11 (1971) 168. Three to five evaluations in a step of a good method.
pub(super) fn illinois(
    [mut low, mut high]: [(f64, f64); 2],
    mut g: impl FnMut(f64) -> Result<f64, StepError>,
) -> Result<f64, StepError> {
    let (first, largest) = (low.1, low.1.abs().max(high.1.abs()));
    let mut kept = 0;
    for round in 0..100 {
        if high.0 - low.0 <= f64::EPSILON * high.0 {
            break;
        }
        let secant = low.0 + (high.0 - low.0) * low.1 / (low.1 - high.1);
        // Where a secant does not help the interval is halved.
        let inside = secant > low.0 && secant < high.0 && round < 40;
        let theta = if inside { secant } else { 0.5 * (low.0 + high.0) };
        if theta <= low.0 || theta >= high.0 {
            break;
        }
        let value = g(theta)?;
        if value == 0.0 {
            return Ok(theta);
        }
        if value * first > 0.0 {
            high.1 *= if kept == 1 { 0.5 } else { 1.0 };
            (low, kept) = ((theta, value), 1);
        } else {
            low.1 *= if kept == -1 { 0.5 } else { 1.0 };
            (high, kept) = ((theta, value), -1);
        }
        if value.abs() <= 4.0 * f64::EPSILON * largest {
            return Ok(theta);
        }
    }
    Ok(0.5 * (low.0 + high.0))
}
