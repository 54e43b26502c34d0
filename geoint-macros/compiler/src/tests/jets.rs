//! The number of sums in Taylor coefficients: as few as by hand.

use super::{expansion, lowered};
use crate::diff::jet::Rule;
use crate::diff::{self, by_velocities, jet};
use crate::ir::{Graph, Id, Symbol};
use crate::parse::Form;
use proc_macro2::TokenStream;
use quote::quote;

/// The number of sums in the Taylor coefficients, counted in halves. A square counts one half.
struct Sums {
    /// With ∂H/∂q as it is written.
    as_it_is: usize,
    /// With ∂H/∂q in velocities.
    by_velocities: Option<usize>,
}

fn sums(item: TokenStream, degrees: u32) -> Sums {
    let (_, mut lowered) = lowered(item);
    let graph = &mut lowered.graph;
    let gradient = diff::gradient(graph, lowered.terms.energy, degrees);
    let sums = |graph: &mut Graph, gradient: &diff::Gradient| {
        let forces: Vec<Id> = gradient.q.iter().map(|slope| graph.neg(*slope)).collect();
        let velocities = (0..).map(Symbol::Position).zip(gradient.p.iter().copied());
        let rates: Vec<_> = velocities.chain((0..).map(Symbol::Momentum).zip(forces)).collect();
        jet::jet(graph, &rates, &[]).half_convolutions()
    };
    let by_velocities = by_velocities::of_energy(graph, lowered.terms.energy, &gradient);
    Sums { as_it_is: sums(graph, &gradient), by_velocities: by_velocities.map(|gradient| sums(graph, &gradient)) }
}

/// sin and cos of three angles 12, sin² 1, p·cos of both momenta 4, velocities 4, v₁v₂ and its product with sin 4.
#[test]
fn the_double_pendulum_takes_as_few_sums_as_by_hand() {
    let pendulum = quote! {
        fn pendulum(q: [f64; 2], p: [f64; 2], m1: f64, m2: f64, l1: f64, l2: f64, g: f64) -> f64 {
            let (sin, cos) = (q[0] - q[1]).sin_cos();
            (m2 * l2 * l2 * p[0] * p[0] + (m1 + m2) * l1 * l1 * p[1] * p[1] - 2.0 * m2 * l1 * l2 * p[0] * p[1] * cos)
                / (2.0 * m2 * l1 * l1 * l2 * l2 * (m1 + m2 * sin * sin))
                - (m1 + m2) * g * l1 * q[0].cos() - m2 * g * l2 * q[1].cos()
        }
    };
    let Sums { as_it_is, by_velocities } = sums(pendulum, 2);
    assert_eq!(by_velocities, Some(25));
    assert!(as_it_is > 25);
}

/// The factors 2 and the masses stand in other places. The determinant is a multiple of the denominator.
#[test]
fn a_denominator_may_be_written_otherwise() {
    let pendulum = quote! {
        fn pendulum(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
            let c = (q[0] - q[1]).cos();
            (p[0] * p[0] / k + (m + k) * p[1] * p[1] / (k * k) - 2.0 * p[0] * p[1] * c / k) / (m / k + 1.0 - c * c)
                - q[0].cos() - q[1].cos()
        }
    };
    assert_eq!(sums(pendulum, 2).by_velocities, Some(25));
}

/// An arm of two links: sin and cos of three angles 12, cos² 1, momenta times M 6, velocities 4, v₁(v₁ + v₂) and its product with sin 4.
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
    let Sums { as_it_is, by_velocities } = sums(arm, 2);
    assert_eq!(by_velocities, Some(27));
    assert!(as_it_is > 27);
}

/// Polar coordinates: r² 1, the angular velocity w 2, w² 1, rw² 2. The spring adds sin and cos 4, r·sin 2.
#[test]
fn polar_coordinates_divide_by_the_square() {
    let spring = quote! {
        fn spring(q: [f64; 2], p: [f64; 2], m: f64, k: f64, l: f64, g: f64) -> f64 {
            (p[0] * p[0] + p[1] * p[1] / (q[0] * q[0])) / (2.0 * m) + k * (q[0] - l) * (q[0] - l) / 2.0
                - m * g * q[0] * q[1].cos()
        }
    };
    assert_eq!(sums(spring, 2).by_velocities, Some(12));
}

/// L is a number, as a momentum or as a parameter: r⁻¹ 2, r⁻² 1, r⁻³ 2.
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
    let Sums { as_it_is, by_velocities } = sums(kepler, 2);
    assert_eq!([Some(as_it_is), by_velocities, Some(sums(radial, 1).as_it_is)], [Some(5); 3]);
}

