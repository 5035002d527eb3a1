//! What is wrong with a file of VTK's ImageData is said with the file and the field, and never costs more memory than the file.

use crate::kit::scene::Refused;
use crate::kit::volume::*;

#[track_caller]
fn bad_vti(vti: Vti) -> Refused {
    bad("v.vti", &vti.appended("raw", &vti.counted(&[0; 24])))
}

#[test]
fn vti_with_bad_attributes() {
    let field = |vti: Vti, field: &str| {
        let error = bad_vti(vti);
        assert_eq!(error.token.as_deref(), Some(field), "{error:?}");
        error
    };
    let image = |image| Vti {
        image,
        ..Vti::default()
    };
    field(image(""), "WholeExtent").says("missing");
    field(image(r#"WholeExtent="0 1 0 2""#), "WholeExtent");
    field(image(r#"WholeExtent="0 1 0 2 0 x""#), "WholeExtent");
    field(image(r#"WholeExtent="0 0 0 2 0 3""#), "WholeExtent").says("1 samples");
    field(image(r#"WholeExtent="5 1 0 2 0 3""#), "WholeExtent").says("0 samples");
    field(
        image(r#"WholeExtent="-2147483648 2147483647 0 2147483647 0 2147483647""#),
        "WholeExtent",
    )
    .says("more than");
    field(
        image(r#"WholeExtent="0 1999 0 1999 0 4999""#),
        "WholeExtent",
    )
    .says("more than");
    field(image(r#"WholeExtent="0 511 0 511 0 511""#), "DataArray").says("there are 24");
    for spacing in ["0 1 1", "nan 1 1", "1 1", "1 1 inf"] {
        let text: &'static str = format!(r#"WholeExtent="0 1 0 2 0 3" Spacing="{spacing}""#).leak();
        field(image(text), "Spacing");
    }
    field(
        image(r#"WholeExtent="0 1 0 2 0 3" Origin="0 0 nan""#),
        "Spacing",
    )
    .says("first sample");
    field(
        image(r#"WholeExtent="0 1 0 2 0 3" Direction="1 0 0 0 1 1 0 1 1""#),
        "Spacing",
    )
    .says("plane");
    field(
        Vti {
            name: "Bit",
            ..Vti::default()
        },
        "DataArray type",
    );
    field(
        Vti {
            order: "MiddleEndian",
            ..Vti::default()
        },
        "byte_order",
    );
    field(
        Vti {
            width: 1,
            ..Vti::default()
        },
        "header_type",
    );
    field(
        Vti {
            array: r#"offset="99999""#,
            ..Vti::default()
        },
        "DataArray offset",
    );
    field(
        Vti {
            array: r#"offset="-1""#,
            ..Vti::default()
        },
        "DataArray offset",
    );
}

#[test]
fn vti_that_is_none() {
    bad("v.vti", b"").says("XML");
    bad("v.vti", b"<a>").says("XML");
    bad("v.vti", b"<a/>").says("<a");
    bad("v.vti", b"<VTKFile type=\"PolyData\"/>").says("PolyData");
    bad("v.vti", b"<VTKFile type=\"ImageData\"/>").says("VTKFile");
    bad("v.vti", &[0xff; 100]).says("UTF-8");
    bad("v.vti", "<a>".repeat(100_000).as_bytes()).says("XML");
}

#[test]
fn vti_with_bad_data() {
    let vti = Vti::default();
    bad("v.vti", &vti.inline("ascii", "1 2 3")).says("3 numbers");
    bad("v.vti", &vti.inline("ascii", "1 2 three")).says("not a number");
    for text in ["!!!!", "=", "=AAA", "====", "A===", " =\n", "GAAAAA==="] {
        bad("v.vti", &vti.inline("binary", text)).says("base64");
        bad("v.vti", &vti.appended("base64", text.as_bytes())).says("base64");
    }
    bad("v.vti", &vti.inline("binary", "")).says("0 bytes");
    bad("v.vti", &vti.inline("hex", "00")).says("hex");
    bad("v.vti", &vti.appended("hex", &vti.counted(&[0; 24]))).says("hex");
    let mut other = String::from_utf8(vti.inline("binary", "")).unwrap();
    other = other.replace(
        "header_type",
        "compressor=\"vtkLZ4DataCompressor\" header_type",
    );
    other = other.replace(
        "</DataArray></PointData>",
        &format!("{}</DataArray></PointData>", base64(&[0; 28])),
    );
    bad("v.vti", other.as_bytes())
        .says("vtkLZ4DataCompressor")
        .says("version 1.0")
        .says("LZ4");
    // Numbers in ASCII are not packed, whatever else would be.
    let words: Vec<String> = (0..24).map(|i| i.to_string()).collect();
    let ascii = String::from_utf8(vti.inline("ascii", &words.join(" "))).unwrap();
    let ascii = ascii.replace(
        "header_type",
        "compressor=\"vtkLZ4DataCompressor\" header_type",
    );
    assert_eq!(read("v.vti", ascii.as_bytes()).samples()[23], 23.0);
    let packed = Vti {
        packed: true,
        ..Vti::default()
    };
    let good = packed.packed(&[0; 24], 10);
    for length in 0..good.len() {
        bad("v.vti", &packed.inline("binary", &base64(&good[..length])));
    }
    // A head that promises 2^32 blocks.
    bad("v.vti", &packed.appended("raw", &[0xff; 40])).says("ends after");
    let wide = Vti { width: 8, ..packed };
    bad("v.vti", &wide.appended("raw", &[0xff; 40])).says("ends after");
}
