//! An amendment of a test: other steps, to see whether that is noticed.

use onionskin::low_level::steps::{Amendment, Step};

pub const fn changed(printed: &'static [Step], amended: &'static [Step]) -> Amendment {
    Amendment {
        key: "",
        kind: onionskin::low_level::steps::Kind::Correction,
        place: "",
        printed,
        amended,
        why: "to see whether it is noticed",
        test: "",
    }
}
