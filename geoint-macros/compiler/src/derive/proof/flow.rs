//! A flow x' = f(x, t), or the flow x' = S(x) ∇H of an energy, with the functions that it keeps.

use super::Structure;
use crate::analyze::{Damping, claims, search};
use crate::diff;
use crate::diff::entropy::EntropyStep;
use crate::diff::equations::{checked_damping, structured, times};
use crate::diff::flow::Conserved;
use crate::ir::{
    Graph, Id, Symbol,
    print::{Naming, Printer},
};
use crate::lower::{Integral, canonical};
use crate::parse::{Form, Kept};
use std::collections::HashSet;

/// The name of the energy among the functions that a flow keeps.
pub(in crate::derive) const ENERGY: &str = "energy";

/// A flow and its integrals.
#[derive(Debug)]
pub(crate) struct Flow {
    pub(crate) form: Form,
    /// f.
    pub(crate) field: Vec<Id>,
    /// H and the matrix S − C of x' = (S − C) ∇H, if they are known.
    pub(crate) energy: Option<(Id, Vec<Vec<Id>>)>,
    /// The damping −C ∇H in the field.
    loss: Option<Vec<Id>>,
    /// The entropy S of x' = L ∇E + M ∇S, with the step.
    pub(crate) entropy: Option<EntropyStep>,
    /// Functions that steps keep, or whose change is known.
    pub(crate) kept: Vec<Named>,
    /// Constant functions that steps do not keep.
    pub(crate) also: Vec<Constant>,
    /// The divergence of the field, if it is not zero. Then the field has no energy.
    pub(crate) divergent: Option<Id>,
}

/// A constant function that steps do not keep.
#[derive(Debug)]
pub(crate) struct Constant {
    pub(crate) value: Id,
    pub(crate) is_casimir: bool,
}

/// A function that a flow keeps, or whose change is known.
#[derive(Clone, Debug)]
pub(crate) struct Named {
    pub(crate) name: String,
    pub(crate) conserved: Conserved,
    pub(crate) origin: Origin,
}

/// The origin of an integral.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    /// Listed by the user, and proven.
    Listed,
    /// Listed by the user, without a proof.
    Assumed,
    /// The energy.
    Energy,
    /// The entropy, which friction raises.
    Entropy,
    /// Found by the search.
    Found,
}

