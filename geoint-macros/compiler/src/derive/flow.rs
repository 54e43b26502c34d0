//! What is derived of a flow x' = f(x, t), and of one that an energy makes, x' = S(x) ∇H.

use super::domain::{Domain, Friction, Roots};
use super::facts::Fact;
use super::implicit;
use super::implicit::Scaled;
use super::jet::JetKernel;
use super::proof::flow::{ENERGY, Flow, Named, Origin, coordinates};
use super::system::{Collocation, FieldKernels, Implicit, Integrals, Missing, NamedFunction, System};
use crate::analyze::{self, Damping, MeanValue};
use crate::diff;
use crate::diff::field::Field;
use crate::diff::flow::{self, Conserved, Order};
use crate::ir::{Graph, Id, Symbol, UndefinedAt};
use crate::messages::NOTHING_KEPT;
use crate::schedule::{Kernel, Levels, Output, Routine, Space};

/// Derives the routines of every method but those of pieces.
pub(crate) fn flow(
    graph: &mut Graph,
    found: &Flow,
    partial: &[UndefinedAt],
    damping: Option<&Damping>,
    positions: &[usize],
) -> System {
    let Flow { form, field, energy, kept, .. } = found;
    let n = field.len() as u32;
    let coordinates = coordinates(field.len());
    let conserved: Vec<Conserved> = kept.iter().map(|kept| kept.conserved.clone()).collect();
    let collocation = Field::new(graph, coordinates.clone(), field.clone());
    let discrete = match energy {
        Some((energy, matrix)) if found.is_kept_by_structure() => Some(flow::structured(graph, *energy, matrix)),
        _ if conserved.is_empty() => None,
        _ => Some(flow::mean_velocity(graph, field, &conserved, Order::Two)),
    };
    let missing = |term: &Id| Missing::new("KeepsIn", *term, NOTHING_KEPT);
    let nothing_kept = found.divergent.as_ref().filter(|_| discrete.is_none()).map(missing);
    let h = graph.symbol(Symbol::StepLength);
    let x = Space { symbols: coordinates.clone(), extents: positions.to_vec() };
    let dx = Space { symbols: (0..n).map(Symbol::PositionIncrement).collect(), extents: positions.to_vec() };
    let equation = |graph: &mut Graph, field: &Field| {
        let Scaled { image, matrix } = implicit::scaled(graph, field, h);
        implicit::equation_routine("equation", image, &matrix, &dx).reading("d", &dx)
    };
    let fourth = (!conserved.is_empty()).then(|| {
        let field = flow::mean_velocity(graph, field, &conserved, Order::Four);
        let equation = equation(graph, &field);
        implicit::iterated(vec![equation], &x)
    });
    // Of a field, what it keeps under that name.
    let named = kept.iter().find(|kept| kept.name == ENERGY).map(|kept| kept.conserved.value);
    let value = named.or(energy.as_ref().map(|(energy, _)| *energy));
    let mut values: Vec<Id> = value.into_iter().chain(conserved.iter().map(|kept| kept.value)).collect();
    values.sort();
    values.dedup();
    let all = [&field[..], &values].concat();
    let quadratic = analyze::is_polynomial_in(graph, field, 2, Symbol::is_coordinate);
    System {
        facts: if quadratic { vec![Fact::QuadraticField] } else { vec![] },
        value: value.map(|value| Routine::number("hamiltonian", value)),
        gradient: None,
        rate: Some(Routine::new("rate", vec![Output::array("slopes", positions, field.clone())])),
        splitting: None,
        perturbed: None,
        modified: None,
        pieces: vec![],
        integrals: integrals(graph, kept, positions),
        lagrangian: None,
        jet: JetKernel::of_field(graph, field, energy.as_ref().map(|(energy, _)| *energy)),
        domain: Domain::of(
            graph,
            Roots { all: &all, divided: &values },
            *form,
            partial,
            Friction { damping, rates: &[] },
        ),
        implicit: Implicit::Field(Box::new(FieldKernels {
            linear: false,
            mean_value: MeanValue::NotClosed(field[0]),
            collocation: Collocation {
                second_order: false,
                kernel: Kernel::new(
                    Levels::Prepared,
                    vec![implicit::field_routine("field", &collocation, &x).reading("y", &x)],
                ),
            },
            discrete: discrete.map(|found| {
                let mut routines = vec![implicit::field_routine("slope", &found, &dx).reading("d", &dx)];
                if field.len() <= implicit::MOST_UNKNOWNS {
                    routines.push(equation(graph, &found));
                }
                implicit::iterated(routines, &x)
            }),
            nothing_kept,
            canonical: None,
            fourth,
            momenta: Routine::default(),
            coordinates: x.clone(),
            increments: dx.clone(),
        })),
    }
}

/// The functions that users call, and those of them that are constant, with their gradients.
fn integrals(graph: &mut Graph, kept: &[Named], positions: &[usize]) -> Option<Integrals> {
    if kept.is_empty() {
        return None;
    }
    let n = positions.iter().product::<usize>() as u32;
    let values: Vec<Id> = kept.iter().map(|kept| kept.conserved.value).collect();
    let constant: Vec<usize> = (0..kept.len()).filter(|i| kept[*i].conserved.but.is_none()).collect();
    let steady: Vec<usize> = constant.iter().copied().filter(|i| !graph.reads(values[*i]).t).collect();
    let energy = steady.iter().position(|i| kept[*i].name == ENERGY).or((!steady.is_empty()).then_some(0));
    let slopes: Vec<Id> = steady.iter().flat_map(|i| diff::gradient(graph, values[*i], n).q).collect();
    let mut change = |i: &usize| {
        let slopes = diff::discrete_gradient(graph, values[*i], n).q;
        let increments: Vec<Id> = (0..n).map(|i| graph.symbol(Symbol::PositionIncrement(i))).collect();
        graph.dot(&slopes, &increments)
    };
    let changes = steady.iter().map(&mut change).collect();
    let extents = [&[steady.len()], positions].concat();
    let dx = Space { symbols: (0..n).map(Symbol::PositionIncrement).collect(), extents: positions.to_vec() };
    Some(Integrals {
        all: kept
            .iter()
            .map(|kept| NamedFunction { name: kept.name.clone(), callable: kept.origin != Origin::Found })
            .collect(),
        constant,
        steady,
        energy,
        steep: analyze::is_steep(graph, &slopes, &coordinates(n as usize)),
        values: Routine::row("values", values),
        slopes: Routine::new("slopes", vec![Output::array("slopes", &extents, slopes)]),
        changes: Routine::row("changes", changes).reading("dz", &dx),
    })
}
