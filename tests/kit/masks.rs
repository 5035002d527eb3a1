//! ppAO's masks by the stencil buffer: as amendments of the pseudocode, and as arithmetic that knows no lines.

use onionskin::low_level::papers::lindholm_2015::components::by_stencil;
use onionskin::low_level::steps::Amendment;
use onionskin::low_level::steps::pseudo::list::{Counter, ListLine, ListTest, Mark};

/// Section 6.2 with this counter and this mark.
pub fn stencil(counter: Counter, mark: Mark) -> [Amendment<ListLine>; 2] {
    let resolve = vec![ListLine::ResolveSegment, ListLine::Mark(mark)].leak();
    let masked = vec![ListLine::If(ListTest::StencilFitsSegment, resolve, &[])].leak();
    by_stencil(vec![ListLine::Count(counter)].leak(), masked)
}

/// How often a pixel of this complexity is resolved by the segments 8, 16 ... `max`.
#[allow(dead_code)] // not every test asks
pub fn times_resolved(complexity: u32, max: u32, mark: Mark, counter: Counter) -> u32 {
    let mut stencil = match counter {
        Counter::StencilWrapping => complexity % 256,
        _ => complexity.min(255),
    };
    let mut times = 0;
    let mut size = 8;
    while size <= max {
        // glStencilFunc clamps its reference to the stencil buffer's bits.
        let reference = size.min(255);
        if reference >= stencil {
            times += 1;
            stencil = match mark {
                Mark::Replace => reference,
                Mark::Invert => 255 - stencil,
                Mark::Keep | Mark::Resolved => stencil,
            };
        }
        size *= 2;
    }
    times
}
