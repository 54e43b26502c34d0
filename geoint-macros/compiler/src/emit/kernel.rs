//! Functions of prepared coefficients and arrays: what routines read and write.

use super::tokens::{Tokens, bracketed, element};
use super::writer::{Names, routine};
use crate::ir::Symbol;
use crate::ir::print::Naming;
use crate::lower::VELOCITY;
use crate::parse::{Energy, Form, Role, Shape};
use crate::schedule::{self, Array, Block, Layout, Operand, Place, Plan, arranged};
use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};
use std::cell::RefCell;

/// How kernels of one energy name things.
pub(crate) struct Context<'a> {
    pub(super) energy: &'a Energy,
    /// Constants that live outside the function.
    constants: &'a [TokenStream],
    /// What registers are called in all routines.
    pub(super) registers: RefCell<Vec<Ident>>,
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

impl Naming for Context<'_> {
    fn name(&self, symbol: Symbol) -> String {
        let indexed = |name: String, shape: &Shape, i: usize| {
            let indices: String = shape.indices(i).iter().map(|i| format!("[{i}]")).collect();
            name + &indices
        };
        let of_role = |role: Role, i: u32| match role {
            Role::Action | Role::Time => self.name_of(role),
            _ => indexed(self.name_of(role), &self.energy.coordinates.shape, i as usize),
        };
        if self.energy.form == Form::Bodies
            && let Some(name) = self.body_name(symbol)
        {
            return name;
        }
        match symbol {
            Symbol::Position(i) => of_role(Role::Position, i),
            Symbol::Momentum(i) => of_role(Role::Momentum, i),
            Symbol::Velocity(i) => of_role(Role::Velocity, i),
            Symbol::Action => of_role(Role::Action, 0),
            Symbol::Time | Symbol::StepStart | Symbol::StepEnd => of_role(Role::Time, 0),
            Symbol::StepLength => "h".into(),
            Symbol::GradientWeight => "g".into(),
            Symbol::PositionIncrement(i) => format!("d{}", of_role(Role::Position, i)),
            Symbol::MomentumIncrement(i) => format!("d{}", of_role(Role::Momentum, i)),
            Symbol::ActionIncrement => format!("d{}", of_role(Role::Action, 0)),
            Symbol::VelocityIncrement(i) => format!("d{}", of_role(Role::Velocity, i)),
            Symbol::Multiplier(k) => format!("λ[{k}]"),
            Symbol::Parameter(index) => {
                let mut rest = index as usize;
                for argument in self.energy.parameters() {
                    if rest < argument.shape.len() {
                        return indexed(argument.name.to_string(), &argument.shape, rest);
                    }
                    rest -= argument.shape.len();
                }
                self.constants[rest].to_string().replace(' ', "")
            }
        }
    }
}

impl<'a> Context<'a> {
    pub(crate) fn new(energy: &'a Energy, constants: &'a [TokenStream]) -> Self {
        Context { energy, constants, registers: RefCell::default() }
    }

    /// The indices of the `i`-th coordinate in its array.
    pub(crate) fn coordinate(&self, i: u32) -> Vec<usize> {
        schedule::coordinate(&self.energy.coordinates.shape, i)
    }

    /// Indices of all coordinates.
    pub(crate) fn coordinates(&self) -> Vec<Vec<usize>> {
        (0..self.energy.degrees()).map(|i| self.coordinate(i)).collect()
    }

