//! Two sums over 32-bit words, by which runs are told apart: those of `node.js`.

pub(crate) struct Digest {
    a: u32,
    b: u32,
    /// The words themselves since they were last taken, if they are wanted.
    pub(crate) words: Option<Vec<u32>>,
}

impl Digest {
    pub(crate) fn new(with_words: bool) -> Self {
        Self {
            a: 0x811c_9dc5,
            b: 0x9e37_79b9,
            words: with_words.then(Vec::new),
        }
    }

    pub(crate) fn add(&mut self, word: u32) {
        self.a = (self.a ^ word).wrapping_mul(0x0100_0193);
        self.b = self.b.wrapping_add(word).wrapping_mul(0x85eb_ca6b) ^ (self.b >> 13);
        if let Some(words) = &mut self.words {
            words.push(word);
        }
    }

    /// There is one zero: the sign of it depends on the order in which `min` looks at its sides.
    pub(crate) fn float(&mut self, value: f32) {
        self.add((value + 0.0).to_bits());
    }

    pub(crate) fn floats(&mut self, values: &[f32]) {
        values.iter().for_each(|value| self.float(*value));
    }

    pub(crate) fn text(&mut self, text: &str) {
        text.chars().for_each(|letter| self.add(letter.into()));
    }

    /// The words since they were last taken.
    pub(crate) fn take(&mut self) -> String {
        let words = self.words.as_mut().map(std::mem::take).unwrap_or_default();
        let words: Vec<_> = words.iter().map(u32::to_string).collect();
        words.join(" ")
    }

    pub(crate) fn value(&self) -> [u32; 2] {
        [self.a, self.b]
    }
}
