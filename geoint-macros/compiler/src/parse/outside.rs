//! Integer constants and type aliases of the user's file. An attribute can not see the file, so its arguments repeat them.
//!
//! The arguments are `const N = …` and `type P = [f64; N]`. The compiler replaces these names in types before other stages read the types.
//! Generated code lets rustc compare the arguments with the file.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote, quote_spanned};
use syn::parse::ParseStream;
use syn::spanned::Spanned;
use syn::{BinOp, Expr, ExprLit, GenericArgument, Lit, PathArguments, Token, Type};

/// Constants and aliases from outside of the function.
#[derive(Clone, Default)]
pub(crate) struct Outside {
    constants: Vec<Constant>,
    aliases: Vec<Alias>,
}

#[derive(Clone)]
struct Constant {
    name: Ident,
    /// Expression of the user, for the assertion.
    expr: Expr,
    value: i128,
}

#[derive(Clone)]
struct Alias {
    name: Ident,
    ty: Type,
}

impl Outside {
    /// Parses `N = 3` or `N: usize = 3` after `const`.
    pub(super) fn parse_constant(&mut self, input: ParseStream<'_>) -> syn::Result<()> {
        let name: Ident = input.parse()?;
        if input.parse::<Option<Token![:]>>()?.is_some() {
            // rustc checks the type.
            input.parse::<Type>()?;
        }
        if !input.peek(Token![=]) {
            let message = format!("an attribute cannot see what `{name}` is: repeat its value, `const {name} = …`");
            return Err(syn::Error::new_spanned(name, message));
        }
        input.parse::<Token![=]>()?;
        let expr: Expr = input.parse()?;
        let Some(value) = self.integer(&expr) else {
            let message = match self.unknown(&expr) {
                Some(other) => format!("`{other}` is not known here: repeat it before, `const {other} = …`"),
                None => NOT_AN_INTEGER.into(),
            };
            return Err(syn::Error::new_spanned(expr, message));
        };
        self.constants.push(Constant { name, expr, value });
        Ok(())
    }

    /// Parses `P = [f64; 2]` after `type`.
    pub(super) fn parse_alias(&mut self, input: ParseStream<'_>) -> syn::Result<()> {
        let name: Ident = input.parse()?;
        input.parse::<Token![=]>()?;
        let ty = self.resolve(&input.parse()?);
        self.aliases.push(Alias { name, ty });
        Ok(())
    }

    /// Returns the constants with their values.
    pub(crate) fn constants(&self) -> impl Iterator<Item = (&Ident, i128)> {
        self.constants.iter().map(|constant| (&constant.name, constant.value))
    }

    /// Returns the aliases with their types as text.
    pub(crate) fn aliases(&self) -> impl Iterator<Item = (&Ident, String)> {
        self.aliases.iter().map(|Alias { name, ty }| (name, ty.to_token_stream().to_string()))
    }

    fn constant(&self, path: &syn::Path) -> Option<i128> {
        let name = path.get_ident()?;
        self.constants().find(|(constant, _)| *constant == name).map(|(_, value)| value)
    }

    /// Adds an alias of the body. It hides an outer alias of the same name.
    pub(crate) fn with_alias(mut self, name: &Ident, ty: &Type) -> Self {
        let ty = self.resolve(ty);
        self.aliases.insert(0, Alias { name: name.clone(), ty });
        self
    }

    /// Returns the type of an alias.
    pub(crate) fn alias(&self, name: &str) -> Option<&Type> {
        self.aliases.iter().find(|alias| alias.name == name).map(|alias| &alias.ty)
    }

    /// Replaces known aliases and known constants in lengths, and removes parentheses. Unknown names remain.
    pub(crate) fn resolve(&self, ty: &Type) -> Type {
        let mut ty = ty.clone();
        match &mut ty {
            Type::Paren(inner) => return self.resolve(&inner.elem),
            Type::Group(inner) => return self.resolve(&inner.elem),
            Type::Reference(inner) => *inner.elem = self.resolve(&inner.elem),
            Type::Array(array) => {
                *array.elem = self.resolve(&array.elem);
                self.resolve_length(&mut array.len);
            }
            Type::Path(path) if path.qself.is_none() => {
                if let Some(alias) = path.path.get_ident().and_then(|name| self.alias(&name.to_string())) {
                    return alias.clone();
                }
                for segment in &mut path.path.segments {
                    if let PathArguments::AngleBracketed(arguments) = &mut segment.arguments {
                        arguments.args.iter_mut().for_each(|argument| self.resolve_argument(argument));
                    }
                }
            }
            _ => {}
        }
        ty
    }

