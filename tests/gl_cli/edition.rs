//! `onionskin edition`: the site that it writes, and the folders that it takes.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::LazyLock;
use std::time::Duration;

use onionskin::{papers, registry};

use crate::kit::cli::Desk;

/// A chapter with its pictures.
const MOST_BYTES: usize = 3 << 20;
/// All scripts together.
const MOST_OF_SCRIPTS: usize = 60 << 10;

/// The quick site, which is written once for all tests.
static DESK: LazyLock<Desk> = LazyLock::new(|| {
    let desk = Desk::new();
    desk.result(&["edition", "-o", "site", "--quick"]);
    desk
});

/// Every file of a folder with its content, by its path from there.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(inside) = folders.pop() {
        for entry in fs::read_dir(inside).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let name = path.strip_prefix(folder).unwrap();
            found.insert(name.to_str().unwrap().to_owned(), fs::read(&path).unwrap());
        }
    }
    found
}

/// The values of an attribute, in the page's order.
fn attributes<'p>(page: &'p str, name: &str) -> Vec<&'p str> {
    let begins = format!(" {name}=\"");
    let after = page.split(begins.as_str()).skip(1);
    after.map(|rest| rest.split('"').next().unwrap()).collect()
}

/// The pages, by their names.
fn pages(site: &BTreeMap<String, Vec<u8>>) -> BTreeMap<&str, &str> {
    let pages = site.iter().filter(|(name, _)| name.ends_with(".html"));
    pages
        .map(|(name, bytes)| (name.as_str(), std::str::from_utf8(bytes).unwrap()))
        .collect()
}

/// Links and images that lead nowhere, or out of the site.
fn broken(site: &BTreeMap<String, Vec<u8>>) -> Vec<String> {
    let pages = pages(site);
    let ids: BTreeMap<_, BTreeSet<_>> = pages
        .iter()
        .map(|(&name, page)| (name, attributes(page, "id").into_iter().collect()))
        .collect();
    let mut broken = Vec::new();
    for (&name, page) in &pages {
        let all = ["href", "src"]
            .map(|attribute| attributes(page, attribute))
            .concat();
        for link in all.into_iter().filter(|it| !it.starts_with("data:")) {
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            let file = if file.is_empty() { name } else { file };
            let leads = site.contains_key(file)
                && (anchor.is_empty() || ids.get(file).is_some_and(|ids| ids.contains(anchor)));
            if !leads {
                broken.push(format!("{name}: {link}"));
            }
        }
    }
    broken
}

#[test]
fn every_link_anchor_and_image_is_there() {
    let mut site = files(&DESK.path("site"));
    assert_eq!(broken(&site), Vec::<String>::new());
    // What is not there is noticed: a page, an anchor, another machine's page.
    for link in [
        "nowhere.html",
        "everitt.html#nowhere",
        "https://example.org/",
    ] {
        let page = format!("<a href=\"{link}\">");
        site.insert("bad.html".into(), page.into_bytes());
        assert_eq!(broken(&site), [format!("bad.html: {link}")]);
    }
}

#[test]
fn no_anchor_is_twice_on_a_page_and_headings_are_in_order() {
    let site = files(&DESK.path("site"));
    for (name, page) in pages(&site) {
        let ids = attributes(page, "id");
        let different: BTreeSet<_> = ids.iter().collect();
        assert_eq!(ids.len(), different.len(), "{name}: {ids:?}");
        let mut level = 0;
        for rest in page.split("<h").skip(1) {
            let next: Option<u32> = rest.chars().next().and_then(|it| it.to_digit(10));
            let Some(next) = next else { continue };
            assert!(next <= level + 1, "{name}: h{next} after h{level}");
            level = next;
        }
        assert_eq!(page.matches("<h1").count(), 1, "{name}");
        for image in page.split("<img ").skip(1) {
            let tag = image.split('>').next().unwrap();
            assert!(
                attributes(&format!(" {tag}"), "alt")[0].len() > 10,
                "{name}: {tag}"
            );
        }
    }
}

