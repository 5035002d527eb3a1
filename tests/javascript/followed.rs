//! Pseudocode on the emulated pixel, with a digest of every line that is executed.

use std::collections::HashMap;

use onionskin::low_level::emulator::{ExecutedLine, ExecutedListLine};

use crate::digest::Digest;

/// The lines that the emulated pixel has executed, and what it held after each.
pub(crate) struct Followed {
    /// The sums over each line's words.
    known: HashMap<*const (), [u32; 2]>,
    digest: Digest,
    /// Every line in words, if they are wanted.
    pub(crate) said: Vec<String>,
}

/// The word for no fragment. There are fewer surfaces.
const NO_FRAGMENT: u32 = 99;

impl Followed {
    pub(crate) fn new(detail: bool) -> Self {
        Self {
            known: HashMap::new(),
            digest: Digest::new(detail),
            said: Vec::new(),
        }
    }

    pub(crate) fn digest(&self) -> [u32; 2] {
        self.digest.value()
    }

    pub(crate) fn on_fragments(&mut self, executed: &ExecutedLine<'_>) {
        self.line(executed.line, executed.fragment, executed.holds);
        let mut variables: Vec<_> = executed.variables(0).collect();
        variables.push(("gChanged", f32::from(u8::from(executed.changed))));
        variables.sort_by_key(|(name, _)| *name);
        for (name, value) in variables {
            self.digest.text(name);
            self.digest.float(value);
        }
        self.digest.add(executed.composited[0].len() as u32);
        self.say(executed.line);
    }

    pub(crate) fn on_lists(&mut self, executed: &ExecutedListLine<'_>) {
        self.line(executed.line, executed.fragment, executed.holds);
        let state = executed.state(0);
        let digest = &mut self.digest;
        digest.add(executed.size);
        for order in state.buffer.iter().flatten() {
            digest.add(*order);
        }
        if let Some((depth, id)) = state.min {
            digest.float(depth);
            digest.add(match id {
                i64::MAX => u32::MAX,
                -1 => u32::MAX - 1,
                id => id as u32,
            });
        }
        let done = state.done;
        for word in [
            state.complexity,
            state.stencil.into(),
            state.marked.into(),
            done.composited.len() as u32,
            done.times,
            done.records_read,
            done.slots[0],
            done.slots[1],
        ] {
            digest.add(word);
        }
        self.say(executed.line);
    }

    fn line<L: ToString>(&mut self, line: &L, fragment: Option<u32>, holds: Option<bool>) {
        let known = self.known.entry(std::ptr::from_ref(line).cast());
        let sums = *known.or_insert_with(|| {
            let mut digest = Digest::new(false);
            digest.text(&line.to_string());
            digest.value()
        });
        sums.into_iter().for_each(|word| self.digest.add(word));
        self.digest.add(fragment.unwrap_or(NO_FRAGMENT));
        self.digest.add(holds.map_or(2, u32::from));
    }

    fn say(&mut self, line: &impl ToString) {
        if self.digest.words.is_some() {
            let line = line.to_string();
            self.said.push(format!("{line}: {}", self.digest.take()));
        }
    }
}
