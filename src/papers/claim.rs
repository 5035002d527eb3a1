//! What a paper claims, and what running it has shown.

use std::fmt;

/// A claim of a paper that a program can check.
#[derive(Clone, Copy, Debug)]
pub struct Claim {
    /// A letter for the paper and a number, such as `E01`. The names of tests of this claim begin with it.
    pub key: &'static str,
    /// Where the paper claims it: a section, a figure, a table.
    pub place: &'static str,
    /// The claim, in this project's words.
    pub claim: &'static str,
    /// What running it has shown.
    pub verdict: Verdict,
    /// Figures: the paper's, if it gives one, beside what is found here.
    pub figures: &'static [Figure],
    /// Why the verdict is what it is.
    pub evidence: &'static str,
    /// The tests that show it, as paths of functions. The first word is the test binary, as in
    /// `cargo test --test gl e01_`.
    pub tests: &'static [&'static str],
}

/// What is to be thought of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It holds as it is printed, and so do its figures, if it has any.
    Reproduced,
    /// What it says holds, but with other figures, on other scenes, or in a part only, which the evidence names.
    InKind,
    /// It does not hold.
    Contradicted,
    /// It does not hold as it is printed, and it does with corrections or additions, which the evidence names.
    Amended,
    /// Nothing here decides it: it is about what is not at hand, such as times on the paper's GPUs. The evidence says what
    /// was found instead.
    Open,
}

impl Verdict {
    /// Every verdict, from the best.
    pub const ALL: [Self; 5] = [
        Self::Reproduced,
        Self::InKind,
        Self::Contradicted,
        Self::Amended,
        Self::Open,
    ];
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Reproduced => "reproduced",
            Self::InKind => "in kind",
            Self::Contradicted => "contradicted",
            Self::Amended => "amended",
            Self::Open => "open",
        })
    }
}

/// A figure of a paper, and the one that is found here.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// What is counted or measured.
    pub of: &'static str,
    /// What the paper prints, if anything.
    pub paper: Option<&'static str>,
    /// What a test of the claim asserts or prints.
    pub here: &'static str,
}

/// A paper's claims, a row each. A figure that the paper does not give is "-". The tests are written as paths of functions. Each test binary reads the same tables by
/// a macro of its own, so that a path which leads nowhere does not compile there.
macro_rules! claims {
    ($($key:ident ($place:literal) $verdict:ident {
        claim: $claim:literal,
        $(figures: [$(($of:literal, $paper:literal, $here:literal)),+ $(,)?],)?
        evidence: $evidence:literal,
        tests: [$($binary:ident $(:: $name:ident)+),+ $(,)?],
    })*) => {
        /// What the paper claims.
        pub const CLAIMS: &[$crate::low_level::papers::Claim] = &[$($crate::low_level::papers::Claim {
            key: stringify!($key),
            place: $place,
            claim: $claim,
            verdict: $crate::low_level::papers::Verdict::$verdict,
            figures: &[$($($crate::low_level::papers::Figure {
                of: $of,
                paper: match $paper.as_bytes() {
                    b"-" => None,
                    _ => Some($paper),
                },
                here: $here,
            }),+)?],
            evidence: $evidence,
            tests: &[$(concat!(stringify!($binary) $(, "::", stringify!($name))+)),+],
        }),*];
    };
}
