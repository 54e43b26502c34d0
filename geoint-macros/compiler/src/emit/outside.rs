//! Error messages for constants and aliases that the attribute repeats but the file does not define.

use super::context::Context;
use proc_macro2::{Ident, TokenStream};
use quote::{quote, quote_spanned};

/// Returns code that rustc rejects if the attribute repeats a constant or an alias that the module of the function lacks. The message contains the missing
/// item.
///
/// An import of all names of the module hides the items of the block around the import. So a name stands for the item of the block only if the
/// module lacks the name. The code finds out in the same way, from the name of the struct, whether the function is an item of the module. A function inside
/// a body can use the names of this body. The check accepts such a function, and rustc reports missing names.
pub(super) fn existence(context: &Context<'_>) -> TokenStream {
    let (outside, system) = (&context.energy.options.outside, &context.energy.name);
    let constants = outside.constants().map(|(name, value)| {
        let fallback = quote!(const #name: _Absent = _Absent; let _ = &#name;);
        let question = quote_spanned!(name.span()=> _PLACE._place()._has_value(|| #name););
        check(system, name, &format!("const {name}: usize = {value};"), fallback, question)
    });
    let aliases = outside.aliases().map(|(name, ty)| {
        let fallback = quote!(type #name = _Absent; let _: fn(#name) = |_| (););
        let question = quote_spanned!(name.span()=> _PLACE._place()._has_type::<#name>(););
        check(system, name, &format!("type {name} = {ty};"), fallback, question)
    });
    constants.chain(aliases).collect()
}

/// Returns the check of one name. The text `advice` is the missing item.
fn check(system: &Ident, name: &Ident, advice: &str, fallback: TokenStream, question: TokenStream) -> TokenStream {
    let message =
        format!("the attribute says what `{name}` is, and does not define it: write `{advice}` above the function");
    let label = format!("there is no `{name}` beside the function");
    quote! {
        #[allow(clippy::all, clippy::pedantic, clippy::restriction, unused_imports, reason = "generated code")]
        const _: fn() = || {
            struct _Absent;
            struct _Module;
            struct _Elsewhere;
            struct _Place<System>(::core::marker::PhantomData<System>);
            #[diagnostic::on_unimplemented(message = #message, label = #label)]
            trait _Repeated {}
            impl<T: ::core::cmp::PartialEq> _Repeated for T {}
            impl _Module {
                fn _has_value<T: _Repeated>(&self, _: fn() -> T) {}
                fn _has_type<T: _Repeated>(&self) {}
            }
            impl _Elsewhere {
                fn _has_value<T>(&self, _: fn() -> T) {}
                fn _has_type<T>(&self) {}
            }
            // For the struct itself this function comes first, for another type the function of the trait.
            impl _Place<#system> {
                fn _place(&self) -> _Module {
                    _Module
                }
            }
            trait _OfAnother {
                fn _place(&self) -> _Elsewhere {
                    _Elsewhere
                }
            }
            impl<System> _OfAnother for _Place<System> {}
            let _ = || {
                type #system = _Absent;
                let _: fn(#system) = |_| ();
                #fallback
                let _ = || {
                    use self::*;
                    const _PLACE: _Place<#system> = _Place(::core::marker::PhantomData);
                    #question
                };
            };
        };
    }
}
