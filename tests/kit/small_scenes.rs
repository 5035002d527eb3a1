//! Small scenes for what is tested state by state or allocation by allocation: 16 x 16 pixels.

use onionskin::Scene;
use onionskin::generate::{Soup, soup};

/// So many random triangles.
pub fn surfaces(count: u32) -> Scene {
    let parameters = Soup {
        count,
        ..Soup::default()
    };
    let mut scene = Scene::of("soup", vec![soup(&parameters).unwrap()]);
    scene.size = [16, 16];
    scene
}

/// A ball of fog and 20 random triangles.
pub fn fog() -> Scene {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("fog.toml");
    let text = "
        size = [16, 16]
        [[volume]]
        generate = \"ball\"
        transfer = [{ value = 0.0, color = [1, 1, 1], density = 0.0 }, { value = 1.0, color = [0.1, 0.4, 0.9], density = 3.0 }]
        [[mesh]]
        generate = \"soup\"
        count = 20
    ";
    std::fs::write(&path, text).unwrap();
    Scene::load(&path).unwrap()
}
