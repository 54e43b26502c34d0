//! What is derived of a flow x' = f(x, t), and of one that an energy makes, x' = S(x) ∇H.

use super::domain::{Domain, Roots};
use super::facts::Fact;
use super::implicit;
use super::jet::JetKernel;
use super::proof::flow::{ENERGY, Flow, Named, Origin, coordinates};
use super::system::{FieldKernels, Implicit, Integrals, Missing, System};
use crate::analyze::{self, Damping, MeanValue};
use crate::diff;
use crate::diff::field::Field;
use crate::diff::flow::{self, Conserved, Order};
use crate::ir::{Graph, Id, Partial, Symbol};
use crate::messages::NOTHING_KEPT;
use crate::schedule::{Kernel, Levels};

/// Derives everything that some method needs.
pub(crate) fn flow(graph: &mut Graph, found: &Flow, partial: &[Partial], damping: Option<&Damping>) -> System {
    let Flow { form, field, energy, kept, .. } = found;
    let n = field.len() as u32;
    let coordinates = coordinates(field.len());
    let conserved: Vec<Conserved> = kept.iter().map(|kept| kept.conserved.clone()).collect();
    let collocation = Field::new(graph, coordinates, field.clone());
    let discrete = match energy {
        Some((energy, matrix)) if found.is_kept_by_structure() => Some(flow::structured(graph, *energy, matrix)),
        _ if conserved.is_empty() => None,
        _ => Some(flow::mean_velocity(graph, field, &conserved, Order::Two)),
    };
    let missing = |term: &Id| Missing { marker: "KeepsIn", term: *term, why: NOTHING_KEPT, pair: None };
    let nothing_kept = found.divergent.as_ref().filter(|_| discrete.is_none()).map(missing);
    let (h, folded) = (graph.symbol(Symbol::StepLength), discrete.is_some() && field.len() <= implicit::MOST_UNKNOWNS);
    let fourth = (!conserved.is_empty()).then(|| {
        let field = flow::mean_velocity(graph, field, &conserved, Order::Four);
        let equation = implicit::image(graph, &field, h);
        Kernel::new(Levels::Iterated, equation)
    });
    // Of a field, what it keeps under that name.
    let named = kept.iter().find(|kept| kept.name == ENERGY).map(|kept| kept.conserved.value);
    let value = named.or(energy.as_ref().map(|(energy, _)| *energy));
    let mut values: Vec<Id> = value.into_iter().chain(conserved.iter().map(|kept| kept.value)).collect();
    values.sort();
    values.dedup();
    let all = [&field[..], &values].concat();
    let quadratic = analyze::is_polynomial(graph, field, 2);
    System {
        facts: if quadratic { vec![Fact::QuadraticField] } else { vec![] },
        value: value.map(|value| Kernel::new(Levels::One, vec![value])),
        slopes: None,
        rate: Some(Kernel::new(Levels::One, field.clone())),
        splitting: None,
        perturbed: None,
        modified: None,
        pieces: vec![],
        integrals: integrals(graph, kept, n),
        lagrangian: None,
        jet: JetKernel::of_field(graph, field, energy.as_ref().map(|(energy, _)| *energy)),
        domain: Domain::of(graph, Roots { all: &all, divided: &values }, *form, partial, (damping, &[])),
        implicit: Implicit::Field(FieldKernels {
            coordinates: collocation.unknowns.clone(),
            increments: (0..n).map(Symbol::PositionIncrement).collect(),
            second_order: false,
            folded,
            linear: false,
            mean_value: MeanValue::NotClosed(field[0]),
            collocation: Kernel {
                levels: Levels::Prepared,
                routines: vec![implicit::roots(&collocation), vec![], vec![]],
            },
            discrete: discrete.map(|field| {
                let equation = if folded { implicit::image(graph, &field, h) } else { vec![] };
                Kernel { levels: Levels::Iterated, routines: vec![implicit::roots(&field), equation, vec![]] }
            }),
            nothing_kept,
            canonical: None,
            fourth,
            momenta: Kernel::new(Levels::One, vec![]),
        }),
    }
}

/// The functions that users call, and those of them that are constant, with their gradients.
fn integrals(graph: &mut Graph, kept: &[Named], n: u32) -> Option<Integrals> {
    if kept.is_empty() {
        return None;
    }
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
    Some(Integrals {
        names: kept.iter().map(|kept| kept.name.clone()).collect(),
        functions: kept.iter().map(|kept| kept.origin != Origin::Found).collect(),
        constant,
        steady,
        energy,
        steep: analyze::is_steep(graph, &slopes, &coordinates(n as usize)),
        values: Kernel::new(Levels::One, values),
        slopes: Kernel::new(Levels::One, slopes),
        changes: Kernel::new(Levels::One, changes),
    })
}
