//! Does every mistake get one message?
//!
//! A file a subject, a module a mistake, named by it, beside what rustc then says: a program each would take minutes. What is accepted is
//! tested in `language`. `TRYBUILD=overwrite cargo test -p geoint-tests-messages` writes the messages anew; read each before it is committed.

#[test]
fn mistakes_are_explained() {
    trybuild::TestCases::new().compile_fail("src/ui/*.rs");
}