#[test]
fn chapters_and_scripts_are_small() {
    let site = files(&DESK.path("site"));
    let scripts = site.iter().filter(|(name, _)| name.ends_with(".js"));
    let bytes: usize = scripts.map(|(_, bytes)| bytes.len()).sum();
    assert!((1..=MOST_OF_SCRIPTS).contains(&bytes), "scripts: {bytes}");
    for (name, page) in pages(&site) {
        let images: BTreeSet<_> = attributes(page, "src").into_iter().collect();
        let bytes = page.len() + images.iter().map(|&it| site[it].len()).sum::<usize>();
        assert!(bytes <= MOST_BYTES, "{name}: {bytes} bytes");
    }
}

#[test]
fn every_method_has_a_page_and_every_chapter_its_claims_and_errata_once() {
    let site = files(&DESK.path("site"));
    let pages = pages(&site);
    for row in registry() {
        let page = pages[format!("method-{}.html", row.name.replace('+', "-")).as_str()];
        assert!(page.contains(&row.ties.to_string()), "{}", row.name);
    }
    for paper in papers() {
        let Some(page) = pages.get(format!("{}.html", paper.key).as_str()) else {
            continue;
        };
        let ids = attributes(page, "id");
        let claims = paper.claims.iter().map(|it| it.key);
        for key in claims.chain(paper.errata.iter().map(|it| it.key)) {
            assert_eq!(ids.iter().filter(|id| **id == key).count(), 1, "{key}");
        }
    }
}

/// Clicks from a place of the front page to a method's page: on links of its text, up to the next place.
fn clicks_to_a_method(page: &str, from: &str) -> Option<usize> {
    let places: BTreeMap<&str, Vec<&str>> = page
        .split(" id=\"")
        .skip(1)
        .map(|rest| {
            let id = rest.split('"').next().unwrap();
            (id, attributes(rest, "href"))
        })
        .collect();
    let mut at: BTreeSet<&str> = [from].into();
    for clicks in 1..=5 {
        let links: Vec<&str> = at
            .iter()
            .filter_map(|id| places.get(id))
            .flatten()
            .copied()
            .collect();
        if links.iter().any(|link| link.starts_with("method-")) {
            return Some(clicks);
        }
        at = links
            .iter()
            .filter_map(|link| link.strip_prefix('#'))
            .collect();
    }
    None
}

#[test]
fn from_what_looks_wrong_it_is_five_clicks_at_most_to_a_method() {
    let site = files(&DESK.path("site"));
    let page = pages(&site)["index.html"];
    let list = page.split("class=\"questions\"").nth(1).unwrap();
    let list = list.split("</nav>").next().unwrap();
    let symptoms: Vec<_> = attributes(list, "href");
    assert!(symptoms.len() >= 8, "{symptoms:?}");
    for symptom in symptoms {
        let clicks = clicks_to_a_method(page, &symptom[1..]);
        // One more for the symptom itself.
        assert!(
            clicks.is_some_and(|clicks| clicks < 5),
            "{symptom}: {clicks:?}"
        );
    }
    assert_eq!(clicks_to_a_method(page, "nowhere"), None);
}

/// The rows of a figure's first table, without their heads.
fn cells(site: &BTreeMap<String, Vec<u8>>, figure: &str) -> Vec<Vec<String>> {
    let record = &site[format!("figures/{figure}.json").as_str()];
    let record: serde_json::Value = serde_json::from_slice(record).unwrap();
    let rows = record["tables"][0]["rows"].as_array().unwrap();
    let text = |cell: &serde_json::Value| cell.as_str().unwrap().to_owned();
    let cells = |row: &serde_json::Value| row.as_array().unwrap()[1..].iter().map(text).collect();
    rows.iter().map(cells).collect()
}

