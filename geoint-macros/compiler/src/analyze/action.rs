//! Splits an energy with an action into H₀(q, p, t) + γ(t)·s.

use super::terms_where;
use crate::diff::constraint::Action;
use crate::ir::{Graph, Id, Symbol};

/// Returns γ of a term γ(t)·s. `None` if the term is not of this form.
pub(crate) fn decay_of(graph: &mut Graph, term: Id) -> Option<Id> {
    let s = graph.symbol(Symbol::Action);
    let decay = graph.div(term, s);
    (!graph.reads(decay).state()).then_some(decay)
}

/// Returns H₀ and γ, or a term that reads s and is not γ(t)·s.
pub(crate) fn with_decay_of_time(graph: &mut Graph, energy: Id) -> Result<Action, Id> {
    let (mut rest, mut decay) = (vec![], graph.zero());
    for term in terms_where(graph, energy, |reads| reads.s) {
        if !graph.reads(term).s {
            rest.push(term);
            continue;
        }
        let rate = decay_of(graph, term).ok_or(term)?;
        decay = graph.add(decay, rate);
    }
    Ok(Action { energy: graph.sum(&rest), decay })
}
