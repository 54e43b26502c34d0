//! The result that each example reproduces, and its source.

use crate::page::Page;
use geoint_verification::sources;
use std::fs;

/// Name of an example, its result, and the publication of the reference. Without a publication the program compares with its own formula.
const EXAMPLES: &[(&str, &str, &str)] = &[
    ("quickstart", "the energy of a pendulum stays", ""),
    (
        "outer_solar_system",
        "orbits and energy of the outer planets",
        "E. Hairer, C. Lubich & G. Wanner, *Geometric Numerical Integration* (2006), table I.2.2 and figure I.2.3",
    ),
    (
        "planets",
        "orbits of the outer planets against DOP853 with short steps",
        "E. Hairer et al., *Geometric Numerical Integration* (2006), table I.2.2; J. Wisdom & M. Holman, Astron. J. 102 (1991) 1528",
    ),
    (
        "fput",
        "the energy of one wave, nearly all of it back after 157 periods",
        "E. Fermi, J. Pasta & S. Ulam, Los Alamos report LA-1940 (1955), figure 1",
    ),
    (
        "mercury",
        "the advance of the perihelion of Mercury, 42.98″ in a century",
        "A. M. Nobili & I. W. Roxburgh, *Relativity in Celestial Mechanics and Astrometry* (1986) 105",
    ),
    ("double_pendulum", "observed orders of implicit methods", ""),
    (
        "to_rounding",
        "three bodies on the figure eight, forwards and back to the start",
        "A. Chenciner & R. Montgomery, Ann. Math. 152 (2000) 881",
    ),
    (
        "poincare",
        "Poincaré sections at three energies",
        "M. Hénon & C. Heiles, Astron. J. 69 (1964) 73, figures 4 to 6",
    ),
    ("bouncing", "times of impacts, a geometric series", ""),
    (
        "close_encounter",
        "the Pythagorean problem to its ejection",
        "C. Burrau, Astron. Nachr. 195 (1913) 113; V. Szebehely & C. F. Peters, Astron. J. 72 (1967) 876",
    ),
    ("saddle", "orbits at a saddle, by the complete scheme and by one without a term", ""),
    ("duffing", "a phase portrait with steps of a seventh of an orbit", ""),
    ("energy_exact", "energy kept to rounding over a million steps", ""),
    ("explicit_against_leapfrog", "a spring and a pendulum with steps of 0.2", ""),
    ("which_discrete_gradient", "orders of seventeen methods", ""),
    ("damped_duffing", "the lost energy is the work of friction", ""),
    (
        "damped_oscillator",
        "a splitting that is exact at any step, and a splitting into three pieces of order 2",
        "A. Bravetti et al., Celest. Mech. Dyn. Astr. 132 (2020) 7",
    ),
    (
        "contact_compared",
        "schemes for an oscillator with friction",
        "M. Vermeeren, A. Bravetti & M. Seri, J. Phys. A 52 (2019) 445206",
    ),
    (
        "driven_oscillator",
        "a periodic solution that draws others",
        "M. Vermeeren, A. Bravetti & M. Seri, J. Phys. A 52 (2019) 445206",
    ),
    (
        "perturbed_kepler",
        "the law of the angular momentum",
        "A. Bravetti et al., Celest. Mech. Dyn. Astr. 132 (2020) 7",
    ),
    (
        "lane_emden",
        "polytropes with known solutions",
        "S. Chandrasekhar, *An Introduction to the Study of Stellar Structure* (1939)",
    ),
    ("spin_orbit", "sections and a capture", "A. Bravetti et al., Celest. Mech. Dyn. Astr. 132 (2020) 7"),
    ("van_der_pol", "periods of a stiff oscillator", "F. Zadra, A. Bravetti & M. Seri, Mathematics 9 (2021) 1960"),
    ("cosmological_oscillator", "an invariant sphere and an invariant axis", ""),
    (
        "quadratic_dissipation",
        "friction that grows with the action",
        "M. Vermeeren, A. Bravetti & M. Seri, J. Phys. A 52 (2019) 445206",
    ),
    ("cooling", "1/H = 1/H₀ + k t", ""),
    (
        "sampling",
        "means with known densities, and a control that stays on a torus",
        "D. Tapias, A. Bravetti & D. Sanders, Comput. Methods Sci. Technol. 23 (2017) 11",
    ),
    ("descent", "the heavy ball, point by point", "B. Polyak, USSR Comput. Math. Math. Phys. 4 (1964) 1"),
    ("gradient_flow", "heights that fall at any step", ""),
    ("heat_bath", "total energy is kept, entropy grows", "M. Grmela & H. C. Öttinger, Phys. Rev. E 56 (1997) 6620"),
    (
        "piston",
        "energy is kept, entropy falls in no step; a state at t = 10",
        "M. Grmela & H. C. Öttinger, Phys. Rev. E 56 (1997) 6620",
    ),
    ("charged_particle", "drift velocity, against an integral over the gyration angle", ""),
    ("bottle", "height of reflection from the magnetic moment", ""),
    (
        "swinging_spring",
        "bouncing that turns into swinging, and back",
        "A. Vitt & G. Gorelik (1933); P. Lynch, Int. J. Nonlin. Mech. 37 (2002) 345",
    ),
    ("lotka_volterra", "a closed orbit over a hundred thousand periods", "V. Volterra, Nature 118 (1926) 558"),
    ("euler_top", "curves of the angular velocity at given energy and momentum", ""),
    (
        "from_field_to_energy",
        "the planar fields of chapters 2 to 4",
        "T. Aung, *Numerical ODE solvers that preserve first integrals*, MSc thesis, Rochester Institute of Technology (2000)",
    ),
    (
        "heavy_top",
        "four integrals of three tops",
        "S. Kovalevskaya, Acta Math. 12 (1889) 177; D. N. Goryachev (1900), S. A. Chaplygin (1901)",
    ),
    ("tumbling", "period of a tumbling body, by the elliptic integral K(k)", ""),
    (
        "vortices",
        "two pairs of vortices leap-frog above Love's ratio 3 − 2√2",
        "A. E. H. Love, Proc. London Math. Soc. 25 (1893) 185",
    ),
    ("epidemic", "the final size", "W. O. Kermack & A. G. McKendrick, Proc. R. Soc. Lond. A 115 (1927) 700"),
    ("lagrangian", "a double pendulum moves as by its energy", ""),
    ("rotating_hoop", "equilibrium of a bead, cos q = g/(rΩ²)", ""),
    ("four_bar", "the curve of a coupler", ""),
    ("crank", "the joint of a driven linkage by geometry", ""),
    ("sleigh", "the turn π√(1 + I/(ma²)) of a sleigh", "S. A. Chaplygin, Mat. Sb. 28 (1912) 303"),
    (
        "rolling",
        "a disk on a slope, a ball on a turning table",
        "A. M. Bloch, *Nonholonomic Mechanics and Control* (2003)",
    ),
    ("brachistochrone", "a cycloid", "Joh. Bernoulli, Acta Eruditorum (1697)"),
    ("relativistic", "periods by a quadrature", ""),
    ("acrobot", "energy errors of RK4 in steps of 0.2 s", "the acrobot of Gymnasium"),
    ("robot_arm", "the balance of energy of six links", ""),
    ("herglotz", "orders of contact methods", "G. Herglotz (1930)"),
    ("degenerate", "a Lagrangian that is linear in velocities; a guiding centre", ""),
];

