//! The tables themselves: every one is in the list of methods, is consistent, and meets conditions of its order.

use geoint_runtime::method::catalogue;
use geoint_runtime::methods::*;
use geoint_runtime::{Composition, Method, Splitting};
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::HenonHeiles;
use std::collections::BTreeSet;

struct Names(BTreeSet<String>);

impl Visitor<HenonHeiles, f64> for Names {
    fn visit<M: Method<HenonHeiles, f64> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        assert!(self.0.insert(name), "{} is visited twice", method.name());
    }
}

/// The list is complete: every constant that the runtime exports is visited, compositions with each symmetric map.
#[test]
fn the_list_of_methods_is_complete() {
    let mut names = Names(BTreeSet::new());
    methods::general(&mut names);
    methods::discrete_gradient(&mut names);
    methods::separable(&mut names);
    methods::nystrom(&mut names);
    methods::force_gradient(&mut names);
    methods::perturbed(&mut names);
    methods::perturbed_gradient(&mut names);
    methods::processed(&mut names);

    let mut tables = 0;
    let sources = [
        include_str!("../../geoint-runtime/src/method/tables/composition.rs"),
        include_str!("../../geoint-runtime/src/method/tables/force_gradient.rs"),
        include_str!("../../geoint-runtime/src/method/tables/near_integrable.rs"),
        include_str!("../../geoint-runtime/src/method/tables/nystrom.rs"),
        include_str!("../../geoint-runtime/src/method/tables/splitting.rs"),
    ];
    for line in sources.into_iter().flat_map(str::lines) {
        let Some((name, ty)) = line.strip_prefix("pub const ").and_then(|rest| rest.split_once(':')) else { continue };
        tables += 1;
        let expected = match ty.trim_start().starts_with("Composition") {
            true => ["StormerVerlet", "PositionVerlet", "ImplicitMidpoint", "DiscreteGradient"]
                .map(|map| format!("{name} of {map}"))
                .to_vec(),
            false => vec![name.to_string()],
        };
        for method in expected {
            assert!(names.0.contains(method.as_str()), "{method} is not in the list of methods");
        }
    }
    assert_eq!(tables, 39, "tables found in the source of the runtime");
    for stages in 1..=6 {
        assert!(names.0.contains(format!("Gauss<{stages}>").as_str()));
    }
    for line in include_str!("../../geoint-runtime/src/method/flows/verlet.rs").lines() {
        let name = line.strip_prefix("pub const ").or(line.strip_prefix("pub struct "));
        if let Some(name) = name.and_then(|rest| rest.split([':', ';']).next()) {
            // Rotations need a rigid body.
            assert!(name == "FiveRotations" || names.0.contains(name), "{name} is not in the list of methods");
        }
    }
}

/// Set of method names. A method with several parameters may repeat its name.
#[derive(Default)]
struct Walked(BTreeSet<String>);

impl Visitor<HenonHeiles, f64> for Walked {
    fn visit<M: Method<HenonHeiles, f64> + 'static>(&mut self, method: M) {
        self.0.insert(method.name().to_string());
    }
}

/// The tests visit the whole catalogue of the runtime, and more methods.
#[test]
fn tests_walk_the_whole_catalogue() {
    let (mut catalogued, mut walked) = (Walked::default(), Walked::default());
    catalogue::general(&mut catalogued);
    catalogue::separable(&mut catalogued);
    catalogue::quadratic_kinetic(&mut catalogued);
    catalogue::force_gradient(&mut catalogued);
    catalogue::perturbed(&mut catalogued);
    catalogue::perturbed_gradient(&mut catalogued);
    catalogue::processed(&mut catalogued);
    catalogue::processed_force_gradient(&mut catalogued);
    catalogue::discrete_gradient(&mut catalogued);
    catalogue::conservative(&mut catalogued);
    catalogue::autonomous(&mut catalogued);
    catalogue::cubic(&mut catalogued);
    methods::general(&mut walked);
    methods::separable(&mut walked);
    methods::nystrom(&mut walked);
    methods::force_gradient(&mut walked);
    methods::perturbed(&mut walked);
    methods::perturbed_gradient(&mut walked);
    methods::processed(&mut walked);
    methods::discrete_gradient(&mut walked);
    methods::itoh_abe(&mut walked);
    methods::itoh_abe_one_way(&mut walked);
    methods::coordinate_increment(&mut walked);
    methods::projected(&mut walked);
    methods::relaxed(&mut walked);
    methods::cubic(&mut walked);
    let missing: Vec<_> = catalogued.0.difference(&walked.0).collect();
    assert!(missing.is_empty() && walked.0.len() > catalogued.0.len(), "not tested: {missing:?}");
}

/// Σ γ = 1 and Σ γᵏ = 0 for odd k < order: conditions that hold for every symmetric composition.
#[test]
fn compositions_meet_their_power_sums() {
    fn check<const K: usize>(name: &str, composition: Composition<K>) {
        let weights = composition.weights();
        let size: f64 = weights.iter().map(|w| w.abs()).sum();
        let power = |k: i32| weights.iter().map(|w| w.powi(k)).sum::<f64>();
        assert!((power(1) - 1.0).abs() < 1e-15 * size, "{name}: Σγ − 1 = {:.1e}", power(1) - 1.0);
        // From order 4 on; to order 8 and 10 the same holds for k = 5, 7, 9.
        for k in (3..composition.order() as i32).step_by(2) {
            let size: f64 = weights.iter().map(|w| w.abs().powi(k)).sum();
            assert!(power(k).abs() < f64::from(k) * 2e-16 * size, "{name}: Σγ^{k} = {:.1e}", power(k));
        }
        assert!(weights.iter().eq(weights.iter().rev()), "{name} is not a palindrome");
    }
    check("Yoshida4", Yoshida4);
    check("Suzuki4", Suzuki4);
    check("McLachlan4", McLachlan4);
    check("Yoshida6a", Yoshida6a);
    check("McLachlan6_9", McLachlan6_9);
    check("KahanLi8_17a", KahanLi8_17a);
    check("SofroniouSpaletta10_35", SofroniouSpaletta10_35);
}

