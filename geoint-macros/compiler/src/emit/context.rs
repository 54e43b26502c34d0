//! Prints the routines of one system: names of their inputs, types of their arrays, and the destinations of their outputs.
//!
//! Results that are quoted often are a `Tokens`, a list that is quoted without rustc, or a `TokenTree`, a single token. All others are a `TokenStream`.

use super::tokens::{Tokens, bracketed, element};
use super::writer::{Names, routine};
use crate::compilation::Compilation;
use crate::derive::MOST_UNKNOWNS;
use crate::ir::{Symbol, print::Printer};
use crate::parse::{Energy, Form, Role};
use crate::schedule::{Argument, Array, Block, Extent, Kernel, Layout, Operand, Output, Routine, Space, coordinate};
use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};
use std::cell::RefCell;

/// The facts about a system that its printed routines share.
pub(crate) struct Context<'a> {
    compilation: &'a Compilation<'a>,
    pub(super) energy: &'a Energy,
    pub(super) form: Form,
    /// Extents of the array of positions.
    positions: Vec<usize>,
    /// Cache of the names of registers, filled on demand.
    pub(super) registers: RefCell<Vec<Ident>>,
}

/// The values of an output as tokens.
pub(super) struct Values<'a> {
    pub(super) output: &'a Output,
    pub(super) all: Vec<Tokens>,
}

