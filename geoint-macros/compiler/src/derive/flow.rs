//! Routines of a flow x' = f(x, t), and of the flow x' = S(x) ∇H of an energy.

use super::checks::{Check, Sign};
use super::domain::{Domain, Formulas};
use super::facts::Fact;
use super::implicit::{self, Scaled};
use super::jet::JetKernel;
use super::proof::flow::{ENERGY, Flow, Named, Origin, coordinates};
use super::system::{Collocation, FieldKernels, Integrals, Kernels, Missing, NamedFunction, System};
use crate::analyze::{self, Damping, MeanValue};
use crate::compilation::Compilation;
use crate::diff;
use crate::diff::entropy::EntropyStep;
use crate::diff::field::Field;
use crate::diff::flow::{self, Conserved, Order};
use crate::ir::{Graph, Id, Symbol, UndefinedAt};
use crate::messages::{FORWARD, NOTHING_KEPT};
use crate::schedule::{Kernel, Levels, Routine, Space};

/// Derives the routines of every method but those of pieces, which the fronts add. `partial` lists the nodes that are undefined at some states. `damping` is
/// that of a structured system; a field has its friction in f.
pub(crate) fn flow(
    compilation: &mut Compilation<'_>,
    found: &Flow,
    partial: &[UndefinedAt],
    damping: Option<&Damping>,
) -> System {
    let (positions, graph) = (compilation.positions(), &mut compilation.graph);
    let Flow { field, energy, kept, entropy, .. } = found;
    let [coordinates, increments] = [Symbol::Position, Symbol::PositionIncrement]
        .map(|symbol: fn(u32) -> Symbol| (0..field.len() as u32).map(symbol).collect::<Vec<Symbol>>());
    let conserved: Vec<Conserved> = kept.iter().map(|kept| kept.conserved.clone()).collect();
    let collocation = Field::new(graph, coordinates.clone(), field.clone());
    // If S and H are known and all integrals are H and Casimirs, the step S(m) ∇̄H with the midpoint m keeps them. Otherwise the mean velocity is projected, so that
    // the integrals are kept.
    let discrete = match energy {
        _ if entropy.is_some() => entropy.as_ref().map(|step| step.field.clone()),
        Some((energy, matrix)) if found.is_kept_by_structure() => Some(flow::structured(graph, *energy, matrix)),
        _ if conserved.is_empty() => None,
        _ => Some(flow::mean_velocity(graph, field, &conserved, Order::Two)),
    };
    // The user named no integral, and a divergence excludes an energy. `KeepsIn` is the trait that rustc names in its error.
    let missing = |term: &Id| Missing::new("KeepsIn", *term, NOTHING_KEPT);
    let nothing_kept = found.divergent.as_ref().filter(|_| discrete.is_none()).map(missing);
    let h = graph.symbol(Symbol::StepLength);
    let x = Space { symbols: coordinates, extents: positions.clone() };
    let dx = Space { symbols: increments, extents: positions.clone() };
    let equation = |graph: &mut Graph, field: &Field| {
        let Scaled { image, matrix } = implicit::scaled(graph, field, h);
        implicit::equation_routine("equation", image, &matrix, &dx).reading("d", &dx)
    };
    let fourth = (!conserved.is_empty() && entropy.is_none()).then(|| {
        let field = flow::mean_velocity(graph, field, &conserved, Order::Four);
        let equation = equation(graph, &field);
        implicit::iterated(vec![equation], &x)
    });
    // Users give the energy of a field as the integral with the name `ENERGY`.
    let named = kept.iter().find(|kept| kept.name == ENERGY).map(|kept| kept.conserved.value);
    let energy = energy.as_ref().map(|(energy, _)| *energy);
    let value = named.or(energy);
    let mut values: Vec<Id> = value.into_iter().chain(conserved.iter().map(|kept| kept.value)).collect();
    values.sort();
    values.dedup();
    let all = [&field[..], &values].concat();
    let quadratic = analyze::is_polynomial_in(graph, field, 2, Symbol::is_coordinate);
    let integrals = integrals(graph, kept, &dx);
    let jet = JetKernel::of_field(graph, field, energy);
    let vanishing = match (energy, entropy) {
        (Some(energy), Some(step)) => vanishing(graph, energy, step),
        _ => vec![],
    };
    let formulas = Formulas { all: &all, damping, edges: &vanishing, ..Formulas::new(&values, partial) };
    let domain = Domain::of(graph, compilation.form, formulas);
    let stages = vec![implicit::field_routine("field", &collocation, &x).reading("y", &x)];
    let discrete = discrete.map(|found| {
        let mut routines = vec![implicit::field_routine("slope", &found, &dx).reading("d", &dx)];
        if field.len() <= implicit::MOST_UNKNOWNS {
            routines.push(equation(graph, &found));
        }
        implicit::iterated(routines, &x)
    });
    // The mean value, linearity and momenta are placeholders: only canonical systems use them.
    let kernels = FieldKernels {
        linear: false,
        mean_value: MeanValue::NotClosed(field[0]),
        collocation: Collocation { second_order: false, kernel: Kernel::new(Levels::Prepared, stages) },
        discrete,
        nothing_kept,
        forward: entropy.as_ref().map(|step| Missing::new("Forward", step.entropy, FORWARD)),
        canonical: None,
        fourth,
        momenta: Routine::default(),
        coordinates: x,
        increments: dx,
    };
    System {
        facts: if quadratic { vec![Fact::QuadraticField] } else { vec![] },
        value: value.map(|value| Routine::number("hamiltonian", value)),
        rate: Some(Routine::array("rate", "slopes", &positions, field.clone())),
        integrals,
        jet,
        ..System::new(Kernels::Field(Box::new(kernels)), domain)
    }
}

