//! When the macro cannot help.
