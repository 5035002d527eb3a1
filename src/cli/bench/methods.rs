//! Which methods are measured.

use onionskin::{Method, Result, Scene, registry};

/// What is measured if no method is named, in this order. Methods that draw the scene again for each of its layers take
/// seconds where these take milliseconds, so they are measured when they are asked for.
const USUAL: [&str; 10] = [
    "blend",
    "painter",
    "auto",
    "verified-painter",
    "dfb",
    "dfb+ppdp",
    "dfb+ppao+ppdp",
    "ppll+ppao+ppdp",
    "coherent-layer-peeling-a",
    "dual-depth-peeling",
];

/// For scenes with geometry that a sort orders exactly, whose peels are few.
const OF_SORTED: &str = "hybrid-layer-peeling";

/// What every ratio is relative to.
pub(super) const BASE: Method = Method::Blend;

/// Which methods the command line asks for.
#[derive(Clone, Debug)]
pub(super) enum Asked {
    Usual,
    All,
    Named(Vec<Method>),
}

impl Asked {
    /// # Errors
    /// If there is no method of one of the names.
    pub(super) fn of(names: &[String]) -> Result<Self> {
        if names.is_empty() {
            return Ok(Self::Usual);
        }
        let words = || {
            names
                .iter()
                .flat_map(|names| names.split(','))
                .map(str::trim)
        };
        if words().any(|word| word == "all") {
            return Ok(Self::All);
        }
        Ok(Self::Named(words().map(str::parse).collect::<Result<_>>()?))
    }

    /// Plain blending first, and no method twice.
    pub(super) fn methods(&self, scene: &Scene) -> Vec<Method> {
        let named = |name: &str| registry().iter().find(|row| row.name == name);
        let has_sorted = !scene.volumes.is_empty()
            || scene.meshes.iter().any(|mesh| mesh.sorted && !mesh.opaque);
        let wanted: Vec<Method> = match self {
            Self::Usual => {
                let names = USUAL.into_iter().chain(has_sorted.then_some(OF_SORTED));
                names.filter_map(named).map(|row| row.method).collect()
            }
            Self::All => drawn().collect(),
            Self::Named(methods) => methods.clone(),
        };
        let mut methods = vec![BASE];
        for method in wanted {
            if !methods.contains(&method) {
                methods.push(method);
            }
        }
        methods
    }
}

/// All methods but the oracle, whose images are not made by drawing.
fn drawn() -> impl Iterator<Item = Method> {
    let methods = registry().iter().map(|row| row.method);
    methods.filter(|method| *method != Method::Exact)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_usual_method_is_in_the_registry() {
        let scene = Scene::of("nothing", Vec::new());
        let methods = Asked::Usual.methods(&scene);
        let names: Vec<_> = methods.iter().map(Method::name).collect();
        assert_eq!(names, USUAL);
        OF_SORTED.parse::<Method>().unwrap();
    }

    #[test]
    fn plain_blending_comes_first_and_no_method_twice() {
        let scene = Scene::of("nothing", Vec::new());
        let asked = Asked::of(&["dfb, painter".into(), "dfb,blend".into()]).unwrap();
        let methods = asked.methods(&scene);
        let names: Vec<_> = methods.iter().map(Method::name).collect();
        assert_eq!(names, ["blend", "dfb", "painter"]);
        let all = Asked::of(&["dfb".into(), "all".into()]).unwrap();
        assert_eq!(all.methods(&scene).len(), registry().len() - 1);
        assert!(Asked::of(&["dbf".into()]).is_err());
    }
}
