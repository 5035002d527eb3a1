//! Picture files of other people: what is read, what is refused by its header alone, and that no bytes do any harm.

use std::io::Write;
use std::path::{Path, PathBuf};

use exr::prelude::*;
use flate2::{Compression, Crc, write::ZlibEncoder};
use onionskin::{Image, MemoryLimit, Rgba};
use proptest::prelude::*;
use tempfile::TempDir;

struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn with(&self, name: &str, bytes: &[u8]) -> PathBuf {
        std::fs::write(self.path(name), bytes).unwrap();
        self.path(name)
    }
}

/// What is said about a file that is not read.
#[track_caller]
fn refused(path: impl AsRef<Path>) -> String {
    match Image::load(path) {
        Ok(image) => panic!("{} x {} pixels were read", image.width, image.height),
        Err(error) => error.to_string(),
    }
}

fn chunk(kind: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let mut crc = Crc::new();
    crc.update(kind);
    crc.update(data);
    let length = (data.len() as u32).to_be_bytes();
    [&length[..], kind, data, &crc.sum().to_be_bytes()].concat()
}

/// A PNG of 8-bit grey that says to have this size and holds so many bytes of zeros, unpacked.
fn png(width: u32, height: u32, zeros: usize) -> Vec<u8> {
    let mut packer = ZlibEncoder::new(Vec::new(), Compression::best());
    packer.write_all(&vec![0; zeros]).unwrap();
    let head = [
        &width.to_be_bytes()[..],
        &height.to_be_bytes(),
        &[8, 0, 0, 0, 0],
    ]
    .concat();
    [
        b"\x89PNG\r\n\x1a\n".to_vec(),
        chunk(b"IHDR", &head),
        chunk(b"IDAT", &packer.finish().unwrap()),
        chunk(b"IEND", &[]),
    ]
    .concat()
}

/// A picture whose pixels all differ.
fn ramp(width: u32, height: u32) -> Image {
    let pixels = (0..width * height).map(|i| {
        let v = i as f32 / (width * height) as f32;
        Rgba::new(v, 1.0 - v, v * v, 0.5 + v / 2.0)
    });
    Image {
        width,
        height,
        pixels: pixels.collect(),
    }
}

#[test]
fn a_header_that_promises_gigabytes_is_read_and_nothing_is_decoded() {
    let folder = Folder::new();
    // A megabyte that unpacks to another gigabyte, of a picture of 3.6 gigapixels.
    let path = folder.with("a.png", &png(60_000, 60_000, 1 << 28));
    assert_eq!(Image::size_of_file(&path).unwrap(), [60_000, 60_000]);
    let error = Image::load_within(&path, &MemoryLimit::of(1 << 30))
        .unwrap_err()
        .to_string();
    assert!(error.contains("60000 x 60000 pixels take"), "{error}");
    assert!(error.contains("1.0 GiB may be taken"), "{error}");
}

#[test]
fn sizes_at_the_ends_of_their_range() {
    let folder = Folder::new();
    for (width, height) in [
        (0, 5),
        (5, 0),
        (u32::MAX, u32::MAX),
        (1 << 31, 1),
        (i32::MAX as u32, i32::MAX as u32),
    ] {
        let path = folder.with("a.png", &png(width, height, 100));
        let error = refused(&path);
        assert!(error.contains("a.png: "), "{error}");
    }
    // What the header says is there is not.
    let error = refused(folder.with("a.png", &png(100, 100, 100)));
    assert!(error.contains("cannot decode it"), "{error}");
}

#[test]
fn a_picture_comes_back_as_it_was_saved() {
    let folder = Folder::new();
    let image = ramp(13, 7);
    image.save(folder.path("a.exr")).unwrap();
    assert_eq!(Image::load(folder.path("a.exr")).unwrap(), image);
    assert_eq!(Image::size_of_file(folder.path("a.exr")).unwrap(), [13, 7]);
    image.save(folder.path("a.png")).unwrap();
    let loaded = Image::load(folder.path("a.png")).unwrap();
    for (a, b) in loaded.pixels.iter().zip(&image.pixels) {
        for (a, b) in [(a.r, b.r), (a.g, b.g), (a.b, b.b), (a.a, b.a)] {
            // Half a step of 8 bits, and what f32 makes of the division.
            assert!((a - b).abs() <= 0.5 / 255.0 + 1e-6, "{a} {b}");
        }
    }
}

