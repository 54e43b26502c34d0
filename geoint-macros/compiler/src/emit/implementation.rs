//! Implementations of the runtime's traits. A table describes each trait that some systems lack. The table gives both the implementation for a system with
//! the trait, and the implementation that no scalar satisfies for a system without it.

use super::context::Context;
use super::missing::unsatisfied;
use super::signature::{Absent, Inline, Method, Trait, Ty};
use super::structure::self_type;
use crate::derive::Missing;
use proc_macro2::{Delimiter, Group, TokenStream};
use quote::{ToTokens, format_ident, quote};

/// The associated types of a trait in one implementation.
struct Types<'a> {
    context: &'a Context<'a>,
    of: &'static Trait,
    /// The name and tokens of each associated type. Empty for a system that lacks the trait.
    given: &'a [(&'static str, TokenStream)],
}

impl Types<'_> {
    /// Returns the tokens of a type.
    fn tokens(&self, ty: Ty) -> TokenStream {
        let context = self.context;
        match ty {
            Ty::Number => quote!(R),
            Ty::Index => quote!(usize),
            Ty::Span => quote!(Span<R>),
            Ty::Array => context.positions_type().into_token_stream(),
            Ty::Phase => context.phase_type().into_token_stream(),
            Ty::Action => context.action_type().into_token_stream(),
            Ty::PerCoordinate => context.per_coordinate_type().into_token_stream(),
            Ty::Associated(name) => match self.given.iter().find(|(other, _)| *other == name) {
                Some((_, ty)) => ty.clone(),
                None => self.absent(name),
            },
            Ty::Square(of) | Ty::Pair(of) | Ty::Ref(of) | Ty::Mut(of) => {
                let of = self.tokens(*of);
                match ty {
                    Ty::Square(_) => quote!(Square<#of>),
                    Ty::Pair(_) => quote!([#of; 2]),
                    Ty::Ref(_) => quote!(&#of),
                    _ => quote!(&mut #of),
                }
            }
        }
    }

    /// Returns an associated type for a system that lacks the trait. The array of unknowns is no associated type of some traits. It is then the array of
    /// all coordinates.
    fn find(&self, name: &str) -> Absent {
        let found = self.of.associated.iter().find(|(other, _)| *other == name);
        found.map_or(Absent::Is(Ty::Phase), |(_, absent)| *absent)
    }

    /// Returns the tokens of an associated type for a system that lacks the trait.
    fn absent(&self, name: &str) -> TokenStream {
        match self.find(name) {
            Absent::Never => quote!(::core::convert::Infallible),
            Absent::Unit => quote!(()),
            Absent::Is(ty) => self.tokens(ty),
        }
    }

    /// Returns whether an argument has no values in a system that lacks the trait.
    fn is_never(&self, ty: Ty) -> bool {
        matches!(ty, Ty::Ref(Ty::Associated(name)) if matches!(self.find(name), Absent::Never))
    }

    /// Returns a method of an absent trait, which cannot be called.
    fn uncallable(&self, method: &Method) -> TokenStream {
        let unit = matches!(method.returns, Some(Ty::Associated(name)) if matches!(self.find(name), Absent::Unit));
        let never = method.arguments.iter().position(|(_, ty)| self.is_never(*ty)).filter(|_| !unit);
        let arguments = method.arguments.iter().enumerate().map(|(i, (_, ty))| {
            let (pattern, ty) = (if never == Some(i) { quote!(never) } else { quote!(_) }, self.tokens(*ty));
            quote!(#pattern: #ty)
        });
        let body = match never {
            _ if unit => quote!(),
            Some(_) => quote!(match *never {}),
            None => quote!(::core::unreachable!()),
        };
        let (name, returns) = (format_ident!("{}", method.name), self.returned(method).filter(|_| !unit));
        quote!(fn #name(&self, #(#arguments),*) #returns { #body })
    }

    /// Returns `-> T` for a method with a result.
    fn returned(&self, method: &Method) -> Option<TokenStream> {
        method.returns.map(|ty| {
            let ty = self.tokens(ty);
            quote!(-> #ty)
        })
    }
}

/// The leading tokens of an implementation.
#[derive(Default)]
pub(super) struct Leading {
    /// Parameters of the trait before the scalar.
    pub(super) parameters: TokenStream,
    /// Items before the type `Proof`.
    pub(super) items: TokenStream,
}

/// The implementation of a trait for a system that has it, built item by item.
pub(super) struct Implementation<'a> {
    types: Types<'a>,
    leading: Leading,
    items: TokenStream,
}

impl<'a> Implementation<'a> {
    /// Returns an implementation without items. The list `given` has the tokens of the types in the signatures of the methods.
    pub(super) fn new(
        context: &'a Context<'a>,
        of: &'static Trait,
        given: &'a [(&'static str, TokenStream)],
    ) -> Implementation<'a> {
        let types = Types { context, of, given };
        Implementation { types, leading: Leading::default(), items: TokenStream::new() }
    }

    /// Sets the leading tokens.
    pub(super) fn leading(self, leading: Leading) -> Self {
        Implementation { leading, ..self }
    }

    /// Adds the associated types of the trait in the order of the given types.
    pub(super) fn types(self) -> Self {
        let Types { of, given, .. } = self.types;
        let own = given.iter().filter(|(name, _)| of.associated.iter().any(|(other, _)| other == name));
        let types = own.map(|(name, ty)| {
            let name = format_ident!("{name}");
            quote!(type #name = #ty;)
        });
        self.items(quote!(#(#types)*))
    }

    /// Adds items that the table of the trait does not describe.
    pub(super) fn items(mut self, items: impl ToTokens) -> Self {
        items.to_tokens(&mut self.items);
        self
    }

    /// Adds a method from the table of the trait. The body becomes one token, because many tokens would be copied one by one.
    pub(super) fn method(mut self, name: &str, body: TokenStream) -> Self {
        let Types { context, of, .. } = self.types;
        if let Some(method) = of.methods.iter().chain(of.provided).find(|method| method.name == name) {
            let inline = match method.inline {
                Inline::Hint => quote!(#[inline]),
                Inline::Always => quote!(#[inline(always)]),
            };
            let arguments = method.arguments.iter().map(|(pattern, ty)| {
                let pattern = match *pattern {
                    "s or _" if context.form.has_action() => quote!(s),
                    "s or _" => quote!(_),
                    pattern => pattern.parse().unwrap_or_default(),
                };
                let ty = self.types.tokens(*ty);
                quote!(#pattern: #ty)
            });
            let (name, returns) = (format_ident!("{name}"), self.types.returned(method));
            let body = Group::new(Delimiter::Brace, body);
            let comma = method.is_wide.then(|| quote!(,));
            self.items.extend(quote!(#inline fn #name(&self, #(#arguments),* #comma) #returns #body));
        }
        self
    }

    /// Returns the implementation. The type `Proof` comes before the items.
    pub(super) fn finish(self) -> TokenStream {
        let Implementation { types: Types { context, of, .. }, leading, items } = self;
        let Leading { parameters, items: first } = leading;
        let proof = of.has_proof.then(|| {
            quote!(
                type Proof = ();
            )
        });
        let (name, of) = (self_type(context), format_ident!("{}", of.name));
        quote!(impl<R: Real> #of<#parameters R> for #name { #first #proof #items })
    }
}

/// Returns `impl<R: Real> of<R>` for the system, with the type `Proof` and further items. Use it for traits without a table.
pub(super) fn proven(context: &Context<'_>, of: TokenStream, items: TokenStream) -> TokenStream {
    let name = self_type(context);
    quote!(impl<R: Real> #of for #name { type Proof = (); #items })
}

/// Returns `const name: bool = value;`.
pub(super) fn flag(name: &str, value: bool) -> TokenStream {
    let name = format_ident!("{name}");
    quote!(const #name: bool = #value;)
}

/// Implements traits for no scalar. The message of rustc about the missing implementation states the reason.
pub(super) fn absent(context: &Context<'_>, missing: Missing, traits: &[&'static Trait]) -> TokenStream {
    absent_with(context, missing, traits, &Leading::default())
}

/// Implements traits with leading tokens for no scalar.
pub(super) fn absent_with(
    context: &Context<'_>,
    missing: Missing,
    traits: &[&'static Trait],
    Leading { parameters, items }: &Leading,
) -> TokenStream {
    let (marker, message) = unsatisfied(context, missing);
    let name = self_type(context);
    let implementations = traits.iter().map(|of| {
        let types = Types { context, of, given: &[] };
        let proof = of.has_proof.then(|| quote!(type Proof = <R as #marker>::Proof;));
        let associated = of.associated.iter().map(|(name, _)| {
            let (name, ty) = (format_ident!("{name}"), types.absent(name));
            quote!(type #name = #ty;)
        });
        let methods = of.methods.iter().map(|method| types.uncallable(method));
        let of = format_ident!("{}", of.name);
        quote!(impl<R: Real + #marker> #of<#parameters R> for #name { #items #proof #(#associated)* #(#methods)* })
    });
    quote!(#message #(#implementations)*)
}
