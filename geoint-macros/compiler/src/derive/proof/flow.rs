//! A flow x' = f(x, t), or one that an energy makes, x' = S(x) ∇H, and what it keeps: known before its methods are derived.

use super::Structure;
use crate::analyze::{Damping, claims, search};
use crate::diff;
use crate::diff::equations::{checked_damping, structured, times};
use crate::diff::flow::Conserved;
use crate::ir::{
    Graph, Id, Symbol,
    print::{Naming, Printer},
};
use crate::lower::{Integral, canonical};
use crate::parse::{Form, Kept};
use std::collections::HashSet;

/// What the energy of a flow is called.
pub(in crate::derive) const ENERGY: &str = "energy";

/// A flow before its methods are derived.
#[derive(Debug)]
pub(crate) struct Flow {
    pub(crate) form: Form,
    /// f.
    pub(crate) field: Vec<Id>,
    /// H with S − C, if x' = (S − C) ∇H is known.
    pub(crate) energy: Option<(Id, Vec<Vec<Id>>)>,
    /// What damping adds to the field, −C ∇H.
    loss: Option<Vec<Id>>,
    /// What steps keep.
    pub(crate) kept: Vec<Named>,
    /// What is constant as well, and not kept; with whether it is a Casimir.
    pub(crate) also: Vec<(Id, bool)>,
    /// Its divergence, if no energy has the field because of that.
    pub(crate) divergent: Option<Id>,
}

/// A function that is kept, or whose change is known.
#[derive(Clone, Debug)]
pub(crate) struct Named {
    pub(crate) name: String,
    pub(crate) conserved: Conserved,
    pub(crate) origin: Origin,
}

/// Who says that a function is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    /// The user, and it was proven.
    Listed,
    /// The user alone.
    Assumed,
    /// It is the energy.
    Energy,
    /// It was found.
    Found,
}

impl Flow {
    /// x' = f(x, t), and what it is said to keep.
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
            kept: keeps.map(named).collect(),
            also: vec![],
            divergent: None,
        }
    }

    /// x' = (S − C) ∇H, and what it keeps.
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
            kept,
            also: vec![],
            divergent: None,
        }
    }

    /// x' = J ∇H with an energy that was recovered from the field: it is kept as well, unless it is a function of what is listed.
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

    /// The first function that is kept, by whose gradient a field is split.
    pub(crate) fn first(&self) -> Option<&Named> {
        self.kept.iter().find(|named| named.conserved.but.is_none())
    }

    /// Whether S(m) ∇̄H keeps all that is kept: H alone, or with Casimirs.
    pub(in crate::derive) fn is_kept_by_structure(&self) -> bool {
        self.form == Form::Structured || self.kept.iter().all(|named| named.origin == Origin::Energy)
    }

    /// Adds what is found to be constant: linear functions to what a field keeps, because a projection onto others would lose them;
    /// and all the rest for the report.
    pub(crate) fn search(&mut self, graph: &mut Graph, names: &dyn Naming) {
        let x = coordinates(self.field.len());
        let found = search::kept_along(graph, &x, std::slice::from_ref(&self.field)).unwrap_or_default();
        let proven = |graph: &mut Graph, value| claims::is_kept(graph, &x, &self.field, value, None).is_zero();
        let found = found.into_iter().filter(|kept| proven(graph, kept.value)).collect();
        for (kept, everywhere) in self.new_among(graph, found) {
            if everywhere && kept.linear && self.form == Form::Field && !self.kept.is_empty() {
                self.keep_found(graph, kept.value, names);
            } else {
                self.also.push((kept.value, false));
            }
        }
    }

    /// Adds Casimirs, which are constant along the rows of S, with one that S was made of. Damping changes them as it changes H.
    pub(crate) fn search_casimirs(
        &mut self,
        graph: &mut Graph,
        Structure { matrix: rows, casimir: written, .. }: &Structure,
        names: &dyn Naming,
    ) {
        let x = coordinates(self.field.len());
        // The one that was written comes first: what is found may be a function of it that is defined at fewer states, as its logarithm.
        let mut found: Vec<_> = written.iter().map(|value| search::Kept { value: *value, linear: false }).collect();
        found.extend(search::kept_along(graph, &x, rows).unwrap_or_default());
        // What reads time is constant along the rows, and not along the flow.
        found.retain(|kept| !graph.reads(kept.value).t);
        found.retain(|kept| claims::is_casimir(graph, &x, rows, kept.value).is_ok());
        for (kept, everywhere) in self.new_among(graph, found) {
            if everywhere {
                self.keep_found(graph, kept.value, names);
            } else if self.loss.is_none() {
                self.also.push((kept.value, true));
            }
        }
    }

    fn keep_found(&mut self, graph: &Graph, value: Id, names: &dyn Naming) {
        let name = Printer::new(graph, names).excerpt(value);
        let conserved = Conserved { value, but: self.loss.clone() };
        self.kept.push(Named { name, conserved, origin: Origin::Found });
    }

    /// Those that are no functions of what is known already, each with whether it is defined wherever that and the field are: a logarithm that
    /// nothing else takes would leave steps with fewer states than the flow has.
    fn new_among(&self, graph: &mut Graph, found: Vec<search::Kept>) -> Vec<(search::Kept, bool)> {
        if found.is_empty() {
            return vec![];
        }
        let known: Vec<Id> = self
            .kept
            .iter()
            .map(|kept| kept.conserved.value)
            .chain(self.also.iter().map(|(value, _)| *value))
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

/// x, in order.
pub(in crate::derive) fn coordinates(n: usize) -> Vec<Symbol> {
    (0..n as u32).map(Symbol::Position).collect()
}