#[test]
fn every_truncation_is_refused() {
    let folder = Folder::new();
    for name in ["a.png", "a.exr"] {
        let path = folder.path(name);
        ramp(9, 5).save(&path).unwrap();
        let whole = std::fs::read(&path).unwrap();
        // A PNG's last chunk says only that it ends.
        let needed = whole.len() - if name == "a.png" { 12 } else { 0 };
        for length in 0..needed {
            let error = refused(folder.with(name, &whole[..length]));
            assert!(error.contains("cannot decode it"), "{length}: {error}");
        }
    }
}

/// A channel of 4 x 3 values.
fn channel(name: &str, samples: FlatSamples) -> AnyChannel<FlatSamples> {
    AnyChannel::new(name, samples)
}

fn floats(first: f32) -> FlatSamples {
    FlatSamples::F32((0..12).map(|i| first + i as f32 / 12.0).collect())
}

fn layer(name: &str, channels: Vec<AnyChannel<FlatSamples>>) -> Layer<AnyChannels<FlatSamples>> {
    Layer::new(
        (4, 3),
        LayerAttributes::named(name),
        Encoding::FAST_LOSSLESS,
        AnyChannels::sort(channels.into()),
    )
}

fn rgb() -> Vec<AnyChannel<FlatSamples>> {
    ["R", "G", "B"]
        .map(|name| channel(name, floats(0.25)))
        .into()
}

#[test]
fn exr_files_with_other_channels_too_are_read() {
    let folder = Folder::new();
    let path = folder.path("a.exr");
    let depth = || channel("Z", floats(1000.0));
    let halves = || {
        let values = (0..12).map(|i| f16::from_f32(0.25 + i as f32 / 16.0));
        FlatSamples::F16(values.collect())
    };
    let id = || channel("id", FlatSamples::U32((0..12).collect()));
    for (what, channels, alpha) in [
        ("RGB", rgb(), 1.0),
        ("RGB and others", [rgb(), vec![depth(), id()]].concat(), 1.0),
        (
            "RGBA",
            [rgb(), vec![channel("A", floats(0.0))]].concat(),
            0.0,
        ),
        (
            "halves",
            ["R", "G", "B"].map(|name| channel(name, halves())).into(),
            1.0,
        ),
    ] {
        exr::image::Image::from_layer(layer("", channels))
            .write()
            .to_file(&path)
            .unwrap();
        let image = Image::load(&path).unwrap_or_else(|error| panic!("{what}: {error}"));
        assert_eq!([image.width, image.height], [4, 3], "{what}");
        let first = image.pixel(0, 0);
        assert_eq!(
            [first.r, first.g, first.b, first.a],
            [0.25, 0.25, 0.25, alpha],
            "{what}"
        );
    }
}

#[test]
fn exr_files_without_colours_are_refused_with_what_they_should_have() {
    let folder = Folder::new();
    let path = folder.path("a.exr");
    for channels in [
        vec![channel("Y", floats(0.0))],
        vec![channel("R", floats(0.0)), channel("G", floats(0.0))],
        vec![
            channel("left.R", floats(0.0)),
            channel("left.G", floats(0.0)),
            channel("left.B", floats(0.0)),
        ],
    ] {
        exr::image::Image::from_layer(layer("", channels))
            .write()
            .to_file(&path)
            .unwrap();
        let error = refused(&path);
        assert!(error.contains("a.exr: cannot decode it"), "{error}");
        assert!(error.contains("channels R, G, B"), "{error}");
    }
}

#[test]
fn exr_files_of_tiles_and_of_several_parts_are_read() {
    let folder = Folder::new();
    let path = folder.path("a.exr");
    let mut tiled = layer("", rgb());
    tiled.encoding.blocks = Blocks::Tiles(Vec2(2, 2));
    exr::image::Image::from_layer(tiled)
        .write()
        .to_file(&path)
        .unwrap();
    assert_eq!(
        Image::load(&path).unwrap().pixel(3, 2).r,
        0.25 + 11.0 / 12.0
    );
    // The first part that has colours is the picture.
    let parts = [
        layer("depth", vec![channel("Z", floats(0.0))]),
        layer("beauty", rgb()),
    ];
    let attributes = ImageAttributes::new(IntegerBounds::from_dimensions((4, 3)));
    exr::image::Image::from_layers(attributes, parts.to_vec())
        .write()
        .to_file(&path)
        .unwrap();
    assert_eq!(Image::load(&path).unwrap().pixel(1, 0).g, 0.25 + 1.0 / 12.0);
}