/// The claims' figures, which the tests of the claims find anew.
#[test]
fn the_counts_of_figures_are_those_of_the_claims() {
    let site = files(&DESK.path("site"));
    let here = |key: &str, number: usize| {
        let claims = papers().iter().flat_map(|paper| paper.claims);
        let claim = claims.into_iter().find(|claim| claim.key == key).unwrap();
        claim.figures[number].here.split(", ").collect::<Vec<_>>()
    };
    let samples = cells(&site, "everitt-3").concat();
    assert_eq!(samples, here("E10", 0));
    let errors = cells(&site, "everitt-6");
    assert_eq!(errors[0], here("E13", 0));
    assert_eq!(errors[2], here("E13", 1));
    assert_ne!(errors[1], here("E13", 0));
}

#[test]
fn killed_and_repeated_it_ends_with_the_bytes_of_an_undisturbed_run() {
    let desk = Desk::new();
    let mut child = Command::new(env!("CARGO_BIN_EXE_onionskin"))
        .current_dir(desk.path("."))
        .args(["edition", "-o", "site", "--quick"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    while !desk.path("site/figures/everitt-1.json").exists() {
        assert!(
            child.try_wait().unwrap().is_none(),
            "it ended without a figure"
        );
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    // What a kill leaves in the middle of a figure, and in the middle of a file.
    let figure = desk.path("site/figures");
    let last = "everitt-1.json";
    let record: serde_json::Value =
        serde_json::from_slice(&fs::read(figure.join(last)).unwrap()).unwrap();
    let picture = record["pictures"][0]["file"].as_str().unwrap();
    fs::remove_file(desk.path("site").join(picture)).unwrap();
    fs::write(figure.join(".onionskin-a1B2c3"), "half a picture").unwrap();
    desk.result(&["edition", "-o", "site", "--quick"]);
    fs::remove_file(figure.join(".onionskin-a1B2c3")).unwrap_or_default();
    let (resumed, undisturbed) = (files(&desk.path("site")), files(&DESK.path("site")));
    let names = |files: &BTreeMap<String, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&resumed), names(&undisturbed));
    for (name, bytes) in &resumed {
        assert!(*bytes == undisturbed[name], "{name}");
    }
    let again = desk.result(&["edition", "-o", "site", "--quick", "--json"]);
    assert!(again.contains("\"figures_made\":0"), "{again}");
}

#[test]
fn a_folder_with_something_else_is_refused_and_stays_as_it_is() {
    let desk = Desk::new().with("file", "");
    let refused = |desk: &Desk, folder: &str| desk.refused(&["edition", "-o", folder, "--quick"]);
    let inside = |name: &str| {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, "mine").unwrap();
        let answer = refused(&desk, folder.path().to_str().unwrap());
        assert_eq!(files(folder.path()).len(), 1, "{answer}");
        answer
    };
    inside("notes.txt").says(&["not the edition's, such as notes.txt", "empty this one"]);
    inside("figures/my-holiday.png").says(&["such as figures/my-holiday.png"]);
    inside("index.html").says(&["no edition.txt"]);
    inside("edition.txt").says(&["another edition (mine)"]);
    refused(&desk, "file").says(&["file", "Name a folder"]);
    refused(&desk, "nowhere/site").says(&["nowhere/site", "Name a folder"]);
}

#[cfg(unix)]
#[test]
fn a_folder_that_cannot_be_written_is_refused() {
    use std::os::unix::fs::PermissionsExt;
    let desk = Desk::new();
    let folder = desk.path("site");
    fs::create_dir(&folder).unwrap();
    fs::set_permissions(&folder, fs::Permissions::from_mode(0o555)).unwrap();
    if fs::write(folder.join("probe"), "").is_ok() {
        println!("skipped: this user may write everywhere");
        fs::remove_file(folder.join("probe")).unwrap();
        // What nobody can write to.
        desk.refused(&["edition", "-o", "/proc/site", "--quick"])
            .says(&["/proc/site"]);
        return;
    }
    desk.refused(&["edition", "-o", "site", "--quick"])
        .says(&["site", "Name a folder"]);
    assert!(files(&folder).is_empty());
}
