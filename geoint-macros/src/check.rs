//! What the user asked for against what was proven.

pub(crate) mod wording;

use crate::analyze::{self, Damping, Flaw, Identity, Remainder, Split, Structure, Why};
use crate::derive::proof;
use crate::diagnostics::{Diagnostics, Result};
use crate::ir::{Graph, Id, Node, Symbol, print::Printer};
use crate::legendre::{self, Legendre, NoFriction};
use crate::lower::{Integral, Place};
use crate::messages::{COUPLED, DAMPED, FULL_MASS, NOT_QUADRATIC};
use crate::parse::{Energy, Form, Requirement, Role};
use crate::split::{Division, NoExactPart, Pieces};
use proc_macro2::Span;
use std::collections::HashMap;
use wording::{in_case, open, remains};

/// Reports damping that is none, and every requirement that does not hold, at the term that breaks it.
pub(crate) fn requests(
    energy: &Energy,
    structure: &Structure,
    graph: &Graph,
    places: &HashMap<Id, Place>,
    name: impl Fn(Symbol) -> String,
) -> Result<()> {
    let mut errors = Diagnostics::default();
    let printer = Printer::new(graph, name);
    if let Some(damping) = &structure.damping {
        flaw_of_damping(energy, damping, &printer, &mut errors);
    }
    for (requirement, span) in &energy.requirements {
        if structure.damping.is_some() {
            errors.at_place((*span, *span), DAMPED);
            continue;
        }
        let witness = match (requirement, &structure.split) {
            (_, Split::Coupled(term)) => Some((*term, COUPLED)),
            (Requirement::Separable, Split::Separable(_)) => None,
            (Requirement::QuadraticKinetic, Split::Separable(parts)) => {
                parts.not_quadratic.map(|term| (term, NOT_QUADRATIC))
            }
        };
        if let Some((term, why)) = witness {
            // A term may have been put together from several that were written.
            let place = places.get(&term).copied().unwrap_or((*span, *span));
            errors.at_place(place, format!("{why}: {}", printer.excerpt(term)));
        }
    }
    errors.or(())
}