/// A bead on a parabola: q² 1, v 2, v² 1, qv² 2.
#[test]
fn a_mass_may_depend_on_the_position() {
    let bead = quote! {
        fn bead(q: f64, p: f64, m: f64, a: f64, g: f64) -> f64 {
            p * p / (2.0 * m * (1.0 + 4.0 * a * a * q * q)) + m * g * a * q * q
        }
    };
    let Sums { as_it_is, by_velocities } = sums(bead, 1);
    assert_eq!(by_velocities, Some(6));
    assert!(as_it_is > 6);
}

/// If no velocity is quadratic, or M is constant, there is one form.
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
    assert_eq!(sums(relativistic, 1).by_velocities, None);
    assert_eq!(sums(pendulum, 1).by_velocities, None);
}

/// Returns the energy of six bodies that attract each other.
fn bodies() -> TokenStream {
    attracting(quote!(-1.0 / square.sqrt()))
}

/// Returns an energy of six bodies with a pair energy, a function of the squared distance `square`.
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

/// The distances of six bodies in groups of four: one array for r⁻³, and one for the differences of positions along each axis.
#[test]
fn arrays_of_pairs_serve_all_sums() {
    let (_, mut lowered) = lowered(bodies());
    let graph = &mut lowered.graph;
    let gradient = diff::gradient(graph, lowered.terms.energy, 18);
    let forces: Vec<_> = gradient.q.iter().map(|slope| graph.neg(*slope)).collect();
    let rates: Vec<_> = (0..).map(Symbol::Momentum).zip(forces).collect();
    let packs = jet::Packs::of(&jet::jet(graph, &rates, &[])).expect("there are many sums");
    // Each of the 4 groups of 15 pairs has arrays for r², r⁻³ and three differences. It has sums for the three squares, three products, and powers.
    assert_eq!([packs.arrays.len(), packs.groups.len()], [4 * 5, 4 * 5]);
}

/// Returns the code emitted for an energy, without spaces.
fn emitted_by(form: Form, item: TokenStream) -> String {
    expansion(form, TokenStream::new(), item).split_whitespace().collect()
}

/// Returns the code emitted for a Hamiltonian, without spaces.
fn emitted(item: TokenStream) -> String {
    emitted_by(Form::Hamiltonian, item)
}

/// Central forces are computed for four pairs at once, also with softening. The code packs the differences of positions only, and has no other sums.
/// The powers include the masses, so the rates are sums and differences of the results.
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

/// Forces of two powers are not central forces.
fn repelling() -> TokenStream {
    attracting(quote!((1.0 / square - 1.0 / square.sqrt())))
}

/// Coefficients of a group are stored as packs: r⁻³ of four groups of pairs.
#[test]
fn coefficients_stay_in_their_lanes() {
    let emitted = emitted(repelling());
    assert_eq!(emitted.matches(".take(n,").count(), 0);
    assert!(emitted.matches("[n]=side").count() >= 4);
}

/// With few arrays, sums take the newest packs from registers. With many bodies, they load them.
#[test]
fn sums_of_few_arrays_take_the_newest_coefficients_from_registers() {
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

/// Of two powers of a distance, one is the product of its square and the other power. This product shares a sum with the other power, so no sum is
/// computed alone.
#[test]
fn of_two_powers_of_a_base_one_is_a_product() {
    let braked = quote! {
        fn braked(q: [f64; 2], p: [f64; 2], s: f64, alpha: f64) -> f64 {
            (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt() + alpha * s
        }
    };
    let emitted = emitted_by(Form::Contact, braked);
    let number = |what: &str| emitted.matches(what).count();
    assert_eq!([number("recurrence::power("), number("sum_of_power("), number("recurrence::sum(")], [1, 0, 0]);
}

/// Returns the number of squares in each sum of squares, sorted.
fn squares(item: TokenStream, degrees: u32) -> Vec<usize> {
    let (_, mut lowered) = lowered(item);
    let graph = &mut lowered.graph;
    let gradient = diff::gradient(graph, lowered.terms.energy, degrees);
    let rates: Vec<_> = (0..).map(Symbol::Momentum).zip(gradient.q.iter().copied()).collect();
    let program = jet::jet(graph, &rates, &[]);
    let number = |series: &jet::Series| match &series.rule {
        Rule::Squares(all) => Some(all.len()),
        _ => None,
    };
    let mut squares: Vec<usize> = program.series.iter().filter_map(number).collect();
    squares.sort_unstable();
    squares
}

/// The square of a distance is one sum. Other terms may stand beside it, and the squares may have a common factor.
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