    /// The array type of q and p.
    pub(crate) fn array(&self) -> TokenTree {
        let extents = match &self.energy.coordinates.shape.extents[..] {
            [] => vec![1],
            extents => extents.to_vec(),
        };
        extents.iter().rev().fold(format_ident!("R").into(), |inner: TokenTree, extent| {
            let extent = Literal::usize_unsuffixed(*extent);
            bracketed(quote!(#inner; #extent))
        })
    }

    /// The array type of all coordinates.
    pub(crate) fn phase(&self) -> TokenTree {
        let array = self.array();
        let two = Literal::usize_unsuffixed(2); // literals are parsed where they are quoted
        if self.energy.form.is_flow() { array } else { bracketed(quote!(#array; #two)) }
    }

    /// The statement that gives parts of the point `z` the names that routines read.
    pub(crate) fn parts(&self) -> TokenStream {
        if self.energy.form.is_flow() { quote!(let q = z;) } else { quote!(let [q, p] = z;) }
    }

    /// The type of what phase space has beside positions and momenta.
    pub(crate) fn action(&self) -> TokenTree {
        match self.energy.form.has_action() {
            true => format_ident!("R").into(),
            false => Group::new(Delimiter::Parenthesis, TokenStream::new()).into(),
        }
    }

    /// The type of a number for every coordinate.
    pub(super) fn per_coordinate(&self) -> Tokens {
        let (phase, action) = (self.phase(), self.action());
        quote!(PerCoordinate<#phase, #action>).into()
    }

    /// Where the entries of an array of unknowns are: positions or momenta alone, or both, one array after the other; or, with an
    /// action or multipliers, all in a row.
    pub(crate) fn unknown_places(&self, unknowns: usize) -> Vec<Vec<usize>> {
        (0..unknowns).map(|i| self.unknown_place(unknowns, i)).collect()
    }

    /// Where the i-th of them is.
    fn unknown_place(&self, unknowns: usize, i: usize) -> Vec<usize> {
        let degrees = self.energy.degrees() as usize;
        if unknowns == degrees {
            return self.coordinate(i as u32);
        }
        if unknowns != 2 * degrees {
            return vec![i];
        }
        let mut place = self.coordinate((i % degrees) as u32);
        place.insert(0, i / degrees);
        place
    }

    /// The type of an array of unknowns.
    pub(crate) fn unknown_type(&self, unknowns: usize) -> TokenTree {
        let degrees = self.energy.degrees() as usize;
        if unknowns == degrees {
            return self.array();
        }
        if unknowns != 2 * degrees {
            let unknowns = Literal::usize_unsuffixed(unknowns);
            return bracketed(quote!(R; #unknowns));
        }
        self.phase()
    }

    /// All scalars of parameters, in order.
    pub(super) fn scalars(&self) -> Vec<TokenStream> {
        let count: usize = self.energy.parameters().map(|argument| argument.shape.len()).sum();
        (0..count as u32).map(|i| self.input(Symbol::Parameter(i)).to_token_stream()).collect()
    }

    /// Places of all inputs of a routine, which has some symbols in an array of its own.
    pub(crate) fn layout(&self, argument: Vec<(Symbol, Vec<usize>)>) -> Layout<'_> {
        let parameters = self.energy.parameters().map(|argument| &argument.shape).collect();
        Layout { coordinates: &self.energy.coordinates.shape, parameters, argument }
    }

    /// The name of an array, or of a number, in every routine. Each routine names its own array of arguments.
    pub(super) fn array_name(&self, argument: &str, array: Array) -> Tokens {
        match array {
            Array::Position => "q".into(),
            Array::Momentum => "p".into(),
            Array::Velocity => "v".into(),
            Array::Kick => "dp".into(),
            Array::Argument => argument.into(),
            Array::Increment => quote!(d.z).into(),
            Array::Parameter(number) => match self.energy.parameters().nth(number) {
                Some(parameter) => Tokens::field("self", &parameter.name),
                None => Tokens::default(),
            },
            Array::Number(Symbol::Action) => quote!(*s).into(),
            Array::Number(Symbol::ActionIncrement) => quote!(d.s).into(),
            Array::Number(Symbol::Time) => "t".into(),
            Array::Number(Symbol::StepStart) => "start".into(),
            Array::Number(Symbol::StepEnd) => "end".into(),
            Array::Number(Symbol::StepLength) => "h".into(),
            Array::Number(Symbol::GradientWeight) => "g".into(),
            Array::Number(Symbol::Parameter(i)) => {
                let scalars: usize = self.energy.parameters().map(|argument| argument.shape.len()).sum();
                let constant = &self.constants[i as usize - scalars];
                quote!(R::from_f64((#constant) as f64)).into()
            }
            Array::Number(_) => Tokens::default(),
        }
    }

    /// What a symbol is called in every routine.
    pub(crate) fn input(&self, symbol: Symbol) -> Tokens {
        let place = self.layout(vec![]).place(symbol);
        self.array_name("", place.array).at(&place.indices)
    }

    /// What users call an argument. Momenta of a Lagrangian are none, nor are velocities of an energy.
    pub(crate) fn name_of(&self, role: Role) -> String {
        let argument = self.energy.arguments.iter().find(|(other, _)| *other == role);
        let unnamed = match role {
            Role::Momentum => "p",
            Role::Velocity => VELOCITY,
            _ => "",
        };
        argument.map_or_else(|| unnamed.into(), |(_, a)| a.name.to_string())
    }

    /// What users call a number of an attitude, of an angular momentum, or of a centre of mass.
    fn body_name(&self, symbol: Symbol) -> Option<String> {
        let attitudes = 4 * self.energy.bodies();
        let (vector, rotor) = (["x", "y", "z", ""], ["i", "j", "k", "w"]);
        let (role, index, numbers) = match symbol {
            Symbol::Position(i) if i < attitudes => (Role::Attitude, i, rotor),
            Symbol::Momentum(i) if i < attitudes => (Role::AngularMomentum, i, vector),
            Symbol::Position(i) => (Role::Position, i - attitudes, vector),
            Symbol::Momentum(i) => (Role::Momentum, i - attitudes, vector),
            _ => return None,
        };
        let (_, argument) = self.energy.arguments.iter().find(|(other, _)| *other == role)?;
        let body = if argument.shape.extents.len() == 1 { String::new() } else { format!("[{}]", index / 4) };
        Some(format!("{}{body}.{}", argument.name, numbers[index as usize % 4]))
    }

    /// The values of a plan's only routine, or of its first.
    pub(crate) fn values<T: ToTokens>(&self, plan: &Plan, finish: impl FnOnce(Vec<Tokens>) -> T) -> TokenStream {
        self.planned(&plan.last[0], (&[], ""), finish)
    }

    /// A routine that writes its results.
    pub(crate) fn written(&self, block: &Block, targets: &[Place]) -> TokenStream {
        let layout = self.layout(vec![]);
        let names = Names { registers: &self.registers, layout: &layout, array: &|array| self.array_name("", array) };
        routine(&arranged(block, &layout, targets), names, |_| TokenStream::new())
    }

    /// A routine that returns its results. It has some symbols in the array `name`.
    pub(crate) fn routine<T: ToTokens>(
        &self,
        block: &Block,
        name: &str,
        argument: Vec<(Symbol, Vec<usize>)>,
        finish: impl FnOnce(Vec<Tokens>) -> T,
    ) -> TokenStream {
        let layout = self.layout(argument);
        let names = Names { registers: &self.registers, layout: &layout, array: &|array| self.array_name(name, array) };
        routine(&arranged(block, &layout, &[]), names, finish)
    }

    /// What the routine of a level stores for later ones, as an array.
    pub(crate) fn stored(&self, plan: &Plan, level: usize) -> TokenStream {
        let block = &plan.stores[level];
        let matrices = block.matrices();
        self.planned(block, (&[], ""), |values| {
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

    /// A routine of a plan, in which `unknowns` are in the array `array`.
    pub(crate) fn planned<T: ToTokens>(
        &self,
        block: &Block,
        (unknowns, array): (&[Symbol], &str),
        finish: impl FnOnce(Vec<Tokens>) -> T,
    ) -> TokenStream {
        let places = self.unknown_places(unknowns.len());
        self.routine(block, array, unknowns.iter().copied().zip(places).collect(), finish)
    }

    /// The same in braces, as the body of a function: one token, where many would be copied one by one as they are quoted.
    pub(super) fn body<T: ToTokens>(
        &self,
        block: &Block,
        unknowns: (&[Symbol], &str),
        finish: impl FnOnce(Vec<Tokens>) -> T,
    ) -> TokenTree {
        Group::new(Delimiter::Brace, self.planned(block, unknowns, finish)).into()
    }
}