impl Flow {
    /// Creates the flow x' = f(x, t) with the integrals that the user lists.
    pub(crate) fn of_field<'a>(field: &[Id], keeps: impl Iterator<Item = (&'a Kept, &'a Integral)>) -> Flow {
        let named = |(kept, integral): (&Kept, &Integral)| Named {
            name: kept.name.to_string(),
            conserved: Conserved { value: integral.value, but: integral.but.clone() },
            origin: if kept.assumed { Origin::Assumed } else { Origin::Listed },
        };
        Flow {
            form: Form::Field,
            field: field.to_vec(),
            energy: None,
            loss: None,
            entropy: None,
            kept: keeps.map(named).collect(),
            also: vec![],
            divergent: None,
        }
    }

    /// Creates the flow x' = (S − C) ∇H, which keeps H unless H reads time.
    pub(crate) fn structured(graph: &mut Graph, energy: Id, structure: &[Vec<Id>], damping: Option<&Damping>) -> Flow {
        let n = structure.len();
        let gradient = diff::gradient(graph, energy, n as u32).q;
        let damped = damping.map(|damping| {
            let mut matrix = structure.to_vec();
            for (i, row) in matrix.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    let taken = checked_damping(graph, &damping.matrix, i, j);
                    *entry = graph.sub(*entry, taken);
                }
            }
            let loss = times(graph, &damping.matrix, &gradient).into_iter().map(|loss| graph.neg(loss)).collect();
            (matrix, loss)
        });
        let (matrix, loss) = damped.map_or_else(|| (structure.to_vec(), None), |(matrix, loss)| (matrix, Some(loss)));
        let field = structured(graph, &matrix, &gradient);
        let conserved = Conserved { value: energy, but: loss.clone() };
        let kept = Named { name: ENERGY.into(), conserved, origin: Origin::Energy };
        let kept = if graph.reads(energy).t { vec![] } else { vec![kept] };
        Flow {
            form: Form::Structured,
            field,
            energy: Some((energy, matrix)),
            loss,
            entropy: None,
            kept,
            also: vec![],
            divergent: None,
        }
    }

    /// Adds an energy that was recovered from the field: x' = J ∇H. It is kept, too, unless it is a function of the listed integrals.
    pub(crate) fn recovered(&mut self, graph: &mut Graph, energy: Id, names: &dyn Naming) {
        self.energy = Some((energy, canonical(graph, self.field.len())));
        let functions: Vec<Id> = self.kept.iter().map(|named| named.conserved.value).chain([energy]).collect();
        let x = coordinates(self.field.len());
        let new =
            claims::dependent(graph, &x, &functions).map_or(self.kept.is_empty(), |found| found.integrals.is_empty());
        if new && !graph.reads(energy).t {
            let taken = self.kept.iter().any(|named| named.name == ENERGY);
            let name = if taken { Printer::new(graph, names).excerpt(energy) } else { ENERGY.into() };
            let origin = if taken { Origin::Found } else { Origin::Energy };
            self.kept.push(Named { name, conserved: Conserved { value: energy, but: None }, origin });
        }
    }

    /// Returns the first function that the flow keeps. Splittings of a field use its gradient.
    pub(crate) fn first(&self) -> Option<&Named> {
        self.kept.iter().find(|named| named.conserved.but.is_none())
    }

    /// Returns whether the step with S(m) ∇̄H keeps all integrals: H alone, or H with Casimirs.
    pub(in crate::derive) fn is_kept_by_structure(&self) -> bool {
        self.form == Form::Structured || self.kept.iter().all(|named| named.origin == Origin::Energy)
    }

    /// Searches for constant functions. Linear functions of a field become integrals, because a projection onto other integrals would violate them. All
    /// others are listed for the report.
    pub(crate) fn search(&mut self, graph: &mut Graph, names: &dyn Naming) {
        let x = coordinates(self.field.len());
        let found = search::kept_along(graph, &x, std::slice::from_ref(&self.field)).unwrap_or_default();
        let proven = |graph: &mut Graph, value| claims::is_kept(graph, &x, &self.field, value, None).is_zero();
        let found = found.into_iter().filter(|kept| proven(graph, kept.value)).collect();
        for (kept, everywhere) in self.new_among(graph, found) {
            if everywhere && kept.linear && self.form == Form::Field && !self.kept.is_empty() {
                self.keep_found(graph, kept.value, names);
            } else {
                self.also.push(Constant { value: kept.value, is_casimir: false });
            }
        }
    }

    /// Adds Casimirs, which are constant along the rows of S. One of them may be the function from which S was built. Damping changes them as it changes H.
    /// In a system with an entropy, [`search`](Self::search) finds the functions that friction keeps, too.
    pub(crate) fn search_casimirs(
        &mut self,
        graph: &mut Graph,
        Structure { matrix: rows, casimir: written, .. }: &Structure,
        names: &dyn Naming,
    ) {
        if self.entropy.is_some() {
            return;
        }
        let x = coordinates(self.field.len());
        // The Casimir of the user comes first. The search may find a function of it with a smaller domain, such as its logarithm.
        let mut found: Vec<_> = written.iter().map(|value| search::Kept { value: *value, linear: false }).collect();
        found.extend(search::kept_along(graph, &x, rows).unwrap_or_default());
        // A function that reads time is constant along the rows, but not along the flow.
        found.retain(|kept| !graph.reads(kept.value).t);
        found.retain(|kept| claims::is_casimir(graph, &x, rows, kept.value).is_ok());
        for (kept, everywhere) in self.new_among(graph, found) {
            if everywhere {
                self.keep_found(graph, kept.value, names);
            } else if self.loss.is_none() {
                self.also.push(Constant { value: kept.value, is_casimir: true });
            }
        }
    }

    /// Adds a found integral. Its name is its formula.
    fn keep_found(&mut self, graph: &Graph, value: Id, names: &dyn Naming) {
        let name = Printer::new(graph, names).excerpt(value);
        let conserved = Conserved { value, but: self.loss.clone() };
        self.kept.push(Named { name, conserved, origin: Origin::Found });
    }

    /// Returns the functions that are independent of all known ones. Each has a flag: whether it is defined wherever the known functions and the field
    /// are. A logarithm that the field does not contain, for example, would make the domain of steps smaller than the domain of the flow.
    fn new_among(&self, graph: &mut Graph, found: Vec<search::Kept>) -> Vec<(search::Kept, bool)> {
        if found.is_empty() {
            return vec![];
        }
        let known: Vec<Id> = self
            .kept
            .iter()
            .map(|kept| kept.conserved.value)
            .chain(self.also.iter().map(|constant| constant.value))
            .collect();
        let defined: HashSet<Id> = graph.reachable(&[&known[..], &self.field].concat()).into_iter().collect();
        let all: Vec<Id> = known.iter().copied().chain(found.iter().map(|kept| kept.value)).collect();
        let x = coordinates(self.field.len());
        let Some(dependent) = claims::dependent(graph, &x, &all) else { return vec![] };
        let new = found.into_iter().enumerate().filter(|(i, _)| !dependent.integrals.contains(&(known.len() + i)));
        new.map(|(_, kept)| {
            let computed = graph.reachable(&[kept.value]);
            let everywhere = computed.iter().all(|id| !graph.is_partial(*id) || defined.contains(id));
            (kept, everywhere)
        })
        .collect()
    }
}

/// Returns the symbols of x.
pub(in crate::derive) fn coordinates(n: usize) -> Vec<Symbol> {
    (0..n as u32).map(Symbol::Position).collect()
}
