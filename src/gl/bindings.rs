//! Where shaders find what is bound, and the numbers that they share with Rust. The shaders' texts say the same, which the
//! tests below hold.

use bytemuck::{Pod, Zeroable};

/// The texture unit of an A-buffer's records.
pub const RECORDS: u32 = 3;
/// The texture unit of a linked list's links.
pub const LINKS: u32 = 4;
/// The texture unit of the numbers of marked pixels.
pub(super) const NUMBERS: u32 = 2;
/// The texture unit of the bounds of triangles' pieces.
pub const PIECES: u32 = 1;
/// The texture unit of the transfer functions.
pub(super) const TRANSFER: u32 = 6;
/// The texture unit of the first volume. The units before it are the fragment lists', the opaque depth's and the transfer
/// functions'.
pub(super) const FIRST_VOLUME: u32 = 7;
/// The texture unit of the counts that a prefix scan begins with.
pub(super) const SCANNED_COUNTS: u32 = 1;
/// The texture units of the classic texture units' first: one kind of lookup each.
pub(super) const PLAIN_2D: u32 = 16;
pub(super) const SHADOW_2D: u32 = 20;
pub(super) const PLAIN_RECTANGLE: u32 = 24;
pub(super) const SHADOW_RECTANGLE: u32 = 28;

/// The uniform block of a band.
pub(super) const BAND_BLOCK: u32 = 0;
/// The uniform block of the volumes' places.
pub(super) const PLACES_BLOCK: u32 = 1;

/// The storage block of a counter of fragments or invocations.
pub(super) const COUNTER: u32 = 0;
/// The storage block of the list of captured fragments.
pub(super) const CAPTURED: u32 = 1;
/// The storage blocks of a prefix scan: a level, and the one above it.
pub(super) const LOWER_LEVEL: u32 = 0;
pub(super) const UPPER_LEVEL: u32 = 1;

/// The attributes of a vertex.
pub(super) const POSITION: u32 = 0;
pub(super) const NORMAL: u32 = 1;
pub(super) const COLOR: u32 = 2;
/// How the vertex's mesh is shaded, where meshes differ in that.
pub(super) const INSIDE: u32 = 3;

/// In the place of an empty sample: less than every value that a sample may have. Shaders need not know what NaN is.
pub(super) const EMPTY: f32 = -3e38;

/// The uniform block that tells shaders which band of the image is rendered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct BandParameters {
    /// The band's first row, from the bottom.
    pub first_row: u32,
    /// Its number of rows.
    pub rows: u32,
    /// The image's width.
    pub width: u32,
    /// How many records each pixel of fixed buffers has room for.
    pub layers: u32,
    /// How many records there is room for in all.
    pub capacity: u32,
    /// How many fragments the image has before the band.
    pub before: u32,
}

#[cfg(test)]
mod tests {
    use super::super::glsl::shader_file;
    use super::*;

    /// The number that the declaration of `name` has after `key`.
    fn declared(file: &str, key: &str, name: &str) -> u32 {
        let text = shader_file(file).unwrap_or_else(|| panic!("there is no glsl/{file}"));
        let words = |line: &str| {
            let words = line.split(|c: char| !c.is_alphanumeric() && c != '_');
            words.map(str::to_owned).collect::<Vec<_>>()
        };
        let declares =
            |line: &&str| line.starts_with("layout(") && words(line).contains(&name.to_owned());
        let line = text.lines().find(declares);
        let line = line.unwrap_or_else(|| panic!("glsl/{file} declares no {name}"));
        let (_, after) = line.split_once(&format!("{key} = ")).expect("it has one");
        let end = after
            .find(|c: char| !c.is_ascii_digit())
            .expect("a bracket follows");
        after[..end].parse().expect("these are digits")
    }

    #[test]
    fn the_shaders_say_the_same_bindings() {
        for (file, name, binding) in [
            ("a_buffer/list.glsl", "records", RECORDS),
            ("a_buffer/list.glsl", "next", LINKS),
            ("verified/pieces.glsl", "pieces", PIECES),
            ("verified/number.glsl", "numbers", NUMBERS),
            ("common/volume.glsl", "transfer", TRANSFER),
            ("common/volume.glsl", "samples", FIRST_VOLUME),
            ("common/volume.glsl", "Volumes", PLACES_BLOCK),
            ("a_buffer/band.glsl", "Band", BAND_BLOCK),
            ("a_buffer/scan_gather.comp", "complexity", SCANNED_COUNTS),
            ("a_buffer/scan_gather.comp", "Counts", LOWER_LEVEL),
            ("a_buffer/scan_reduce.comp", "Lower", LOWER_LEVEL),
            ("a_buffer/scan_reduce.comp", "Upper", UPPER_LEVEL),
            ("a_buffer/scan_spread.comp", "Lower", LOWER_LEVEL),
            ("a_buffer/scan_spread.comp", "Upper", UPPER_LEVEL),
            ("capture.frag", "Count", COUNTER),
            ("capture.frag", "List", CAPTURED),
            ("trap.frag", "Count", COUNTER),
            ("classic/textures.glsl", "texture_2d", PLAIN_2D),
            ("classic/textures.glsl", "shadow_2d", SHADOW_2D),
            ("classic/textures.glsl", "rectangle", PLAIN_RECTANGLE),
            (
                "classic/textures.glsl",
                "shadow_rectangle",
                SHADOW_RECTANGLE,
            ),
        ] {
            assert_eq!(declared(file, "binding", name), binding, "{file}: {name}");
        }
    }

    #[test]
    fn the_vertex_shaders_say_the_same_attributes() {
        for file in [
            "geometry.vert",
            "classic/vertex.vert",
            "invariance/vertex.vert",
        ] {
            for (name, location) in [("position", POSITION), ("normal", NORMAL), ("color", COLOR)] {
                assert_eq!(declared(file, "location", name), location, "{file}: {name}");
            }
        }
    }

    #[test]
    fn the_block_of_a_band_has_the_same_members() {
        let text = shader_file("a_buffer/band.glsl").unwrap();
        let members = text
            .lines()
            .filter_map(|line| line.trim().strip_prefix("uint "));
        let members: Vec<_> = members.filter_map(|line| line.split(';').next()).collect();
        assert_eq!(
            members,
            ["first_row", "rows", "width", "layers", "capacity", "before"]
        );
        let parameters = BandParameters {
            first_row: 0,
            rows: 1,
            width: 2,
            layers: 3,
            capacity: 4,
            before: 5,
        };
        assert_eq!(
            bytemuck::cast::<_, [u32; 6]>(parameters),
            [0, 1, 2, 3, 4, 5]
        );
    }

    #[test]
    fn an_empty_sample_is_the_same_number() {
        let text = shader_file("common/volume.glsl").unwrap();
        assert!(
            text.contains(&format!("#define EMPTY {EMPTY:e}\n")),
            "{EMPTY:e}"
        );
    }

    #[test]
    #[should_panic(expected = "declares no record")]
    fn a_declaration_that_is_missing_is_noticed() {
        declared("a_buffer/list.glsl", "binding", "record");
    }
}
