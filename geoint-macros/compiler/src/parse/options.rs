//! What the arguments of an attribute say.

use super::Role;
use super::flow::{Kept, StructureForm};
use super::outside::Outside;
use super::values::{Coordinates, Requirement};
use proc_macro2::{Ident, Span};
use std::rc::Rc;
use syn::spanned::Spanned;
use syn::{Expr, Path};

/// What the arguments say; expressions are in terms of the arguments of the function.
#[derive(Clone, Default)]
pub(crate) struct Options {
    /// The name of the struct.
    pub(super) name: Option<Ident>,
    /// Where the runtime is.
    pub(super) runtime: Option<Path>,
    /// Names of arguments that are other than q, p, ….
    pub(super) roles: Vec<(Role, Ident)>,
    /// The argument that is called `x` of an energy: all its coordinates, if it has a structure.
    pub(super) all: Option<Ident>,
    /// Constants and aliases of the file.
    pub(crate) outside: Rc<Outside>,
    /// What is to be proven.
    pub(crate) requirements: Vec<(Requirement, Span)>,
    /// The coefficients of damping.
    pub(crate) damping: Option<Expr>,
    /// Rayleigh's dissipation function R of a Lagrangian.
    pub(crate) rayleigh: Option<Expr>,
    /// F of a force that is added.
    pub(crate) force: Option<Expr>,
    /// The functions of positions that are kept at zero.
    pub(crate) constraint: Option<Expr>,
    /// S of x' = S(x) ∇H.
    pub(crate) structure: Option<StructureForm>,
    /// What a vector field keeps.
    pub(crate) keeps: Vec<Kept>,
    /// How an energy is to be split into pieces.
    pub(crate) split: Option<Vec<Expr>>,
    /// The coordinates in which methods move bodies.
    pub(crate) coordinates: Option<(Coordinates, Span)>,
    /// Whether momenta of a contact Hamiltonian are not followed.
    pub(crate) lift: Option<Span>,
    /// Functions under `#[energy_function]` that the attribute names.
    pub(crate) with: Vec<Path>,
}

impl Options {
    /// With a structure there are neither momenta nor a kinetic part. Rigid bodies have an attitude and angular momenta, and
    /// are not damped.
    pub(super) fn consistent(self) -> syn::Result<Self> {
        let role = |role: Role| self.roles.iter().find(|(other, _)| *other == role).map(|(_, name)| name.span());
        let required = self.requirements.first().map(|(_, span)| *span);
        let damped = self.damping.as_ref().map(Spanned::span);
        let forced = self.force.as_ref().map(Spanned::span);
        let split = self.split.as_ref().and_then(|groups| groups.first()).map(Spanned::span);
        let parted = self.coordinates.map(|(_, span)| span).or(split);
        let constrained = self.constraint.as_ref().map(Spanned::span);
        if let Some(span) = constrained
            && (self.structure.is_some() || role(Role::Attitude).is_some() || parted.is_some() || forced.is_some())
        {
            return Err(syn::Error::new(span, CONSTRAINED));
        }
        let [attitude, m] = [Role::Attitude, Role::AngularMomentum].map(role);
        let wrong = match (&self.structure, attitude) {
            (Some(_), Some(attitude)) => Some((attitude, BODY_WITH_STRUCTURE)),
            (Some(_), None) => role(Role::Momentum).or(required).or(parted).or(forced).map(|span| (span, NO_MOMENTA)),
            (None, None) => {
                let both = self.coordinates.filter(|_| split.is_some()).map(|(_, span)| (span, TWO_WAYS));
                let damped = damped.or(forced).and(parted).map(|span| (span, DAMPED_PARTS));
                m.map(|m| (m, WITHOUT_ATTITUDE)).or(both).or(damped)
            }
            (None, Some(_)) => {
                let damped = damped.or(forced).map(|span| (span, DAMPED_BODY));
                let parted = parted.map(|span| (span, PARTS_OF_BODIES));
                damped.or(required.map(|span| (span, ALWAYS_SEPARABLE))).or(parted)
            }
        };
        wrong.map_or(Ok(()), |(span, message)| Err(syn::Error::new(span, message)))?;
        Ok(self)
    }
}

const CONSTRAINED: &str = "constraints are for positions and momenta whose energy is not split: leave out this, or `structure`, `attitude`, \
                           `split`, `coordinates` and `force`";

const NO_MOMENTA: &str = "with `structure` there are no momenta: the state is `x` alone";

const BODY_WITH_STRUCTURE: &str =
    "with `attitude` the state is that of rigid bodies, whose structure is known: leave `structure` out";

const WITHOUT_ATTITUDE: &str =
    "`m = …` names the angular momentum of a rigid body: say which argument is its attitude, `attitude = …`";

const DAMPED_BODY: &str =
    "rigid bodies are moved by their energy alone: `damping` and `force` are for energies of `q` and `p`";

const ALWAYS_SEPARABLE: &str =
    "with `attitude` the energy has to be T(m) + V(r) with a quadratic T: leave `require` out";

const TWO_WAYS: &str = "`coordinates` says how the energy is split: leave `split` out";

const DAMPED_PARTS: &str = "damping, or a force, is no part of an exact flow or a kick: leave it out, or this";

const PARTS_OF_BODIES: &str = "with `attitude` the parts of the energy are known, T(m) and V(r): leave this out";
