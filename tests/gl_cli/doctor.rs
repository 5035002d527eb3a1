//! `onionskin doctor`: what it says of the driver.

use crate::kit::sheets::desk;
use onionskin::Context;

#[test]
fn the_doctor_reports_the_driver_that_renders() {
    let answer = desk().run(&["doctor"]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{answer}");
    let context = Context::headless().unwrap();
    let driver = context.driver();
    for part in [&driver.renderer, &driver.version_text] {
        assert!(answer.out.contains(part), "{answer}");
    }
    for (name, value) in &driver.limits {
        let line = answer.out.lines().find(|line| line.contains(name)).unwrap();
        assert!(line.ends_with(&format!(" {value}")), "{line}");
    }
}

#[test]
fn the_doctor_as_json_prints_one_object_for_each_backend() {
    let answer = desk().run(&["doctor", "--json"]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{answer}");
    let objects = answer.objects();
    let names: Vec<_> = objects.iter().map(|object| &object["backend"]).collect();
    assert_eq!(names, ["egl", "osmesa"]);
    let context = Context::headless().unwrap();
    let backend = context.backend().unwrap().to_string();
    let used = objects.iter().find(|object| object["backend"] == *backend);
    let (used, driver) = (used.unwrap(), context.driver());
    assert_eq!(used["works"], true);
    assert_eq!(used["version"], driver.version_text);
    assert_eq!(
        used["limits"]["GL_MAX_TEXTURE_SIZE"],
        driver.largest_image()
    );
    assert_eq!(
        used["extensions"]["GL_KHR_debug"],
        driver.has("GL_KHR_debug")
    );
}

#[test]
fn the_backend_of_the_argument_comes_before_that_of_the_environment() {
    let context = Context::headless().unwrap();
    let backend = context.backend().unwrap().to_string();
    // A backend that is not there would end the program before it could look at the argument.
    let desk = desk().with_variable("ONIONSKIN_BACKEND", "none");
    let render = ["render", "sheets.toml", "-o", "s.png"];
    desk.refused(&render);
    desk.result(&[&render[..], &["--backend", &backend]].concat());
}
