//! Prints loops: `let array0: [_; 63] = from_fn(|i| …);`, or `for i in 0..63 { … }` if the loop writes to an array of the caller.

use super::tokens::Tokens;
use super::writer::{SLOTS, Writer};
use crate::schedule::{Call, Computed, Loop, Register, Source, Statement, Successive};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, format_ident, quote};

impl Writer<'_> {
    /// Prints a loop. Later statements read the entries of its array.
    pub(super) fn print_loop(&mut self, each: &Loop) {
        let mut body = TokenStream::new();
        for (register, successive) in &each.reads {
            let (register, value) = (self.names_of(&[*register]), self.entry_of(successive));
            body.extend(quote!(let #register = #value;));
        }
        for statement in &each.body {
            let (registers, value) = match statement {
                Statement::Let(register, instruction) => {
                    (vec![*register], self.inside(|writer| writer.instruction(instruction)))
                }
                Statement::Call(Call { results, arguments, .. }) => {
                    (results.concat(), self.inside(|writer| writer.sin_cos(&arguments[0])))
                }
                _ => continue,
            };
            let names = self.names_of(&registers);
            body.extend(quote!(let #names = #value;));
        }
        let (length, results, i) = (number(each.length), self.names_of(&each.results), member());
        if let Some(target) = &each.target {
            let target = self.entry_of(target);
            self.extend(quote!(for #i in 0..#length { #body #target = #results; }));
            return;
        }
        let name = name(each.array);
        self.extend(quote!(let #name: [_; #length] = ::core::array::from_fn(|#i| { #body #results });));
        for (i, registers) in each.members.iter().enumerate() {
            for (k, register) in registers.iter().enumerate() {
                let computed = Computed { array: each.array, part: (registers.len() > 1).then_some(k) };
                self.entries.insert(*register, entry(computed, &number(i)));
            }
        }
    }

    /// Returns the name of a register, or a pair of names.
    fn names_of(&mut self, registers: &[Register]) -> TokenStream {
        let names: Vec<TokenStream> =
            registers.iter().map(|register| self.inside(|writer| writer.register(*register))).collect();
        match &names[..] {
            [name] => name.clone(),
            names => quote!((#(#names),*)),
        }
    }

    /// Returns the operand or the target of member i.
    fn entry_of(&self, successive: &Successive) -> TokenStream {
        let at = |k: usize| index(successive.first[k], successive.step[k]);
        match successive.source {
            Source::Given(array, rank) => {
                let (array, indices) = ((self.names.array)(array), (0..rank).rev().map(at));
                quote!(#array #([#indices])*)
            }
            Source::Slots(level) => {
                let (slots, at) = (format_ident!("{}", SLOTS[level]), at(0));
                quote!(#slots[#at])
            }
            Source::Computed(computed) => entry(computed, &at(0)),
            // A shared operand is read before the loop.
            Source::One(_) => Tokens::default().into_token_stream(),
        }
    }
}

/// Returns the name of the array of a loop.
fn name(array: usize) -> Ident {
    Ident::new(&format!("array{array}"), Span::mixed_site())
}

/// Returns the name of the index of members. Its hygiene separates the index from names of the user.
fn member() -> Ident {
    Ident::new("i", Span::mixed_site())
}

/// Returns an entry of the array of a loop: a number, or a part of a pair.
fn entry(computed: Computed, at: &impl ToTokens) -> TokenStream {
    let (name, part) = (name(computed.array), computed.part.map(number));
    match part {
        None => quote!(#name[#at]),
        Some(part) => quote!(#name[#at].#part),
    }
}

/// Returns a literal.
fn number(n: usize) -> Literal {
    Literal::usize_unsuffixed(n)
}

/// Returns `first + i·step`.
fn index(first: i32, step: i32) -> TokenStream {
    let number = |n: i32| number(n.unsigned_abs() as usize);
    let (i, begin) = (member(), number(first));
    let moved = match step {
        0 => return quote!(#begin),
        1 | -1 => quote!(#i),
        step => {
            let step = number(step);
            quote!(#step * #i)
        }
    };
    match first {
        _ if step < 0 => quote!(#begin - #moved),
        0 => moved,
        _ => quote!(#moved + #begin),
    }
}
