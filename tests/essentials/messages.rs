//! One file of mistakes for each form of energy; rustc must print the messages that stand beside them.

#[test]
fn mistakes_in_every_form_are_explained() {
    trybuild::TestCases::new().compile_fail("mistakes/*.rs");
}
