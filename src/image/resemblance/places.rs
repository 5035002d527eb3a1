//! Mistakes that put pixels elsewhere.

use super::pair::{Pair, Tried};

/// The largest shift that is tried, in whole pixels along x and y.
const FARTHEST: i32 = 8;

/// The number of rows in which a shift is looked for.
const ROWS: i32 = 256;

pub(super) fn tried(pair: &Pair<'_>) -> Vec<Tried> {
    let [width, height] = [pair.exact.width as i32, pair.exact.height as i32];
    let (right, bottom) = (width - 1, height - 1);
    let mut tried = vec![
        Tried::new(
            left(pair, |x, y| [x, bottom - y]),
            "The image is the exact one upside down: rows are flipped vertically. OpenGL counts rows from the bottom, \
             picture files from the top.",
        ),
        Tried::new(
            left(pair, |x, y| [right - x, y]),
            "The image is the exact one, flipped horizontally.",
        ),
        Tried::new(
            left(pair, |x, y| [right - x, bottom - y]),
            "The image is the exact one, rotated by 180 degrees.",
        ),
    ];
    tried.extend(shifted(pair, [width, height]));
    tried
}

/// The number of pixels that differ from the exact pixel at the place that a rule gives. Pixels for which that place is
/// outside do not count.
fn left(pair: &Pair<'_>, place: impl Fn(i32, i32) -> [i32; 2]) -> usize {
    among_rows(pair, 1, usize::MAX, place)
}

/// The same, only in every `step`-th row, and given up when the number exceeds a limit.
fn among_rows(
    pair: &Pair<'_>,
    every: usize,
    most: usize,
    place: impl Fn(i32, i32) -> [i32; 2],
) -> usize {
    let [width, height] = [pair.exact.width as i32, pair.exact.height as i32];
    let mut left = 0;
    for y in (0..height).step_by(every) {
        for x in 0..width {
            let [column, row] = place(x, y);
            if (0..width).contains(&column) && (0..height).contains(&row) {
                let image = pair.image.pixels[(y * width + x) as usize];
                let exact = pair.exact.pixels[(row * width + column) as usize];
                left += usize::from(!pair.same(&image, &exact));
            }
        }
        if left > most {
            break;
        }
    }
    left
}

/// The shift after which the fewest pixels differ, or the shortest one of several. In a large picture it is looked for
/// in some rows, and then tried on all. A shift by more than a quarter of the picture leaves too little to compare.
fn shifted(pair: &Pair<'_>, [width, height]: [i32; 2]) -> Option<Tried> {
    let [most_x, most_y] = [width, height].map(|side| FARTHEST.min(side / 4));
    let shifts = (-most_y..=most_y).flat_map(|y| (-most_x..=most_x).map(move |x| [x, y]));
    let mut shifts: Vec<[i32; 2]> = shifts.filter(|shift| *shift != [0, 0]).collect();
    shifts.sort_by_key(|[x, y]| x * x + y * y);
    let every = (height / ROWS).max(1) as usize;
    let mut best: Option<(usize, [i32; 2])> = None;
    for [dx, dy] in shifts {
        let most = best.map_or(usize::MAX, |(left, _)| left);
        let left = among_rows(pair, every, most, |x, y| [x - dx, y - dy]);
        if left < most {
            best = Some((left, [dx, dy]));
        }
    }
    let (_, [dx, dy]) = best?;
    let left = left(pair, |x, y| [x - dx, y - dy]);
    let along = |by: i32, [less, more]: [&str; 2]| match by {
        0 => None,
        by => {
            let (count, way) = (by.abs(), if by < 0 { less } else { more });
            let plural = if count == 1 { "" } else { "s" };
            Some(format!("{count} pixel{plural} {way}"))
        }
    };
    let ways = [
        along(dx, ["to the left", "to the right"]),
        along(dy, ["up", "down"]),
    ];
    let ways: Vec<String> = ways.into_iter().flatten().collect();
    let sentence = format!(
        "The image is the exact one, shifted by {}.",
        ways.join(" and ")
    );
    Some(Tried::new(left, sentence))
}
