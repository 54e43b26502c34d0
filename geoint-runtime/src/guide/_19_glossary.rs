//! Glossary.
