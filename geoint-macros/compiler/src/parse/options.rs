//! The arguments of an attribute, and the rules for their combination.

use super::flow::{Kept, StructureForm};
use super::outside::Outside;
use super::values::{Coordinates, Requirement};
use super::{Role, runtime};
use proc_macro2::{Ident, Span, TokenStream};
use std::rc::Rc;
use syn::spanned::Spanned;
use syn::{Expr, Path};

/// Arguments of an attribute. Expressions are written in terms of the arguments of the function.
#[derive(Clone, Default)]
pub(crate) struct Options {
    /// Name of the generated struct.
    pub(super) name: Option<Ident>,
    /// Path of the runtime, from `crate = path`.
    pub(super) runtime: Option<Path>,
    /// Arguments with a role that the attribute names, such as `q = angle`.
    pub(super) roles: Vec<(Role, Ident)>,
    /// Argument of `x = …` for an energy. The structure of the energy needs it.
    pub(super) all: Option<Ident>,
    /// Constants and aliases that the attribute repeats.
    pub(crate) outside: Rc<Outside>,
    /// Properties to prove.
    pub(crate) requirements: Vec<(Requirement, Span)>,
    /// Coefficients of damping.
    pub(crate) damping: Option<Expr>,
    /// Rayleigh's dissipation function R of a Lagrangian.
    pub(crate) rayleigh: Option<Expr>,
    /// Force F without a potential.
    pub(crate) force: Option<Expr>,
    /// Functions g of constraints g(q, t) = 0.
    pub(crate) constraint: Option<Expr>,
    /// Functions r of constraints r(q, v, t) = 0 that are linear in velocities.
    pub(crate) rolling: Option<Expr>,
    /// S of x' = S(x) ∇H.
    pub(crate) structure: Option<StructureForm>,
    /// S of x' = L ∇E + M ∇S, where L is the structure.
    pub(crate) entropy: Option<Expr>,
    /// M of x' = L ∇E + M ∇S.
    pub(crate) friction: Option<Expr>,
    /// First integrals of a vector field.
    pub(crate) keeps: Vec<Kept>,
    /// Density ρ of an invariant measure of a field.
    pub(crate) measure: Option<Expr>,
    /// Pieces into which the energy is split.
    pub(crate) split: Option<Vec<Expr>>,
    /// Coordinates in which methods move bodies.
    pub(crate) coordinates: Option<(Coordinates, Span)>,
    /// Place of `lift`. A lift p·f(q) needs no evolution of its momenta.
    pub(crate) lift: Option<Span>,
    /// Paths of functions under `#[energy_function]`.
    pub(crate) with: Vec<Path>,
}

impl Options {
    /// Returns the argument with the given role, if the attribute names one.
    pub(super) fn named(&self, role: Role) -> Option<&Ident> {
        self.roles.iter().find(|(other, _)| *other == role).map(|(_, name)| name)
    }

    /// Returns whether there are constraints of positions or velocities.
    pub(crate) fn is_constrained(&self) -> bool {
        self.constraint.is_some() || self.rolling.is_some()
    }

    /// Returns the path of the runtime in generated code.
    pub(crate) fn runtime_path(&self) -> TokenStream {
        runtime::path_or(self.runtime.as_ref())
    }

    /// Checks that the arguments fit together. A structure excludes momenta and a kinetic part. Rigid bodies are not damped.
    pub(super) fn consistent(self) -> syn::Result<Self> {
        let span = |role: Role| self.named(role).map(Ident::span);
        let [attitude, angular_momentum] = [Role::Attitude, Role::AngularMomentum].map(span);
        let required = self.requirements.first().map(|(_, span)| *span);
        let force = self.force.as_ref().map(Spanned::span);
        let [damping, entropy, friction] =
            [&self.damping, &self.entropy, &self.friction].map(|expr| expr.as_ref().map(Spanned::span));
        let nonconservative = damping.or(force);
        let split = self.split.as_ref().and_then(|pieces| pieces.first()).map(Spanned::span);
        let coordinates = self.coordinates.map(|(_, span)| span);
        let parts = coordinates.or(split);
        let constraint = self.constraint.as_ref().or(self.rolling.as_ref()).map(Spanned::span);
        let (structured, bodies) = (self.structure.is_some(), attitude.is_some());
        let canonical = !structured && !bodies;
        // An argument conflicts with the others if the condition holds. The first conflict is reported.
        let conflicts = [
            (entropy.or(friction), !structured, WITHOUT_STRUCTURE),
            (entropy, friction.is_none(), WITHOUT_FRICTION),
            (friction, entropy.is_none(), WITHOUT_ENTROPY),
            (damping, entropy.is_some(), DAMPED_ENTROPY),
            (constraint, !canonical || parts.is_some() || force.is_some(), CONSTRAINED),
            (constraint, self.lift.is_some(), CONSTRAINED_LIFT),
            (attitude, structured, BODY_WITH_STRUCTURE),
            (span(Role::Momentum).or(required).or(parts).or(force), structured, NO_MOMENTA),
            (angular_momentum, canonical, WITHOUT_ATTITUDE),
            (coordinates, canonical && split.is_some(), TWO_WAYS),
            (parts, canonical && nonconservative.is_some(), DAMPED_PARTS),
            (nonconservative, bodies, DAMPED_BODY),
            (required, bodies, ALWAYS_SEPARABLE),
            (parts, bodies, PARTS_OF_BODIES),
        ];
        match conflicts.into_iter().find(|(span, applies, _)| *applies && span.is_some()) {
            Some((Some(span), _, message)) => Err(syn::Error::new(span, message)),
            _ => Ok(self),
        }
    }
}

const WITHOUT_STRUCTURE: &str =
    "`entropy = S` and `friction = M` belong to x' = L ∇E + M ∇S: add the skew matrix L, `structure = L`";

const WITHOUT_FRICTION: &str = "without friction the entropy is constant, a Casimir of the structure, which the report names by itself: add \
                                `friction = M`, or leave `entropy` out";

const WITHOUT_ENTROPY: &str = "`friction = M` is the matrix of x' = L ∇E + M ∇S: add the function S, `entropy = S`; a matrix C that takes energy \
                               away is `damping = C`";

const DAMPED_ENTROPY: &str =
    "with an entropy the energy is kept, and damping would take some away: write `friction = M` with M ∇E = 0 alone";

const CONSTRAINED: &str = "constraints are for positions and momenta whose energy is not split: leave out this, or `structure`, `attitude`, \
                           `split`, `coordinates` and `force`";

const CONSTRAINED_LIFT: &str =
    "the positions of a lift follow q' = X(q), and no constraint force acts on them: leave out this, or `lift`";

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
