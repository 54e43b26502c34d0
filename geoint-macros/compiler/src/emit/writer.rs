//! Prints routines: declarations, inputs, statements and results.
//!
//! Most emitted tokens come from this file, and are pushed one by one. In an unoptimised build, as proc macros are, a push is
//! several times faster than a quotation.

use super::tokens::Tokens;
use crate::ir::{HashMap, Number, Symbol};
use crate::schedule::{Array, Block, Layout, Operand, Place, Register};
use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::{ToTokens, format_ident};
use std::cell::RefCell;

/// The arrays of slots of earlier levels.
pub(crate) const SLOTS: [&str; 2] = ["prepared", "start"];

/// The names in a routine.
pub(crate) struct Names<'a> {
    /// The registers. All routines share their names.
    pub(super) registers: &'a RefCell<Vec<Ident>>,
    /// The places of inputs.
    pub(super) layout: &'a Layout<'a>,
    /// Returns the name of an array, or of a number.
    pub(super) array: &'a dyn Fn(Array) -> Tokens,
}

/// Prints a routine: declarations, inputs, statements, and the end that `finish` makes of the results.
///
/// One `let` declares all variables. A `let` for each variable would nest a scope for each variable. Thousands of
/// scopes overflow the stack of rustc, when rustc writes debug information.
pub(crate) fn routine<T: ToTokens>(
    block: &Block,
    names: Names<'_>,
    finish: impl FnOnce(Vec<Tokens>) -> T,
) -> TokenStream {
    let mut writer = Writer {
        given_names: HashMap::default(),
        declared: vec![],
        given: vec![],
        words: vec![],
        registers: names.registers.take(),
        entries: HashMap::default(),
        tokens: vec![],
        names,
    };
    block.statements.iter().for_each(|statement| writer.statement(statement));
    let results = block.results.iter().map(|operand| writer.apart(|writer| writer.operand(operand)).into()).collect();
    let last = finish(results);
    let declared = std::mem::take(&mut writer.declared);
    let mut tokens = writer.declaration(&declared, &block.registers());
    writer.names.registers.replace(writer.registers);
    tokens.extend(writer.given);
    tokens.extend(writer.tokens);
    last.to_tokens(&mut tokens);
    tokens
}

/// Prints the statements of a routine.
pub(super) struct Writer<'a> {
    pub(super) names: Names<'a>,
    /// Inputs, slots and constants get a name at the start of the routine, so statements consist of names only.
    given_names: HashMap<Operand, Ident>,
    /// These names in order.
    declared: Vec<Ident>,
    /// The assignments of these names.
    given: Vec<TokenTree>,
    /// Cache of words, filled on demand.
    words: Vec<(&'static str, Ident)>,
    registers: Vec<Ident>,
    /// The registers in arrays of loops.
    pub(super) entries: HashMap<Register, TokenStream>,
    tokens: Vec<TokenTree>,
}

