//! Every mistake gets one message.
//!
//! Each file in `ui` covers one subject. Each module in it is one mistake, named by it, and the file `.stderr` holds the messages that rustc must
//! print. One program for each mistake would take minutes. Mistakes in the forms of energies are in `tests/essentials/mistakes`; programs that
//! compile are in `tests/language`. `TRYBUILD=overwrite cargo test -p geoint-tests-messages` rewrites the messages; read each before you commit it.

#[test]
fn mistakes_are_explained() {
    trybuild::TestCases::new().compile_fail("src/ui/*.rs");
}
