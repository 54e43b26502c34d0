//! Checks on random input that the macro does not panic or hang, keeps the user's function, and emits valid Rust. The input is random tokens, random
//! functions, and valid energies with random damage.

mod damage;
mod functions;
mod stacks;
mod written;

use crate::attribute;
use crate::parse::Form;
use proc_macro2::TokenStream;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};
use quote::quote;

use damage::{ENERGIES, damage, damaged, token_text};
pub(super) use functions::one_of;
use functions::{LEAVES, arithmetic, function};

/// Expands an item and checks the result.
fn holds(form: Form, args: TokenStream, item: TokenStream) {
    check(item.clone(), attribute::expand(form, args, item));
}

/// Checks that emitted code is valid Rust and starts with the user's function.
fn check(item: TokenStream, emitted: TokenStream) {
    if syn::parse2::<syn::Item>(item.clone()).is_ok()
        && let Err(error) = syn::parse2::<syn::File>(emitted.clone())
    {
        panic!("{error}: {emitted}");
    }
    let same = emitted.into_iter().zip(item.clone()).all(|(out, input)| out.to_string() == input.to_string());
    assert!(same, "the function does not come first: {item}");
}

fn tokens(text: &str) -> Option<TokenStream> {
    text.parse().ok()
}

/// Returns a configuration with few cases and a fixed seed, or with `PROPTEST_CASES` cases if this variable is set.
pub(super) fn config() -> Config {
    config_of(300)
}

/// Returns the configuration with this number of cases instead of 300.
pub(super) fn config_of(cases: u32) -> Config {
    let few = Config { cases, rng_seed: RngSeed::Fixed(20), ..Config::default() };
    let config = if std::env::var_os("PROPTEST_CASES").is_some() { Config::default() } else { few };
    Config { failure_persistence: None, ..config }
}

/// Draws one of the two forms of energies.
fn form() -> impl Strategy<Value = Form> {
    prop::sample::select(vec![Form::Hamiltonian, Form::Contact])
}

/// Draws an attribute.
fn any_form() -> impl Strategy<Value = Form> {
    prop::sample::select(vec![Form::Hamiltonian, Form::Contact, Form::Field])
}

/// Draws a random energy with its form.
pub(super) fn energy(leaves: &'static [&'static str]) -> impl Strategy<Value = (Form, String)> {
    form().prop_flat_map(move |form| (Just(form), arithmetic(form, leaves)))
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn random_tokens(form in any_form(), args in token_text(), item in token_text()) {
        if let (Some(args), Some(item)) = (tokens(&args), tokens(&item)) {
            check(item.clone(), attribute::energy_function(args.clone(), item.clone()));
            let _ = attribute::resume(quote!(#args #item));
            holds(form, args, item);
        }
    }

    #[test]
    fn random_functions((form, text) in form().prop_flat_map(|form| (Just(form), function(form)))) {
        if let Some(item) = tokens(&text) {
            holds(form, quote!(), item);
        }
    }

    #[test]
    fn random_arithmetic((form, text) in energy(&LEAVES)) {
        holds(form, quote!(), tokens(&text).expect("tokens"));
    }

    #[test]
    fn damaged_energies(which in 0..ENERGIES.len(), harm in prop::collection::vec(damage(), 1..4)) {
        let (form, energy) = ENERGIES[which];
        let mut item = tokens(energy).expect("tokens");
        for (at, damage) in harm {
            let mut at = at;
            item = damaged(item, &mut at, &damage);
        }
        holds(form, quote!(), item);
    }
}