impl Writer<'_> {
    /// Returns `let (names, registers,);`. A branch has no names of its own.
    pub(super) fn declaration(&mut self, names: &[Ident], registers: &[Register]) -> TokenStream {
        if names.is_empty() && registers.is_empty() {
            return TokenStream::new();
        }
        self.inside(|writer| {
            writer.word("let");
            writer.grouped(Delimiter::Parenthesis, |writer| {
                for name in names {
                    writer.tokens.push(name.clone().into());
                    writer.punct(",");
                }
                writer.registers(registers);
            });
            writer.punct(";");
        })
    }

    /// Prints the name of an operand.
    pub(super) fn operand(&mut self, operand: &Operand) {
        match operand {
            Operand::Truth(value) => self.word(if *value { "true" } else { "false" }),
            Operand::Register(register) => match self.entries.get(register) {
                Some(entry) => self.tokens.extend(entry.clone()),
                None => self.register(*register),
            },
            Operand::Input(Symbol::Time) => self.word("t"),
            Operand::Input(Symbol::StepStart) => self.word("start"),
            Operand::Input(Symbol::StepEnd) => self.word("end"),
            Operand::Input(Symbol::StepLength) => self.word("h"),
            Operand::Input(Symbol::GradientWeight) => self.word("g"),
            Operand::Input(_) | Operand::Slot(..) | Operand::Constant(_) => {
                let name = match self.given_names.get(operand) {
                    Some(name) => name.clone(),
                    None => self.give(*operand),
                };
                self.tokens.push(name.into());
            }
        }
    }

    /// Gives a name to an input, a slot or a constant: `name = value;` before all statements.
    fn give(&mut self, operand: Operand) -> Ident {
        let name = match operand {
            Operand::Input(Symbol::Position(i)) => format_ident!("q{i}"),
            Operand::Input(Symbol::Momentum(i)) => format_ident!("p{i}"),
            Operand::Input(Symbol::Parameter(i)) => format_ident!("a{i}"),
            Operand::Input(Symbol::PositionIncrement(i)) => format_ident!("dq{i}"),
            Operand::Input(Symbol::MomentumIncrement(i)) => format_ident!("dp{i}"),
            Operand::Input(Symbol::Action) => format_ident!("action"),
            Operand::Input(Symbol::ActionIncrement) => format_ident!("ds"),
            // Not `p0`: momenta have this name.
            Operand::Slot(level, i) => format_ident!("{}_{i}", SLOTS[level]),
            _ => format_ident!("k{}", self.given_names.len()),
        };
        self.given_names.insert(operand, name.clone());
        self.declared.push(name.clone());
        let mut given = self.apart(|writer| {
            writer.tokens.push(name.clone().into());
            writer.punct("=");
            match operand {
                Operand::Input(symbol) => writer.place(&writer.names.layout.place(symbol)),
                Operand::Slot(level, index) => {
                    writer.word(SLOTS[level]);
                    writer.grouped(Delimiter::Bracket, |writer| writer.literal(index));
                }
                Operand::Constant(value) => writer.constant(value),
                Operand::Truth(_) | Operand::Register(_) => {}
            }
            writer.punct(";");
        });
        self.given.append(&mut given);
        name
    }

    /// Prints an entry of an array, or a number.
    pub(super) fn place(&mut self, place: &Place) {
        (self.names.array)(place.array).at(&place.indices).push_to(&mut self.tokens);
    }

    /// Prints a constant of the scalar type.
    fn constant(&mut self, value: Number) {
        let value = value.to_f64();
        self.path("R", "from_f64");
        self.grouped(Delimiter::Parenthesis, |writer| {
            if value < 0.0 {
                writer.punct("-");
            }
            // Coefficients of a derivative may overflow. The step then reports a number that is not finite.
            match value.abs() {
                magnitude if magnitude.is_finite() => writer.tokens.push(Literal::f64_unsuffixed(magnitude).into()),
                magnitude => writer.path("f64", if magnitude.is_nan() { "NAN" } else { "INFINITY" }),
            }
        });
    }

    // ------------------------------------------------------------------------------------------------------ tokens

    /// Pushes quoted tokens.
    pub(super) fn extend(&mut self, tokens: TokenStream) {
        self.tokens.extend(tokens);
    }

    /// Prints an identifier.
    pub(super) fn word(&mut self, word: &'static str) {
        for (known, ident) in &self.words {
            if *known == word {
                self.tokens.push(ident.clone().into());
                return;
            }
        }
        let ident = Ident::new(word, Span::call_site());
        self.words.push((word, ident.clone()));
        self.tokens.push(ident.into());
    }

    /// Prints `of::name`.
    pub(super) fn path(&mut self, of: &'static str, name: &'static str) {
        self.word(of);
        self.punct("::");
        self.word(name);
    }

    /// Prints a count.
    pub(super) fn literal(&mut self, number: usize) {
        self.tokens.push(Literal::usize_unsuffixed(number).into());
    }

    /// Prints a register.
    pub(super) fn register(&mut self, register: Register) {
        while self.registers.len() <= register {
            self.registers.push(Ident::new(&format!("v{}", self.registers.len()), Span::mixed_site()));
        }
        self.tokens.push(self.registers.as_slice()[register].clone().into());
    }

    /// Prints punctuation of one or two characters.
    pub(super) fn punct(&mut self, punct: &str) {
        let (last, first) = punct.as_bytes().split_last().unwrap_or((&b' ', &[]));
        for c in first {
            self.tokens.push(Punct::new(*c as char, Spacing::Joint).into());
        }
        self.tokens.push(Punct::new(*last as char, Spacing::Alone).into());
    }

    /// Prints `a, b,` of registers.
    pub(super) fn registers(&mut self, registers: &[Register]) {
        for register in registers {
            self.register(*register);
            self.punct(",");
        }
    }

    /// Prints `a, b,` of operands.
    pub(super) fn separated(&mut self, operands: &[Operand]) {
        for operand in operands {
            self.operand(operand);
            self.punct(",");
        }
    }

    /// Prints `[a, b,]` of operands.
    pub(super) fn list(&mut self, operands: &[Operand]) {
        self.grouped(Delimiter::Bracket, |writer| writer.separated(operands));
    }

    /// Prints a group. `write` prints its contents.
    pub(super) fn grouped(&mut self, delimiter: Delimiter, write: impl FnOnce(&mut Self)) {
        let tokens = self.inside(write);
        self.tokens.push(Group::new(delimiter, tokens).into());
    }

    /// Returns the tokens of `write`.
    pub(super) fn inside(&mut self, write: impl FnOnce(&mut Self)) -> TokenStream {
        self.apart(write).into_iter().collect()
    }

    /// Returns the tokens of `write` as a list.
    fn apart(&mut self, write: impl FnOnce(&mut Self)) -> Vec<TokenTree> {
        let outside = std::mem::take(&mut self.tokens);
        write(self);
        std::mem::replace(&mut self.tokens, outside)
    }
}
