//! Energies are recovered from their fields, and fields without an energy are refused.

use super::arrays;
use crate::analyze::identity;
use crate::analyze::liouville::{Logarithm, NoEnergy, antiderivative, energy};
use crate::diff::jacobian;
use crate::ir::Symbol;
use proc_macro2::TokenStream;
use quote::quote;

/// Recovers the energy from q' and p' of n degrees of freedom, and compares it with the expected energy.
fn recovered(n: usize, field: &TokenStream, expected: &TokenStream) -> Result<(), NoEnergy> {
    [Logarithm::OfNumber, Logarithm::OfMagnitude]
        .into_iter()
        .try_for_each(|logarithm| by(logarithm, n, field, expected))
}

fn by(logarithm: Logarithm, n: usize, field: &TokenStream, expected: &TokenStream) -> Result<(), NoEnergy> {
    let (mut graph, found) = arrays(2 * n, &quote!(let (q, p) = (x[0], x[#n]);), &[field, &quote!([#expected])]);
    let symbols = |range: std::ops::Range<usize>| range.map(|i| Symbol::Position(i as u32)).collect::<Vec<_>>();
    let (energy, _) = energy(&mut graph, &symbols(0..n), &symbols(n..2 * n), &found[0], logarithm)?;
    let difference = graph.sub(energy, found[1][0]);
    let verdict = identity(&mut graph, difference);
    assert!(verdict.is_zero(), "{field}: {verdict:?}");
    Ok(())
}

#[test]
fn energies_of_plane_fields_are_recovered() {
    let cases = [
        // The examples 2.2.2 to 2.2.7, 3.1.2, 4.1.1 and 4.1.2 of Aung's thesis.
        (quote!([q + p, q - p]), quote!(q * p + p * p / 2.0 - q * q / 2.0)),
        (quote!([q + 2.0 * p, q - p]), quote!(q * p + p * p - q * q / 2.0)),
        (quote!([q + 2.0 * p, q * q - p]), quote!(q * p + p * p - q.powi(3) / 3.0)),
        (quote!([q * t + 2.0 * p, q * q - p * t]), quote!(q * p * t + p * p - q.powi(3) / 3.0)),
        (quote!([-2.0 * p * q - 2.0 * q, p * p - 2.0 * q + 2.0 * p]), quote!(-p * p * q + q * q - 2.0 * p * q)),
        (
            quote!([-2.0 * p * q - 2.0 * q + p.exp(), p * p - 2.0 * q + 2.0 * p]),
            quote!(-p * p * q + q * q - 2.0 * p * q + p.exp()),
        ),
        (quote!([p, -q - q.powi(3)]), quote!(p * p / 2.0 + q * q / 2.0 + q.powi(4) / 4.0)),
        (quote!([p, -q]), quote!((p * p + q * q) / 2.0)),
        // Lotka–Volterra times its multiplier.
        (quote!([a / p - b, b - c / q]), quote!(a * p.ln() - b * p - b * q + c * q.ln())),
        (quote!([p / (a * b * b), -a * c * b * q.sin()]), quote!(p * p / (2.0 * a * b * b) - a * c * b * q.cos())),
        (quote!([p / (1.0 + p * p).sqrt(), -(2.0 * q).exp()]), quote!((1.0 + p * p).sqrt() + (2.0 * q).exp() / 2.0)),
        (
            quote!([p * (1.0 + q * q), -q * p * p - q * q * q.sin()]),
            quote!(p * p * (1.0 + q * q) / 2.0 - q * q * q.cos() + 2.0 * q * q.sin() + 2.0 * q.cos()),
        ),
        (quote!([2.0 * p * (p * p).cos(), q / (1.0 + q * q)]), quote!((p * p).sin() - (1.0 + q * q).ln() / 2.0)),
        // Powers of functions.
        (
            quote!([p.sin() * p.cos().powi(2), -q.cos() * q.sin().powi(3)]),
            quote!(q.sin().powi(4) / 4.0 - p.cos().powi(3) / 3.0),
        ),
        (quote!([p.sin() * p.cos(), -q.ln() / q]), quote!(q.ln().powi(2) / 2.0 - p.cos().powi(2) / 2.0)),
        (quote!([p.tanh(), -q.atan()]), quote!(p.cosh().ln() + q * q.atan() - (1.0 + q * q).ln() / 2.0)),
        // Angles in the plane of one coordinate and a constant.
        (
            quote!([1.0 / (p * p + 2.0 * p + 2.0), -3.0 / (4.0 + q * q)]),
            quote!((p + 1.0).atan() + 1.5 * (q / 2.0).atan()),
        ),
        (quote!([p, (2.0 - q) / (1.0 + q * q)]), quote!(p * p / 2.0 + (1.0 + q * q).ln() / 2.0 - 2.0 * q.atan())),
    ];
    for (field, energy) in &cases {
        assert_eq!(recovered(1, field, energy), Ok(()), "{field}");
    }
}

/// Example 2.2.7 of Aung's thesis: p' = −∂H/∂q alone gives H up to a function F(p). The other equation is not read.
#[test]
fn one_equation_gives_the_energy_but_for_a_function_of_momenta() {
    let arguments = quote!(let (q, p) = (x[0], x[1]););
    let arrays_of = [&quote!([p * p - 2.0 * q + 2.0 * p]), &quote!([-p * p * q + q * q - 2.0 * p * q, p.powi(3)])];
    let (mut graph, found) = arrays(2, &arguments, &arrays_of);
    let (force, [expected, of_momenta]) = (found[0][0], [found[1][0], found[1][1]]);
    let (q, p) = (Symbol::Position(0), Symbol::Position(1));
    let slope = graph.neg(force);
    let (energy, _) = antiderivative(&mut graph, &[q], &[slope], Logarithm::OfNumber).expect("an energy");
    let difference = graph.sub(energy, expected);
    assert!(identity(&mut graph, difference).is_zero());
    // Every F(p) leaves p' as it is and changes q'.
    let other = graph.add(energy, of_momenta);
    let slopes = jacobian(&mut graph, &[energy, other], &[q, p]);
    let [by_position, by_momentum] = [0, 1].map(|i| graph.sub(slopes[1][i], slopes[0][i]));
    assert!(identity(&mut graph, by_position).is_zero() && !identity(&mut graph, by_momentum).is_zero());
}

/// Angles around the origin, and around another point in other units. No energy is defined wherever the field is.
#[test]
fn angles_are_found_in_a_part_of_the_domain() {
    for (field, angle) in [
        (quote!([q / (q * q + p * p), p / (q * q + p * p)]), quote!((p / q).atan())),
        (
            quote!([(q - a) / ((q - a).powi(2) + 4.0 * p * p), p / ((q - a).powi(2) + 4.0 * p * p)]),
            quote!((2.0 * p / (q - a)).atan() / 2.0),
        ),
    ] {
        assert_eq!(by(Logarithm::OfNumber, 1, &field, &angle), Ok(()), "{field}");
        let everywhere = by(Logarithm::OfMagnitude, 1, &field, &angle);
        assert!(matches!(everywhere, Err(NoEnergy::NotElementary(Some(_), _))), "{field}: {everywhere:?}");
    }
}

#[test]
fn fields_without_an_energy_are_refused() {
    for field in [
        // Divergences 2 + t, −1/10 and a(1 − x) − c(1 − y).
        quote!([q * t - 2.0 * p, q + 2.0 * p]),
        quote!([p, -q - q.powi(3) - p / 10.0]),
        quote!([q * (a - b * p), p * (b * q - c)]),
    ] {
        assert!(matches!(recovered(1, &field, &quote!(0.0)), Err(NoEnergy::NotCanonical(..))), "{field}");
    }
}

/// The quotient of a force and its slope has no value where the slope is zero.
#[test]
fn forces_on_one_side_of_a_wall_are_not_divided_by_their_slopes() {
    let wall = quote!([p, if q > 0.0 { -q } else { 0.0 }]);
    assert!(matches!(recovered(1, &wall, &quote!(0.0)), Err(NoEnergy::NotElementary(Some(_), _))));
}

/// e^(−p²) has an antiderivative that is not elementary.
#[test]
fn what_has_no_antiderivative_stays_an_integral() {
    let gauss = quote!([(-p * p).exp(), -q]);
    let Err(NoEnergy::Integrals(open)) = recovered(1, &gauss, &quote!(0.0)) else { panic!("{gauss}") };
    assert_eq!((open.integrals.len(), open.integrals[0].1), (1, Symbol::Position(1)));
    assert!(open.elementary.is_some());
    // The energy is a single integral.
    let Err(NoEnergy::Integrals(open)) = recovered(1, &quote!([0.0, (q * q).sin()]), &quote!(0.0)) else { panic!() };
    assert_eq!((open.elementary, open.integrals[0].1), (None, Symbol::Position(0)));
    // The antiderivative would contain a root of an expression that may be negative.
    for open in [quote!([p, 1.0 / (q * q - 1.0)]), quote!([p, 1.0 / (a + q * q)]), quote!([p, 1.0 / (1.0 + q.powi(4))])]
    {
        assert!(matches!(recovered(1, &open, &quote!(0.0)), Err(NoEnergy::Integrals(_))), "{open}");
    }
    // The integrand reads both variables, so the line integral is not a sum over variables.
    let both = quote!([q * (-p * p * q * q).exp(), -p * (-p * p * q * q).exp()]);
    assert!(matches!(recovered(1, &both, &quote!(0.0)), Err(NoEnergy::NotElementary(Some(_), _))));
}

#[test]
fn with_more_degrees_of_freedom_the_divergence_is_not_enough() {
    let henon = quote!([x[2], x[3], -x[0] - 2.0 * x[0] * x[1], -x[1] - x[0] * x[0] + x[1] * x[1]]);
    let energy = quote! {
        (x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]) / 2.0 + x[0] * x[0] * x[1] - x[1].powi(3) / 3.0
    };
    assert_eq!(recovered(2, &henon, &energy), Ok(()));
    // A charge in a uniform field: products of sums, whose antiderivatives differ by squares of momenta.
    let charge = quote!([x[2] + a * x[1], x[3] - a * x[0], a * (x[3] - a * x[0]), -a * (x[2] + a * x[1])]);
    let energy = quote!(((x[2] + a * x[1]).powi(2) + (x[3] - a * x[0]).powi(2)) / 2.0);
    assert_eq!(recovered(2, &charge, &energy), Ok(()));
    // div f = 0, but there is no energy, because the force has a curl.
    let turning = quote!([x[2], x[3], -x[0] - x[1], -x[1] + x[0]]);
    let Err(NoEnergy::NotCanonical(pair, _)) = recovered(2, &turning, &quote!(0.0)) else { panic!("an energy") };
    assert_eq!(pair, [Symbol::Position(0), Symbol::Position(1)]);
    // Damping of one degree, gain of the other.
    let mixed = quote!([x[2], x[3], -x[0] - x[2], -x[1] + x[3]]);
    assert!(matches!(recovered(2, &mixed, &quote!(0.0)), Err(NoEnergy::NotCanonical(..))));
}
