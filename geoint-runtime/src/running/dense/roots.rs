//! Finds zeros of a function within a step, from values of the function only. The step extends from 0 to 1.

use crate::running::StepError;

/// Maximum number of rounds in which a parabola is followed to its extremum.
const ROUNDS: u32 = 8;

/// Distance from the step, in step lengths, at which a first estimate of an extremum is still followed. The first point lies outside of the step and
/// steps may be long, so the estimate is rough.
const ASIDE: f64 = 0.5;

/// Returns a zero of g(θ) between two points with values of different signs, by the Illinois method. This is the secant method with a bracket; the
/// value at an end that is kept twice is halved. M. Dowell & P. Jarratt, BIT 11 (1971) 168. In a step of a good method, three to five evaluations
/// suffice.
///
/// Returns `None` if |g| finally exceeds its values at both ends: this is a pole.
pub(super) fn illinois(
    [mut low, mut high]: [(f64, f64); 2],
    g: &mut impl FnMut(f64) -> Result<f64, StepError>,
) -> Result<Option<f64>, StepError> {
    let (first, largest) = (low.1, low.1.abs().max(high.1.abs()));
    let (mut kept, mut last) = (0, 0.0_f64);
    for round in 0..100 {
        if high.0 - low.0 <= f64::EPSILON * high.0 {
            break;
        }
        let secant = low.0 + (high.0 - low.0) * low.1 / (low.1 - high.1);
        // Bisect if the secant leaves the bracket, or after 40 rounds.
        let inside = secant > low.0 && secant < high.0 && round < 40;
        let theta = if inside { secant } else { 0.5 * (low.0 + high.0) };
        if theta <= low.0 || theta >= high.0 {
            break;
        }
        let value = g(theta)?;
        last = value.abs();
        if differ(value, first) {
            low.1 *= if kept == -1 { 0.5 } else { 1.0 };
            (high, kept) = ((theta, value), -1);
        } else if value != 0.0 {
            high.1 *= if kept == 1 { 0.5 } else { 1.0 };
            (low, kept) = ((theta, value), 1);
        }
        if last <= 4.0 * f64::EPSILON * largest {
            return Ok(Some(theta));
        }
    }
    Ok((last <= largest).then_some(0.5 * (low.0 + high.0)))
}

/// Returns whether two numbers have different signs. Their product could underflow to zero.
pub(super) fn differ(a: f64, b: f64) -> bool {
    a < 0.0 && b > 0.0 || a > 0.0 && b < 0.0
}

/// Searches a step whose ends have the same sign for a point with the other sign. Returns this point and the value there.
///
/// `before` is a third point, outside or inside of the step. The parabola through the three points shows whether there may be an extremum near zero
/// in the step. Without one, nothing is evaluated. Otherwise the extremum is refined with new values.
pub(super) fn excursion(
    before: (f64, f64),
    ends: [f64; 2],
    g: &mut impl FnMut(f64) -> Result<f64, StepError>,
) -> Result<Option<(f64, f64)>, StepError> {
    let side = ends[0].signum();
    let mut points = [before, (0.0, ends[0]), (1.0, ends[1])];
    for round in 0..ROUNDS {
        let Some((at, value)) = extremum(points) else { return Ok(None) };
        let nearest = ends[0].abs().min(ends[1].abs());
        let (beyond, far) = if round == 0 { (ASIDE, nearest) } else { (0.0, 0.25 * nearest) };
        // No extremum in the step, or an extremum that remains far from zero on the same side.
        if !(at > -beyond && at < 1.0 + beyond) || value * side > far {
            return Ok(None);
        }
        let at = if at > 0.0 && at < 1.0 { at } else { 0.5 };
        let there = (at, g(at)?);
        if differ(there.1, side) {
            return Ok(Some(there));
        }
        // Replace the point farthest from the extremum.
        let farthest =
            (0..3).max_by(|i, j| (points[*i].0 - at).abs().total_cmp(&(points[*j].0 - at).abs())).unwrap_or(0);
        if points.iter().any(|point| (point.0 - at).abs() < 1e-9) {
            return Ok(None);
        }
        points[farthest] = there;
    }
    Ok(None)
}

/// Returns the extremum of the parabola through three points, and its value.
fn extremum([a, b, c]: [(f64, f64); 3]) -> Option<(f64, f64)> {
    let first = (b.1 - a.1) / (b.0 - a.0);
    let second = ((c.1 - b.1) / (c.0 - b.0) - first) / (c.0 - a.0);
    let at = 0.5 * (a.0 + b.0) - 0.5 * first / second;
    let value = a.1 + (at - a.0) * (first + (at - b.0) * second);
    (at.is_finite() && value.is_finite()).then_some((at, value))
}
