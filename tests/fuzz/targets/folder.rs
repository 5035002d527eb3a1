//! A folder in memory whose files the readers are given: they read files, not bytes, as they do for everybody.

use std::path::{Path, PathBuf};

use onionskin::{LoadOptions, MemoryLimit, Scene};

/// A folder of this process, which stays until the machine is restarted or it is removed.
pub struct Folder(PathBuf);

/// What a reader may take: less than what the fuzzer gives the process.
pub fn memory() -> MemoryLimit {
    MemoryLimit::of(400 << 20)
}

/// Loads a scene or a model within that.
#[allow(dead_code)]
pub fn load(path: impl AsRef<Path>) {
    let options = LoadOptions {
        memory: memory(),
        ..LoadOptions::default()
    };
    let _ = Scene::load_with(path, &options);
}

impl Folder {
    /// With one file that does not change.
    pub fn with(name: &str, content: &str) -> Self {
        let memory = Path::new("/dev/shm");
        let parent = if memory.is_dir() {
            memory.to_owned()
        } else {
            std::env::temp_dir()
        };
        let folder = parent.join(format!("onionskin-fuzz-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("the folder can be made");
        std::fs::write(folder.join(name), content).expect("the folder can be written to");
        Self(folder)
    }

    /// With a scene file of one volume.
    pub fn of_volume(name: &str) -> Self {
        Self::with(
            "scene.toml",
            &format!(
                "[[volume]]\nfile = \"{name}\"\ntransfer = [{{ value = 0, color = [1, 1, 1], density = 1 }}]\n"
            ),
        )
    }

    /// Writes a file and gives its path.
    pub fn write(&self, name: &str, bytes: &[u8]) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, bytes).expect("the folder can be written to");
        path
    }

    /// The path of a file there.
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}
