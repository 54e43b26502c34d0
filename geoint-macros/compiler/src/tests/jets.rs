//! How many sums of series a coefficient takes: as few as by hand.

use super::lowered;
use crate::attribute;
use crate::diff::jet::Rule;
use crate::diff::{self, by_velocities, jet};
use crate::ir::{Graph, Id, Symbol};
use crate::parse::Form;
use proc_macro2::TokenStream;
use quote::quote;

/// Sums in halves, a square is one: of ∂H/∂q as it is, and in velocities.
fn sums(item: TokenStream, degrees: u32) -> (usize, Option<usize>) {
    let (_, mut lowered) = lowered(item);
    let graph = &mut lowered.graph;
    let gradient = diff::gradient(graph, lowered.energy, degrees);
    let sums = |graph: &mut Graph, gradient: &diff::Gradient| {
        let forces: Vec<Id> = gradient.q.iter().map(|slope| graph.neg(*slope)).collect();
        let velocities = (0..).map(Symbol::Position).zip(gradient.p.iter().copied());
        let rates: Vec<_> = velocities.chain((0..).map(Symbol::Momentum).zip(forces)).collect();
        jet::jet(graph, &rates, &[]).half_convolutions()
    };
    let by_velocities = by_velocities::of_energy(graph, lowered.energy, &gradient);
    (sums(graph, &gradient), by_velocities.map(|gradient| sums(graph, &gradient)))
}

/// sin and cos of three angles 12, sin² 1, p·cos of both momenta 4, velocities 4, v₁v₂ and that times sin 4.
#[test]
fn the_double_pendulum_takes_as_many_as_by_hand() {
    let pendulum = quote! {
        fn pendulum(q: [f64; 2], p: [f64; 2], m1: f64, m2: f64, l1: f64, l2: f64, g: f64) -> f64 {
            let (sin, cos) = (q[0] - q[1]).sin_cos();
            (m2 * l2 * l2 * p[0] * p[0] + (m1 + m2) * l1 * l1 * p[1] * p[1] - 2.0 * m2 * l1 * l2 * p[0] * p[1] * cos)
                / (2.0 * m2 * l1 * l1 * l2 * l2 * (m1 + m2 * sin * sin))
                - (m1 + m2) * g * l1 * q[0].cos() - m2 * g * l2 * q[1].cos()
        }
    };
    let (as_it_is, by_velocities) = sums(pendulum, 2);
    assert_eq!(by_velocities, Some(25));
    assert!(as_it_is > 25);
}

/// The same with what 2 and masses divide taken to other places: the determinant is a multiple of the denominator.
#[test]
fn a_denominator_may_be_written_otherwise() {
    let pendulum = quote! {
        fn pendulum(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
            let c = (q[0] - q[1]).cos();
            (p[0] * p[0] / k + (m + k) * p[1] * p[1] / (k * k) - 2.0 * p[0] * p[1] * c / k) / (m / k + 1.0 - c * c)
                - q[0].cos() - q[1].cos()
        }
    };
    assert_eq!(sums(pendulum, 2).1, Some(25));
}

/// An arm of two links: sin and cos of three angles 12, cos² 1, momenta times M 6, velocities 4, v₁(v₁ + v₂) and that times sin 4.
#[test]
fn an_arm_has_common_factors() {
    let arm = quote! {
        fn arm(q: [f64; 2], p: [f64; 2], a: f64, b: f64, c: f64, g: f64) -> f64 {
            let cos = q[1].cos();
            (b * p[0] * p[0] - 2.0 * (b + c * cos) * p[0] * p[1] + (a + 2.0 * c * cos) * p[1] * p[1])
                / (2.0 * (a * b - b * b - c * c * cos * cos))
                + g * (2.0 * q[0].sin() + (q[0] + q[1]).sin())
        }
    };
    let (as_it_is, by_velocities) = sums(arm, 2);
    assert_eq!(by_velocities, Some(27));
    assert!(as_it_is > 27);
}

/// In polar coordinates: r² 1, the angular velocity w 2, w² 1, rw² 2; and of the spring sin and cos 4, r·sin 2.
#[test]
fn polar_coordinates_divide_by_the_square() {
    let spring = quote! {
        fn spring(q: [f64; 2], p: [f64; 2], m: f64, k: f64, l: f64, g: f64) -> f64 {
            (p[0] * p[0] + p[1] * p[1] / (q[0] * q[0])) / (2.0 * m) + k * (q[0] - l) * (q[0] - l) / 2.0
                - m * g * q[0] * q[1].cos()
        }
    };
    assert_eq!(sums(spring, 2).1, Some(12));
}