/// Reports the term by which an energy is not that of rigid bodies.
pub(crate) fn bodies(
    energy: &Energy,
    found: std::result::Result<analyze::Bodies, (Id, &'static str)>,
    graph: &Graph,
    places: &HashMap<Id, Place>,
    name: impl Fn(Symbol) -> String,
) -> Result<analyze::Bodies> {
    found.map_err(|(term, why)| {
        let mut errors = Diagnostics::default();
        let span = energy.item.sig.ident.span();
        // A term may have been put together from several that were written.
        let place = places.get(&term).copied().unwrap_or((span, span));
        errors.at_place(place, format!("{why}: {}", Printer::new(graph, name).excerpt(term)));
        errors
    })
}

/// Reports a Lagrangian that has no energy here, and friction that is none.
pub(crate) fn lagrangian(
    energy: &Energy,
    (found, friction): (std::result::Result<Legendre, legendre::Flaw>, std::result::Result<Option<Damped>, NoFriction>),
    graph: &Graph,
    places: &HashMap<Id, Place>,
    name: impl Fn(Symbol) -> String,
) -> Result<(Legendre, Option<Damped>)> {
    let mut errors = Diagnostics::default();
    let printer = Printer::new(graph, name);
    let [q, v] = [Symbol::Q, Symbol::V].map(|kind| move |i: &u32| kind(*i));
    let named = |symbol: Symbol| printer.named(symbol);
    let velocities =
        energy.arguments.iter().find(|(role, _)| *role == Role::Velocity).map(|(_, argument)| &argument.name);
    match (energy.form, &friction) {
        (Form::Herglotz, Ok(Some(_))) => errors.at(&energy.rayleigh, FRICTION_OF_ACTION),
        (_, Err(NoFriction::Degree)) => errors.at(&energy.rayleigh, NOT_RAYLEIGH),
        (_, Err(NoFriction::AtRest(rest))) => {
            errors.at(&energy.rayleigh, format!("{NO_REST}: {}", printer.excerpt(*rest)));
        }
        _ => {}
    }
    if let Err(flaw) = &found {
        let all =
            |velocities: &[u32]| velocities.iter().map(|i| format!("`{}`", named(v(i)))).collect::<Vec<_>>().join(", ");
        let (message, term) = match flaw {
            legendre::Flaw::Unread(i) => {
                let [q, v] = [named(q(i)), named(v(i))];
                let message = format!(
                    "`{v}` is not read, so that `{q}` has no inertia, and ∂L/∂{q} = 0 is no differential equation: solve that for `{q}` and \
                     put it in, or give it a mass"
                );
                (message, None)
            }
            legendre::Flaw::Linear(momenta) => {
                let momenta: Vec<String> = momenta.iter().map(|momentum| printer.excerpt(*momentum)).collect();
                let message = format!(
                    "this Lagrangian is linear in the velocities, so that its equations are of first order: write them as \
                     `#[hamiltonian(structure = …)]` of the energy −L at {} = 0; the momenta ∂L/∂v are {}",
                    velocities.map(ToString::to_string).unwrap_or_default(),
                    momenta.join(", ")
                );
                (message, None)
            }
            legendre::Flaw::LinearIn(i, momentum) => {
                let message = format!(
                    "this Lagrangian is linear in `{}`, which has no inertia: its momentum is a function of positions, {}",
                    named(v(i)),
                    printer.excerpt(*momentum)
                );
                (message, None)
            }
            legendre::Flaw::Singular(velocities) => {
                let message = format!(
                    "the mass matrix ∂²L/∂v² of {} is singular at every state, so that these velocities do not follow from momenta: some \
                     combination of them has no inertia",
                    all(velocities)
                );
                (message, None)
            }
            legendre::Flaw::NotClosed(velocities, of) => {
                let message = format!(
                    "no formula is known for {} as functions of their momenta; known are Lagrangians that are quadratic in velocities, and \
                     A√(S + v·Cv), A|v|ⁿ, A eᵛ, A ln v and A cosh v, with terms that are linear: {}",
                    all(velocities),
                    printer.excerpt(*of)
                );
                (message, Some(*of))
            }
        };
        match (term.and_then(|term| written(graph, places, term)), velocities) {
            (Some(place), _) => errors.at_place(place, message),
            (None, Some(velocities)) => errors.at(velocities, message),
            (None, None) => errors.at(&energy.item.sig.ident, message),
        }
    }
    let (Ok(legendre), Ok(friction)) = (found, friction) else {
        return errors.or(()).map(|()| unreachable!("reported"));
    };
    errors.or((legendre, friction))
}

/// Reports friction that is none, and what is required of an energy that is not derived.
pub(crate) fn velocities(
    energy: &Energy,
    (long, damping): (Id, Option<&Damping>),
    graph: &Graph,
    places: &HashMap<Id, Place>,
    name: impl Fn(Symbol) -> String,
) -> Result<()> {
    let mut errors = Diagnostics::default();
    let printer = Printer::new(graph, name);
    if let Some(damping) = damping {
        flaw_of_damping(energy, damping, &printer, &mut errors);
    }
    for (_, span) in &energy.requirements {
        let place = written(graph, places, long).unwrap_or((*span, *span));
        errors.at_place(place, format!("{FULL_MASS}: {}", printer.excerpt(long)));
    }
    errors.or(())
}

/// The rows of a matrix of damping.
type Damped = Vec<Vec<Id>>;

/// Damping that is none.
fn flaw_of_damping<F: Fn(Symbol) -> String>(
    energy: &Energy,
    damping: &Damping,
    printer: &Printer<'_, F>,
    errors: &mut Diagnostics,
) {
    if let Damping { matrix, flaw: Some(flaw), .. } = damping {
        let entry = |i: usize, j: usize| printer.excerpt(matrix[i][j]);
        let message = match *flaw {
            Flaw::NotSymmetric(i, j) => format!(
                "damping is a symmetric matrix, but row {i}, column {j} is {} and row {j}, column {i} is {}: write both alike",
                entry(i, j),
                entry(j, i)
            ),
            Flaw::Negative(i) => format!(
                "damping takes energy away, but the coefficient of coordinate {i} is {}: write one that is not negative",
                entry(i, i)
            ),
            Flaw::Indefinite => INDEFINITE.into(),
        };
        errors.at(&energy.damping.as_ref().or(energy.rayleigh.as_ref()), message);
    }
}

/// Reports pieces that were asked for and have no flow, or do not add up to H, and momenta that cannot be dropped.
pub(crate) fn pieces(
    energy: &Energy,
    (root, groups): (Id, Option<&[(Id, Place)]>),
    found: &Pieces,
    graph: &mut Graph,
    places: &HashMap<Id, Place>,
    name: impl Fn(Symbol) -> String,
) -> Result<()> {
    let mut errors = Diagnostics::default();
    if let Some(groups) = groups {
        if let Err(group) = found
            && let Some((_, place)) = groups.iter().find(|(other, _)| other == group)
        {
            let printer = Printer::new(graph, &name);
            errors.at_place(*place, format!("{NO_FLOW}: {}", printer.excerpt(*group)));
        }
        adds_up(root, groups, graph, &name, &mut errors);
    }
    if let Some(span) = energy.lift
        && let Some(term) = analyze::not_affine(graph, root)
    {
        let printer = Printer::new(graph, &name);
        let place = places.get(&term).copied().unwrap_or((span, span));
        errors.at_place(place, format!("{NO_LIFT}: {}", printer.excerpt(term)));
    }
    errors.or(())
}

/// Reports a part with an exact flow, and a rest, that were asked for and are not there.
pub(crate) fn division(
    energy: &Energy,
    (root, groups): (Id, Option<&[(Id, Place)]>),
    found: &Division,
    graph: &mut Graph,
    places: &HashMap<Id, Place>,
    name: impl Fn(Symbol) -> String,
) -> Result<()> {
    let mut errors = Diagnostics::default();
    let asked = match (groups, energy.inner) {
        (Some(groups), _) => Some(whole(groups)),
        (None, inner) => inner.map(|(_, span)| (span, span)),
    };
    if let (Some(asked), Err(NoExactPart { term, why })) = (asked, found) {
        let group = groups.and_then(|groups| groups.iter().find(|(group, _)| group == term)).map(|(_, place)| *place);
        let place = group.or_else(|| written(graph, places, *term)).unwrap_or(asked);
        errors.at_place(place, format!("{why}: {}", Printer::new(graph, &name).excerpt(*term)));
    }
    if let Some(groups) = groups {
        adds_up(root, groups, graph, &name, &mut errors);
    }
    errors.or(())
}

/// Reports what groups miss of the energy.
fn adds_up(
    root: Id,
    groups: &[(Id, Place)],
    graph: &mut Graph,
    name: &impl Fn(Symbol) -> String,
    errors: &mut Diagnostics,
) {
    let sum = graph.sum(&groups.iter().map(|(group, _)| *group).collect::<Vec<_>>());
    let missing = difference(graph, root, sum);
    let verdict = analyze::identity(graph, missing);
    let printer = Printer::new(graph, name);
    let wrong = matches!(verdict, Identity::Wrong(_));
    let message = match verdict.rest() {
        _ if verdict.is_zero() => None,
        Some(Remainder { rest, certain, case }) => {
            let (told, rest) = (in_case(&printer, case), shorter(&printer, missing, *rest, case));
            let advice = if wrong || *certain || is_term(graph, missing) { "" } else { SAME_SPELLING };
            Some(format!("{NOT_THE_SUM}{told} is: {rest}{advice}"))
        }
        None if wrong => Some(format!("{NOT_THE_SUM} is: {}", printer.excerpt(missing))),
        None => Some(format!("{NOT_COMPARED}: {}", printer.excerpt(missing))),
    };
    if let Some(message) = message {
        errors.at_place(whole(groups), message);
    }
}

/// From the first group to the last.
fn whole(groups: &[(Id, Place)]) -> Place {
    let [first, last] =
        [groups.first(), groups.last()].map(|group| group.map_or_else(Span::call_site, |(_, place)| place.0));
    (first, last)
}

/// a − b, in which terms that are written alike have cancelled.
fn difference(graph: &mut Graph, a: Id, b: Id) -> Id {
    let [mut terms, other] = [a, b].map(|root| analyze::terms(graph, root));
    terms.extend(other.into_iter().map(|term| graph.neg(term)));
    graph.sum(&terms)
}

/// Whether a node is one term.
fn is_term(graph: &Graph, id: Id) -> bool {
    !matches!(graph.node(graph.coefficient(id).1), Node::Linear(..))
}

/// What is left, as it is written or multiplied out.
fn shorter<F: Fn(Symbol) -> String>(printer: &Printer<'_, F>, missing: Id, rest: Id, case: &[(Id, bool)]) -> String {
    let [written, rest] = [missing, rest].map(|id| printer.excerpt(id));
    if case.is_empty() && written.chars().count() <= rest.chars().count() { written } else { rest }
}

/// Reports S that is not skew, and damping that is none.
pub(crate) fn structure(
    energy: &Energy,
    (structure, damping): (&proof::Structure, Option<&Damping>),
    graph: &Graph,
    places: &HashMap<Id, Place>,
    name: impl Fn(Symbol) -> String,
) -> Result<()> {
    let mut errors = Diagnostics::default();
    let printer = Printer::new(graph, name);
    if let (Err(([i, j], verdict)), Some(form)) = (&structure.skew, &energy.structure) {
        let (sum, equal) = match verdict {
            Identity::Wrong(wrong) => (remains(&printer, wrong.rest.as_ref(), &wrong.witness), ""),
            _ => (open(&printer, verdict), " was not proven to be 0"),
        };
        let what = if i == j { format!("twice S[{i}][{i}]") } else { format!("S[{i}][{j}] + S[{j}][{i}]") };
        let advice = if i == j { "" } else { "; `|i, j| …` is asked for i < j alone" };
        let message = format!("S is skew, but {what}{equal}{sum}{advice}");
        match written(graph, places, structure.matrix[*j][*i]) {
            Some(place) => errors.at_place(place, message),
            None => errors.at(&form.expr, message),
        }
    }
    if let Some(damping) = damping {
        flaw_of_damping(energy, damping, &printer, &mut errors);
    }
    errors.or(())
}

/// Where a node was written, if it is more than a symbol or a number, which may have been written elsewhere first.
fn written(graph: &Graph, places: &HashMap<Id, Place>, id: Id) -> Option<Place> {
    let more = !matches!(graph.node(id), Node::Symbol(_) | Node::Number(_));
    places.get(&id).copied().filter(|_| more)
}

/// Reports functions that are not kept, and those that are functions of others.
pub(crate) fn integrals(
    energy: &Energy,
    written: &[Integral],
    found: &proof::Integrals,
    graph: &Graph,
    name: impl Fn(Symbol) -> String,
) -> Result<()> {
    let mut errors = Diagnostics::default();
    let printer = Printer::new(graph, name);
    for (i, (kept, verdict)) in energy.keeps.iter().zip(&found.kept).enumerate() {
        let (name, but) = (&kept.name, if kept.but.is_some() { " but for b·∇I" } else { "" });
        let message = match verdict {
            None | Some(Identity::Zero(_)) => continue,
            Some(Identity::Wrong(wrong)) => {
                let rest = remains(&printer, wrong.rest.as_ref(), &wrong.witness);
                format!("`{name}` is not constant along the field{but}: what remains of its derivative{rest}")
            }
            Some(verdict @ Identity::Open(found)) => {
                let why = match found.why {
                    Why::Relation => {
                        "it holds to rounding, and rests on a relation between functions that is not known here"
                    }
                    Why::Branch => "it holds to rounding, for one choice of the signs of roots",
                    Why::TooLong => "it holds to rounding, and is too long to be decided",
                    Why::Nowhere => "no state was met at which it is defined",
                };
                format!(
                    "`{name}` was not proven to be constant along the field{but}: {why}; if you know that it is, say \
                     `keeps(assume({name} = …))`{}",
                    open(&printer, verdict).replacen(": ", "; what remains of its derivative is ", 1)
                )
            }
        };
        errors.at_place(written[i].place, message);
    }
    if let Some(i) = found.dependent.filter(|_| errors.len() == 0) {
        let others = if i == 0 { "is constant everywhere" } else { "is a function of the others" };
        errors.at_place(written[i].place, format!("`{}` {others}: leave it out", energy.keeps[i].name));
    }
    errors.or(())
}

const NO_FLOW: &str = "no flow in closed form is known for this piece: take it apart, or leave out `split` to see in `REPORT` what is \
                       found";

const NOT_THE_SUM: &str = "the pieces do not add up to the energy; what is missing";

const SAME_SPELLING: &str =
    "; if that is zero by a relation between functions, write them in the pieces as they are in the energy";

const NOT_COMPARED: &str = "it cannot be decided whether the pieces add up to the energy, because their difference is too long: write \
                            their terms as they are in the energy; what remains is";

const NO_LIFT: &str =
    "`lift` does not follow the momenta, but positions move by them in this term: write q' = X(q) as p·X(q)";

const FRICTION_OF_ACTION: &str =
    "with an action friction is a term of the Lagrangian in it, such as `- gamma * s`: leave `rayleigh` out";

const NOT_RAYLEIGH: &str = "Rayleigh's function has to be a quadratic form in the velocities, such as `c * v * v / 2.0`; its coefficients may \
                            read positions, parameters and time";

const NO_REST: &str = "Rayleigh's function has to be a quadratic form in the velocities, so that friction vanishes at rest, but there ∂R/∂v is";

const INDEFINITE: &str = "damping takes energy away, but this matrix gives some at some velocity: write one that is positive \
                          semidefinite";