impl Values<'_> {
    /// Returns `name[i][j]… = value;` for every value, or `*name = value;` for a number.
    pub(super) fn assigned(&self, context: &Context<'_>) -> TokenStream {
        let Output { name, extent, nodes } = self.output;
        let places = self.output.places();
        match extent {
            Extent::Number => {
                let (name, value) = (format_ident!("{name}"), &self.all);
                quote!(#(*#name = #value;)*)
            }
            // A matrix for more unknowns than dense solvers take is sparse, and a statement for each zero would be most of the code. One statement writes them all.
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

    /// Returns the rows of an output with [`Extent::Array`], each as `[a, b]`. Other outputs have none.
    pub(super) fn rows_of_array(&self) -> Vec<TokenStream> {
        let Extent::Array(extents) = &self.output.extent else { return vec![] };
        let length = extents.last().copied().unwrap_or(1).max(1);
        self.all.chunks(length).map(|row| quote!([#(#row),*])).collect()
    }

    /// Returns a number, or a list.
    pub(super) fn returned(&self) -> TokenStream {
        match self.output.extent {
            Extent::Number => self.all.iter().map(ToTokens::to_token_stream).collect(),
            _ => self.listed(),
        }
    }

    /// Returns all values as a nested list: `[[a, b], [c, d]]`.
    pub(super) fn listed(&self) -> TokenStream {
        let extents = match &self.output.extent {
            Extent::Array(extents) => extents.clone(),
            Extent::Square(extents) => extents.repeat(2),
            Extent::Number | Extent::Coordinates(_) | Extent::Increments(_) => vec![self.all.len()],
        };
        let mut lists: Vec<TokenStream> = self.all.iter().map(ToTokens::to_token_stream).collect();
        for extent in extents.iter().rev() {
            lists = lists.chunks((*extent).max(1)).map(|list| quote!([#(#list),*])).collect();
        }
        lists.into_iter().next().unwrap_or_else(|| quote!([]))
    }
}

/// Returns `base[i][j]… = value;` for every value.
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

/// Returns the type of an array of numbers.
pub(super) fn array_type(extents: &[usize]) -> TokenTree {
    extents.iter().rev().fold(format_ident!("R").into(), |inner: TokenTree, extent| {
        let extent = Literal::usize_unsuffixed(*extent);
        bracketed(quote!(#inner; #extent))
    })
}

impl<'a> Context<'a> {
    /// Returns the context of a system.
    pub(crate) fn new(compilation: &'a Compilation<'a>) -> Self {
        let (energy, form, positions) = (compilation.energy, compilation.form, compilation.positions());
        Context { compilation, energy, form, positions, registers: RefCell::default() }
    }

    /// Returns the printer of expressions for messages.
    pub(super) fn printer(&self) -> Printer<'a> {
        self.compilation.printer()
    }

    /// Returns the user's name of coordinates.
    pub(super) fn name_of(&self, role: Role) -> String {
        self.compilation.names.of(role)
    }

    /// Returns the indices of the `i`-th coordinate in its array.
    pub(crate) fn coordinate(&self, i: u32) -> Vec<usize> {
        coordinate(&self.energy.coordinates.shape, i)
    }

    /// Returns the array type of positions or momenta.
    pub(crate) fn positions_type(&self) -> TokenTree {
        array_type(&self.positions)
    }

    /// Returns the array type of all coordinates.
    pub(crate) fn phase_type(&self) -> TokenTree {
        let array = self.positions_type();
        let two = Literal::usize_unsuffixed(2); // A literal inside `quote!` is parsed at each use.
        if self.form.is_flow() { array } else { bracketed(quote!(#array; #two)) }
    }

    /// Returns the statement that names the parts of the point `z`. A vector field has one array of coordinates, and no momenta.
    pub(crate) fn parts(&self) -> TokenStream {
        if self.form.is_flow() { quote!(let q = z;) } else { quote!(let [q, p] = z;) }
    }

    /// Returns the extents of the array of the unknown velocities and the action.
    pub(super) fn extents_with_action(&self) -> Vec<usize> {
        let unknowns = (0..self.energy.degrees()).map(Symbol::VelocityIncrement).chain([Symbol::ActionIncrement]);
        Space::of_unknowns(unknowns.collect(), &self.positions).extents
    }

    /// Returns the type of the action: `R`, or `()` without an action.
    pub(crate) fn action_type(&self) -> TokenTree {
        match self.form.has_action() {
            true => format_ident!("R").into(),
            false => Group::new(Delimiter::Parenthesis, TokenStream::new()).into(),
        }
    }

    /// Returns the type with a number for every coordinate.
    pub(super) fn per_coordinate_type(&self) -> Tokens {
        let (phase, action) = (self.phase_type(), self.action_type());
        quote!(PerCoordinate<#phase, #action>).into()
    }

    /// Returns all scalars of the parameters, in order.
    pub(super) fn scalars(&self) -> Vec<TokenStream> {
        let count: usize = self.energy.parameters().map(|argument| argument.shape.len()).sum();
        (0..count as u32).map(|i| self.input(Symbol::Parameter(i)).to_token_stream()).collect()
    }

    /// Returns the name of an array or a number. All routines share these names, except the name `argument` of their own array. `d` is the increment of a step,
    /// with the fields `z` and `s`. The action is passed by reference.
    pub(super) fn array_name(&self, argument: &str, array: Array) -> Tokens {
        match array {
            Array::Position => "q".into(),
            Array::Momentum => "p".into(),
            Array::Velocity => "v".into(),
            Array::Kick => "dp".into(),
            Array::Argument => argument.into(),
            Array::Increment => quote!(d.z).into(),
            Array::Parameter(number) => {
                let parameter = self.energy.parameters().nth(number);
                parameter.map(|parameter| Tokens::field("self", &parameter.name)).unwrap_or_default()
            }
            Array::Number(Symbol::Action) => quote!(*s).into(),
            Array::Number(Symbol::ActionIncrement) => quote!(d.s).into(),
            Array::Number(Symbol::Time) => "t".into(),
            Array::Number(Symbol::StepStart) => "start".into(),
            Array::Number(Symbol::StepEnd) => "end".into(),
            Array::Number(Symbol::StepLength) => "h".into(),
            Array::Number(Symbol::GradientWeight) => "g".into(),
            // Parameters beyond the arguments of the energy are constants of the user's module.
            Array::Number(Symbol::Parameter(i)) => {
                let scalars: usize = self.energy.parameters().map(|argument| argument.shape.len()).sum();
                let constant = &self.compilation.names.constants[i as usize - scalars];
                quote!(R::from_f64((#constant) as f64)).into()
            }
            // Unreachable: all other symbols lie in one of the arrays. An empty name would be an error of rustc at once.
            Array::Number(_) => Tokens::default(),
        }
    }

    /// Returns the name of a symbol in all routines.
    pub(crate) fn input(&self, symbol: Symbol) -> Tokens {
        let place = Layout::of(self.energy).place(symbol);
        self.array_name("", place.array).at(&place.indices)
    }

    /// Returns the statements of a block, and the tokens that `finish` makes of its results.
    fn block<T: ToTokens>(
        &self,
        block: &Block,
        argument: Option<&Argument>,
        finish: impl FnOnce(Vec<Tokens>) -> T,
    ) -> TokenStream {
        let mut layout = Layout::of(self.energy);
        layout.argument.extend(argument.iter().flat_map(|argument| argument.space.places()));
        let name = argument.map_or("", |argument| argument.name);
        let names = Names { registers: &self.registers, layout: &layout, array: &|array| self.array_name(name, array) };
        routine(block, names, finish)
    }

    /// Returns the statements of a routine, and the tokens that `finish` makes of its outputs.
    pub(super) fn outputs<T: ToTokens>(
        &self,
        routine: &Routine,
        finish: impl FnOnce(Vec<Values<'_>>) -> T,
    ) -> TokenStream {
        self.block(&routine.block, routine.argument.as_ref(), |results| finish(by_output(routine, results)))
    }

    /// Returns the statements that assign all outputs of a routine to variables with their names.
    pub(super) fn assigned(&self, routine: &Routine) -> TokenStream {
        self.outputs(routine, |outputs| outputs.iter().map(|values| values.assigned(self)).collect::<TokenStream>())
    }

    /// Returns the statements of [`Context::assigned`] in braces, as the body of a function. One token is quoted faster than many.
    pub(super) fn body(&self, routine: &Routine) -> TokenTree {
        Group::new(Delimiter::Brace, self.assigned(routine)).into()
    }

    /// Returns the statements of a routine with one output, and its value as the result.
    pub(super) fn returned(&self, routine: &Routine) -> TokenStream {
        self.outputs(routine, |outputs| outputs.iter().map(Values::returned).collect::<TokenStream>())
    }

    /// Returns the statements of a routine that writes coordinates. The statements contain the writes, so there are no results.
    pub(super) fn coordinates_written(&self, routine: &Routine) -> TokenStream {
        self.block(&routine.block, routine.argument.as_ref(), |_| TokenStream::new())
    }

    /// Returns the statements of a level of a kernel, and its stored numbers as the result. Levels after the first also read the argument `start` of the kernel.
    /// If a statement returns a matrix, its numbers and all other numbers are joined as slices, because the array of stored numbers is flat.
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

/// Divides the results of a routine among its outputs.
pub(super) fn by_output(routine: &Routine, results: Vec<Tokens>) -> Vec<Values<'_>> {
    let mut results = results.into_iter();
    let values = |output| Values { output, all: results.by_ref().take(output.nodes.len()).collect::<Vec<Tokens>>() };
    routine.outputs.iter().map(values).collect()
}
