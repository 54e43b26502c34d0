//! Messages about terms that rule out a method. Checks report them at compile time; unimplemented traits carry them to the type system.

/// Page of the runtime's documentation on systems that the macro cannot compile.
pub(crate) const BY_HAND: &str = "`geoint_runtime::guide::_14_by_hand`";

pub(crate) const NO_PIECES: &str = "no flow in closed form is known for this term, so the energy cannot be split; use \
                                    `ContactMidpoint` or `ContactDiscreteGradient`";

pub(crate) const NO_CANONICAL_PIECES: &str = "no flow in closed form is known for this term, so that `PieceSplitting` has no pieces; use \
                                              `ImplicitMidpoint`, `Gauss` or `DiscreteGradient`";

pub(crate) const NOT_POISSON: &str = "no flow in closed form is known for this term, so that `PoissonSplitting` has no pieces; use \
                                      `DiscreteGradient`, `ImplicitMidpoint` or `Gauss`";

pub(crate) const NOT_PLANAR: &str = "no flow in closed form is known in a plane, and more than 12 planes without one are not solved for, so \
                                     that `PlanarSplitting` has no pieces; use `DiscreteGradient`, `ImplicitMidpoint` or `Gauss`";

pub(crate) const NOT_SOLVED: &str = "more than 12 planes are not solved for, so that there are no pieces for this method; use \
                                     `DiscreteGradient`, `ImplicitMidpoint` or `Gauss`";

pub(crate) const NO_STRUCTURE: &str = "a field is split by S of x' = S(x) ∇I, and no S was found for this I: write the system as \
                                       `#[hamiltonian(structure = S)]` with I for its energy, or use `DiscreteGradient`";

pub(crate) const CHANGED: &str = "a field is split by S of x' = S(x) ∇I, and what stands under `but` changes this I; use `DiscreteGradient`, \
                                  `ImplicitMidpoint` or `Gauss`";

pub(crate) const AT_REST: &str = "nothing moves, so that there are no pieces";

pub(crate) const NOTHING_KEPT: &str = "nothing was named that this field keeps, and no energy has it, because its divergence is not 0: name \
                                       what it keeps, `#[vector_field(keeps(name = expression))]`, or use `ImplicitMidpoint`, `Gauss` or `RK4`";

pub(crate) const DAMPED_FLOW: &str =
    "damping is no part of these pieces; use `DiscreteGradient`, `ImplicitMidpoint` or `Gauss`";

pub(crate) const FRICTION_FLOW: &str =
    "friction is no part of these pieces; use `DiscreteGradient`, which keeps the energy and never lowers the entropy";

pub(crate) const FORWARD: &str = "a step of order 4 may lower the entropy; use `DiscreteGradient` of order 2, or `RK4`, `DOP853` and `Gauss`, which keep \
                                  neither law exactly";

pub(crate) const NOT_MECHANICAL: &str = "this term is no part of T(p) + g·s + V(q), so kick and drift do not exist; use \
                                         `ContactSplitting`, `ContactMidpoint` or `ContactDiscreteGradient`";

pub(crate) const NOT_NYSTROM: &str = "the flow of this term is not that of a quadratic T(p) + g·s exactly in time, so \
                                      Runge–Kutta–Nyström tables, and those with force gradients, would lose their order; use a \
                                      table for every splitting, such as `BlanesMoan6`";

pub(crate) const COUPLED: &str = "this term couples positions and momenta, so kick and drift do not exist; \
                                  use `ImplicitMidpoint`, `Gauss` or `DiscreteGradient`";

pub(crate) const CONSTRAINED: &str =
    "kick and drift leave this constraint; use `Rattle`, `DiscreteGradient` or their compositions";

pub(crate) const NO_CONSTRAINT: &str = "no constraint is given: leave this out, or name functions that stay zero";

pub(crate) const COUPLED_IN_PIECES: &str = "this term couples positions and momenta, so kick and drift do not exist; its flow is known: use \
                                            `PieceSplitting`, or one of its compositions such as `KahanLi8_17a.of(PieceSplitting)`";

pub(crate) const FULL_MASS: &str = "by this entry of the mass matrix, or this term in velocities, positions and momenta are coupled, so that \
                                    kick and drift do not exist; use `ImplicitMidpoint`, `Gauss` or `DiscreteGradient`";

pub(crate) const FULL_MASS_OF_ACTION: &str = "by this entry of the mass matrix, or this term in velocities, positions and momenta are coupled, so that \
                                              kick and drift do not exist; use `ContactMidpoint`, `ContactGauss` or `ContactDiscreteGradient`";

pub(crate) const NO_PIECES_OF_VELOCITIES: &str = "by this entry of the mass matrix, or this term in velocities, the energy has no short formula that could be split; \
                                                  use `ContactMidpoint`, `ContactGauss` or `ContactDiscreteGradient`";

