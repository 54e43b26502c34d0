//! Names of methods, so that a program can select a method by its name.

use core::fmt;

/// Largest number of nested methods in a name.
const MAX_DEPTH: usize = 4;

/// The name of a method, as in "BlanesMoan4" or "Yoshida4 of StormerVerlet".
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Name {
    /// From the outermost method to the innermost; empty at the end.
    words: [&'static str; MAX_DEPTH],
}

impl Name {
    /// Returns a name of one word.
    pub const fn new(word: &'static str) -> Self {
        Name { words: [word, "", "", ""] }
    }

    /// Returns the name "`self` of `inner`". Words beyond the fourth are dropped.
    pub const fn of(mut self, inner: Name) -> Self {
        let (mut at, mut from) = (0, 0);
        while at < MAX_DEPTH && !self.words[at].is_empty() {
            at += 1;
        }
        while at < MAX_DEPTH {
            self.words[at] = inner.words[from];
            (at, from) = (at + 1, from + 1);
        }
        self
    }

    /// The words from the outermost method to the innermost.
    pub fn words(&self) -> impl Iterator<Item = &'static str> {
        self.words.into_iter().take_while(|word| !word.is_empty())
    }
}

impl PartialEq<str> for Name {
    fn eq(&self, other: &str) -> bool {
        let mut rest = Some(other);
        for (i, word) in self.words().enumerate() {
            rest = rest.and_then(|rest| if i == 0 { Some(rest) } else { rest.strip_prefix(" of ") });
            rest = rest.and_then(|rest| rest.strip_prefix(word));
        }
        rest == Some("")
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, word) in self.words().enumerate() {
            f.write_str(if i == 0 { "" } else { " of " })?;
            f.write_str(word)?;
        }
        Ok(())
    }
}
