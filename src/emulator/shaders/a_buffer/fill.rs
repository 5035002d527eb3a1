//! `a_buffer/fill.frag`: each fragment counts its pixel's counter up, and its record goes where the count says. Nodes of
//! linked lists are numbered pixel by pixel here, and not through the pool that all pixels share.

use super::super::verified::is_hidden;
use super::record::{append, is_linked};
use crate::low_level::emulator::color::Texel;
use crate::low_level::emulator::invocation::{Appended, Inputs, Kept, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    if i.is("MARKED") && is_hidden(i) {
        return None;
    }
    let [count, ..] = i.image(0).integers();
    let texel = |number: u32| Texel::Integers([number, 0, 0, 1]);
    let mut images = vec![(0, texel(count + 1))];
    let list = append(i, count);
    if let (true, Appended::Stored(at, _)) = (is_linked(i), &list) {
        images.push((1, texel(at + 1)));
    }
    Some(Kept {
        images,
        list: Some(list),
        ..Kept::default()
    })
}
