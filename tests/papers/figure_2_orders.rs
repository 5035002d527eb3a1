//! Figure 2's trace against every order of depths that its ten surfaces can have: which ends of the ranges of passes 3 and
//! 4 does it fit? The passes are written here once more, in whole numbers, and share no code with the listings.

/// The depths of s1 to s10, as places from 1 to 10; index 0 is s1.
pub(crate) type Depths = [u32; 10];

/// Behind every surface.
const FAR: u32 = 11;

/// The upper end of the ranges of passes 3 and 4, for which the paper prints no bracket.
#[derive(Clone, Copy, Debug)]
pub(crate) enum End {
    Open,
    Closed,
}

/// What the paper says of figure 2: pass 1 counts s1, s2 and s3; pass 2 stops at s2; pass 3 counts s3, s5, s6 and s7, and
/// s9 inverts 4 to 251; pass 4 skips these four, renders s9 and s10, and leaves D(s10). The last peeled surface is s4.
/// The result is the depth that pass 3 leaves, if all of this holds.
pub(crate) fn fits(depths: &Depths, end: End) -> Option<u32> {
    let depth = |s: usize| depths[s - 1];
    let peeled = depth(4);
    let all = || (1..=10).map(|s| (s, depth(s)));

    // Passes 1 and 2, in (D(sc), opaque).
    let mut nearest = FAR;
    let mut updates = Vec::new();
    for (s, z) in all().filter(|&(_, z)| z > peeled) {
        if z < nearest {
            nearest = z;
            updates.push(s);
        }
    }
    if updates != [1, 2, 3] {
        return None;
    }
    let (mut stencil, mut z_min_prev) = (3, FAR);
    for (_, z) in all().filter(|&(_, z)| z > peeled) {
        if 1 < stencil && z < z_min_prev {
            z_min_prev = z;
            stencil -= 1;
        }
    }
    if z_min_prev != depth(2) || stencil != 1 {
        return None;
    }

    // Passes 3 and 4, from D(sn) up to z_min_prev.
    let in_range = |&(_, z): &(usize, u32)| {
        let before_end = match end {
            End::Open => z < z_min_prev,
            End::Closed => z <= z_min_prev,
        };
        nearest <= z && before_end
    };
    let (mut stencil, mut farthest) = (0_u8, 0);
    let (mut counted, mut inverted) = (Vec::new(), Vec::new());
    for (s, z) in all().filter(in_range) {
        if 128 > stencil && z > farthest {
            farthest = z;
            stencil += 1;
            counted.push(s);
        } else if 128 > stencil {
            stencil = !stencil;
            inverted.push(s);
        }
    }
    if counted != [3, 5, 6, 7] || inverted != [9] || stencil != 251 {
        return None;
    }
    let mut z_min_post = FAR;
    let (mut skipped, mut rendered) = (Vec::new(), Vec::new());
    for (s, z) in all().filter(in_range) {
        if stencil == 255 {
            rendered.push(s);
            z_min_post = z_min_post.min(z);
        } else {
            stencil += 1;
            skipped.push(s);
        }
    }
    let as_said = skipped == [3, 5, 6, 7] && rendered == [9, 10] && z_min_post == depth(10);
    as_said.then_some(farthest)
}

/// Every order of the ten depths, one after the other (Heap's algorithm).
fn every_order(mut visit: impl FnMut(&Depths)) {
    let mut depths: Depths = std::array::from_fn(|at| at as u32 + 1);
    let mut counters = [0; 10];
    visit(&depths);
    let mut at = 1;
    while at < depths.len() {
        if counters[at] == at {
            counters[at] = 0;
            at += 1;
            continue;
        }
        let other = if at % 2 == 0 { 0 } else { counters[at] };
        depths.swap(other, at);
        visit(&depths);
        counters[at] += 1;
        at = 1;
    }
}

/// The closing bracket is a filling: figure 2 proves it.
#[test]
pub(crate) fn figure_2_fits_eighteen_orders_with_half_open_ranges_and_none_with_closed_ones() {
    let (mut orders, mut half_open, mut closed) = (0, Vec::new(), 0);
    every_order(|depths| {
        orders += 1;
        if let Some(left) = fits(depths, End::Open) {
            half_open.push((*depths, left));
        }
        closed += usize::from(fits(depths, End::Closed).is_some());
    });
    assert_eq!(orders, 3_628_800);
    assert_eq!((half_open.len(), closed), (18, 0));
    for (depths, left) in half_open {
        let depth = |s: usize| depths[s - 1];
        for [nearer, farther] in [[4, 3], [3, 5], [5, 6], [6, 7], [7, 2], [2, 1]] {
            assert!(depth(nearer) < depth(farther), "{depths:?}");
        }
        assert!(depth(3) < depth(10) && depth(10) < depth(9) && depth(9) < depth(7));
        // CX01: pass 3 never leaves D(s9), as the text says, since what fails the depth test writes no depth.
        assert_eq!(left, depth(7));
    }
}
