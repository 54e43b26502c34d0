//! Events, sections, states between steps.
