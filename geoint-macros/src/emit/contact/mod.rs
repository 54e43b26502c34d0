//! What is emitted of contact systems.

mod implicit;
mod mechanics;
mod pieces;
mod report;
mod system;

use super::kernel::Context;
use crate::diff;
use crate::ir::{Graph, Id};
use crate::split::{Mechanics, Pieces};
use proc_macro2::TokenStream;
use quote::quote;

/// Everything that is emitted beside the user's function.
pub(crate) fn contact_items(
    context: &Context<'_>,
    graph: &mut Graph,
    energy: Id,
    found: &Pieces,
    mechanics: &Result<Mechanics, Id>,
) -> TokenStream {
    let bounds = super::system::bounds(graph, &[energy]);
    let gradient = diff::gradient(graph, energy, context.energy.degrees());
    let system = system::contact(context, graph, (energy, &gradient), &bounds);
    let (pieces, costs) = pieces::pieces(context, graph, found, &bounds);
    let kicks = mechanics::mechanics(context, graph, mechanics, &bounds);
    let conformal = system::conformal(context, graph, gradient.s, &bounds);
    // Implicit steps follow all coordinates.
    let lift = context.energy.lift.is_some();
    let (steps, step_costs) = if lift { Default::default() } else { implicit::steps(context, graph, energy, &bounds) };
    let facts =
        report::Facts { energy, decay: gradient.s, pieces: found, mechanics, costs: &costs, steps: &step_costs };
    let report = report::report(context, graph, &facts);
    let inherent = super::system::inherent(context, &report);
    super::around(context, &report, &quote!(#inherent #system #conformal #pieces #kicks #steps))
}
