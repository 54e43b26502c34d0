//! Constants that both crates have.

/// The runtime solves equations with more unknowns without the kernel that the compiler emits up to this number.
#[test]
fn both_crates_emit_and_use_newton_kernels_up_to_the_same_number() {
    assert_eq!(crate::MOST_UNKNOWNS, geoint_runtime::private::MOST_UNKNOWNS);
}
