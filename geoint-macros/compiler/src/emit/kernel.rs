//! Routines as tokens: what they read, and where their outputs go.

use super::given::{Given, array, element};
use super::straight_line;
use super::tokens::{Tokens, bracketed};
use super::writer::Names;
use crate::compilation::Compilation;
use crate::derive::MOST_UNKNOWNS;
use crate::ir::{Symbol, print::Printer};
use crate::parse::{Energy, Form, Role};
use crate::schedule::{Argument, Block, Extent, Kernel, Operand, Output, Routine, Space};
use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};
use std::cell::RefCell;

/// The emission of one system.
pub(crate) struct Context<'a> {
    compilation: &'a Compilation<'a>,
    pub(super) energy: &'a Energy,
    pub(super) form: Form,
    /// Extents of the array of positions.
    positions: Vec<usize>,
    /// Names of registers in all routines.
    pub(super) registers: RefCell<Vec<Ident>>,
}

/// Values of an output as tokens.
pub(super) struct Values<'a> {
    pub(super) output: &'a Output,
    pub(super) all: Vec<Tokens>,
}

impl Values<'_> {
    /// `name[i][j]… = value;` for every value, or `*name = value;`.
    pub(super) fn assigned(&self, context: &Context<'_>) -> TokenStream {
        let Output { name, extent, nodes } = self.output;
        let places = self.output.places();
        match extent {
            Extent::Number => {
                let (name, value) = (format_ident!("{name}"), &self.all);
                quote!(#(*#name = #value;)*)
            }
            // Many unknowns depend on few others: zeros are written all at once.
            Extent::Square(extents) if extents.iter().product::<usize>() > MOST_UNKNOWNS => {
                let graph = &context.compilation.graph;
                let entries = || (0..nodes.len()).filter(|i| !graph.is_zero(nodes[*i]));
                let (some_places, some): (Vec<_>, Vec<_>) =
                    entries().map(|i| (places[i].clone(), self.all[i].clone())).unzip();
                let (matrix, ty) = (format_ident!("{name}"), array_type(extents));
                let zeros = (some.len() < nodes.len())
                    .then(|| quote!(*#matrix = <#ty as Array>::fill(<#ty as Array>::zero());));
                let some = write(name, &some_places, &some);
                quote!(#zeros #some)
            }
            _ => write(name, &places, &self.all),
        }
    }

    /// The rows of a matrix, each as `[a, b]`.
    pub(super) fn rows(&self) -> Vec<TokenStream> {
        let Extent::Array(extents) = &self.output.extent else { return vec![] };
        let length = extents.last().copied().unwrap_or(1).max(1);
        self.all.chunks(length).map(|row| quote!([#(#row),*])).collect()
    }

    /// `[[a, b], [c, d]]`
    pub(super) fn listed(&self) -> TokenStream {
        let extents = match &self.output.extent {
            Extent::Array(extents) => extents.clone(),
            Extent::Square(extents) => extents.repeat(2),
            Extent::Number | Extent::Coordinates(_) => vec![self.all.len()],
        };
        let mut lists: Vec<TokenStream> = self.all.iter().map(ToTokens::to_token_stream).collect();
        for extent in extents.iter().rev() {
            lists = lists.chunks((*extent).max(1)).map(|list| quote!([#(#list),*])).collect();
        }
        lists.into_iter().next().unwrap_or_else(|| quote!([]))
    }
}

/// `base[i][j]… = value;` for every value.
pub(crate) fn write(base: &str, places: &[Vec<usize>], values: &[Tokens]) -> TokenStream {
    let punct = |c| TokenTree::Punct(Punct::new(c, Spacing::Alone));
    let mut tokens: Vec<TokenTree> = vec![];
    for (indices, value) in places.iter().zip(values) {
        element(base, indices).push_to(&mut tokens);
        tokens.push(punct('='));
        value.clone().push_to(&mut tokens);
        tokens.push(punct(';'));
    }
    tokens.into_iter().collect()
}

/// The type of an array of numbers.
pub(super) fn array_type(extents: &[usize]) -> TokenTree {
    extents.iter().rev().fold(format_ident!("R").into(), |inner: TokenTree, extent| {
        let extent = Literal::usize_unsuffixed(*extent);
        bracketed(quote!(#inner; #extent))
    })
}

impl<'a> Context<'a> {
    pub(crate) fn new(compilation: &'a Compilation<'a>) -> Self {
        let (energy, form, positions) = (compilation.energy, compilation.form, compilation.positions());
        Context { compilation, energy, form, positions, registers: RefCell::default() }
    }

    pub(super) fn printer(&self) -> Printer<'a> {
        self.compilation.printer()
    }

    pub(super) fn name_of(&self, role: Role) -> String {
        self.compilation.names.of(role)
    }

    /// The indices of the `i`-th coordinate in its array.
    pub(crate) fn coordinate(&self, i: u32) -> Vec<usize> {
        let shape = &self.energy.coordinates.shape;
        if shape.extents.is_empty() { vec![0] } else { shape.indices(i as usize) }
    }

    /// The array type of q and p.
    pub(crate) fn array(&self) -> TokenTree {
        array_type(&self.positions)
    }

    /// The array type of all coordinates.
    pub(crate) fn phase(&self) -> TokenTree {
        let array = self.array();
        let two = Literal::usize_unsuffixed(2); // literals are parsed where they are quoted
        if self.form.is_flow() { array } else { bracketed(quote!(#array; #two)) }
    }

    /// The statement that names the parts of the point `z`.
    pub(crate) fn parts(&self) -> TokenStream {
        if self.form.is_flow() { quote!(let q = z;) } else { quote!(let [q, p] = z;) }
    }

    /// The extents of an array of unknowns: velocities, and the action.
    pub(super) fn with_action(&self) -> Vec<usize> {
        let unknowns = (0..self.energy.degrees()).map(Symbol::VelocityIncrement).chain([Symbol::ActionIncrement]);
        Space::of_unknowns(unknowns.collect(), &self.positions).extents
    }

    /// The type of the action: `R` or `()`.
    pub(crate) fn action(&self) -> TokenTree {
        match self.form.has_action() {
            true => format_ident!("R").into(),
            false => Group::new(Delimiter::Parenthesis, TokenStream::new()).into(),
        }
    }

    /// The type of a number for every coordinate.
    pub(super) fn per_coordinate(&self) -> Tokens {
        let (phase, action) = (self.phase(), self.action());
        quote!(PerCoordinate<#phase, #action>).into()
    }

    /// All scalars of parameters, in order.
    pub(super) fn scalars(&self) -> Vec<TokenStream> {
        let count: usize = self.energy.parameters().map(|argument| argument.shape.len()).sum();
        (0..count as u32).map(|i| self.parameter(i).to_token_stream()).collect()
    }

    /// A scalar of a parameter, or a constant from outside.
    fn parameter(&self, index: u32) -> Given {
        let mut rest = index as usize;
        for (number, argument) in self.energy.parameters().enumerate() {
            if rest < argument.shape.len() {
                let name = &argument.name;
                let field = Tokens::field("self", name);
                return Given::entry(array::PARAMETERS + number, field, argument.shape.indices(rest));
            }
            rest -= argument.shape.len();
        }
        let constant = &self.compilation.names.constants[rest];
        Given::alone(quote!(R::from_f64((#constant) as f64)))
    }

    /// What a symbol is called in every routine.
    pub(crate) fn input(&self, symbol: Symbol) -> Given {
        let of = |array, base, i| Given::entry(array, base, self.coordinate(i));
        match symbol {
            Symbol::Position(i) => of(array::POSITIONS, "q", i),
            Symbol::Momentum(i) => of(array::MOMENTA, "p", i),
            Symbol::Velocity(i) => of(array::VELOCITIES, "v", i),
            Symbol::Action => Given::alone(quote!(*s)),
            Symbol::Time => Given::alone("t"),
            Symbol::StepStart => Given::alone("start"),
            Symbol::StepEnd => Given::alone("end"),
            Symbol::StepLength => Given::alone("h"),
            Symbol::GradientWeight => Given::alone("g"),
            Symbol::Parameter(i) => self.parameter(i),
            // What a kick adds before a flow.
            Symbol::MomentumIncrement(i) => of(array::KICKS, "dp", i),
            // Other increments are unknowns wherever they are read.
            Symbol::PositionIncrement(_)
            | Symbol::ActionIncrement
            | Symbol::VelocityIncrement(_)
            | Symbol::Multiplier(_) => Given::alone(Tokens::default()),
        }
    }

    /// A symbol in a routine that reads some symbols from an array.
    fn input_or_argument(&self, argument: Option<&Argument>, symbol: Symbol) -> Given {
        let found = argument.and_then(|Argument { name, space }| {
            let i = space.symbols.iter().position(|other| *other == symbol)?;
            Some(Given::entry(array::UNKNOWNS, *name, space.place(i)))
        });
        found.unwrap_or_else(|| self.input(symbol))
    }

    /// Names of registers and inputs.
    pub(crate) fn names<'b>(&'b self, input: &'b dyn Fn(Symbol) -> Given) -> Names<'b> {
        Names { registers: &self.registers, input, degrees: self.energy.degrees() as usize }
    }

    /// Statements of a block, followed by tokens made of its results.
    fn block<T: ToTokens>(
        &self,
        block: &Block,
        argument: Option<&Argument>,
        finish: impl FnOnce(Vec<Tokens>) -> T,
    ) -> TokenStream {
        let input = |symbol| self.input_or_argument(argument, symbol);
        straight_line::routine(block, self.names(&input), finish)
    }

    /// Statements of a routine, followed by tokens made of its outputs.
    pub(super) fn outputs<T: ToTokens>(
        &self,
        routine: &Routine,
        finish: impl FnOnce(Vec<Values<'_>>) -> T,
    ) -> TokenStream {
        let input = |symbol| self.input_or_argument(routine.argument.as_ref(), symbol);
        self.outputs_with(routine, &input, finish)
    }

    /// The same with other names of inputs.
    pub(super) fn outputs_with<T: ToTokens>(
        &self,
        routine: &Routine,
        input: &dyn Fn(Symbol) -> Given,
        finish: impl FnOnce(Vec<Values<'_>>) -> T,
    ) -> TokenStream {
        straight_line::routine(&routine.block, self.names(input), |results| {
            let mut results = results.into_iter();
            let values =
                |output| Values { output, all: results.by_ref().take(output.nodes.len()).collect::<Vec<Tokens>>() };
            finish(routine.outputs.iter().map(values).collect())
        })
    }

    /// Statements that assign all outputs of a routine to variables of their names.
    pub(super) fn assigned(&self, routine: &Routine) -> TokenStream {
        self.outputs(routine, |outputs| outputs.iter().map(|values| values.assigned(self)).collect::<TokenStream>())
    }

    /// The same in braces, as the body of a function: one token, where many would be copied one by one as they are quoted.
    pub(super) fn body(&self, routine: &Routine) -> TokenTree {
        Group::new(Delimiter::Brace, self.assigned(routine)).into()
    }

    /// A block that ends with the only number of a routine, or a list of its numbers.
    pub(super) fn returned(&self, routine: &Routine) -> TokenStream {
        self.returned_with(routine, &|symbol| self.input_or_argument(routine.argument.as_ref(), symbol))
    }

    /// The same with other names of inputs.
    pub(super) fn returned_with(&self, routine: &Routine, input: &dyn Fn(Symbol) -> Given) -> TokenStream {
        self.outputs_with(routine, input, |outputs| {
            let returned = |values: &Values<'_>| match values.output.extent {
                Extent::Number => values.all.iter().map(ToTokens::to_token_stream).collect(),
                _ => values.listed(),
            };
            outputs.iter().map(returned).collect::<TokenStream>()
        })
    }

    /// Statements that assign new values, or increments, of coordinates.
    pub(super) fn moved(&self, routine: &Routine, target: impl Fn(Symbol) -> Given) -> TokenStream {
        let symbols = routine.outputs.iter().filter_map(|output| match &output.extent {
            Extent::Coordinates(symbols) => Some(symbols),
            _ => None,
        });
        let targets: Vec<Given> = symbols.flatten().map(|symbol| target(*symbol)).collect();
        straight_line::assignments(&routine.block, self.names(&|symbol| self.input(symbol)), &targets)
    }

    /// A block that ends with the numbers that the routine of a level stores.
    pub(crate) fn stored(&self, kernel: &Kernel, level: usize) -> TokenStream {
        let block = &kernel.stores[level];
        let matrices = block.matrices();
        let start = kernel.start.as_ref().filter(|_| level > 0);
        self.block(block, start, |values| {
            if matrices.is_empty() {
                return quote!([#(#values),*]);
            }
            let parts = values.iter().zip(&block.results).map(|(value, operand)| match operand {
                Operand::Register(register) if matrices.contains(register) => quote!(#value.as_flattened()),
                _ => quote!(&[#value]),
            });
            quote!(slope::joined(&[#(#parts),*]))
        })
    }
}