/// L is a number: r⁻¹ 2, r⁻² 1, r⁻³ 2; whether it is a momentum or a parameter.
#[test]
fn momenta_of_cyclic_coordinates_are_numbers() {
    let kepler = quote! {
        fn kepler(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
            p[0] * p[0] / (2.0 * m) + p[1] * p[1] / (2.0 * m * q[0] * q[0]) - m / q[0]
        }
    };
    let radial = quote! {
        fn radial(q: f64, p: f64, m: f64, l: f64) -> f64 {
            p * p / (2.0 * m) + l * l / (2.0 * m * q * q) - m / q
        }
    };
    let (as_it_is, by_velocities) = sums(kepler, 2);
    assert_eq!([Some(as_it_is), by_velocities, Some(sums(radial, 1).0)], [Some(5); 3]);
}

/// A bead on a parabola: q² 1, v 2, v² 1, qv² 2.
#[test]
fn a_mass_may_depend_on_the_position() {
    let bead = quote! {
        fn bead(q: f64, p: f64, m: f64, a: f64, g: f64) -> f64 {
            p * p / (2.0 * m * (1.0 + 4.0 * a * a * q * q)) + m * g * a * q * q
        }
    };
    let (as_it_is, by_velocities) = sums(bead, 1);
    assert_eq!(by_velocities, Some(6));
    assert!(as_it_is > 6);
}

/// Where no velocity is quadratic, or M does not change, there is one form.
#[test]
fn other_energies_have_one_form() {
    let relativistic = quote! {
        fn relativistic(q: f64, p: f64) -> f64 {
            (1.0 + p * p / (1.0 + q * q)).sqrt()
        }
    };
    let pendulum = quote! {
        fn pendulum(q: f64, p: f64, m: f64) -> f64 {
            p * p / (2.0 * m) - q.cos()
        }
    };
    assert_eq!(sums(relativistic, 1).1, None);
    assert_eq!(sums(pendulum, 1).1, None);
}

/// Six bodies that attract each other.
fn bodies() -> TokenStream {
    attracting(quote!(-1.0 / square.sqrt()))
}

/// The same with an energy of two bodies by the square of their distance.
fn attracting(energy: TokenStream) -> TokenStream {
    quote! {
        fn bodies(q: [[f64; 3]; 6], p: [[f64; 3]; 6], m: [f64; 6]) -> f64 {
            let mut energy = 0.0;
            for i in 0..6 {
                energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1] + p[i][2] * p[i][2]) / (2.0 * m[i]);
                for j in 0..i {
                    let d = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                    let square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
                    energy += m[i] * m[j] * #energy;
                }
            }
            energy
        }
    }
}

/// The distances of six bodies in groups of four: r⁻³ for all, and differences of positions in the same lanes for each coordinate.
#[test]
fn arrays_of_pairs_serve_all_sums() {
    let (_, mut lowered) = lowered(bodies());
    let graph = &mut lowered.graph;
    let gradient = diff::gradient(graph, lowered.energy, 18);
    let forces: Vec<_> = gradient.q.iter().map(|slope| graph.neg(*slope)).collect();
    let rates: Vec<_> = (0..).map(Symbol::Momentum).zip(forces).collect();
    let lanes = jet::Packs::of(&jet::jet(graph, &rates, &[])).expect("there are many sums");
    // Of 15 pairs r², r⁻³ and three differences; the squares of three at once, products of three, and powers.
    assert_eq!([lanes.arrays.len(), lanes.groups.len()], [4 * 5, 4 * 5]);
}

/// What is emitted for an energy, without spaces.
fn emitted(item: TokenStream) -> String {
    attribute::expand(Form::Hamiltonian, TokenStream::new(), item).to_string().split_whitespace().collect()
}

/// Forces between bodies, four pairs at a time, also softened: nothing but the differences of positions is brought together, and nothing is summed
/// beside. The powers have the masses, and rates are sums and differences of what is read.
#[test]
fn forces_between_bodies_are_computed_as_one() {
    for energy in [bodies(), attracting(quote!(-1.0 / (square + 0.25).sqrt())), attracting(quote!(square.powf(1.7)))] {
        let emitted = emitted(energy);
        let number = |what: &str| emitted.matches(what).count();
        assert_eq!([number(".take(n,[["), number(".order(n);")], [4, 4]);
        assert_eq!([number("[n]=["), number("[n]=side"), number("recurrence::sum")], [0; 3]);
        assert_eq!(number("multiply_add(products"), 0);
    }
}

