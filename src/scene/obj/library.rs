//! Reading an MTL file, as far as it is needed: the statements of the materials that are used.

use super::numbers;
use super::transparency::Evidence;
use super::words;

/// A statement of a material, and its line.
#[derive(Clone, Default)]
pub(super) struct Statement {
    pub(super) line: usize,
    pub(super) rest: Vec<u8>,
}

impl Statement {
    /// The number in `d 0.5` or `d -halo 0.5`.
    pub(super) fn number(&self) -> Option<f64> {
        let mut words = words::words(&self.rest);
        numbers::number(words.find(|&word| word != b"-halo")?)
    }
}

/// A material.
#[derive(Default)]
pub(super) struct Material {
    pub(super) name: Vec<u8>,
    pub(super) line: usize,
    pub(super) kd: Option<Statement>,
    pub(super) ka: Option<Statement>,
    pub(super) d: Option<Statement>,
    pub(super) tr: Option<Statement>,
    /// A colour texture.
    pub(super) map_kd: Option<Statement>,
    /// An opacity map.
    pub(super) map_d: Option<Statement>,
    /// Any other texture.
    pub(super) map: Option<Statement>,
}

/// A material file.
#[derive(Default)]
pub(super) struct Library {
    /// The materials that are used.
    pub(super) materials: Vec<Material>,
    /// The comments before the first material, in lower case.
    pub(super) head: Vec<u8>,
    /// The evidence of all materials about the meaning of `Tr`.
    pub(super) evidence: Evidence,
    /// The number of statements that belong to no material, and the line of the first.
    pub(super) homeless: (usize, usize),
}

impl Library {
    /// Reads a material file.
    pub(super) fn read(bytes: &[u8], is_used: impl Fn(&[u8]) -> bool) -> Self {
        let mut library = Self::default();
        let mut current: Option<Material> = None;
        for (line, text) in words::lines(bytes) {
            let (keyword, rest) = words::split(&text);
            if keyword.first().is_none_or(|&first| first == b'#') {
                if current.is_none() {
                    words::keep_head(&text, &mut library.head);
                }
            } else if keyword.eq_ignore_ascii_case(b"newmtl") {
                let name = rest.to_owned();
                let next = Material {
                    name,
                    line,
                    ..Material::default()
                };
                library.keep(current.replace(next), &is_used);
            } else if let Some(material) = &mut current {
                material.statement(keyword, line, rest);
            } else {
                let (count, first) = library.homeless;
                library.homeless = (count + 1, if count == 0 { line } else { first });
            }
        }
        library.keep(current, &is_used);
        library
    }

    fn keep(&mut self, material: Option<Material>, is_used: impl Fn(&[u8]) -> bool) {
        let Some(material) = material else { return };
        let number = |statement: &Option<Statement>| statement.as_ref()?.number();
        self.evidence.add(number(&material.d), number(&material.tr));
        if is_used(&material.name) {
            self.materials.push(material);
        }
    }
}

impl Material {
    fn statement(&mut self, keyword: &[u8], line: usize, rest: &[u8]) {
        let slot = match &keyword.to_ascii_lowercase()[..] {
            b"kd" => &mut self.kd,
            b"ka" => &mut self.ka,
            b"d" => &mut self.d,
            b"tr" => &mut self.tr,
            b"map_kd" => &mut self.map_kd,
            b"map_d" | b"map_tr" | b"map_opacity" => &mut self.map_d,
            other if other.starts_with(b"map_") => &mut self.map,
            _ => return,
        };
        let rest = rest.to_owned();
        *slot = Some(Statement { line, rest });
    }
}