/// A file to be damaged, and its ending.
fn whole(kind: usize) -> (&'static str, Vec<u8>) {
    let folder = Folder::new();
    match kind {
        0 => {
            ramp(9, 5).save(folder.path("a.png")).unwrap();
            ("a.png", std::fs::read(folder.path("a.png")).unwrap())
        }
        1 => ("a.png", png(30, 40, 31 * 40)),
        2 => {
            ramp(9, 5).save(folder.path("a.exr")).unwrap();
            ("a.exr", std::fs::read(folder.path("a.exr")).unwrap())
        }
        _ => {
            let mut tiled = layer("", rgb());
            tiled.encoding.blocks = Blocks::Tiles(Vec2(2, 2));
            let compressions = [Compression_::ZIP16, Compression_::PIZ, Compression_::RLE];
            tiled.encoding.compression = compressions[kind % 3];
            let path = folder.path("a.exr");
            exr::image::Image::from_layer(tiled)
                .write()
                .to_file(&path)
                .unwrap();
            ("a.exr", std::fs::read(path).unwrap())
        }
    }
}

use exr::compression::Compression as Compression_;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    /// Whatever becomes of a file's bytes, it is read or refused, within 256 MiB.
    #[test]
    fn damaged_files_are_read_or_refused(
        kind in 0_usize..6,
        damage in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        cut in proptest::option::of(any::<prop::sample::Index>()),
    ) {
        let (name, mut bytes) = whole(kind);
        for (place, value) in damage {
            let place = place.index(bytes.len());
            bytes[place] = value;
        }
        if let Some(cut) = cut {
            bytes.truncate(cut.index(bytes.len()));
        }
        let folder = Folder::new();
        let path = folder.with(name, &bytes);
        match Image::load_within(&path, &MemoryLimit::of(256 << 20)) {
            Ok(image) => prop_assert_eq!(image.pixels.len() as u64, u64::from(image.width) * u64::from(image.height)),
            Err(error) => prop_assert!(error.to_string().contains(name), "{}", error),
        }
    }

    /// Any bytes behind the magic number.
    #[test]
    fn any_bytes_are_refused(is_png: bool, bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        let (name, magic) = if is_png {
            ("a.png", &b"\x89PNG\r\n\x1a\n"[..])
        } else {
            ("a.exr", &b"\x76\x2f\x31\x01\x02\0\0\0"[..])
        };
        let folder = Folder::new();
        let error = refused(folder.with(name, &[magic, &bytes].concat()));
        prop_assert!(error.contains("cannot decode it"), "{}", error);
    }
}

#[test]
fn a_data_window_far_larger_than_the_picture_is_refused_by_the_header() {
    // 558 bytes that fuzzing found: a picture of 4 x 3 pixels whose data window is 67108868 x 3.
    let wide = include_bytes!("../fuzz_findings/exr/wide");
    let folder = Folder::new();
    let words = refused(folder.with("wide.exr", wide));
    assert!(
        words.contains("its data window has 201326604 pixels"),
        "{words}"
    );
    assert!(words.contains("4 x 3"), "{words}");
}

#[test]
fn what_the_system_said_is_the_source_of_the_error() {
    let folder = tempfile::tempdir().unwrap();
    let error = Image::load(folder.path().join("none.png")).unwrap_err();
    let source = std::error::Error::source(&error);
    let source = source.and_then(|source| source.downcast_ref::<std::io::Error>());
    let kind = source.map(std::io::Error::kind);
    assert_eq!(kind, Some(std::io::ErrorKind::NotFound));
    let error = onionskin::Error::input(
        onionskin::low_level::error::Place::file("a"),
        "it is empty",
        "fill it",
    );
    assert!(std::error::Error::source(&error).is_none());
}
