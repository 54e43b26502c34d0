//! Alike statements as arrays: `let a0: [_; 63] = from_fn(|i| …);`

use super::given::Given;
use super::tokens::Tokens;
use super::writer::{SLOTS, Writer};
use crate::ir::HashMap;
use crate::schedule::{Block, Families, Family, Indices, Instruction, Item, Operand, Register, Run, Source, families};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};
use std::cell::RefCell;

/// The arrays of a routine by their numbers, and how many indices they have.
type Arrays = HashMap<usize, (Tokens, usize)>;

/// A result of a routine.
pub(super) enum Output {
    Value(Tokens),
    /// The loop that writes this one and others.
    Loop(TokenStream),
    /// By the loop of another one.
    Written,
}

impl Writer<'_> {
    /// Families of alike statements, and the arrays that they read and write.
    pub(super) fn families(&self, block: &Block, targets: &[Given]) -> Option<(Families, Arrays)> {
        let arrays: RefCell<Arrays> = RefCell::default();
        let place = |given: &Given| {
            let mut indices: Indices = [0; 3];
            if given.indices.is_empty() || given.indices.len() > indices.len() {
                return None;
            }
            for (to, from) in indices.iter_mut().zip(given.indices.iter().rev()) {
                *to = *from as i32;
            }
            arrays.borrow_mut().entry(given.array).or_insert_with(|| (given.base.clone(), given.indices.len()));
            Some((given.array, indices))
        };
        let given = |symbol| place(&(self.names.input)(symbol));
        let families = families((block, self.names.degrees), &given, || targets.iter().map(place).collect())?;
        Some((families, arrays.into_inner()))
    }

    /// Writes the statements and loops of a block; returns its results, and the registers that are in no array.
    pub(super) fn with_loops(
        &mut self,
        block: &Block,
        (families, arrays): (Families, Arrays),
    ) -> (Vec<Output>, Vec<Register>) {
        let mut alone = vec![];
        let is_written = |number: &usize| families.all[number].target.is_some();
        for (register, (number, result, place)) in &families.members {
            if !is_written(number) {
                let place = Literal::usize_unsuffixed(*place);
                let entry = entry(&families, (*number, *result), &quote!(#place));
                self.members.insert(*register, entry);
            }
        }
        for item in &families.items {
            match item {
                Item::Statement(number) => {
                    let statement = &block.statements[*number];
                    alone.extend(statement.registers());
                    self.statement(statement);
                }
                Item::Family(number) if is_written(number) => {}
                Item::Family(number) => {
                    let array = self.array(&families, &arrays, *number);
                    self.extend(array);
                }
            }
        }
        let mut results = vec![];
        for operand in &block.results {
            let member = match operand {
                Operand::Register(register) => families.members.get(register).filter(|(number, ..)| is_written(number)),
                _ => None,
            };
            results.push(match member {
                None => Output::Value(self.result(operand)),
                Some((number, _, 0)) => Output::Loop(self.array(&families, &arrays, *number)),
                Some(_) => Output::Written,
            });
        }
        (results, alone)
    }

    /// The statement that computes an array, or writes to one.
    fn array(&mut self, families: &Families, arrays: &Arrays, number: usize) -> TokenStream {
        let Family { length, reads, body, results, target } = &families.all[&number];
        let mut tokens = TokenStream::new();
        for (register, Run { source, first, step }) in reads {
            let register = self.inside(|writer| writer.register(*register));
            let at = |k: usize| index(first[k], step[k]);
            let value = match source {
                Source::Given(array) => given(&arrays[array], at),
                Source::Slots(level) => {
                    let (slots, at) = (format_ident!("{}", SLOTS[*level]), at(0));
                    quote!(#slots[#at])
                }
                Source::Family(family, result) => entry(families, (*family, *result), &at(0)),
                Source::One(_) => continue,
            };
            tokens.extend(quote!(let #register = #value;));
        }
        for (registers, instruction) in body {
            let names: Vec<TokenStream> = registers.iter().map(|r| self.inside(|writer| writer.register(*r))).collect();
            let value = match (&names[..], instruction) {
                ([_, _], Instruction::Call(_, x)) => self.inside(|writer| writer.method("sin_cos", &x[0], &[])),
                _ => self.inside(|writer| writer.instruction(instruction)),
            };
            let names = one_or_pair(&names);
            tokens.extend(quote!(let #names = #value;));
        }
        let results: Vec<TokenStream> = results.iter().map(|r| self.inside(|writer| writer.register(*r))).collect();
        let (name, length, results) = (name(number), Literal::usize_unsuffixed(*length), one_or_pair(&results));
        if let Some(Run { source: Source::Given(array), first, step }) = target {
            let target = given(&arrays[array], |k| index(first[k], step[k]));
            let i = member();
            return quote!(for #i in 0..#length { #tokens #target = #results; });
        }
        let i = member();
        quote!(let #name: [_; #length] = ::core::array::from_fn(|#i| { #tokens #results });)
    }
}

/// An entry of an array that the routine is given.
fn given((base, indices): &(Tokens, usize), at: impl Fn(usize) -> TokenStream) -> TokenStream {
    let indices = (0..*indices).rev().map(at);
    quote!(#base #([#indices])*)
}

fn name(number: usize) -> Ident {
    Ident::new(&format!("array{number}"), Span::mixed_site())
}

/// Which member of a family it is. Nothing of the user can be meant.
fn member() -> Ident {
    Ident::new("i", Span::mixed_site())
}

fn one_or_pair(names: &[TokenStream]) -> TokenStream {
    match names {
        [name] => name.clone(),
        names => quote!((#(#names),*)),
    }
}

/// An entry of a family's array: a number, or one of a pair.
fn entry(families: &Families, (number, result): (usize, usize), at: &TokenStream) -> TokenStream {
    let name = name(number);
    if families.all[&number].results.len() == 1 {
        return quote!(#name[#at]);
    }
    let result = Literal::usize_unsuffixed(result);
    quote!(#name[#at].#result)
}

/// `first + i·step`.
fn index(first: i32, step: i32) -> TokenStream {
    let number = |n: i32| Literal::usize_unsuffixed(n.unsigned_abs() as usize);
    let i = member();
    let moved = match step {
        0 => None,
        1 | -1 => Some(quote!(#i)),
        step => {
            let step = number(step);
            Some(quote!(#step * #i))
        }
    };
    let begin = number(first);
    match moved {
        None => quote!(#begin),
        Some(moved) if step < 0 => quote!(#begin - #moved),
        Some(moved) if first == 0 => moved,
        Some(moved) => quote!(#moved + #begin),
    }
}
