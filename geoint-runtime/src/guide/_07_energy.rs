//! Energy kept exactly.
