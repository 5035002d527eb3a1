//! The house has floors, and a room imports only from floors below it. Rust compiles module cycles in silence; this
//! does not.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::sources::{files, root};
use crate::surface::names;

/// Every room with its floor, as the README's plan has them: a floor's number stands before its first room.
fn floors() -> Vec<(String, u32)> {
    let readme = include_str!("../../README.md");
    let (_, house) = readme.split_once("## The house").unwrap();
    let plan = house
        .split("```")
        .nth(1)
        .unwrap()
        .trim_start_matches("text");
    let mut floor = 0;
    let rooms = plan.lines().filter(|line| !line.is_empty()).map(|line| {
        let (number, room) = line.split_at(3);
        floor = number.trim().parse().unwrap_or(floor);
        let name = room.split_whitespace().next().unwrap();
        (name.trim_end_matches('/').to_owned(), floor)
    });
    rooms.collect()
}

#[test]
fn every_room_imports_only_from_floors_below() {
    let floors = floors();
    let floor = |room: &str| {
        let found = floors.iter().find(|(name, _)| name == room);
        found.map(|(_, floor)| *floor)
    };
    let mut rooms = BTreeSet::new();
    let mut wrong = Vec::new();
    for file in sources() {
        let room = room_of(&file);
        let its_floor = floor(&room).unwrap_or_else(|| panic!("{room} has no floor"));
        for imported in imports(&fs::read_to_string(&file).unwrap()) {
            if imported != room && floor(&imported).is_some_and(|other| other >= its_floor) {
                wrong.push(format!(
                    "{}: {room} (floor {its_floor}) imports {imported}",
                    file.display()
                ));
            }
        }
        rooms.insert(room);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let known: BTreeSet<_> = floors.iter().map(|(room, _)| room.clone()).collect();
    assert_eq!(
        rooms, known,
        "every room has a floor and every floor its rooms"
    );
}

#[test]
fn an_import_from_above_would_be_found() {
    let found = imports(
        "use crate::gl::Context;\nlet x = crate::methods::registry();\nuse onionskin::scene::Scene;",
    );
    assert_eq!(found, ["gl", "methods", "scene"].map(str::to_owned).into());
    let nested = imports(
        "use crate::{error::Result, papers::vtk};\nuse super::*;\nuse onionskin::{Context, Scene};
         use onionskin::low_level::steps::Call;",
    );
    assert_eq!(
        nested,
        ["error", "papers", "gl", "scene", "steps"]
            .map(str::to_owned)
            .into()
    );
}

#[test]
fn unsafe_code_stands_in_gl_only() {
    for file in sources() {
        let text = fs::read_to_string(&file).unwrap();
        let allowed = file.strip_prefix(root()).unwrap().starts_with("gl");
        let code = text
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"));
        let found = code
            .filter(|line| line.contains("unsafe {") || line.contains("unsafe_code)"))
            .count();
        assert!(allowed || found == 0, "{}", file.display());
    }
}

/// Every file but the crate's root, which has no room.
fn sources() -> impl Iterator<Item = PathBuf> {
    let files = files(&root()).into_iter();
    files.filter(|file| *file != root().join("lib.rs"))
}

fn room_of(file: &Path) -> String {
    let inside = file.strip_prefix(root()).unwrap();
    let room = inside.components().next().unwrap();
    Path::new(room.as_os_str())
        .file_stem()
        .unwrap()
        .to_str()
        .unwrap()
        .to_owned()
}

/// The rooms that a source names after `crate::` or `onionskin::`. The crate's root re-exports some types; they count
/// as their rooms.
fn imports(text: &str) -> BTreeSet<String> {
    let code: String = text
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"))
        .map(|l| l.to_owned() + "\n")
        .collect();
    let mut found = BTreeSet::new();
    for (at, path) in code
        .match_indices("crate::")
        .chain(code.match_indices("onionskin::"))
    {
        // `$crate::` stands in macros, which are expanded elsewhere.
        if code[..at].ends_with('$') {
            continue;
        }
        let rest = &code[at + path.len()..];
        match rest.strip_prefix('{') {
            Some(group) => {
                let mut depth = 0;
                let end = group.find(|c| {
                    depth += match c {
                        '{' => 1,
                        '}' => -1,
                        _ => 0,
                    };
                    depth < 0
                });
                let group = &group[..end.unwrap_or(group.len())];
                found.extend(group.split(',').map(|item| room(item.trim())));
            }
            None => {
                found.insert(room(rest));
            }
        }
    }
    found
}

fn room(path: &str) -> String {
    let path = path.strip_prefix("low_level::").unwrap_or(path);
    let name: String = path
        .chars()
        .take_while(|c| c.is_alphanumeric() || *c == '_')
        .collect();
    let offered = names().into_iter().find(|(_, offered)| *offered == name);
    offered.map_or(name, |(path, _)| {
        let room = path.trim_start_matches("low_level::").split("::").next();
        room.unwrap().to_owned()
    })
}
