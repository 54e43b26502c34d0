//! Attributes and annotated functions as they are written, in tokens.

use crate::parse::Form;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use syn::{Expr, Lit, Meta};

/// An attribute, `#[…]` or `#![…]`.
pub(super) struct Written {
    pub(super) tokens: Vec<TokenTree>,
    is_inner: bool,
    /// Missing if syn can not read the attribute.
    meta: Option<Meta>,
}

/// An attribute of this crate with the function below it.
#[derive(Clone)]
pub(super) struct Annotated {
    pub(super) attribute: Attribute,
    pub(super) args: TokenStream,
    /// The item with its other attributes, as rustc hands it over. Attributes of this crate above this one are already expanded.
    pub(super) item: TokenStream,
    pub(super) name: String,
    /// The groups around the function, from the outside to the inside.
    pub(super) scope: Vec<Scope>,
}

/// A group of tokens, or a code block, around a function.
#[derive(Clone, PartialEq, Eq)]
pub(super) enum Scope {
    Module(String),
    /// Any other group, by its place.
    Group(usize),
    /// A code block, by its number.
    Block(usize),
}

/// The attributes of this crate.
#[derive(Clone, Copy)]
pub(super) enum Attribute {
    System(Form),
    EnergyFunction,
}

impl Written {
    /// Returns the attribute with which some tokens begin.
    pub(super) fn first_of(trees: &[TokenTree]) -> Option<Written> {
        let (is_inner, group) = match trees {
            [TokenTree::Punct(hash), TokenTree::Group(group), ..] if hash.as_char() == '#' => (false, group),
            [TokenTree::Punct(hash), TokenTree::Punct(not), TokenTree::Group(group), ..]
                if hash.as_char() == '#' && not.as_char() == '!' =>
            {
                (true, group)
            }
            _ => return None,
        };
        let tokens = trees[..if is_inner { 3 } else { 2 }].to_vec();
        let is_attribute = group.delimiter() == Delimiter::Bracket;
        is_attribute.then(|| Written { tokens, is_inner, meta: syn::parse2(group.stream()).ok() })
    }

    /// Returns a line of documentation.
    pub(super) fn doc(&self) -> Option<String> {
        let Some(Meta::NameValue(pair)) = &self.meta else { return None };
        let Expr::Lit(literal) = &pair.value else { return None };
        match &literal.lit {
            Lit::Str(text) if pair.path.is_ident("doc") => Some(text.value() + "\n"),
            _ => None,
        }
    }

    /// Returns the attribute of this crate with its arguments.
    fn ours(&self) -> Option<(Attribute, TokenStream)> {
        let meta = self.meta.as_ref()?;
        let name = meta.path().segments.last()?.ident.to_string();
        let system = Form::of_attribute(&name).map(Attribute::System);
        let attribute = system.or((name == "energy_function").then_some(Attribute::EnergyFunction))?;
        match meta {
            Meta::List(list) => Some((attribute, list.tokens.clone())),
            _ => Some((attribute, TokenStream::new())),
        }
    }
}

impl Annotated {
    /// Returns the path of the function below the file. The name of its struct replaces the name of the function if the attribute has one.
    pub(super) fn path(&self) -> String {
        let args: Vec<TokenTree> = self.args.clone().into_iter().collect();
        let named = args.windows(3).find_map(|three| match three {
            [TokenTree::Ident(key), TokenTree::Punct(_), TokenTree::Ident(name)] if key == "name" => {
                Some(name.to_string())
            }
            _ => None,
        });
        let modules = self.scope.iter().filter_map(|scope| match scope {
            Scope::Module(name) => Some(name.clone()),
            _ => None,
        });
        modules.chain([named.unwrap_or_else(|| self.name.clone())]).collect::<Vec<_>>().join("::")
    }

    /// Returns whether a fragment such as `$x` is among the tokens.
    pub(super) fn has_fragment(&self) -> bool {
        has_fragment(&self.args) || has_fragment(&self.item)
    }
}

/// Returns the item behind some attributes, once for each attribute of this crate.
pub(super) fn annotated(attributes: &[Written], behind: &[TokenTree], scope: &[Scope]) -> Vec<Annotated> {
    let end = behind.iter().position(ends_item).map_or(behind.len(), |end| end + 1);
    let name = behind[..end].windows(2).find_map(|pair| match pair {
        [TokenTree::Ident(keyword), TokenTree::Ident(name)] if keyword == "fn" => Some(name.to_string()),
        _ => None,
    });
    let name = name.unwrap_or_else(|| "no_function".to_owned());
    let mut found = vec![];
    for (i, written) in attributes.iter().enumerate() {
        let Some((attribute, args)) = written.ours() else { continue };
        let expanded = attributes[..i].iter().filter(|before| before.ours().is_none());
        let others = expanded.chain(&attributes[i + 1..]).filter(|other| !other.is_inner);
        let item = others.flat_map(|other| &other.tokens).chain(&behind[..end]).cloned().collect();
        found.push(Annotated { attribute, args, item, name: name.clone(), scope: scope.to_vec() });
    }
    found
}

/// Returns whether an item ends with this token: with its body, or with a semicolon.
fn ends_item(tree: &TokenTree) -> bool {
    match tree {
        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
        TokenTree::Punct(punct) => punct.as_char() == ';',
        _ => false,
    }
}

fn has_fragment(tokens: &TokenStream) -> bool {
    tokens.clone().into_iter().any(|tree| match tree {
        TokenTree::Group(group) => has_fragment(&group.stream()),
        TokenTree::Punct(punct) => punct.as_char() == '$',
        _ => false,
    })
}
