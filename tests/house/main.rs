//! The house itself: its floors, and what the README and the findings say of it.

mod circles;
mod examples;
mod flags;
mod floors;
mod imports;
mod papers;
mod readme;
mod sources;
mod surface;
