//! Finds annotated functions in token trees, wherever they stand: in modules, bodies, macros and doc comments.

use super::sources::code_blocks;
use super::written::{Annotated, Written, annotated};
use proc_macro2::{LexError, TokenStream, TokenTree};
use std::str::FromStr;

/// The annotated functions of a file, in its order.
#[derive(Default)]
pub(super) struct Found {
    pub(super) functions: Vec<Annotated>,
    /// The number of functions of `macro_rules!` with fragments such as `$x`.
    pub(super) templates: usize,
    /// The number of code blocks.
    blocks: usize,
}

impl Found {
    /// Scans a Rust file. Errors: text that has no tokens.
    pub(super) fn rust(&mut self, text: &str) -> Result<(), LexError> {
        self.tokens(TokenStream::from_str(text)?, &[])
    }

    /// Scans a Markdown page. Errors: a code block that has no tokens.
    pub(super) fn markdown(&mut self, text: &str, scope: &[String]) -> Result<(), LexError> {
        for block in code_blocks(text) {
            self.blocks += 1;
            let scope = [scope, &[format!("block {}", self.blocks)]].concat();
            self.tokens(TokenStream::from_str(&block)?, &scope)?;
        }
        Ok(())
    }

    /// Scans the tokens of a group and of the groups inside.
    fn tokens(&mut self, tokens: TokenStream, scope: &[String]) -> Result<(), LexError> {
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
                let label = match &trees[..at] {
                    [.., TokenTree::Ident(keyword), TokenTree::Ident(name)] if keyword == "mod" => name.to_string(),
                    _ => format!("group {at}"),
                };
                self.tokens(group.stream(), &[scope, &[label]].concat())?;
            }
            at += 1;
        }
        self.item(&attributes, &[], scope)
    }

    /// Scans the attributes of an item and their documentation. `behind` starts with the item.
    fn item(&mut self, attributes: &[Written], behind: &[TokenTree], scope: &[String]) -> Result<(), LexError> {
        for function in annotated(attributes, behind, scope) {
            if function.has_fragment() {
                self.templates += 1;
            } else {
                self.functions.push(function);
            }
        }
        let docs: String = attributes.iter().filter_map(Written::doc).collect();
        if docs.is_empty() { Ok(()) } else { self.markdown(&docs, scope) }
    }
}