    fn resolve_argument(&self, argument: &mut GenericArgument) {
        match argument {
            GenericArgument::Const(length) => self.resolve_length(length),
            GenericArgument::Type(ty) => {
                // The parser takes the name of a constant for a type.
                let constant = match &*ty {
                    Type::Path(path) => self.constant(&path.path).and_then(|value| value.try_into().ok()),
                    _ => None,
                };
                match constant {
                    Some(value) => *argument = GenericArgument::Const(literal(value, ty)),
                    None => *ty = self.resolve(ty),
                }
            }
            _ => {}
        }
    }

    fn resolve_length(&self, length: &mut Expr) {
        if let Some(value) = self.integer(length).and_then(|value| value.try_into().ok()) {
            *length = literal(value, length);
        }
    }

    /// Returns a constant in an expression that the attribute does not repeat.
    fn unknown(&self, expr: &Expr) -> Option<Ident> {
        match expr {
            Expr::Path(path) => path.path.get_ident().filter(|_| self.constant(&path.path).is_none()).cloned(),
            Expr::Paren(inner) => self.unknown(&inner.expr),
            Expr::Group(inner) => self.unknown(&inner.expr),
            Expr::Unary(unary) => self.unknown(&unary.expr),
            Expr::Binary(binary) => self.unknown(&binary.left).or_else(|| self.unknown(&binary.right)),
            _ => None,
        }
    }

    /// Evaluates an expression of integers and known constants.
    fn integer(&self, expr: &Expr) -> Option<i128> {
        match expr {
            Expr::Lit(ExprLit { lit: Lit::Int(n), .. }) if !n.suffix().starts_with('f') => n.base10_parse().ok(),
            Expr::Path(path) if path.qself.is_none() => self.constant(&path.path),
            Expr::Paren(inner) => self.integer(&inner.expr),
            Expr::Group(inner) => self.integer(&inner.expr),
            Expr::Block(block) => match &block.block.stmts[..] {
                [syn::Stmt::Expr(inner, None)] => self.integer(inner),
                _ => None,
            },
            Expr::Unary(unary) if matches!(unary.op, syn::UnOp::Neg(_)) => self.integer(&unary.expr)?.checked_neg(),
            Expr::Binary(binary) => {
                integer_operation(&binary.op, self.integer(&binary.left)?, self.integer(&binary.right)?)
            }
            _ => None,
        }
    }

    /// Returns code that does not compile if the file defines a constant or an alias differently.
    pub(crate) fn assertions(&self) -> TokenStream {
        let constants = self.constants.iter().map(|Constant { name, expr, value }| {
            let message = format!("the attribute says that `{name}` is {value}, which it is not");
            quote_spanned!(expr.span()=> ::core::assert!(#name == #expr, #message);)
        });
        let identity = |Alias { name, ty }: &Alias| quote_spanned!(ty.span()=> let _: fn(#name) -> #ty = |same| same;);
        let aliases = self.aliases.iter().map(identity);
        if self.constants.is_empty() && self.aliases.is_empty() {
            return TokenStream::new();
        }
        quote! {
            #[allow(clippy::all, clippy::pedantic, clippy::restriction, reason = "generated code")]
            const _: () = {
                #(#constants)*
                #(#aliases)*
            };
        }
    }
}

/// Returns a `op` b. `None` on overflow, for division by zero, and for other operators than `+ - * / %`.
pub(crate) fn integer_operation(op: &BinOp, a: i128, b: i128) -> Option<i128> {
    match op {
        BinOp::Add(_) => a.checked_add(b),
        BinOp::Sub(_) => a.checked_sub(b),
        BinOp::Mul(_) => a.checked_mul(b),
        BinOp::Div(_) => a.checked_div(b),
        BinOp::Rem(_) => a.checked_rem(b),
        _ => None,
    }
}

fn literal(value: u64, place: &impl ToTokens) -> Expr {
    let mut literal = Literal::u64_unsuffixed(value);
    literal.set_span(place.span());
    Expr::Lit(ExprLit { attrs: vec![], lit: Lit::new(literal) })
}

const NOT_AN_INTEGER: &str = "a constant that the attribute repeats is an integer, for lengths and loops: `const N = …`; of other \
                              constants outside of the function only rustc needs the value";
