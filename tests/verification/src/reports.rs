//! Sentences of `REPORT` on systems and pieces, and the test behind each sentence.

use crate::page::Page;
use geoint_verification::project::Project;
use geoint_verification::sources;
use geoint_verification::statements::Names;

/// Words of a sentence in the source of the report, and a test by its folder and name. The test fails if the sentence is not true.
const SENTENCES: &[(&str, &str)] = &[
    ("kick and drift are exact flows", "tests/accuracy::every_problem"),
    ("H = T({p}) + V({q})", "geoint-macros/compiler/src/tests::separable_with_quadratic_t"),
    (
        "T is quadratic in {p} with a constant mass matrix",
        "geoint-macros/compiler/src/tests::separable_with_quadratic_t",
    ),
    ("T is not quadratic in {p}", "geoint-macros/compiler/src/tests::separable_but_not_quadratic"),
    ("not separable", "geoint-macros/compiler/src/tests::coupled_terms_are_named"),
    ("H is linear in {p}", "tests/contact::lifts_are_of_the_order_of_the_method"),
    ("a polynomial", "geoint-macros/compiler/src/tests::degrees"),
    ("T and V have exact flows", "geoint-macros/compiler/src/tests::separable_with_quadratic_t"),
    ("half of the unknowns of implicit methods", "tests/accuracy::every_problem"),
    ("prepared once", "geoint-macros/compiler/src/tests::early_values_are_computed_early"),
    ("they need a quadratic T", "tests/accuracy::nystrom_tables_lose_their_order_elsewhere"),
    ("Conserved by the flow", "geoint-macros/compiler/src/tests::linear_momenta_and_norms"),
    ("does not read", "geoint-macros/compiler/src/tests::coordinates_that_are_not_read_and_time"),
    ("all of that, to rounding", "tests/builds::discrete_gradient_keeps_energy_and_angular_momentum"),
    ("`FourthOrder(DiscreteGradient)` keep", "tests/builds::steps_of_order_4_keep_momenta"),
    ("as on a circle", "tests/builds::steps_of_order_4_follow_circles"),
    ("is exact: ", "tests/accuracy::energy_is_kept_where_the_mean_is_exact"),
    ("the equation is linear, its matrix inverted once", "tests/stability::linear_systems_are_solved_at_once"),
    ("in the order of half a step", "tests/pieces::one_degree_of_freedom"),
    (
        "- linear motion is one piece, beside which errors are as small as the rest is",
        "tests/pieces::linear_motion_is_one_piece",
    ),
    ("`BlanesMoanSrkn14a.of(PieceSplitting)`", "tests/pieces::methods_have_their_orders"),
    ("A + B, an exact flow and a kick", "tests/accuracy::tables_have_the_order_of_h_that_they_claim"),
    ("a step of order 2", "tests/planets::compositions_have_their_order"),
    ("with force gradients keep their order", "tests/accuracy::tables_have_the_order_of_h_that_they_claim"),
    ("H may jump where", "tests/stability::steps_of_one_length_end_where_the_energy_jumps"),
    ("the term jumps where the angle by `atan2` comes round", "tests/accuracy::an_energy_turns_with_its_angle"),
    // Bodies.
    ("H = T({momenta}) + V({places})", "tests/accuracy::a_drift_is_the_flow_of_a_free_body"),
    ("T is quadratic in {m}", "tests/accuracy::every_table_of_the_catalogue_has_its_order"),
    ("a gyrostat", "tests/accuracy::gyrostats_drift_exactly"),
    ("the length of {r}", "tests/accuracy::attitudes_are_normalised_after_the_same_steps"),
    ("drifts of centres of mass are straight", "tests/accuracy::arrays_of_bodies_with_centres"),
    // Constraints.
    ("a state starts with {start}", "tests/constraints::a_state_off_a_constraint_is_named"),
    ("volume in phase space is not kept in general", "tests/constraints::a_volume_is_wrong_for_the_sleigh"),
    ("{} stays constant", "tests/constraints::reports_say_what_is_bound"),
    ("no combination of two rows", "tests/constraints::reports_say_what_is_bound"),
    ("constraints hold to the error of the method", "tests/constraints::multipliers_are_forces"),
    ("momenta as unknowns", "tests/constraints::rattle"),
    ("no step is a contact map", "tests/lagrangian::forces_read_the_action"),
    ("F has a potential", "tests/lagrangian::forces_add_to_an_action"),
    // Contact systems.
    ("exact in time", "tests/contact::orders"),
    ("T + g·s + V", "tests/contact::forms"),
    ("Decaying by the factor", "tests/contact::angular_momentum_decays_with_the_form"),
    ("momenta are multiplied by one number", "tests/lagrangian::dissipated_momenta_decay_alike"),
    ("multiplies H by what its equation says", "tests/contact::the_law_of_decay"),
    ("the momenta of a lift are not followed", "tests/contact::stiff_oscillations_have_their_period"),
    ("s follows, and friction costs nothing", "tests/contact::orders"),
    ("no rule knows the flow", "geoint-macros/compiler/src/tests::terms_without_a_flow"),
    (
        "is the density of an invariant measure where H ≠ 0",
        "tests/statements::a_flow_keeps_the_measure_and_no_other_power",
    ),
    // Fields and structures.
    ("the density ρ is kept by the flow", "tests/statements::flows_keep_their_density_and_steps_to_their_order"),
    ("no energy has this field", "tests/accuracy::without_an_energy_the_report_says_why"),
    ("not proven to be the field of an energy", "tests/accuracy::without_an_energy_the_report_says_why"),
    ("canonical, ", "tests/accuracy::what_is_recovered_is_kept"),
    ("f = J ∇H/μ", "tests/accuracy::what_is_recovered_is_kept"),
    ("skew S", "tests/accuracy::fields_by_planes"),
    ("a Poisson structure", "tests/accuracy::claims"),
    ("kept, a Casimir", "tests/accuracy::tops_by_terms"),
    ("kept, found", "tests/accuracy::what_is_found_is_reported"),
    ("kept, the energy of the field", "tests/accuracy::what_is_recovered_is_kept"),
    ("kept, because S is skew", "tests/accuracy::euler_top"),
    ("kept, because L is skew and M ∇E = 0", "tests/statements::energy_is_kept_and_entropy_never_falls"),
    ("adds h ∇̄S·M ∇̄S ≥ 0 to the entropy", "tests/statements::energy_is_kept_and_entropy_never_falls"),
    ("with skew L and symmetric M", "tests/statements::the_report_names_both_laws"),
    ("constant as well, not listed", "tests/accuracy::what_is_found_is_reported"),
    ("{methods} keep {kept}, to rounding", "geoint-macros/compiler/src/tests::steps_keep_every_integral_to_rounding"),
    ("by h times the mean of b·∇I, to rounding", "tests/accuracy::what_a_drive_changes_is_known"),
    ("takes h ∇̄H·C ∇̄H off the energy", "tests/stability::energy_falls_by_what_is_dissipated"),
    ("keeps the energy to rounding, and every C", "tests/accuracy::euler_top"),
    ("`DiscreteGradient` keeps every C(x) of degree 2", "tests/accuracy::a_driven_top_stays_on_its_sphere"),
    ("Casimirs are kept to rounding", "tests/accuracy::tops_by_terms"),
    ("is kept to rounding, Casimirs", "tests/accuracy::more_than_three_coordinates_by_planes"),
    ("no structure is kept", "tests/accuracy::claims"),
    ("Jacobi's multiplier", "geoint-macros/compiler/src/tests::multipliers_of_jacobi_are_products_of_powers"),
    // Lagrangians.
    ("L is linear in the velocities", "tests/lagrangian::velocities_are_those_of_lagranges_equations"),
    ("no canonical coordinates", "tests/lagrangian::reports_say_what_was_found"),
    ("canonical coordinates: ", "tests/lagrangian::collocation_is_symplectic"),
    ("are those of canonical coordinates: symplectic", "tests/lagrangian::collocation_is_symplectic"),
    ("the mass matrix is negative definite", "tests/lagrangian::reports_say_what_is_unusual"),
    ("what is linear in velocities is d/dt f", "tests/lagrangian::derivatives_along_the_motion_are_named"),
    ("changes no motion", "tests/lagrangian::derivatives_along_the_motion_are_named"),
    (
        "`ImplicitMidpoint` and `Gauss` keep all momenta of these",
        "tests/lagrangian::angular_momenta_stay_under_gauss_methods",
    ),
    ("`DiscreteGradient` keeps all of these", "tests/lagrangian::sums_of_momenta_stay"),
    ("`DiscreteGradient` keeps all of these{but}", "tests/lagrangian::angular_momenta_stay_under_gauss_methods"),
    ("decay by one factor", "tests/lagrangian::dissipated_momenta_decay_alike"),
    ("neither quadratic nor of a known conjugate", "tests/lagrangian::other_powers_of_velocities"),
    ("L is quadratic, with a mass matrix", "geoint-macros/compiler/src/tests::energies_belong_to_lagrangians"),
    ("linear in {}", "geoint-macros/compiler/src/tests::energies_belong_to_lagrangians"),
    ("not T + V", "tests/lagrangian::the_energy_of_a_moving_frame_is_not_mechanical"),
    ("there is no discrete gradient", "tests/lagrangian::other_powers_of_velocities"),
    ("L by values only", "tests/statements::energies_without_a_formula_have_values"),
    // Damping and forces.
    ("{} that is not positive semidefinite", "tests/stability::parameters_that_feed_energy_are_refused"),
    ("falls by exactly h ∇̄H·C ∇̄H", "tests/stability::energy_falls_by_what_is_dissipated"),
    ("they add exactly h times that", "tests/lagrangian::forces_are_for_energies_too"),
    ("friction would feed energy is refused", "tests/lagrangian::friction_that_feeds_is_refused"),
    ("the discrete gradient keeps the whole energy", "tests/lagrangian::reports_say_what_forces_do"),
];