/// Bodies with forces of two powers, which are not computed as one.
fn repelling() -> TokenStream {
    attracting(quote!((1.0 / square - 1.0 / square.sqrt())))
}

/// Coefficients that follow from sums side by side go to their arrays as they are: r⁻³ of four groups of pairs.
#[test]
fn coefficients_stay_in_their_lanes() {
    let emitted = emitted(repelling());
    assert_eq!(emitted.matches(".take(n,").count(), 0);
    assert!(emitted.matches("[n]=side").count() >= 4);
}

/// Few arrays: sums take the newest coefficients as they were computed, and do not wait until they can be read side by side. Of many bodies they do not.
#[test]
fn sums_of_few_arrays_have_their_newest_coefficients_at_hand() {
    let double = emitted(quote! {
        fn double(q: [f64; 2], p: [f64; 2], g: f64) -> f64 {
            let (sin, cos) = (q[0] - q[1]).sin_cos();
            (p[0] * p[0] + 2.0 * p[1] * p[1] - 2.0 * p[0] * p[1] * cos) / (2.0 + 2.0 * sin * sin)
                - 2.0 * g * q[0].cos() - g * q[1].cos()
        }
    });
    let [at_hand, read] = ["recurrence::sum_with_newest(lanes", "recurrence::sum(lanes"]
        .map(|sum| [&double, &emitted(repelling())].map(|emitted| emitted.matches(sum).count()));
    assert_eq!([at_hand, [read[0]; 2]], [[3, 0], [0, 0]]);
    // The forces of 15 pairs have three products each.
    assert!(read[1] >= 3 * 4);
}

/// Of two powers of a distance one is the product of its square with the other, and the sum in that product is one that the other one has: beside as
/// many others that has two sums of products. Nothing is summed alone.
#[test]
fn of_two_powers_of_a_base_one_is_a_product() {
    let braked = quote! {
        fn braked(q: [f64; 2], p: [f64; 2], s: f64, alpha: f64) -> f64 {
            (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt() + alpha * s
        }
    };
    let emitted = attribute::expand(Form::Contact, TokenStream::new(), braked).to_string();
    let emitted: String = emitted.split_whitespace().collect();
    let number = |what: &str| emitted.matches(what).count();
    assert_eq!([number("recurrence::power("), number("sum_of_power("), number("recurrence::sum(")], [1, 0, 0]);
}

/// The numbers of series whose squares are summed, of all such sums.
fn squares(item: TokenStream, degrees: u32) -> Vec<usize> {
    let (_, mut lowered) = lowered(item);
    let graph = &mut lowered.graph;
    let gradient = diff::gradient(graph, lowered.energy, degrees);
    let rates: Vec<_> = (0..).map(Symbol::Momentum).zip(gradient.q.iter().copied()).collect();
    let program = jet::jet(graph, &rates, &[]);
    let mut squares: Vec<usize> = program
        .series
        .iter()
        .filter_map(|series| match &series.rule {
            Rule::Squares(all) => Some(all.len()),
            _ => None,
        })
        .collect();
    squares.sort_unstable();
    squares
}

/// The square of a distance is one sum, whatever stands beside it, also of a part of the squares and with another factor.
#[test]
fn a_sum_of_squares_is_one_sum() {
    let softened = quote! {
        fn softened(q: [f64; 3], p: [f64; 3], k: f64) -> f64 {
            k / (1.0 + q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt()
        }
    };
    assert_eq!(squares(softened, 3), [3]);
    let beside = quote! {
        fn beside(q: [f64; 3], p: [f64; 3], k: f64) -> f64 {
            k / (1.0 + 2.0 * q[0] * q[0] + 2.0 * q[1] * q[1] + q[2]).sqrt()
        }
    };
    assert_eq!(squares(beside, 3), [2]);
}

/// A square that two sums read is a series of its own.
#[test]
fn a_square_that_is_shared_is_computed_once() {
    let shared = quote! {
        fn shared(q: [f64; 3], p: [f64; 3]) -> f64 {
            (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt() + (1.0 + q[0] * q[0]).sqrt()
        }
    };
    assert_eq!(squares(shared, 3), [1, 2]);
}
