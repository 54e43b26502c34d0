//! Constants that the runtime and the compiler define separately.

/// The compiler emits Newton kernels for at most this number of unknowns. The runtime solves larger systems without a kernel.
#[test]
fn both_crates_emit_and_use_newton_kernels_up_to_the_same_number() {
    assert_eq!(crate::MOST_UNKNOWNS, geoint_runtime::private::MOST_UNKNOWNS);
}
