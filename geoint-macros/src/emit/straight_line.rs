//! Statements to tokens.

use crate::ir::{Function, Number, Relation, Symbol};
use crate::schedule::{Block, Instruction, Operand, Register, Statement};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashMap;

/// An expression nested deeper than this gets a name.
const MAX_INLINE: usize = 6;

/// The arrays in which routines find the slots of earlier levels.
pub(crate) const SLOTS: [&str; 2] = ["prepared", "start"];

/// The statements of a block, in which symbols are called as `input` says, followed by what `finish` makes of its results.
pub(crate) fn routine(
    block: &Block,
    input: &dyn Fn(Symbol) -> TokenStream,
    finish: impl FnOnce(Vec<TokenStream>) -> TokenStream,
) -> TokenStream {
    let mut writer = Writer { input, reads: block.reads(), inline: HashMap::new() };
    let (statements, results) = writer.block(block);
    let finish = finish(results);
    quote!(#statements #finish)
}

struct Writer<'a> {
    input: &'a dyn Fn(Symbol) -> TokenStream,
    reads: HashMap<Register, usize>,
    /// Registers that are read once, as expressions with their depth.
    inline: HashMap<Register, (TokenStream, usize)>,
}

impl Writer<'_> {
    fn block(&mut self, block: &Block) -> (TokenStream, Vec<TokenStream>) {
        let mut tokens = TokenStream::new();
        for statement in &block.statements {
            tokens.extend(self.statement(statement));
        }
        let results = block.results.iter().map(|operand| self.operand(operand).0).collect();
        (tokens, results)
    }

    fn statement(&mut self, statement: &Statement) -> TokenStream {
        match statement {
            Statement::Let(register, instruction) => {
                let (value, depth) = self.instruction(instruction);
                if self.reads.get(register).copied().unwrap_or(0) <= 1 && depth < MAX_INLINE {
                    self.inline.insert(*register, (value, depth));
                    return TokenStream::new();
                }
                let name = name(*register);
                quote!(let #name = #value;)
            }
            Statement::SinCos(sin, cos, x) => {
                let (sin, cos, x) = (name(*sin), name(*cos), self.atom(x).0);
                quote!(let (#sin, #cos) = #x.sin_cos();)
            }
            Statement::If { registers, condition, first, second } => {
                let condition = self.operand(condition).0;
                let (first, a) = self.block(first);
                let (second, b) = self.block(second);
                let names = registers.iter().map(|register| name(*register));
                quote!(let (#(#names,)*) = if #condition { #first (#(#a,)*) } else { #second (#(#b,)*) };)
            }
        }
    }

    /// An instruction as an expression, with how deeply it is nested.
    fn instruction(&mut self, instruction: &Instruction) -> (TokenStream, usize) {
        let operands: Vec<_> = instruction.operands().iter().map(|operand| self.atom(operand)).collect();
        let depth = operands.iter().map(|(_, depth)| depth + 1).max().unwrap_or(0);
        let x: Vec<&TokenStream> = operands.iter().map(|(tokens, _)| tokens).collect();
        let tokens = match (instruction, &x[..]) {
            (Instruction::Neg(_), [a]) => quote!(-#a),
            (Instruction::Not(_), [a]) => quote!(!#a),
            (Instruction::Add(..), [a, b]) => quote!(#a + #b),
            (Instruction::Sub(..), [a, b]) => quote!(#a - #b),
            (Instruction::Mul(..), [a, b]) => quote!(#a * #b),
            (Instruction::Div(..), [a, b]) => quote!(#a / #b),
            (Instruction::And(..), [a, b]) => quote!(#a && #b),
            (Instruction::Or(..), [a, b]) => quote!(#a || #b),
            (Instruction::MulAdd(..), [a, b, c]) => quote!(#a.multiply_add(#b, #c)),
            (Instruction::Sqrt(_), [a]) => quote!(#a.sqrt()),
            (Instruction::Compare(relation, ..), [a, b]) => match relation {
                Relation::Less => quote!(#a < #b),
                Relation::LessEqual => quote!(#a <= #b),
                Relation::Equal => quote!(#a == #b),
            },
            (Instruction::Call(function, _), args) => call(*function, args),
            // Every instruction has as many operands as its pattern above.
            (_, _) => TokenStream::new(),
        };
        (tokens, depth)
    }

    fn operand(&mut self, operand: &Operand) -> (TokenStream, usize) {
        match operand {
            Operand::Constant(value) => (constant(*value), 0),
            Operand::Truth(value) => (quote!(#value), 0),
            Operand::Input(symbol) => ((self.input)(*symbol), 0),
            Operand::Slot(level, index) => {
                let (array, index) = (format_ident!("{}", SLOTS[*level]), Literal::usize_unsuffixed(*index));
                (quote!(#array[#index]), 0)
            }
            Operand::Register(register) => match self.inline.get(register) {
                Some((tokens, depth)) => (tokens.clone(), *depth),
                None => {
                    let name = name(*register);
                    (quote!(#name), 0)
                }
            },
        }
    }

    /// An operand that can stand anywhere in an expression.
    fn atom(&mut self, operand: &Operand) -> (TokenStream, usize) {
        let (tokens, depth) = self.operand(operand);
        match operand {
            Operand::Register(register) if self.inline.contains_key(register) => (quote!((#tokens)), depth),
            _ => (tokens, depth),
        }
    }
}

fn name(register: Register) -> proc_macro2::Ident {
    format_ident!("v{register}", span = proc_macro2::Span::mixed_site())
}

fn call(function: Function, args: &[&TokenStream]) -> TokenStream {
    let name = format_ident!("{}", function.entry().name);
    match args {
        [x, rest @ ..] if function.entry().public => quote!(#x.#name(#(#rest),*)),
        _ => quote!(slope::#name(#(#args),*)),
    }
}

/// A constant of the scalar type.
pub(crate) fn constant(value: Number) -> TokenStream {
    let x = value.to_f64();
    let magnitude = Literal::f64_unsuffixed(x.abs());
    if x < 0.0 { quote!(R::from_f64(-#magnitude)) } else { quote!(R::from_f64(#magnitude)) }
}