/// Returns the states at which a projection of the step does not exist, because a gradient vanishes on a block.
fn vanishing(graph: &mut Graph, energy: Id, step: &EntropyStep) -> Vec<Check> {
    let mut checks = vec![];
    for (blocks, function, message) in [
        (&step.structure, step.entropy, "the entropy has no slope in coordinates that `structure` couples"),
        (&step.friction, energy, "the energy has no slope in coordinates that `friction` couples"),
    ] {
        let slopes = diff::gradient(graph, function, step.field.f.len() as u32).q;
        for block in blocks.iter().filter(|block| block.projected) {
            let of_block: Vec<Id> = block.coordinates.iter().map(|i| slopes[*i]).collect();
            let size = diff::entropy::sum_of_sizes(graph, &of_block);
            checks.push(Check::new(size, Sign::Zero, message, function));
        }
    }
    checks
}

/// Derives the routines of the functions that a flow keeps, or changes at a known rate. `increments` are the increments of x.
fn integrals(graph: &mut Graph, kept: &[Named], increments: &Space) -> Option<Integrals> {
    if kept.is_empty() {
        return None;
    }
    let n = increments.len() as u32;
    let values: Vec<Id> = kept.iter().map(|kept| kept.conserved.value).collect();
    // Functions with the option `but` change.
    let constant: Vec<usize> = (0..kept.len()).filter(|i| kept[*i].conserved.but.is_none()).collect();
    let steady: Vec<usize> = constant.iter().copied().filter(|i| !graph.reads(values[*i]).t).collect();
    // The runtime uses this integral where methods need an energy.
    let energy = steady.iter().position(|i| kept[*i].name == ENERGY).or((!steady.is_empty()).then_some(0));
    let slopes: Vec<Id> = steady.iter().flat_map(|i| diff::gradient(graph, values[*i], n).q).collect();
    let mut change = |i: &usize| {
        let slopes = diff::discrete_gradient(graph, values[*i], n).q;
        let increments: Vec<Id> = increments.symbols.iter().map(|symbol| graph.symbol(*symbol)).collect();
        graph.dot(&slopes, &increments)
    };
    let changes = steady.iter().map(&mut change).collect();
    let extents = [&[steady.len()], &increments.extents[..]].concat();
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
        slopes: Routine::array("slopes", "slopes", &extents, slopes),
        changes: Routine::row("changes", changes).reading("dz", increments),
    })
}