/// Writes the table of examples. Fails if a program has no row, or if a figure belongs to no example.
pub(crate) fn section(page: &mut Page) {
    page.section(
        2,
        "Examples",
        "Every example prints claims, and fails if a claim does not hold. The last column has the number of claims in its source. `.ci/examples` \
         runs all examples and compares the figures.",
    );
    let figures: Vec<String> = fs::read_dir(sources::root().join("examples/figures"))
        .map(|folder| folder.flatten().map(|file| file.file_name().to_string_lossy().into_owned()).collect())
        .unwrap_or_default();
    let programs = sources::below("examples/src/bin");
    let name =
        |path: &str| path.rsplit('/').next().map(|file| file.trim_end_matches(".rs").to_owned()).unwrap_or_default();
    for path in &programs {
        page.claim(EXAMPLES.iter().any(|row| row.0 == name(path)), format_args!("{path} has no row"));
    }
    let rows = EXAMPLES.iter().map(|(example, what, source)| {
        let path = format!("examples/src/bin/{example}.rs");
        let claims = sources::read(&path).matches("claim(").count();
        let mut drawn: Vec<_> = figures.iter().filter(|file| belongs(file, example)).collect();
        drawn.sort();
        let drawn =
            drawn.iter().map(|file| format!("[{file}](examples/figures/{file})")).collect::<Vec<_>>().join(", ");
        let source = if source.is_empty() { "formulas in the program" } else { source };
        [format!("[`{example}`]({path})"), (*what).into(), source.into(), drawn, claims.to_string()]
    });
    let rows: Vec<_> = rows.collect();
    page.table(["example", "reproduces", "source", "figures", "claims"], rows);
    for file in figures.iter().filter(|file| !EXAMPLES.iter().any(|row| belongs(file, row.0))) {
        page.claim(false, format_args!("the figure {file} belongs to no example"));
    }
}

/// Returns whether a figure belongs to an example. The example with the longest name that begins the name of the figure owns the figure.
fn belongs(file: &str, example: &str) -> bool {
    let stem = file.trim_end_matches(".svg");
    let begins = |name: &str| stem.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with('_'));
    begins(example) && !EXAMPLES.iter().any(|row| row.0.len() > example.len() && begins(row.0))
}
