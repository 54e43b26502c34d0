//! Finds annotated functions in token trees, wherever they stand: in modules, bodies, macros and doc comments.

use super::sources::code_blocks;
use super::transcription::Macros;
use super::written::{Annotated, Scope, Written, annotated};
use proc_macro2::{LexError, TokenStream, TokenTree};
use std::str::FromStr;

/// The annotated functions of a file, in its order.
#[derive(Default)]
pub(super) struct Found {
    pub(super) functions: Vec<Annotated>,
    /// The names of macros, and of functions of macros, that the scan does not expand.
    pub(super) missed: Vec<String>,
    macros: Macros,
    /// The number of code blocks.
    blocks: usize,
}

impl Found {
    /// Scans a Rust file. Errors: text that has no tokens.
    pub(super) fn rust(&mut self, text: &str) -> Result<(), LexError> {
        self.tokens(TokenStream::from_str(text)?, &[])?;
        self.missed.extend(self.macros.unused().cloned());
        Ok(())
    }

    /// Scans a Markdown page. Errors: a code block that has no tokens.
    pub(super) fn markdown(&mut self, text: &str, scope: &[Scope]) -> Result<(), LexError> {
        for block in code_blocks(text) {
            self.blocks += 1;
            self.tokens(TokenStream::from_str(&block)?, &[scope, &[Scope::Block(self.blocks)]].concat())?;
        }
        Ok(())
    }

    /// Scans the tokens of a group and of the groups inside.
    fn tokens(&mut self, tokens: TokenStream, scope: &[Scope]) -> Result<(), LexError> {
        let trees: Vec<TokenTree> = tokens.into_iter().collect();
        let mut attributes: Vec<Written> = vec![];
        let mut at = 0;
        while at < trees.len() {
            if let Some(attribute) = Written::first_of(&trees[at..]) {
                at += attribute.tokens.len();
                attributes.push(attribute);
                continue;
            }
            self.item(&attributes, &trees[at..], scope)?;
            attributes.clear();
            if let TokenTree::Group(group) = &trees[at] {
                self.group(&trees[..at], group.stream(), scope)?;
            }
            at += 1;
        }
        self.item(&attributes, &[], scope)
    }

    /// Scans a group: the body of a module, the rules or the arguments of a macro, or any other group.
    fn group(&mut self, before: &[TokenTree], inside: TokenStream, scope: &[Scope]) -> Result<(), LexError> {
        let label = match before {
            [.., TokenTree::Ident(keyword), TokenTree::Ident(name)] if keyword == "mod" => {
                Scope::Module(name.to_string())
            }
            _ => Scope::Group(before.len()),
        };
        let scope = [scope, &[label]].concat();
        match before {
            [.., TokenTree::Ident(keyword), TokenTree::Punct(_), TokenTree::Ident(name)]
                if keyword == "macro_rules" =>
            {
                self.macros.define(name.to_string(), inside);
                Ok(())
            }
            [.., TokenTree::Ident(name), TokenTree::Punct(not)] if not.as_char() == '!' => {
                let expanded = self.macros.expand(&name.to_string(), &inside);
                let expanded = expanded.unwrap_or_else(|name| {
                    self.missed.push(name);
                    None
                });
                self.tokens(expanded.unwrap_or(inside), &scope)
            }
            _ => self.tokens(inside, &scope),
        }
    }

    /// Scans the attributes of an item and their documentation. `behind` starts with the item.
    fn item(&mut self, attributes: &[Written], behind: &[TokenTree], scope: &[Scope]) -> Result<(), LexError> {
        for function in annotated(attributes, behind, scope) {
            if function.has_fragment() {
                self.missed.push(function.name);
            } else {
                self.functions.push(function);
            }
        }
        let docs: String = attributes.iter().filter_map(Written::doc).collect();
        if docs.is_empty() { Ok(()) } else { self.markdown(&docs, scope) }
    }
}
