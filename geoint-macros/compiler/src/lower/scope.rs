//! How names are bound and found, level by level, as rustc resolves them.

use super::value::{Around, Callable, Item, Level, Scopes, Value};
use crate::parse::{Function, Outside};
use std::rc::Rc;

/// What a name stands for.
pub(super) enum Found {
    Variable(Value),
    /// An item, and what it sees: the items around it, never the variables.
    Item(Item, Scopes),
}

impl Default for Scopes {
    fn default() -> Self {
        let levels = vec![Rc::default()];
        Scopes { levels, closed_below: (0, Around::Function), outside: Rc::default(), foreign: false }
    }
}

/// Why a variable cannot be assigned to.
pub(super) enum Refused {
    Unknown,
    Outside(Around),
}

impl Scopes {
    /// What a function sees that stands in a file by itself.
    pub(super) fn of_file(outside: &Rc<Outside>, functions: &[Function]) -> Self {
        let mut scopes = Scopes { outside: outside.clone(), ..Scopes::default() };
        for (name, value) in outside.constants() {
            scopes.declare(name, Item::Import(Value::Integer(value)));
        }
        for function in functions {
            let sees = Scopes { foreign: true, ..Scopes::of_file(&function.outside, &function.used) };
            scopes.declare(&function.path, Item::Outside(Rc::new(Callable::of(&function.item)), Rc::new(sees)));
        }
        scopes
    }

    pub(super) fn outside(&self) -> &Rc<Outside> {
        &self.outside
    }

    /// From here on types have these names.
    pub(super) fn name_types(&mut self, outside: Rc<Outside>) {
        self.outside = outside;
    }

    /// Whether names that are not known mean something else than they do beside the energy.
    pub(super) fn are_foreign(&self) -> bool {
        self.foreign
    }

    pub(super) fn enter(&mut self) {
        self.levels.push(Rc::default());
    }

    pub(super) fn leave(&mut self) {
        self.levels.pop();
    }

    fn innermost(&mut self) -> Option<&mut Level> {
        self.levels.last_mut().map(Rc::make_mut)
    }

    pub(super) fn bind(&mut self, name: &impl ToString, value: Value) {
        if let Some(level) = self.innermost() {
            level.variables.insert(name.to_string(), value);
        }
    }

    pub(super) fn declare(&mut self, name: &impl ToString, item: Item) {
        if let Some(level) = self.innermost() {
            level.items.insert(name.to_string(), item);
        }
    }

    pub(super) fn get(&self, name: &str) -> Option<Found> {
        let (level, names) = self.levels.iter().enumerate().rev().find(|(_, level)| level.knows(name))?;
        Some(match names.variables.get(name) {
            Some(value) => Found::Variable(value.clone()),
            None => Found::Item(names.items.get(name)?.clone(), self.items_only(level)),
        })
    }

    /// Returns the variable whose name is most like an unknown one: it differs in case, or by one letter that is other, missing, added or swapped.
    pub(super) fn similar(&self, unknown: &str) -> Option<&str> {
        let known = self.levels.iter().rev().flat_map(|level| level.variables.keys());
        known.filter(|known| is_similar(known, unknown)).min().map(String::as_str)
    }

    /// What an item of a level sees.
    fn items_only(&self, level: usize) -> Scopes {
        let items = |level: &Rc<Level>| Rc::new(Level { items: level.items.clone(), ..Level::default() });
        let levels = self.levels[..=level].iter().map(items).collect();
        Scopes { levels, closed_below: (0, Around::Function), outside: self.outside.clone(), foreign: self.foreign }
    }

    fn level_of_variable(&self, name: &str) -> Option<usize> {
        let level = self.levels.iter().rposition(|level| level.knows(name))?;
        self.levels[level].variables.contains_key(name).then_some(level)
    }

    /// A variable to assign to.
    pub(super) fn assignable(&mut self, name: &str) -> Result<&mut Value, Refused> {
        let level = self.level_of_variable(name).ok_or(Refused::Unknown)?;
        let (outside, around) = self.closed_below;
        if level < outside {
            return Err(Refused::Outside(around));
        }
        Rc::make_mut(&mut self.levels[level]).variables.get_mut(name).ok_or(Refused::Unknown)
    }

    /// From here on outer variables may be read but not assigned to; returns what [`Scopes::open`] needs.
    pub(super) fn close(&mut self, around: Around) -> (usize, Around) {
        std::mem::replace(&mut self.closed_below, (self.levels.len(), around))
    }

    pub(super) fn open(&mut self, before: (usize, Around)) {
        self.closed_below = before;
    }
}

impl Level {
    fn knows(&self, name: &str) -> bool {
        self.variables.contains_key(name) || self.items.contains_key(name)
    }
}

/// Returns whether two names differ in case only, or by one letter. Names of one letter are similar in case only.
fn is_similar(a: &str, b: &str) -> bool {
    let [a, b] = [a, b].map(|name| name.to_lowercase().chars().collect::<Vec<_>>());
    if a == b {
        return true;
    }
    let (short, long) = if a.len() < b.len() { (&a, &b) } else { (&b, &a) };
    let start = short.iter().zip(long).take_while(|(a, b)| a == b).count();
    let (short, long) = (&short[start..], &long[start..]);
    let is_swapped =
        short.len() >= 2 && long.len() == short.len() && short[..2] == [long[1], long[0]] && short[2..] == long[2..];
    let is_other = short.len() == long.len() && short[1..] == long[1..];
    let is_added = short.len() + 1 == long.len() && *short == long[1..];
    a.len().min(b.len()) > 1 && (is_swapped || is_other || is_added)
}