pub(crate) const NOT_POLARISED_OF_ACTION: &str = "this is not quadratic in the velocities, and no formula is known for its energy, so that there is no \
                                                  discrete gradient; use `ContactMidpoint` or `ContactGauss`";

pub(crate) const NOT_POLARISED: &str = "this is not quadratic in the velocities, and no formula is known for its energy, so that there is no \
                                        discrete gradient; use `ImplicitMidpoint` or `Gauss`";

pub(crate) const DAMPED: &str = "damping is no part of a kick or a drift; use `ImplicitMidpoint`, `Gauss` or `DiscreteGradient`, or write linear \
                                 friction as a term `+ gamma * s` under `#[contact_hamiltonian]`";

pub(crate) const FORCED: &str =
    "a force beside the energy is no part of a kick or a drift; use `ImplicitMidpoint`, `Gauss` or `DiscreteGradient`";

pub(crate) const TAKES_ENERGY: &str =
    "damping takes energy away, so that none is conserved: leave out the one or the other";

pub(crate) const DOES_WORK: &str = "a force beside the energy does work, so that none is conserved: leave out the one or the other; a force that \
                                    has a potential is a term of the energy";

pub(crate) const FORCED_ACTION: &str = "a force beside a Lagrangian with an action leaves no contact map, and no kick and drift; use `DOP853`, `RK4` or Taylor series";

pub(crate) const READS_ACTION: &str = "this reads the action, so that the energy changes with ∂H/∂s";

pub(crate) const NOT_QUADRATIC: &str = "this term is not quadratic in the momenta with constant coefficients, so \
                                        Runge–Kutta–Nyström tables, and those with force gradients, would lose their \
                                        order; use a table for every separable energy, such as `BlanesMoan6`";

pub(crate) const BODY_COUPLED: &str = "this term couples attitude and angular momentum; the energy of rigid bodies is T(m) + V(r), \
                                       with both in the frame of the body, and beside centres of mass T(m) + T(p) + V(r, q)";

pub(crate) const BODY_NOT_QUADRATIC: &str = "this term is not quadratic in the momenta with constant coefficients, so that the drift is \
                                             not that of a free rigid body";

pub(crate) const BODIES_COUPLED: &str = "this term couples the angular momenta of two bodies, so that the drift is not that of free \
                                         rigid bodies";

pub(crate) const CENTRES_COUPLED: &str = "this term couples the angular momentum of a body and the momentum of a centre of mass, so that the \
                                           drift is not that of free rigid bodies";

pub(crate) const NO_EXACT_PART: &str = "no part of this energy has an exact flow beside a rest that is a kick; for bodies that attract each \
                                        other `coordinates = jacobi` makes one, and `split = \"A | B\"` names one";

pub(crate) const NOT_A_KICK: &str =
    "the second part of `split` has to be a kick, a function of positions and time alone, and this is none";

pub(crate) const NOT_TWO_PARTS: &str = "methods for A + B need `split = \"A | B\"` with two parts, the one with an exact flow first; for more pieces there is `PieceSplitting`";

pub(crate) const NO_FLOW_OF_EXACT_PART: &str =
    "no flow in closed form is known for the first part of `split`, which is to be solved exactly";

pub(crate) const NOT_NYSTROM_EXACT: &str = "the part with an exact flow is not of degree 2 in the momenta with constant coefficients of \
                                            their squares, so that a kick with a force gradient is none; use a table without, such as \
                                            `Aba10_6_4`";

pub(crate) const JUMP_IS_NO_KICK: &str = "in heliocentric coordinates the rest moves positions by this term, so that it is no kick, with or without a \
                                          force gradient; use a table without, such as `Aba10_6_4`, or `coordinates = jacobi`";

pub(crate) const NOT_BODIES: &str = "`coordinates` are those of bodies: let `q` and `p` be arrays of vectors, one a body, as in \
                                     `[Vector3<f64>; 6]` or `[[f64; 2]; 3]`";

pub(crate) const NOT_ONE_MASS: &str =
    "`coordinates` need one constant mass a body, T = Σ |pᵢ|²/2mᵢ, and this term is another one";

pub(crate) const NO_MASS: &str =
    "`coordinates` need one constant mass a body, T = Σ |pᵢ|²/2mᵢ, and of this momentum there is no square";

pub(crate) const NO_CENTRE: &str =
    "`coordinates` need centres of mass, and the masses up to that of this term add up to zero";

pub(crate) const NO_ATTRACTION: &str = "`coordinates` make Kepler's motion of bodies that attract each other by −c/|qᵢ − qⱼ|, c a constant, and here is no \
                                        such term";
