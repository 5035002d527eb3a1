//! ppDP's pseudocode on a list of depths, in Rust, without a shader: what each rule must lose.

/// How a subpass tells which fragments were resolved before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(dead_code)] // not every test needs every rule
pub enum Rule {
    /// `depth(f) <= min depth`, min depth 0 at first, as printed.
    Printed,
    /// (depth, place in the order of submission), and nothing resolved at first.
    Amended,
    /// The text beside the pseudocode: n - 1 are resolved of a buffer of n, and min depth is "of the last buffer element".
    PrintedText,
}

/// What came of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Peeled {
    /// Fragments in the order in which they were resolved, by place in the list.
    pub resolved: Vec<usize>,
    pub lost: usize,
    pub subpasses: usize,
    /// Whether "until all fragments are resolved", read as a count, would ever have held.
    pub ends_by_count: bool,
}

/// Peels a list of depths, in the order of submission, with a buffer of `n`.
pub fn peel(depths: &[u32], n: usize, rule: Rule) -> Peeled {
    let mut resolved = Vec::new();
    let mut min: Option<(u32, usize)> = None;
    let mut subpasses = 0;
    loop {
        subpasses += 1;
        let mut left: Vec<usize> = (0..depths.len())
            .filter(|&f| match (rule, min) {
                (Rule::Amended, None) => true,
                (Rule::Amended, Some(min)) => (depths[f], f) > min,
                (_, min) => depths[f] > min.map_or(0, |(depth, _)| depth),
            })
            .collect();
        left.sort_by_key(|&f| (depths[f], f));
        let overflow = left.len() > n;
        left.truncate(n);
        let Some(&last) = left.last() else { break };
        min = Some((depths[last], last));
        let taken = if rule == Rule::PrintedText && overflow {
            n - 1
        } else {
            left.len()
        };
        resolved.extend_from_slice(&left[..taken]);
        if !overflow {
            break;
        }
    }
    Peeled {
        lost: depths.len() - resolved.len(),
        ends_by_count: resolved.len() == depths.len(),
        resolved,
        subpasses,
    }
}
