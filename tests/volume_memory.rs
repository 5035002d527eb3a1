//! A header that promises gigabytes costs no memory, and packed samples cost no more than the samples. One test alone in its process, whose memory is looked at.

mod kit;

use kit::scene::{Folder, refused};
use kit::volume::*;

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
    small_files_are_refused_what_no_person_allowed(&cube);
    // That the peak would show it.
    let before = peak().expect("it was there before");
    let wanted = vec![0_u8; 512 << 20];
    assert!(std::hint::black_box(&wanted)[1 << 20] == 0);
    assert!(peak().expect("it was there before") - before > 400 << 10);
}

/// 144 Mi samples of a small file, packed as NIfTI and as NRRD, at once and in a list that names one file many times.
fn small_files_are_refused_what_no_person_allowed(cube: &Nifti) {
    let before = peak().expect("it was there before");
    let large = Nifti {
        dim: [3, 512, 512, 576, 1, 1, 1, 1],
        ..cube.clone()
    };
    let nifti = gzip_with_zeros(&large.bytes(), 144 << 20);
    let head = nrrd_head("uchar", "gzip", "little", "").replace("2 3 4", "512 512 576");
    let nrrd = [head.as_bytes(), b"\n", &gzip_with_zeros(b"", 144 << 20)].concat();
    // What follows the samples is never read, but makes the file one of 9 KB.
    let one = [gzip_with_zeros(b"", 1 << 20), vec![0; 8 << 10]].concat();
    let listed = format!("{head}data file: LIST\n{}", "z.gz\n".repeat(288));
    let listed = listed.replace("512 512 576", "1024 1024 288");
    // The same file by many names is still one.
    let renamed = (0..288).fold(listed.clone(), |text, n| {
        text.replacen("\nz.gz", &format!("\n{}z.gz", "./".repeat(n + 1)), 1)
    });
    for files in [
        vec![("v.nii.gz", &nifti[..])],
        vec![("v.nrrd", &nrrd)],
        vec![("v.nhdr", listed.as_bytes()), ("z.gz", &one)],
        vec![("v.nhdr", renamed.as_bytes()), ("z.gz", &one)],
    ] {
        assert!(files.iter().all(|(_, bytes)| bytes.len() < 1 << 20));
        refused(load(&files)).says("no more than 176.0 MiB");
    }
    // Each of three volumes would fit alone.
    let third = Nifti {
        dim: [3, 512, 512, 100, 1, 1, 1, 1],
        ..cube.clone()
    };
    let packed = gzip_with_zeros(&third.bytes(), 100 << 18);
    let volume = "[[volume]]\nfile = \"v.nii.gz\"\ntransfer = [{ value = 0, color = [1, 1, 1], density = 1 }]\n";
    let folder = Folder::new()
        .with("s.toml", volume.repeat(3))
        .with("v.nii.gz", packed);
    refused(folder.load("s.toml")).says("no more than 76.0 MiB");
    // One of them is read before the second is refused.
    let grown = peak().expect("it was there before") - before;
    assert!(grown < (100 + 64) << 10, "{grown} KiB");
}
