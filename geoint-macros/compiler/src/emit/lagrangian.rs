//! Items of systems with velocities: the value of a Lagrangian, and the maps between velocities and momenta. An energy has a Lagrangian, too.

use super::context::Context;
use super::implementation::proven;
use super::structure::{self_type, state};
use crate::derive::{Kernels, Lagrangian, OfEnergy, System};
use crate::parse::Energy;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns `impl LagrangianSystem` and the user's methods.
pub(super) fn lagrangian(context: &Context<'_>, found: &Lagrangian) -> TokenStream {
    let (array, phase, parts, action) =
        (context.positions_type(), context.phase_type(), context.parts(), context.action_type());
    let (value, momenta) = (context.returned(&found.value), context.assigned(&found.momenta));
    let velocities = match &found.velocities {
        Some(velocities) => {
            let velocities = context.assigned(velocities);
            quote! {
                #parts
                let mut velocity = <#array as Array>::zero();
                #velocities
                velocity
            }
        }
        None => quote!(velocity_of(self, t, z, s)),
    };
    let Energy { name: plain, float, coordinates, runtime, .. } = context.energy;
    let (form, state, coordinates) = (context.form, state(context.form), &coordinates.ty);
    // Argument and value of the action.
    let [takes, hands] = if form.has_action() { [quote!(, s: #float), quote!(, s)] } else { [quote!(), quote!()] };
    let given = if form.has_action() { quote!(&s) } else { quote!(&()) };
    // Without a formula for velocities, an iteration may find another velocity with the same momenta. The momentum is
    // NaN for such a velocity.
    let momenta_of_state = match found.velocities {
        Some(_) => quote!(#state::at(t, q, self.momentum(t, q, v #hands) #hands)),
        None => quote! {
            let [position, velocity] = [q, v].map(Coordinates::into_array);
            let momentum = #runtime::private::own_momentum(self, t, &position, &velocity, #given);
            #state::at(t, q, Coordinates::from_array(momentum) #hands)
        },
    };
    let from_positions = (!form.has_action() && !context.energy.options.is_constrained()).then(|| {
        quote! {
            /// The state at time `t` with position `now`, and the momentum that the implicit midpoint rule has there when a step of
            /// length `h` has led from `before` to `now`: what recursions of positions alone start with. Of order 2 in h.
            pub fn from_positions(&self, t: #float, before: #coordinates, now: #coordinates, h: #float) -> #state<#coordinates> {
                let [before, after] = [before, now].map(Coordinates::into_array);
                let momentum = from_positions(self, t, [&before, &after], h);
                #state::at(t, Coordinates::from_array(after), Coordinates::from_array(momentum))
            }
        }
    });
    let items = quote! {
        #[inline]
        fn lagrangian(&self, t: R, q: &#array, v: &#array, s: &#action) -> R {
            #value
        }
        #[inline]
        fn momentum(&self, t: R, q: &#array, v: &#array, s: &#action) -> #array {
            let mut momentum = <#array as Array>::zero();
            #momenta
            momentum
        }
        #[inline]
        fn velocity(&self, t: R, z: &#phase, s: &#action) -> #array {
            #velocities
        }
    };
    let implementation = proven(context, quote!(LagrangianSystem<R>), items);
    quote! {
        #implementation
        impl #plain {
            /// The state with these positions and velocities, at t = 0. The first step reports velocities without a finite momentum of their own.
            pub fn at(&self, q: #coordinates, v: #coordinates #takes) -> #state<#coordinates> {
                self.at_time(0.0, q, v #hands)
            }

            /// The state with these positions and velocities at a time.
            pub fn at_time(&self, t: #float, q: #coordinates, v: #coordinates #takes) -> #state<#coordinates> {
                #momenta_of_state
            }

            /// The momenta ∂L/∂v.
            pub fn momentum(&self, t: #float, q: #coordinates, v: #coordinates #takes) -> #coordinates {
                let [q, v] = [q, v].map(Coordinates::into_array);
                Coordinates::from_array(LagrangianSystem::momentum(self, t, &q, &v, #given))
            }

            /// The velocities of a state.
            pub fn velocity(&self, state: &#state<#coordinates>) -> #coordinates {
                let (t, z, s) = state.parts();
                Coordinates::from_array(LagrangianSystem::velocity(self, t, &z, &s))
            }

            /// The Lagrangian.
            pub fn lagrangian(&self, t: #float, q: #coordinates, v: #coordinates #takes) -> #float {
                let [q, v] = [q, v].map(Coordinates::into_array);
                LagrangianSystem::lagrangian(self, t, &q, &v, #given)
            }

            #from_positions
        }
    }
}

/// Returns the user's methods of an energy: the value of its Lagrangian, and states from velocities if momenta are a formula of velocities.
pub(super) fn of_energy(context: &Context<'_>, system: &System) -> TokenStream {
    let lagrangian = match system.kernels {
        Kernels::Constrained(_) => quote!(constrained_lagrangian_of),
        _ => quote!(lagrangian_of),
    };
    let Energy { name: plain, float, coordinates, .. } = context.energy;
    let (state, coordinates) = (state(context.form), &coordinates.ty);
    let from_velocities = system.of_energy.as_ref().map(|OfEnergy { momenta, .. }| {
        let (name, array, momenta) = (self_type(context), context.positions_type(), context.assigned(momenta));
        quote! {
            trait OfVelocities<R: Real> {
                fn momentum(&self, t: R, q: &#array, v: &#array) -> #array;
            }
            impl<R: Real> OfVelocities<R> for #name {
                #[inline]
                fn momentum(&self, t: R, q: &#array, v: &#array) -> #array {
                    let mut momentum = <#array as Array>::zero();
                    #momenta
                    momentum
                }
            }
            impl #plain {
                /// The state with these positions and velocities, at t = 0.
                pub fn at(&self, q: #coordinates, v: #coordinates) -> #state<#coordinates> {
                    self.at_time(0.0, q, v)
                }

                /// The state with these positions and velocities at a time.
                pub fn at_time(&self, t: #float, q: #coordinates, v: #coordinates) -> #state<#coordinates> {
                    let [position, velocity] = [q, v].map(Coordinates::into_array);
                    #state::at(t, q, Coordinates::from_array(OfVelocities::momentum(self, t, &position, &velocity)))
                }
            }
        }
    });
    quote! {
        impl #plain {
            /// The Lagrangian p·∂H/∂p − H of a state.
            pub fn lagrangian(&self, state: &#state<#coordinates>) -> #float {
                #lagrangian(self, state)
            }
        }
        #from_velocities
    }
}

/// Returns the user's methods of a Lagrangian that is linear in velocities.
pub(super) fn first_order(context: &Context<'_>, found: &Lagrangian) -> TokenStream {
    let (name, array) = (self_type(context), context.positions_type());
    let (value, momenta) = (context.returned(&found.value), context.assigned(&found.momenta));
    let Energy { name: plain, float, coordinates, .. } = context.energy;
    let (state, coordinates) = (state(context.form), &coordinates.ty);
    quote! {
        trait OfVelocities<R: Real> {
            fn lagrangian(&self, t: R, q: &#array, v: &#array) -> R;
            fn momentum(&self, t: R, q: &#array) -> #array;
        }
        impl<R: Real> OfVelocities<R> for #name {
            #[inline]
            fn lagrangian(&self, t: R, q: &#array, v: &#array) -> R {
                #value
            }
            #[inline]
            fn momentum(&self, t: R, q: &#array) -> #array {
                let mut momentum = <#array as Array>::zero();
                #momenta
                momentum
            }
        }
        impl #plain {
            /// The state with these positions, at t = 0: velocities follow from them.
            pub fn at(&self, q: #coordinates) -> #state<#coordinates> {
                self.at_time(0.0, q)
            }

            /// The state with these positions at a time.
            pub fn at_time(&self, t: #float, q: #coordinates) -> #state<#coordinates> {
                #state::at(t, q)
            }

            /// The momenta ∂L/∂v, functions of positions.
            pub fn momentum(&self, t: #float, q: #coordinates) -> #coordinates {
                Coordinates::from_array(OfVelocities::momentum(self, t, &Coordinates::into_array(q)))
            }

            /// The velocities of a state.
            pub fn velocity(&self, state: &#state<#coordinates>) -> #coordinates {
                self.field(state)
            }

            /// The Lagrangian.
            pub fn lagrangian(&self, t: #float, q: #coordinates, v: #coordinates) -> #float {
                let [q, v] = [q, v].map(Coordinates::into_array);
                OfVelocities::lagrangian(self, t, &q, &v)
            }
        }
    }
}