/// A sentence with one of these words claims something.
const WORDS: [&str; 24] = [
    "keep",
    "kept",
    "exact",
    "symplectic",
    "rounding",
    "order",
    "constant",
    "Poisson",
    "skew",
    "refuse",
    "follow",
    "quadratic",
    "polynomial",
    "canonical",
    "linear",
    "definite",
    "couple",
    "Conserved",
    "Decaying",
    "decay",
    "falls",
    "multipl",
    "no energy",
    "no rule",
];

/// Families of pieces, and the tests that compare their flows with differential equations.
const FLOWS: [&str; 2] = ["tests/contact/flows.rs", "tests/pieces/flows.rs"];

/// Writes the tables of sentences and of families of flows.
pub(crate) fn section(page: &mut Page) {
    page.section(
        2,
        "Reports",
        "Each sentence of `REPORT` that claims a property of a system has a test. The test fails if the sentence is not true.",
    );
    page.table(["sentence", "test"], SENTENCES.iter().map(|(words, test)| [shown(words), format!("`{test}`")]));
    let project = Project::here();
    let mut names = Names::of(&project);
    for (_, test) in SENTENCES {
        page.claim(names.is_test(test), format_args!("{test} is no test"));
    }
    let mut files = sources::below("geoint-macros/compiler/src/emit/report");
    files.push("geoint-macros/compiler/src/emit/domain.rs".into());
    let texts: Vec<(String, String)> = files.into_iter().map(|path| (sources::read(&path), path)).collect();
    for (words, _) in SENTENCES {
        page.claim(texts.iter().any(|(text, _)| text.contains(words)), format_args!("no report says “{words}”"));
    }
    for (text, path) in &texts {
        for said in literals(text).into_iter().filter(|said| WORDS.iter().any(|word| said.contains(word))) {
            // Names and single words are parts of sentences.
            let sentence = said.split_whitespace().count() > 2;
            let proven = SENTENCES.iter().any(|(words, _)| said.contains(words));
            page.claim(!sentence || proven, format_args!("“{said}”, of {path}, has no test"));
        }
    }
    for fault in names.faults(&sources::read("tests/STATEMENTS.md")) {
        page.claim(false, format_args!("tests/STATEMENTS.md: {fault}"));
    }
    flows(page);
}