/// Kicks and drifts sum to 1 and meet the two conditions of order 3 in their palindromic form: Σ bᵢ cᵢ² = 1/3 and Σ aᵢ Bᵢ² = 1/3. Here c are the
/// drifts and B the kicks up to this point. The share of F·M⁻¹F is Σ aᵢ Bᵢ²/2 from drifts by momenta BᵢF, and −Σ g from force gradients. With force
/// gradients the second condition is Σ aᵢ Bᵢ² − 2 Σ g = 1/3.
#[test]
fn splittings_meet_their_conditions() {
    fn check<const K: usize, F>(name: &str, table: &Splitting<K, F>) {
        let kick_first = table.is_kick_first();
        // (kick, drift) pairs in order of application, padded with zeros.
        let (outer, last, inner) = table.coefficients();
        let ends = if kick_first && last != 0.0 { table.gradients()[0] } else { 0.0 };
        let gradients = table.gradients().iter().sum::<f64>() + ends;
        let mut flows: Vec<(bool, f64)> = vec![];
        for (x, y) in outer.iter().zip(inner) {
            flows.extend([(kick_first, *x), (!kick_first, *y)]);
        }
        flows.push((kick_first, last));
        let backwards: Vec<_> = flows.iter().rev().copied().collect();
        assert_eq!(flows, backwards, "{name} is not a palindrome");

        // Run on q'' = f with f constant, linear and quadratic in time: c is the drift so far.
        let (mut c, mut b) = (0.0, 0.0);
        let (mut kicks_c, mut kicks_cc, mut drifts_bb) = (0.0, 0.0, 0.0);
        for (is_kick, weight) in flows {
            if is_kick {
                kicks_c += weight * c;
                kicks_cc += weight * c * c;
                b += weight;
            } else {
                drifts_bb += weight * b * b;
                c += weight;
            }
        }
        let sums = [
            ("Σa", c, 1.0),
            ("Σb", b, 1.0),
            ("Σbc", kicks_c, 0.5),
            ("Σbc²", kicks_cc, 1.0 / 3.0),
            ("ΣaB² − 2Σg", drifts_bb - 2.0 * gradients, 1.0 / 3.0),
        ];
        for (what, sum, expected) in sums {
            assert!((sum - expected).abs() < 2e-15, "{name}: {what} − {expected} = {:.1e}", sum - expected);
        }
    }
    check("ForestRuth4", &ForestRuth4);
    check("PEFRL", &PEFRL);
    check("BlanesMoan4", &BlanesMoan4);
    check("BlanesMoan6", &BlanesMoan6);
    check("BlanesMoanSrkn6b", BlanesMoanSrkn6b.table());
    check("BlanesMoanSrkn11b", BlanesMoanSrkn11b.table());
    check("BlanesMoanSrkn14a", BlanesMoanSrkn14a.table());
    check("BceRkn17_8", BceRkn17_8.table());
    check("BceRkn19_8", BceRkn19_8.table());
    check("Chin4A", &Chin4A);
    check("Chin4B", &Chin4B);
    check("Chin4C", &Chin4C);
    check("Chin4D", &Chin4D);
    check("Omelyan4_4F2GV", &Omelyan4_4F2GV);
    check("Omelyan4_5F2GP", &Omelyan4_5F2GP);
    check("Omelyan6_5F3GP", &Omelyan6_5F3GP);
    check("Omelyan6_5F4GV", &Omelyan6_5F4GV);
    check("Omelyan8_11F11GP", &Omelyan8_11F11GP);
}

/// Closed forms, computed here.
#[test]
fn tables_with_a_closed_form() {
    let near = |a: f64, b: f64| assert!((a - b).abs() < 4e-16 * a.abs(), "{a} {b}");
    let triple = 1.0 / (2.0 - 2.0_f64.cbrt());
    near(Yoshida4.weights()[0], triple);
    near(Yoshida4.weights()[1], 1.0 - 2.0 * triple);
    let fractal = 1.0 / (4.0 - 4.0_f64.cbrt());
    near(Suzuki4.weights()[1], fractal);
    near(Suzuki4.weights()[2], 1.0 - 4.0 * fractal);
    let (outer, _, inner) = ForestRuth4.coefficients();
    near(outer[0], 0.5 * triple);
    near(outer[1], 0.5 * (1.0 - triple));
    near(inner[0], triple);
    near(Chin4A.gradients()[1], 1.0 / 72.0);
    near(Chin4B.coefficients().0[0], 0.5 - 0.5 / 3.0_f64.sqrt());
    near(Chin4B.gradients()[0], 1.0 / (48.0 * (2.0 + 3.0_f64.sqrt())));
    near(Chin4C.gradients()[1], 1.0 / 192.0);
    near(Chin4D.gradients()[1], 1.0 / 384.0);
    let (outer, _, inner) = Omelyan6_5F4GV.coefficients();
    near(outer[0], 1.0 / 12.0);
    near(inner[0], 0.5 + 0.5 / 5.0_f64.sqrt());
    near(inner[1], -1.0 / 5.0_f64.sqrt());
}
