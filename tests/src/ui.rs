//! Does every mistake get one message, and every accepted form none?
//!
//! A file a mistake, named by it, beside what rustc then says. `TRYBUILD=overwrite cargo test --test ui` writes the
//! messages anew; read each before it is committed.

#[test]
fn mistakes_are_explained() {
    trybuild::TestCases::new().compile_fail("src/ui/*.rs");
}

#[test]
fn accepted_forms_compile_and_mean_what_they_say() {
    trybuild::TestCases::new().pass("src/ui/pass/*.rs");
}
