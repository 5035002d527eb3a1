//! Which texts there are, by paper.

use super::paper::Paper;
use crate::error::{Error, Result};
use crate::steps::Text;

/// Every paper whose texts are here, one line each. The line makes it a module, too; its file has its [`Paper`].
macro_rules! every_paper {
    ($receiver:ident) => {
        $receiver! {
            everitt_2001,
            vtk,
            carr_2008,
            lindholm_2015,
            bavoil_2008,
            vasilakis_2013,
            mcguire_2013,
            salvi_2014,
            edition,
        }
    };
}

macro_rules! index {
    ($($paper:ident,)*) => {
        /// Every paper whose texts are here.
        pub const fn papers() -> &'static [Paper] {
            &[$(super::$paper::PAPER),*]
        }
    };
}

every_paper!(index);

/// The texts of a name, each with its full name. The name is that of a text, such as `everitt/listing-1`, or of a
/// paper, such as `everitt`, for all of its texts.
///
/// ```
/// use onionskin::low_level::steps::{Recorder, Variables, print, run};
/// use onionskin::{Text, texts};
///
/// let (name, text) = texts("everitt/listing-1")?.remove(0);
/// let Text::Listing(listing, amendments) = text else {
///     panic!("{name} is pseudocode");
/// };
/// println!("{}", print::listing(listing, amendments));
/// // Its calls, one after the other; a `GlMachine` in place of the recorder draws.
/// let mut calls = Recorder::new();
/// run(listing, &[], Variables::new().with("num_passes", 2.0), &mut calls)?;
/// assert!(calls.calls.len() > 20);
/// # Ok::<(), onionskin::Error>(())
/// ```
///
/// # Errors
/// If there is none of that name. It says which was probably meant, and which there are.
pub fn texts(name: &str) -> Result<Vec<(String, &'static Text)>> {
    let all = papers().iter().flat_map(|paper| {
        let named = |(key, text)| (paper.key, format!("{}/{key}", paper.key), text);
        paper.texts.iter().map(|(key, text)| (key, text)).map(named)
    });
    let all: Vec<_> = all.collect();
    let wanted = |(paper, whole, _): &&(&str, String, _)| *paper == name || whole == name;
    let found: Vec<_> = all
        .iter()
        .filter(wanted)
        .map(|(_, whole, text)| (whole.clone(), *text))
        .collect();
    if found.is_empty() {
        let names: Vec<_> = all.iter().map(|(_, whole, _)| whole).collect();
        return Err(Error::unknown("listing", name, &names));
    }
    Ok(found)
}
