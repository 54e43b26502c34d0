//! Names and what they are bound to.

use super::value::Value;
use proc_macro2::Ident;
use std::collections::{HashMap, HashSet};

/// Nested scopes of one function body.
pub(super) struct Scopes {
    levels: Vec<HashMap<String, Value>>,
    /// Variables of levels below this one may not be assigned to: they belong to what is around a branch or closure.
    closed_below: usize,
    /// Accumulators of the loops around, with the level above which the loop's own variables live.
    accumulators: Vec<(HashSet<String>, usize)>,
}

impl Default for Scopes {
    fn default() -> Self {
        Scopes { levels: vec![HashMap::new()], closed_below: 0, accumulators: vec![] }
    }
}

/// Why a variable cannot be added to.
pub(super) enum Refused {
    Unknown,
    Outside,
}

impl Scopes {
    pub(super) fn enter(&mut self) {
        self.levels.push(HashMap::new());
    }

    pub(super) fn leave(&mut self) {
        self.levels.pop();
    }

    pub(super) fn bind(&mut self, name: &Ident, value: Value) {
        if let Some(level) = self.levels.last_mut() {
            level.insert(name.to_string(), value);
        }
    }

    fn level_of(&self, name: &str) -> Option<usize> {
        self.levels.iter().rposition(|level| level.contains_key(name))
    }

    pub(super) fn get(&self, name: &str) -> Option<&Value> {
        self.level_of(name).and_then(|level| self.levels[level].get(name))
    }

    /// Whether a name is being accumulated by a loop around, so that its value is not known before the loop ends.
    pub(super) fn is_accumulating(&self, name: &str) -> bool {
        let Some(level) = self.level_of(name) else { return false };
        self.accumulators.iter().any(|(names, outside)| level < *outside && names.contains(name))
    }

    /// A variable to add to.
    pub(super) fn accumulator(&mut self, name: &str) -> Result<&mut Value, Refused> {
        let level = self.level_of(name).ok_or(Refused::Unknown)?;
        if level < self.closed_below {
            return Err(Refused::Outside);
        }
        self.levels[level].get_mut(name).ok_or(Refused::Unknown)
    }

    /// From here on outer variables may be read but not assigned to; returns what [`Scopes::open`] needs.
    pub(super) fn close(&mut self) -> usize {
        std::mem::replace(&mut self.closed_below, self.levels.len())
    }

    pub(super) fn open(&mut self, before: usize) {
        self.closed_below = before;
    }

    pub(super) fn enter_loop(&mut self, accumulators: HashSet<String>) {
        self.accumulators.push((accumulators, self.levels.len()));
    }

    pub(super) fn leave_loop(&mut self) {
        self.accumulators.pop();
    }

    /// The innermost scope with everything that is visible in it, for a closure.
    pub(super) fn snapshot(&self) -> HashMap<String, Value> {
        let mut all = HashMap::new();
        for level in &self.levels {
            all.extend(level.iter().map(|(name, value)| (name.clone(), value.clone())));
        }
        all
    }

    /// Scopes in which only `visible` can be seen.
    pub(super) fn with(visible: HashMap<String, Value>) -> Self {
        Scopes { levels: vec![visible], ..Scopes::default() }
    }
}
