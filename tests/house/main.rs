//! The house itself: its floors, and what the README and the findings say of it.

mod floors;
mod readme;
