//! Games and real time.
