//! A header that promises gigabytes costs no memory, and packed samples cost no more than the samples. One test alone in its process, whose memory is looked at.

mod scene_kit;
mod volume_kit;

use volume_kit::*;

/// The most memory that the process has ever asked for, in KiB, touched or not; nothing where there is no /proc.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmPeak:"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

#[test]
fn headers_that_promise_gigabytes_cost_nothing() {
    let Some(before) = peak() else {
        eprintln!("skipped: there is no /proc/self/status here");
        return;
    };
    let nrrd = |encoding: &str, sizes: &str| {
        let head = nrrd_head("short", encoding, "little", "").replace("2 3 4", sizes);
        [head.as_bytes(), b"\n", &gzip(&[0; 4096])].concat()
    };
    // 20 GB, which are never read, and 1 GB, which would be.
    for sizes in ["2000 2000 2500", "800 800 800"] {
        bad("v.nrrd", &nrrd("raw", sizes));
        bad("v.nrrd", &nrrd("gzip", sizes));
    }
    for length in [2000, 800] {
        let header = Nifti {
            dim: [3, length, length, length, 1, 1, 1, 1],
            ..Nifti::default()
        };
        bad("v.nii", &header.bytes());
        bad("v.nii.gz", &gzip(&header.bytes()));
    }
    for image in [
        r#"WholeExtent="0 1999 0 1999 0 2499""#,
        r#"WholeExtent="0 799 0 799 0 799""#,
    ] {
        for packed in [false, true] {
            let vti = Vti {
                image,
                packed,
                ..Vti::default()
            };
            bad("v.vti", &vti.appended("raw", &[0xff; 4096]));
            bad("v.vti", &vti.inline("binary", &base64(&[0xff; 4096])));
            bad("v.vti", &vti.inline("ascii", "1 2 3"));
        }
    }
    let grown = peak().expect("it was there before") - before;
    assert!(grown < 64 << 10, "{grown} KiB");
    // What is unpacked is not kept beside the samples: 16 Mi of them take 64 MiB, and their bytes would take 16 more, or 32
    // while they grow.
    let cube = Nifti {
        dim: [3, 256, 256, 256, 1, 1, 1, 1],
        ..Nifti::default()
    };
    let packed = gzip_with_zeros(&cube.bytes(), 1 << 24);
    let before = peak().expect("it was there before");
    let volume = read("v.nii.gz", &packed);
    let grown = peak().expect("it was there before") - before;
    assert!(grown < 72 << 10, "{grown} KiB");
    assert_eq!(volume.samples().len(), 1 << 24);
    drop(volume);
    // That the peak would show it.
    let before = peak().expect("it was there before");
    let wanted = vec![0_u8; 512 << 20];
    assert!(std::hint::black_box(&wanted)[1 << 20] == 0);
    assert!(peak().expect("it was there before") - before > 400 << 10);
}
