//! Proven properties of a system.

/// A proven property that needs no kernel. The struct states it by a trait without items.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fact {
    /// The system has an energy, and no friction or other force changes it.
    Conservative,
    /// The energy is constant: the system is conservative, and H does not read time.
    Autonomous,
    /// The field is a polynomial of degree 2 at most.
    QuadraticField,
    /// H has two pieces for which tables of Runge–Kutta–Nyström type keep their order.
    NystromPieces,
    /// Each piece of a contact Hamiltonian scales the contact form by a factor of time alone.
    ConformalContact,
}

impl Fact {
    /// Returns the name of the trait in the runtime.
    pub(crate) fn trait_name(self) -> &'static str {
        match self {
            Fact::Conservative => "Conservative",
            Fact::Autonomous => "Autonomous",
            Fact::QuadraticField => "QuadraticField",
            Fact::NystromPieces => "NystromPieces",
            Fact::ConformalContact => "ConformalContact",
        }
    }
}