fn flows(page: &mut Page) {
    page.section(
        3,
        "Families of flows in closed form",
        "Each flow is compared with the solution of its differential equation to twenty digits. The bounds of the errors are in units of the \
         condition of the flow. The table has the numbers of instances in the tests of contact systems and of canonical energies.",
    );
    let families = sources::read("geoint-macros/compiler/src/split/families/mod.rs");
    let tests = FLOWS.map(sources::read);
    let mut rows = vec![];
    for family in families.split("name: \"").skip(1) {
        let field = |name: &str| {
            let text = family.split_once(&format!("{name}: "))?.1;
            Some(
                text.strip_prefix('"')
                    .map_or_else(|| "as there".into(), |text| text.split('"').next().unwrap_or_default().to_owned()),
            )
        };
        let name = family.split('"').next().unwrap_or_default();
        let instances = tests.each_ref().map(|test| test.matches(&format!("\"{name}\"")).count());
        page.claim(instances.iter().sum::<usize>() > 0, format_args!("no flow of “{name}” is tested"));
        let energies = field("energies").unwrap_or_default();
        rows.push([name.to_owned(), format!("`{energies}`"), instances[0].to_string(), instances[1].to_string()]);
    }
    page.table(["family", "energies", "contact", "canonical"], rows);
}

/// Returns all texts between quotes in a source, without its tests.
fn literals(source: &str) -> Vec<String> {
    let code = source.split("#[cfg(test)]").next().unwrap_or_default();
    let mut found = vec![];
    // A text may continue in the next line.
    let joined = code.lines().map(str::trim_start).fold(String::new(), |text, line| match text.strip_suffix('\\') {
        Some(before) => format!("{before}{line}"),
        None if line.starts_with("//") => text,
        None => format!("{text}\n{line}"),
    });
    let mut rest = joined.as_str();
    while let Some((_, after)) = rest.split_once('"') {
        let Some((text, after)) = after.split_once('"') else { break };
        found.push(text.to_owned());
        rest = after;
    }
    found
}

/// Returns words with an ellipsis in place of inserted values.
fn shown(words: &str) -> String {
    let mut text = String::new();
    let mut rest = words.trim();
    while let Some((before, after)) = rest.split_once('{') {
        text += before;
        text += "…";
        rest = after.split_once('}').map_or("", |after| after.1);
    }
    text + rest
}
